// Writes OpenRaster files (openraster.org, 0.0.5).
#pragma once

#include "render/layered/raster_layers.h"

#include <QString>

namespace suffuse {

/// Writes the layers, the picture and the painting itself, which `readDocument` gives back bit by bit. The target is
/// replaced when all is on disk, or left as it was. Errors name the file and the remedy.
Result<LayeredStats> writeOpenRaster(const QString &path, const LayeredRequest &request, Renderer &renderer,
                                     Renderer &groups);

} // namespace suffuse
