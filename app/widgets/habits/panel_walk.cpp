#include "app/widgets/habits/panel_walk.h"

#include "app/widgets/look/theme.h"

#include <QApplication>
#include <QDockWidget>
#include <QLineEdit>
#include <QMainWindow>
#include <QPainter>
#include <QTabBar>
#include <QToolBar>

#include <algorithm>
#include <tuple>

namespace suffuse {

/// A frame that lies on top of a panel and lets all events through.
class PanelFrame : public QWidget {
public:
    explicit PanelFrame(QWidget &panel) : QWidget(panel.window()), m_panel(panel)
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setFocusPolicy(Qt::NoFocus);
        follow();
        show();
        raise();
    }

    const QWidget &panel() const { return m_panel; }
    /// Follows the panel, which has moved or has another size.
    void follow()
    {
        constexpr int width = 2;
        setGeometry(QRect(m_panel.mapTo(window(), QPoint()), m_panel.size()));
        setMask(QRegion(rect()) - rect().adjusted(width, width, -width, -width)); // the widgets below paint freely
    }

protected:
    void paintEvent(QPaintEvent *) override { QPainter(this).fillRect(rect(), focusFrame()); }

private:
    QWidget &m_panel;
};

namespace {

/// The place of a dock among the tabs of docks that share a place; −1 if it has a place for itself.
int tabOf(const QMainWindow &window, const QString &title)
{
    for (const auto *bar : window.findChildren<QTabBar *>(QString(), Qt::FindDirectChildrenOnly))
        for (int i = 0; bar->isVisible() && i < bar->count(); ++i)
            if (bar->tabText(i) == title)
                return i;
    return -1;
}

} // namespace

bool takesFocus(const QWidget &widget)
{
    return widget.focusPolicy() & Qt::TabFocus && widget.isEnabled() && !widget.focusProxy();
}

PanelWalk::PanelWalk(QMainWindow &window, QWidget &canvas, QObject *parent)
    : QObject(parent), m_window(window), m_canvas(canvas)
{}

PanelWalk::~PanelWalk()
{
    delete m_frame;
}

QWidget *PanelWalk::panelOf(QWidget *widget) const
{
    for (; widget && widget != &m_window; widget = widget->parentWidget()) {
        const bool isPanel = qobject_cast<QDockWidget *>(widget) || qobject_cast<QToolBar *>(widget);
        if (isPanel && widget->parentWidget() == &m_window)
            return widget;
        if (widget->isWindow())
            return nullptr; // a dialog has keys of its own
    }
    return nullptr;
}

QList<QWidget *> PanelWalk::stops() const
{
    QList<QWidget *> panels;
    for (auto *bar : m_window.findChildren<QToolBar *>(QString(), Qt::FindDirectChildrenOnly))
        if (bar->isVisible())
            panels << bar;
    for (auto *dock : m_window.findChildren<QDockWidget *>(QString(), Qt::FindDirectChildrenOnly))
        if (!dock->isHidden())
            panels << dock;
    // Docks that lie behind another one have no place of their own. They count as standing where the shown one stands.
    const auto place = [this](QWidget *panel) {
        const QWidget *front = inFrontOf(*panel), *shown = front ? front : panel;
        const QPoint at = shown->mapToGlobal(QPoint());
        return std::tuple(at.x(), at.y(), tabOf(m_window, panel->windowTitle()));
    };
    std::ranges::sort(panels, {}, place);
    return QList<QWidget *>{&m_canvas} + panels;
}

void PanelWalk::walk(bool forward)
{
    const QList<QWidget *> all = stops();
    QWidget *focus = QApplication::focusWidget();
    const qsizetype count = all.size(), here = std::max<qsizetype>(0, all.indexOf(panelOf(focus)));
    for (qsizetype i = 1; i <= count; ++i)
        if (QWidget *stop = all[(here + (forward ? i : count - i)) % count]) {
            QDockWidget *front = inFrontOf(*stop);
            if (enter(*stop)) {
                putBack(*stop);
                if (!m_front)
                    m_front = front;
                return;
            }
            if (front)
                front->raise();
        }
}

