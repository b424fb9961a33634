#include "app/panels/inspector/scroll_place.h"

#include "app/widgets/habits/lay_out.h"

#include <QEvent>
#include <QScopedValueRollback>
#include <QScrollBar>

#include <algorithm>

namespace suffuse {

ScrollPlace::ScrollPlace(QScrollArea &scroll, const QWidgetList &pages) : QObject(&scroll), m_scroll(scroll)
{
    for (QWidget *page : pages) {
        m_pages << Page{page, {}};
        for (QObject *child : page->children())
            child->installEventFilter(this);
    }
    connect(scroll.verticalScrollBar(), &QScrollBar::rangeChanged, this, &ScrollPlace::scrollToAnchor);
    connect(scroll.verticalScrollBar(), &QScrollBar::valueChanged, this, [this] {
        if (!m_restoring)
            take();
    });
}

/// Rows may find their height only when they are laid out a second time.
bool ScrollPlace::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Move || event->type() == QEvent::Resize)
        scrollToAnchor();
    return QObject::eventFilter(watched, event);
}

ScrollPlace::Page &ScrollPlace::shown()
{
    const auto isShown = [](const Page &page) { return !page.widget->isHidden(); };
    const auto it = std::ranges::find_if(m_pages, isShown);
    return it == m_pages.end() ? m_pages.front() : *it;
}

void ScrollPlace::take()
{
    Page &page = shown();
    page.anchors.clear();
    const int top = m_scroll.verticalScrollBar()->value();
    if (top == 0)
        return;
    const QWidget &content = *m_scroll.widget();
    const int left = page.widget->mapTo(&content, QPoint()).x();
    // Between two rows there is nothing but their section, so what is just below the edge is asked for.
    constexpr int rowHeight = 24, step = 4;
    QWidget *found = nullptr;
    for (int below = 0; below < rowHeight; below += step) {
        QWidget *at = content.childAt(left + 1, top + below);
        if (at && page.widget->isAncestorOf(at) && (!found || found->isAncestorOf(at)))
            found = at;
    }
    for (QWidget *widget = found; widget && widget != &content; widget = widget->parentWidget())
        page.anchors << Anchor{widget, widget->mapTo(&content, QPoint()).y() - top};
}

void ScrollPlace::restore()
{
    const QScopedValueRollback<bool> restoring(m_restoring, true);
    // Rows that were shown or hidden just now have no places yet, and the scroll bar has its old range.
    layOutNow(m_scroll);
    scrollToAnchor();
}

void ScrollPlace::scrollToAnchor()
{
    const QScopedValueRollback<bool> restoring(m_restoring, true);
    const QWidget &content = *m_scroll.widget();
    int top = 0;
    for (const Anchor &anchor : shown().anchors)
        if (anchor.widget && anchor.widget->isVisibleTo(&content)) {
            top = anchor.widget->mapTo(&content, QPoint()).y() - anchor.below;
            break;
        }
    m_scroll.verticalScrollBar()->setValue(top);
}

} // namespace suffuse
