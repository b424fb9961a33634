#include "app/tools/tool_options.h"

#include <QStackedWidget>

namespace suffuse {

namespace {

constexpr int leastHeight = 30; ///< the height of a row of fields, logical pixels

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
    if (widget && m_stack->indexOf(widget) < 0)
        m_stack->addWidget(widget);
    if (widget)
        m_stack->setCurrentWidget(widget);
    else
        m_stack->setCurrentIndex(0);
}

} // namespace suffuse
