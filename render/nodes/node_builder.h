// Segments become nodes: a few Gaussians with positive weights whose sum is the segment's density (docs/solver.md).
#pragma once

#include "model/painting/painting.h"
#include "render/threads/parallel.h"
#include "render/threads/unset_vector.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace suffuse {

/// A node is weight · e^(−q(d)) with q = a·dx² + 2b·dx·dy + c·dy² and d = x − position. It is taken as zero where q >
/// cutRadius² per axis. Nodes of segments that lift paint have negative weights: a stroke's sum over all its nodes is
/// φ⁺ − φ⁻. Those of segments that make paint paler belong to neither: their sum is φ_f.
struct Node {
    double x = 0; ///< offset from the stroke's origin, canvas units
    double y = 0;
    double a = 0; ///< 1/s² where isotropic (then b = 0, c = a), unit⁻²
    double b = 0;
    double c = 0;
    double weight = 0;   ///< density at the node's centre
    float cutRadius = 0; ///< R, in spreads
    friend bool operator==(const Node &, const Node &) = default;
};

/// Nodes with s > deepSpread px are evaluated in double (render/cpu/deep.h).
inline constexpr double deepSpread = 4096;

/// Holds what a node carries beside its density.
struct NodeValues {
    Colour colour;
    float granulation = 1;
    Style style;       ///< the segment's own or the stroke's
    bool lift = false; ///< whether it takes density away, or
    bool fade = false; ///< makes paint paler; the other values then count for nothing

    bool laysPaint() const { return !lift && !fade; }
    friend bool operator==(const NodeValues &, const NodeValues &) = default;
};

/// Where paint is lifted, the samples of a pixel lie this many times closer (docs/solver.md, "Lift").
inline constexpr double liftFineness = 4;

/// Returns the first row that lays paint, or null if there is none.
const NodeValues *firstLaying(std::span<const NodeValues> rows);

/// Says where a segment makes pixels supersampled (docs/reference.md), in offsets from the stroke's origin.
struct SegmentReach {
    double spread = 0; ///< s, the smaller axis where anisotropic; divided by the fineness of what takes paint
    Rect box;          ///< as influenceOf gives it
    friend bool operator==(const SegmentReach &, const SegmentReach &) = default;
};

/// A group has the nodes of one segment, or of a window of segments that were merged. No smaller part of a stroke is
/// redrawn by itself.
struct NodeGroup {
    std::uint32_t begin = 0; ///< range in StrokeNodes::nodes
    std::uint32_t end = 0;
    std::uint32_t row = 0; ///< index in StrokeNodes::rows, for all its nodes or for the first one
    bool rowPerNode = false;
    std::uint32_t reachBegin = 0; ///< range in StrokeNodes::reaches
    std::uint32_t reachEnd = 0;
};

/// Holds the nodes of a stroke at a time and zoom octave. They are a pure function of stroke, T, octave (and clip, for
/// segments of extreme length, whose nodes outside of it are left out).
struct StrokeNodes {
    UnsetVector<Node> nodes;       ///< group by group, in order along the stroke
    UnsetVector<NodeGroup> groups; ///< what is there at T and can be seen at the octave
    UnsetVector<NodeValues> rows;
    UnsetVector<SegmentReach> reaches;
    bool clipped = false;          ///< whether they depend on the clip
    std::uint32_t settledRows = 0; ///< rows of leading blocks that have dried; these stay while the stroke grows
};

/// Returns the zoom octave of a scale in pixels per unit, which is the smallest o with 2^o ≥ scale.
int zoomOctave(double scale);

/// Builds the nodes of a stroke. `clip` is what the view shows, in canvas units. The bits are the same for any number
/// of threads.
std::shared_ptr<const StrokeNodes> buildNodes(const Stroke &stroke, Microseconds T, int octave, const Rect &clip,
                                              Threads threads = 1);

/// Returns a box outside of which no node of the stroke adds anything, whatever the octave. Canvas units; empty if the
/// stroke has no nodes.
Rect greatestReach(const Stroke &stroke, Microseconds T);

/// Holds what nodes depend on, beside their block of segments.
struct NodeContext {
    Microseconds T = 0;
    int octave = 0;
    Rect clip;                 ///< what the view shows, canvas units
    std::vector<Style> styles; ///< those of all segments of the stroke that lay paint, each once
};

/// Returns what the nodes of all segments of a stroke depend on.
NodeContext contextOf(const Stroke &stroke, Microseconds T, int octave, const Rect &clip);

/// Appends the nodes of the stroke's blocks between these borders, which are some of blocksOf, one after the other.
void appendNodes(const Stroke &stroke, std::span<const std::size_t> borders, const NodeContext &context,
                 Threads threads, StrokeNodes &out);

/// Appends all of `part`.
void appendNodes(const StrokeNodes &part, StrokeNodes &out);

/// Returns the absolute density error that a style lets pass unseen, which changes opacity by 5e-4 where the style is
/// steepest. (19) jumps, but no pixel sees it sharper than its own width. `peak` is the segment's pk, and
/// `spreadPixels` is s in pixels at the octave.
double densityTolerance(const Style &style, double peak, double spreadPixels);

} // namespace suffuse
