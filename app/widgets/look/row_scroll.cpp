#include "app/widgets/look/row_scroll.h"

#include <QScrollBar>
#include <QWheelEvent>

namespace suffuse {

namespace {

constexpr int leastRowWidth = 200; ///< of what is seen of a row, logical pixels

} // namespace

RowScroll::RowScroll(QWidget *row)
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

QSize RowScroll::sizeHint() const
{
    return {widget()->sizeHint().width(), height(*widget())};
}

QSize RowScroll::minimumSizeHint() const
{
    return {leastRowWidth, height(*widget())};
}

void RowScroll::resizeEvent(QResizeEvent *event)
{
    QScrollArea::resizeEvent(event);
    updateGeometry(); // for the bar that comes or goes
}

void RowScroll::wheelEvent(QWheelEvent *event)
{
    event->ignore(); // it would move the row under the pointer
}

int RowScroll::height(const QWidget &row) const
{
    // Rows behind the shown one are as wide as what holds them, too, but hear of it only when their turn comes.
    const bool narrow = (parentWidget() ? parentWidget() : this)->width() < row.minimumSizeHint().width();
    return row.sizeHint().height() + (narrow ? horizontalScrollBar()->sizeHint().height() : 0);
}

} // namespace suffuse
