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
constexpr double nearlyLevel = 0.05;  // of the budget, where a jump may show in paint that is nearly level
constexpr double thinnest = 0x1p-13;  // In px: a line of this spread covers less than 1/512 of a pixel.
constexpr double greatestSquare = 80; // of R, in spreads
constexpr double cutShare = 0.35;     // the share of the tolerance for cutting nodes off at R
// The kernel b(u)b(v), b(u) = e^(−u²) − e^(−R²), takes between 1 and 5 e^(−R²) of its peak from a long line, depending
// on the direction of the line. Raising the weights by 3.5 e^(−R²) leaves −2.5 to 0.7, and for oblique nodes −3.3 to
// −0.4.
constexpr double cutGain = 3.5;
constexpr double lossSeparable = 2.5, lossOblique = 3.3, lossUnraised = 5;
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

panels::Curve whitened(const Source &s, const panels::Curve &curve)
{
    const panels::Vector from{s.curve.p[0].x, s.curve.p[0].y};
    const auto white = [&](panels::Vector p) {
        const panels::Vector d = p - from;
        return panels::Vector{s.wxx * d.x + s.wxy * d.y, s.wxy * d.x + s.wyy * d.y};
    };
    return {white(curve.a), white(curve.b), white(curve.c), white(curve.d)};
}

