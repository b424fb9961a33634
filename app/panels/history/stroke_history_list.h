#pragma once

#include "model/painting/ids.h"
#include "undo/history/stroke_history.h"

#include <QBasicTimer>
#include <QListWidget>

namespace suffuse {

class Editor;

/// Lists the states that the one selected stroke has had. A click puts the stroke back to one of them as a new step.
/// What was done to the rest of the painting since then stays.
class StrokeHistoryList : public QListWidget {
    Q_OBJECT

public:
    explicit StrokeHistoryList(Editor &editor, QWidget *parent = nullptr);

    /// Whether exactly one stroke is selected.
    bool hasStroke() const { return m_stroke != 0; }

signals:
    /// Emitted when another stroke, or none, is listed.
    void strokeChanged();

protected:
    void showEvent(QShowEvent *event) override;
    /// Keeps the present state in sight when the list gets lower.
    void resizeEvent(QResizeEvent *event) override;
    void timerEvent(QTimerEvent *event) override;

private:
    void followLater();
    void follow();
    void goTo(int row);

    Editor &m_editor;
    StrokeId m_stroke = 0;
    std::vector<StrokeState> m_states;
    QBasicTimer m_later;
};

} // namespace suffuse
