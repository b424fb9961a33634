// What of the canvas is painted again, and when.
#include "app/canvas/canvas_widget.h"
#include "app/session/editor.h"
#include "model/shaping/transform.h"

#include <algorithm>
#include <tuple>

namespace suffuse {

namespace {

constexpr int manyRects = 200; ///< of a frame, to be painted together
/// So many strokes that a drag alters are painted without the others that are selected.
constexpr std::size_t fewChangedStrokes = 32;

/// Tiles together, neighbours as one.
QRegion regionOf(std::vector<PixelRect> tiles)
{
    std::sort(tiles.begin(), tiles.end(),
              [](const PixelRect &a, const PixelRect &b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); });
    QRegion region;
    QRect run;
    for (const PixelRect &tile : tiles) {
        const QRect next(tile.x, tile.y, tile.width, tile.height);
        if (next.y() == run.y() && next.height() == run.height() && next.x() <= run.x() + run.width()) {
            run |= next;
            continue;
        }
        region += run;
        run = next;
    }
    return region + run;
}

} // namespace

void CanvasWidget::updateOverlay()
{
    m_allRepaints = true;
    m_presenter->updateArea(m_presenter->widget()->rect());
}

void CanvasWidget::updateOverlay(const QRectF &pixels)
{
    const double dpr = devicePixelRatioF();
    const QRectF logical(pixels.topLeft() / dpr, pixels.size() / dpr);
    m_presenter->updateArea(logical.toAlignedRect().adjusted(-1, -1, 1, 1) & m_presenter->widget()->rect());
}

void CanvasWidget::updateOverlay(const QRegion &pixels)
{
    const double dpr = devicePixelRatioF();
    if (dpr == 1) {
        m_presenter->updateArea(pixels);
        return;
    }
    QRegion logical;
    for (const QRect &r : pixels)
        logical += QRectF(QPointF(r.topLeft()) / dpr, QSizeF(r.size()) / dpr).toAlignedRect().adjusted(-1, -1, 1, 1);
    m_presenter->updateArea(logical & m_presenter->widget()->rect());
}

/// Where something stands that is marked with so many pixels around it.
QRect CanvasWidget::markedArea(const Rect &units, double margin) const
{
    constexpr double lines = 12; // logical pixels: of the outline
    if (units.isEmpty())
        return {};
    Rect box;
    for (const Point corner : {Point{units.left, units.top}, Point{units.right, units.top},
                               Point{units.right, units.bottom}, Point{units.left, units.bottom}})
        box.include(view().toPixels(corner));
    box = box.grown(std::max(margin, lines * devicePixelRatioF()));
    const QRectF pixels(QPointF(box.left, box.top), QPointF(box.right, box.bottom));
    return (pixels & QRectF(0, 0, view().width, view().height)).toAlignedRect();
}

std::optional<double> CanvasWidget::selectionMargin() const
{
    return tool() ? tool()->paintMargin() : 0.0;
}

std::optional<QRegion> CanvasWidget::selectionArea() const
{
    const std::optional<double> margin = selectionMargin();
    if (!margin)
        return {};
    if (selection().isEmpty())
        return QRegion();
    return QRegion(markedArea(m_outline.boxOf(*m_editor.document().painting(), selection()), *margin));
}

const Selection &CanvasWidget::selection() const
{
    const Document &document = m_editor.document();
    return m_begun.at(m_editor.clock().time(), document.painting()->strokes, document.selection());
}

/// Where time goes on or back, selected strokes may begin, or not be begun any more.
void CanvasWidget::followMoment()
{
    if (m_editor.document().selection().isEmpty() || m_begun.holds(m_editor.clock().time()))
        return;
    const std::set<StrokeId> before = m_begun.leftOut();
    selection();
    if (m_begun.leftOut() == before)
        return;
    emit begunChanged();
    updateSelection();
}

Rect CanvasWidget::selectedCurves() const
{
    return m_outline.curveBoxOf(*m_editor.document().painting(), selection());
}

