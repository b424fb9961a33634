#include "render/gradient/tile_list.h"

#include "render/math/scalar.h"
#include "render/math/shade_params.h"
// This header has templates over the numbers of scalar.h, which must be declared before it.
#include "render/math/style_slopes.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace suffuse::gradient {

namespace {

/// The density below which a style shows nothing at all. The kernels in float cut a tail off that those in double have.
float levelOf(const FlatStroke &stroke)
{
    const double x1 = stroke.xi[0], x2 = stroke.xi[1], x3 = stroke.xi[2];
    switch (stroke.kind) {
    case StyleKind::Uniform:
        return float(math::UniformSlopes<double>(x1, x2, x3).cut);
    case StyleKind::Feathering:
        return float(math::FeatheringSlopes<double>(x1, x2, x3).cut);
    case StyleKind::Edge:
        break;
    }
    return float(math::EdgeSlopes<double>(x1, x2, x3).phiE);
}

/// The distance of a place from the pixels of a tile, of which the first one has its centre at `low`.
float beyond(float place, float low)
{
    return std::max(std::fabs(place - (low + 7.5f)) - 7.5f, 0.0f);
}

/// Bounds of what nodes add to a density and to its slope in a tile.
struct TileBounds {
    float density = 0, slope = 0;

    void add(const SceneNodes &nodes, const PixelSegment &s, std::span<const std::uint32_t> near, float x, float y)
    {
        const auto inverse = float(s.inverse);
        for (const std::uint32_t i : near) {
            const float dx = beyond(nodes.x[i], x), dy = beyond(nodes.y[i], y);
            const float u2 = (dx * dx + dy * dy) * inverse * inverse, e = std::exp(-u2);
            if (!s.lift)
                density += nodes.strength[i] * e;
            slope += nodes.strength[i] * inverse * (u2 < 0.5f ? 0.8578f : (1 + u2) * e);
        }
    }
};

} // namespace

void StrokeFinder::prepare(const FlatScene &scene, const SceneNodes &nodes, int columns, int rows)
{
    m_scene = &scene, m_nodes = &nodes;
    m_rows.resize(std::size_t(rows));
    for (auto &row : m_rows)
        row.clear();
    for (std::size_t i = 0; i < scene.strokes.size(); ++i) {
        const FlatStroke &stroke = scene.strokes[i];
        Reach reach{std::uint32_t(i), 1e30f, 1e30f, -1e30f, -1e30f, levelOf(stroke), false};
        const auto include = [&](const PixelSegment &s) {
            const auto by = float(s.reach) + 1e-3f;
            reach.left = std::min(reach.left, s.left - by), reach.right = std::max(reach.right, s.right + by);
            reach.top = std::min(reach.top, s.top - by), reach.bottom = std::max(reach.bottom, s.bottom + by);
        };
        for (std::size_t k = stroke.first; k < stroke.first + stroke.count; ++k)
            if (const PixelSegment &s = nodes.segments[k]; s.first < s.end) {
                reach.fades |= s.fade;
                if (!s.fade)
                    include(s);
            }
        if (stroke.filled)
            include(nodes.segments[nodes.fills[i]]);
        if (!(reach.right >= 0 && reach.left <= float(columns * tileSide)))
            continue;
        const auto rowOf = [&](float y) { return int(std::clamp(std::floor(y / tileSide), -1.0f, float(rows))); };
        for (int row = std::max(rowOf(reach.top), 0); row <= std::min(rowOf(reach.bottom), rows - 1); ++row)
            m_rows[std::size_t(row)].push_back(reach);
    }
}

void StrokeFinder::list(int column, int row, TileList &out) const
{
    out.strokes.clear(), out.runs.clear(), out.nodes.clear();
    // The centres of the first and the last pixel of the tile.
    const float x = float(column * tileSide) + 0.5f, y = float(row * tileSide) + 0.5f;
    for (const Reach &reach : m_rows[std::size_t(row)])
        if (reach.left <= x + tileSide && reach.right >= x - 1 && reach.top <= y + tileSide && reach.bottom >= y - 1)
            addStroke(reach, x, y, out);
}

