// In which folder people look for a file, and where they save.
#pragma once

#include <QString>

namespace suffuse {

class Editor;

/// Where the painting lies, else where one lies that was opened or saved lately, else where pictures or documents lie.
QString folderNear(const Editor &editor);
/// A place for a file of that name: the same, but a folder in which one may write.
QString placeToSave(const Editor &editor, const QString &name);

} // namespace suffuse
