#pragma once

#include <QWidget>

class QUndoView;

namespace suffuse {

class Editor;
class StrokeHistoryList;

/// The undo stack as a list: a click goes to that moment; the saved state is marked. Below it, while one stroke is
/// selected, the states of that stroke alone.
class HistoryPanel : public QWidget {
    Q_OBJECT

public:
    explicit HistoryPanel(Editor &editor, QWidget *parent = nullptr);

    QUndoView *view() const { return m_view; }
    StrokeHistoryList *strokeView() const { return m_strokeView; }
    QSize sizeHint() const override;

private:
    QUndoView *m_view = nullptr;
    StrokeHistoryList *m_strokeView = nullptr;
};

} // namespace suffuse
