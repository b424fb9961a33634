// Shortcuts and settings, and how a window makes way for another one where they ask for it.
#include "app/canvas/canvas_widget.h"
#include "app/dialogs/settings_dialog.h"
#include "app/dialogs/shortcuts_dialog.h"
#include "app/session/settings/settings.h"
#include "app/window/main_window.h"
#include "app/window/rebuilt_windows.h"
#include "app/window/workspace_view.h"

#include <QApplication>
#include <QDockWidget>

#include <map>

namespace suffuse {

namespace {

/// What the user has switched on and off, by the rows' ids. Full screen is the window's own state, hidden docks need
/// their layout first.
std::map<QString, bool> switchesOf(const Commands &table)
{
    std::map<QString, bool> switches;
    for (const QAction *action : table.all())
        if (action->isCheckable() && action != &table[Command::FullScreen] && action != &table[Command::HideDocks])
            switches[action->objectName()] = action->isChecked();
    return switches;
}

void setSwitches(const Commands &table, const std::map<QString, bool> &switches)
{
    for (QAction *action : table.all())
        if (const auto it = switches.find(action->objectName()); it != switches.end())
            action->setChecked(it->second);
}

} // namespace

void MainWindow::changeShortcuts()
{
    if (ShortcutsDialog(m_commands->all(), fixedKeys(), this).exec() != QDialog::Accepted)
        return;
    for (QWidget *widget : QApplication::topLevelWidgets())
        if (auto *window = qobject_cast<MainWindow *>(widget))
            applyStoredShortcuts(window->m_commands->all());
}

void MainWindow::changeSettings()
{
    SettingsDialog dialog(this, m_editor.brush());
    if (dialog.exec() != QDialog::Accepted)
        return;
    m_canvas->setPenSettings(settings::penSettings());
    if (dialog.needsOtherWindows())
        rebuildWindowsSoon(); // this is an action of one of them
}

std::unique_ptr<OpenPainting> MainWindow::release()
{
    if (m_canvas->tool())
        m_canvas->tool()->cancel();
    m_editor.commit(); // no widget that goes puts anything back
    // A stack that goes reports that it is empty; there is no canvas to tell any more.
    Editor &editor = m_editor;
    for (QObject *sender :
         std::initializer_list<QObject *>{&editor, &editor.document(), &editor.laterChanges(), &editor.undoStack(),
                                          &editor.clock(), m_playback, m_journal})
        disconnect(sender, nullptr, this, nullptr);
    delete m_commands; // they follow it
    m_commands = nullptr;
    delete m_canvas; // it draws the document
    m_canvas = nullptr;
    for (QDockWidget *dock : std::as_const(m_docks))
        delete dock;
    m_docks.clear();
    return std::move(m_open);
}

MainWindow *MainWindow::replace()
{
    if (m_canvas->tool())
        m_canvas->tool()->cancel();
    const bool hidesDocks = action(Command::HideDocks).isChecked();
    if (hidesDocks)
        action(Command::HideDocks).trigger();
    const QByteArray geometry = saveGeometry(), layout = saveState();
    const std::optional<WorkspaceState> view = workspaceOf(*m_canvas, m_editor);
    const bool fitted = m_canvas->isFitted();
    const std::map<QString, bool> switches = switchesOf(*m_commands);
    auto *successor = new MainWindow(release(), m_makeRenderer);
    setSwitches(*successor->m_commands, switches);
    successor->setAttribute(Qt::WA_DeleteOnClose, testAttribute(Qt::WA_DeleteOnClose));
    successor->restoreGeometry(geometry);
    successor->restoreState(layout);
    successor->m_commands->update();
    successor->show();
    if (view && !fitted)
        showWorkspace(*view, *successor->m_canvas, successor->m_editor);
    if (hidesDocks)
        successor->action(Command::HideDocks).trigger();
    return successor;
}

} // namespace suffuse
