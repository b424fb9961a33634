#include "app/tools/shaping/push_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/tools/tool_fields.h"
#include "app/widgets/numbers/quantity.h"
#include "undo/run_edits.h"
#include "undo/text_edits.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QTimerEvent>

namespace suffuse {

namespace {

constexpr int stayMs = 40;            ///< milliseconds between touches while the pointer stays
constexpr double touchSpacing = 0.25; ///< radii between touches while the pointer moves
constexpr int mostTouches = 64;       ///< One report of the pointer makes no more touches than these.
constexpr double leastMove = 1e-3;    ///< radii; a shorter move has no direction that means anything
constexpr double pinchShare = 0.12;   ///< the share of the way to the middle that a touch at full strength takes
constexpr double roughShare = 0.06;   ///< the share of the radius by which a touch at full strength roughens

} // namespace

PushTool::PushTool(CanvasWidget &canvas, QObject *parent) : SizedTool("push", 40, canvas, parent) {}

QString PushTool::hint() const
{
    if (!said().isEmpty())
        return said();
    const bool all = m_editor.document().selection().isEmpty();
    switch (m_kind) {
    case TweakKind::Push:
        return all ? tr("Drag to push strokes along. [ and ] change the size.")
                   : tr("Drag to push the selected strokes along. [ and ] change the size.");
    case TweakKind::Comb:
        return all ? tr("Drag to turn strokes into the direction of the drag.")
                   : tr("Drag to turn the selected strokes into the direction of the drag.");
    case TweakKind::Pinch:
        return all ? tr("Hold to pull strokes together. Shift: apart.")
                   : tr("Hold to pull the selected strokes together. Shift: apart.");
    case TweakKind::Roughen:
        break;
    }
    return all ? tr("Drag to roughen strokes.") : tr("Drag to roughen the selected strokes.");
}

QWidget *PushTool::options()
{
    if (m_options)
        return m_options;
    m_options = new QWidget;
    QHBoxLayout *row = toolRow(m_options);
    m_kinds = new QComboBox(m_options);
    m_kinds->addItems({tr("Push"), tr("Comb"), tr("Pinch"), tr("Roughen")});
    m_kinds->setToolTip(tr("What the circle does to strokes"));
    m_kinds->setAccessibleName(tr("What the circle does to strokes"));
    m_kinds->setCurrentIndex(int(m_kind));
    connect(m_kinds, &QComboBox::activated, this, [this](int i) { setKind(TweakKind(i)); });
    row->addWidget(m_kinds);
    row->addSpacing(10);
    addSizeField(*row);
    FieldSpec strength =
        shareSpec(tr("Strength"), tr("How much of it one touch does; a pen's pressure takes from it"), m_strength);
    strength.minimum = 0.01;
    addNumber(*row, strength, [this](double value) { setStrength(value); })->setValue(m_strength);
    row->addStretch();
    return m_options;
}

void PushTool::setKind(TweakKind kind)
{
    if (kind == m_kind)
        return;
    m_kind = kind;
    if (m_kinds)
        m_kinds->setCurrentIndex(int(kind));
    emit hintChanged();
}

void PushTool::setStrength(double strength)
{
    m_strength = std::clamp(strength, 0.01, 1.0);
}

void PushTool::press(const PointerEvent &event)
{
    const QString names[] = {tr("Push strokes"), tr("Comb strokes"), tr("Pinch strokes"), tr("Roughen strokes")};
    say({});
    m_last = event;
    m_touches = 0;
    m_touched = m_sparedLetters = false;
    m_gesture = m_editor.begin(names[int(m_kind)]);
    if (m_kind == TweakKind::Pinch || m_kind == TweakKind::Roughen) {
        show({touchAt(event.point, {})});
        m_timer.start(stayMs, this);
    }
    showCircleAt(event.pixel);
}

Tweak PushTool::touchAt(Point centre, Point by) const
{
    const double force = m_strength * m_last.pressure;
    Tweak touch{m_kind, centre, radius(), by, force, m_touches};
    switch (m_kind) {
    case TweakKind::Push:
        touch.by = std::sqrt(force) * by; // The root lets even a light hand take strokes along.
        break;
    case TweakKind::Comb:
        break;
    case TweakKind::Pinch:
        touch.share = force * (m_last.modifiers & Qt::ShiftModifier ? -pinchShare : pinchShare);
        break;
    case TweakKind::Roughen:
        touch.share = force * roughShare;
        break;
    }
    return touch;
}

void PushTool::move(const PointerEvent &event)
{
    showCircleAt(event.pixel);
    if (!isBusy())
        return;
    const Point way = event.point - m_last.point;
    if (length(way) < leastMove * radius())
        return; // Short moves wait until they add up to a touch.
    const Point from = m_last.point;
    m_last = event;
    const int count = int(std::clamp(std::ceil(length(way) / (touchSpacing * radius())), 1.0, double(mostTouches)));
    std::vector<Tweak> touches;
    for (int i = 0; i < count; ++i) {
        touches.push_back(touchAt(from + (double(i) / count) * way, (1.0 / count) * way));
        ++m_touches;
    }
    show(touches);
    if (m_timer.isActive())
        m_timer.start(stayMs, this);
}

void PushTool::show(const std::vector<Tweak> &touches)
{
    const std::vector<StrokePtr> strokes = targets(touches);
    m_touched |= !strokes.empty();
    m_gesture.show(tweakStrokes(m_editor.document(), strokes, touches));
}

std::vector<StrokePtr> PushTool::targets(const std::vector<Tweak> &touches)
{
    const PaintingPtr reached = m_editor.layer().reached();
    const StrokeList &strokes = reached->strokes;
    const std::set<StrokeId> &selected = m_editor.document().selection().strokes;
    m_boxes.follow(strokes);
    Rect way;
    for (const Tweak &touch : touches)
        way.include(touch.centre);
    way = way.grown(2 * radius()); // Strokes that are moved may come into the circle from beside the way.
    std::vector<StrokePtr> result;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const Stroke &stroke = *strokes[i];
        if (!m_boxes[i].intersects(way) || (!selected.empty() && !selected.contains(stroke.id)) ||
            stroke.born() > m_editor.clock().time())
            continue;
        if (selected.empty() && textOf(*reached, stroke.group))
            m_sparedLetters = true;
        else
            result.push_back(strokes[i]);
    }
    return result;
}

void PushTool::timerEvent(QTimerEvent *event)
{
    if (event->timerId() != m_timer.timerId())
        return SizedTool::timerEvent(event);
    ++m_touches;
    show({touchAt(m_last.point, {})});
}

void PushTool::release(const PointerEvent &event)
{
    if (isBusy() && event.point != m_last.point) {
        PointerEvent last = event;
        // A pen reports pressure 0 when it lifts, so the last pressure before that counts.
        last.pressure = m_last.pressure;
        move(last);
    }
    finish();
    if (!m_touched && m_sparedLetters)
        say(tr("Letters are left alone while nothing is selected. Select the text to change its letters."));
}

void PushTool::cancel()
{
    m_gesture.giveUp();
    finish();
}

void PushTool::finish()
{
    m_timer.stop();
    m_gesture.commit();
}

} // namespace suffuse
