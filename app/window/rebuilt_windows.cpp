#include "app/window/rebuilt_windows.h"

#include "app/session/translation.h"
#include "app/window/main_window.h"

#include <QApplication>
#include <QTimer>

namespace suffuse {

void rebuildWindows()
{
    installTranslators();
    QWidget *active = QApplication::activeWindow();
    QList<MainWindow *> windows;
    for (QWidget *widget : QApplication::topLevelWidgets())
        if (auto *window = qobject_cast<MainWindow *>(widget); window && window->testAttribute(Qt::WA_DeleteOnClose))
            windows << window; // the others are not their own
    for (MainWindow *window : windows) {
        MainWindow *successor = window->replace();
        if (window == active)
            successor->activateWindow();
        delete window;
    }
}

void rebuildWindowsSoon()
{
    QTimer::singleShot(0, qApp, [] { rebuildWindows(); });
}

} // namespace suffuse
