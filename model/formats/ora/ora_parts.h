// What an OpenRaster file that this program wrote has besides its layers: the painting itself.
#pragma once

#include "model/result.h"

#include <QByteArray>
#include <QString>

namespace suffuse::ora {

inline const QByteArray mimeType = QByteArrayLiteral("image/openraster");
inline const QString stackPart = QStringLiteral("stack.xml");
inline const QString picturePart = QStringLiteral("mergedimage.png");
/// The painting as a .suffuse document.
inline const QString paintingPart = QStringLiteral("suffuse/painting.suffuse");
/// `hashOfPicture` of the merged picture as it was written, by which changes of other programs are seen.
inline const QString pictureHashPart = QStringLiteral("suffuse/mergedimage.sha256");

/// SHA-256 in hexadecimal digits.
QByteArray hashOfPicture(const QByteArray &png);

/// Whether bytes begin as an OpenRaster file does.
bool isOpenRaster(const QByteArray &bytes);

/// The painting in the file, as a .suffuse document.
struct EmbeddedPainting {
    QByteArray document;    ///< empty if there is none
    bool isChanged = false; ///< whether another program changed the picture since
};
/// Errors are sentences without the file's name.
Result<EmbeddedPainting> readEmbedded(const QByteArray &bytes);

} // namespace suffuse::ora
