// A label with a list of choices, as a row of a section.
#pragma once

#include <QStringList>

class QComboBox;
class QGridLayout;
class QLabel;
class QWidget;

namespace suffuse {

struct ComboRow {
    QLabel *label = nullptr;
    QComboBox *box = nullptr;

    /// Adds a row to a grid of fields, in its columns of values. Without a choice the box says "—".
    static ComboRow add(QGridLayout &grid, int row, const QString &name, const QString &toolTip,
                        const QStringList &items, QWidget *parent);
    void setVisible(bool visible) const;
};

} // namespace suffuse
