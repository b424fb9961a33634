#include "app/panels/inspector/along/along_dialog.h"

#include "app/session/editor.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/habits/mnemonics.h"
#include "app/widgets/look/section.h"
#include "model/restyling/profile.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

AlongDialog::Shape shapeOf(const PlaceCurve &curve)
{
    if (curve.isPoints())
        return AlongDialog::Points;
    return curve.knots.size() == 1   ? AlongDialog::Constant
           : curve.knots.size() == 2 ? AlongDialog::Ramp
                                     : AlongDialog::Drawn;
}

QString nameOfStroke(const Stroke &stroke)
{
    return stroke.name.isEmpty() ? AlongDialog::tr("Stroke %1").arg(stroke.id) : stroke.name;
}

} // namespace

AlongDialog::AlongDialog(Editor &editor, QWidget *parent) : QDialog(parent), m_editor(editor)
{
    setHelpPage(*this, "refining");
    m_state.runs = std::make_shared<const StrokeRuns>(runsOf(editor.document()));
    setAttribute(Qt::WA_DeleteOnClose);
    auto *outer = new QVBoxLayout(this);
    m_body = new QWidget(this);
    outer->addWidget(m_body, 1);
    auto *column = new QVBoxLayout(m_body);
    column->setContentsMargins({});
    addChoice();
    m_curve = new CurveEditor(this);
    m_curve->setAccessibleName(tr("Curve along the stroke"));
    m_curve->setToolTip(
        tr("Drag the line, its ends or its points; a press beside them makes a point, Del removes one. A drawn curve "
           "is drawn with the pointer. The dots are the values of the segments."));
    column->addWidget(m_curve, 1);
    addFields();
    m_hint = new HintLabel(this);
    m_hint->setMargin(0);
    outer->addWidget(m_hint);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    outer->addWidget(buttons);
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
    connect(&editor.undoStack(), &QUndoStack::indexChanged, this, [this] {
        if (!m_applying)
            goOnFromStep();
    });
    EntryField::letReturnShowFirst(*this);
    giveMnemonics(*this);
    showSubject();
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
        {tr("Points"), tr("The values that there are, as a curve of points that can be moved")},
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
    static_cast<QVBoxLayout *>(m_body->layout())->addLayout(row);
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
    row->addStretch(1);
    addScale(*row);
    static_cast<QVBoxLayout *>(m_body->layout())->addLayout(row);
}

void AlongDialog::addScale(QHBoxLayout &row)
{
    m_scaleLabel = new QLabel(this);
    m_scale = new NumberField(this);
    m_scaleLabel->setBuddy(m_scale);
    row.addWidget(m_scaleLabel);
    row.addWidget(m_scale);
    connect(m_scale, &NumberField::entered, this, &AlongDialog::scaleBy);
    connect(m_scale, &NumberField::stepped, this, &AlongDialog::scaleBy);
    connect(m_scale, &NumberField::refused, this, [this](const QString &hint) { m_hint->showRefusal(hint); });
}

void AlongDialog::showScale()
{
    const FieldSpec spec = specOf(m_quantity);
    const bool scales = spec.logarithmic;
    m_scaleLabel->setText(scales ? tr("Scale") : tr("Add"));
    m_scale->setAccessibleName(m_scaleLabel->text());
    giveMnemonics(*this); // The label's new text has none yet.
    m_scale->setToolTip(scales ? tr("Multiplies all of it; what varies along the stroke stays")
                               : tr("Is added to all of it; what varies along the stroke stays"));
    m_scale->setRange(scales ? 0.001 : spec.minimum - spec.maximum, scales ? 1000 : spec.maximum - spec.minimum);
    Display difference = spec.display;
    difference.offset = 0;
    m_scale->setDisplay(scales ? Display{.unit = QStringLiteral(" ×")} : difference);
    m_scale->setStep(scales ? 0 : spec.step);
    m_scale->setValue(ValueChange::neutral(scales ? ValueChange::Scale : ValueChange::Shift));
}

ValueAxis AlongDialog::axisOf(Quantity quantity) const
{
    const FieldSpec spec = specOf(quantity);
    ValueAxis axis{spec.sliderMinimum, spec.sliderMaximum, spec.logarithmic, spec.display.isReversed()};
    for (const auto &[id, run] : *m_state.runs)
        for (const RunPlace &p : run.places)
            axis.include(double(valueOf(run.stroke->segments[std::size_t(p.segment)], quantity)));
    return axis;
}

