#include "app/canvas/reading/read_item.h"

#include "app/canvas/canvas_widget.h"
#include "app/canvas/reading/canvas_reading.h"
#include "app/session/current_layer.h"
#include "app/session/selecting/stroke_words.h"

#include <QWindow>

namespace suffuse {

namespace {

const QString selectName = QStringLiteral("select"); ///< a stroke alone; the name stays the same in every language

} // namespace

ReadItem::ReadItem(CanvasReading &reading, const TreeItem &item) : m_reading(&reading), m_item(item) {}

ReadItem::~ReadItem() = default;

bool ReadItem::isValid() const
{
    return m_reading && m_reading->tree().contains(m_item);
}

QWindow *ReadItem::window() const
{
    return m_reading ? m_reading->canvas().window()->windowHandle() : nullptr;
}

const std::vector<TreeItem> &ReadItem::children() const
{
    static const std::vector<TreeItem> none;
    return m_reading && m_item.group ? m_reading->tree().in(m_item.group) : none;
}

QAccessibleInterface *ReadItem::childAt(int x, int y) const
{
    const StrokeId stroke = m_reading ? m_reading->strokeAt({x, y}) : 0;
    const TreeItem found{stroke, 0};
    return stroke && m_item.group && m_reading->tree().parentOf(found) == m_item.group ? m_reading->interfaceOf(found)
                                                                                      : nullptr;
}

QAccessibleInterface *ReadItem::parent() const
{
    return isValid() ? m_reading->parentOf(m_item) : nullptr;
}

QAccessibleInterface *ReadItem::child(int index) const
{
    return index >= 0 && index < childCount() ? m_reading->interfaceOf(children()[std::size_t(index)]) : nullptr;
}

int ReadItem::childCount() const
{
    return int(children().size());
}

int ReadItem::indexOfChild(const QAccessibleInterface *child) const
{
    const auto *item = dynamic_cast<const ReadItem *>(child);
    return item && m_reading && m_item.group && m_reading->tree().parentOf(item->item()) == m_item.group
               ? m_reading->tree().placeOf(item->item())
               : -1;
}

QString ReadItem::text(QAccessible::Text kind) const
{
    if (!isValid() || (kind != QAccessible::Name && kind != QAccessible::Description))
        return {};
    const Painting &painting = *m_reading->tree().painting();
    if (m_item.group) {
        const Group *group = painting.findGroup(m_item.group);
        return kind == QAccessible::Name && group ? titleOf(*group) : QString();
    }
    const StrokePtr stroke = painting.find(m_item.stroke);
    return kind == QAccessible::Name ? wordsOf(*stroke) : stateWordsOf(painting, *stroke);
}

/// Names are given by the command for it, which makes an undo step.
void ReadItem::setText(QAccessible::Text, const QString &) {}

QRect ReadItem::rect() const
{
    return isValid() ? m_reading->areaOf(m_item) : QRect();
}

QAccessible::Role ReadItem::role() const
{
    return m_item.group ? QAccessible::Grouping : QAccessible::ListItem;
}

QAccessible::State ReadItem::state() const
{
    QAccessible::State state;
    if (!isValid()) {
        state.invalid = true;
        return state;
    }
    const Painting &painting = *m_reading->tree().painting();
    const bool selectable = m_reading->canBeSelected(m_item);
    state.selectable = selectable;
    state.multiSelectable = selectable;
    state.focusable = selectable;
    state.selected = m_reading->isSelected(m_item);
    state.focused = m_item.stroke && m_reading->focused() == m_item.stroke;
    if (m_item.stroke) {
        const StrokePtr stroke = painting.find(m_item.stroke);
        state.invisible = !painting.isVisible(*stroke);
        state.readOnly = painting.isLocked(*stroke);
    }
    const QRect view(m_reading->canvas().mapToGlobal(QPoint()), m_reading->canvas().size());
    state.offscreen = !view.intersects(rect());
    return state;
}

void *ReadItem::interface_cast(QAccessible::InterfaceType type)
{
    return type == QAccessible::ActionInterface ? static_cast<QAccessibleActionInterface *>(this) : nullptr;
}

QStringList ReadItem::actionNames() const
{
    if (!isValid() || !m_reading->canBeSelected(m_item))
        return {};
    return {selectName, toggleAction()};
}

QString ReadItem::localizedActionName(const QString &name) const
{
    return name == selectName ? CanvasReading::tr("Select") : QAccessibleActionInterface::localizedActionName(name);
}

QString ReadItem::localizedActionDescription(const QString &name) const
{
    return name == selectName       ? CanvasReading::tr("Selects this and nothing else")
           : name == toggleAction() ? CanvasReading::tr("Adds this to the selection, or takes it away")
                                    : QAccessibleActionInterface::localizedActionDescription(name);
}

void ReadItem::doAction(const QString &name)
{
    if (!isValid())
        return;
    if (name == selectName || name == setFocusAction() || name == pressAction())
        m_reading->select(m_item, false);
    else if (name == toggleAction())
        m_reading->select(m_item, true);
}

} // namespace suffuse
