// The derived figures of many segments, taken together.
#pragma once

#include "app/panels/inspector/inspected.h"

namespace suffuse {

/// The least and the greatest of some values.
struct Extent {
    double least = 0, most = 0;
    std::size_t count = 0;
    void add(double value) { add(Extent{value, value, 1}); }
    void add(const Extent &other);
};

/// The figures of some segments together. Those of paint stand for themselves: segments that take paint away have
/// figures of their own.
struct FiguresSummary {
    std::size_t segments = 0, transparent = 0, withoutPaint = 0; ///< of those that lay paint
    std::size_t aroundFills = 0;           ///< of those without paint, those that are the outline of a fill
    Extent spread, along, peak, halfWidth; ///< as in DerivedFigures
    Extent driesOut;                       ///< of the segments that dry out, with paint or without
    /// the ages at which paint vanishes, or is widest, if that is before it is dry
    Extent fading, shrinking;
    bool uneven = false;
    std::size_t erasing = 0, withoutEffect = 0; ///< the segments that take paint away, and those that take nothing
    Extent reach, taken; ///< of these, the spread, and of those that lift the greatest density that they take away
    Extent share;        ///< of those that fade, the share of the paint that they take
    std::vector<Style> styles; ///< in the order of the segments; where equal styles follow each other, once

    void add(const InspectedSegment &inspected);
    void add(const FiguresSummary &other);
    /// Whether all of it takes paint away.
    bool isErasure() const { return segments == 0 && erasing > 0; }
    /// Whether nothing is seen of any stroke but its fill.
    bool isFillAlone() const { return segments > 0 && aroundFills == segments; }
};

/// Makes the summary of what is inspected. It keeps the summaries of strokes, and uses those of strokes that have not
/// changed.
class FiguresKeeper {
public:
    FiguresSummary summaryOf(const Inspected &inspected);

private:
    struct Kept {
        const Stroke *stroke = nullptr;
        FiguresSummary figures;
    };
    std::vector<Kept> m_kept; ///< the strokes that are inspected as a whole, in order
    PaintingPtr m_painting;   ///< Holds these strokes: while it lives, no other stroke gets the address of one of them.
};

} // namespace suffuse
