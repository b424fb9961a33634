#include "app/panels/history/stroke_history_list.h"

#include "app/session/editor.h"

#include <QSignalBlocker>
#include <QTimerEvent>

namespace suffuse {

StrokeHistoryList::StrokeHistoryList(Editor &editor, QWidget *parent) : QListWidget(parent), m_editor(editor)
{
    setUniformItemSizes(true);
    setSpacing(2);
    setFrameShape(QFrame::NoFrame);
    setAccessibleName(tr("History of the selected stroke"));
    setToolTip(tr("What was done to the selected stroke. Click a state to put this stroke back to it; everything else "
                  "stays as it is."));
    connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem *item) { goTo(row(item)); });
    connect(this, &QListWidget::itemActivated, this, [this](QListWidgetItem *item) { goTo(row(item)); });
    connect(&editor.undoStack(), &QUndoStack::indexChanged, this, &StrokeHistoryList::followLater);
    connect(&editor.laterChanges(), &LaterChanges::changed, this, [this](const Change &change) {
        if (change.selection || change.reset)
            followLater();
    });
    followLater();
}

void StrokeHistoryList::showEvent(QShowEvent *event)
{
    QListWidget::showEvent(event);
    follow();
}

void StrokeHistoryList::resizeEvent(QResizeEvent *event)
{
    QListWidget::resizeEvent(event);
    scrollTo(currentIndex());
}

void StrokeHistoryList::timerEvent(QTimerEvent *event)
{
    if (event->timerId() != m_later.timerId()) {
        QListWidget::timerEvent(event);
        return;
    }
    m_later.stop();
    follow();
}

void StrokeHistoryList::followLater()
{
    // The list is filled once for all that happens before the event loop comes round, since a drag merges into one step
    // many times.
    if (!m_later.isActive())
        m_later.start(0, this);
}

void StrokeHistoryList::follow()
{
    const std::set<StrokeId> &selected = m_editor.selection().strokes;
    const StrokeId stroke = selected.size() == 1 ? *selected.begin() : 0;
    if (stroke != m_stroke) {
        m_stroke = stroke;
        emit strokeChanged();
    }
    if (!isVisible())
        return;
    m_states = statesOf(m_editor.undoStack(), m_editor.unsettled(), stroke);
    const QSignalBlocker blocker(this);
    while (count() > int(m_states.size()))
        delete takeItem(count() - 1);
    while (count() < int(m_states.size()))
        addItem(QString());
    for (int i = 0; i < count(); ++i)
        item(i)->setText(m_states[std::size_t(i)].text.isEmpty() ? tr("As it was at first")
                                                                 : m_states[std::size_t(i)].text);
    setCurrentRow(count() - 1);
    if (count() > 0)
        scrollToItem(item(count() - 1));
}

void StrokeHistoryList::goTo(int row)
{
    if (row < 0 || row >= int(m_states.size()))
        return;
    const StrokeState state = m_states[std::size_t(row)];
    m_editor.push(putBack(m_editor.document(), *state.stroke), tr("Put stroke back"));
    follow();
}

} // namespace suffuse
