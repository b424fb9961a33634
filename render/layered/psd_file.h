// Writes Photoshop files (Adobe Photoshop File Formats Specification, version 1, "PSD").
#pragma once

#include "render/layered/raster_layers.h"

#include <QString>

namespace suffuse {

/// Sides are at most this long, pixels, in files of version 1.
inline constexpr int largestPsdSide = 30'000;

/// Writes the layers and the picture. Opacities of layers become whole 255ths, as such files have them. The target is
/// replaced when all is on disk, or left as it was. Errors name the file and the remedy: sides that are too long, and
/// files over 2 GB, among them.
Result<LayeredStats> writePsd(const QString &path, const LayeredRequest &request, Renderer &renderer, Renderer &groups);

} // namespace suffuse
