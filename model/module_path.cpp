#include "model/module_path.h"

#include "model/environment.h"

#include <QCoreApplication>
#include <QDir>

namespace suffuse {

QString modulePath(const QString &name)
{
    const QString folder = QString::fromStdString(environment::value(environment::Variable::ModuleFolder));
    const QDir dir(folder.isEmpty() ? QCoreApplication::applicationDirPath() + QStringLiteral("/../lib/suffuse")
                                    : folder);
    return QDir::cleanPath(dir.absoluteFilePath(name + QStringLiteral(".so")));
}

} // namespace suffuse
