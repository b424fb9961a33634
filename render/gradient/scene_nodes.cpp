#include "render/gradient/scene_nodes.h"

#include "render/gradient/tile_data.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suffuse::gradient {

namespace {

/// The similarity of a view as a matrix: pixel = matrix · canvas + shift.
struct ViewMatrix {
    double xx, xy, yx, yy, shiftX, shiftY, scale;

    explicit ViewMatrix(const View &view) : scale(view.scale)
    {
        const double c = view.scale * std::cos(view.rotation), s = view.scale * std::sin(view.rotation);
        const double side = view.mirrored ? -1 : 1;
        xx = side * c, xy = -s, yx = side * s, yy = c;
        const Point at = view.toPixels({0, 0});
        shiftX = at.x, shiftY = at.y;
    }
};

struct Vector2 {
    double x = 0, y = 0;
};

/// The control points of a segment in pixels.
struct PixelCurve {
    double x[4], y[4];

    PixelCurve(const SegmentNumbers &s, const ViewMatrix &map)
    {
        for (int i = 0; i < 4; ++i) {
            x[i] = map.xx * s.x[i] + map.xy * s.y[i] + map.shiftX;
            y[i] = map.yx * s.x[i] + map.yy * s.y[i] + map.shiftY;
        }
    }
    Vector2 sum(const double (&weights)[4]) const
    {
        Vector2 at;
        for (int i = 0; i < 4; ++i)
            at.x += weights[i] * x[i], at.y += weights[i] * y[i];
        return at;
    }
};

/// Derivatives by four points in pixels.
struct PixelSlopes {
    double x[4] = {}, y[4] = {};

