#include "app/panels/strokes/group_hand.h"

#include "app/panels/strokes/group_cells.h"
#include "app/session/editor.h"
#include "app/widgets/habits/entry_field.h"
#include "app/widgets/numbers/blend_modes.h"
#include "app/widgets/numbers/display.h"
#include "app/widgets/numbers/number_field.h"
#include "undo/layers/group_edits.h"

#include <QActionGroup>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QTreeView>

#include <algorithm>
#include <cmath>
#include <utility>

namespace suffuse {

GroupHand::GroupHand(Editor &editor, QTreeView &view) : QObject(&view), m_editor(editor), m_view(view) {}

void GroupHand::setOpacity(GroupId group, double opacity, ValueEntry *entry)
{
    const auto rounded = float(std::round(std::clamp(opacity, 0.0, 1.0) * 1000) / 1000);
    Edit edit = setGroupOpacity(m_editor.document(), {group}, rounded);
    const Group *present = m_editor.document().painting()->findGroup(group);
    if (edit.isEmpty() && present && present->opacity != rounded)
        emit said(tr("The group is locked: nothing changes."));
    m_editor.push(std::move(edit), tr("Change group opacity"), entry);
}

void GroupHand::fillModes(QMenu &menu, GroupId group)
{
    const Group *present = m_editor.document().painting()->findGroup(group);
    QComboBox all;
    addBlendModes(all);
    auto *oneOf = new QActionGroup(&menu);
    for (int i = 0; i < all.count() && present; ++i) {
        if (!all.itemData(i).isValid()) {
            menu.addSeparator();
            continue;
        }
        const BlendMode mode = modeAt(all, i);
        QAction *action = menu.addAction(all.itemText(i), this, [this, group, mode] {
            Edit edit = setGroupBlend(m_editor.document(), {group}, mode);
            const Group *now = m_editor.document().painting()->findGroup(group);
            if (edit.isEmpty() && now && now->blend != mode)
                emit said(tr("The group is locked: nothing changes."));
            m_editor.push(std::move(edit), tr("Change group mode"));
        });
        action->setToolTip(all.itemData(i, Qt::ToolTipRole).toString());
        action->setCheckable(true);
        oneOf->addAction(action);
        action->setChecked(present->blend == mode);
    }
    menu.setToolTipsVisible(true);
    menu.installEventFilter(this);
}

/// Goes on to the next entry that begins with a letter, as lists do. Returns false if no letter was typed.
bool GroupHand::goesToLetter(QMenu &menu, QKeyEvent &key)
{
    const QString letter = key.text();
    if (letter.size() != 1 || !letter[0].isLetter() || (key.modifiers() & ~Qt::ShiftModifier))
        return false;
    key.accept(); // What the key means to the window it does not mean here.
    if (key.type() == QEvent::ShortcutOverride)
        return true;
    const QList<QAction *> actions = menu.actions();
    const qsizetype from = actions.indexOf(menu.activeAction());
    for (qsizetype i = 1; i <= actions.size(); ++i)
        if (QAction *next = actions[(from + i) % actions.size()];
            next->text().remove(QLatin1Char('&')).startsWith(letter, Qt::CaseInsensitive)) {
            menu.setActiveAction(next);
            break;
        }
    return true;
}

void GroupHand::typeOpacity(const QModelIndex &row, const Group &group, const GroupCells &cells)
{
    constexpr int fieldWidth = 64;
    auto *field = new NumberField(m_view.viewport());
    field->setObjectName("groupOpacity");
    field->setAccessibleName(tr("Opacity of the group"));
    field->setAlignment(Qt::AlignRight);
    QRect place = cells.opacity;
    place.setLeft(std::min(place.left(), place.right() + 1 - fieldWidth));
    field->setGeometry(place);
    field->setDisplay(shareDisplay());
    field->setRange(0, 1);
    field->setValue(double(group.opacity));
    field->selectAll();
    connect(field, &NumberField::entered, this,
            [this, id = group.id](double value) { setOpacity(id, value, nullptr); });
    connect(field, &NumberField::refused, this, [this](const QString &why) {
        if (!why.isEmpty())
            emit said(why);
    });
    connect(field, &QLineEdit::editingFinished, this, [this, field] { close(*field); });
    field->installEventFilter(this);
    // It stands on its row, which has gone or stands elsewhere then.
    const QAbstractItemModel *rows = m_view.model();
    for (const auto change : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(rows, change, field, &QObject::deleteLater);
    connect(rows, &QAbstractItemModel::rowsMoved, field, &QObject::deleteLater);
    connect(rows, &QAbstractItemModel::layoutChanged, field, &QObject::deleteLater);
    m_view.scrollTo(row);
    field->setVisible(true);
    field->setFocus(Qt::MouseFocusReason);
}

/// The list has the keyboard again, unless it has gone elsewhere.
void GroupHand::close(QWidget &field)
{
    if (field.hasFocus())
        m_view.setFocus(Qt::OtherFocusReason);
    field.deleteLater();
}

/// Esc gives up the number that is typed, as it does with a name.
bool GroupHand::eventFilter(QObject *watched, QEvent *event)
{
    if (auto *menu = qobject_cast<QMenu *>(watched);
        menu && (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride))
        return goesToLetter(*menu, *static_cast<QKeyEvent *>(event));
    auto *field = qobject_cast<EntryField *>(watched);
    if (!field || event->type() != QEvent::KeyPress || static_cast<QKeyEvent *>(event)->key() != Qt::Key_Escape)
        return QObject::eventFilter(watched, event);
    field->setModified(false);
    close(*field);
    return true;
}

std::optional<float> GroupHand::opacityOf(GroupId group) const
{
    const Group *present = m_editor.document().painting()->findGroup(group);
    return present ? std::optional(present->opacity) : std::nullopt;
}

void GroupHand::giveUp()
{
    if (!isDragging())
        return;
    m_press->isOver = true;
    m_entry.giveUpDrag();
}

void GroupHand::dragTo(const QPoint &at)
{
    if (m_press->shown && opacityOf(m_press->group) != m_press->shown) // An undo has taken it back.
        giveUp();
    const int by = at.x() - m_press->at.x();
    if (m_press->isOver || (!m_press->shown && std::abs(by) < QApplication::startDragDistance()))
        return;
    if (!m_press->shown)
        m_entry.beginDrag();
    setOpacity(m_press->group, m_press->from + by * perPixel, &m_entry);
    m_press->shown = opacityOf(m_press->group);
}

bool GroupHand::takes(const QMouseEvent &event, const QModelIndex &row, const Group *group, const GroupCells &cells)
{
    const QPoint at = event.position().toPoint();
    const bool isPress = event.type() == QEvent::MouseButtonPress || event.type() == QEvent::MouseButtonDblClick;
    const bool isOwn = isPress && group && event.button() == Qt::LeftButton && !event.modifiers();
    if (isOwn && cells.mode.contains(at)) {
        QMenu menu(&m_view);
        fillModes(menu, group->id);
        menu.exec(m_view.viewport()->mapToGlobal(cells.mode.bottomLeft()));
        return true;
    }
    if (isOwn && cells.opacity.contains(at)) {
        m_press = Press{group->id, double(group->opacity), at};
        return true;
    }
    if (!m_press)
        return false;
    if (event.type() == QEvent::MouseMove) {
        dragTo(at);
    } else if (event.type() == QEvent::MouseButtonRelease) {
        const Press press = *std::exchange(m_press, {});
        if (press.shown && !press.isOver)
            m_entry.commitDrag();
        else if (!press.isOver && group && press.group == group->id)
            typeOpacity(row, *group, cells);
    }
    return true;
}

} // namespace suffuse
