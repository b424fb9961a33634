#include "app/tools/brush/brush_sizing.h"

#include "app/session/editor.h"
#include "app/tools/canvas_tool.h"
#include "app/widgets/numbers/quantity.h"
#include "model/brush/brush_width.h"

#include <QTimerEvent>

namespace suffuse {

namespace {

constexpr double opacityStep = 0.1;
constexpr double leastSpread = 1e-7;
constexpr double greatestSpread = 1e5;
/// logical pixels that a drag takes before it is known to be one of size or one of opacity
constexpr double undecided = 4;
constexpr double doubling = 80;      ///< logical pixels across that double the size
constexpr double wholeOpacity = 200; ///< logical pixels upwards that raise the opacity from 0 to 1
constexpr int noteMs = 900;

QString noteOf(Quantity quantity, double value)
{
    const FieldSpec spec = specOf(quantity);
    return spec.name + QStringLiteral(" ") + spec.display.text(value);
}

} // namespace

void BrushSizing::begin(Point pixel)
{
    m_drag = Drag{m_editor.brush(), pixel};
}

void BrushSizing::end()
{
    if (std::exchange(m_drag, std::nullopt))
        showNote(m_note, false);
}

void BrushSizing::giveUp()
{
    if (!m_drag)
        return;
    m_editor.setBrush(std::exchange(m_drag, std::nullopt)->brush);
    showNote({}, false);
}

void BrushSizing::stepSize(int steps)
{
    scaleSize(std::pow(sizeStep, steps));
}

void BrushSizing::stepOpacity(int steps)
{
    addOpacity(opacityStep * steps);
}

void BrushSizing::scaleSize(double factor)
{
    Brush brush = m_editor.brush();
    brush.setSpread(std::clamp(brush.spread() * factor, leastSpread, greatestSpread));
    m_editor.setBrush(brush);
    showNote(noteOf(Quantity::Size, visibleWidth(brush)), m_drag.has_value());
}

void BrushSizing::addOpacity(double difference)
{
    Brush brush = m_editor.brush();
    brush.colour.opacity = float(std::clamp(double(brush.colour.opacity) + difference, 0.0, 1.0));
    m_editor.setBrush(brush);
    showNote(noteOf(Quantity::Opacity, double(brush.colour.opacity)), m_drag.has_value());
}

void BrushSizing::moveTo(Point pixel, double dpr)
{
    if (!m_drag)
        return;
    const Point way = (1 / dpr) * (pixel - m_drag->pixel);
    if (m_drag->what == Drag::Undecided && length(way) >= undecided)
        m_drag->what = std::abs(way.x) >= std::abs(way.y) ? Drag::Size : Drag::Opacity;
    if (m_drag->what == Drag::Undecided)
        return;
    // The change starts from the brush as it was at the beginning, so that dragging back leads to it exactly.
    Brush brush = m_editor.brush();
    brush.diffusion = m_drag->brush.diffusion;
    brush.colour.opacity = m_drag->brush.colour.opacity;
    m_editor.setBrush(brush);
    if (m_drag->what == Drag::Size)
        scaleSize(std::exp2(way.x / doubling));
    else
        addOpacity(-way.y / wholeOpacity);
}

void BrushSizing::showNote(const QString &note, bool stays)
{
    m_note = note;
    if (stays || note.isEmpty())
        m_noteTimer.stop();
    else
        m_noteTimer.start(noteMs, this);
    emit noteChanged();
}

void BrushSizing::timerEvent(QTimerEvent *event)
{
    if (event->timerId() == m_noteTimer.timerId())
        showNote({}, false);
}

} // namespace suffuse
