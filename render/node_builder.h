// Segments to Gaussian nodes: a few positive-weighted Gaussians whose sum is the segment's density (docs/solver.md).
#pragma once

#include "model/painting.h"

#include <memory>
#include <optional>
#include <vector>

namespace suffuse {

/// weight · e^(−q(d)), q = a·dx² + 2b·dx·dy + c·dy², d = x − position; taken as zero where q > cutRadius² per axis.
struct Node {
    double x = 0; ///< offset from the stroke's origin, canvas units
    double y = 0;
    float a = 0; ///< 1/s² where isotropic (then b = 0, c = a), unit⁻²
    float b = 0;
    float c = 0;
    float weight = 0;    ///< density at the node's centre
    float cutRadius = 0; ///< R, in spreads
    friend bool operator==(const Node &, const Node &) = default;
};

/// What one segment contributes to a picture, beside its geometry.
struct SegmentValues {
    Colour colour;
    float granulation = 1;
    Style style; ///< its own or the stroke's
    friend bool operator==(const SegmentValues &, const SegmentValues &) = default;
};

struct SegmentNodes {
    std::uint32_t begin = 0; ///< range in StrokeNodes::nodes
    std::uint32_t end = 0;
    SegmentValues values;
    double spread = 0; ///< s, the smaller axis where anisotropic
    Rect reach;        ///< influenceOf, for the supersampling rule; offsets from the stroke's origin
};

/// The nodes of a stroke at a time and zoom octave. A pure function of stroke, T, octave (and clip, for segments of
/// extreme length: outside of it nodes are left out).
struct StrokeNodes {
    std::vector<Node> nodes; ///< by segment, in order
    std::vector<SegmentNodes> segments; ///< those that are there at T and can be seen at the octave
    bool clipped = false; ///< depends on the clip
};

/// Zoom octave of a scale in pixels per unit: the smallest o with 2^o ≥ scale.
int zoomOctave(double scale);

/// `clip`: what the view shows, canvas units.
std::shared_ptr<const StrokeNodes> buildNodes(const Stroke &stroke, Microseconds T, int octave, const Rect &clip);

/// Absolute density error that a style lets pass unseen: 5e-4 of opacity at its steepest point, where a pixel's own
/// width also softens a hard edge. `peak`: the segment's pk; `spreadPixels`: s in pixels at the octave.
double densityTolerance(const Style &style, double peak, double spreadPixels);

} // namespace suffuse
