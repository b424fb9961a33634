#include "app/tools/brush/eyedropper_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/colour_convert.h"
#include "app/session/commands/commands.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/session/selecting/pick.h"
#include "app/tools/tool_fields.h"
#include "model/paint/local_paint.h"
#include "render/probe.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

#include <utility>

namespace suffuse {

namespace {

constexpr double ringRadius = 26;   ///< logical pixels
constexpr double ringWidth = 10;    ///< logical pixels
constexpr double hairlineSlack = 3; ///< logical pixels around the pointer in which hairlines are found

} // namespace

std::optional<Colour> pictureColourAt(const Painting &painting, Microseconds time, Point point)
{
    const Result<Probe> found = probe(reaching(painting, time, point), time, point.x, point.y);
    if (!found)
        return {};
    const std::array<double, 3> &ryb = found->rybAfter;
    const auto channel = [&ryb](int i) { return float(std::clamp(ryb[std::size_t(i)], 0.0, 1.0)); };
    return Colour{channel(0), channel(1), channel(2), 1};
}

std::optional<Colour> strokeColourAt(const Painting &painting, Microseconds time, Point point, double tolerance)
{
    const std::optional<SegmentRef> hit = pickTopmost(painting, time, point, tolerance);
    if (!hit)
        return {};
    const StrokePtr stroke = painting.find(hit->stroke);
    if (stroke->fill && stroke->fill->age(time) > 0) { // It is the fill's if that has the greater share.
        const Point at = point - stroke->origin;
        const DensityOfFill::Value fill = DensityOfFill(*stroke, time, at)(at);
        if (fill.density > 0.5 * seenPaint(*stroke, time, point).density) {
            LocalPaint paint;
            paint.add(*stroke->fill, stroke->style, fill.density, fill.place);
            const std::array<double, 4> c = paint.colour();
            return Colour{float(c[0]), float(c[1]), float(c[2]), float(c[3])};
        }
    }
    return painting.find(hit->stroke)->segments[std::size_t(hit->segment)].colour;
}

ColourPicker::ColourPicker(CanvasWidget &canvas) : m_canvas(canvas), m_editor(canvas.editor()) {}

void ColourPicker::begin(const PointerEvent &event)
{
    m_isOnly = m_editor.layer().reachedGroup() != 0;
    m_picture = m_isOnly ? m_editor.layer().reached() : m_editor.document().snapshot();
    m_before = m_picked = m_editor.colourTarget().colour();
    m_entry.beginDrag();
    move(event);
}

void ColourPicker::move(const PointerEvent &event)
{
    if (!m_picture)
        return;
    m_pixel = event.pixel;
    m_isBeyond = !m_picture->canvas.area().contains(event.point) && !m_canvas.aids().showBeyond;
    ColourTarget &target = m_editor.colourTarget();
    const Microseconds time = m_editor.clock().time();
    const bool ofStroke = event.modifiers & Qt::ShiftModifier;
    const double tolerance = hairlineSlack * m_canvas.devicePixelRatioF() / m_canvas.view().scale;
    // Where a layer only is asked, its bare ground is no colour.
    const bool isBare = m_isOnly && !pickTopmost(*m_picture, time, event.point, tolerance);
    const std::optional<Colour> colour = m_isBeyond || isBare ? std::nullopt
                                         : ofStroke           ? strokeColourAt(*m_picture, time, event.point, tolerance)
                                                              : pictureColourAt(*m_picture, time, event.point);
    if (colour) {
        m_picked = *colour;
        target.setPaint(*colour, &m_entry);
        if (ofStroke && target.kind() == ColourTarget::Kind::Brush) // The picture has no opacity, a stroke has one.
            target.setOpacity(colour->opacity, &m_entry);
    }
    m_canvas.updateOverlay();
}

QString ColourPicker::refusal() const
{
    return m_isBeyond
               ? QCoreApplication::translate("ColourPicker", "Beside the canvas there is no paint to take a colour "
                                                             "from, unless paint beyond the canvas is shown.")
               : QString();
}

void ColourPicker::end()
{
    if (!std::exchange(m_picture, nullptr))
        return;
    m_entry.commitDrag();
    m_canvas.updateOverlay();
}

void ColourPicker::giveUp()
{
    if (!m_picture)
        return;
    ColourTarget &target = m_editor.colourTarget();
    if (target.kind() == ColourTarget::Kind::Brush)
        m_editor.setColour(m_before);
    m_entry.giveUpDrag();
    end();
}

void ColourPicker::paint(QPainter &painter, double dpr) const
{
    if (!m_picture)
        return;
    const double r = ringRadius * dpr;
    const QRectF box(m_pixel.x - r, m_pixel.y - r, 2 * r, 2 * r);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(20, 20, 24, 160), (ringWidth + 3) * dpr));
    painter.drawEllipse(box);
    painter.setPen(QPen(Qt::white, (ringWidth + 1.5) * dpr));
    painter.drawEllipse(box);
    const auto half = [&](const Colour &colour, int from) {
        painter.setPen(QPen(toOpaqueScreen(colour), ringWidth * dpr, Qt::SolidLine, Qt::FlatCap));
        painter.drawArc(box, from * 16, 180 * 16);
    };
    half(m_picked, 0);
    half(m_before, 180);
}