std::vector<QPointF> AlongDialog::presentOf(Quantity quantity) const
{
    constexpr std::size_t mostDots = 4000;
    std::vector<QPointF> dots;
    for (const auto &[id, run] : *m_state.runs)
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
    const auto it = m_state.set.find(quantity);
    m_axis = it == m_state.set.end() ? axisOf(quantity) : it->second.axis;
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
    m_from.reset();
    if (const auto it = m_state.set.find(m_quantity); it != m_state.set.end()) {
        curve = it->second.curve;
        m_from = it->second.from;
    } else if (!present.empty()) { // The values are shown as they are.
        const bool same =
            std::all_of(present.begin(), present.end(), [&](QPointF p) { return p.y() == present.front().y(); });
        curve.knots = {present.front().y()};
        if (!same)
            m_from = curve = presentCurve(*m_state.runs, m_quantity, m_axis);
    }
    m_curve->setCurve(curve);
    showFields();
}

void AlongDialog::choose(Shape shape)
{
    const PlaceCurve now = m_curve->curve();
    if (shape == shapeOf(now))
        return showFields();
    std::vector<Point> samples;
    double mean = 0;
    for (int i = 0; i < CurveEditor::drawnKnots; ++i) {
        const double place = double(i) / (CurveEditor::drawnKnots - 1);
        samples.push_back({place, now.at(place)});
        mean += samples.back().y / CurveEditor::drawnKnots;
    }
    // A constant and a ramp take the place of what was there; the others go on from it.
    if (shape == Constant || shape == Ramp)
        m_from.reset();
    PlaceCurve next;
    if (shape == Constant)
        next.knots = {now.knots.size() > 2 ? mean : now.at(0)};
    else if (shape == Ramp)
        next.knots = {now.at(0), now.at(1)};
    else if (shape == Points)
        next = pointsThrough(simplifiedProfile(samples, 0.01), m_from ? 0 : 1);
    else
        next = drawnThrough(samples, m_from ? 0 : 1);
    m_curve->setCurve(next);
    showFields();
    if (m_state.set.contains(m_quantity))
        apply(); // A curve that was set here is applied in its new shape; one that was only looked at changes nothing.
}

void AlongDialog::showFields()
{
    const PlaceCurve &curve = m_curve->curve();
    const Shape shape = shapeOf(curve);
    m_shapes->button(shape)->setChecked(true);
    m_start->setValue(m_axis.toValue(curve.at(0)));
    m_end->setValue(m_axis.toValue(curve.at(1)));
    showScale();
    const bool hasEnds = shape == Ramp || shape == Points;
    m_start->setEnabled(shape != Drawn);
    m_end->setEnabled(hasEnds);
    m_endLabel->setEnabled(hasEnds);
}

void AlongDialog::set(const CurveAlong &curve)
{
    if (m_finished)
        return;
    note();
    m_state.set[m_quantity] = curve;
    m_axis = curve.axis;
    showQuantity();
    m_state.set[m_quantity] = shown();
    showValues();
}

/// Before something is changed: that is stepped back to. A drag is one change.
void AlongDialog::note()
{
    const bool goesOn = m_curve->isDragging() && m_beforeDrag;
    if (goesOn && !m_past.empty())
        return;
    m_past.emplace_back(m_quantity, m_state.set); // What a drag does after it was saved is another change.
    if (m_curve->isDragging() && !goesOn)
        m_beforeDrag = {m_state.set, m_future};
    m_future.clear();
}

void AlongDialog::setEnd(std::size_t knot, double value)
{
    CurveAlong next = shown();
    next.growAxis(value);
    next.curve.knots[knot == 0 ? 0 : next.curve.knots.size() - 1] = next.axis.toShare(value);
    set(next);
}

void AlongDialog::scaleBy(double amount)
{
    const FieldSpec spec = specOf(m_quantity);
    CurveAlong next = shown();
    next.change({spec.logarithmic ? ValueChange::Scale : ValueChange::Shift, amount, spec.minimum, spec.maximum});
    set(next);
}

void AlongDialog::apply()
{
    if (m_finished)
        return; // The strokes have gone while a drag went on.
    note();
    m_state.set[m_quantity] = shown();
    showValues();
}

void AlongDialog::giveUpDrag()
{
    if (!m_finished && m_beforeDrag) {
        m_state.set = std::move(m_beforeDrag->set);
        m_future = std::move(m_beforeDrag->future);
        if (!m_past.empty()) // It is, where the drag has been saved and has not moved since.
            m_past.pop_back();
    }
    m_beforeDrag.reset();
    showFields();
    if (!m_finished)
        showValues();
}

void AlongDialog::step(bool back)
{
    if (m_curve->isDragging()) { // What it has changed so far is a change, and comes back by redo.
        m_curve->dropDrag();
        m_beforeDrag.reset();
    }
    auto &from = back ? m_past : m_future, &to = back ? m_future : m_past;
    const Quantity quantity = from.back().first; // that was changed
    to.emplace_back(quantity, std::move(m_state.set));
    m_state.set = std::move(from.back().second);
    from.pop_back();
    showValues();
    choose(quantity);
}

