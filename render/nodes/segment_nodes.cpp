#include "render/nodes/segment_nodes.h"

#include "model/painting/influence.h"
#include "render/math/scalar.h"
#include "render/nodes/level0.h"
// This header has templates over the numbers of scalar.h, which must be declared before it.
#include "render/math/style.h"

#include <numbers>

namespace suffuse {

namespace {

constexpr double unseen = 5e-4;        // an error of opacity that nobody sees
constexpr double finest = 0x1p-22;     // Float sums have no more precision.
constexpr double finestDeep = 0x1p-44; // the same in double, for segments whose edge a deep zoom shows
constexpr double mergeable = 0x1p-20;  // The check of merged nodes is in float.
constexpr double coarsest = 0x1p-12;
constexpr double thinnest = 0x1p-13; // In px: a line of this spread covers less than 1/512 of a pixel.
constexpr double cutShare = 0.35;    // the share of the tolerance for cutting nodes off at R
// The kernel b(u)b(v), b(u) = e^(−u²) − e^(−R²), takes between 1 and 5 e^(−R²) of its peak from a long line, depending
// on the direction of the line. Raising the weights by 3.5 e^(−R²) leaves −2.5 to 0.7, and for oblique nodes −3.3 to
// −0.4.
constexpr double cutGain = 3.5;
constexpr double lossSeparable = 2.5, lossOblique = 3.3, lossUnraised = 5;
constexpr int maxDepth = 40;
// A segment has no more nodes than this. Only a hair that is 200,000 times as long as wide would have more.
constexpr std::size_t mostNodes = std::size_t(1) << 18;
constexpr double longSegment = 512; // in spreads; longer segments are built for each view

/// Holds a segment that is ready to be cut into panels.
struct Source {
    Cubic curve;          // offsets from the stroke's origin
    double a, b, c;       // metric, unit⁻²
    double wxx, wxy, wyy; // the square root of the metric, for whitening
    double speedScale;    // 1/s of the smaller axis, which scales |g′| like the whitened curve
    double gain;          // φˢ √det M / π
    double radius;        // R
    Rect clip;            // empty if nothing is clipped
    double reach;         // R · larger axis
    bool isotropic;
};

Cubic whitened(const Source &s, const Cubic &curve)
{
    Cubic w;
    for (int i = 0; i < 4; ++i) {
        const Point d = curve.p[i] - s.curve.p[0];
        w.p[i] = {s.wxx * d.x + s.wxy * d.y, s.wxy * d.x + s.wyy * d.y};
    }
    return w;
}

Cubic scaled(const Source &s, const Cubic &curve)
{
    Cubic w;
    for (int i = 0; i < 4; ++i)
        w.p[i] = s.speedScale * (curve.p[i] - s.curve.p[0]);
    return w;
}

/// Returns the length without hypot's care for overflow, which canvas coordinates do not need.
double norm(Point p)
{
    return std::sqrt(dot(p, p));
}

double sumOfSides(const Cubic &c)
{
    return norm(c.p[1] - c.p[0]) + norm(c.p[2] - c.p[1]) + norm(c.p[3] - c.p[2]);
}

void addPanel(const Source &s, const Cubic &curve, int n, UnsetVector<Node> &out)
{
    const QuadratureRule &rule = gaussLegendre(n);
    for (int i = 0; i < n; ++i) {
        const Point at = curve.at(rule.x[i]);
        const double weight = s.gain * rule.weight[i] * norm(curve.derivative(rule.x[i]));
        if (weight > 0)
            out.push_back({at.x, at.y, s.a, s.b, s.c, weight, float(s.radius)});
    }
}

/// Adds panels. Once `out` has `most` nodes, what is left gets few nodes, so that no painting, however extreme, takes
/// memory without end.
void addPanels(const Source &s, const Cubic &curve, double tolerance, int depth, std::size_t most,
               UnsetVector<Node> &out)
{
    if (!s.clip.isEmpty() && !curve.controlBox().grown(s.reach).intersects(s.clip))
        return;
    const Cubic metric = scaled(s, curve);
    int n = panelNodes(s.isotropic ? metric : whitened(s, curve), metric, tolerance);
    // Any rule is good enough for a piece (of a cusp) so short that all its mass counts for less than the tolerance.
    if (n == 0 &&
        (depth == maxDepth || out.size() >= most || 2 * sumOfSides(metric) < tolerance * std::sqrt(std::numbers::pi)))
        n = 4;
    if (n > 0)
        return addPanel(s, curve, n, out);
    const auto halves = curve.split(0.5);
    addPanels(s, halves[0], tolerance / 2, depth + 1, most, out);
    addPanels(s, halves[1], tolerance / 2, depth + 1, most, out);
}

/// Sets the metric M = D⁻¹/4t of an age, and its square root.
void setMetric(Source &s, const Segment &segment, double spread)
{
    const double across = 1 / (spread * spread), along = across / segment.anisotropyRatio;
    s.isotropic = segment.isIsotropic();
    if (s.isotropic) {
        s.a = s.c = across;
        s.b = 0;
        s.wxx = s.wyy = 1 / spread;
        s.wxy = 0;
        return;
    }
    const double cs = std::cos(double(segment.anisotropyAngle)), sn = std::sin(double(segment.anisotropyAngle));
    const auto compose = [&](double l, double n, double &xx, double &xy, double &yy) {
        xx = l * cs * cs + n * sn * sn;
        xy = (l - n) * cs * sn;
        yy = l * sn * sn + n * cs * cs;
    };
    compose(along, across, s.a, s.b, s.c);
    compose(std::sqrt(along), std::sqrt(across), s.wxx, s.wxy, s.wyy);
    // Axis-aligned tensors are separable, which must stay exact.
    if (std::abs(s.b) < 1e-9 * std::min(s.a, s.c))
        s.b = s.wxy = 0;
}

/// Returns R, beyond which neither the density itself nor its slope over a sample can be seen. `lineLoss` is what
/// cutting takes from a line at most, in units of e^(−R²) of its peak.
double cutRadius(double tolerance, const std::vector<Style> &styles, double peak, double spreadPixels, double lineLoss)
{
    // A sample is at most one spread wide, unless even 64 × 64 of them in a pixel are not enough.
    const double sample = spreadPixels < 1 ? std::max(1.0, 1 / (64 * spreadPixels)) : 1 / spreadPixels;
    // At the edge of its box the slope of a node jumps by 2R e^(−R²), half of which counts.
    double r2 = std::log((lineLoss + 3.5 * sample) / cutShare * std::max(peak / tolerance, 1.0));
    for (const Style &style : styles)
        if (style.kind == StyleKind::Feathering) // Its tail reaches far if ξ2 is small.
            r2 = std::max(r2, std::log(std::max(peak / style.xi[0], 1e-6)) + std::log(1 / unseen) / style.xi[1]);
    return std::sqrt(std::clamp(r2, 6.0, 80.0));
}

/// Returns the density from which on a style is plainly seen.
double shownFrom(const Style &style)
{
    const double xi1 = style.xi[0];
    return style.kind == StyleKind::Edge ? math::Edge<double>(xi1, style.xi[1], style.xi[2]).phiE : xi1;
}

/// Computes the spreads of a segment at a time, in canvas units.
struct Axes {
    double across, smaller, larger;

