// Fewer nodes for spans of frozen segments: Gauss rules of the measure that the Level 0 nodes already are.
#pragma once

#include "model/style.h"

#include <array>
#include <vector>

namespace suffuse {

/// A Level 0 node in units of the span's spread, with what its segment carries: R, Y, B, opacity, ω.
struct SpanNode {
    double x = 0;
    double y = 0;
    double weight = 0;    ///< density at its centre
    double tolerance = 0; ///< density error that its segment lets pass
    std::array<double, 5> values{};
};

/// The nodes that stand for fine nodes [begin, end).
struct SpanWindow {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::vector<SpanNode> nodes;
};

/// Replaces `fine`, a run along a stroke in order, by fewer nodes whose sum differs by at most half the tolerance at the
/// points checked: windows of arc length get the n-point Gauss rule of their discrete measure (Lanczos, Golub-Welsch),
/// positions and values by projection on its orthonormal polynomials; a window that fails is halved. A window's nodes
/// depend on its fine nodes only; where windows are cut, on the run's arc length and `epsilon`, the tolerance relative
/// to the peak, rounded to a power of two.
std::vector<SpanWindow> mergeSpan(const std::vector<SpanNode> &fine, double epsilon);

} // namespace suffuse
