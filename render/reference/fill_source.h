// A fill prepared for one picture: the heat kernel is integrated over the area along scan lines.
#pragma once

#include "render/reference/density.h"
#include "render/view.h"

#include "model/painting/stroke.h"

#include <array>
#include <memory>
#include <vector>

namespace suffuse::reference {

/// What a fill is at a point. The gradient is per pixel.
struct FillSample {
    double density = 0;
    Point gradient;
    double place = 0; ///< between the colours of its gradient, in [0, 1]
};

/// The area within a stroke's outline, in pixels and, for the integral, in coordinates u = ax + by, v = cy in which the
/// fill's Gaussian is e^(−u² − v²)/π. Rows of pixels are scan lines there, too.
class FillSource {
public:
    /// `reach` is in spreads: what is farther away counts as 0. The fill must be there at T.
    FillSource(const Stroke &stroke, Microseconds T, const View &view, double reach);

    /// Where s is below 1/64 px along the shorter axis the area ends at its outline, and a sample that the outline
    /// crosses is covered in part.
    bool crisp() const { return m_crisp; }
    /// The smallest k ≤ 6 with s·2^k ≥ 1 px; 0 where it is crisp.
    int level() const { return m_level; }
    /// Around all that it reaches, pixels.
    const Rect &box() const { return m_box; }
    /// Whether the area ends within 4 s (of the longer axis) of a square of pixels, so that `level` counts there.
    bool isNear(const Rect &square) const;

    /// φ_fill (ρ times the integral of the kernel over the area), ∇φ_fill and the mean place of what comes to a point.
    FillSample at(Point x) const;
    /// For a crisp fill: how much of a square with this centre lies inside, in [0, 1].
    double covered(Point centre, double side) const;
    /// ρ and the place between the colours at a point, for a crisp fill.
    FillSample inside(Point x) const;

    const std::vector<double> &channels() const { return m_channels; } ///< by `Channel`, at the begin of its gradient
    /// The value of a channel at a place of its gradient.
    double channelAt(std::size_t channel, double place) const;
    void setChannels(std::vector<double> channels) { m_channels = std::move(channels); }

private:
    /// A part of the outline along which v rises (sign 1) or falls (−1).
    struct Arc {
        Cubic curve; ///< from the lower v to the higher
        int sign = 1;
        Rect box; ///< u, v

        double parameterAt(double v) const;
        double uAt(double v) const { return curve.at(parameterAt(v)).x; }
    };
    using Interval = std::array<double, 2>;
    struct ScanLine {
        double v = 0, weight = 0;
        std::size_t from = 0, to = 0; ///< in m_intervals
    };

    Point toPlane(Point x) const { return {m_a * x.x + m_b * x.y, m_c * x.y}; }
    void makeArcs(const std::vector<Cubic> &outline);
    void insideAt(double v, std::vector<Interval> &out) const;
    /// Adds scan lines that integrate over [from, to], in which no arc ends.
    bool runsFar(double from, double to) const;
    void addPanels(double from, double to, int depth);
    void addLines(double from, double to);
    std::array<double, 2> measure(double from, double to, int order) const;
    double coveredBetween(double from, double to, const Rect &cell, int depth) const;
    double coveredShare(const Rect &square) const;
    bool endsIn(const Rect &square) const;
    static std::vector<double> cutsOf(const Arc &arc, const Rect &square);
    double clippedAt(double v, const Rect &cell) const;

    double m_a = 1, m_b = 0, m_c = 1;
    double m_density = 0, m_reach = 0;
    double m_left = 0, m_right = 0; ///< what of the plane is seen, and what reaches it: u
    double m_largerSpread = 0;      ///< px
    FillRule m_rule = FillRule::NonZero;
    bool m_crisp = false, m_hasGradient = false;
    int m_level = 0;
    Rect m_box;
    std::array<double, 3> m_place{}; ///< place = m_place[0] + m_place[1] u + m_place[2] v
    std::array<double, 4> m_colourEnd{};
    std::vector<double> m_channels;
    std::vector<Cubic> m_outline;         ///< pixels
    std::shared_ptr<FillSource> m_pixels; ///< the same area in pixels, for `isNear`; null where it is not asked for
    std::vector<Arc> m_arcs;
    std::vector<double> m_ends; ///< of arcs, in order
    std::vector<ScanLine> m_lines;
    std::vector<Interval> m_intervals;
};

} // namespace suffuse::reference
