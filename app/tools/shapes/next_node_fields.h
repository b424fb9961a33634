#pragma once

#include "app/tools/shapes/next_node.h"

#include <QObject>

class QHBoxLayout;
class QToolButton;

namespace suffuse {

class NumberField;

/// The fields of the row over the canvas in which the next node of an outline is seen and typed. A number that was
/// typed stays until the node is set, or until it is deleted from its field. Return sets the node there and lets the
/// next one be typed; where nothing is typed it ends the outline. With Shift it closes it.
class NextNodeFields : public QObject {
    Q_OBJECT

public:
    /// Adds the fields to the row, whose widget owns this object.
    explicit NextNodeFields(QHBoxLayout &row);

    const NextNode &typed() const { return m_node; }
    /// Takes a text that is still being typed.
    void takeEdited();
    /// Forgets what was typed; the node is set, or there is none to come.
    void clear();
    /// Shows the node before, if there is one, and where the next one would be. Without the first, `next` counts only
    /// as far as it is typed.
    void show(std::optional<Point> from, Point next, bool canClose);

signals:
    /// Other numbers are typed than before.
    void changed();
    /// The node is to be set where it is typed.
    void placed();
    /// Return, with nothing typed: the outline is to end open, and the canvas gets the keyboard.
    void ended();
    void closed();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    using Number = NextNode::Number;

    NumberField *field(Number number) const { return m_fields[std::size_t(number)]; }
    std::optional<Number> numberOf(const QObject *field) const;
    void take(Number number, double value);
    void forgetTyped(Number number);
    void pressReturn(Number number);
    void select(Number number);

    NextNode m_node;
    std::array<NumberField *, NextNode::numbers.size()> m_fields{};
    QToolButton *m_close;
    std::optional<Number> m_edited; ///< the field whose text has been typed and not taken yet
    bool m_isRefused = false;       ///< what was typed last was no number, or out of range
    bool m_isFirst = true;          ///< there is no node before
};

} // namespace suffuse
