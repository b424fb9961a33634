#pragma once

#include <QWidget>

class QUndoView;

namespace suffuse {

class Editor;

/// The undo stack as a list: a click goes to that moment; the saved state is marked.
class HistoryPanel : public QWidget {
    Q_OBJECT

public:
    explicit HistoryPanel(Editor &editor, QWidget *parent = nullptr);

    QUndoView *view() const { return m_view; }
    QSize sizeHint() const override;

private:
    QUndoView *m_view = nullptr;
};

} // namespace suffuse
