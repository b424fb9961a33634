#include "app/tools/shaping/eraser_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/tools/tool_fields.h"
#include "model/paint/seen_paint.h"
#include "model/paint/style_function.h"
#include "model/painting/wash_groups.h"
#include "undo/node_edits.h"

#include <QHBoxLayout>
#include <QPainter>

#include <algorithm>

namespace suffuse {

namespace {

constexpr double pressSlack = 3;           ///< logical pixels around a press in which hairlines are found
constexpr double strengthStep = 0.1;       ///< of the commands for opacity
constexpr std::size_t mostExplained = 200; ///< samples that are looked at for why nothing was erased
constexpr std::size_t mostLookedAt = 16;   ///< samples at which it is looked whether a gap is seen

/// A dot with a rim, for a soft tip.
QCursor softCursor(double dpr)
{
    constexpr int size = 13; // logical pixels
    QPixmap picture(int(size * dpr), int(size * dpr));
    picture.setDevicePixelRatio(dpr);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(20, 20, 24), 1.2));
    painter.setBrush(Qt::white);
    painter.drawEllipse(QPointF(0.5 * size, 0.5 * size), 2.6, 2.6);
    return QCursor(picture);
}

/// Whether a stroke was cut along the path, and still covers the middle of the gap by more than half of what it did.
/// `dry`: when all paint is.
bool closesGap(const Stroke &before, const Stroke &now, const std::vector<PenSample> &path, Microseconds dry)
{
    if (before == now)
        return false;
    const PaintSight was(before, dry), is(now, dry);
    double covered = 0, left = 0;
    const std::size_t step = std::max<std::size_t>(path.size() / mostLookedAt, 1);
    for (std::size_t i = 0; i < path.size(); i += step) {
        covered += was.at(path[i].position).opacity;
        left += is.at(path[i].position).opacity;
    }
    return covered > 0 && left > 0.5 * covered;
}

} // namespace

EraserTool::EraserTool(CanvasWidget &canvas, QObject *parent)
    : SizedTool("eraser", 10, canvas, parent), m_choice(EraserChoice::stored()), m_mode(m_choice.mode)
{
    connect(&m_editor.document(), &Document::changed, this, [this](const Change &change) {
        if (change.selection || change.reset)
            followSelection();
    });
    connect(&m_canvas, &CanvasWidget::modifiersChanged, this, [this] {
        if (m_canvas.tool() == this && !isBusy())
            followModifiers(m_canvas.modifiers());
    });
}

/// Hint and row say whether the selected strokes are meant, or all as none is selected.
void EraserTool::followSelection()
{
    if (m_fields)
        m_fields->setAnySelected(!m_editor.selection().isEmpty());
    emit hintChanged();
}

QString EraserTool::hint() const
{
    if (!said().isEmpty())
        return said();
    const bool selected = m_choice.scope == EraserScope::Selected && !m_editor.document().selection().isEmpty();
    const bool group = m_choice.scope == EraserScope::Group;
    if (m_mode == EraserMode::Fade)
        return selected
                   ? tr("Fade: drag to make the selected strokes paler, by the strength. Shift: cut. [ and ] change "
                        "the size, { and } the strength.")
               : group ? tr("Fade: drag to make the strokes of the group paler, by the strength. Shift: cut. [ and ] "
                            "change the size, { and } the strength.")
                       : tr("Fade: drag to make paint paler, by the strength, wherever it is seen. Shift: cut. [ and ] "
                            "change the size, { and } the strength.");
    if (m_mode == EraserMode::Lift)
        return selected ? tr("Lift: drag to take paint away softly from the selected strokes. Shift: cut. [ and ] "
                             "change the size, { and } the strength.")
               : group  ? tr("Lift: drag to take paint away softly from the strokes of the group. Shift: cut. [ and ] "
                              "change the size, { and } the strength.")
                       : tr("Lift: drag to take paint away softly, wherever it is seen. Shift: cut. [ and ] change the "
                            "size, { and } the strength.");
    return selected ? tr("Cut: drag to cut out what of the selected curves lies under the circle. Shift: erase softly. "
                         "[ and ] change the size.")
           : group ? tr("Cut: drag to cut out what of the group's curves lies under the circle. Shift: erase softly. [ "
                        "and ] change the size.")
                   : tr("Cut: drag to cut out what of the curves lies under the circle. Shift: erase softly. [ and ] "
                        "change the size.");
}

