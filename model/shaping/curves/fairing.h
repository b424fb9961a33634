// Smooths curves: wiggles shorter than a length go, slower bends stay.
#pragma once

#include "model/shaping/curves/runs.h"

namespace suffuse {

/// Smooths the chosen segments (see `runsOf`) by convolving them along the arc length with the kernel 2g − g∗g, where g
/// is a Gaussian of standard deviation `length` (canvas units). It removes the share (1 − exp(−(length·k)²/2))² of a
/// wiggle with the wave number k. Ends of chains, corners and the ends of a run stay where they are, and a run goes on
/// from its neighbours in their direction. Nodes move and handles turn; values, times and the kinds of nodes stay.
Stroke smoothed(const Stroke &stroke, double length, const std::vector<bool> &chosen = {});

} // namespace suffuse
