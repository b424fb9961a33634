// Whether paint looks like one colour.
#pragma once

#include "model/colour/colour_uses.h"

namespace suffuse {

/// Whether people call the colours of the parts one colour, that of the usual one among them. Within a stroke a brush
/// strays from its colour to make its paint lively; how far that looks depends on the colour, and it is one colour all
/// the same. Colours of several strokes are one if they look alike.
bool looksLikeOne(const ColourParts &parts, const Colour &usual);

} // namespace suffuse
