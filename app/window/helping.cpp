#include "app/window/helping.h"

#include "app/dialogs/manual/manual_window.h"
#include "app/session/commands/commands.h"
#include "app/widgets/habits/help_page.h"

#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QKeySequenceEdit>
#include <QMainWindow>
#include <QShortcutEvent>

namespace suffuse {

namespace {

/// What the manual says about each tool.
QString pageOfTool(const Commands &table)
{
    using enum Command;
    struct ToolPage {
        Command tool;
        const char *page;
    };
    static constexpr ToolPage pages[] = {
        {Brush, "brushes"},       {Select, "refining"},   {Segments, "refining"}, {Shapes, "shapes"},
        {OutlinePen, "shapes"},   {LassoFill, "shapes"},  {Bucket, "shapes"},     {Text, "texts"},
        {Redraw, "refining"},     {Push, "refining"},     {Knife, "refining"},    {Eraser, "refining"},
        {AttributeBrush, "refining"}, {Eyedropper, "colour"}, {Assistants, "window"}, {Pan, "window"},
    };
    for (const auto &[tool, page] : pages)
        if (table[tool].isChecked())
            return QString::fromLatin1(page);
    return {};
}

} // namespace

Helping::Helping(const Workplace &place, QObject *parent) : QObject(parent), m_place(place)
{
    qApp->installEventFilter(this);
    place.commands
        .add(Command::Manual, "manual", Commands::tr("&Manual"), "", {QKeySequence(Qt::Key_F1)},
             Commands::tr("What Suffuse does and how; the key opens the page about what you are working with"))
        .runs([] { ManualWindow::open({}, nullptr); });
}

QString Helping::pageAbout(const QWidget *widget) const
{
    const QString page = helpPageOf(widget);
    return page.isEmpty() ? pageOfTool(m_place.commands) : page;
}

/// Windows beside the main one have no shortcuts of it. The field that takes a shortcut takes this one, too.
bool Helping::isAskedIn(const QObject &watched, const QEvent &event) const
{
    const auto *widget = event.type() == QEvent::KeyPress ? qobject_cast<const QWidget *>(&watched) : nullptr;
    if (!widget || qobject_cast<const QKeySequenceEdit *>(widget) || !qobject_cast<const QDialog *>(widget->window()))
        return false;
    const QWidget *owner = widget->window();
    while (owner->parentWidget())
        owner = owner->parentWidget()->window();
    const auto &key = static_cast<const QKeyEvent &>(event);
    return owner == &m_place.window &&
           m_place.commands[Command::Manual].shortcuts().contains(QKeySequence(key.keyCombination()));
}

bool Helping::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Shortcut && watched == &m_place.commands[Command::Manual]) {
        QWidget *focus = QApplication::focusWidget();
        ManualWindow::open(pageAbout(focus), focus);
        return true;
    }
    if (isAskedIn(*watched, *event)) {
        auto *asking = static_cast<QWidget *>(watched);
        ManualWindow::open(pageAbout(asking), asking);
        return true;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace suffuse
