// Erasures that run over several letters, where the line bends on which these stand.
#pragma once

#include "model/painting/stroke.h"
#include "model/painting/text.h"
#include "model/shaping/baseline_curve.h"

#include <utility>

namespace suffuse {

/// What one drag of the eraser took from several letters is one path for people, and bends with the line of writing
/// when the letters are turned one by one: each point keeps its place along the line and its distance from it. Parts
/// belong together where their births overlap, as those of a drag do. What was erased out of one letter alone goes with
/// that letter, and so does all where the curve stays or where letters stand upright below each other.
class LetterErasures {
public:
    /// The text before and as it becomes. Both must live longer.
    LetterErasures(const Text &before, const Text &after);

    /// Notes what a letter has of erasures; call it for each one, as it is before.
    void note(const Stroke &letter);
    /// Call it behind the last one.
    void findLong();

    /// How a letter was moved on the canvas, and where its middle was and is along the line (`LaidCluster::along`).
    struct Step {
        Affine map;
        double alongBefore = 0, alongAfter = 0;
    };
    /// A letter that was moved, with its part of long erasures where it belongs along the line.
    StrokePtr bent(const StrokePtr &moved, const Step &step) const;

private:
    struct Part {
        StrokeId letter = 0;
        Microseconds from = 0, to = 0; ///< from its first birth until its last one is dry
    };
    bool isLong(const Segment &segment) const;

    const Text &m_before, &m_after;
    bool m_bends = false;
    BaselineCurve m_lineBefore, m_lineAfter;
    std::vector<Part> m_parts;
    std::vector<std::pair<Microseconds, Microseconds>> m_long; ///< when those were made that run over several letters
};

} // namespace suffuse
