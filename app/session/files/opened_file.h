// Reads the file of a document that is to be worked on.
#pragma once

#include "model/formats/files.h"

namespace suffuse {

struct OpenedFile {
    QString path; ///< absolute
    LoadedDocument document;
    QByteArray hash; ///< SHA-256 of exactly the bytes that were read
};

/// As loadDocument; of a damaged file it returns all that is whole.
Result<OpenedFile> readOpenedFile(const QString &path);

} // namespace suffuse
