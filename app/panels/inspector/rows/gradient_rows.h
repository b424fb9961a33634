#pragma once

#include "app/panels/inspector/inspected.h"
#include "app/widgets/numbers/slider_field.h"

class QToolButton;

namespace suffuse {

class ColourRows;
class Editor;

/// The gradients of the selected strokes' fills: added, removed, turned around, and their second colour.
class GradientRows : public QWidget {
    Q_OBJECT

public:
    explicit GradientRows(Editor &editor, QWidget *parent = nullptr);

    void refresh(const Inspected &inspected);

    QToolButton *addButton() const { return m_add; }
    QToolButton *removeButton() const { return m_remove; }
    QToolButton *swapButton() const { return m_swap; }
    ColourRows *colour() const { return m_colour; }

signals:
    /// Emitted when a text that was typed is no value; says why.
    void refused(const QString &hint);

private:
    void set(int channel, double value, ValueEntry *entry);
    void changeEach(int channel, const ValueMap &map);
    void changeTogether(int channel, const ValueChange &change, ValueEntry *entry);

    Editor &m_editor;
    QToolButton *m_add = nullptr;
    QToolButton *m_remove = nullptr;
    QToolButton *m_swap = nullptr;
    ColourRows *m_colour = nullptr;
};

} // namespace suffuse
