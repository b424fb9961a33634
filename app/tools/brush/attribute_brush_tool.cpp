#include "app/tools/brush/attribute_brush_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/tools/brush/wish_fields.h"
#include "app/tools/tool_fields.h"
#include "app/widgets/numbers/quantity.h"
#include "model/area/outline.h"
#include "model/painting/editable.h"
#include "undo/edits.h"

#include <QHBoxLayout>
#include <QTimerEvent>

namespace suffuse {

namespace {

constexpr int stayMs = 40;          ///< milliseconds between dabs while the pointer stays
constexpr double dabSpacing = 0.25; ///< radii between dabs while the pointer moves
/// One report of the pointer lays down no more dabs than these, however far away it is.
constexpr int mostDabs = 400;

/// The density of a line is a length, and no fill has it.
bool isLineDensity(const AttributeWish &wish)
{
    return wish.attribute == Attribute::Density && !wish.relative;
}

} // namespace

AttributeBrushTool::AttributeBrushTool(CanvasWidget &canvas, QObject *parent)
    : SizedTool("attributeBrush", 30, canvas, parent)
{
    m_wish = {.attribute = Attribute::Density, .relative = true, .value = 1.5, .colour = {}};
}

QString AttributeBrushTool::hint() const
{
    if (!said().isEmpty())
        return said();
    return m_editor.document().selection().isEmpty()
               ? tr("Drag over strokes to paint the chosen value onto their segments. [ and ] change the size.")
               : tr("Drag over the selection to paint the chosen value onto its segments. [ and ] change the size.");
}

QWidget *AttributeBrushTool::options()
{
    if (m_options)
        return m_options;
    m_options = new QWidget;
    QHBoxLayout *row = toolRow(m_options);
    m_fields = new WishFields(*row);
    m_fields->show(m_wish);
    connect(m_fields, &WishFields::wishChanged, this, [this](const AttributeWish &wish) { m_wish = wish; });
    addSizeField(*row);
    FieldSpec strength = shareSpec(tr("Strength"), tr("How fast it is laid down"), m_flow);
    strength.minimum = 0.001;
    addNumber(*row, strength, [this](double value) { setFlow(value); })->setValue(m_flow);
    row->addStretch();
    return m_options;
}

void AttributeBrushTool::setWish(const AttributeWish &wish)
{
    m_wish = wish;
    if (m_fields)
        m_fields->show(wish);
}

void AttributeBrushTool::setFlow(double flow)
{
    m_flow = std::clamp(flow, 0.001, 1.0);
}

void AttributeBrushTool::gatherTargets()
{
    m_targets.clear();
    m_fills.clear();
    const Document &document = m_editor.document();
    const PaintingPtr reached = m_editor.layer().reached();
    const Painting &painting = *reached;
    const Selection &selection = document.selection();
    std::set<StrokeId> inPart; // the strokes of which only segments are selected
    for (const SegmentRef &ref : selection.segments)
        inPart.insert(ref.stroke);
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        const bool isMeant = selection.isEmpty() || selection.strokes.contains(stroke->id);
        if (!isMeant || !isEditable(*stroke))
            continue;
        const bool part = inPart.contains(stroke->id);
        if (stroke->fill && !part && stroke->fill->age(m_editor.clock().time()) > 0)
            m_fills.push_back({stroke, DensityOfFill(*stroke, m_editor.clock().time())});
        const auto isPainted = [&](int k) {
            return !stroke->segments[std::size_t(k)].takesPaint() && !onlyBounds(*stroke, std::size_t(k));
        };
        for (int k = 0; k < int(stroke->segments.size()); ++k)
            if (part ? selection.segments.contains({stroke->id, k}) : isPainted(k))
                m_targets.push_back({stroke->id, k, stroke->cubicOf(stroke->segments[std::size_t(k)]).at(0.5), 1});
    }
    std::sort(m_targets.begin(), m_targets.end(), [](const Target &a, const Target &b) {
        return std::pair(a.stroke, a.segment) < std::pair(b.stroke, b.segment);
    });
}