panels::Curve scaled(const Source &s, const panels::Curve &curve)
{
    return panels::scaledFrom(curve, {s.curve.p[0].x, s.curve.p[0].y}, s.speedScale);
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

void addPanel(const Source &s, const panels::Curve &curve, int n, UnsetVector<Node> &out)
{
    const QuadratureRule &rule = gaussLegendre(n);
    for (int i = 0; i < n; ++i) {
        const panels::Vector at = panels::pointAt(curve, rule.x[i]);
        const double weight = s.gain * rule.weight[i] * panels::size(panels::derivativeAt(curve, rule.x[i]));
        if (weight > 0)
            out.push_back({at.x, at.y, s.a, s.b, s.c, weight, float(s.radius)});
    }
}

/// Tells whether a piece reaches into the clip.
bool isNear(const Source &s, const panels::Curve &piece)
{
    if (s.clip.isEmpty())
        return true;
    Rect box;
    for (const panels::Vector p : {piece.a, piece.b, piece.c, piece.d})
        box.include({p.x, p.y});
    return box.grown(s.reach).intersects(s.clip);
}

/// Adds panels. Once `out` has `most` nodes, what is left gets few nodes, so that no painting, however extreme, takes
/// memory without end.
void addPanels(const Source &s, double tolerance, std::size_t most, UnsetVector<Node> &out)
{
    const panels::Curve curve = panelCurve(s.curve);
    panels::Place place;
    for (bool more = true; more;) {
        const panels::Curve piece = place.piece(curve);
        if (!isNear(s, piece)) {
            more = place.next();
            continue;
        }
        const panels::Curve metric = scaled(s, piece);
        const double allowed = place.tolerance(tolerance);
        int n = panelNodes(s.isotropic ? metric : whitened(s, piece), metric, allowed);
        if (n == 0 && (place.depth == panels::mostHalvings || out.size() >= most || panels::isTiny(metric, allowed)))
            n = panels::anyRule;
        if (n == 0) {
            place.halve();
            continue;
        }
        addPanel(s, piece, n, out);
        more = place.next();
    }
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
    return std::sqrt(std::clamp(r2, 6.0, greatestSquare));
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

Rect greatestReach(const Stroke &stroke, Microseconds T)
{
    // In spreads, and one more that stand for several may lie a little beside the curve.
    const double radius = std::sqrt(greatestSquare) + 1;
    Rect box;
    for (const Segment &segment : stroke.segments)
        if (const Axes axes(segment, T); axes.across > 0)
            box = box.united(stroke.cubicOf(segment).controlBox().grown(radius * axes.larger));
    if (stroke.fill && stroke.fill->age(T) > 0) {
        const double larger = stroke.fill->spread(T) * std::sqrt(std::max(1.0, double(stroke.fill->anisotropyRatio)));
        for (const Segment &segment : stroke.segments)
            if (!segment.takesPaint()) // The hull of the boxes contains the area.
                box = box.united(stroke.cubicOf(segment).controlBox().grown(radius * larger));
    }
    return box;
}

bool isSeen(const Segment &segment, Microseconds T, double scale)
{
    return isSeen(segment, Axes(segment, T), scale);
}

namespace {

/// Describes the segment, and makes it ready to be cut into panels.
bool describe(const Stroke &stroke, const Segment &segment, const NodeContext &context, double scale, SegmentNodes &out,
              Source &s)
{
    static const std::vector<Style> none;
    // What fades passes through no style: an error of its density is at most one of the opacity.
    const std::vector<Style> &styles = segment.fade ? none : context.styles;
    const Axes axes(segment, context.T);
    if (!isSeen(segment, axes, scale))
        return false;
    const double spread = axes.smaller, larger = axes.larger;
    out.peak = segment.density / (std::sqrt(std::numbers::pi) * spread);
    double tolerance = segment.fade ? unseen : 1e300;
    // Where a segment alone has too little density for the style to show, several lie on top of each other, and their
    // errors add up.
    for (const Style &style : styles)
        tolerance = std::min(tolerance, densityTolerance(style, out.peak, spread * scale) *
                                            std::min(1.0, out.peak / shownFrom(style)));
    // What is left of paint may fall more gently than the segment itself, so that a jump is less softened.
    if (segment.lift)
        tolerance *= 0.5;
    out.epsilon = std::clamp(tolerance / out.peak, spread * scale > deepSpread ? finestDeep : finest, coarsest);
    // Passes beside each other make paint that is nearly level, where a pixel covers much less density than at the edge
    // of one line. The budget is not made so small that nodes could not be merged.
    if (std::ranges::any_of(styles, [](const Style &style) { return style.kind == StyleKind::Edge; }))
        out.epsilon = std::max(nearlyLevel * out.epsilon, std::min(out.epsilon, mergeable));

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
    out.length = polygon / spread;
    out.gain = s.gain;
    out.tolerance = out.epsilon * std::min(1.0, chord / (4 * spread) + 0.1);
    out.isotropic = s.isotropic;
    if (segment.takesPaint())
        out.values = {{}, 1, stroke.style, segment.lift, segment.fade};
    else
        out.values = {segment.colour, segment.granulation, stroke.styleOf(segment)};
    if (segment.lift)
        out.weightGain = -out.weightGain;
    out.spread = spread;
    const double fineness = segment.lift ? liftFineness : segment.fade ? fadeFineness : 1;
    out.reach = {spread / fineness, box.grown(reachInSpreads * larger)};
    out.mergeable = segment.isIsotropic() && !out.clipped && segment.driesAt() <= context.T && out.epsilon >= mergeable;
    return true;
}

} // namespace

bool describeSegment(const Stroke &stroke, const Segment &segment, const NodeContext &context, double scale,
                     SegmentNodes &out)
{
    Source source{};
    return describe(stroke, segment, context, scale, out, source);
}

bool buildSegment(const Stroke &stroke, const Segment &segment, const NodeContext &context, double scale,
                  UnsetVector<Node> &nodes, SegmentNodes &out)
{
    Source source{};
    if (!describe(stroke, segment, context, scale, out, source))
        return false;
    out.begin = nodes.size();
    addPanels(source, out.tolerance, out.begin + mostNodes, nodes);
    out.end = nodes.size();
    return true;
}

namespace {

/// Tells whether nodes have the same values in floats, as rows hold them.
bool sameRow(const SpanNode &a, const SpanNode &b)
{
    return std::ranges::equal(a.values, b.values, [](double x, double y) { return float(x) == float(y); });
}

} // namespace

void appendGroup(const SegmentNodes &b, std::size_t begin, StrokeNodes &out)
{
    NodeGroup g;
    g.begin = std::uint32_t(begin);
    g.end = std::uint32_t(out.nodes.size());
    for (std::size_t i = begin; i < out.nodes.size(); ++i)
        out.nodes[i].weight *= b.weightGain;
    g.row = std::uint32_t(out.rows.size());
    out.rows.push_back(b.values);
    g.reachBegin = std::uint32_t(out.reaches.size());
    out.reaches.push_back(b.reach);
    g.reachEnd = std::uint32_t(out.reaches.size());
    out.groups.push_back(g);
}

void appendWindows(std::span<const SegmentNodes> run, const MergedSpan &merged, StrokeNodes &out)
{
    const double s = run[0].spread, metric = 1 / (s * s);
    const NodeValues &values = run[0].values; // All segments of the run have its style, and take paint away as it does.
    const std::size_t origin = run[0].begin;
    std::size_t first = 0, next = 0; // the first segments of the window and of the next one
    for (const SpanWindow &window : merged.windows) {
        float radius = 0;
        double gain = 1;
        while (run[first].end - origin <= window.begin)
            ++first;
        for (std::size_t k = first; k < run.size() && run[k].begin - origin < window.end; ++k)
            if (run[k].radius > radius)
                radius = run[k].radius, gain = run[k].weightGain;
        const std::span nodes(&merged.nodes[window.nodes], window.nodesEnd - window.nodes);
        NodeGroup g;
        g.begin = std::uint32_t(out.nodes.size());
        g.row = std::uint32_t(out.rows.size());
        g.rowPerNode = std::ranges::any_of(nodes, [&](const SpanNode &n) { return !sameRow(n, nodes[0]); });
        for (const SpanNode &n : nodes) {
            out.nodes.push_back({n.x * s, n.y * s, metric, 0, metric, n.weight * gain, radius});
            if (g.rowPerNode || out.rows.size() == g.row) {
                const auto &v = n.values;
                out.rows.push_back({{float(v[0]), float(v[1]), float(v[2]), float(v[3])},
                                    float(v[4]),
                                    values.style,
                                    values.lift,
                                    values.fade});
            }
        }
        g.end = std::uint32_t(out.nodes.size());
        g.reachBegin = std::uint32_t(out.reaches.size());
        for (; next < run.size() && run[next].begin - origin < window.end; ++next)
            out.reaches.push_back(run[next].reach);
        g.reachEnd = std::uint32_t(out.reaches.size());
        out.groups.push_back(g);
    }
}

void giveBackSpareRoom(StrokeNodes &nodes)
{
    nodes.nodes.shrink_to_fit();
    nodes.groups.shrink_to_fit();
    nodes.rows.shrink_to_fit();
    nodes.reaches.shrink_to_fit();
}

} // namespace suffuse
