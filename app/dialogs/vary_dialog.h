#pragma once

#include "app/session/editor.h"
#include "model/restyling/vary.h"

#include <QDialog>

#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace suffuse {

class HintLabel;
class NumberField;
struct Display;

/// Lets values and colours of what is selected stray at random, by numbers. All of it shows at once and is one undo
/// step; Cancel takes it back.
class VaryDialog : public QDialog {
    Q_OBJECT

public:
    VaryDialog(Editor &editor, QWidget *parent);
    ~VaryDialog() override;

    /// The field of an amount.
    NumberField *field(double VaryAmounts::*amount) const;
    QComboBox *per() const { return m_per; }
    /// Rolls other random values by the same amounts.
    QPushButton *rollButton() const { return m_roll; }
    const VaryAmounts &amounts() const { return m_amounts; }

    void accept() override;
    void reject() override;

private:
    void addField(double VaryAmounts::*amount, const QString &name, const QString &tip, const Display &display,
                  double most);
    void addChoices();
    void roll();
    void apply();

    Editor &m_editor;
    PaintingPtr m_before;
    Selection m_selection; ///< the selection in m_before
    VaryAmounts m_amounts;
    Gesture m_gesture;
    std::vector<std::pair<double VaryAmounts::*, NumberField *>> m_fields;
    QFormLayout *m_form = nullptr;
    QComboBox *m_per = nullptr;
    QPushButton *m_roll = nullptr;
    HintLabel *m_hint = nullptr;
};

} // namespace suffuse
