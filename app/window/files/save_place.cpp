#include "app/window/files/save_place.h"

#include "app/session/editor.h"
#include "app/session/settings/settings.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace suffuse {

namespace {

QString folderOf(const Editor &editor, bool writable)
{
    for (const QString &file : QStringList{editor.filePath(), editor.suggestedPath()} + settings::recentFiles()) {
        const QFileInfo folder(QFileInfo(file).absolutePath());
        if (!file.isEmpty() && folder.isDir() && (!writable || folder.isWritable()))
            return folder.filePath();
    }
    using Place = QStandardPaths;
    for (const auto place : {Place::PicturesLocation, Place::DocumentsLocation})
        if (const QFileInfo folder(Place::writableLocation(place)); folder.isDir())
            return folder.filePath();
    return QDir::homePath();
}

} // namespace

QString folderNear(const Editor &editor)
{
    return folderOf(editor, false);
}

QString placeToSave(const Editor &editor, const QString &name)
{
    return QDir(folderOf(editor, true)).filePath(name);
}

} // namespace suffuse
