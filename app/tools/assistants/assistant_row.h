#pragma once

#include "model/geometry/assistant.h"

#include <QWidget>

#include <array>

class QComboBox;
class QHBoxLayout;

namespace suffuse {

class Commands;
class NumberField;

/// The name of a kind, as the row has it.
QString nameOf(AssistantKind kind);

/// The row over the canvas for assistants: the kind of the next one, the numbers of the one that is chosen, and the
/// commands that belong to them.
class AssistantRow : public QWidget {
    Q_OBJECT

public:
    /// What a number of it means: place of the point, angle, and half axes of an ellipse.
    enum class Number { X, Y, Angle, First, Second };

    explicit AssistantRow(Commands &commands, QWidget *parent = nullptr);

    void showKind(AssistantKind kind);
    /// Shows the numbers of an assistant and of a point of it; null: none is chosen.
    void show(const Assistant *chosen, std::size_t point);

signals:
    void kindChosen(suffuse::AssistantKind kind);
    void newAsked();
    void entered(suffuse::AssistantRow::Number number, double value);

private:
    void addField(QHBoxLayout &row, Number number, const QString &label, const QString &tip);
    void addButtons(QHBoxLayout &row, Commands &commands);
    NumberField &field(Number number) const { return *m_fields[std::size_t(number)]; }

    QComboBox *m_kinds = nullptr;
    std::array<NumberField *, 5> m_fields{}; ///< by the value of `Number`
    std::array<QWidget *, 5> m_pairs{};      ///< each with its label
};

} // namespace suffuse
