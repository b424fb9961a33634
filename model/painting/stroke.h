#pragma once

#include "model/painting/fill.h"
#include "model/painting/ids.h"
#include "model/painting/picture.h"
#include "model/painting/segment.h"

#include <QString>

#include <memory>

namespace suffuse {

/// A stroke as a value. Paintings share strokes as `StrokePtr`; an edit makes a new one with the same id.
/// A stroke has one or more chains. Within a chain, segment k + 1 starts where segment k ends, in equal float32
/// numbers.
struct Stroke {
    StrokeId id = 0;
    QString name;
    GroupId group = 0;
    bool visible = true;
    bool locked = false;
    Style style;
    Mix mix;
    Point origin;                  ///< the control points of the segments are offsets from it
    QString brush;                 ///< the name of the preset that it was painted with; may be empty
    std::vector<Segment> segments; ///< at least one
    SharedFill fill;               ///< what lies within the segments, or none
    SharedPicture picture;         ///< what it is painted with in place of its colours, or none

    friend bool operator==(const Stroke &, const Stroke &) = default;

    /// Whether a segment begins a chain.
    bool beginsChain(std::size_t segment) const { return segment == 0 || segments[segment].start; }
    /// Whether some of its segments take paint away.
    bool hasErasure() const
    {
        return std::any_of(segments.begin(), segments.end(), [](const Segment &s) { return s.takesPaint(); });
    }
    /// Whether some of its segments make its paint paler.
    bool hasFade() const
    {
        return std::any_of(segments.begin(), segments.end(), [](const Segment &s) { return s.fade; });
    }
    /// Whether some of its segments lay paint: others have nothing to take away from.
    bool laysPaint() const
    {
        return std::any_of(segments.begin(), segments.end(), [](const Segment &s) { return !s.takesPaint(); });
    }
    const Style &styleOf(const Segment &s) const { return s.style ? *s.style : style; }
    Cubic cubicOf(const Segment &s) const
    {
        return {{origin + s.bezier[0], origin + s.bezier[1], origin + s.bezier[2], origin + s.bezier[3]}};
    }
    Microseconds born() const
    {
        Microseconds t = segments.empty() ? 0 : segments.front().born;
        for (const Segment &s : segments)
            t = std::min(t, s.born);
        return fill ? std::min(t, fill->born) : t;
    }
    Microseconds driesAt() const
    {
        Microseconds t = born();
        for (const Segment &s : segments)
            t = std::max(t, s.driesAt());
        return fill ? std::max(t, fill->driesAt()) : t;
    }
};

using StrokePtr = std::shared_ptr<const Stroke>;

} // namespace suffuse
