#pragma once

#include "model/painting/painting.h"

#include <QImage>

namespace suffuse {

/// A picture of the whole canvas when all is dry, with `side` pixels on its longer side. Null where nothing can be
/// drawn. Any thread.
QImage previewImage(const PaintingPtr &painting, int side);

} // namespace suffuse
