// Which SIMD instruction set the kernels use.
#pragma once

namespace suffuse {

/// Has Highway choose among all sets of this machine, or take that one which the environment names. Whoever chooses
/// kernels calls it before.
void useWantedSimd();

} // namespace suffuse
