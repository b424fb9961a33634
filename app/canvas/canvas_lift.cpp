#include "app/canvas/canvas_lift.h"

#include "app/session/editor.h"
#include "app/session/frames/floating_layers.h"
#include "app/session/frames/reach.h"
#include "model/painting/editable.h"
#include "render/composition/composition.h"

#include <QPainter>

namespace suffuse {

namespace {

/// With more segments than these an edit takes long during a drag, however little it draws.
constexpr std::size_t manySegments = 2000;

/// The view in which strokes look as they do in `view` after the map. It has no value where the map is no similarity.
std::optional<View> viewUnder(View view, const Affine &map)
{
    const std::optional<Affine> back = map.inverse();
    if (!back || !map.isSimilarity())
        return {};
    const Point centre = (*back)(view.centre);
    view.centre = {};
    const Point half{0.5 * view.width, 0.5 * view.height};
    const Point down = view.toPixels(map.turned({0, 1})) - half; // Mirroring leaves this direction unchanged.
    view.mirrored = view.mirrored != (map.determinant() < 0);
    view.scale = length(down);
    view.rotation = std::atan2(-down.x, down.y);
    view.centre = centre;
    return view;
}

/// The map as it acts on pixels of the view.
QTransform inPixels(const View &view, const Affine &map)
{
    const auto at = [&](double x, double y) { return view.toPixels(map(view.toCanvas({x, y}))); };
    const double w = view.width, h = view.height;
    const Point base = at(0, 0), right = (1 / w) * (at(w, 0) - base), down = (1 / h) * (at(0, h) - base);
    return QTransform(right.x, right.y, down.x, down.y, base.x, base.y);
}

} // namespace

CanvasLift::CanvasLift(Editor &editor, FrameThread &frames, const CanvasView &view, std::function<void()> schedule)
    : m_editor(editor), m_frames(frames), m_view(view), m_schedule(std::move(schedule))
{
    if (!m_editor.floatingView()) // A canvas that only looks on comes later.
        m_editor.setFloatingView(this);
}

CanvasLift::~CanvasLift()
{
    if (m_editor.floatingView() == this)
        m_editor.setFloatingView(nullptr);
}

void CanvasLift::lift(const std::set<StrokeId> &strokes)
{
    endLift();
    const PaintingPtr &painting = m_editor.unsettled().painting();
    if (strokes.size() < 2 || m_editor.clock().isRunning() || m_editor.unsettledShown() != painting ||
        !m_frames.canFloat())
        return;
    // Where a group is put on what lies below it as a whole, or is a wash, no picture of some strokes over one of the
    // others is like the picture of all.
    if (!mixesInOrder(*painting))
        return;
    Painting rest = *painting, lifted = *painting;
    rest.strokes.clear();
    lifted.strokes.clear();
    const Editable isEditable(painting->groups);
    for (const StrokePtr &stroke : painting->strokes) {
        const bool moves = strokes.contains(stroke->id) && isEditable(*stroke);
        (moves ? lifted : rest).strokes.push_back(stroke);
    }
    const Microseconds time = m_editor.clock().time();
    // An edit draws what the strokes reach before and after it, which is why twice the pixels count.
    if (lifted.segmentCount() < manySegments && !m_frames.isSlowFor(2 * reachedPixels(lifted, view(), time)))
        return;
    m_liftedFrom = painting;
    m_lift = std::make_shared<const Lift>(Lift{painting, std::make_shared<const Painting>(std::move(rest)),
                                               std::make_shared<const Painting>(std::move(lifted)), time, view()});
    m_frames.lift(m_lift);
}

void CanvasLift::endLift()
{
    if (!m_lift)
        return;
    m_lift.reset();
    m_frames.lift(nullptr);
    if (m_floating && m_floating->settled)
        return;
    m_floating.reset();
    m_schedule(); // The renderer has drawn the rest last, so the whole picture is asked for.
}

bool CanvasLift::holds(const Lift &lift) const
{
    return m_liftedFrom == m_editor.unsettledShown() && lift.view == view() && lift.time == m_editor.clock().time() &&
           m_frames.canFloat();
}

void CanvasLift::showFloating(const Affine &map)
{
    m_floating = {m_lift, map, false};
    m_schedule();
}

void CanvasLift::settleFloating()
{
    if (!m_floating)
        return;
    m_floating->settled = true;
    m_liftedFrom = m_editor.unsettled().painting();
    m_schedule();
}

bool CanvasLift::coversFloating(const Affine &map) const
{
    constexpr double beyond = FloatingLayers::margin;
    const std::optional<Affine> back = map.inverse();
    const double w = view().width, h = view().height;
    for (const Point corner : {Point{0, 0}, Point{w, 0}, Point{w, h}, Point{0, h}})
        if (!back || !Rect::of(0, 0, w, h).grown(beyond).contains(view().toPixels((*back)(view().toCanvas(corner)))))
            return false;
    return true;
}

const std::optional<Floating> &CanvasLift::forFrame()
{
    if (m_floating && !holds(*m_floating->lift))
        m_floating.reset();
    return m_floating;
}

void CanvasLift::exactShown()
{
    if (m_floating && m_floating->settled)
        m_floating.reset();
}

bool CanvasLift::paintOutline(QPainter &painter, SelectionOutline &outline, const Selection &selection,
                              const OverlayColours &colours, double dpr) const
{
    if (!m_floating || !holds(*m_floating->lift))
        return false;
    const std::optional<View> under = viewUnder(view(), m_floating->map);
    if (!under)
        painter.setTransform(inPixels(view(), m_floating->map), true);
    outline.paint(painter, under.value_or(view()), *m_floating->lift->lifted, selection, colours, dpr, true);
    return true;
}

} // namespace suffuse
