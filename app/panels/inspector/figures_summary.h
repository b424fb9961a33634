// What the derived figures of many segments come to.
#pragma once

#include "app/panels/inspector/inspected.h"

namespace suffuse {

/// The least and the most of some values.
struct Extent {
    double least = 0, most = 0;
    std::size_t count = 0;
    void add(double value) { add(Extent{value, value, 1}); }
    void add(const Extent &other);
};

/// Of some segments together.
struct FiguresSummary {
    std::size_t segments = 0, transparent = 0, withoutPaint = 0;
    Extent spread, along, peak, halfWidth; ///< DerivedFigures
    Extent driesOut;                       ///< of those that do, with paint or without
    Extent fading, shrinking;              ///< ages at which paint vanishes, or is widest, before it is dry
    bool uneven = false;
    std::vector<Style> styles; ///< in the order of the segments, the same ones that follow each other once

    void add(const InspectedSegment &inspected);
    void add(const FiguresSummary &other);
};

/// Summaries of what is inspected. Those of strokes that stay as they are, are kept.
class FiguresKeeper {
public:
    FiguresSummary summaryOf(const Inspected &inspected);

private:
    struct Kept {
        const Stroke *stroke = nullptr;
        FiguresSummary figures;
    };
    std::vector<Kept> m_kept; ///< strokes that are inspected as a whole, in order
    PaintingPtr m_painting;   ///< theirs; while it lives, no other stroke has the address of one of them
};

} // namespace suffuse
