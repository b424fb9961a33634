// Reads the layers of OpenRaster files.
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"

namespace suffuse::ora {

/// The layers of an OpenRaster file (0.0.5) as groups that hold a picture each, in place: a pixel is a unit, folders
/// are groups, and names, opacities, modes, visibility and locks stay. The pictures are in the painting as they are in
/// the file, and whoever shows them decodes them. `leftOut` receives a sentence about what could not be taken, as
/// LoadedDocument has it. Errors are sentences without the file's name.
Result<Painting> readLayers(const QByteArray &bytes, QString &leftOut);

} // namespace suffuse::ora
