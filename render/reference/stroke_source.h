// A stroke prepared for one picture: its segments in pixel space, cut into panels.
#pragma once

#include "render/reference/fill_source.h"
#include "render/reference/panels.h"
#include "render/reference/picture.h"
#include "render/renderer.h"

#include <optional>

namespace suffuse::reference {

/// The places of a segment's channels: density-weighted means over the segments (eq 15, 20) and, for strokes of mixed
/// styles, four channels for each kind: its share and ξ1, ξ2, ξ3.
enum Channel : std::size_t { GranulationChannel, ColourChannel, FirstStyleChannel = ColourChannel + 4 };

struct SegmentSource {
    Cubic curve;                  ///< pixels
    Kernel kernel;                ///< in pixels, turned and mirrored with the view
    double factor = 0;            ///< φˢ in pixels · norm, by which the weight of a node is multiplied
    double reach = 0;             ///< pixels beyond which its density counts as 0
    Rect box;                     ///< around all that it reaches, pixels
    bool onTheFly = false;        ///< whether it is so thin that panels are made where they are needed
    std::vector<Panel> panels;    ///< otherwise the panels that reach the picture
    std::vector<double> channels; ///< values by `Channel`
    bool lifts = false;           ///< whether it takes density away; its channels then do not count
    bool fades = false;           ///< whether it makes paint paler; its density is then a sum of its own
    int level = 0;                ///< the smallest k ≤ 6 with s·2^k ≥ 1 px, or 4 px if it takes paint away
    Rect influence;               ///< canvas units, for the rule of supersampling
};

struct StrokeSource {
    Mix mix;
    Style style;                  ///< of all segments, if `kinds` is empty
    std::vector<StyleKind> kinds; ///< the kinds of style that there are, if segments differ
    std::size_t channels = 0;
    double reach = 0; ///< in spreads
    std::vector<SegmentSource> segments;
    std::optional<FillSource> fill;
    std::shared_ptr<const PictureField> picture; ///< what it shows in place of its colours
    Rect box;                                    ///< pixels
};

/// The stroke at time T in the view, without segments and fills of age 0. Pixel (i, j) covers [i, i+1] × [j, j+1].
/// Styles are those of the segments that lay paint.
StrokeSource strokeSource(const Stroke &stroke, Microseconds time, const View &view);

/// How many spreads a node must reach so that what is cut off is below 1e-14 of the density at which the stroke's
/// styles begin to show; at least 6.5 (e^−42).
double reachOf(const Stroke &stroke, Microseconds time);

} // namespace suffuse::reference
