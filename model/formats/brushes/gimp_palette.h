// Palettes as GIMP, Krita and Inkscape write them (.gpl).
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"

namespace suffuse {

struct GimpPalette {
    QString name;
    std::vector<Swatch> swatches; ///< opaque, since the format has no opacity
};

/// Reads a palette of at most 1 MiB and 10,000 colours. Errors name the line and the remedy.
Result<GimpPalette> readGimpPalette(const QByteArray &bytes, const QString &fileName);
/// Writes the colours as 8-bit sRGB, without their opacity.
QByteArray writeGimpPalette(const GimpPalette &palette);

} // namespace suffuse
