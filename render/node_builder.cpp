#include "render/node_builder.h"

#include "model/influence.h"
#include "render/level0.h"
#include "render/level1.h"
#include "render/math/scalar.h"
#include "render/math/style.h"

#include <numbers>

namespace suffuse {

namespace {

constexpr double unseen = 5e-4;       // opacity
constexpr double finest = 0x1p-22;    // float sums carry no more
constexpr double finestDeep = 0x1p-44; // double ones, for segments that a deep zoom shows the edge of
constexpr double mergeable = 0x1p-20; // the check of merged nodes is in float
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
            out.push_back({at.x, at.y, s.a, s.b, s.c, weight, float(s.radius)});
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

/// R: beyond it neither the density itself nor its slope over a sample can be seen.
double cutRadius(double tolerance, const std::vector<Style> &styles, double peak, double spreadPixels)
{
    // A sample is at most one spread wide, but where even 64 × 64 of them a pixel do not suffice.
    const double sample = spreadPixels < 1 ? std::max(1.0, 1 / (64 * spreadPixels)) : 1 / spreadPixels;
    double r2 = std::log(16 * (1 + 5 * sample) * std::max(peak / tolerance, 1.0));
    for (const Style &style : styles)
        if (style.kind == StyleKind::Feathering) // its tail reaches far where ξ2 is small
            r2 = std::max(r2, std::log(std::max(peak / style.xi[0], 1e-6)) + std::log(1 / unseen) / style.xi[1]);
    return std::sqrt(std::clamp(r2, 6.0, 80.0));
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
    const double xi1 = style.xi[0], xi2 = style.xi[1];
    switch (style.kind) {
    case StyleKind::Uniform:
        return unseen * 4 * xi2;
    case StyleKind::Feathering:
        return unseen * xi1 / std::max(xi2, 1.0);
    case StyleKind::Edge:
        break;
    }
    // A jump: the pixel's width alone softens it. It spans 2h = |∇φ| px of density, |∇φ| = 2uφ/s at u spreads from a line.
    const double edge = math::Edge<double>(xi1, xi2, style.xi[2]).phiE;
    const double u = std::sqrt(std::max(std::log(peak / edge), 0.25));
    return unseen * 2 * u * edge / std::max(spreadPixels, 1.0);
}

namespace {

/// One segment's Level 0 nodes, before they are put together.
struct Built {
    std::vector<Node> nodes;
    NodeValues values;
    SegmentReach reach;
    double epsilon = 0; ///< error budget relative to the peak
    double peak = 0;
    bool clipped = false;   ///< to the view
    bool mergeable = false; ///< isotropic, dry, not clipped, and not too exact
};

/// False: nothing to be seen.
bool buildSegment(const Stroke &stroke, const Segment &segment, const std::vector<Style> &styles, Microseconds T,
                  double scale, const Rect &clip, Built &out)
{
    const double across = segment.spread(T);
    const double along = across * std::sqrt(double(segment.anisotropyRatio));
    const double spread = std::min(across, along), larger = std::max(across, along);
    if (!(across > 0) || segment.density <= 0 || larger * scale < thinnest)
        return false;
    out.peak = segment.density / (std::sqrt(std::numbers::pi) * spread);
    double tolerance = 1e300;
    for (const Style &style : styles)
        tolerance = std::min(tolerance, densityTolerance(style, out.peak, spread * scale));
    out.epsilon = std::clamp(tolerance / out.peak, spread * scale > deepSpread ? finestDeep : finest, coarsest);

    Source s{};
    for (int i = 0; i < 4; ++i)
        s.curve.p[i] = Point{} + segment.bezier[i];
    setMetric(s, segment, across);
    s.speedScale = 1 / spread;
    s.gain = segment.density * std::sqrt(s.a * s.c - s.b * s.b) / std::numbers::pi;
    s.radius = cutRadius(tolerance, styles, out.peak, spread * scale);
    s.reach = s.radius * larger;
    out.clipped = polygonLength(s.curve) > longSegment * spread;
    if (out.clipped)
        s.clip = {clip.left - stroke.origin.x, clip.top - stroke.origin.y, clip.right - stroke.origin.x,
                  clip.bottom - stroke.origin.y};
    const double chord = length(s.curve.p[3] - s.curve.p[0]);
    addPanels(s, s.curve, out.epsilon * std::min(1.0, chord / (4 * spread) + 0.1), 0, out.nodes);
    out.values = {segment.colour, segment.granulation, stroke.styleOf(segment)};
    out.reach = {spread, s.curve.controlBox().grown(reachInSpreads * larger)};
    out.mergeable = segment.isIsotropic() && !out.clipped && segment.driesAt() <= T && out.epsilon >= mergeable;
    return true;
}

/// Appends one segment as a group of its own.
void append(const Built &b, StrokeNodes &out)
{
    NodeGroup g;
    g.begin = std::uint32_t(out.nodes.size());
    out.nodes.insert(out.nodes.end(), b.nodes.begin(), b.nodes.end());
    g.end = std::uint32_t(out.nodes.size());
    g.row = std::uint32_t(out.rows.size());
    out.rows.push_back(b.values);
    g.reachBegin = std::uint32_t(out.reaches.size());
    out.reaches.push_back(b.reach);
    g.reachEnd = std::uint32_t(out.reaches.size());
    out.groups.push_back(g);
}

/// Appends a run of segments of one spread and style with fewer nodes, a group for each window.
void appendMerged(const Built *run, std::size_t count, StrokeNodes &out)
{
    const double s = run[0].reach.spread;
    double epsilon = 1;
    std::vector<SpanNode> fine;
    std::vector<float> radii;
    std::vector<std::size_t> firstNode; // of each segment
    for (std::size_t k = 0; k < count; ++k) {
        const Built &b = run[k];
        epsilon = std::min(epsilon, b.epsilon);
        firstNode.push_back(fine.size());
        const Colour &c = b.values.colour;
        for (const Node &n : b.nodes) {
            fine.push_back({n.x / s, n.y / s, n.weight, b.epsilon * b.peak,
                            {c.red, c.yellow, c.blue, c.opacity, b.values.granulation}});
            radii.push_back(n.cutRadius);
        }
    }
    const double metric = 1 / (s * s);
    std::size_t segment = 0;
    for (const SpanWindow &window : mergeSpan(fine, epsilon)) {
        NodeGroup g;
        g.begin = std::uint32_t(out.nodes.size());
        g.row = std::uint32_t(out.rows.size());
        const auto differ = [&](const SpanNode &n) { return n.values != window.nodes[0].values; };
        g.rowPerNode = std::any_of(window.nodes.begin(), window.nodes.end(), differ);
        const float radius = *std::max_element(radii.begin() + std::ptrdiff_t(window.begin),
                                               radii.begin() + std::ptrdiff_t(window.end));
        for (const SpanNode &n : window.nodes) {
            out.nodes.push_back({n.x * s, n.y * s, metric, 0, metric, n.weight, radius});
            if (g.rowPerNode || out.rows.size() == g.row) {
                const auto &v = n.values;
                out.rows.push_back(
                    {{float(v[0]), float(v[1]), float(v[2]), float(v[3])}, float(v[4]), run[0].values.style});
            }
        }
        g.end = std::uint32_t(out.nodes.size());
        g.reachBegin = std::uint32_t(out.reaches.size());
        for (; segment < count && firstNode[segment] < window.end; ++segment)
            out.reaches.push_back(run[segment].reach);
        g.reachEnd = std::uint32_t(out.reaches.size());
        out.groups.push_back(g);
    }
}

/// Appends a block's segments, merging runs of them if all are dry.
void appendBlock(const std::vector<Built> &block, StrokeNodes &out)
{
    const bool merge = std::all_of(block.begin(), block.end(), [](const Built &b) { return b.mergeable; });
    const auto together = [](const Built &a, const Built &b) {
        return a.reach.spread == b.reach.spread && a.values.style == b.values.style;
    };
    for (std::size_t i = 0; i < block.size();) {
        std::size_t end = i + 1, nodes = block[i].nodes.size();
        while (merge && end < block.size() && together(block[i], block[end]))
            nodes += block[end++].nodes.size();
        if (end - i > 1 && nodes > 0)
            appendMerged(&block[i], end - i, out);
        else
            append(block[i], out);
        i = end;
    }
}

} // namespace

std::shared_ptr<const StrokeNodes> buildNodes(const Stroke &stroke, Microseconds T, int octave, const Rect &clip)
{
    auto result = std::make_shared<StrokeNodes>();
    std::vector<Style> styles; // every segment's density passes through all of the stroke's styles
    for (const Segment &segment : stroke.segments)
        if (std::find(styles.begin(), styles.end(), stroke.styleOf(segment)) == styles.end())
            styles.push_back(stroke.styleOf(segment));

    std::vector<Built> block;
    for (std::size_t first = 0; first < stroke.segments.size(); first += mergeBlock) {
        block.clear();
        const std::size_t last = std::min(first + mergeBlock, stroke.segments.size());
        for (std::size_t k = first; k < last; ++k) {
            const Segment &segment = stroke.segments[k];
            Built built;
            if (!buildSegment(stroke, segment, styles, T, std::ldexp(1.0, octave), clip, built))
                continue;
            result->clipped |= built.clipped;
            block.push_back(std::move(built));
        }
        appendBlock(block, *result);
    }
    return result;
}

} // namespace suffuse