bool StrokeFinder::addRun(std::uint32_t segment, float x, float y, TileList &out) const
{
    const PixelSegment &s = m_nodes->segments[segment];
    const auto near = float(s.reach) + 1e-3f;
    const bool tooFarLeft = s.right < x - near && !s.outline;
    if (s.left > x + 15 + near || tooFarLeft || s.top > y + 15 + near || s.bottom < y - near)
        return false;
    const std::size_t first = out.nodes.size();
    out.nodes.resize(first + (s.end - s.first) + searchMargin);
    // Farther away a node is below what is cut off.
    const NodeSearch search{m_nodes->x.data(), m_nodes->y.data(), s.first, s.end, x, y, near, s.outline};
    const std::size_t end = first + m_findNodes(search, out.nodes.data() + first);
    out.nodes.resize(end);
    if (first == end)
        return false;
    out.runs.push_back({segment, std::uint32_t(first), std::uint32_t(end)});
    return true;
}

bool StrokeFinder::addFill(std::uint32_t fill, float x, float y, TileList &out) const
{
    const std::size_t before = out.nodes.size();
    if (!addRun(fill, x, y, out))
        return false;
    const PixelSegment &s = m_nodes->segments[fill];
    const auto near = float(s.reach), inverse = float(s.inverse);
    double within = 0; // the density in the middle of the tile, if its outline is far away
    for (const std::uint32_t i : std::span(out.nodes).subspan(before)) {
        if (beyond(m_nodes->x[i], x) <= near && beyond(m_nodes->y[i], y) <= near)
            return true;
        const float v = (m_nodes->y[i] - (y + 7.5f)) * inverse;
        within += m_nodes->nodes[i].weight * double(std::max(std::exp(-v * v) - float(s.cut), 0.0f));
    }
    const bool inside = std::fabs(within) > 0.5 * m_scene->strokes[s.stroke].fill.density;
    out.nodes.resize(before);
    out.runs.pop_back();
    if (!inside)
        return false;
    const std::uint32_t place = insideOf(*m_nodes, fill);
    out.nodes.push_back(m_nodes->segments[place].first);
    out.runs.push_back({place, std::uint32_t(before), std::uint32_t(before + 1)});
    return true;
}

void StrokeFinder::addStroke(const Reach &reach, float x, float y, TileList &out) const
{
    const FlatStroke &stroke = m_scene->strokes[reach.stroke];
    const auto firstRun = std::uint32_t(out.runs.size());
    const std::size_t firstNode = out.nodes.size();
    for (std::uint32_t k = stroke.first; reach.fades && k < stroke.first + stroke.count; ++k)
        if (m_nodes->segments[k].fade)
            addRun(k, x, y, out);
    const auto firstPaint = std::uint32_t(out.runs.size());
    TileBounds bounds; // as long as it is not sure that the stroke shows there
    for (std::uint32_t k = stroke.first; k < stroke.first + stroke.count; ++k) {
        const std::size_t before = out.nodes.size();
        if (!m_nodes->segments[k].fade && addRun(k, x, y, out) && bounds.density <= reach.level)
            bounds.add(*m_nodes, m_nodes->segments[k], std::span(out.nodes).subspan(before), x, y);
    }
    const bool fillSeen = stroke.filled && addFill(m_nodes->fills[reach.stroke], x, y, out);
    const bool isBare = out.runs.size() == firstPaint;
    if (isBare ||
        (!fillSeen && vanishes(stroke.kind, reach.level, bounds.density * 1.001f, 0.5f * bounds.slope * 1.001f))) {
        out.runs.resize(firstRun);
        out.nodes.resize(firstNode);
        return;
    }
    out.strokes.push_back({reach.stroke, firstRun, firstPaint, std::uint32_t(out.runs.size())});
}

} // namespace suffuse::gradient
