#include "render/gradient/node_rule.h"

#include "render/math/scalar.h"
#include "render/nodes/level0.h"
#include "render/nodes/node_builder.h"
// This header has templates over the numbers of scalar.h, which must be declared before it.
#include "render/math/style.h"

#include <cmath>
#include <numbers>

namespace suffuse::gradient {

namespace {

constexpr double unseenByRenderer = 5e-4; // what densityTolerance is made for
constexpr double coarsestBudget = 0x1p-12, finestBudget = 0x1p-42;
constexpr double greatestRadiusSquare = 80;
constexpr double shareOfCut = 0.35, lossOfLine = 2.5, gainOfCut = 3.5; // as in render/nodes/segment_nodes.cpp
constexpr double shareOfEdge = 0.05;
constexpr std::size_t mostNodesOfSegment = 4096;

struct Budget {
    double tolerance; // of the panels, relative to the peak
    double radius;
};

panels::Curve inSpreads(const SegmentNumbers &s)
{
    const auto at = [&](int i) { return panels::Vector{(s.x[i] - s.x[0]) / s.spread, (s.y[i] - s.y[0]) / s.spread}; };
    return {at(0), at(1), at(2), at(3)};
}

Style styleOf(const FlatStroke &stroke)
{
    return {stroke.kind, {float(stroke.xi[0]), float(stroke.xi[1]), float(stroke.xi[2])}};
}

/// Which error of a segment's density nobody sees.
double toleranceOf(const FlatStroke &stroke, bool fades, double peak, double spreadPixels, const Precision &precision)
{
    if (fades) // It passes through no style, and is at most one of the opacity.
        return precision.unseen;
    const bool edge = stroke.kind == StyleKind::Edge;
    const double shown = edge ? math::Edge<double>(stroke.xi[0], stroke.xi[1], stroke.xi[2]).phiE : stroke.xi[0];
    return precision.unseen / unseenByRenderer * densityTolerance(styleOf(stroke), peak, spreadPixels) *
           std::min(1.0, peak / shown);
}

/// Returns the budget of a segment, which follows from the segment, its style and the scale alone.
Budget budgetOf(const SegmentNumbers &s, bool fades, const panels::Curve &curve, const FlatStroke &stroke, double scale,
                const Precision &precision)
{
    const double peak = std::max(s.density / (std::sqrt(std::numbers::pi) * s.spread), 1e-12);
    const double spreadPixels = s.spread * scale, coarser = precision.unseen / unseenByRenderer;
    const double tolerance = toleranceOf(stroke, fades, peak, spreadPixels, precision);
    double epsilon = std::clamp(tolerance / peak, finestBudget, coarsestBudget * coarser);
    if (!fades && stroke.kind == StyleKind::Edge)
        epsilon = std::max(shareOfEdge * epsilon, finestBudget);
    const panels::Vector chord = curve.d - curve.a;
    const double polygon = panels::sumOfSides(curve), straight = panels::size(chord);
    const double folds = std::max(1.0, polygon / (straight + 0.5));
    const double sample = std::max(1.0, 1 / spreadPixels);
    double square = std::log((folds * lossOfLine + 3.5 * sample) / shareOfCut * std::max(1 / epsilon, 1.0));
    if (!fades && stroke.kind == StyleKind::Feathering) // Its tail reaches far if ξ2 is small.
        square = std::max(square, std::log(std::max(peak / stroke.xi[0], 1e-6)) +
                                      std::log(1 / precision.unseen) / stroke.xi[1]);
    return {epsilon * std::min(1.0, straight / 4 + 0.1), std::sqrt(std::clamp(square, 6.0, greatestRadiusSquare))};
}

void addRule(double from, double length, int count, std::vector<RuleNode> &out)
{
    const QuadratureRule &rule = gaussLegendre(count);
    for (int i = 0; i < count; ++i) {
        const double p = from + length * rule.x[std::size_t(i)], q = 1 - p;
        out.push_back({{q * q * q, 3 * q * q * p, 3 * q * p * p, p * p * p},
                       {-3 * q * q, 3 * q * (q - 2 * p), 3 * p * (2 * q - p), 3 * p * p},
                       length * rule.weight[std::size_t(i)]});
    }
}

/// Cuts the segment into panels as the renderer does.
void addPanelRules(const panels::Curve &curve, double tolerance, std::vector<RuleNode> &out)
{
    panels::Place place;
    for (bool more = true; more;) {
        const panels::Curve piece = place.piece(curve);
        const double allowed = place.tolerance(tolerance);
        int n = panelNodes(piece, piece, allowed);
        if (n == 0 &&
            (place.depth == panels::mostHalvings || out.size() >= mostNodesOfSegment || panels::isTiny(piece, allowed)))
            n = panels::anyRule;
        if (n == 0) {
            place.halve();
            continue;
        }
        const double length = std::ldexp(1.0, -place.depth);
        addRule(double(place.path) * length, length, n, out);
        more = place.next();
    }
}

} // namespace

NodeRules chooseNodes(const FlatScene &scene, const Precision &precision, const Threads &threads)
{
    NodeRules rules;
    rules.segments.resize(scene.segments.size());
    std::vector<std::vector<RuleNode>> ofStroke(scene.strokes.size());
    const auto choose = [&](std::size_t i) {
        const FlatStroke &stroke = scene.strokes[i];
        for (std::size_t k = stroke.first; k < stroke.first + stroke.count; ++k) {
            const SegmentNumbers &s = scene.segments[k];
            std::vector<RuleNode> nodes;
            SegmentRule &rule = rules.segments[k];
            const bool onlyOutline = stroke.filled && s.density == 0;
            if (s.spread > 0 && !onlyOutline) {
                const panels::Curve curve = inSpreads(s);
                const bool fades = !scene.marks.empty() && scene.marks[k].fade;
                const Budget budget = budgetOf(s, fades, curve, stroke, scene.view.scale, precision);
                rule.radius = budget.radius;
                rule.cut = std::exp(-budget.radius * budget.radius);
                rule.gain = 1 + gainOfCut * rule.cut;
                addPanelRules(curve, budget.tolerance, nodes);
            }
            rule.first = std::uint32_t(ofStroke[i].size());
            ofStroke[i].insert(ofStroke[i].end(), nodes.begin(), nodes.end());
            rule.end = std::uint32_t(ofStroke[i].size());
        }
    };
    parallelFor(scene.strokes.size(), threads, choose);
    for (std::size_t i = 0; i < ofStroke.size(); ++i) {
        const auto before = std::uint32_t(rules.nodes.size());
        const FlatStroke &stroke = scene.strokes[i];
        for (std::size_t k = stroke.first; k < stroke.first + stroke.count; ++k)
            rules.segments[k].first += before, rules.segments[k].end += before;
        rules.nodes.insert(rules.nodes.end(), ofStroke[i].begin(), ofStroke[i].end());
    }
    rules.outlines = chooseOutlines(scene, precision.unseen);
    return rules;
}

} // namespace suffuse::gradient