void AlongDialog::handOver(const std::function<bool()> &commit, const std::function<void()> &undo)
{
    const QScopedValueRollback applying(m_applying, true);
    std::vector<CurvesSet> states;
    for (const auto &[quantity, set] : m_past)
        states.push_back(set);
    const std::size_t now = states.size();
    states.push_back(m_state.set);
    for (auto it = m_future.rbegin(); it != m_future.rend(); ++it)
        states.push_back(it->second);
    int undone = 0; // steps after what is shown now
    for (std::size_t k = 0; k < states.size(); ++k) {
        m_state.set = states[k];
        showValues();
        const bool isStep = commit(); // of the first one: what was done to other strokes before
        undone += isStep && k > now;
    }
    for (; undone > 0; --undone)
        undo();
    m_state.set = states[now];
    m_gesture.commit();
    goOnFromStep();
}

/// All that was changed is steps now, which undo takes back one by one; a drag goes on from there.
void AlongDialog::goOnFromStep()
{
    m_past.clear();
    m_future.clear();
    if (!m_beforeDrag)
        return;
    m_beforeDrag = {m_state.set, {}};
    m_curve->keepDragSoFar();
}

/// Shows what was set so far.
void AlongDialog::showValues()
{
    std::map<Quantity, ValueAlong> values;
    for (const auto &[quantity, set] : m_state.set)
        values[quantity] = [&set = set](double place, double old) { return set.valueAt(place, old); };
    showRuns(m_state.runsToSet(), values);
    m_states.note(*m_editor.document().painting(), m_state);
    if (!m_curve->isDragging())
        m_gesture.rest();
}

void AlongDialog::showRuns(const StrokeRuns &runs, const std::map<Quantity, ValueAlong> &values)
{
    const QScopedValueRollback applying(m_applying, true);
    if (!m_gesture.isOpen()) // Nothing was changed yet, or all of it has been made steps since.
        m_gesture = m_editor.begin(tr("Change along the stroke"), this);
    m_gesture.show(setAlong(m_editor.document(), runs, values));
}

void AlongDialog::accept()
{
    m_gesture.commit();
    QDialog::accept();
}

void AlongDialog::reject()
{
    // Where it was saved, or something else was done meanwhile, a part of the changes is a step already, so the old
    // values are set anew.
    if (const StrokeRuns starts = m_states.starts(*m_editor.document().painting()); !starts.empty())
        showRuns(starts, {});
    m_gesture.commit();
    QDialog::reject();
}

void AlongDialog::documentChanged(const Change &change)
{
    if (m_applying || m_finished)
        return;
    const bool ours = std::any_of(change.strokes.begin(), change.strokes.end(),
                                  [this](StrokeId id) { return m_state.runs->contains(id); });
    const Painting &painting = *m_editor.unsettled().painting();
    const bool isGone = std::ranges::any_of(*m_state.runs, [&](const auto &run) { return !painting.find(run.first); });
    if (change.reset || isGone) {
        m_finished = true;
        accept();
        return;
    }
    if (change.selection || ours)
        follow();
}

/// Goes on with what is selected now: with the curves that were set there, where it is as the window has shown it, and
/// with the values that there are else. OK and Cancel decide what was done before, too.
void AlongDialog::follow()
{
    const QScopedValueRollback applying(m_applying, true);
    m_gesture.rest();
    m_curve->dropDrag();
    m_beforeDrag.reset();
    goOnFromStep();
    const Document &document = m_editor.document();
    StrokeRuns selected = runsOf(document);
    if (const AlongState *known = m_states.find(*document.painting(), selected))
        m_state = *known;
    else
        m_state = {std::make_shared<const StrokeRuns>(std::move(selected)), {}, {}};
    showSubject();
    choose(m_quantity);
}

/// Says which strokes it is about, or that there are none.
void AlongDialog::showSubject()
{
    const StrokeRuns &runs = *m_state.runs;
    const QString name =
        runs.size() == 1 ? nameOfStroke(*runs.begin()->second.stroke) : tr("%n stroke(s)", nullptr, int(runs.size()));
    setWindowTitle(runs.empty() ? tr("Along the Stroke") : tr("Along the Stroke – %1").arg(name));
    m_body->setEnabled(!runs.empty());
    m_hint->showHint(runs.empty() ? tr("Nothing is selected that can be changed. Click a stroke, and its values "
                                       "are shown here.")
                                  : QString());
}

} // namespace suffuse