    /// Adds those by one of them to those by a control point.
    void addTo(const ViewMatrix &map, int from, SegmentNumbers &by, int point) const
    {
        by.x[point] += map.xx * x[from] + map.yx * y[from];
        by.y[point] += map.xy * x[from] + map.yy * y[from];
    }
};

/// What the weight of a segment's nodes is for φˢ = 1 and a speed of 1 pixel, but for that of the quadrature.
double weightScale(const SegmentNumbers &s, const SegmentRule &rule, const ViewMatrix &map, bool lift)
{
    const double spread = s.spread * map.scale;
    return (lift ? -1 : 1) * rule.gain * map.scale / (std::numbers::pi * spread * spread);
}

bool isLift(const FlatScene &scene, std::size_t segment)
{
    return !scene.marks.empty() && scene.marks[segment].lift;
}

void includeNode(SceneNodes &out, PixelSegment &segment, std::size_t i, const PixelNode &node)
{
    out.nodes[i] = node;
    out.x[i] = float(node.x), out.y[i] = float(node.y), out.strength[i] = float(std::fabs(node.weight));
    segment.left = std::min(segment.left, out.x[i]), segment.right = std::max(segment.right, out.x[i]);
    segment.top = std::min(segment.top, out.y[i]), segment.bottom = std::max(segment.bottom, out.y[i]);
}

void placeSegment(const FlatScene &scene, const NodeRules &rules, const ViewMatrix &map, std::size_t k, SceneNodes &out)
{
    const SegmentNumbers &s = scene.segments[k];
    const SegmentRule &rule = rules.segments[k];
    PixelSegment &segment = out.segments[k];
    const double spread = s.spread * map.scale;
    segment.first = rule.first, segment.end = rule.end;
    segment.lift = isLift(scene, k);
    segment.fade = !scene.marks.empty() && scene.marks[k].fade;
    segment.inverse = 1 / spread, segment.reach = rule.radius * spread, segment.cut = rule.cut;
    const PixelCurve curve(s, map);
    const double gain = s.density * weightScale(s, rule, map, segment.lift);
    for (std::size_t i = rule.first; i < rule.end; ++i) {
        const RuleNode &node = rules.nodes[i];
        const Vector2 at = curve.sum(node.point), slope = curve.sum(node.slope);
        includeNode(out, segment, i,
                    {at.x, at.y, gain * node.weight * std::sqrt(slope.x * slope.x + slope.y * slope.y)});
    }
}

/// The four points that a node on an outline is a sum of.
PixelCurve curveOf(const FlatScene &scene, const OutlineNode &node, const ViewMatrix &map)
{
    PixelCurve curve(scene.segments[node.segment], map);
    if (node.closing) {
        const PixelCurve begin(scene.segments[node.closesTo], map);
        curve.x[0] = curve.x[3], curve.y[0] = curve.y[3];
        curve.x[1] = begin.x[0], curve.y[1] = begin.y[0];
    }
    return curve;
}

/// The weight of a fill's node for ρ = 1 and dy = 1 pixel, but for its sign.
double weightScale(const FlatStroke &stroke, const OutlineRule &rule, const ViewMatrix &map)
{
    return rule.gain / (std::sqrt(std::numbers::pi) * stroke.fill.spread * map.scale);
}

std::vector<OutlinePlace> placesOf(const FlatScene &scene, const OutlineRules &rules, const OutlineRule &rule,
                                   const ViewMatrix &map)
{
    std::vector<OutlinePlace> places;
    for (std::size_t i = rule.first; i < rule.end; ++i) {
        const OutlineNode &node = rules.nodes[i];
        const PixelCurve curve = curveOf(scene, node, map);
        const Vector2 at = curve.sum(node.point);
        places.push_back({at.x, at.y, node.weight * curve.sum(node.slope).y});
    }
    return places;
}

void placeFill(const FlatScene &scene, const NodeRules &rules, const ViewMatrix &map, std::size_t f, SceneNodes &out)
{
    const OutlineRule &rule = rules.outlines.fills[f];
    const FlatStroke &stroke = scene.strokes[rule.stroke];
    PixelSegment &segment = out.segments[scene.segments.size() + f];
    out.fills[rule.stroke] = std::uint32_t(scene.segments.size() + f);
    const double spread = stroke.fill.spread * map.scale;
    const auto before = std::uint32_t(rules.nodes.size());
    segment.stroke = rule.stroke, segment.outline = true;
    segment.first = before + rule.first, segment.end = before + rule.end;
    segment.inverse = 1 / spread, segment.reach = rule.radius * spread, segment.cut = rule.cut;
    const std::vector<OutlinePlace> places = placesOf(scene, rules.outlines, rule, map);
    const double gain = stroke.fill.density * senseOf(places) * weightScale(stroke, rule, map);
    for (std::size_t i = 0; i < places.size(); ++i)
        includeNode(out, segment, segment.first + i, {places[i].x, places[i].y, gain * places[i].rise});
    PixelSegment &inside = out.segments[insideOf(out, out.fills[rule.stroke])];
    inside.stroke = rule.stroke;
    inside.first = before + std::uint32_t(rules.outlines.nodes.size() + f), inside.end = inside.first + 1;
    inside.reach = 1e9;
    includeNode(out, inside, inside.first, {0, 0, stroke.fill.density});
}

void segmentToNumbers(const FlatScene &scene, const NodeRules &rules, const ViewMatrix &map, std::size_t k,
                      const std::vector<NodeSum> &sums, SegmentNumbers &by)
{
    const SegmentNumbers &s = scene.segments[k];
    const SegmentRule &rule = rules.segments[k];
    const PixelCurve curve(s, map);
    const double scale = weightScale(s, rule, map, isLift(scene, k));
    double spread = 0;
    PixelSlopes slopes;
    for (std::size_t i = rule.first; i < rule.end; ++i) {
        const RuleNode &node = rules.nodes[i];
        const NodeSum &sum = sums[i];
        const Vector2 slope = curve.sum(node.slope);
        const double speed = std::sqrt(slope.x * slope.x + slope.y * slope.y);
        const double perSpeed = scale * node.weight;
        by.density += sum.weight * perSpeed * speed;
        spread += sum.spread - 2 * sum.weight * s.density * perSpeed * speed / (s.spread * map.scale);
        const double bySpeed = speed > 0 ? sum.weight * s.density * perSpeed / speed : 0;
        for (int j = 0; j < 4; ++j) {
            slopes.x[j] += sum.x * node.point[j] + bySpeed * slope.x * node.slope[j];
            slopes.y[j] += sum.y * node.point[j] + bySpeed * slope.y * node.slope[j];
        }
    }
    by.spread += spread * map.scale;
    for (int j = 0; j < 4; ++j)
        slopes.addTo(map, j, by, j);
}

void fillToNumbers(const FlatScene &scene, const NodeRules &rules, const ViewMatrix &map, std::size_t f,
                   const std::vector<NodeSum> &sums, FlatGradient &out)
{
    const OutlineRule &rule = rules.outlines.fills[f];
    const FlatStroke &stroke = scene.strokes[rule.stroke];
    FillNumbers &by = out.strokes[rule.stroke].fill;
    by.density += sums[rules.nodes.size() + rules.outlines.nodes.size() + f].weight; // far inside
    const std::vector<OutlinePlace> places = placesOf(scene, rules.outlines, rule, map);
    const double scale = senseOf(places) * weightScale(stroke, rule, map), spread = stroke.fill.spread * map.scale;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const OutlineNode &node = rules.outlines.nodes[rule.first + i];
        const NodeSum &sum = sums[rules.nodes.size() + rule.first + i];
        const double perRise = stroke.fill.density * scale * node.weight;
        by.density += sum.weight * scale * places[i].rise;
        by.spread += (sum.spread - sum.weight * stroke.fill.density * scale * places[i].rise / spread) * map.scale;
        PixelSlopes slopes;
        for (int j = 0; j < 4; ++j) {
            slopes.x[j] = sum.x * node.point[j];
            slopes.y[j] = sum.y * node.point[j] + sum.weight * perRise * node.slope[j];
        }
        for (int j = 0; j < (node.closing ? 2 : 4); ++j)
            slopes.addTo(map, j, out.segments[node.closing && j == 1 ? node.closesTo : node.segment],
                         node.closing ? 3 * (1 - j) : j);
    }
}

} // namespace