/// The dock behind which another one stands; null if it stands behind none.
QDockWidget *PanelWalk::inFrontOf(QWidget &stop) const
{
    auto *dock = qobject_cast<QDockWidget *>(&stop);
    if (dock && dock->visibleRegion().isEmpty())
        for (QDockWidget *other : m_window.tabifiedDockWidgets(dock))
            if (!other->visibleRegion().isEmpty())
                return other;
    return nullptr;
}

/// Docks that the walk has brought to the front, and in which nothing was done, go back behind the one that stood
/// there.
void PanelWalk::putBack(const QWidget &stop)
{
    if (!m_front || m_front == &stop)
        return;
    for (const QDockWidget *other : m_window.tabifiedDockWidgets(m_front))
        if (other == &stop)
            return;
    m_front->raise();
    m_front = nullptr;
}

bool PanelWalk::enter(QWidget &stop)
{
    QWidget *goal = &stop == &m_canvas ? &stop : nullptr;
    QWidget *last = stop.focusWidget(); // the widget that had the keyboard when it was here last
    if (auto *dock = qobject_cast<QDockWidget *>(&stop))
        dock->raise();
    // In a row of fields one types: its buttons come by Tab.
    if (qobject_cast<QToolBar *>(&stop) && !qobject_cast<QLineEdit *>(last))
        for (QWidget *w = stop.nextInFocusChain(); !goal && w != &stop; w = w->nextInFocusChain())
            if (qobject_cast<QLineEdit *>(w) && stop.isAncestorOf(w) && takesFocus(*w) && w->isVisibleTo(&stop))
                goal = w;
    if (!goal && last && last->focusPolicy() != Qt::NoFocus && last->isEnabled() && last->isVisibleTo(&stop))
        goal = last;
    for (QWidget *w = stop.nextInFocusChain(); !goal && w != &stop; w = w->nextInFocusChain())
        if (stop.isAncestorOf(w) && takesFocus(*w) && w->isVisibleTo(&stop))
            goal = w;
    if (!goal)
        return false;
    stop.window()->activateWindow();
    stop.window()->setAttribute(Qt::WA_KeyboardFocusChange); // from now on styles show the focus
    goal->setFocus(Qt::TabFocusReason);
    frame(stop);
    return true;
}

void PanelWalk::toDock(QDockWidget &dock)
{
    m_front = nullptr; // It is meant to stay there.
    enter(dock);
}

void PanelWalk::keepInFront()
{
    m_front = nullptr;
}

/// Shows where the keyboard is.
void PanelWalk::frame(QWidget &stop)
{
    delete m_frame;
    m_frame = new PanelFrame(stop);
    emit framed(&stop);
}

void PanelWalk::unframe()
{
    if (!m_frame)
        return;
    delete m_frame;
    emit framed(nullptr);
}

void PanelWalk::leave(const QWidget *now)
{
    if (m_frame && (!now || (now != &m_frame->panel() && !m_frame->panel().isAncestorOf(now))))
        unframe();
}

void PanelWalk::follow(const QWidget *moved)
{
    if (m_frame && moved == &m_frame->panel())
        m_frame->follow();
}

/// Whether a widget is in a dock that is hidden behind another one.
bool PanelWalk::isBehind(QWidget &widget) const
{
    const auto *dock = qobject_cast<QDockWidget *>(panelOf(&widget));
    return dock && dock->visibleRegion().isEmpty();
}

QWidget *PanelWalk::tabbed(QWidget &to, bool forward)
{
    QWidget *goal = &to;
    while (isBehind(*goal) || !takesFocus(*goal) || !goal->isVisible() || goal->window() != to.window()) {
        goal = forward ? goal->nextInFocusChain() : goal->previousInFocusChain();
        if (goal == &to)
            return nullptr;
    }
    if (goal != &to)
        goal->setFocus(forward ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    QWidget *panel = goal == &m_canvas ? goal : panelOf(goal); // the canvas: by Shift+Tab in the first field of a row
    if (panel)
        frame(*panel);
    return panel;
}

} // namespace suffuse
