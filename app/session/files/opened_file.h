// A document's file, read to be worked on.
#pragma once

#include "model/formats/files.h"

namespace suffuse {

struct OpenedFile {
    LoadedDocument document;
    QByteArray hash; ///< SHA-256 of the very bytes that were read
};

/// As loadDocument; a damaged file gives what is whole of it.
Result<OpenedFile> readOpenedFile(const QString &path);

} // namespace suffuse
