#include "app/tools/select_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/editor.h"
#include "app/window/actions.h"
#include "undo/transform_edits.h"

#include <QKeyEvent>
#include <QLocale>

#include <numbers>

namespace suffuse {

namespace {

using Kind = TransformHandle::Kind;

/// Nodes that snap, those nearest to the pointer: of few strokes all.
constexpr std::size_t snappingNodes = 64;

bool takesAway(const PointerEvent &event)
{
    return event.modifiers & Qt::ShiftModifier && event.modifiers & Qt::ControlModifier;
}

std::vector<Point> nodesNear(const Painting &painting, const std::set<StrokeId> &moved, Point point)
{
    std::vector<Point> nodes;
    for (const StrokePtr &stroke : painting.strokes) {
        if (!moved.contains(stroke->id) || !painting.isVisible(*stroke) || painting.isLocked(*stroke))
            continue;
        for (const Segment &segment : stroke->segments)
            nodes.push_back(stroke->origin + segment.bezier[0]);
        nodes.push_back(stroke->origin + stroke->segments.back().bezier[3]);
    }
    const auto count = std::min(nodes.size(), snappingNodes);
    std::partial_sort(nodes.begin(), nodes.begin() + std::ptrdiff_t(count), nodes.end(),
                      [point](Point a, Point b) { return length(a - point) < length(b - point); });
    nodes.resize(count);
    return nodes;
}

} // namespace

SelectTool::SelectTool(CanvasWidget &canvas, Actions &actions, QObject *parent)
    : SelectionTool(canvas, parent), m_actions(actions), m_drag(canvas)
{
    connect(&m_editor.document(), &Document::changed, this, &SelectTool::followDocument);
    connect(&canvas, &CanvasWidget::begunChanged, this, [this] {
        m_stale = true;
        m_hovered.reset();
    });
}

void SelectTool::followDocument(const Change &change)
{
    m_stale = true;
    if (change.reset || selection().strokes != m_handled) {
        m_handled = selection().strokes;
        m_handles.setMode(TransformHandles::Mode::Scale);
        m_handles.resetCentre();
        m_hovered.reset();
    }
}

const TransformHandles &SelectTool::handles() const
{
    if (m_stale && !isBusy()) {
        m_handles.setBox(m_canvas.selectedCurves());
        m_stale = false;
    }
    return m_handles;
}

void SelectTool::pressed(const PointerEvent &event)
{
    m_touch.reset();
    m_handle = event.modifiers & Qt::AltModifier
                   ? std::nullopt
                   : handles().at(event.pixel, m_canvas.view(), m_canvas.devicePixelRatioF());
    m_hit = m_handle ? std::nullopt : pick(event);
    const bool plain = !(event.modifiers & (Qt::ShiftModifier | Qt::AltModifier));
    m_selectedByPress = m_hit && plain && !selection().strokes.contains(m_hit->stroke);
    if (m_selectedByPress) {
        const bool within = event.modifiers & Qt::ControlModifier; // a group
        select(Selection{within ? std::set<StrokeId>{m_hit->stroke}
                                : withGroup(*m_editor.document().painting(), m_hit->stroke),
                         {}});
    }
    if (isMoving(event) || (m_handle && m_handle->kind != Kind::Centre))
        m_drag.prepare(m_canvas.selection().strokes);
}

bool SelectTool::isMoving(const PointerEvent &event) const
{
    return m_hit && !(event.modifiers & (Qt::ShiftModifier | Qt::AltModifier)) &&
           selection().strokes.contains(m_hit->stroke);
}

void SelectTool::release(const PointerEvent &event)
{
    SelectionTool::release(event);
    m_drag.end();
}

void SelectTool::cancel()
{
    SelectionTool::cancel();
    m_drag.end();
}

void SelectTool::clicked(const PointerEvent &event)
{
    say({});
    const std::optional<TransformHandle> handle = std::exchange(m_handle, std::nullopt);
    const bool centre = handle && handle->kind == Kind::Centre;
    const bool resets = centre && event.modifiers & Qt::ShiftModifier;
    if (resets)
        m_handles.resetCentre();
    else if (centre)
        m_hit = pick(event); // it only lies over the paint
    if (resets || (handle && !centre)) {
        // A handle that is not dragged does nothing.
    } else if (event.modifiers & Qt::AltModifier) {
        clickedBelow(event);
    } else if (m_hit) {
        clickedStroke(event);
    } else if (!(event.modifiers & Qt::ShiftModifier)) {
        select({});
    }
}

void SelectTool::clickedStroke(const PointerEvent &event)
{
    const bool turned = std::exchange(m_turnedByClick, false);
    if (event.modifiers & Qt::ShiftModifier) {
        const std::set<StrokeId> meant = event.modifiers & Qt::ControlModifier
                                             ? std::set<StrokeId>{m_hit->stroke}
                                             : withGroup(*m_editor.document().painting(), m_hit->stroke);
        Selection chosen = selection();
        const bool add = !chosen.strokes.contains(m_hit->stroke);
        for (const StrokeId id : meant)
            if (add)
                chosen.strokes.insert(id);
            else
                chosen.strokes.erase(id);
        std::erase_if(chosen.segments, [&](const SegmentRef &s) { return meant.contains(s.stroke); });
        select(std::move(chosen));
    } else if (start().doubleClick) {
        if (turned)
            m_handles.setMode(TransformHandles::Mode::Scale);
        selectSegment(*m_hit);
    } else if (event.modifiers & Qt::ControlModifier) {
        select(Selection{{m_hit->stroke}, {}});
    } else if (!m_selectedByPress) {
        const bool scales = m_handles.mode() == TransformHandles::Mode::Scale;
        m_handles.setMode(scales ? TransformHandles::Mode::Turn : TransformHandles::Mode::Scale);
        m_turnedByClick = scales;
    }
}

void SelectTool::clickedBelow(const PointerEvent &event)
{
    const Painting &painting = *m_editor.document().painting();
    const std::vector<SegmentRef> hits = pickAll(painting, m_editor.clock().time(), event.point, tolerance());
    if (hits.empty())
        return;
    std::size_t next = 0; // below the lowest that is selected; from the lowest, the topmost
    for (std::size_t i = 0; i < hits.size(); ++i)
        if (selection().strokes.contains(hits[i].stroke))
            next = (i + 1) % hits.size();
    Selection chosen;
    if (event.modifiers & Qt::ShiftModifier)
        chosen = selection();
    if (event.modifiers & Qt::ControlModifier)
        chosen.strokes.insert(hits[next].stroke);
    else
        chosen.strokes.merge(withGroup(painting, hits[next].stroke));
    select(std::move(chosen));
    say(tr("Stroke %1 of %2 under the pointer, from the top. Alt+click again: the next below.")
            .arg(next + 1)
            .arg(hits.size()));
}

BandShape SelectTool::bandShape(const PointerEvent &event) const
{
    if (event.modifiers & Qt::AltModifier || m_actions[Command::TouchPath].isChecked())
        return BandShape::Touch;
    return m_actions[Command::Lasso].isChecked() ? BandShape::Lasso : BandShape::Rectangle;
}

void SelectTool::banded(const Rect &band, const PointerEvent &event)
{
    combine(strokesWithin(*m_editor.document().painting(), m_editor.clock().time(), m_canvas.view(), band), event);
}

void SelectTool::tracing(Point point, BandShape shape)
{
    if (shape != BandShape::Touch)
        return;
    if (m_touch)
        m_touch->goOn(point);
    else
        m_touch.emplace(m_editor.document().painting(), m_editor.clock().time(), tolerance(), point);
}

void SelectTool::traced(const std::vector<Point> &path, BandShape shape, const PointerEvent &event)
{
    const std::optional<PathTouch> touch = std::exchange(m_touch, std::nullopt);
    if (shape == BandShape::Touch && touch)
        combine(touch->touched(), event);
    else
        combine(strokesWithin(*m_editor.document().painting(), m_editor.clock().time(), path), event);
}

void SelectTool::combine(std::set<StrokeId> found, const PointerEvent &event)
{
    Selection chosen;
    if (takesAway(event) || takesAway(start())) {
        chosen = selection();
        for (const StrokeId id : found)
            chosen.strokes.erase(id);
        std::erase_if(chosen.segments, [&](const SegmentRef &s) { return found.contains(s.stroke); });
    } else {
        if ((event.modifiers | start().modifiers) & Qt::ShiftModifier)
            chosen = selection();
        chosen.strokes.merge(found);
    }
    select(std::move(chosen));
}

bool SelectTool::beginDrag(const PointerEvent &event)
{
    m_map = {};
    m_turnedByClick = false;
    const bool moves = isMoving(event);
    if (!m_handle && !moves)
        return false;
    const QString name = !m_handle                       ? tr("Move")
                         : m_handle->kind == Kind::Scale ? tr("Scale")
                         : m_handle->kind == Kind::Skew  ? tr("Skew")
                                                         : tr("Rotate");
    m_drag.begin(m_canvas.selection().strokes, name);
    beginSnapping(moves);
    return m_drag.isActive();
}

void SelectTool::beginSnapping(bool moving)
{
    const Painting &painting = *m_editor.document().painting();
    const std::set<StrokeId> &moved = m_canvas.selection().strokes;
    const bool centre = m_handle && m_handle->kind == Kind::Centre; // it may lie on a node of its own strokes
    m_snapping = Snapping(painting, m_canvas.aids(),
                          [&](const Stroke &stroke, int) { return !centre && moved.contains(stroke.id); });
    m_snap = {};
    m_snapPoints.clear();
    if (!moving)
        return;
    const Rect box = selectionBox(painting, m_canvas.selection());
    m_snapPoints = {
        {box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}, box.centre()};
    for (const Point &node : nodesNear(painting, moved, start().point))
        m_snapPoints.push_back(node);
}

void SelectTool::drag(const PointerEvent &event)
{
    if (m_handle)
        dragHandle(event);
    else
        dragSelection(event);
}

void SelectTool::dragSelection(const PointerEvent &event)
{
    const View &view = m_canvas.view();
    Point by = event.point - start().point;
    m_snap = {};
    if (event.modifiers & Qt::ControlModifier) { // along one axis of the screen, as in Inkscape
        const Point pixels = event.pixel - start().pixel;
        const Point kept = std::abs(pixels.x) > std::abs(pixels.y) ? Point{pixels.x, 0} : Point{0, pixels.y};
        by = view.toCanvas(start().pixel + kept) - start().point;
    } else if (!(event.modifiers & Qt::ShiftModifier)) { // Shift: freely
        Point at;
        const Snap snapped = m_snapping.snapMove(m_snapPoints, by, view, m_canvas.devicePixelRatioF(), &at);
        by = snapped.point;
        m_snap = {at, snapped.to};
    }
    show(Affine::translation(by));
    const QLocale locale;
    say(tr("Move by %1, %2").arg(locale.toString(by.x, 'f', 1), locale.toString(by.y, 'f', 1)));
}

void SelectTool::dragHandle(const PointerEvent &event)
{
    const View &view = m_canvas.view();
    Point to = event.point;
    const bool ctrl = event.modifiers & Qt::ControlModifier;
    const bool snaps = m_handle->kind == Kind::Centre || (m_handle->kind == Kind::Scale && !ctrl);
    m_snap = {};
    if (snaps) { // the corner of the box, not the handle beside it
        const Point beside = m_handle->kind == Kind::Centre ? Point{} : start().point - m_handles.anchor(*m_handle);
        m_snap = m_snapping.snap(to - beside, view, m_canvas.devicePixelRatioF());
        to = m_snap.point + beside;
    }
    if (m_handle->kind == Kind::Centre) {
        m_handles.setCentre(to);
        m_canvas.updateOverlay();
        return;
    }
    const Affine map = m_handles.map(*m_handle, start().point, to, event.modifiers);
    if (map.inverse())
        show(map);
    const QLocale locale;
    const auto percent = [&](double scale) { return locale.toString(100 * scale, 'f', 1); };
    if (m_handle->kind == Kind::Scale) // below 0: mirrored
        say(tr("Scale to %1 % × %2 %").arg(percent(m_map.a), percent(m_map.d)));
    else if (m_handle->kind == Kind::Rotate)
        turned(event);
    else
        say(tr("Skew by %1°").arg(locale.toString(std::atan(m_map.b + m_map.c) * 180 / std::numbers::pi, 'f', 1)));
}

void SelectTool::turned(const PointerEvent &event)
{
    const double angle = std::atan2(m_map.c, m_map.a);
    say(tr("Rotate by %1").arg(angleText(angle)));
    showTurn(angle, event.pixel);
}

void SelectTool::show(const Affine &map)
{
    m_map = map;
    const SpreadRule rule = m_actions[Command::ScaleSpread].isChecked() ? SpreadRule::Scales : SpreadRule::Stays;
    m_drag.show(map, rule);
}

void SelectTool::endDrag(bool cancelled)
{
    const bool centre = m_handle && m_handle->kind == Kind::Centre;
    const Point about = m_map(m_handles.centre());
    const bool ownCentre = length(m_handles.centre() - m_handles.box().centre()) > 1e-9 * m_handles.box().width();
    if (cancelled)
        m_drag.giveUp();
    else
        m_drag.end();
    m_stale = true;
    handles();
    if (!cancelled && !centre && ownCentre)
        m_handles.setCentre(about); // it stays where it was on the strokes
    m_handle.reset();
    m_snap = {};
    say({});
    showTurn({});
}

bool SelectTool::wantsKey(const QKeyEvent &event) const
{
    const bool isTab = event.key() == Qt::Key_Tab || event.key() == Qt::Key_Backtab;
    return isTab && !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
}

bool SelectTool::keyPress(QKeyEvent *event)
{
    if (!wantsKey(*event))
        return SelectionTool::keyPress(event);
    if (!isBusy())
        selectNext(event->key() == Qt::Key_Tab && !(event->modifiers() & Qt::ShiftModifier) ? 1 : -1);
    return true;
}

void SelectTool::selectNext(int step)
{
    const Painting &painting = *m_editor.document().painting();
    const std::set<StrokeId> selectable = selectableStrokes(painting, m_editor.clock().time());
    std::vector<StrokeId> order;
    for (const StrokePtr &stroke : painting.strokes)
        if (selectable.contains(stroke->id))
            order.push_back(stroke->id);
    if (order.empty())
        return;
    const auto isSelected = [&](StrokeId id) { return selection().strokes.contains(id); };
    const int count = int(order.size());
    int at = step > 0 ? -1 : count;
    for (int i = 0; i < count; ++i)
        if (isSelected(order[std::size_t(i)]) && (step > 0 || at == count))
            at = i;
    select(Selection{{order[std::size_t((at + step + count) % count)]}, {}});
}

} // namespace suffuse