EyedropperTool::EyedropperTool(CanvasWidget &canvas, QObject *parent)
    : CanvasTool(canvas, parent), m_picker(canvas), m_match(canvas)
{
    connect(&canvas.editor().colourTarget(), &ColourTarget::changed, this, &EyedropperTool::showTarget);
    connect(&canvas, &CanvasWidget::toolChanged, this, [this] {
        if (m_canvas.tool() != this && m_untilNextTool)
            setMatches(false);
    });
}

void EyedropperTool::beginMatching(Commands &commands)
{
    commands[Command::Eyedropper].setChecked(true);
    const bool chosen = m_matches && !m_untilNextTool;
    setMatches(true);
    m_untilNextTool = !chosen;
}

QString EyedropperTool::hint() const
{
    if (m_matches)
        return m_match.hint();
    if (const QString refusal = m_picker.refusal(); !refusal.isEmpty())
        return refusal;
    if (m_editor.colourTarget().kind() == ColourTarget::Kind::Selection)
        return tr("Click to give what is selected the picture's colour. Shift: the stroke's own colour. "
                  "Ctrl: its whole appearance.");
    if (m_editor.colourTarget().kind() == ColourTarget::Kind::Swatch)
        return tr("Click to give the swatch the picture's colour. Shift: the stroke's own colour.");
    return tr("Click to take the picture's colour as the current one. Shift: the stroke's own colour.");
}

QWidget *EyedropperTool::options()
{
    if (m_options)
        return m_options;
    m_options = new QWidget;
    QHBoxLayout *row = toolRow(m_options);
    auto *label = new QLabel(tr("A click takes"), m_options);
    m_takes = new QComboBox(m_options);
    m_takes->addItems({colourUseText(), tr("The appearance, for the selection")});
    m_takes->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_takes->setToolTip(tr("A colour, or style, values and colour of a stroke for the selected ones. The colour is for "
                           "what the Colour dock shows: the brush, the selection or a swatch."));
    m_takes->setAccessibleName(label->text());
    m_takes->setCurrentIndex(m_matches ? 1 : 0);
    label->setBuddy(m_takes);
    connect(m_takes, &QComboBox::activated, this, [this](int i) { setMatches(i == 1); });
    row->addWidget(label);
    row->addWidget(m_takes);
    row->addStretch();
    return m_options;
}

/// What a click does with the colour.
QString EyedropperTool::colourUseText() const
{
    switch (m_editor.colourTarget().kind()) {
    case ColourTarget::Kind::Selection:
        return tr("The colour, for the selection");
    case ColourTarget::Kind::Swatch:
        return tr("The colour, for the swatch");
    case ColourTarget::Kind::Brush:
        break;
    }
    return tr("The colour, to paint with");
}

void EyedropperTool::showTarget()
{
    if (m_takes)
        m_takes->setItemText(0, colourUseText());
    emit hintChanged();
}

void EyedropperTool::setMatches(bool matches)
{
    cancel();
    m_matches = matches;
    m_untilNextTool = false;
    if (m_takes)
        m_takes->setCurrentIndex(matches ? 1 : 0);
    emit hintChanged();
}

void EyedropperTool::press(const PointerEvent &event)
{
    if (m_matches || event.modifiers & Qt::ControlModifier)
        m_match.begin(event);
    else
        m_picker.begin(event);
    emit hintChanged();
}

void EyedropperTool::move(const PointerEvent &event)
{
    if (m_match.isActive())
        m_match.move(event);
    else
        m_picker.move(event);
    emit hintChanged();
}

void EyedropperTool::release(const PointerEvent &)
{
    m_match.end();
    m_picker.end();
}

void EyedropperTool::cancel()
{
    m_match.giveUp();
    m_picker.giveUp();
}

void EyedropperTool::paint(QPainter &painter, const View &, double dpr) const
{
    m_picker.paint(painter, dpr);
}

} // namespace suffuse