QRect CanvasWidget::selectionOnScreen() const
{
    const Rect curves = selectedCurves();
    if (curves.isEmpty())
        return {};
    Rect pixels;
    for (const Point &corner : {Point{curves.left, curves.top}, Point{curves.right, curves.top},
                                Point{curves.right, curves.bottom}, Point{curves.left, curves.bottom}})
        pixels.include(view().toPixels(corner));
    const double dpr = devicePixelRatioF();
    const QRectF logical(pixels.left / dpr, pixels.top / dpr, pixels.width() / dpr, pixels.height() / dpr);
    // Straight strokes have boxes without width or height.
    const QRect visible = (logical.adjusted(-1, -1, 1, 1) & QRectF(rect())).toAlignedRect();
    return visible.isEmpty() ? QRect() : visible.translated(mapToGlobal(QPoint()));
}

/// Notes what a drag alters. True where only that is to be painted: the rest of the selection stays as it is.
bool CanvasWidget::altersFew(const Change &change)
{
    const std::optional<double> margin = selectionMargin();
    const bool mayBe = margin && m_editor.isDragging() && !change.selection && !change.order &&
                       change.strokes.size() <= fewChangedStrokes;
    if (!mayBe) {
        m_altered = {};
        return false;
    }
    bool known =
        m_altered.margin == *margin && m_selectionArea && !m_selectionChanged && m_selectionArea == selectionArea();
    m_altered.margin = *margin;
    for (const StrokePtr &stroke : m_editor.document().painting()->strokes) {
        if (!std::binary_search(change.strokes.begin(), change.strokes.end(), stroke->id))
            continue;
        const Rect now = controlBox(*stroke);
        const auto [it, isNew] = m_altered.boxes.try_emplace(stroke->id, now);
        known = known && !isNew;
        m_altered.area += markedArea(it->second, *margin);
        m_altered.area += markedArea(now, *margin);
        it->second = now;
    }
    return known;
}

void CanvasWidget::followSelection(const Change &change)
{
    if (!m_allRepaints && altersFew(change))
        flushSelectionLater();
    else
        updateSelection();
}

void CanvasWidget::updateSelection()
{
    if (m_allRepaints)
        return;
    const std::optional<QRegion> now = selectionArea();
    if (now && m_selectionArea)
        m_selectionArea = m_selectionArea->united(*now);
    else
        m_selectionArea.reset();
    m_selectionChanged = true;
    flushSelectionLater();
}

void CanvasWidget::flushSelectionLater()
{
    if (!m_editor.isDragging())
        flushSelection();
    else if (!m_selectionWaits.isActive())
        m_selectionWaits.start();
}

void CanvasWidget::flushSelection()
{
    m_selectionWaits.stop();
    const QRegion altered = std::exchange(m_altered.area, {});
    if (m_allRepaints)
        return;
    if (!std::exchange(m_selectionChanged, false)) {
        updateOverlay(altered);
        return;
    }
    if (!m_selectionArea) {
        updateOverlay();
        return;
    }
    updateOverlay(*m_selectionArea); // two strokes that lie far apart are not one large box
    m_selectionArea = selectionArea();
}

void CanvasWidget::endDrag()
{
    m_altered = {};
    updateSelection(); // smooth lines again
    scheduleRender();
}

void CanvasWidget::frameReady(const FrameInfo &frame)
{
    if (frame.backendText != m_backendText || frame.notice != m_rendererNotice) {
        m_backendText = frame.backendText;
        m_rendererNotice = frame.notice;
        emit backendChanged();
    }
    if (frame.error.isEmpty()) {
        if (m_selectionWaits.isActive())
            flushSelection();
        if (frame.isExact() && m_floating && m_floating->settled)
            m_floating.reset();
        const QRegion changed = regionOf(frame.stats.dirty);
        if (frame.view == view() && changed.rectCount() < manyRects && !frame.floats)
            updateOverlay(changed);
        else
            updateOverlay();
    }
    emit framePresented(frame);
}

} // namespace suffuse