QCursor EraserTool::cursor() const
{
    return isSoft() ? softCursor(m_canvas.devicePixelRatioF()) : QCursor(Qt::CrossCursor);
}

QWidget *EraserTool::options()
{
    if (m_options)
        return m_options;
    m_options = new QWidget;
    QHBoxLayout *row = toolRow(m_options);
    m_fields = new EraserFields(*row, [this, row] { addSizeField(*row); });
    m_fields->show(m_choice);
    followSelection();
    connect(m_fields, &EraserFields::chosen, this, &EraserTool::setChoice);
    return m_options;
}

void EraserTool::setChoice(const EraserChoice &choice)
{
    if (choice == m_choice)
        return;
    m_choice = choice;
    m_choice.store();
    if (m_fields)
        m_fields->show(choice);
    say({});
    if (!isBusy())
        followModifiers(m_canvas.modifiers());
    emit hintChanged();
}

void EraserTool::setMode(EraserMode mode)
{
    if (mode == m_mode)
        return;
    m_mode = mode;
    m_canvas.refreshCursor();
    m_canvas.updateOverlay();
    emit hintChanged();
}

void EraserTool::followModifiers(Qt::KeyboardModifiers held)
{
    setMode(held & Qt::ShiftModifier ? m_choice.other() : m_choice.mode);
}

void EraserTool::stepOpacity(int steps)
{
    EraserChoice choice = m_choice;
    choice.strength = std::clamp(std::round((choice.strength + steps * strengthStep) / strengthStep) * strengthStep,
                                 strengthStep, 1.0);
    setChoice(choice);
}

void EraserTool::hover(const PointerEvent &event)
{
    SizedTool::hover(event);
    followModifiers(event.modifiers);
}

void EraserTool::press(const PointerEvent &event)
{
    say({});
    followModifiers(event.modifiers);
    m_gesture = m_editor.begin(tr("Erase"));
    const Document &document = m_editor.document();
    m_began = m_editor.clock().time();
    m_reach = EraserReach(document, m_editor.layer(), m_began, m_choice.scope, event.point,
                          pressSlack * m_canvas.devicePixelRatioF() / m_canvas.view().scale);
    m_samples.clear();
    m_took = false;
    m_before = document.painting();
    m_cut.clear();
    if (isSoft()) {
        m_soft = std::make_unique<SoftEraser>(tip(), m_reach.strokesOf(*document.painting(), m_began), m_began,
                                              washesOf(*document.painting()));
        m_editor.clock().hold(true, event.late); // what is laid down spreads at once
        takeTo(event);
    } else {
        m_samples.push_back({event.point, event.time});
        cutTo(event.point);
    }
    showCircleAt(event.pixel);
}

SoftTip EraserTool::tip() const
{
    return {radius(), m_choice.softness, m_choice.strength, m_mode == EraserMode::Fade ? SoftWay::Fade : SoftWay::Lift};
}

void EraserTool::takeTo(const PointerEvent &event)
{
    const Microseconds last = m_samples.empty() ? event.time : m_samples.back().time;
    m_samples.push_back({event.point, std::max(last, event.time), float(event.pressure)});
    m_soft->add(m_samples.back());
    showTaken();
}

void EraserTool::showTaken()
{
    const std::set<StrokeId> touched = m_soft->touched();
    m_took = !touched.empty();
    m_gesture.take(touched);
    m_gesture.show([this](const Stroke &stroke) { return m_soft->erased(stroke); });
}

