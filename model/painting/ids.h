// Identities. A stroke keeps its id through every edit, undo and save, and values never point at each other.
#pragma once

#include <cstdint>

namespace suffuse {

using StrokeId = std::uint64_t; ///< unique in a painting, from 1; 0 means "none"
using GroupId = std::uint64_t;  ///< unique in a painting, from 1; 0 means "no group"

} // namespace suffuse
