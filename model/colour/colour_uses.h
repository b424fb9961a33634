// The colours that a painting is painted with, as a list that a person can read.
#pragma once

#include "model/painting/painting.h"
#include "model/painting/selection.h"

#include <array>
#include <optional>
#include <vector>

namespace suffuse {

/// The one colour by which a stroke is shown in lists: that of the segment in its middle or, where it is its fill
/// alone, that of the fill.
Colour shownColourOf(const Stroke &stroke);

/// A stroke as it was at some moment, and which of its colours are meant.
struct ColourPart {
    StrokePtr stroke;
    std::vector<bool> chosen; ///< for each segment; empty: all are
    bool fill = false;        ///< whether the colour of its fill is
    bool gradient = false;    ///< whether the second colour of its fill is

    bool has(std::size_t segment) const { return chosen.empty() || chosen[segment]; }
    std::size_t count() const; ///< of segments
};
using ColourParts = std::vector<ColourPart>;

/// What a change of colour means: of visible, unlocked strokes, the segments that are selected, or all of the selected
/// strokes without selected segments. Where nothing is selected, all of the painting. Bottom to top. Erasures are left
/// out: what takes paint away has no colour. A fill is meant with all of its stroke, and with segments that only bound
/// it, which have no paint of their own.
ColourParts partsToColour(const Painting &painting, const Selection &selection);
/// Where a painting has exactly this red, yellow and blue, in hidden and locked strokes, too.
ColourParts partsOfColour(const Painting &painting, const Colour &colour);

/// A colour of a painting, or several that look much alike. Opacity plays no part in it.
struct ColourUse {
    Colour colour;               ///< of those, the one with the most paint; opaque
    std::vector<Colour> members; ///< all of them, `colour` among them, each once; opaque
    std::size_t segments = 0;
    std::size_t strokes = 0; ///< that have such segments or fills
    /// share of all that the colours cover: lines by their length and the width at which they are seen, fills by their
    /// area, both by opacity. What lies over other paint counts as if it lay alone
    double paint = 0;
};

/// The colours of the parts, those with the most paint first. Where there are more than `most`, colours that look alike
/// become one, and the less alike ones the more there are. Segments that take paint away show no colour, and are left
/// out, and so are those that only bound a fill. Each colour of a gradient has half of its fill.
std::vector<ColourUse> coloursOf(const ColourParts &parts, std::size_t most);

/// What a person is told of the colours of some parts.
struct ColourSummary {
    Colour usual;         ///< that most segments have, opacity included; of several, the first. A fill counts as many
                          ///< times as its stroke has segments
    bool several = false; ///< they look like several: what a brush strays by within a stroke is one colour
    std::optional<Colour> other;  ///< of several, the one that most segments have but for the usual one
    std::array<bool, 4> differ{}; ///< whether they do in red, in yellow, in blue, in opacity
    std::size_t strokes = 0;
    std::size_t segments = 0; ///< that lay paint or, if none does, that bound fills
    bool onlyFills = false;   ///< whether nothing but fills has a colour
};
/// Where `coloured`, greys are the usual colour only if there is nothing else. There must be at least one part.
ColourSummary summaryOf(const ColourParts &parts, bool coloured);

} // namespace suffuse
