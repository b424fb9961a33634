// Paintings that come along, and the small pictures that documents keep of themselves.
#pragma once

#include <QImage>
#include <QStringList>

namespace suffuse {

/// The files of the sample paintings, by their names: where the program is installed, or in the source folder. None
/// where they are missing.
QStringList sampleFiles();
/// What a painting that comes along is called, in the language of the program.
QString sampleTitle(const QString &path);

/// The preview that a document keeps (at most 256 pixels a side), read from the start of its file. Null where there is
/// none, or the file is no document.
QImage keptPreview(const QString &path);
/// The same or, where a painting keeps none and its file is small, one that is drawn now, at most `side` pixels wide
/// and high. Any thread.
QImage previewOf(const QString &path, int side);

} // namespace suffuse