    Axes(const Segment &segment, Microseconds T) : across(segment.spread(T))
    {
        const double along = across * std::sqrt(double(segment.anisotropyRatio));
        smaller = std::min(across, along), larger = std::max(across, along);
    }
};

bool isSeen(const Segment &segment, const Axes &axes, double scale)
{
    return axes.across > 0 && segment.density > 0 && !(axes.larger * scale < thinnest);
}

} // namespace

double densityTolerance(const Style &style, double peak, double spreadPixels)
{
    const double xi1 = style.xi[0], xi2 = style.xi[1];
    switch (style.kind) {
    case StyleKind::Uniform:
        return unseen * 4 * xi2;
    case StyleKind::Feathering:
        return unseen * xi1 / std::max(xi2, 1.0);
    case StyleKind::Edge:
        break;
    }
    // Only the width of the pixel softens a jump. It covers 2h = |∇φ| px of density, and |∇φ| = 2uφ/s at u spreads from
    // a line.
    const double edge = math::Edge<double>(xi1, xi2, style.xi[2]).phiE;
    const double u = std::sqrt(std::max(std::log(peak / edge), 0.25));
    return unseen * 2 * u * edge / std::max(spreadPixels, 1.0);
}

bool isSeen(const Segment &segment, Microseconds T, double scale)
{
    return isSeen(segment, Axes(segment, T), scale);
}

bool buildSegment(const Stroke &stroke, const Segment &segment, const NodeContext &context, double scale,
                  UnsetVector<Node> &nodes, SegmentNodes &out)
{
    const std::vector<Style> &styles = context.styles;
    const Axes axes(segment, context.T);
    if (!isSeen(segment, axes, scale))
        return false;
    const double spread = axes.smaller, larger = axes.larger;
    out.peak = segment.density / (std::sqrt(std::numbers::pi) * spread);
    double tolerance = 1e300;
    // Where a segment alone has too little density for the style to show, several lie on top of each other, and their
    // errors add up.
    for (const Style &style : styles)
        tolerance = std::min(tolerance, densityTolerance(style, out.peak, spread * scale) *
                                            std::min(1.0, out.peak / shownFrom(style)));
    // What is left of paint may fall more gently than the segment itself, so that a jump is less softened.
    if (segment.lift)
        tolerance *= 0.5;
    out.epsilon = std::clamp(tolerance / out.peak, spread * scale > deepSpread ? finestDeep : finest, coarsest);

    Source s{};
    for (int i = 0; i < 4; ++i)
        s.curve.p[i] = Point{} + segment.bezier[i];
    setMetric(s, segment, axes.across);
    s.speedScale = 1 / spread;
    s.gain = segment.density * std::sqrt(s.a * s.c - s.b * s.b) / std::numbers::pi;
    // Nodes that are evaluated in double are not cut.
    const bool raised = larger * scale <= deepSpread;
    const double lineLoss = !raised ? lossUnraised : s.isotropic ? lossSeparable : lossOblique;
    const Rect box = s.curve.controlBox();
    const double polygon = sumOfSides(s.curve);
    // This is how often the segment may lie on top of itself.
    const double folds = std::max(1.0, polygon / (norm({box.width(), box.height()}) + 0.5 * spread));
    s.radius = cutRadius(out.epsilon * out.peak, styles, out.peak, spread * scale, folds * lineLoss);
    out.radius = float(s.radius);
    out.weightGain = raised ? 1 + cutGain * std::exp(-s.radius * s.radius) : 1;
    s.reach = s.radius * larger;
    out.clipped = polygon > longSegment * spread;
    if (out.clipped)
        s.clip = {context.clip.left - stroke.origin.x, context.clip.top - stroke.origin.y,
                  context.clip.right - stroke.origin.x, context.clip.bottom - stroke.origin.y};
    const double chord = norm(s.curve.p[3] - s.curve.p[0]);
    out.begin = nodes.size();
    addPanels(s, s.curve, out.epsilon * std::min(1.0, chord / (4 * spread) + 0.1), 0, out.begin + mostNodes, nodes);
    out.end = nodes.size();
    if (segment.lift)
        out.values = {{}, 1, stroke.style, true}, out.weightGain = -out.weightGain;
    else
        out.values = {segment.colour, segment.granulation, stroke.styleOf(segment), false};
    out.spread = spread;
    out.reach = {segment.lift ? spread / liftFineness : spread, box.grown(reachInSpreads * larger)};
    out.mergeable = segment.isIsotropic() && !out.clipped && segment.driesAt() <= context.T && out.epsilon >= mergeable;
    return true;
}

} // namespace suffuse
