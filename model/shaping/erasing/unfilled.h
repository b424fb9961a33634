// Strokes without the fills that they had.
#pragma once

#include "model/painting/stroke.h"

namespace suffuse {

/// The stroke without its fill. If it was its fill alone, its outline gets paint, in the fill's colour and wide enough
/// to be seen.
Stroke withoutFill(const Stroke &stroke);

} // namespace suffuse
