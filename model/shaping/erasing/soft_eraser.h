// The soft eraser: segments that take paint away, where a path comes over paint that is seen.
#pragma once

#include "model/brush/stroke_builder.h"
#include "model/painting/painting.h"
#include "model/shaping/erasing/paint_samples.h"

#include <set>
#include <unordered_map>

namespace suffuse {

/// How a soft eraser takes paint.
enum class SoftWay {
    Fade, ///< a share of what is seen, which gets paler
    Lift  ///< density: feathered paint gets paler, paint with a sharp edge draws in
};

/// The tip of a soft eraser. What it lays down spreads by the tip's own softness, whatever the paint has.
struct SoftTip {
    static constexpr double leastSoftness = 0.4, greatestSoftness = 2;

    double radius = 10;    ///< where lifted paint ends beside a path of full strength, canvas units
    double softness = 0.6; ///< the spread s of what takes away, radii
    /// (0, 1]. Of fading it is the share that is taken in the middle of the path; when lifting, paint is gone there
    /// from a half on.
    double strength = 1;
    SoftWay way = SoftWay::Lift;

    /// s. A tip that fades is no softer than that half of the paint is left at the radius, where strength saturates.
    double spread() const;
};

/// The peak of a fading density that takes a share q of the paint: −ln(1 − q). At most so much that nothing can be seen
/// (1/2048) within the radius less the spread.
double fadingPeak(double share, const SoftTip &tip);

/// The peak of a lifting density, for paint whose density is by `excess` over that at which it ends. `share`: of the
/// whole strength, q. Up to a half it is 2q: a half just reaches the middle, and what is feathered gets paler. Beyond,
/// it is e^{(2q − 1)²x}, x = (radius/s)²: the paint ends at (2q − 1) radii, whatever the softness.
double liftingPeak(double excess, double share, const SoftTip &tip);

/// One drag of the eraser over strokes. What has been taken at one place counts when the path comes by again: where
/// nothing is left, nothing more is lifted, and what fades takes its share once. Another drag takes its share of what is
/// left. The result depends on the samples, not on when one asks for it.
class SoftEraser {
public:
    /// For each group in a wash, that wash.
    using Washes = std::unordered_map<GroupId, const Group *>;
    /// `strokes`: those that it may touch, as they are without it, at document time T. The strokes of a wash are one:
    /// what fades them is laid once, on the one that is touched first.
    SoftEraser(const SoftTip &tip, const std::vector<StrokePtr> &strokes, Microseconds T, const Washes &washes = {});

    /// The pressure is a share of the strength.
    void add(const PenSample &sample);
    void finish();

    /// The strokes of which paint is taken so far.
    std::set<StrokeId> touched() const;
    /// One of the strokes, as it was given, with what takes paint away behind its segments; each part of the path that
    /// lies over its paint is a chain.
    Stroke erased(const Stroke &stroke) const;

private:
    /// A part of the path, no longer than the radius.
    struct PathPart {
        Cubic curve;        ///< canvas units
        double density = 0; ///< φˢ of a peak of 1
        double share = 0;   ///< of the strength
        Microseconds born = 0;
        Rect reach;
        double from = 0, to = 0; ///< arc length
        double peak = 0;         ///< of what fades, less what the path took here before
    };
    struct FoundPaint {
        std::size_t part = 0;
        double excess = 0;
    };
    struct SoughtStroke {
        PaintSamples samples;
        Rect reach;
        GroupId wash = 0;             ///< in which it is one with other strokes; 0: none
        std::vector<FoundPaint> hits; ///< in the order of the path
        std::size_t taken = 0;        ///< how many of them the samples know
    };

    void follow();
    void addParts(const Stroke &path, const Segment &segment);
    /// The peak of a part that fades, which the last one is not yet.
    double peakLeft(const PathPart &part) const;
    void seek(SoughtStroke &target, std::size_t from);
    /// A part of the path as a segment with a peak, as seen from the origin of a stroke.
    Segment segmentOf(const PathPart &part, double peak, Point origin) const;
    Segment taking(const FoundPaint &hit, Point origin) const;
    /// What a stroke's erasure is made of.
    std::vector<FoundPaint> hitsOf(const SoughtStroke &target) const;

    SoftTip m_tip;
    double m_sought; ///< so far from the path paint is looked for, canvas units
    std::unordered_map<GroupId, GroupId> m_washes;
    Microseconds m_time;
    StrokeBuilder m_builder;
    std::vector<StrokePtr> m_strokes; ///< until the path begins
    std::vector<SoughtStroke> m_targets;
    std::vector<PathPart> m_parts;
    std::size_t m_frozenParts = 0; ///< those that will not change any more
    int m_frozenSegments = 0;      ///< of the path: what they are made of
};

} // namespace suffuse