void placeNodes(const FlatScene &scene, const NodeRules &rules, SceneNodes &out)
{
    out.fillCount = rules.outlines.fills.size();
    const std::size_t nodes = rules.nodes.size() + rules.outlines.nodes.size() + out.fillCount;
    out.nodes.resize(nodes);
    for (auto *numbers : {&out.x, &out.y, &out.strength})
        numbers->resize(nodes + searchMargin); // for whole vectors
    out.segments.assign(rules.segments.size() + 2 * out.fillCount, {});
    out.fills.assign(scene.strokes.size(), noFill);
    const ViewMatrix map(scene.view);
    for (std::size_t i = 0; i < scene.strokes.size(); ++i)
        for (std::size_t k = scene.strokes[i].first; k < scene.strokes[i].first + scene.strokes[i].count; ++k) {
            out.segments[k].stroke = std::uint32_t(i);
            placeSegment(scene, rules, map, k, out);
        }
    for (std::size_t f = 0; f < rules.outlines.fills.size(); ++f)
        placeFill(scene, rules, map, f, out);
}

void nodesToNumbers(const FlatScene &scene, const NodeRules &rules, const std::vector<NodeSum> &sums, FlatGradient &out)
{
    const ViewMatrix map(scene.view);
    for (std::size_t k = 0; k < scene.segments.size(); ++k)
        segmentToNumbers(scene, rules, map, k, sums, out.segments[k]);
    for (std::size_t f = 0; f < rules.outlines.fills.size(); ++f)
        fillToNumbers(scene, rules, map, f, sums, out);
}

} // namespace suffuse::gradient
