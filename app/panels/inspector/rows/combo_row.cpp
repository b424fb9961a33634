#include "app/panels/inspector/rows/combo_row.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>

namespace suffuse {

ComboRow ComboRow::add(QGridLayout &grid, int row, const QString &name, const QString &toolTip,
                       const QStringList &items, QWidget *parent)
{
    ComboRow made{new QLabel(name, parent), new QComboBox(parent)};
    made.box->addItems(items);
    made.box->setPlaceholderText(QStringLiteral("—"));
    made.box->setAccessibleName(name);
    made.box->setToolTip(toolTip);
    made.box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    made.box->setMinimumContentsLength(8);
    made.label->setBuddy(made.box);
    grid.addWidget(made.label, row, 0);
    grid.addWidget(made.box, row, 1, 1, 2);
    return made;
}

void ComboRow::setVisible(bool visible) const
{
    label->setVisible(visible);
    box->setVisible(visible);
}

} // namespace suffuse
