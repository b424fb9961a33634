#include "app/panels/history_panel.h"

#include "app/editor.h"
#include "app/icons.h"

#include <QUndoView>
#include <QVBoxLayout>

namespace suffuse {

HistoryPanel::HistoryPanel(Editor &editor, QWidget *parent) : QWidget(parent)
{
    m_view = new QUndoView(&editor.undoStack(), this);
    m_view->setEmptyLabel(tr("Start"));
    m_view->setCleanIcon(icon("save"));
    m_view->setIconSize({14, 14});
    m_view->setSpacing(2);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setAccessibleName(tr("History"));
    m_view->setToolTip(tr("Every change since the painting was opened. Click one to go back or forward to it."));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_view);
}

QSize HistoryPanel::sizeHint() const
{
    return {280, 200};
}

} // namespace suffuse
