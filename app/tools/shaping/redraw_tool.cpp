#include "app/tools/shaping/redraw_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/tools/tool_fields.h"
#include "model/painting/editable.h"
#include "undo/run_edits.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>

namespace suffuse {

namespace {

constexpr double strokeReach = 12; ///< logical pixels around a stroke in which a line may begin

} // namespace

RedrawTool::RedrawTool(CanvasWidget &canvas, QObject *parent) : CanvasTool(canvas, parent) {}

RedrawTool::~RedrawTool() = default;

QString RedrawTool::hint() const
{
    if (!said().isEmpty())
        return said();
    return m_editor.selection().isEmpty() ? tr("Draw from a stroke and back to it: the part between follows the line.")
                                          : tr("Draw from a selected stroke and back to it: the part between follows.");
}

QWidget *RedrawTool::options()
{
    if (m_options)
        return m_options;
    m_options = new QWidget;
    QHBoxLayout *row = toolRow(m_options);
    auto *label = new QLabel(tr("Values"), m_options);
    m_choice = new QComboBox(m_options);
    m_choice->addItems({tr("As they were"), tr("Of the brush in hand")});
    m_choice->setToolTip(tr("What the new part is painted with, and when"));
    m_choice->setAccessibleName(tr("Values"));
    m_choice->setCurrentIndex(int(m_values));
    label->setBuddy(m_choice);
    connect(m_choice, &QComboBox::activated, this, [this](int i) { setValues(RedrawValues(i)); });
    row->addWidget(label);
    row->addWidget(m_choice);
    row->addStretch();
    return m_options;
}

void RedrawTool::setValues(RedrawValues values)
{
    m_values = values;
    if (m_choice)
        m_choice->setCurrentIndex(int(values));
}

double RedrawTool::reach() const
{
    return strokeReach * m_canvas.devicePixelRatioF() / m_canvas.view().scale;
}

void RedrawTool::press(const PointerEvent &event)
{
    say({});
    Brush brush = m_editor.brush();
    if (m_values == RedrawValues::Kept)
        brush.taper = {};
    m_builder = std::make_unique<StrokeBuilder>(brush, m_editor.document().takeStrokeId());
    m_lastTime = event.time;
    m_line.clear();
    m_editor.clock().hold(true, event.late);
    add(event);
}

void RedrawTool::add(const PointerEvent &event)
{
    m_lastTime = std::max(m_lastTime, event.time);
    m_builder->add({event.point, m_lastTime, float(event.pressure), 0});
    if (m_line.empty() || m_line.back() != event.point)
        m_line.push_back(event.point);
    m_canvas.updateOverlay();
}

void RedrawTool::move(const PointerEvent &event)
{
    if (m_builder)
        add(event);
}

StrokeId RedrawTool::strokeUnder(const std::vector<Point> &line) const
{
    const PaintingPtr reached = m_editor.layer().reached();
    const Painting &painting = *reached;
    const Selection &selection = m_editor.document().selection();
    StrokeId best = 0;
    double nearest = std::numeric_limits<double>::infinity();
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        const bool isMeant = selection.isEmpty() || selection.strokes.contains(stroke->id);
        if (!isMeant || !isEditable(*stroke) || stroke->born() > m_editor.clock().time() ||
            !partToRedraw(*stroke, line, reach()))
            continue;
        double atStart = 0, atEnd = 0;
        nearestPlace(*stroke, line.front(), &atStart);
        nearestPlace(*stroke, line.back(), &atEnd);
        if (const double distance = std::min(atStart, reach()) + std::min(atEnd, reach()); distance <= nearest) {
            nearest = distance;
            best = stroke->id;
        }
    }
    return best;
}

void RedrawTool::release(const PointerEvent &event)
{
    if (!m_builder)
        return;
    // A pen reports pressure 0 when it lifts, which is no part of the line.
    if (event.device == PointerDevice::Mouse || event.pressure > 0)
        add(event);
    m_builder->finish();
    const StrokePtr line = m_builder->stroke();
    m_builder.reset();
    m_line.clear();
    m_editor.clock().hold(false);
    m_canvas.updateOverlay();
    const std::vector<Point> points = line ? pointsAlong(*line) : std::vector<Point>();
    const StrokeId stroke = points.size() > 1 ? strokeUnder(points) : 0;
    Edit edit = stroke ? redrawStroke(m_editor.document(), stroke, *line, reach(), m_values) : Edit();
    if (!edit.isEmpty())
        m_editor.push(std::move(edit), tr("Redraw"));
    else
        say(m_editor.selection().isEmpty() ? tr("The line begins and ends at no stroke that can be changed.")
                                           : tr("The line begins and ends at no selected stroke that can be changed."));
}

void RedrawTool::cancel()
{
    say({});
    if (!m_builder)
        return;
    m_builder.reset();
    m_line.clear();
    m_editor.clock().hold(false);
    m_canvas.updateOverlay();
}

void RedrawTool::paint(QPainter &painter, const View &view, double dpr) const
{
    if (m_line.size() < 2)
        return;
    QPainterPath path;
    for (const Point &point : m_line) {
        const Point p = view.toPixels(point);
        if (path.elementCount() == 0)
            path.moveTo(p.x, p.y);
        else
            path.lineTo(p.x, p.y);
    }
    strokeTwoTone(painter, path, m_canvas.overlayColours().accent, 1.6 * dpr);
}

} // namespace suffuse
