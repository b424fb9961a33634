#include "app/panels/strokes/rows/row_menu.h"

#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/session/commands/selection_commands.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/widgets/look/icons.h"
#include "model/painting/editable.h"
#include "undo/layers/emptied_groups.h"
#include "undo/layers/group_edits.h"

#include <QMenu>

#include <algorithm>

namespace suffuse {

namespace {

/// A group that blends mixes by itself in any case, and a locked one stays as it is.
void addIsolated(QMenu &menu, Editor &editor, GroupId id)
{
    const Document &document = editor.document();
    const Group *group = document.painting()->findGroup(id);
    if (!group)
        return;
    const bool on = group->isolated, isFree = !group->blends();
    QAction *action = menu.addAction(StrokesPanel::tr("Mi&x by Itself"), &editor, [&editor, id, on] {
        editor.push(setGroupIsolated(editor.document(), {id}, !on),
                    on ? StrokesPanel::tr("Mix group with what lies below") : StrokesPanel::tr("Mix group by itself"));
    });
    action->setCheckable(true);
    action->setChecked(group->isIsolated());
    action->setEnabled(isFree && !setGroupIsolated(document, {id}, !on).isEmpty());
}

void addGroupSwitches(QMenu &menu, Editor &editor, StrokesModel &model, const QModelIndex &row)
{
    for (const int column : {StrokesModel::EyeColumn, StrokesModel::LockColumn}) {
        const QModelIndex cell = row.siblingAtColumn(column);
        const bool on = cell.data(StrokesModel::SwitchRole).toBool();
        const QString text = column == StrokesModel::EyeColumn
                                 ? (on ? StrokesPanel::tr("&Hide") : StrokesPanel::tr("Sh&ow"))
                                 : (on ? StrokesPanel::tr("Un&lock") : StrokesPanel::tr("&Lock"));
        menu.addAction(text, &model, [&model, cell = QPersistentModelIndex(cell)] { model.toggle(cell); });
    }
    addIsolated(menu, editor, row.data(StrokesModel::GroupIdRole).toULongLong());
}

/// All that is selected changes as the row does that was clicked.
void addStrokeSwitches(QMenu &menu, Editor &editor, const Stroke &stroke)
{
    std::set<StrokeId> strokes = editor.selection().strokes;
    strokes.insert(stroke.id);
    const bool visible = stroke.visible, locked = stroke.locked;
    menu.addAction(visible ? StrokesPanel::tr("&Hide") : StrokesPanel::tr("Sh&ow"), &editor,
                   [&editor, strokes, visible] {
                       editor.push(setVisible(editor.document(), strokes, !visible),
                                   visible ? StrokesPanel::tr("Hide strokes") : StrokesPanel::tr("Show strokes"));
                       commands::deselectHidden(editor);
                   });
    menu.addAction(locked ? StrokesPanel::tr("Un&lock") : StrokesPanel::tr("&Lock"), &editor,
                   [&editor, strokes, locked] {
                       editor.push(setLocked(editor.document(), strokes, !locked),
                                   locked ? StrokesPanel::tr("Unlock strokes") : StrokesPanel::tr("Lock strokes"));
                   });
}

} // namespace

void fillRowMenu(QMenu &menu, Editor &editor, StrokesModel &model, const QModelIndex &row, const QList<QAction *> &more)
{
    if (const StrokePtr stroke = model.strokeValueAt(row))
        addStrokeSwitches(menu, editor, *stroke);
    else
        addGroupSwitches(menu, editor, model, row);
    const Painting &painting = *editor.document().painting();
    const std::set<StrokeId> &selected = editor.selection().strokes;
    const Locks isLocked(painting.groups);
    const bool any = !selected.empty() && std::ranges::any_of(painting.strokes, [&](const StrokePtr &stroke) {
        return selected.contains(stroke->id) && !isLocked(*stroke);
    });
    // A group without strokes has nothing to select, and is deleted as the layer.
    const auto group = GroupId(row.data(StrokesModel::GroupIdRole).toULongLong());
    const bool isEmpty = selected.empty() && isEmptyGroup(painting, group);
    menu.addAction(icon("delete"), StrokesPanel::tr("&Delete"), &editor,
                   [&editor, isEmpty, group] {
                       if (isEmpty)
                           editor.layer().choose(group);
                       commands::deleteSelected(editor);
                   })
        ->setEnabled(any || isEmpty);
    menu.addSeparator();
    menu.addActions(more);
    menu.addSeparator();
    QMenu *same = menu.addMenu(StrokesPanel::tr("Select &Same"));
    same->setEnabled(!selected.empty());
    for (const auto &[text, what] :
         {std::pair(StrokesPanel::tr("&Colour"), Same::Colour), std::pair(StrokesPanel::tr("&Style"), Same::Style),
          std::pair(StrokesPanel::tr("&Brush"), Same::Brush), std::pair(StrokesPanel::tr("&Name"), Same::Name)})
        same->addAction(text, &editor, [&editor, what = what] { commands::selectSameAs(editor, what); });
}

} // namespace suffuse
