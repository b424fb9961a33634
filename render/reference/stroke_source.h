// A stroke made ready for one picture: its segments in pixel space, cut into panels.
#pragma once

#include "render/reference/panels.h"
#include "render/renderer.h"

namespace suffuse::reference {

/// Where a segment's channels stand: density-weighted means over the segments (eq 15, 20), and for strokes of mixed
/// styles four channels for each kind there is: its share and ξ1, ξ2, ξ3.
enum Channel : std::size_t { GranulationChannel, ColourChannel, FirstStyleChannel = ColourChannel + 4 };

struct SegmentSource {
    Cubic curve;                  ///< pixels
    Kernel kernel;                ///< in pixels, turned and mirrored with the view
    double factor = 0;            ///< φˢ in pixels · norm: what a node's weight is multiplied with
    double reach = 0;             ///< pixels beyond which its density counts as 0
    Rect box;                     ///< of all it reaches, pixels
    bool onTheFly = false;        ///< so thin that panels are made where they are needed
    std::vector<Panel> panels;    ///< else: those that reach the picture
    std::vector<double> channels; ///< values by `Channel`
    bool lifts = false;           ///< it takes paint away; its channels count for nothing
    int level = 0;                ///< smallest k ≤ 6 with s·2^k ≥ 1 px, where it lifts 4 px
    Rect influence;               ///< canvas units, for the supersampling rule
};

struct StrokeSource {
    Mix mix;
    Style style;                  ///< of all segments, where `kinds` is empty
    std::vector<StyleKind> kinds; ///< there are, where segments differ
    std::size_t channels = 0;
    double reach = 0; ///< in spreads
    std::vector<SegmentSource> segments;
    Rect box; ///< pixels
};

/// The stroke at time T in the view; segments of age 0 are left out. Pixel (i, j) covers [i, i+1] × [j, j+1]. Styles
/// are those of the segments that lay paint.
StrokeSource strokeSource(const Stroke &stroke, Microseconds time, const View &view);

/// How many spreads a node must reach so that what is cut off is below 1e-14 of the density at which the stroke's
/// styles begin to show: at least 6.5 (e^−42).
double reachOf(const Stroke &stroke, Microseconds time);

} // namespace suffuse::reference
