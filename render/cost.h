// What a picture is going to cost, roughly, before anything of it is computed.
#pragma once

#include "render/renderer.h"

namespace suffuse {

/// How long one core takes for a picture from its segments, in seconds, within a factor of about three: the segments
/// become nodes, and each stroke is evaluated at the pixels of the boxes of its segments' influence.
double cpuSeconds(const RenderRequest &request);

} // namespace suffuse
