// How places of a stroke are named.
#pragma once

#include "model/painting/ids.h"

#include <compare>

namespace suffuse {

/// A node of a stroke of n segments. Node k is the start of segment k, node n the end of the last one, and the ends of
/// other chains follow (model/shaping/curves/chains.h).
struct NodeRef {
    StrokeId stroke = 0;
    int node = 0;
    friend auto operator<=>(const NodeRef &, const NodeRef &) = default;
};

/// A place on a stroke's curve: the parameter p in [0, 1] of a segment.
struct CurvePlace {
    int segment = 0;
    double p = 0;
    friend auto operator<=>(const CurvePlace &, const CurvePlace &) = default;
};

} // namespace suffuse
