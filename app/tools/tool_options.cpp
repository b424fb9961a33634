#include "app/tools/tool_options.h"

#include "app/widgets/look/row_scroll.h"

#include <QStackedWidget>

namespace suffuse {

namespace {

constexpr int rowHeight = 30; ///< the height of a row of fields, logical pixels

} // namespace

ToolOptionsBar::ToolOptionsBar(const QString &title, QWidget *parent)
    : QToolBar(title, parent), m_stack(new QStackedWidget(this))
{
    setObjectName("toolOptions");
    setMovable(false);
    m_stack->setMinimumHeight(rowHeight);
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
