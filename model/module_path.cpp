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
    if (folder.isEmpty())
        folder = QCoreApplication::applicationDirPath() + QStringLiteral("/../lib/suffuse");
    const QDir dir(folder);
    return QDir::cleanPath(dir.absoluteFilePath(name + QStringLiteral(".so")));
}

} // namespace suffuse
