// Images within PDF files.
#pragma once

#include "model/formats/pdf/pdf_objects.h"
#include "render/drawing/drawn_picture.h"

namespace suffuse {

/// Adds an image that loses nothing of its file, and returns its object. PNGs of 8 bits and JPEGs stay as they are
/// packed; others become red, green and blue of 8 bits, with alpha as a mask. It fails if the file cannot be read.
Result<int> addImage(pdf::Objects &objects, const DrawnImage &image);

} // namespace suffuse
