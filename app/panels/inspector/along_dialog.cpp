#include "app/panels/inspector/along_dialog.h"

#include "app/session/editor.h"
#include "app/widgets/habits/mnemonics.h"
#include "app/widgets/look/section.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace suffuse {

AlongDialog::AlongDialog(Editor &editor, QWidget *parent)
    : QDialog(parent), m_editor(editor), m_runs(runsOf(editor.document()))
{
    setWindowTitle(tr("Along the Stroke"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto *column = new QVBoxLayout(this);
    addChoice();
    m_curve = new CurveEditor(this);
    m_curve->setAccessibleName(tr("Curve along the stroke"));
    m_curve->setToolTip(
        tr("Drag the line or its ends; a drawn curve is drawn with the pointer. The dots are the values "
           "of the segments."));
    column->addWidget(m_curve, 1);
    addFields();
    m_hint = new HintLabel(this);
    m_hint->setMargin(0);
    column->addWidget(m_hint);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_curve, &CurveEditor::edited, this, [this] {
        showFields();
        apply();
    });
    connect(m_curve, &CurveEditor::released, this, [this] {
        m_beforeDrag.reset();
        m_gesture.rest();
    });
    connect(m_curve, &CurveEditor::givenUp, this, &AlongDialog::giveUpDrag);
    connect(&editor.document(), &Document::changed, this, &AlongDialog::documentChanged);
    giveMnemonics(*this);
    choose(Quantity::Density);
}

AlongDialog::~AlongDialog()
{
    m_gesture.commit(); // The window may be destroyed without closing this dialog.
}

void AlongDialog::addChoice()
{
    auto *row = new QHBoxLayout;
    m_choice = new QComboBox(this);
    m_choice->setAccessibleName(tr("Quantity"));
    auto *label = new QLabel(tr("Quantity"), this);
    label->setBuddy(m_choice);
    row->addWidget(label);
    for (const Quantity quantity : curveQuantities)
        m_choice->addItem(specOf(quantity).name);
    row->addWidget(m_choice, 1);
    m_shapes = new QButtonGroup(this);
    const std::pair<QString, QString> shapes[] = {
        {tr("Constant"), tr("The same value all along")},
        {tr("Ramp"), tr("Evenly from one value to another")},
        {tr("Drawn"), tr("A curve drawn with the pointer")},
    };
    for (const auto &[name, tip] : shapes) {
        auto *button = new QToolButton(this);
        button->setText(name);
        button->setToolTip(tip);
        button->setCheckable(true);
        button->setAutoRaise(true); // The chosen button is seen in a dark palette, too.
        button->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Preferred);
        m_shapes->addButton(button, int(m_shapes->buttons().size()));
        row->addWidget(button);
    }
    static_cast<QVBoxLayout *>(layout())->addLayout(row);
    connect(m_choice, &QComboBox::activated, this, [this](int index) { choose(curveQuantities[std::size_t(index)]); });
    connect(m_shapes, &QButtonGroup::idClicked, this, [this](int shape) { choose(Shape(shape)); });
}

void AlongDialog::addFields()
{
    auto *row = new QHBoxLayout;
    const auto add = [&](const QString &name, std::size_t knot) {
        auto *label = new QLabel(name, this);
        auto *field = new NumberField(this);
        label->setBuddy(field);
        field->setAccessibleName(name);
        row->addWidget(label);
        row->addWidget(field);
        connect(field, &NumberField::entered, this, [this, knot](double value) { setEnd(knot, value); });
        connect(field, &NumberField::stepped, this, [this, knot](double value) { setEnd(knot, value); });
        connect(field, &NumberField::refused, this, [this](const QString &hint) { m_hint->showRefusal(hint); });
        return std::pair(label, field);
    };
    m_start = add(tr("Start"), 0).second;
    row->addStretch(1);
    std::tie(m_endLabel, m_end) = add(tr("End"), 1);
    static_cast<QVBoxLayout *>(layout())->addLayout(row);
}

