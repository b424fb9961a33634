#include "model/formats/ora/ora_parts.h"

#include "model/formats/messages.h"
#include "model/formats/ora/zip_parts.h"

#include <QCryptographicHash>

#include <optional>

namespace suffuse::ora {

QByteArray hashOfPicture(const QByteArray &png)
{
    return QCryptographicHash::hash(png, QCryptographicHash::Sha256).toHex();
}

bool isOpenRaster(const QByteArray &bytes)
{
    return bytes.startsWith("PK\x03\x04") && bytes.mid(30, 8 + mimeType.size()) == "mimetype" + mimeType;
}

Result<EmbeddedPainting> readEmbedded(const QByteArray &bytes)
{
    const ZipParts parts(bytes);
    if (!parts.isOpen())
        return Error{FileMessages::tr("This OpenRaster file is damaged: it has no list of its parts.")};
    constexpr qint64 mostOfPainting = qint64(1) << 29, mostOfPicture = qint64(1) << 30;
    EmbeddedPainting out;
    const std::optional<QByteArray> document = parts.part(paintingPart, mostOfPainting);
    if (!document)
        return out;
    out.document = *document;
    const std::optional<QByteArray> hash = parts.part(pictureHashPart, 1024);
    const std::optional<QByteArray> picture = parts.part(picturePart, mostOfPicture);
    out.isChanged = !hash || !picture || hashOfPicture(*picture) != *hash;
    return out;
}

} // namespace suffuse::ora
