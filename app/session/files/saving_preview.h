#pragma once

#include "model/painting/painting.h"

#include <QImage>

namespace suffuse {

/// The whole canvas when all is dry, its longer side `side` pixels; null where nothing can be drawn. Any thread.
QImage previewImage(const PaintingPtr &painting, int side);

} // namespace suffuse
