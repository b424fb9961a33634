#pragma once

#include "app/panels/inspector/inspected.h"
#include "app/widgets/numbers/slider_field.h"

#include <functional>

class QCheckBox;
class QComboBox;
class QLabel;

namespace suffuse {

class ColourRows;
class Editor;
class GradientRows;

/// Shows and changes the fills of the selected strokes: whether they have one, and its values.
class FillSection : public QWidget {
    Q_OBJECT

public:
    explicit FillSection(Editor &editor, QWidget *parent = nullptr);

    void refresh(const Inspected &inspected);

    /// Leaves the switch and the rule out, for a card that shows what a fill has.
    void showFew();

    QCheckBox *filled() const { return m_filled; }
    SliderField *row(float Fill::*member) const;
    ColourRows *colour() const { return m_colour; }
    GradientRows *gradient() const { return m_gradient; }
    QComboBox *rule() const { return m_rule; }

signals:
    /// Emitted when a text that was typed is no value; says why.
    void refused(const QString &hint);

private:
    using Member = std::function<float &(Fill &)>;

    void addRow(const FieldSpec &spec, QGridLayout &grid, float Fill::*member);
    void set(const Member &member, double value, ValueEntry *entry);
    void changeEach(const Member &member, const ValueMap &map);
    void changeTogether(const Member &member, const ValueChange &change, ValueEntry *entry);
    void fillSelected(bool on);
    static void keepChange(SliderField &row, const Inspected &inspected,
                           const std::function<double(const Fill &)> &valueOf);

    Editor &m_editor;
    QCheckBox *m_filled = nullptr;
    QWidget *m_values = nullptr; ///< all but the switch
    std::vector<std::pair<float Fill::*, SliderField *>> m_rows;
    ColourRows *m_colour = nullptr;
    GradientRows *m_gradient = nullptr;
    QComboBox *m_rule = nullptr;
    QLabel *m_ruleLabel = nullptr;
};

} // namespace suffuse