void AttributeBrushTool::press(const PointerEvent &event)
{
    const QString names[] = {tr("Paint diffusion"), tr("Paint density"), tr("Paint granulation"),
                             tr("Paint colour"),    tr("Paint opacity"), tr("Paint drying time")};
    say({});
    m_last = event;
    m_wish.colour = m_editor.brush().colour;
    m_touched.clear();
    gatherTargets();
    m_gesture = m_editor.begin(names[int(m_wish.attribute)]);
    dabAt(event.point, event.pressure);
    show();
    m_timer.start(stayMs, this);
    showCircleAt(event.pixel);
}

void AttributeBrushTool::dabAt(Point point, double pressure)
{
    for (Target &target : m_targets) {
        const double share = m_flow * pressure * falloff(length(target.middle - point), radius());
        if (share <= 0)
            continue;
        target.left *= 1 - share;
        m_touched.insert(target.stroke);
    }
    constexpr double within = 0.25; // of ρ: half of what there is at the outline
    for (FillTarget &target : m_fills) {
        const Stroke &stroke = *target.stroke;
        if (target.density(point - stroke.origin).density <= within * double(stroke.fill->density))
            continue;
        if (isLineDensity(m_wish)) {
            m_metFill = true;
            continue;
        }
        target.left *= 1 - std::min(1.0, m_flow * pressure);
        m_touched.insert(stroke.id);
    }
}

void AttributeBrushTool::show()
{
    if (m_touched.empty())
        return;
    m_gesture.take(m_touched);
    m_gesture.show([this](const Stroke &stroke) {
        Stroke changed = stroke;
        const auto first = std::lower_bound(m_targets.begin(), m_targets.end(), stroke.id,
                                            [](const Target &t, StrokeId id) { return t.stroke < id; });
        for (auto t = first; t != m_targets.end() && t->stroke == stroke.id; ++t)
            if (t->left < 1 && std::size_t(t->segment) < stroke.segments.size())
                changed.segments[std::size_t(t->segment)] =
                    withAttribute(stroke.segments[std::size_t(t->segment)], m_wish, 1 - t->left);
        const auto fill = std::ranges::find(m_fills, stroke.id, [](const FillTarget &t) { return t.stroke->id; });
        if (stroke.fill && fill != m_fills.end() && fill->left < 1)
            changed.fill = withAttribute(*stroke.fill, m_wish, 1 - fill->left);
        return changed;
    });
}

void AttributeBrushTool::move(const PointerEvent &event)
{
    showCircleAt(event.pixel);
    if (!isBusy())
        return;
    const Point way = event.point - m_last.point;
    const double dabs = std::clamp(std::ceil(length(way) / (dabSpacing * radius())), 1.0, double(mostDabs));
    for (int i = 1; i <= int(dabs); ++i)
        dabAt(m_last.point + (i / dabs) * way, event.pressure);
    m_last = event;
    show();
    m_timer.start(stayMs, this);
}

void AttributeBrushTool::timerEvent(QTimerEvent *event)
{
    if (event->timerId() != m_timer.timerId())
        return SizedTool::timerEvent(event);
    dabAt(m_last.point, m_last.pressure);
    show();
}

void AttributeBrushTool::release(const PointerEvent &)
{
    const bool onlyFills = m_metFill && m_touched.empty();
    finish();
    if (onlyFills)
        say(tr("A fill has a density of its own, ρ, which the inspector shows. It can be painted relative to what it "
               "is."));
}

void AttributeBrushTool::cancel()
{
    m_gesture.giveUp();
    finish();
    say({});
}

void AttributeBrushTool::finish()
{
    m_timer.stop();
    m_gesture.commit();
    m_targets.clear();
    m_fills.clear();
    m_touched.clear();
    m_metFill = false;
}

} // namespace suffuse