double AlongDialog::Axis::toShare(double value) const
{
    const double v = std::clamp(value, low, high);
    const double share = logarithmic ? std::log(v / low) / std::log(high / low) : (v - low) / (high - low);
    return reversed ? 1 - share : share;
}

double AlongDialog::Axis::toValue(double place) const
{
    const double share = reversed ? 1 - place : place;
    return std::clamp(logarithmic ? low * std::pow(high / low, share) : std::lerp(low, high, share), low, high);
}

/// The axis has the slider's range, widened to the values that there are.
AlongDialog::Axis AlongDialog::axisOf(Quantity quantity) const
{
    const FieldSpec spec = specOf(quantity);
    Axis axis{spec.sliderMinimum, spec.sliderMaximum, spec.logarithmic, spec.display.isReversed()};
    for (const auto &[id, run] : m_runs)
        for (const RunPlace &p : run.places) {
            const double value = valueOf(run.stroke->segments[std::size_t(p.segment)], quantity);
            if (value > 0 || !axis.logarithmic)
                axis.low = std::min(axis.low, value);
            axis.high = std::max(axis.high, value);
        }
    return axis;
}

std::vector<QPointF> AlongDialog::presentOf(Quantity quantity) const
{
    constexpr std::size_t mostDots = 4000;
    std::vector<QPointF> dots;
    for (const auto &[id, run] : m_runs)
        for (const RunPlace &p : run.places)
            if (dots.size() < mostDots)
                dots.emplace_back(p.place,
                                  m_axis.toShare(valueOf(run.stroke->segments[std::size_t(p.segment)], quantity)));
    std::stable_sort(dots.begin(), dots.end(), [](QPointF a, QPointF b) { return a.x() < b.x(); });
    return dots;
}

void AlongDialog::choose(Quantity quantity)
{
    m_quantity = quantity;
    m_choice->setCurrentIndex(
        int(std::find(curveQuantities.begin(), curveQuantities.end(), quantity) - curveQuantities.begin()));
    const auto it = m_set.find(quantity);
    m_axis = it == m_set.end() ? axisOf(quantity) : it->second.axis;
    showQuantity();
}

void AlongDialog::showQuantity()
{
    const FieldSpec spec = specOf(m_quantity);
    m_curve->setAxis(spec.display.text(m_axis.toValue(0)), spec.display.text(m_axis.toValue(1)));
    const std::vector<QPointF> present = presentOf(m_quantity);
    m_curve->setPresent(present);
    for (NumberField *field : {m_start, m_end}) {
        field->setRange(spec.minimum, spec.maximum);
        field->setDisplay(spec.display);
        field->setStep(spec.step);
    }
    PlaceCurve curve;
    if (const auto it = m_set.find(m_quantity); it != m_set.end()) {
        curve = it->second.curve;
    } else if (!present.empty()) { // The values are shown as they are, from end to end.
        curve.knots = {present.front().y(), present.back().y()};
        const bool same =
            std::all_of(present.begin(), present.end(), [&](QPointF p) { return p.y() == present.front().y(); });
        if (same)
            curve.knots.pop_back();
    }
    m_curve->setCurve(curve);
    showFields();
}

void AlongDialog::choose(Shape shape)
{
    const PlaceCurve &now = m_curve->curve();
    PlaceCurve next;
    if (shape == Constant)
        next.knots = {now.at(0)};
    else if (shape == Ramp)
        next.knots = {now.at(0), now.at(1)};
    else
        for (int i = 0; i < CurveEditor::drawnKnots; ++i) {
            next.knots.resize(CurveEditor::drawnKnots);
            next.knots[std::size_t(i)] = now.at(double(i) / (CurveEditor::drawnKnots - 1));
        }
    m_curve->setCurve(next);
    showFields();
    if (m_set.contains(m_quantity))
        apply(); // A curve that was set here is applied in its new shape; one that was only looked at changes nothing.
}

