// Where people look for files that are no paintings.
#pragma once

#include <QString>

namespace suffuse {

/// The folder in which a file of this kind was chosen last ("picture", "brush", "palette"), else that of pictures, else that of
/// documents, else home; never where the program happens to have been started.
QString usualFolder(const QString &kind);
/// A file of this kind was chosen.
void keepUsualFolder(const QString &kind, const QString &path);

} // namespace suffuse
