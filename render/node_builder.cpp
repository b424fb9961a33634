#include "render/node_builder.h"

#include "model/influence.h"
#include "render/level0.h"
#include "render/math/scalar.h"
#include "render/math/style.h"

#include <numbers>

namespace suffuse {

namespace {

constexpr double unseen = 5e-4;       // opacity
constexpr double finest = 0x1p-22;    // float sums carry no more
constexpr double coarsest = 0x1p-12;
constexpr double thinnest = 0x1p-13;  // px: a line of this spread covers less than 1/512 of a pixel
constexpr int maxDepth = 40;
constexpr double longSegment = 512;   // spreads: longer ones are built per view

/// A segment ready to be cut into panels.
struct Source {
    Cubic curve;    // offsets from the stroke's origin
    double a, b, c; // metric, unit⁻²
    double wxx, wxy, wyy; // its square root: whitening
    double speedScale;    // makes |g′| comparable: 1/s of the smaller axis
    double gain;    // φˢ √det M / π
    double radius;  // R
    Rect clip;      // empty: none
    double reach;   // R · larger axis
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

double polygonLength(const Cubic &c)
{
    return length(c.p[1] - c.p[0]) + length(c.p[2] - c.p[1]) + length(c.p[3] - c.p[2]);
}

void addPanel(const Source &s, const Cubic &curve, int n, std::vector<Node> &out)
{
    const QuadratureRule &rule = gaussLegendre(n);
    for (int i = 0; i < n; ++i) {
        const Point at = curve.at(rule.x[i]);
        const double weight = s.gain * rule.weight[i] * length(curve.derivative(rule.x[i]));
        if (weight > 0)
            out.push_back({at.x, at.y, float(s.a), float(s.b), float(s.c), float(weight), float(s.radius)});
    }
}

void addPanels(const Source &s, const Cubic &curve, double tolerance, int depth, std::vector<Node> &out)
{
    if (!s.clip.isEmpty() && !curve.controlBox().grown(s.reach).intersects(s.clip))
        return;
    const Cubic metric = scaled(s, curve);
    int n = panelNodes(whitened(s, curve), metric, tolerance);
    // A piece (of a cusp) so short that all its mass counts for less than the tolerance takes any rule.
    if (n == 0 && (depth == maxDepth || 2 * polygonLength(metric) < tolerance * std::sqrt(std::numbers::pi)))
        n = 4;
    if (n > 0)
        return addPanel(s, curve, n, out);
    const auto halves = curve.split(0.5);
    addPanels(s, halves[0], tolerance / 2, depth + 1, out);
    addPanels(s, halves[1], tolerance / 2, depth + 1, out);
}

/// Metric M = D⁻¹/4t of an age and its square root.
void setMetric(Source &s, const Segment &segment, double spread)
{
    const double across = 1 / (spread * spread), along = across / segment.anisotropyRatio;
    const double cs = std::cos(double(segment.anisotropyAngle)), sn = std::sin(double(segment.anisotropyAngle));
    const auto compose = [&](double l, double n, double &xx, double &xy, double &yy) {
        xx = l * cs * cs + n * sn * sn;
        xy = (l - n) * cs * sn;
        yy = l * sn * sn + n * cs * cs;
    };
    if (segment.isIsotropic()) {
        s.a = s.c = across;
        s.b = 0;
        s.wxx = s.wyy = 1 / spread;
        s.wxy = 0;
        return;
    }
    compose(along, across, s.a, s.b, s.c);
    compose(std::sqrt(along), std::sqrt(across), s.wxx, s.wxy, s.wyy);
    // Axis-aligned tensors are separable: keep that exact.
    if (std::abs(s.b) < 1e-9 * std::min(s.a, s.c))
        s.b = s.wxy = 0;
}

double cutRadius(double epsilon, const std::vector<Style> &styles, double peak)
{
    double r2 = std::log(16 / epsilon);
    for (const Style &style : styles)
        if (style.kind == StyleKind::Feathering) // its tail reaches far where ξ2 is small
            r2 = std::max(r2, std::log(std::max(peak / style.xi[0], 1e-6)) + std::log(1 / unseen) / style.xi[1]);
    return std::sqrt(std::clamp(r2, 6.0, 36.0));
}

} // namespace

int zoomOctave(double scale)
{
    int exponent = 0;
    const double mantissa = std::frexp(scale, &exponent); // scale = mantissa · 2^exponent, mantissa in [½, 1)
    return mantissa == 0.5 ? exponent - 1 : exponent;
}

double densityTolerance(const Style &style, double peak, double spreadPixels)
{
    using namespace math;
    const double xi1 = style.xi[0], xi2 = style.xi[1];
    double gentle = 0, edge = xi1; // 1/slope; density at the edge
    switch (style.kind) {
    case StyleKind::Uniform:
        gentle = 4 * xi2;
        break;
    case StyleKind::Feathering:
        gentle = xi1 / std::max(xi2, 1.0);
        break;
    case StyleKind::Edge:
        edge = Edge<double>(xi1, xi2, style.xi[2]).phiE;
        break;
    }
    // A pixel spans 2h = |∇φ| px of density, |∇φ| = 2uφ/s at u spreads from a line: a slope of 1/2h at most.
    const double u = std::sqrt(std::max(std::log(peak / edge), 0.25));
    return unseen * std::max(gentle, 2 * u * edge / std::max(spreadPixels, 1.0));
}

std::shared_ptr<const StrokeNodes> buildNodes(const Stroke &stroke, Microseconds T, int octave, const Rect &clip)
{
    auto result = std::make_shared<StrokeNodes>();
    const double scale = std::ldexp(1.0, octave);
    std::vector<Style> styles; // every segment's density passes through all of the stroke's styles
    for (const Segment &segment : stroke.segments)
        if (std::find(styles.begin(), styles.end(), stroke.styleOf(segment)) == styles.end())
            styles.push_back(stroke.styleOf(segment));

    for (const Segment &segment : stroke.segments) {
        const double across = segment.spread(T);
        const double along = across * std::sqrt(double(segment.anisotropyRatio));
        const double spread = std::min(across, along), larger = std::max(across, along);
        if (!(across > 0) || segment.density <= 0 || larger * scale < thinnest)
            continue;
        const double peak = segment.density / (std::sqrt(std::numbers::pi) * spread);
        double tolerance = 1e300;
        for (const Style &style : styles)
            tolerance = std::min(tolerance, densityTolerance(style, peak, spread * scale));
        const double epsilon = std::clamp(tolerance / peak, finest, coarsest);

        Source s{};
        for (int i = 0; i < 4; ++i)
            s.curve.p[i] = Point{} + segment.bezier[i];
        setMetric(s, segment, across);
        s.speedScale = 1 / spread;
        s.gain = segment.density * std::sqrt(s.a * s.c - s.b * s.b) / std::numbers::pi;
        s.radius = cutRadius(epsilon, styles, peak);
        s.reach = s.radius * larger;
        if (polygonLength(s.curve) > longSegment * spread) {
            s.clip = {clip.left - stroke.origin.x, clip.top - stroke.origin.y, clip.right - stroke.origin.x,
                      clip.bottom - stroke.origin.y};
            result->clipped = true;
        }
        SegmentNodes nodes;
        nodes.begin = std::uint32_t(result->nodes.size());
        const double chord = length(s.curve.p[3] - s.curve.p[0]);
        addPanels(s, s.curve, epsilon * std::min(1.0, chord / (4 * spread) + 0.1), 0, result->nodes);
        nodes.end = std::uint32_t(result->nodes.size());
        nodes.values = {segment.colour, segment.granulation, stroke.styleOf(segment)};
        nodes.spread = spread;
        nodes.reach = s.curve.controlBox().grown(reachInSpreads * larger);
        result->segments.push_back(nodes);
    }
    return result;
}

} // namespace suffuse
