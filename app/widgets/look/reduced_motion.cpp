#include "app/widgets/look/reduced_motion.h"

#include "app/session/settings/motion.h"
#include "model/environment.h"

#include <QApplication>
#include <QMainWindow>
#include <QProcess>
#include <QSettings>
#include <QStandardPaths>

#include <optional>

namespace suffuse {

namespace {

/// What GNOME's settings said when they were asked; no value: nothing yet.
std::optional<bool> gnomeReduces;

/// A value of a desktop's file of settings; no value where there is none.
QVariant desktopValue(const QString &file, const QString &key)
{
    const QString path = QStandardPaths::locate(QStandardPaths::GenericConfigLocation, file);
    return path.isEmpty() ? QVariant() : QSettings(path, QSettings::IniFormat).value(key);
}

bool desktopReduces()
{
    if (const QVariant factor = desktopValue("kdeglobals", "KDE/AnimationDurationFactor"); factor.isValid())
        return factor.toDouble() == 0;
    for (const QString file : {"gtk-4.0/settings.ini", "gtk-3.0/settings.ini"})
        if (const QVariant animates = desktopValue(file, "Settings/gtk-enable-animations"); animates.isValid())
            return !animates.toBool();
    return gnomeReduces.value_or(false);
}

/// GNOME keeps its settings where only its own program reads them.
void askGnome()
{
    static bool asked = false;
    if (asked || environment::value(environment::Variable::Desktop).find("GNOME") == std::string::npos)
        return;
    asked = true;
    auto *process = new QProcess(qApp);
    QObject::connect(process, &QProcess::finished, qApp, [process] {
        gnomeReduces = process->readAllStandardOutput().trimmed() == "false";
        process->deleteLater();
        applyMotion();
    });
    process->start("gsettings", {"get", "org.gnome.desktop.interface", "enable-animations"});
}

} // namespace

bool motionIsReduced()
{
    const settings::Motion wanted = settings::motion();
    return wanted == settings::Motion::Reduced || (wanted == settings::Motion::System && desktopReduces());
}

void applyMotion()
{
    static const int usualFlash = QApplication::cursorFlashTime();
    askGnome();
    const bool reduced = motionIsReduced();
    QApplication::setCursorFlashTime(reduced ? 0 : usualFlash);
    for (QWidget *window : QApplication::topLevelWidgets())
        if (auto *main = qobject_cast<QMainWindow *>(window))
            main->setAnimated(!reduced);
}

} // namespace suffuse
