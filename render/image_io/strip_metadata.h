#pragma once

#include "render/image_io/image_io.h"

namespace suffuse {

/// A PNG, JPEG or TIFF without what its pixels do not need: colour profiles, Exif, IPTC, XMP, comments. OpenImageIO 2.4
/// parses these before it looks at a pixel, and reads beyond its buffers if they are damaged. Other formats, and what
/// is not understood, come back unchanged.
QByteArray withoutMetadata(const QByteArray &bytes, ImageFormat format);

} // namespace suffuse
