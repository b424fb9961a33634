// Makes strokes of cubic segments from samples of the pen.
#pragma once

#include "model/painting/stroke.h"
#include "model/brush/stroke_fit.h"

#include <vector>

namespace suffuse {

/// One report of the pointer, in canvas units.
struct PenSample {
    Point position;
    Microseconds time = 0; ///< document time
    float pressure = 1;    ///< [0, 1]
    float tilt = 0;        ///< [0, 1] from upright to 60° or more
};

/// Builds a stroke while it is drawn. It has a frozen prefix of segments, which no longer change, and a live tail.
/// Samples come at the device's pace. Knots are taken at the brush's interval, linearly between samples or, where
/// samples are sparser, at the samples. Duplicates and outliers without pressure are dropped. A C² cubic spline is
/// fitted through position and what the brush paints, in time (natural ends, Eigen). Where that varies along a segment,
/// the segment is split until its length is at most s/2.
/// A stroke shorter than 0.1 s is a tap: one segment 0.1 s long whose φˢ makes its peak pk. A stroke shorter than 2 s
/// is raised likewise, also while it is drawn, so that nothing jumps when the pen lifts (docs/strokes.md). The stroke
/// depends only on brush, id and samples; what is random in it depends on the id.
class StrokeBuilder {
public:
    /// Begins a stroke. The brush's values must be in their domains (model/painting/validate.h).
    StrokeBuilder(Brush brush, StrokeId id);

    /// Adds a sample. Samples may repeat, stand still or go back in time (then they count as simultaneous). Those that
    /// are not finite or farther out than 3.3e11 units are ignored.
    void add(const PenSample &sample);
    /// Ends the stroke, since the pen lifts. No samples may follow.
    void finish();

    /// The stroke so far; null before the first sample. Frozen segments are equal from call to call.
    StrokePtr stroke() const;
    /// The number of segments that will not change any more.
    int frozenSegments() const;

private:
    /// Some devices have no pressure and report 0. Which kind this is becomes clear with the samples.
    enum class Pressure { Unknown, Real, None };

    void start(const PenSample &sample);
    void take(const PenSample &sample, double pressure);
    void addSample(Knot &next);
    double parameterStep(const Knot &next) const;
    void addKnot(const Knot &knot);
    double speedAt(Microseconds elapsed, double way);
    void fix();
    void settle();
    double appendTail(std::vector<Segment> &segments) const;
    bool mayBeRaised() const;
    bool isStep(Point from, Point to) const;
    Segment dot() const;

    Brush m_brush;
    Stroke m_stroke; ///< with the settled segments, which are not raised here
    std::vector<Knot> m_knots;
    Knot m_last;           ///< the newest sample that moved, at or after the last knot
    double m_nextKnot = 0; ///< parameter
    Knot m_strongest;      ///< the sample with the greatest φˢ, which a tap has
    double m_interval;     ///< µs
    double m_speed = 0;    ///< smoothed, spreads a second
    Pressure m_pressure = Pressure::Unknown;
    int m_zeroSamples = 0;
    std::size_t m_fixedKnot = 0;   ///< derivatives before this knot do not change
    std::size_t m_settledKnot = 0; ///< segments up to this knot do not change
    double m_settledLength = 0;    ///< their arc length, units
    bool m_finished = false;
};

/// Builds a whole stroke at once; null if there is no sample.
StrokePtr buildStroke(const Brush &brush, StrokeId id, const std::vector<PenSample> &samples);

} // namespace suffuse
