// Reads the pictures that a painting takes in: its paper's and its underlay's.
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"

namespace suffuse {

/// The bytes of a file, at most 64 MB. Only decoding shows whether they are a picture.
Result<EncodedImage> readPictureFile(const QString &path);

} // namespace suffuse
