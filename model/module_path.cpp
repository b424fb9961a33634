#include "model/module_path.h"

#include "model/environment.h"

#include <QCoreApplication>
#include <QDir>

namespace suffuse {

QString modulePath(const QString &name)
{
    QDir dir(QString::fromStdString(environment::value(environment::Variable::ModuleFolder)));
    if (!environment::isSet(environment::Variable::ModuleFolder)) {
        const QDir programs(QCoreApplication::applicationDirPath());
        dir.setPath(programs.absoluteFilePath(QStringLiteral("../lib/suffuse")));
        if (!dir.exists())
            dir.setPath(programs.absoluteFilePath(QStringLiteral(SUFFUSE_MODULES)));
    }
    return QDir::cleanPath(dir.absoluteFilePath(name + QStringLiteral(".so")));
}

} // namespace suffuse
