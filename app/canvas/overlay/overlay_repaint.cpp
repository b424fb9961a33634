#include "app/canvas/overlay/overlay_repaint.h"

#include "app/canvas/canvas_view.h"
#include "app/canvas/overlay/shown_selection.h"
#include "app/canvas/presenters/presenter.h"
#include "app/session/editor.h"
#include "model/shaping/transform.h"

#include <algorithm>
#include <tuple>

namespace suffuse {

namespace {

constexpr int frameMs = 16;
constexpr int manyRects = 200; ///< A frame that has changed in more rectangles than these is painted as a whole.
/// Up to so many strokes that a drag alters are painted without the rest of the selection.
constexpr std::size_t fewStrokes = 32;

/// The region of all tiles; neighbouring tiles are joined first.
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

OverlayRepaint::OverlayRepaint(QWidget &canvas, Editor &editor, const CanvasView &view, const ShownSelection &selection,
                               std::function<std::optional<double>()> margin)
    : m_canvas(canvas), m_editor(editor), m_view(view), m_selection(selection), m_margin(std::move(margin))
{
    m_waits.setSingleShot(true);
    m_waits.setInterval(frameMs);
    connect(&m_waits, &QTimer::timeout, this, &OverlayRepaint::flush);
}

bool OverlayRepaint::isMoving() const
{
    return m_editor.isDragging() || m_editor.isStepping();
}

void OverlayRepaint::all()
{
    m_all = true;
    m_presenter->updateArea(m_presenter->widget()->rect());
}

void OverlayRepaint::part(const QRectF &area)
{
    const double dpr = m_canvas.devicePixelRatioF();
    const QRectF logical(area.topLeft() / dpr, area.size() / dpr);
    m_presenter->updateArea(logical.toAlignedRect().adjusted(-1, -1, 1, 1) & m_presenter->widget()->rect());
}

void OverlayRepaint::part(const QRegion &area)
{
    const double dpr = m_canvas.devicePixelRatioF();
    if (dpr == 1) {
        m_presenter->updateArea(area);
        return;
    }
    QRegion logical;
    for (const QRect &r : area)
        logical += QRectF(QPointF(r.topLeft()) / dpr, QSizeF(r.size()) / dpr).toAlignedRect().adjusted(-1, -1, 1, 1);
    m_presenter->updateArea(logical & m_presenter->widget()->rect());
}

void OverlayRepaint::tiles(const std::vector<PixelRect> &dirty)
{
    const QRegion changed = regionOf(dirty);
    if (changed.rectCount() < manyRects)
        part(changed);
    else
        all();
}

/// Where the selection is painted now. No value means that it may be painted anywhere.
std::optional<QRegion> OverlayRepaint::areaNow() const
{
    const std::optional<double> margin = m_margin();
    return margin ? std::optional(m_selection.area(m_view.view(), *margin, m_canvas.devicePixelRatioF()))
                  : std::nullopt;
}

/// Notes what a drag alters. Returns true if only that needs painting, since the rest of the selection stays as it is.
bool OverlayRepaint::altersFew(const Change &change)
{
    const std::optional<double> margin = m_margin();
    const bool mayBe =
        margin && isMoving() && !change.selection && !change.order && change.strokes.size() <= fewStrokes;
    if (!mayBe) {
        m_altered = {};
        return false;
    }
    const double dpr = m_canvas.devicePixelRatioF();
    bool known = m_altered.margin == *margin && m_area && !m_selectionChanged && m_area == areaNow();
    m_altered.margin = *margin;
    for (const StrokePtr &stroke : m_editor.unsettled().painting()->strokes) {
        if (!std::binary_search(change.strokes.begin(), change.strokes.end(), stroke->id))
            continue;
        const Rect now = controlBox(*stroke);
        const auto [it, isNew] = m_altered.boxes.try_emplace(stroke->id, now);
        known = known && !isNew;
        m_altered.area += markedArea(it->second, *margin, m_view.view(), dpr);
        m_altered.area += markedArea(now, *margin, m_view.view(), dpr);
        it->second = now;
    }
    return known;
}

void OverlayRepaint::follow(const Change &change)
{
    if (!m_all && altersFew(change))
        flushLater();
    else
        selection();
}

void OverlayRepaint::selection()
{
    if (m_all)
        return;
    const std::optional<QRegion> now = areaNow();
    if (now && m_area)
        m_area = m_area->united(*now);
    else
        m_area.reset();
    m_selectionChanged = true;
    flushLater();
}

void OverlayRepaint::flushLater()
{
    if (!isMoving())
        flush();
    else if (!m_waits.isActive())
        m_waits.start();
}

void OverlayRepaint::flushWaiting()
{
    if (m_waits.isActive())
        flush();
}

void OverlayRepaint::flush()
{
    m_waits.stop();
    const QRegion altered = std::exchange(m_altered.area, {});
    if (m_all)
        return;
    if (!std::exchange(m_selectionChanged, false)) {
        part(altered);
        return;
    }
    if (!m_area) {
        all();
        return;
    }
    part(*m_area); // The area is a region, so two strokes that lie far apart do not become one large box.
    m_area = areaNow();
}

void OverlayRepaint::endDrag()
{
    m_altered = {};
    selection(); // Lines are smooth again after a drag.
}

void OverlayRepaint::painted(bool anywhere)
{
    if (!std::exchange(m_all, false))
        return;
    m_area = anywhere ? std::nullopt : areaNow();
    m_selectionChanged = false;
    m_altered.area = {};
}

} // namespace suffuse
