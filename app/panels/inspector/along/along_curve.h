// A curve over the arc length of runs, and what it makes of the values there.
#pragma once

#include "app/panels/inspector/along/stroke_run.h"
#include "app/widgets/curves/curve_editor.h"

#include <optional>

namespace suffuse {

/// The axis of a quantity: values ↔ [0, 1].
struct ValueAxis {
    double low = 0, high = 1;
    bool logarithmic = false;
    bool reversed = false;   ///< whether the shown number falls while the value grows
    bool endsInZero = false; ///< of a logarithmic one, whether its end stands for 0 and not for `low`
    /// Makes the axis longer where the value lies beyond it.
    void include(double value);
    double toShare(double value) const;
    double toValue(double place) const;
};

/// A curve, and the axis that it belongs to. Values change by what the curve differs from `from`, the curve of what was
/// there, so that what is finer than its points stays. Where the curve was drawn over, or where there is no `from`,
/// they are the curve's.
struct CurveAlong {
    PlaceCurve curve;
    ValueAxis axis;
    std::optional<PlaceCurve> from;

    double valueAt(double place, double old) const;
    /// Whether it needs short segments.
    bool varies() const;
    /// Makes the axis longer where a value lies beyond it; the knots keep their values.
    void growAxis(double value);
    /// Changes the values of all knots.
    void change(const ValueChange &change);
};

/// A curve through points, or a drawn one. `drawn`: 1 where it takes the place of what was there, 0 where it goes on
/// from it.
PlaceCurve pointsThrough(const std::vector<Point> &points, double drawn);
PlaceCurve drawnThrough(const std::vector<Point> &points, double drawn);

/// The values that runs have, as a curve of few points that goes on from what is there.
PlaceCurve presentCurve(const StrokeRuns &runs, Quantity quantity, const ValueAxis &axis);

} // namespace suffuse
