// What the tests of the measuring code measure.
#pragma once

#include "render/bench/generator.h"

namespace suffuse {

inline bench::PaintingOptions smallOptions()
{
    bench::PaintingOptions o;
    o.strokes = 12;
    o.segments = 240;
    o.width = 256;
    o.height = 192;
    return o;
}

} // namespace suffuse
