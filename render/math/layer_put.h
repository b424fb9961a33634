// What has to be known to put the picture of a layer on what lies below it.
#pragma once

#include "model/painting/blend.h"

namespace suffuse {

/// How a layer is put on what lies below.
struct LayerPut {
    BlendMode mode = BlendMode::Normal;
    float opacity = 1;
    bool opaque = false; ///< whether below there is the canvas, which lets nothing through
    float bare[3]{};     ///< RGB of what is there without any paint
};

} // namespace suffuse
