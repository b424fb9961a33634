#include "model/module_path.h"

#include "model/environment.h"

#include <QCoreApplication>
#include <QDir>

namespace suffuse {

namespace {

QString &namedFolder()
{
    static QString folder;
    return folder;
}

} // namespace

void setModuleFolder(const QString &folder)
{
    namedFolder() = folder;
}

QString modulePath(const QString &name)
{
    QString folder = QString::fromStdString(environment::value(environment::Variable::ModuleFolder));
    if (folder.isEmpty())
        folder = namedFolder();
    QDir dir(folder);
    if (folder.isEmpty()) {
        const QDir programs(QCoreApplication::applicationDirPath());
        dir.setPath(programs.absoluteFilePath(QStringLiteral("../lib/suffuse")));
        if (!dir.exists())
            dir.setPath(programs.absoluteFilePath(QStringLiteral(SUFFUSE_MODULES)));
    }
    return QDir::cleanPath(dir.absoluteFilePath(name + QStringLiteral(".so")));
}

} // namespace suffuse
