#include "app/tools/nodes/width_handle.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/editor.h"
#include "model/paint/half_width.h"
#include "undo/edits.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>

namespace suffuse {

namespace {

constexpr double handleGap = 9;      ///< logical pixels from the visible edge to the handle's middle
constexpr double widthHitRadius = 8; ///< logical pixels
constexpr double markRadius = 4.5;

/// Whether a segment has an edge that is seen: what takes paint away, or only bounds a fill, has none.
bool hasEdge(const Segment &segment)
{
    return !segment.takesPaint() && segment.density > 0;
}

/// The segment in the middle of what is selected of a stroke, of those that have an edge.
std::optional<int> middlePaint(const Stroke &stroke, const Selection &selection)
{
    const auto lays = [&](int k) {
        return k >= 0 && k < int(stroke.segments.size()) && hasEdge(stroke.segments[std::size_t(k)]);
    };
    std::vector<int> chosen;
    for (const SegmentRef &ref : selection.segments)
        if (lays(ref.segment))
            chosen.push_back(ref.segment);
    if (!selection.segments.empty())
        return chosen.empty() ? std::nullopt : std::optional(chosen[chosen.size() / 2]);
    const int middle = int(stroke.segments.size()) / 2;
    for (int way = 0; way <= middle; ++way)
        for (const int k : {middle - way, middle + way})
            if (lays(k))
                return k;
    return std::nullopt;
}

} // namespace

QString WidthHandle::hint()
{
    return QCoreApplication::translate("WidthHandle", "Drag to set the width by the density, Shift: by the diffusion.");
}

std::optional<WidthHandle::Target> WidthHandle::targetOf(const Stroke &stroke, const SegmentRef &ref) const
{
    if (!hasEdge(stroke.segments[std::size_t(ref.segment)]))
        return {};
    const auto seen = seenWidth(stroke, ref.segment, m_canvas.editor().clock().time());
    return seen ? std::optional<Target>({ref, stroke.segments[std::size_t(ref.segment)], *seen}) : std::nullopt;
}

std::optional<WidthHandle::Place> WidthHandle::place() const
{
    const Document &document = m_canvas.editor().document();
    const Selection &selection = document.selection();
    if (selection.strokes.size() != 1 || m_canvas.selection().isEmpty())
        return {};
    const StrokePtr stroke = document.painting()->find(*selection.strokes.begin());
    if (!stroke || !document.painting()->isVisible(*stroke) || document.painting()->isLocked(*stroke))
        return {};
    const std::optional<int> middle = middlePaint(*stroke, selection);
    const std::optional<Target> target = middle ? targetOf(*stroke, {stroke->id, *middle}) : std::nullopt;
    if (!target)
        return {};
    const Cubic cubic = stroke->cubicOf(stroke->segments[std::size_t(*middle)]);
    const Point tangent = tangentAt(cubic, 0.5);
    return Place{{stroke->id, *middle}, cubic.at(0.5), {-tangent.y, tangent.x}, target->seen.width};
}

Point WidthHandle::pixelOf(const Place &place, const View &view, double dpr) const
{
    // The handle keeps a least distance on the screen, so that the nodes of thin strokes stay free.
    const double distance = place.width + handleGap * dpr / view.scale;
    return view.toPixels(place.middle + distance * place.normal);
}

bool WidthHandle::isAt(Point pixel) const
{
    const std::optional<Place> at = place();
    const double dpr = m_canvas.devicePixelRatioF();
    return at && length(pixel - pixelOf(*at, m_canvas.view(), dpr)) <= widthHitRadius * dpr;
}

std::optional<SegmentRef> WidthHandle::segment() const
{
    const std::optional<Place> at = place();
    return at ? std::optional(at->ref) : std::nullopt;
}

bool WidthHandle::press(const PointerEvent &event)
{
    if (isBusy() || !isAt(event.pixel))
        return false;
    const Document &document = m_canvas.editor().document();
    m_start = *place();
    m_targets.clear();
    const StrokePtr stroke = document.painting()->find(m_start.ref.stroke);
    for (const SegmentRef &ref : targetSegments(document))
        if (const std::optional<Target> target = targetOf(*stroke, ref))
            m_targets.push_back(*target);
    m_grab = dot(event.point - m_start.middle, m_start.normal) - m_start.width;
    m_gesture = m_canvas.editor().begin(QCoreApplication::translate("WidthHandle", "Change width"));
    return true;
}

void WidthHandle::move(const PointerEvent &event)
{
    if (!isBusy())
        return;
    const double width = dot(event.point - m_start.middle, m_start.normal) - m_grab;
    setWidth(std::max(width, 0.0), event.modifiers & Qt::ShiftModifier);
}

void WidthHandle::setWidth(double width, bool diffusionAlone)
{
    // At the start of the drag every value is again what it was, to the last bit.
    const bool back = std::abs(width - m_start.width) * m_canvas.view().scale < 0.5;
    const double ratio = m_start.width > 0 ? width / m_start.width : 0;
    Editor &editor = m_canvas.editor();
    Edit edit = changeStrokes(editor.document(), {m_start.ref.stroke}, [&](Stroke &stroke) {
        for (const Target &target : m_targets) {
            if (std::size_t(target.ref.segment) >= stroke.segments.size())
                continue;
            Segment &segment = stroke.segments[std::size_t(target.ref.segment)];
            segment.diffusion = target.before.diffusion;
            segment.density = target.before.density;
            const bool faded = target.seen.width <= 0 && m_start.width > 0; // it stays so beside what is seen
            if (!back && !faded)
                setSeenWidth(segment, target.seen, m_start.width > 0 ? ratio * target.seen.width : width,
                             diffusionAlone);
        }
    });
    m_gesture.show(std::move(edit));
    m_canvas.updateOverlay();
}

void WidthHandle::release()
{
    m_gesture.commit();
    m_targets.clear();
    m_canvas.updateOverlay();
}

void WidthHandle::cancel()
{
    m_gesture.giveUp();
    release();
}

double WidthHandle::reach() const
{
    const std::optional<Place> at = place();
    const double dpr = m_canvas.devicePixelRatioF();
    return at ? at->width * m_canvas.view().scale + (handleGap + 2 * widthHitRadius) * dpr : 0;
}

void WidthHandle::paint(QPainter &painter, const View &view, double dpr) const
{
    const std::optional<Place> at = place();
    if (!at)
        return;
    const Point from = view.toPixels(at->middle), to = pixelOf(*at, view, dpr);
    const QColor accent = m_canvas.overlayColours().accent;
    const auto point = [](Point p) { return QPointF(p.x, p.y); };
    painter.setPen(QPen(QColor(255, 255, 255, 200), 3 * dpr));
    painter.drawLine(point(from), point(to));
    painter.setPen(QPen(accent, 1 * dpr));
    painter.drawLine(point(from), point(to));
    // The knob is round and shows two arrow heads, one inwards and one outwards.
    painter.setPen(QPen(Qt::white, 3 * dpr));
    painter.drawEllipse(point(to), markRadius * dpr, markRadius * dpr);
    painter.setPen(QPen(accent, 1.5 * dpr));
    painter.setBrush(isBusy() ? accent : QColor(Qt::white));
    painter.drawEllipse(point(to), markRadius * dpr, markRadius * dpr);
}

} // namespace suffuse
