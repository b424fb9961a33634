#include "app/tools/tool_options.h"

#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QWheelEvent>

namespace suffuse {

namespace {

constexpr int leastHeight = 30; ///< the height of a row of fields, logical pixels
constexpr int leastWidth = 200; ///< of what is seen of it

/// Scrolls a row sideways where the window is narrower than it.
class RowScroll : public QScrollArea {
public:
    explicit RowScroll(QWidget *row)
    {
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus);
        setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setWidgetResizable(true);
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        setWidget(row);
        viewport()->setAutoFillBackground(false);
        row->setAutoFillBackground(false);
    }

    QSize sizeHint() const override { return {widget()->sizeHint().width(), height(*widget())}; }
    QSize minimumSizeHint() const override { return {leastWidth, height(*widget())}; }

protected:
    void resizeEvent(QResizeEvent *event) override
    {
        QScrollArea::resizeEvent(event);
        updateGeometry(); // for the bar that comes or goes
    }
    void wheelEvent(QWheelEvent *event) override { event->ignore(); } // it would move the row under the pointer

private:
    int height(const QWidget &row) const
    {
        // Rows behind the shown one are as wide as the stack, too, but hear of it only when their turn comes.
        const bool narrow = (parentWidget() ? parentWidget() : this)->width() < row.minimumSizeHint().width();
        return row.sizeHint().height() + (narrow ? horizontalScrollBar()->sizeHint().height() : 0);
    }
};

} // namespace

ToolOptionsBar::ToolOptionsBar(const QString &title, QWidget *parent)
    : QToolBar(title, parent), m_stack(new QStackedWidget(this))
{
    setObjectName("toolOptions");
    setMovable(false);
    m_stack->setMinimumHeight(leastHeight);
    m_stack->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_stack->addWidget(new QWidget(m_stack));
    addWidget(m_stack);
}

void ToolOptionsBar::setWidget(QWidget *widget)
{
    if (!widget)
        return m_stack->setCurrentIndex(0);
    QWidget *scroll = widget->parentWidget() ? widget->parentWidget()->parentWidget() : nullptr;
    if (!scroll || m_stack->indexOf(scroll) < 0)
        m_stack->addWidget(scroll = new RowScroll(widget));
    m_stack->setCurrentWidget(scroll);
}

} // namespace suffuse