void EraserTool::cutTo(Point point)
{
    Document &document = m_editor.document();
    const Point from = m_samples.back().position;
    if (Edit edit = eraseAlong(document, targets(from, point), {from, point}, radius(), m_editor.clock().time(),
                               Leaves::Chains);
        !edit.isEmpty()) {
        m_took = true;
        for (const auto &[id, stroke] : edit.strokes)
            m_cut.insert(id);
        m_gesture.show(std::move(edit));
    }
    m_samples.push_back({point, m_samples.back().time});
}

std::set<StrokeId> EraserTool::targets(Point from, Point to)
{
    const Painting &painting = *m_editor.document().painting();
    const StrokeList &strokes = painting.strokes;
    m_boxes.follow(strokes);
    Rect path;
    path.include(from);
    path.include(to);
    path = path.grown(radius());
    std::set<StrokeId> result;
    for (std::size_t i = 0; i < strokes.size(); ++i)
        if (m_boxes[i].intersects(path) && m_reach.spares(*strokes[i]) == Spared::Nothing)
            result.insert(strokes[i]->id);
    return result;
}

void EraserTool::move(const PointerEvent &event)
{
    showCircleAt(event.pixel);
    if (!isBusy())
        return;
    if (m_soft)
        takeTo(event);
    else if (event.point != m_samples.back().position)
        cutTo(event.point);
}

void EraserTool::release(const PointerEvent &event)
{
    if (!isBusy())
        return;
    if (m_soft) {
        if (event.device == PointerDevice::Mouse || event.pressure > 0) // a pen lifts with pressure 0
            takeTo(event);
        m_soft->finish();
        showTaken();
    } else if (event.point != m_samples.back().position) {
        cutTo(event.point);
    }
    const QString why = !m_took ? whyNothing() : m_soft ? QString() : whyNoGap();
    finish();
    say(why);
}

void EraserTool::finish()
{
    m_gesture.commit();
    if (std::exchange(m_soft, nullptr))
        m_editor.clock().hold(false);
}

void EraserTool::cancel()
{
    // What was erased before something else changed the painting stays, as a step of its own.
    m_gesture.giveUp();
    finish();
    say({});
}

QString EraserTool::whyNothing() const
{
    const Painting &painting = *m_editor.document().painting();
    SoftTip strongest = tip();
    strongest.strength = 1;
    SoftEraser anything(strongest, visibleStrokes(painting, m_began), m_began);
    for (std::size_t i = 0; i < std::min(m_samples.size(), mostExplained); ++i)
        anything.add({m_samples[i].position, m_samples[i].time});
    anything.finish();
    std::set<Spared> reasons;
    for (const StrokeId id : anything.touched())
        reasons.insert(m_reach.spares(*painting.find(id)));
    if (reasons.empty())
        return tr("Nothing is erased: no paint is seen under the circle.");
    if (reasons.contains(Spared::Nothing))
        return tr("Nothing is cut: no curve lies under the circle. Fade takes paint away wherever it is seen.");
    if (reasons.contains(Spared::OtherLayer))
        return tr("Nothing is erased: what lies under the circle is not on the layer, and only that is reached.");
    if (reasons.contains(Spared::NotSelected))
        return tr("Nothing is erased: what lies under the circle is not selected.");
    if (reasons.contains(Spared::OtherGroup))
        return tr("Nothing is erased: what lies under the circle is in another group.");
    return tr("Nothing is erased: what lies under the circle is locked.");
}

QString EraserTool::whyNoGap() const
{
    const Painting &painting = *m_editor.document().painting();
    for (const StrokeId id : m_cut) {
        const StrokePtr now = painting.find(id), before = m_before->find(id);
        if (now && before && closesGap(*before, *now, m_samples, painting.end()))
            return tr("It was cut, but hardly a gap is seen: its edges are softer than the cut is wide. Fade takes "
                      "its paint away.");
    }
    return {};
}

void EraserTool::paint(QPainter &painter, const View &view, double dpr) const
{
    SizedTool::paint(painter, view, dpr);
    if (isSoft())
        paintSoftRing(painter, 0.5, view, dpr);
}

} // namespace suffuse
