// The row over the canvas in which a text's values are shown and changed.
#pragma once

#include "model/painting/text.h"

#include <QWidget>

#include <functional>

class QAbstractButton;
class QCheckBox;
class QComboBox;

namespace suffuse {

class FontBox;
class NumberField;

/// Shows the values of a text, and tells which is changed.
class TextRow : public QWidget {
    Q_OBJECT

public:
    using Change = std::function<void(Text &)>;

    explicit TextRow(QWidget *parent = nullptr);

    /// Shows the values; `hasFamily`: its font is installed. `canBend`: there is a stroke to set it along.
    void show(const Text &text, bool hasFamily, bool canBend);

signals:
    void changed(const suffuse::TextRow::Change &change);
    void bendWanted();       ///< onto the selected stroke
    void straightenWanted(); ///< off its curve
    void done();             ///< something was chosen, and typing may go on

private:
    void emitChange(Change change);

    FontBox *m_family;
    QComboBox *m_weight;
    QCheckBox *m_italic;
    NumberField *m_size;
    NumberField *m_spacing;
    NumberField *m_lines;
    QComboBox *m_alignment;
    QCheckBox *m_vertical;
    QAbstractButton *m_bend;
    QAbstractButton *m_straighten;
};

} // namespace suffuse
