#include "app/widgets/asking/usual_folder.h"

#include "app/session/settings/settings.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace suffuse {

namespace {

QString keyOf(const QString &kind)
{
    return QStringLiteral("folders/") + kind;
}

} // namespace

QString usualFolder(const QString &kind)
{
    using Place = QStandardPaths;
    for (const QString &folder : {settings::store().value(keyOf(kind)).toString(), Place::writableLocation(Place::PicturesLocation),
                                  Place::writableLocation(Place::DocumentsLocation)})
        if (!folder.isEmpty() && QFileInfo(folder).isDir())
            return folder;
    return QDir::homePath();
}

void keepUsualFolder(const QString &kind, const QString &path)
{
    settings::store().setValue(keyOf(kind), QFileInfo(path).absolutePath());
}

} // namespace suffuse
