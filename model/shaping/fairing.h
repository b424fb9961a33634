// Smoothing a curve: what wiggles faster than a length goes, what bends slower stays.
#pragma once

#include "model/shaping/runs.h"

namespace suffuse {

/// The chosen segments (`runsOf`) faired: convolved along the arc length with the kernel 2g − g∗g, g a Gaussian of
/// standard deviation `length` (canvas units), which takes a share of (1 − exp(−(length·k)²/2))² of what wiggles with
/// the wave number k. Ends of chains, corners and the ends of a run stay where they are, and a run goes on from its
/// neighbours in their direction. Nodes move and handles turn; values, times and the kinds of nodes stay.
Stroke smoothed(const Stroke &stroke, double length, const std::vector<bool> &chosen = {});

} // namespace suffuse
