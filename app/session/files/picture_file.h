// Pictures that a painting takes in: its paper's and its underlay's.
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"

namespace suffuse {

/// The file as it is, at most 64 MB; whether it is a picture shows when it is decoded.
Result<EncodedImage> readPictureFile(const QString &path);

} // namespace suffuse
