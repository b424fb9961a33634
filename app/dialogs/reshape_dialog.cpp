#include "app/dialogs/reshape_dialog.h"

#include "app/widgets/habits/help_page.h"
#include "app/widgets/habits/mnemonics.h"
#include "app/widgets/numbers/number_field.h"
#include "model/painting/editable.h"
#include "undo/run_edits.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>

namespace suffuse {

namespace {

constexpr int settledMs = 60;

/// The strokes of a painting that a selection means and that can be changed.
std::vector<StrokePtr> changeable(const Painting &painting, const Selection &selection)
{
    std::vector<StrokePtr> strokes;
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (selection.strokes.contains(stroke->id) && isEditable(*stroke))
            strokes.push_back(stroke);
    return strokes;
}

std::size_t segmentsOf(const std::vector<StrokePtr> &strokes)
{
    std::size_t count = 0;
    for (const StrokePtr &stroke : strokes)
        count += stroke->segments.size();
    return count;
}

} // namespace

ReshapeDialog::ReshapeDialog(Editor &editor, Reshaping what, QWidget *parent)
    : QDialog(parent), m_editor(editor), m_before(editor.document().painting()), m_selection(editor.selection()),
      m_amounts(ReshapeAmounts::stored()), m_difference(changeable(*m_before, m_selection)),
      m_countBefore(segmentsOf(changeable(*m_before, m_selection)))
{
    setWindowTitle(tr("Reshape"));
    setHelpPage(*this, "refining");
    m_form = new QFormLayout(this);
    m_choice = new QComboBox(this);
    m_choice->addItems({tr("Simplify"), tr("Smooth"), tr("Straighten"), tr("Grow or shrink"), tr("Offset")});
    m_form->addRow(tr("Change"), m_choice);
    addField(Reshaping::Simplify, &ReshapeAmounts::distance, tr("Distance"), tr("How far curves may move"),
             lengthDisplay(), 0, 1e6);
    addField(Reshaping::Simplify, &ReshapeAmounts::values, tr("Values"),
             tr("How far spreads, densities, colours and times may differ that become one"), shareDisplay(), 0, 10);
    addField(Reshaping::Smooth, &ReshapeAmounts::smoothing, tr("Length"),
             tr("Wiggles of this length and shorter ones go"), lengthDisplay(), 1e-6, 1e6);
    addField(Reshaping::Straighten, &ReshapeAmounts::straight, tr("Amount"),
             tr("0 %: as it is; 100 %: a straight line"), shareDisplay(), 0, 1);
    addField(Reshaping::Width, &ReshapeAmounts::width, tr("Width"), tr("Of the paint; below 100 % it shrinks"),
             shareDisplay(), 0.01, 100);
    addField(Reshaping::Offset, &ReshapeAmounts::aside, tr("Distance"),
             tr("To the right of the stroke's direction; below 0 to the left"), lengthDisplay(), -1e6, 1e6);
    m_report = new QLabel(this);
    m_report->setTextInteractionFlags(Qt::TextSelectableByMouse);
    const QString counts = tr("%1 → %2 segments").arg("88,888", "88,888");
    const QString longest = tr("%1, picture differs by %2").arg(counts, "88.88 %");
    m_report->setMinimumWidth(m_report->fontMetrics().horizontalAdvance(longest));
    m_form->addRow(m_report);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_choice, &QComboBox::currentIndexChanged, this, [this] { showFields(); });
    m_settled.setSingleShot(true);
    m_settled.setInterval(settledMs);
    connect(&m_settled, &QTimer::timeout, this, [this] { showReport(); });
    EntryField::letReturnShowFirst(*this);
    giveMnemonics(*this);
    choose(what);
    showFields();
}

ReshapeDialog::~ReshapeDialog()
{
    m_gesture.giveUp();
}

void ReshapeDialog::addField(Reshaping of, double ReshapeAmounts::*amount, const QString &name, const QString &tip,
                             const Display &display, double least, double most)
{
    auto *field = new NumberField(this);
    field->setRange(least, most);
    field->setDisplay(display);
    field->setValue(m_amounts.*amount);
    field->setToolTip(tip);
    field->setAccessibleName(name);
    auto *label = new QLabel(name, this);
    label->setToolTip(tip);
    label->setBuddy(field);
    m_form->addRow(label, field);
    const auto take = [this, amount](double value) {
        m_amounts.*amount = value;
        apply();
    };
    connect(field, &NumberField::entered, this, take);
    connect(field, &NumberField::stepped, this, take);
    connect(field, &NumberField::refused, this, [this](const QString &hint) {
        if (!hint.isEmpty())
            m_report->setText(hint);
    });
    m_rows.push_back({of, label, field});
}

void ReshapeDialog::choose(Reshaping what)
{
    m_choice->setCurrentIndex(int(what));
}

Reshaping ReshapeDialog::chosen() const
{
    return Reshaping(m_choice->currentIndex());
}

std::vector<NumberField *> ReshapeDialog::fields() const
{
    std::vector<NumberField *> result;
    for (const Row &row : m_rows)
        if (row.of == chosen())
            result.push_back(row.field);
    return result;
}

QString ReshapeDialog::report() const
{
    return m_report->text();
}

void ReshapeDialog::showFields()
{
    for (const Row &row : m_rows) {
        row.label->setVisible(row.of == chosen());
        row.field->setVisible(row.of == chosen());
    }
    adjustSize();
    m_gesture.giveUp(); // the step is called by what is chosen
    apply();
}

void ReshapeDialog::apply()
{
    if (!m_gesture.isOpen())
        m_gesture = m_editor.begin(nameOf(chosen()));
    m_gesture.show(reshapeEdit(m_editor.document(), *m_before, m_selection, chosen(), m_amounts));
    m_gesture.rest();
    m_settled.start();
}

std::vector<StrokePtr> ReshapeDialog::strokesNow()
{
    return changeable(*m_editor.document().painting(), m_editor.selection());
}

void ReshapeDialog::showReport()
{
    const std::vector<StrokePtr> now = strokesNow();
    const QLocale locale;
    //: %1, %2: numbers of segments before and after
    QString text = tr("%1 → %2 segments")
                       .arg(locale.toString(qulonglong(m_countBefore)), locale.toString(qulonglong(segmentsOf(now))));
    if (const std::optional<double> mean = m_difference.meanTo(now))
        //: %1: "12 → 3 segments"; %2: "0.4 %", the mean difference of the pictures
        text = tr("%1, picture differs by %2").arg(text, shareDisplay().text(*mean));
    m_report->setText(text);
}

void ReshapeDialog::accept()
{
    m_amounts.store();
    m_gesture.commit();
    QDialog::accept();
}

void ReshapeDialog::reject()
{
    // A part of it may be a step already, where the painting was saved meanwhile.
    const auto asItWas = [](const Stroke &stroke, const std::vector<bool> &, std::vector<int> *) { return stroke; };
    m_gesture.show(reshapeSelection(m_editor.document(), *m_before, m_selection, asItWas));
    m_gesture.commit();
    QDialog::reject();
}

} // namespace suffuse
