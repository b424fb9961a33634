#pragma once

#include "render/image_io/image_io.h"

namespace suffuse {

/// Whether the header of a PNG, WebP or EXR file asks for more than an image may have. Their decoders allocate what a
/// header says when they open the file, so this must be checked before. Decoders of the other formats look before they
/// allocate.
bool declaresTooMuch(const QByteArray &bytes, ImageFormat format);

} // namespace suffuse
