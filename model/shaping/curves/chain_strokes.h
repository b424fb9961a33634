// Strokes of the chains of a stroke.
#pragma once

#include "model/shaping/curves/chains.h"

namespace suffuse {

/// A stroke for each chain that lays paint, all with the same id. Chains that enclose a part of the same area stay
/// together where the stroke is filled, such as those around a hole. Each takes along what takes paint away and may
/// reach it when all is dry. `sources`: for all of their segments, one stroke after the other, the index of that each
/// came from.
std::vector<Stroke> strokesOfChains(const Stroke &stroke, std::vector<int> *sources = nullptr);

} // namespace suffuse
