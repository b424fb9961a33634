#include "app/window/extending.h"

#include "app/canvas/canvas_widget.h"
#include "app/dialogs/extensions/extension_dialog.h"
#include "app/dialogs/extensions/manage_extensions_dialog.h"
#include "app/extensions/passed_part.h"
#include "app/session/commands/commands.h"
#include "app/session/extensions/extension_library.h"
#include "app/session/open_painting.h"
#include "app/session/translation.h"
#include "app/widgets/habits/at_next_change.h"

#include <QMainWindow>
#include <QMenu>
#include <QStatusBar>

#include <algorithm>
#include <utility>
#include <vector>

namespace suffuse {

namespace {

/// A text of somebody else as a menu's entry: what it has of ampersands are no letters of ours.
QString entryText(const QString &text)
{
    return QString(text).replace('&', QLatin1String("&&"));
}

using ExtensionEntry = std::pair<QStringList, const Extension *>;

/// What stands in the menu, each with the titles of its submenus: submenus first, by their titles.
std::vector<ExtensionEntry> entriesOf(ExtensionLibrary &library, const QString &language)
{
    std::vector<ExtensionEntry> entries;
    for (const FoundExtension &found : library.found()) {
        if (!found.extension || !library.isEnabled(found.extension->id))
            continue;
        QStringList titles;
        for (const Words &title : found.extension->menu)
            titles << entryText(title.in(language));
        entries.emplace_back(titles, &*found.extension);
    }
    std::ranges::stable_sort(entries, [](const ExtensionEntry &a, const ExtensionEntry &b) {
        if (a.first.isEmpty() || b.first.isEmpty())
            return !a.first.isEmpty() && b.first.isEmpty();
        return a.first.first().localeAwareCompare(b.first.first()) < 0;
    });
    return entries;
}

} // namespace

Extending::Extending(const Workplace &place, QObject *parent) : QObject(parent), m_place(place)
{
    addRows();
    connect(&ExtensionLibrary::instance(), &ExtensionLibrary::changed, this, &Extending::refill);
}

Extending::~Extending() = default;

void Extending::addRows()
{
    m_place.commands
        .add(Command::RepeatExtension, "repeatExtension", Commands::tr("&Repeat Last Extension"), "",
             {QKeySequence(Commands::tr("Ctrl+Alt+X"))}, Commands::tr("Once more, with the same values"))
        .when([] { return ExtensionLibrary::instance().usable(ExtensionLibrary::instance().last()) != nullptr; },
              Commands::tr("No extension has run yet."))
        .runs([this] { run(ExtensionLibrary::instance().last(), true); });
    m_place.commands
        .add(Command::ManageExtensions, "manageExtensions", Commands::tr("&Manage Extensions…"), "", {},
             Commands::tr("Which extensions there are, which are in the menu, and what went wrong"))
        .runs([this] { ManageExtensionsDialog(&m_place.window).exec(); });
}

void Extending::fill(QMenu &menu)
{
    m_menu = &menu;
    refill();
}

void Extending::refill()
{
    if (!m_menu)
        return;
    qDeleteAll(m_actions);
    m_actions.clear();
    for (QMenu *submenu : std::as_const(m_submenus)) {
        m_menu->removeAction(submenu->menuAction());
        submenu->deleteLater();
    }
    m_submenus.clear();
    delete std::exchange(m_line, nullptr);
    const QString language = languageInUse();
    ExtensionLibrary &library = ExtensionLibrary::instance();
    QAction *last = &m_place.commands[Command::ManageExtensions];
    for (const auto &[titles, each] : entriesOf(library, language)) {
        const Extension &extension = *each;
        const QString name = entryText(extension.name.in(language));
        auto *action = new QAction(extension.fields.empty() ? name : Commands::tr("%1…").arg(name), this);
        action->setObjectName(QStringLiteral("extension.") + extension.id);
        action->setIconText(extension.name.in(language));
        action->setToolTip(extension.description.in(language));
        connect(action, &QAction::triggered, this, [this, id = extension.id] { run(id, false); });
        QMenu &menu = menuFor(titles);
        menu.insertAction(&menu == m_menu ? last : nullptr, action);
        m_actions << action;
    }
    if (!m_actions.isEmpty())
        m_line = m_menu->insertSeparator(last);
}

QMenu &Extending::menuFor(const QStringList &titles)
{
    QMenu *menu = m_menu;
    for (const QString &title : titles) {
        const auto at = std::ranges::find_if(
            m_submenus, [&](const QMenu *submenu) { return submenu->title() == title && submenu->parent() == menu; });
        QMenu *below = at == m_submenus.end() ? new QMenu(title, menu) : *at;
        if (at == m_submenus.end()) {
            menu->insertMenu(menu == m_menu ? &m_place.commands[Command::ManageExtensions] : nullptr, below);
            m_submenus << below;
        }
        menu = below;
    }
    return *menu;
}

void Extending::run(const QString &id, bool atOnce)
{
    const Extension *found = ExtensionLibrary::instance().usable(id);
    if (!found)
        return;
    const Extension extension = *found;
    m_place.canvas.settleTool();
    m_place.open.playback.pause();
    Editor &editor = m_place.open.editor;
    if (extension.passes == Extension::Passes::Selection &&
        passedStrokes(*editor.document().painting(), extension.passes, editor.selection().strokes, 0).empty()) {
        emit m_place.commands.said(Commands::tr("Nothing that is visible and unlocked is selected."), 5000);
        return;
    }
    ExtensionDialog dialog(editor, extension, &m_place.window);
    if (atOnce || extension.fields.empty())
        QMetaObject::invokeMethod(&dialog, &ExtensionDialog::run, Qt::QueuedConnection);
    if (dialog.exec() == QDialog::Accepted && !dialog.said().isEmpty())
        sayUntilChange(*m_place.window.statusBar(), editor.document(), dialog.said());
    m_place.commands.update(Command::RepeatExtension);
}

} // namespace suffuse
