#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;

namespace suffuse {

class Editor;

/// The line above the colour: whose colour it is, with the choice between the brush and what is selected. Where several
/// colours are selected, also whether all become the same or shift; where the brush is meant, a button gives its colour
/// to what is selected.
class ColourHeader : public QWidget {
    Q_OBJECT

public:
    explicit ColourHeader(Editor &editor, QWidget *parent = nullptr);

    /// What it says.
    const QString &text() const { return m_text; }
    QToolButton *brushButton() const { return m_brush; }
    QToolButton *selectionButton() const { return m_selection; }
    QComboBox *modeChoice() const { return m_mode; }
    QToolButton *applyButton() const { return m_apply; }

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    QToolButton *addChoice(const char *icon, const QString &name, const QString &tip);
    void refresh();
    void showText();
    void applyToSelection();

    Editor &m_editor;
    QString m_text;
    QToolButton *m_brush = nullptr;
    QToolButton *m_selection = nullptr;
    QLabel *m_title = nullptr;
    QComboBox *m_mode = nullptr;
    QToolButton *m_apply = nullptr;
};

} // namespace suffuse
