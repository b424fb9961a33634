// Parts of strokes that are reshaped: runs of segments that follow each other in a chain.
#pragma once

#include "model/shaping/chains.h"

namespace suffuse {

/// Of the two directions at a node that is no corner, at least (`cornersOf`: about a degree).
inline constexpr double smoothCosine = 0.9998;

/// The longest runs of chosen segments within chains, in order. `chosen`: for each segment whether it is; empty: all
/// are.
std::vector<Chain> runsOf(const Stroke &stroke, const std::vector<bool> &chosen);

/// A run with its curves as offsets from the stroke's origin and the arc length at each of its nodes.
struct RunPath {
    Chain run;
    std::vector<Cubic> curves;
    std::vector<double> lengths; ///< from the run's start to node k; one more than there are curves
    bool joinsBefore = false;    ///< the chain goes on before the run, or after it
    bool joinsAfter = false;

    RunPath(const Stroke &stroke, const Chain &run);
    double total() const { return lengths.back(); }
};

/// Writes curves to a stroke's segments: they begin at `first`, and where two follow each other in a chain they meet in
/// the same float32 numbers.
void writeCurves(Stroke &stroke, int first, const std::vector<Cubic> &curves);

/// 0 up to 0, 1 from 1 on, and smooth between (3x² − 2x³); its slope.
double smoothStep(double x);
double smoothStepSlope(double x);

} // namespace suffuse
