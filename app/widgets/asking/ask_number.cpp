#include "app/widgets/asking/ask_number.h"

#include "app/widgets/habits/mnemonics.h"
#include "app/widgets/numbers/decimal_box.h"
#include "app/widgets/numbers/length_units.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace suffuse {

std::optional<double> askNumber(QWidget *parent, const NumberQuestion &question)
{
    QDialog dialog(parent);
    dialog.setWindowTitle(question.title);
    auto *label = new QLabel(question.label, &dialog);
    auto *box = new DecimalBox(&dialog);
    box->setDecimals(question.decimals);
    if (question.isLength)
        box->setDisplay(lengthDisplay(parent));
    box->setRange(question.minimum, question.maximum);
    box->setValue(question.value);
    box->setKeyboardTracking(false);
    box->selectAll();
    label->setBuddy(box);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    auto *column = new QVBoxLayout(&dialog);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(16);
    auto *line = new QHBoxLayout;
    line->setSpacing(16);
    line->addWidget(label);
    line->addWidget(box, 1);
    column->addLayout(line);
    column->addWidget(buttons);
    giveMnemonics(dialog);
    if (dialog.exec() != QDialog::Accepted)
        return {};
    box->interpretText();
    return box->value();
}

} // namespace suffuse
