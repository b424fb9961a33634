// How values that differ from segment to segment change together, so that what varies among them stays.
#pragma once

#include "model/document/document.h"

#include <functional>
#include <vector>

namespace suffuse {

/// A change of several values at once: quantities that count by ratios (D, φ, t_max) are multiplied, others (shares,
/// angles) are added to. Results stay within [least, greatest].
struct ValueChange {
    enum Kind { Scale, Shift };
    Kind kind = Scale;
    double amount = 1; ///< the factor, or the difference
    double least = 0;
    double greatest = 1;

    /// The amount that changes nothing.
    static double neutral(Kind kind) { return kind == Scale ? 1 : 0; }
    double applied(double value) const;
};

/// Whether each of the segments has the value that `change` makes of the one that it had in `before`. Segments of
/// locked strokes do not count, since nothing changes them.
bool isChangedBy(const Painting &now, const Painting &before, const std::vector<SegmentRef> &segments,
                 const std::function<float(const Segment &)> &valueOf, const ValueChange &change);

} // namespace suffuse
