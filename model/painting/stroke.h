#pragma once

#include "model/painting/ids.h"
#include "model/painting/segment.h"

#include <QString>

#include <memory>

namespace suffuse {

/// A stroke as a value. Paintings share them as `StrokePtr`; an edit makes a new one with the same id.
/// Segment k + 1 starts where segment k ends, in equal float32 numbers.
struct Stroke {
    StrokeId id = 0;
    QString name;
    GroupId group = 0;
    bool visible = true;
    bool locked = false;
    Style style;
    Mix mix;
    Point origin; ///< the segments' control points are offsets from it
    QString brush; ///< name of the preset it was painted with, may be empty
    std::vector<Segment> segments; ///< at least one

    friend bool operator==(const Stroke &, const Stroke &) = default;

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
        return t;
    }
    Microseconds driesAt() const
    {
        Microseconds t = born();
        for (const Segment &s : segments)
            t = std::max(t, s.driesAt());
        return t;
    }
};

using StrokePtr = std::shared_ptr<const Stroke>;

} // namespace suffuse
