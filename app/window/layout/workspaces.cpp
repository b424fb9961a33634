#include "app/window/layout/workspaces.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/commands/commands.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/messages.h"
#include "app/window/free_hand.h"
#include "app/window/layout/docks.h"
#include "app/window/layout/window_layout.h"

#include <QInputDialog>
#include <QMainWindow>
#include <QMenu>

#include <algorithm>

namespace suffuse {

namespace {

constexpr qsizetype longestWorkspaceName = 80; ///< characters

/// In the settings a workspace is its name and its sealed bytes, with a tab between them.
QString workspaceNameIn(const QString &stored)
{
    return stored.section('\t', 0, 0);
}

void removeWorkspace(QStringList &stored, const QString &name)
{
    stored.removeIf([&](const QString &one) { return workspaceNameIn(one) == name; });
}

QString workspacesKey()
{
    return QStringLiteral("workspaces/saved");
}

/// Those that come along.
const std::vector<std::pair<Command, DockSet>> &ownSets()
{
    static const std::vector<std::pair<Command, DockSet>> sets{{Command::WorkspacePaint, DockSet::Paint},
                                                               {Command::WorkspaceRefine, DockSet::Refine},
                                                               {Command::WorkspaceTime, DockSet::Time}};
    return sets;
}

} // namespace

Workspaces::Workspaces(const Workplace &place, std::function<void(DockSet)> arrange, QObject *parent)
    : QObject(parent), m_place(place), m_arrange(std::move(arrange))
{
    addRows();
}

void Workspaces::addRows()
{
    using enum Command;
    Commands &table = m_place.commands;
    const auto add = [&](Command command, const QString &id, const QString &text, const QString &tip) {
        const DockSet set = std::ranges::find(ownSets(), command, &std::pair<Command, DockSet>::first)->second;
        table.add(command, id, text, "", {}, tip).runs([this, set] {
            whenHandIsFree(m_place.canvas, *this, [this, set] { m_arrange(set); });
        });
    };
    add(WorkspacePaint, "workspacePaint", Commands::tr("Workspace to &Paint"),
        Commands::tr("Colour, brushes and strokes beside a wide canvas"));
    add(WorkspaceRefine, "workspaceRefine", Commands::tr("Workspace to &Refine"),
        Commands::tr("Inspector, strokes, history and colour"));
    add(WorkspaceTime, "workspaceTime", Commands::tr("Workspace for &Time"),
        Commands::tr("A high timeline, with inspector and strokes"));
    table
        .add(SaveWorkspace, "saveWorkspace", Commands::tr("&Save Workspace…"), "", {},
             Commands::tr("Keep where docks and tool bars stand now, under a name"))
        .runs([this] { askAndSave(); });
}

void Workspaces::askAndSave()
{
    bool ok = false;
    const QString name =
        QInputDialog::getText(&m_place.window, tr("Save Workspace"), tr("Name"), QLineEdit::Normal, {}, &ok)
            .simplified()
            .left(longestWorkspaceName);
    if (!ok || name.isEmpty())
        return;
    if (names().contains(name) &&
        !confirm(&m_place.window, tr("There is a workspace “%1” already.").arg(name),
                 tr("It would be replaced by how the window is arranged now."), tr("Replace")))
        return;
    save(name);
    emit m_place.commands.said(tr("The workspace “%1” was saved: View ▸ Workspaces.").arg(name), 8'000);
}

QStringList Workspaces::names()
{
    QStringList names;
    for (const QString &stored : settings::store().value(workspacesKey()).toStringList())
        if (const QString name = workspaceNameIn(stored); !name.isEmpty() && !names.contains(name))
            names << name;
    std::ranges::sort(names, [](const QString &a, const QString &b) { return a.localeAwareCompare(b) < 0; });
    return names;
}

void Workspaces::save(const QString &name)
{
    if (QAction &hides = m_place.commands[Command::HideDocks]; hides.isChecked())
        hides.trigger(); // What is kept is what comes back.
    const QString entry = name + '\t' + window_layout::sealed(m_place.window);
    settings::updateList(workspacesKey(), [&](QStringList stored) {
        removeWorkspace(stored, name);
        return stored << entry;
    });
}

bool Workspaces::choose(const QString &name)
{
    for (const QString &stored : settings::store().value(workspacesKey()).toStringList())
        if (workspaceNameIn(stored) == name) {
            if (QAction &hides = m_place.commands[Command::HideDocks]; hides.isChecked())
                hides.trigger();
            return window_layout::restoreSealed(m_place.window, stored.section('\t', 1));
        }
    return false;
}

void Workspaces::remove(const QString &name)
{
    settings::updateList(workspacesKey(), [&](QStringList stored) {
        removeWorkspace(stored, name);
        return stored;
    });
}

void Workspaces::fillMenu(QMenu &menu)
{
    for (QAction *action : menu.actions())
        if (action->property("saved").toBool()) {
            menu.removeAction(action);
            if (QMenu *below = action->menu())
                below->deleteLater(); // and the action with it
            else
                action->deleteLater();
        }
    const QStringList all = names();
    if (all.isEmpty())
        return;
    const auto mark = [](QAction *action) {
        action->setProperty("saved", true);
        return action;
    };
    const auto shown = [](QString name) { return name.replace('&', "&&"); };
    mark(menu.addSeparator());
    for (const QString &name : all)
        connect(mark(menu.addAction(shown(name))), &QAction::triggered, this, [this, name] {
            whenHandIsFree(m_place.canvas, *this, [this, name] {
                if (!choose(name))
                    showError(&m_place.window, tr("The workspace “%1” is damaged. Save it anew.").arg(name));
            });
        });
    auto *deleting = new QMenu(tr("&Delete Workspace"), &menu);
    for (const QString &name : all)
        connect(deleting->addAction(shown(name)), &QAction::triggered, this, [this, name] {
            if (confirm(&m_place.window, tr("Delete the workspace “%1”?").arg(name),
                        tr("The window stays arranged as it is."), tr("Delete")))
                remove(name);
        });
    mark(menu.addMenu(deleting));
}

} // namespace suffuse
