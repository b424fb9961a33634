#pragma once

#include "render/image_io/image_io.h"

namespace suffuse {

/// Whether the header of a PNG, WebP or EXR file asks for more than an image may have. Their decoders take memory for
/// what a header says when they open the file, so this comes first; of the other formats they look before they take.
bool declaresTooMuch(const QByteArray &bytes, ImageFormat format);

} // namespace suffuse