void AlongDialog::showFields()
{
    const PlaceCurve &curve = m_curve->curve();
    const std::size_t knots = curve.knots.size();
    m_shapes->button(knots == 1 ? Constant : knots == 2 ? Ramp : Drawn)->setChecked(true);
    m_start->setValue(m_axis.toValue(curve.at(0)));
    m_end->setValue(m_axis.toValue(curve.at(1)));
    m_start->setEnabled(knots <= 2);
    m_end->setEnabled(knots == 2);
    m_endLabel->setEnabled(knots == 2);
}

void AlongDialog::setEnd(std::size_t knot, double value)
{
    // The axis grows where a value beyond it is asked for, and the other knots keep their values.
    PlaceCurve curve = m_curve->curve();
    Axis grown = m_axis;
    if (value > 0 || !grown.logarithmic)
        grown.low = std::min(grown.low, value);
    grown.high = std::max(grown.high, value);
    for (double &k : curve.knots)
        k = grown.toShare(m_axis.toValue(k));
    m_axis = grown;
    curve.knots[std::min(knot, curve.knots.size() - 1)] = m_axis.toShare(value);
    m_set[m_quantity] = {curve, m_axis};
    showQuantity();
    apply();
}

void AlongDialog::apply()
{
    if (m_finished)
        return; // The strokes have gone while a drag went on.
    if (m_curve->isDragging() && !m_beforeDrag)
        m_beforeDrag = m_set;
    m_set[m_quantity] = {m_curve->curve(), m_axis};
    showValues();
}

void AlongDialog::giveUpDrag()
{
    if (!m_finished && m_beforeDrag)
        m_set = *m_beforeDrag;
    m_beforeDrag.reset();
    showFields();
    if (!m_finished)
        showValues();
}

/// Shows what was set so far.
void AlongDialog::showValues()
{
    std::map<Quantity, std::function<double(double)>> values;
    for (const auto &[quantity, set] : m_set)
        values[quantity] = [&set = set](double place) { return set.axis.toValue(set.curve.at(place)); };
    const QScopedValueRollback applying(m_applying, true);
    if (!m_gesture.isOpen())
        m_gesture = m_editor.begin(tr("Change along the stroke"));
    m_gesture.show(setAlong(m_editor.document(), runsToSet(), values));
    if (!m_curve->isDragging())
        m_gesture.rest();
}

const StrokeRuns &AlongDialog::runsToSet()
{
    const bool varies = std::any_of(m_set.begin(), m_set.end(), [](const auto &entry) {
        const std::vector<double> &knots = entry.second.curve.knots;
        return std::any_of(knots.begin(), knots.end(), [&](double k) { return k != knots.front(); });
    });
    if (!varies)
        return m_runs;
    if (!m_refined)
        m_refined = refined(m_runs);
    return *m_refined;
}

void AlongDialog::accept()
{
    m_gesture.commit();
    QDialog::accept();
}

void AlongDialog::reject()
{
    // If something else was done meanwhile, a part of the changes is a step already, so the old values are set anew.
    const QScopedValueRollback applying(m_applying, true);
    m_gesture.show(setAlong(m_editor.document(), m_runs, {}));
    m_gesture.commit();
    QDialog::reject();
}

void AlongDialog::keyPressEvent(QKeyEvent *event)
{
    // Return enters a number, and does not close the dialog.
    const bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (!enters || !qobject_cast<NumberField *>(focusWidget()))
        QDialog::keyPressEvent(event);
}

void AlongDialog::documentChanged(const Change &change)
{
    const bool ours =
        std::any_of(change.strokes.begin(), change.strokes.end(), [this](StrokeId id) { return m_runs.contains(id); });
    if (m_applying || m_finished || !(change.reset || ours))
        return;
    m_finished = true;
    accept();
}

} // namespace suffuse
