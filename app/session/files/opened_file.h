// Reads the file of a document that is to be worked on.
#pragma once

#include "model/formats/files.h"

namespace suffuse {

struct OpenedFile {
    QString path; ///< absolute
    LoadedDocument document;
    QByteArray hash; ///< SHA-256 of exactly the bytes that were read
    bool isSample = false; ///< It came with the program: it opens untitled, so that saving does not replace it.
};

/// As loadDocument; of a damaged file it returns all that is whole. Links to pictures are absolute, since the painting
/// may be saved elsewhere.
Result<OpenedFile> readOpenedFile(const QString &path);

} // namespace suffuse
