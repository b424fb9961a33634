// The parts of strokes that are reshaped: runs of segments that follow each other in a chain.
#pragma once

#include "model/shaping/curves/chains.h"

namespace suffuse {

/// The least cosine between the two directions at a node that is no corner (as in `cornersOf`: about a degree).
inline constexpr double smoothCosine = 0.9998;

/// Whether the curve's direction breaks between a segment and the next one, so that the node between them is a corner.
bool breaksBetween(const Segment &before, const Segment &after);

/// The longest runs of chosen segments within chains, in order. `chosen` says for each segment whether it is chosen; if
/// it is empty, all are.
std::vector<Chain> runsOf(const Stroke &stroke, const std::vector<bool> &chosen);

/// Which segments are meant where a stroke is selected as a whole: those that lay paint. What takes paint away keeps
/// its values and its place, unless the stroke has nothing else. If it is empty, all are.
std::vector<bool> meantOfWhole(const Stroke &stroke);

/// The runs, divided at their corners.
std::vector<Chain> smoothRunsOf(const Stroke &stroke, const std::vector<bool> &chosen);

/// A run with its curves as offsets from the stroke's origin and the arc length at each of its nodes.
struct RunPath {
    Chain run;
    std::vector<Cubic> curves;
    std::vector<double> lengths; ///< from the run's start to node k; one more than there are curves
    /// whether the chain goes on before the run; the other says whether it goes on behind it
    bool joinsBefore = false;
    bool joinsAfter = false;

    RunPath(const Stroke &stroke, const Chain &run);
    double total() const { return lengths.back(); }
};

/// Writes curves to a stroke's segments from `first` on. Where two of them follow each other in a chain, they meet in
/// the same float32 numbers.
void writeCurves(Stroke &stroke, int first, const std::vector<Cubic> &curves);

/// A function that is 0 up to 0, 1 from 1 on, and smooth in between (3x² − 2x³), and its slope.
double smoothStep(double x);
double smoothStepSlope(double x);

} // namespace suffuse
