#include "app/dialogs/vary_dialog.h"

#include "app/session/commands/restyling.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/habits/mnemonics.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/numbers/quantity.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QRandomGenerator>

#include <algorithm>
#include <numbers>

namespace suffuse {

VaryDialog::VaryDialog(Editor &editor, QWidget *parent)
    : QDialog(parent), m_editor(editor), m_before(editor.document().painting()), m_selection(editor.selection()),
      m_amounts(commands::storedVariation())
{
    setWindowTitle(tr("Vary at Random"));
    setHelpPage(*this, "refining");
    m_amounts.seed = QRandomGenerator::global()->generate();
    m_form = new QFormLayout(this);
    addField(&VaryAmounts::diffusion, specOf(Quantity::Diffusion).name,
             tr("D becomes greater by up to this, or smaller by the same factor"), shareDisplay(), 100);
    addField(&VaryAmounts::density, specOf(Quantity::Density).name,
             tr("φ becomes greater by up to this, or smaller by the same factor"), shareDisplay(), 100);
    addField(&VaryAmounts::maxAge, specOf(Quantity::MaxAge).name,
             tr("t_max becomes greater by up to this, or smaller by the same factor"), shareDisplay(), 100);
    addField(&VaryAmounts::granulation, specOf(Quantity::Granulation).name, tr("So much more grain, or less"),
             shareDisplay(), 1);
    addField(&VaryAmounts::hue, tr("Hue"), tr("Colours turn by up to this angle, either way"), angleDisplay(),
             std::numbers::pi);
    addField(&VaryAmounts::lightness, tr("Lightness"), tr("Colours get lighter or darker by up to this"),
             shareDisplay(), 1);
    addField(&VaryAmounts::opacity, specOf(Quantity::Opacity).name, tr("So much more opaque, or less"), shareDisplay(),
             1);
    addChoices();
    m_hint = new HintLabel(this);
    m_hint->setMargin(0);
    m_form->addRow(m_hint);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_roll = buttons->addButton(tr("Roll Again"), QDialogButtonBox::ActionRole);
    m_roll->setToolTip(tr("Other random values by the same amounts"));
    m_roll->setAutoDefault(false);
    m_form->addRow(buttons);
    connect(m_roll, &QPushButton::clicked, this, &VaryDialog::roll);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    EntryField::letReturnShowFirst(*this);
    giveMnemonics(*this);
    apply();
}

VaryDialog::~VaryDialog()
{
    m_gesture.giveUp();
}

void VaryDialog::addField(double VaryAmounts::*amount, const QString &name, const QString &tip, const Display &display,
                          double most)
{
    auto *field = new NumberField(this);
    field->setRange(amount == &VaryAmounts::length ? 1e-3 : 0, most);
    field->setDisplay(display);
    if (display.factor != 1)
        field->setStep(display.toValue(1)); // one of what is shown: a per cent, a degree
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
    connect(field, &NumberField::refused, this, [this](const QString &hint) { m_hint->showRefusal(hint); });
    m_fields.emplace_back(amount, field);
}

void VaryDialog::addChoices()
{
    m_per = new QComboBox(this);
    m_per->addItems({tr("Each stroke"), tr("Each segment"), tr("Along each stroke")});
    m_per->setToolTip(tr("What gets a random value of its own; along a stroke values drift smoothly"));
    m_per->setAccessibleName(tr("Of its own"));
    m_per->setCurrentIndex(int(m_amounts.per));
    auto *label = new QLabel(tr("Of its own"), this);
    label->setBuddy(m_per);
    m_form->addRow(label, m_per);
    addField(&VaryAmounts::length, tr("Length"), tr("Over this length along a stroke values become others"),
             lengthDisplay(), 1e6);
    const auto showLength = [this] { field(&VaryAmounts::length)->setEnabled(m_amounts.per == VaryAmounts::Along); };
    showLength();
    connect(m_per, &QComboBox::currentIndexChanged, this, [this, showLength](int index) {
        m_amounts.per = VaryAmounts::Per(index);
        showLength();
        apply();
    });
}

NumberField *VaryDialog::field(double VaryAmounts::*amount) const
{
    return std::ranges::find(m_fields, amount, &std::pair<double VaryAmounts::*, NumberField *>::first)->second;
}

void VaryDialog::roll()
{
    ++m_amounts.seed;
    apply();
}

void VaryDialog::apply()
{
    if (!m_gesture.isOpen())
        m_gesture = m_editor.begin(tr("Vary"));
    m_gesture.show(varySelection(m_editor.document(), *m_before, m_selection, m_amounts));
    m_gesture.rest();
}

void VaryDialog::accept()
{
    commands::storeVariation(m_amounts);
    m_gesture.commit();
    QDialog::accept();
}

void VaryDialog::reject()
{
    // If something was saved meanwhile, a part of the changes is a step already, so the old values are set anew.
    m_gesture.show(varySelection(m_editor.document(), *m_before, m_selection, {}));
    m_gesture.commit();
    QDialog::reject();
}

} // namespace suffuse
