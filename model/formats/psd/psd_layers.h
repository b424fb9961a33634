// Reads the layers of Photoshop files (Adobe Photoshop File Formats Specification, version 1, "PSD").
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"

namespace suffuse::psd {

/// Whether bytes begin as a Photoshop file does.
bool isPsd(const QByteArray &bytes);

/// The layers of a file of 8 or 16 bits, RGB or grey, as groups that hold a picture each, in place: a pixel is a unit,
/// and names, opacities, modes, clipping and visibility stay. Masks of layers are applied. A file without layers is one
/// layer. `leftOut` receives a sentence about what could not be taken, as LoadedDocument has it. Errors are sentences
/// without the file's name.
Result<Painting> readLayers(const QByteArray &bytes, QString &leftOut);

} // namespace suffuse::psd
