#pragma once

#include <QElapsedTimer>
#include <QToolButton>

namespace suffuse {

class Editor;

/// Shows the picture as it was before the last run of changes to the selection: while the button is held, or until it
/// is clicked again or the painting changes. It touches no undo step.
class CompareButton : public QToolButton {
    Q_OBJECT

public:
    explicit CompareButton(Editor &editor, QWidget *parent = nullptr);

private:
    void refresh();

    Editor &m_editor;
    QElapsedTimer m_held;
    bool m_wasOn = false;
};

} // namespace suffuse
