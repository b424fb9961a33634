#include "render/gradient/outline_rule.h"

#include "render/nodes/level0.h"

#include <algorithm>
#include <cmath>

namespace suffuse::gradient {

namespace {

constexpr int nodesOfPanel = 5;        // errors are some 1e-6 of ρ
constexpr double panelLength = 1.5;    // in spreads
constexpr double greatestPanels = 512; // of a curve

/// The number of panels of a curve whose control polygon is so long, in spreads.
int panelsOf(double length)
{
    return int(std::clamp(std::ceil(length / panelLength), 1.0, greatestPanels));
}

template <class Set>
void addPanels(int count, OutlineNode node, Set set, std::vector<OutlineNode> &out)
{
    const QuadratureRule &rule = gaussLegendre(nodesOfPanel);
    for (int panel = 0; panel < count; ++panel)
        for (std::size_t i = 0; i < nodesOfPanel; ++i) {
            set(node, (panel + rule.x[i]) / count);
            node.weight = rule.weight[i] / count;
            out.push_back(node);
        }
}

void setCubic(OutlineNode &node, double p)
{
    const double q = 1 - p;
    const double point[4] = {q * q * q, 3 * q * q * p, 3 * q * p * p, p * p * p};
    const double slope[4] = {-3 * q * q, 3 * q * (q - 2 * p), 3 * p * (2 * q - p), 3 * p * p};
    std::copy_n(point, 4, node.point);
    std::copy_n(slope, 4, node.slope);
}

void setLine(OutlineNode &node, double p)
{
    node.point[0] = 1 - p, node.point[1] = p;
    node.slope[0] = -1, node.slope[1] = 1;
}

double polygonOf(const SegmentNumbers &s)
{
    double length = 0;
    for (int i = 1; i < 4; ++i)
        length += std::hypot(s.x[i] - s.x[i - 1], s.y[i] - s.y[i - 1]);
    return length;
}

bool isMarked(const FlatScene &scene, std::size_t segment, bool SegmentMark::*mark)
{
    return !scene.marks.empty() && scene.marks[segment].*mark;
}

void addOutline(const FlatScene &scene, const FlatStroke &stroke, std::vector<OutlineNode> &out)
{
    const double spread = std::max(stroke.fill.spread, 1e-9);
    const auto close = [&](std::uint32_t first, std::uint32_t last) {
        OutlineNode line;
        line.segment = last, line.closesTo = first, line.closing = true;
        const SegmentNumbers &a = scene.segments[last], &b = scene.segments[first];
        addPanels(panelsOf(std::hypot(b.x[0] - a.x[3], b.y[0] - a.y[3]) / spread), line, setLine, out);
    };
    bool open = false; // a chain that lays paint
    std::uint32_t first = 0, last = 0;
    for (std::uint32_t k = stroke.first; k < stroke.first + stroke.count; ++k) {
        const bool takes = !scene.marks.empty() && scene.marks[k].takesPaint();
        if (open && (takes || isMarked(scene, k, &SegmentMark::start)))
            close(first, last), open = false;
        if (takes)
            continue;
        if (!open)
            first = k, open = true;
        last = k;
        OutlineNode curve;
        curve.segment = k;
        addPanels(panelsOf(polygonOf(scene.segments[k]) / spread), curve, setCubic, out);
    }
    if (open)
        close(first, last);
}

using Polygon = std::vector<Point>;

/// The nodes' places, a polygon for each chain.
std::vector<Polygon> polygonsOf(const FlatScene &scene, const OutlineRules &rules, const OutlineRule &rule)
{
    std::vector<Polygon> out(1);
    for (std::size_t i = rule.first; i < rule.end; ++i) {
        const OutlineNode &node = rules.nodes[i];
        const SegmentNumbers &s = scene.segments[node.segment], &begin = scene.segments[node.closesTo];
        Point at;
        if (node.closing)
            at = {node.point[0] * s.x[3] + node.point[1] * begin.x[0],
                  node.point[0] * s.y[3] + node.point[1] * begin.y[0]};
        else
            for (int j = 0; j < 4; ++j)
                at.x += node.point[j] * s.x[j], at.y += node.point[j] * s.y[j];
        out.back().push_back(at);
        if (node.closing && i + 1 < rule.end && !rules.nodes[i + 1].closing)
            out.emplace_back();
    }
    return out;
}

/// How often polygons go round a point.
int windingOf(const std::vector<Polygon> &polygons, Point at)
{
    int winding = 0;
    for (const Polygon &polygon : polygons)
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
            const double side = (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x);
            if (a.y <= at.y && b.y > at.y && side > 0)
                ++winding;
            if (a.y > at.y && b.y <= at.y && side < 0)
                --winding;
        }
    return winding;
}

} // namespace

bool crossesItself(const FlatScene &scene, const OutlineRules &rules, const OutlineRule &rule)
{
    constexpr std::size_t mostPlaces = 200;
    const std::vector<Polygon> polygons = polygonsOf(scene, rules, rule);
    const double beside = 0.02 * scene.strokes[rule.stroke].fill.spread;
    int least = 0, most = 0;
    const std::size_t stride = 1 + (rule.end - rule.first) / mostPlaces;
    for (const Polygon &polygon : polygons)
        for (std::size_t i = 0; i + 1 < polygon.size(); i += stride) {
            const Point a = polygon[i], b = polygon[i + 1];
            const double length = std::hypot(b.x - a.x, b.y - a.y);
            if (length == 0)
                continue;
            for (const double side : {-beside, beside}) {
                const Point at{0.5 * (a.x + b.x) - side * (b.y - a.y) / length,
                               0.5 * (a.y + b.y) + side * (b.x - a.x) / length};
                const int winding = windingOf(polygons, at);
                least = std::min(least, winding), most = std::max(most, winding);
            }
        }
    return most - least > 1;
}

OutlineRules chooseOutlines(const FlatScene &scene, double unseen)
{
    OutlineRules rules;
    for (std::size_t i = 0; i < scene.strokes.size(); ++i) {
        const FlatStroke &stroke = scene.strokes[i];
        if (!stroke.filled)
            continue;
        OutlineRule rule;
        rule.stroke = std::uint32_t(i);
        // An error of density shows by the slope of the style: at most as if all of its opacity came within ξ2.
        const double allowed = unseen * 0.25 * std::min(stroke.xi[0], std::max(stroke.xi[1], 1e-3));
        const double square = std::log(4 * std::max(stroke.fill.density, 1e-6) / allowed);
        rule.radius = std::sqrt(std::clamp(square, 9.0, 40.0));
        rule.cut = std::exp(-rule.radius * rule.radius);
        // The integral of e^(−v²) − cut, over √π.
        rule.gain = 1 / (std::erf(rule.radius) - 2 * rule.radius * rule.cut * 0.56418958354775629);
        rule.first = std::uint32_t(rules.nodes.size());
        addOutline(scene, stroke, rules.nodes);
        rule.end = std::uint32_t(rules.nodes.size());
        rules.fills.push_back(rule);
    }
    return rules;
}

double senseOf(const std::vector<OutlinePlace> &places)
{
    double area = 0;
    for (const OutlinePlace &place : places)
        area += place.x * place.rise;
    return area > 0 ? -1 : 1;
}

} // namespace suffuse::gradient
