#include "app/window/rebuilt_windows.h"

#include "app/session/translation.h"
#include "app/window/main_window.h"

#include <QApplication>
#include <QPointer>
#include <QTimer>

#include <algorithm>

namespace suffuse {

void rebuildWindows(const MainWindow *front)
{
    installTranslators();
    if (!front)
        front = qobject_cast<MainWindow *>(QApplication::activeWindow());
    QList<MainWindow *> windows;
    for (QWidget *widget : QApplication::topLevelWidgets())
        if (auto *window = qobject_cast<MainWindow *>(widget); window && window->testAttribute(Qt::WA_DeleteOnClose))
            windows << window; // the others are not their own
    // The one that is worked in comes last, so that it is shown over the others again.
    std::stable_partition(windows.begin(), windows.end(), [front](const MainWindow *w) { return w != front; });
    for (MainWindow *window : windows) {
        MainWindow *successor = window->replace();
        if (window == front) {
            successor->raise();
            successor->activateWindow();
        }
        delete window;
    }
}

void rebuildWindowsSoon(const MainWindow &front)
{
    QTimer::singleShot(0, qApp, [front = QPointer(&front)] { rebuildWindows(front); });
}

} // namespace suffuse
