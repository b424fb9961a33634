// Images inside a painting: encoded bytes of files, which the text form writes as data: URLs.
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"

#include <optional>
#include <utility>

namespace suffuse {

/// The media type, "image/png" and so on, by the first bytes. It is empty unless they are PNG, JPEG, TIFF, WebP or EXR.
QString imageMediaType(const QByteArray &bytes);
/// Refuses bytes that are no supported image, or more than 64 MB. The message has no file name and no path.
Result<EncodedImage> checkedImage(const QByteArray &bytes);
/// Width and height in pixels of a PNG, or of a JPEG that says nothing of its direction, by its head. No value for
/// other images, for damaged ones, and for those that are larger than a picture of a painting.
std::optional<std::pair<int, int>> pixelsOf(const QByteArray &image);
/// The image of an "image" member: "data:…;base64,…", or the path of a file relative to the folder of `fileName`. The
/// message has no file name and no path.
Result<EncodedImage> imageFromText(const QString &text, const QString &fileName);
/// The image as "data:image/png;base64,…".
QByteArray imageToText(const QByteArray &bytes);

} // namespace suffuse
