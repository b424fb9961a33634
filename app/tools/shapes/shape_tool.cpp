#include "app/tools/shapes/shape_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "app/tools/tool_fields.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/numbers/quantity.h"
#include "model/shaping/nodes/node_path.h"
#include "undo/edits.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

namespace suffuse {

namespace {

constexpr double leastSweep = std::numbers::pi / 180; ///< of arcs

QString keyOf(const char *name)
{
    return QStringLiteral("tools/shapes/") + QLatin1String(name);
}

/// The form that was stored last; numbers out of range count as unset.
ShapeForm storedForm()
{
    ShapeForm form;
    const auto stored = [](const char *name, auto &value, double least, double greatest) {
        bool ok = false;
        const double number = settings::store().value(keyOf(name)).toDouble(&ok);
        if (ok && number >= least && number <= greatest)
            value = std::remove_reference_t<decltype(value)>(number);
    };
    int kind = 0;
    stored("kind", kind, 0, int(ShapeKind::Star));
    form.kind = ShapeKind(kind);
    stored("radius", form.radius, 0, 1e6);
    stored("rounding", form.rounding, 0, 1);
    stored("corners", form.corners, ShapeForm::leastCorners, ShapeForm::mostCorners);
    stored("inner", form.inner, 0.01, 1);
    stored("from", form.from, -2 * std::numbers::pi, 2 * std::numbers::pi);
    stored("sweep", form.sweep, leastSweep, 2 * std::numbers::pi);
    form.isPie = settings::store().value(keyOf("pie"), true).toBool();
    return form;
}

void store(const ShapeForm &form)
{
    QSettings &store = settings::store();
    store.setValue(keyOf("kind"), int(form.kind));
    store.setValue(keyOf("radius"), form.radius);
    store.setValue(keyOf("rounding"), form.rounding);
    store.setValue(keyOf("corners"), form.corners);
    store.setValue(keyOf("inner"), form.inner);
    store.setValue(keyOf("from"), form.from);
    store.setValue(keyOf("sweep"), form.sweep);
    store.setValue(keyOf("pie"), form.isPie);
}

} // namespace

ShapeTool::ShapeTool(CanvasWidget &canvas, QObject *parent)
    : DrawingTool(canvas, QStringLiteral("shapes"), parent), m_form(storedForm())
{}

QString ShapeTool::hint() const
{
    return isFromMiddle(m_form.kind)
               ? tr("Drag from the middle to a corner. Shift: steps of 15°. Return: as the last one.")
               : tr("Drag from corner to corner. Shift: even sides. Ctrl: from the middle. Return: as the last one.");
}

void ShapeTool::setForm(const ShapeForm &form)
{
    const bool otherKind = form.kind != m_form.kind;
    m_form = form;
    store(form);
    showFields();
    if (otherKind)
        emit hintChanged();
}

void ShapeTool::addFields(QHBoxLayout &row)
{
    auto *kinds = new QComboBox(m_options);
    kinds->setObjectName("kind");
    kinds->addItems({tr("Rectangle"), tr("Ellipse"), tr("Polygon"), tr("Star")});
    kinds->setToolTip(tr("What is drawn"));
    kinds->setAccessibleName(tr("What is drawn"));
    connect(kinds, &QComboBox::activated, this, [this](int index) {
        ShapeForm form = m_form;
        form.kind = ShapeKind(index);
        setForm(form);
    });
    row.addWidget(kinds);
    DrawingTool::addFields(row);
    row.addSpacing(10);

    // Each field stands in a row of its own with its label, so that they are shown and hidden together.
    const auto add = [&](const char *name, const QList<ShapeKind> &shapes, const FieldSpec &spec, auto member) {
        auto *pair = new QWidget(m_options);
        pair->setObjectName(QLatin1String(name));
        QList<QVariant> shownFor;
        for (const ShapeKind kind : shapes)
            shownFor << int(kind);
        pair->setProperty("shapes", shownFor);
        auto *inner = new QHBoxLayout(pair);
        inner->setContentsMargins(0, 0, 0, 0);
        addNumber(*inner, spec, [this, member](double value) {
            ShapeForm form = m_form;
            using Number = std::remove_reference_t<decltype(form.*member)>;
            form.*member = std::is_integral_v<Number> ? Number(std::lround(value)) : Number(value);
            setForm(form);
        });
        row.addWidget(pair);
    };
    using enum ShapeKind;
    FieldSpec radius{tr("Corner radius"), tr("Radius of the corners; half of the shorter side is the most"),
                     lengthDisplay(), 0, 1e6};
    FieldSpec corners{tr("Corners"),
                      tr("How many corners a polygon, or tips a star has"),
                      {},
                      ShapeForm::leastCorners,
                      ShapeForm::mostCorners};
    corners.step = 1;
    corners.display.decimals = 0;
    FieldSpec inner = shareSpec(tr("Inner"), tr("Radius of the inner corners, as a share of that of the tips"), 0.4);
    inner.minimum = 0.01;
    const FieldSpec rounding = shareSpec(tr("Round"), tr("How much of each side is round"));
    FieldSpec from{tr("From"), tr("Where the arc begins, clockwise from the right"), angleDisplay(),
                   -2 * std::numbers::pi, 2 * std::numbers::pi};
    FieldSpec sweep{tr("Arc"), tr("How far the arc goes round; 360° is the whole ellipse"), angleDisplay(), leastSweep,
                    2 * std::numbers::pi};
    add("radius", {Rectangle}, radius, &ShapeForm::radius);
    add("corners", {Polygon, Star}, corners, &ShapeForm::corners);
    add("inner", {Star}, inner, &ShapeForm::inner);
    add("rounding", {Polygon, Star}, rounding, &ShapeForm::rounding);
    add("from", {Ellipse}, from, &ShapeForm::from);
    add("sweep", {Ellipse}, sweep, &ShapeForm::sweep);
    auto *pie = new QCheckBox(tr("Pie"), m_options);
    pie->setObjectName("pie");
    pie->setProperty("shapes", QList<QVariant>{int(Ellipse)});
    pie->setToolTip(tr("An arc is closed through the middle; else by a straight line"));
    connect(pie, &QCheckBox::toggled, this, [this](bool on) {
        ShapeForm form = m_form;
        form.isPie = on;
        setForm(form);
    });
    row.addWidget(pie);
    showFields();
}

/// What belongs to the kind of shape, with the values that count.
void ShapeTool::showFields()
{
    if (!m_options)
        return;
    m_options->findChild<QComboBox *>("kind")->setCurrentIndex(int(m_form.kind));
    for (QWidget *field : m_options->findChildren<QWidget *>(QString(), Qt::FindDirectChildrenOnly))
        if (const QVariant shapes = field->property("shapes"); shapes.isValid())
            field->setVisible(shapes.toList().contains(int(m_form.kind)));
    const auto show = [this](const char *name, double value) {
        m_options->findChild<QWidget *>(QLatin1String(name))->findChild<NumberField *>()->setValue(value);
    };
    show("radius", m_form.radius);
    show("corners", m_form.corners);
    show("inner", m_form.inner);
    show("rounding", m_form.rounding);
    show("from", m_form.from);
    show("sweep", m_form.sweep);
    m_options->findChild<QCheckBox *>("pie")->setChecked(m_form.isPie);
}

StrokePtr ShapeTool::strokeBetween(Point a, Point b) const
{
    return painted(outlineOf(m_form, a, b));
}

void ShapeTool::press(const PointerEvent &event)
{
    if (!mayBegin())
        return;
    begin(event);
    m_from = m_a = m_b = snapped(event);
}

void ShapeTool::aim(const PointerEvent &event)
{
    Point way = snapped(event) - m_from;
    const bool shift = event.modifiers & Qt::ShiftModifier;
    if (isFromMiddle(m_form.kind)) {
        if (shift)
            way = inSteps({}, way);
        m_a = m_from;
    } else {
        if (shift) {
            const double side = std::max(std::abs(way.x), std::abs(way.y));
            way = {std::copysign(side, way.x), std::copysign(side, way.y)};
        }
        m_a = event.modifiers & Qt::ControlModifier ? m_from - way : m_from;
    }
    m_b = m_from + way;
    show();
}

void ShapeTool::show()
{
    showDraft(strokeBetween(m_a, m_b));
    m_canvas.updateOverlay();
}

void ShapeTool::move(const PointerEvent &event)
{
    if (isBusy())
        aim(event);
}

void ShapeTool::release(const PointerEvent &event)
{
    if (!isBusy())
        return;
    aim(event);
    const double drag = length(m_b - m_a) * m_canvas.view().scale / m_canvas.devicePixelRatioF();
    const StrokePtr stroke = drag >= leastShapeDrag ? strokeBetween(m_a, m_b) : nullptr;
    if (stroke)
        m_size = m_b - m_a;
    cancel();
    if (stroke)
        finish(stroke);
}

void ShapeTool::finish(const StrokePtr &stroke)
{
    const QString names[] = {tr("Rectangle"), tr("Ellipse"), tr("Polygon"), tr("Star")};
    push(stroke, names[int(m_form.kind)]);
}

bool ShapeTool::wantsKey(const QKeyEvent &event) const
{
    return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

bool ShapeTool::keyPress(QKeyEvent *event)
{
    if (!wantsKey(*event) || isBusy())
        return false;
    if (!mayBegin())
        return true;
    const Point middle = m_canvas.view().centre;
    const Point a = isFromMiddle(m_form.kind) ? middle : middle - 0.5 * m_size;
    begin(m_editor.clock().time());
    const StrokePtr stroke = strokeBetween(a, a + m_size);
    m_id = 0;
    if (stroke)
        finish(stroke);
    return true;
}

void ShapeTool::paint(QPainter &painter, const View &view, double dpr) const
{
    if (!isBusy() || m_a == m_b)
        return;
    QPainterPath path;
    for (const Cubic &curve : outlineOf(m_form, m_a, m_b)) {
        const auto at = [&](int i) {
            const Point p = view.toPixels(curve.p[std::size_t(i)]);
            return QPointF(p.x, p.y);
        };
        if (path.elementCount() == 0)
            path.moveTo(at(0));
        path.cubicTo(at(1), at(2), at(3));
    }
    strokeTwoTone(painter, path, m_canvas.overlayColours().accent, dpr);
}

} // namespace suffuse
