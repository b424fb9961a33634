// Strokes that a drag has lifted off the painting.
#pragma once

#include "model/painting/painting.h"
#include "model/shaping/transform.h"
#include "render/view.h"

#include <memory>

namespace suffuse {

/// Strokes lifted off a painting, at a moment and in a view.
struct Lift {
    PaintingPtr from;
    PaintingPtr rest;   ///< the painting without them
    PaintingPtr lifted; ///< they alone
    Microseconds time = 0;
    View view;
};
using LiftPtr = std::shared_ptr<const Lift>;

/// How what is lifted lies in a frame.
struct Floating {
    LiftPtr lift;
    Affine map; ///< canvas units
    /// The frame's painting has it so: an exact frame may follow. Else it has not heard of the map yet.
    bool settled = false;
};

} // namespace suffuse
