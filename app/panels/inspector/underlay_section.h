#pragma once

#include "app/widgets/numbers/slider_field.h"
#include "model/painting/painting.h"

#include <array>

class QHBoxLayout;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace suffuse {

class Editor;

/// Shows the picture to paint over: whether and how strongly it is seen, and where it lies. If there is none, it offers
/// to load one.
class UnderlaySection : public QWidget {
    Q_OBJECT

public:
    explicit UnderlaySection(Editor &editor, QWidget *parent = nullptr);

    void refresh();

    enum class Number { X, Y, Width, Height };
    NumberField *field(Number number) const { return m_fields[std::size_t(number)]; }
    SliderField *opacity() const { return m_opacity; }
    QToolButton *visibility() const { return m_visible; }
    QToolButton *proportions() const { return m_proportions; }
    QPushButton *addButton() const { return m_add; }
    QPushButton *fitButton() const { return m_fit; }
    QPushButton *replaceButton() const { return m_replace; }
    QToolButton *removeButton() const { return m_remove; }

signals:
    /// Emitted when a text that was typed is no value; says why.
    void refused(const QString &hint);

private:
    void addHead(QVBoxLayout &column);
    QToolButton *makeTool(const QString &text);
    void addFields(QVBoxLayout &column);
    void addButtons(QVBoxLayout &column);
    NumberField *addNumber(Number number, const QString &name, const QString &toolTip);
    QPushButton *addButton(QHBoxLayout &row, const QString &text, const QString &toolTip);
    void enter(Number number, double value, ValueEntry *entry = nullptr);
    void step(Number number, double value);
    void choose();

    Editor &m_editor;
    QWidget *m_values = nullptr; ///< the fields that are shown only with an underlay
    QToolButton *m_visible = nullptr;
    SliderField *m_opacity = nullptr;
    std::array<NumberField *, 4> m_fields = {};
    QToolButton *m_proportions = nullptr;
    QPushButton *m_add = nullptr;
    QPushButton *m_fit = nullptr;
    QPushButton *m_replace = nullptr;
    QToolButton *m_remove = nullptr;
    ValueEntry m_steps; ///< steps of one field that follow each other
    Number m_stepped = Number::X;
};

} // namespace suffuse
