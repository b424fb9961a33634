#pragma once

#include "model/painting/painting.h"

#include <QImage>

namespace suffuse {

/// A picture of a brush of ink that runs dry from right to left over a paper, drawn by the renderer on `size` device
/// pixels, `scale` of them a unit, with the paper's white. A null image if the renderer fails.
QImage paperPreview(const Paper &paper, QSize size, double scale);

} // namespace suffuse
