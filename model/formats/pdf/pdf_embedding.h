// The paintings within a PDF file of them, so that what was drawn for others can be opened again as it is.
#pragma once

#include "model/formats/pdf/pdf_objects.h"

#include <QByteArrayList>

namespace suffuse::pdf {

/// Whether bytes begin as a PDF file does.
bool isPdf(const QByteArray &bytes);

/// Attaches the documents of the pages' paintings, in the order of pages. Returns what the catalogue says of them.
QByteArray attach(Objects &objects, const QByteArrayList &documents);
/// The file of objects with a sum over all of it, by which changes of other programs are seen. It fails as
/// `Objects::file` does.
Result<QByteArray> sealedFile(const Objects &objects, const std::atomic<bool> *cancel = nullptr);

/// The painting of the first page, as a .suffuse document.
struct AttachedPainting {
    QByteArray document;    ///< empty if there is none
    int count = 0;          ///< how many paintings there are
    bool isChanged = false; ///< whether another program changed the file since
};
/// Errors are sentences without the file's name: the file is damaged, or the module is missing.
Result<AttachedPainting> readAttached(const QByteArray &bytes);

} // namespace suffuse::pdf
