// A fill prepared for one view: its boundary in pixels, cut into panels with nodes (docs/solver.md, "Fills").
#pragma once

#include "model/area/boundary.h"
#include "model/painting/stroke.h"
#include "render/math/shade_params.h"
#include "render/picture_grid.h"

#include <array>
#include <atomic>
#include <memory>
#include <vector>

namespace suffuse {

/// The boundary of a stroke's area, turned as a view is: offsets from its origin, before they are scaled. It serves all
/// moments, zooms and places of the view.
struct TurnedBoundary {
    double rotation = 0;
    bool mirrored = false;
    AreaBoundary area;
};

/// A place on the boundary. At a point with u = a·dx + b·dy and v = c·dy from it, it adds weight · ½erfc(−u) · e^(−v²).
struct FillNode {
    double x = 0, y = 0; ///< pixels
    double weight = 0;
};

/// Boxes of panels and arcs are looked at in runs of so many.
inline constexpr std::size_t fillRun = 32;

/// A piece of an arc, so short that the nodes [begin, end) integrate along it.
struct FillPanel {
    BoundaryArc part; ///< pixels
    Rect box;
    std::uint32_t begin = 0, end = 0;
    friend bool operator==(const FillPanel &a, const FillPanel &b) { return a.part == b.part; }
};

/// The heights of a part of an arc that lies left of all that is near the window.
struct FillLeft {
    double top = 0, bottom = 0;
    int enters = 1;
};

/// What a place where the density is summed needs to know of the area left of it: whether it is inside at a corner, and
/// where that changes along the level of x.
struct FillEvent {
    double y = 0;
    int jump = 0;
};

/// The sums over a great square of the grid in which a fill of a spread beyond deepSpread is evaluated.
struct DeepFillSquare {
    int entered = 0;
    std::vector<FillEvent> events;
    std::vector<FillNode> nodes;
};

struct SceneFill {
    std::shared_ptr<const TurnedBoundary> boundary;
    double density = 0;         ///< ρ
    double a = 1, b = 0, c = 1; ///< px⁻¹: u = a·dx + b·dy, v = c·dy
    Point reach;                ///< px: what is farther away counts as 0
    double nearby = 0;          ///< px: where the outline is so near, pixels have the level
    int level = 0;              ///< of supersampling, 2^level·s ≥ 1 px
    bool crisp = false;         ///< s < 1/64 px: the outline covers pixels in part
    bool deep = false;          ///< s > deepSpread px
    double narrowest = 0;       ///< px: s along the shorter axis
    double steepest = 0;        ///< a bound of |∇φ|, px⁻¹
    double epsilon = 0;         ///< what the density may be off by, as a share of ρ
    PixelRect bounds;           ///< the pixels that it can change

    std::vector<BoundaryArc> arcs; ///< pixels; those that tell what lies inside, in or near the window
    std::vector<Rect> arcRuns;
    std::vector<BoundaryFlat> flats; ///< pixels
    std::vector<FillPanel> panels;   ///< in or near the window
    std::vector<Rect> panelRuns;
    std::vector<FillNode> nodes;
    /// Parts of arcs left of the window, without panels. With these, every level of the window is crossed by panels and
    /// such parts alone.
    std::vector<FillLeft> lefts;

    static constexpr int deepSide = 4096;             ///< pixels
    int deepColumn = 0, deepRow = 0, deepColumns = 0; ///< the first square, and how many stand in a row
    std::vector<DeepFillSquare> deepSquares;

    bool hasGradient = false;
    double place = 0;             ///< between the colours, at pixel (0, 0)
    Point placeSlope;             ///< per pixel
    std::array<double, 3> half{}; ///< ½M⁻¹ (xx, xy, yy): the mean place is place(x) + slope·½M⁻¹∇φ/φ
    std::array<float, maxChannels> from{}; ///< channel values at the gradient's begin
    std::array<float, maxChannels> step{}; ///< and what they are more at its end

    double placeAt(double x, double y) const { return place + placeSlope.x * x + placeSlope.y * y; }
};

/// Prepares the fill of a stroke; null if it has none that could be seen, or if `stop` became true before its boundary
/// was found. `before` is what another state of the stroke had, from which the boundary is taken over where it is the
/// same.
std::shared_ptr<SceneFill> makeSceneFill(const Stroke &stroke, Microseconds T, const PictureGrid &grid,
                                         const Stroke *strokeBefore, const SceneFill *before,
                                         const std::atomic<bool> *stop = nullptr);

/// How often the area is entered left of a point, 0 or 1. `arcs` are those that may meet its level.
int enteredAt(const BoundaryArc *arcs, std::size_t count, Point at);

/// Collects what is needed to sum up in an area. `left` and `top` are those of the area that counts, i.e. grown by the
/// reach, and `bottom` ends it.
void collectFill(const SceneFill &fill, const FillPanel *const *panels, std::size_t count, double left, double top,
                 double bottom, std::vector<FillEvent> &events, std::vector<FillNode> &nodes);

} // namespace suffuse
