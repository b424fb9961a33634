#include "app/panels/history/history_panel.h"

#include "app/panels/history/stroke_history_list.h"
#include "app/session/editor.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/section.h"

#include <QSplitter>
#include <QStyledItemDelegate>
#include <QUndoView>
#include <QVBoxLayout>

namespace suffuse {

namespace {

/// Shows steps that are undone in grey. These stand below the present step.
class StepDelegate : public QStyledItemDelegate {
public:
    StepDelegate(const QUndoStack &stack, QObject *parent) : QStyledItemDelegate(parent), m_stack(stack) {}

    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        if (index.row() > m_stack.index()) // The first row is the start, which is no step.
            option->palette.setColor(QPalette::Text, option->palette.color(QPalette::Disabled, QPalette::Text));
    }

private:
    const QUndoStack &m_stack;
};

/// Keeps the present step in sight when the list gets lower.
class StepList : public QUndoView {
public:
    using QUndoView::QUndoView;

protected:
    void resizeEvent(QResizeEvent *event) override
    {
        QUndoView::resizeEvent(event);
        scrollTo(currentIndex());
    }
};

} // namespace

HistoryPanel::HistoryPanel(Editor &editor, QWidget *parent) : QWidget(parent)
{
    m_view = new StepList(&editor.undoStack(), this);
    m_view->setItemDelegate(new StepDelegate(editor.undoStack(), this));
    m_view->setEmptyLabel(tr("Start"));
    m_view->setCleanIcon(icon("save"));
    m_view->setIconSize({14, 14});
    m_view->setSpacing(2);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setAccessibleName(tr("History"));
    m_view->setToolTip(tr("Every change since the painting was opened. Click one to go back or forward to it."));

    auto *below = new QWidget(this);
    auto *belowColumn = new QVBoxLayout(below);
    belowColumn->setContentsMargins(0, 6, 0, 0);
    belowColumn->setSpacing(4);
    QLabel *title = sectionTitle(tr("This stroke"), below);
    title->setContentsMargins(8, 0, 8, 0);
    belowColumn->addWidget(title);
    m_strokeView = new StrokeHistoryList(editor, below);
    belowColumn->addWidget(m_strokeView, 1);
    const auto follow = [this, below] { below->setVisible(m_strokeView->hasStroke()); };
    connect(m_strokeView, &StrokeHistoryList::strokeChanged, below, follow);
    follow();

    auto *splitter = new QSplitter(Qt::Vertical, this);
    splitter->addWidget(m_view);
    splitter->addWidget(below);
    splitter->setChildrenCollapsible(false);
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 2);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(splitter);
}

QSize HistoryPanel::sizeHint() const
{
    return {280, 200};
}

} // namespace suffuse
