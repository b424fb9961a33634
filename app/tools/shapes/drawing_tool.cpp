#include "app/tools/shapes/drawing_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/current_layer.h"
#include "app/session/drawing_aids.h"
#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "app/tools/tool_fields.h"
#include "model/shaping/nodes/node_path.h"
#include "undo/edits.h"

#include <QComboBox>
#include <QHBoxLayout>

namespace suffuse {

namespace {

QString paintKey(const QString &tool)
{
    return QStringLiteral("tools/%1/paint").arg(tool);
}

/// What was chosen last in the row of a tool; a fill at first.
ShapePaint storedPaint(const QString &tool)
{
    bool ok = false;
    const int paint = settings::store().value(paintKey(tool)).toInt(&ok);
    return ok && paint >= 0 && paint <= int(ShapePaint::Both) ? ShapePaint(paint) : ShapePaint::Fill;
}

} // namespace

DrawingTool::DrawingTool(CanvasWidget &canvas, const QString &name, QObject *parent)
    : CanvasTool(canvas, parent), m_name(name), m_paint(storedPaint(name))
{
    connect(&m_editor, &Editor::brushChanged, this, [this] {
        if (isBusy())
            show();
    });
    const auto forgetTakenBack = [this] {
        if (!isBusy())
            forget();
    };
    connect(&canvas, &CanvasWidget::toolChanged, this, forgetTakenBack);
    connect(&m_editor.document(), &Document::changed, this, [forgetTakenBack](const Change &change) {
        if (!change.strokes.empty() || change.order || change.canvas || change.texts || change.reset)
            forgetTakenBack();
    });
}

QWidget *DrawingTool::options()
{
    if (m_options)
        return m_options;
    m_options = new QWidget;
    QHBoxLayout *row = toolRow(m_options);
    addFields(*row);
    row->addStretch();
    return m_options;
}

void DrawingTool::addFields(QHBoxLayout &row)
{
    auto *paints = new QComboBox(m_options);
    paints->setObjectName("paint");
    paints->addItems({tr("Outline"), tr("Fill"), tr("Outline and fill")});
    paints->setToolTip(tr("What of the shape is painted"));
    paints->setAccessibleName(tr("What of the shape is painted"));
    paints->setCurrentIndex(int(m_paint));
    connect(paints, &QComboBox::activated, this, [this](int index) { setPaint(ShapePaint(index)); });
    row.addWidget(paints);
}

void DrawingTool::setPaint(ShapePaint paint)
{
    m_paint = paint;
    settings::store().setValue(paintKey(m_name), int(paint));
    if (m_options)
        m_options->findChild<QComboBox *>("paint")->setCurrentIndex(int(paint));
    if (isBusy())
        show();
}

bool DrawingTool::mayBegin()
{
    return m_editor.layer().takesPaint();
}

void DrawingTool::begin(Microseconds born)
{
    say({});
    m_id = m_editor.document().takeStrokeId();
    m_copies.begin(m_editor.document(), m_editor.aids().symmetry());
    m_born = born;
}

void DrawingTool::begin(const PointerEvent &event)
{
    m_snapping = Snapping(*m_editor.document().painting(), m_canvas.aids(), m_editor.aids().guides());
    begin(event.time);
    m_editor.clock().hold(true, event.late);
}

void DrawingTool::beginWithoutPointer(Microseconds born)
{
    m_snapping = Snapping(*m_editor.document().painting(), m_canvas.aids(), m_editor.aids().guides());
    begin(born);
    m_editor.clock().hold(true);
}

void DrawingTool::resume()
{
    beginWithoutPointer(m_born);
}

void DrawingTool::cancel()
{
    if (!isBusy())
        return;
    m_id = 0;
    forget();
    m_editor.document().setDraft(nullptr);
    m_editor.clock().hold(false);
    m_canvas.updateOverlay();
    emit hintChanged();
}

void DrawingTool::addOrSay(const StrokePtr &stroke, const QString &name)
{
    if (stroke)
        push(stroke, name);
    else
        say(tr("What was drawn encloses no area: nothing was added."));
}

void DrawingTool::push(const StrokePtr &stroke, const QString &name)
{
    m_editor.push(m_editor.layer().take(addStrokes(m_editor.document(), m_copies.with(stroke), true)), name);
}

void DrawingTool::showDraft(const StrokePtr &stroke, bool alone)
{
    m_editor.document().setDraft(stroke, alone ? std::vector<StrokePtr>() : m_copies.of(stroke));
}

Point DrawingTool::snapped(const PointerEvent &event) const
{
    return m_snapping.snap(event.point, m_canvas.view(), m_canvas.devicePixelRatioF()).point;
}

Point DrawingTool::placeOf(const PointerEvent &event, Point from) const
{
    return event.modifiers & Qt::ShiftModifier ? inSteps(from, event.point) : snapped(event);
}

StrokePtr DrawingTool::painted(const std::vector<Cubic> &curves) const
{
    return paintedAlong(curves, m_editor.brush(), m_id, m_born, m_paint);
}

} // namespace suffuse
