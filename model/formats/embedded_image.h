// Images inside a painting: encoded file bytes, in the text form as data: URLs.
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"

namespace suffuse {

/// "image/png" and so on, from the first bytes; empty unless it is PNG, JPEG, TIFF, WebP or EXR.
QString imageMediaType(const QByteArray &bytes);
/// Refuses bytes that are no image that is supported, or more than 64 MB. The message has no file name or path.
Result<EncodedImage> checkedImage(const QByteArray &bytes);
/// The image of an "image" member: "data:…;base64,…", or the path of a file relative to the folder of `fileName`.
/// The message has no file name or path.
Result<EncodedImage> imageFromText(const QString &text, const QString &fileName);
/// "data:image/png;base64,…"
QByteArray imageToText(const QByteArray &bytes);

} // namespace suffuse
