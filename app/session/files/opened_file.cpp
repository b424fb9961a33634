#include "app/session/files/opened_file.h"

#include "app/session/files/samples.h"
#include "model/formats/messages.h"
#include "model/formats/picture_links.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace suffuse {

Result<OpenedFile> readOpenedFile(const QString &path)
{
    QFile file(path);
    QByteArray bytes;
    if (QFileInfo(path).isFile() && file.size() <= largestFile && file.open(QIODevice::ReadOnly))
        bytes = file.readAll();
    // Where there is nothing to read, loadDocument's error says why.
    Result<LoadedDocument> document = bytes.isEmpty() ? loadDocument(path) : readDocument(bytes, path);
    if (!document)
        return Error{document.error()};
    document->painting = withAbsoluteLinks(std::move(document->painting), QFileInfo(path).absolutePath());
    const QString absolute = QFileInfo(path).absoluteFilePath();
    return OpenedFile{absolute, std::move(*document), QCryptographicHash::hash(bytes, QCryptographicHash::Sha256),
                      sampleFiles().contains(QDir::cleanPath(absolute))};
}

} // namespace suffuse
