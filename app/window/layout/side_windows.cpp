#include "app/window/layout/side_windows.h"

#include "app/session/commands/commands.h"

#include <QApplication>
#include <QDialog>
#include <QEvent>
#include <QMainWindow>

namespace suffuse {

SideWindows::SideWindows(const Workplace &place, QObject *parent) : QObject(parent), m_place(place)
{
    qApp->installEventFilter(this);
}

bool SideWindows::eventFilter(QObject *watched, QEvent *event)
{
    auto *dialog = event->type() == QEvent::Show ? qobject_cast<QDialog *>(watched) : nullptr;
    if (dialog && !dialog->isModal() && dialog->parentWidget() && dialog->parentWidget()->window() == &m_place.window)
        for (const Command command :
             {Command::Undo, Command::Redo, Command::Save, Command::SaveAs, Command::SaveCopy, Command::Quit})
            dialog->addAction(&m_place.commands[command]);
    return QObject::eventFilter(watched, event);
}

} // namespace suffuse
