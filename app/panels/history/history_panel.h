#pragma once

#include <QWidget>

class QUndoView;

namespace suffuse {

class Editor;
class StrokeHistoryList;

/// Shows the undo stack as a list. A click goes to a step, and the saved one is marked. While one stroke is selected,
/// the states of that stroke alone are listed below.
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
