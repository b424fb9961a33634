#include "render/gradient/scene_nodes.h"

#include "render/gradient/tile_kernels.h"

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

void placeSegment(const FlatScene &scene, const NodeRules &rules, const ViewMatrix &map, std::size_t k, SceneNodes &out)
{
    const SegmentNumbers &s = scene.segments[k];
    const SegmentRule &rule = rules.segments[k];
    PixelSegment &segment = out.segments[k];
    const double spread = s.spread * map.scale;
    segment.first = rule.first, segment.end = rule.end;
    segment.lift = isLift(scene, k);
    segment.inverse = 1 / spread, segment.reach = rule.radius * spread, segment.cut = rule.cut;
    segment.left = segment.top = 1e30f, segment.right = segment.bottom = -1e30f;
    const PixelCurve curve(s, map);
    const double gain = s.density * weightScale(s, rule, map, segment.lift);
    for (std::size_t i = rule.first; i < rule.end; ++i) {
        const RuleNode &node = rules.nodes[i];
        const Vector2 at = curve.sum(node.point), slope = curve.sum(node.slope);
        out.nodes[i] = {at.x, at.y, gain * node.weight * std::sqrt(slope.x * slope.x + slope.y * slope.y)};
        out.x[i] = float(at.x), out.y[i] = float(at.y), out.strength[i] = float(std::fabs(out.nodes[i].weight));
        segment.left = std::min(segment.left, float(at.x)), segment.right = std::max(segment.right, float(at.x));
        segment.top = std::min(segment.top, float(at.y)), segment.bottom = std::max(segment.bottom, float(at.y));
    }
}

} // namespace

void placeNodes(const FlatScene &scene, const NodeRules &rules, SceneNodes &out)
{
    out.nodes.resize(rules.nodes.size());
    for (auto *numbers : {&out.x, &out.y, &out.strength})
        numbers->resize(rules.nodes.size() + searchMargin); // for whole vectors
    out.segments.resize(rules.segments.size());
    const ViewMatrix map(scene.view);
    for (std::size_t i = 0; i < scene.strokes.size(); ++i)
        for (std::size_t k = scene.strokes[i].first; k < scene.strokes[i].first + scene.strokes[i].count; ++k) {
            out.segments[k].stroke = std::uint32_t(i);
            placeSegment(scene, rules, map, k, out);
        }
}

void nodesToSegments(const FlatScene &scene, const NodeRules &rules, const std::vector<NodeSum> &sums,
                     std::vector<SegmentNumbers> &out)
{
    const ViewMatrix map(scene.view);
    for (std::size_t k = 0; k < scene.segments.size(); ++k) {
        const SegmentNumbers &s = scene.segments[k];
        const SegmentRule &rule = rules.segments[k];
        SegmentNumbers &by = out[k];
        const PixelCurve curve(s, map);
        const double scale = weightScale(s, rule, map, isLift(scene, k));
        double x[4] = {}, y[4] = {}, density = 0, spread = 0;
        for (std::size_t i = rule.first; i < rule.end; ++i) {
            const RuleNode &node = rules.nodes[i];
            const NodeSum &sum = sums[i];
            const Vector2 slope = curve.sum(node.slope);
            const double speed = std::sqrt(slope.x * slope.x + slope.y * slope.y);
            const double perSpeed = scale * node.weight;
            density += sum.weight * perSpeed * speed;
            spread += sum.spread - 2 * sum.weight * s.density * perSpeed * speed / (s.spread * map.scale);
            const double bySpeed = speed > 0 ? sum.weight * s.density * perSpeed / speed : 0;
            for (int j = 0; j < 4; ++j) {
                x[j] += sum.x * node.point[j] + bySpeed * slope.x * node.slope[j];
                y[j] += sum.y * node.point[j] + bySpeed * slope.y * node.slope[j];
            }
        }
        for (int j = 0; j < 4; ++j) {
            by.x[j] = map.xx * x[j] + map.yx * y[j];
            by.y[j] = map.xy * x[j] + map.yy * y[j];
        }
        by.density = density;
        by.spread = spread * map.scale;
    }
}

} // namespace suffuse::gradient
