// The formats of layered files, told from each other by their endings.
#pragma once

#include "render/layered/raster_layers.h"

#include <QString>

namespace suffuse {

enum class LayeredFormat : std::uint8_t {
    None,       ///< no layered file
    OpenRaster, ///< .ora
    Photoshop   ///< .psd
};

/// The format by a path's ending.
LayeredFormat layeredFormatFor(const QString &path);

/// Writes a layered file in the format of its ending (`writeOpenRaster`, `writePsd`).
Result<LayeredStats> writeLayered(const QString &path, const LayeredRequest &request, Renderer &renderer,
                                  Renderer &groups);

} // namespace suffuse
