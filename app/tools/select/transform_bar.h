#pragma once

#include "app/session/value_entry.h"
#include "model/shaping/transform.h"

#include <QWidget>

#include <optional>

class QHBoxLayout;
class QToolButton;

namespace suffuse {

class Commands;
class Editor;
class NumberField;

/// The Select tool's row over the canvas: place and size of the selection as numbers, an angle to turn it by, and the
/// commands that belong to it.
class TransformBar : public QWidget {
    Q_OBJECT

public:
    TransformBar(Editor &editor, Commands &commands, QWidget *parent = nullptr);

    /// Shows the angle by which a drag turns the selection, in radians; no value where nothing is being turned.
    void showTurn(std::optional<double> angle);

    /// What is said where strokes cannot become what they are to.
    static QString refusal();

protected:
    void showEvent(QShowEvent *event) override;

private:
    /// What a number means: a side of the box, its size, or an angle to turn by.
    enum class Number { X, Y, Width, Height, Angle };

    NumberField *addField(QHBoxLayout &row, Number number, const QString &label, const QString &tip);
    void showHint(Number number, const QString &hint);
    void addNumbers(QHBoxLayout &row);
    void addButtons(QHBoxLayout &row, Commands &commands);
    void follow();
    void refresh();
    void enter(Number number, double value, ValueEntry *entry = nullptr);
    void step(Number number, double value);
    Affine mapFor(Number number, double value) const;

    Editor &m_editor;
    Commands &m_commands;
    std::array<NumberField *, 5> m_fields{}; ///< by the value of `Number`
    QToolButton *m_proportions = nullptr;
    Rect m_box;
    bool m_stale = true;
    double m_turn = 0;            ///< degrees; 0 where no strokes are being turned
    Number m_stepped = Number::X; ///< The field that was stepped last: steps of one field become one undo step.
    ValueEntry m_steps;
};

} // namespace suffuse
