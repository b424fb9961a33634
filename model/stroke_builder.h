// From pen samples to a stroke of cubic segments.
#pragma once

#include "model/stroke.h"
#include "model/stroke_fit.h"

#include <vector>

namespace suffuse {

/// One report of the pointer, in canvas units.
struct PenSample {
    Point position;
    Microseconds time = 0; ///< document time
    float pressure = 1;    ///< [0, 1]
};

/// Interval at which the spline's knots are taken along the stroke's time.
inline constexpr Microseconds samplingInterval = 1'000'000 / 60;

/// Builds a stroke while it is drawn: a frozen prefix of segments that no longer change and a live tail.
///
/// Samples come at the device's pace; knots are taken every `samplingInterval` (linearly between samples; where samples
/// are sparser, at the samples), duplicates and zero-pressure blips are dropped, and a C² cubic spline is fitted
/// through position, colour and density in time (natural ends, Eigen). Where attributes vary along a segment it is
/// split until its length is at most s/2. A stroke shorter than 0.1 s is a tap: one segment 0.1 s long whose φˢ makes
/// its peak pk; one shorter than 2 s is raised likewise, while it is drawn too, so that nothing jumps when the pen
/// lifts (docs/strokes.md). The stroke depends on the samples only.
class StrokeBuilder {
public:
    /// The brush's values must be in their domains (model/validate.h).
    StrokeBuilder(Brush brush, StrokeId id);

    /// Samples may repeat, stand still or go back in time (then they count as simultaneous). Those that are not finite
    /// or farther out than 3.3e11 units are ignored.
    void add(const PenSample &sample);
    /// The pen lifts; no more samples.
    void finish();

    /// The stroke so far; null before the first sample. Frozen segments are equal from call to call.
    StrokePtr stroke() const;
    /// Segments that will not change any more.
    int frozenSegments() const;

private:
    /// Some devices have no pressure and report 0: which kind this is shows with the samples.
    enum class Pressure { Unknown, Real, None };

    void start(const PenSample &sample);
    void take(const PenSample &sample, double pressure);
    double parameterStep(const Knot &next) const;
    void addKnot(const Knot &knot);
    void settle();
    double appendTail(std::vector<Segment> &segments) const;
    bool isStep(Point from, Point to) const;
    Segment dot() const;

    Brush m_brush;
    Stroke m_stroke; ///< with the settled segments, not raised
    std::vector<Knot> m_knots;
    Knot m_last;           ///< the newest sample that moved; at or after the last knot
    double m_nextKnot = 0; ///< parameter
    double m_greatestDensity = 0;
    Pressure m_pressure = Pressure::Unknown;
    int m_zeroSamples = 0;
    std::size_t m_settledKnot = 0; ///< segments up to this knot do not change
    double m_settledLength = 0;    ///< their arc length, units
    bool m_finished = false;
};

/// The whole stroke at once; null if there is no sample.
StrokePtr buildStroke(const Brush &brush, StrokeId id, const std::vector<PenSample> &samples);

} // namespace suffuse
