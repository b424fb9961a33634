#include "model/shaping/coarse_nodes.h"

#include "model/shaping/split.h"

#include <algorithm>
#include <numeric>

namespace suffuse {

namespace {

constexpr double cornerCosine = 0.985;  ///< of the angle between the directions at a corner, ten degrees
constexpr double cornerGap = 1.0 / 3;   ///< of the gap; corners may lie as near to each other
constexpr double unevenShare = 1.0 / 3; ///< of the way; a node in the middle by count must divide it as evenly
constexpr double polygonShare =
    1.0 / 2; ///< the weight of the polygon in a length, besides the chord; this is near enough for a screen

double roughLength(const Cubic &curve)
{
    return polygonShare * polygonLength(curve) + (1 - polygonShare) * length(curve.p[3] - curve.p[0]);
}

bool isSeenCorner(const Stroke &stroke, int node)
{
    const Segment &after = stroke.segments[std::size_t(node)];
    if (after.node == NodeKind::Corner)
        return true;
    const Point in = endDirection(offsetsOf(stroke.segments[std::size_t(node - 1)]));
    return dot(in, startDirection(offsetsOf(after))) < cornerCosine;
}

/// Chooses among the nodes of one chain, which are counted from its start.
class ChainNodes {
public:
    ChainNodes(const Stroke &stroke, const Chain &chain) : m_ways{0}
    {
        for (int k = chain.first; k <= chain.last; ++k)
            m_ways.push_back(m_ways.back() + roughLength(offsetsOf(stroke.segments[std::size_t(k)])));
        m_kept.resize(m_ways.size());
        m_kept.front() = m_kept.back() = true;
        m_corners = {0};
        for (int k = chain.first + 1; k <= chain.last; ++k)
            if (isSeenCorner(stroke, k))
                m_corners.push_back(std::size_t(k - chain.first));
        m_corners.push_back(m_ways.size() - 1);
    }

    void keep(double gap)
    {
        divide(m_corners, 0, m_corners.size() - 1, cornerGap * gap);
        std::vector<std::size_t> all(m_ways.size());
        std::iota(all.begin(), all.end(), std::size_t(0));
        std::size_t last = 0;
        for (std::size_t i = 1; i < m_ways.size(); ++i)
            if (m_kept[i]) {
                divide(all, last, i, gap);
                last = i;
            }
    }

    const std::vector<double> &ways() const { return m_ways; }
    bool isKept(std::size_t i) const { return m_kept[i]; }

private:
    /// Keeps a node between two kept ones, if it is far enough from both, and goes on with both halves. This is the
    /// node in the middle by count, which stays the same when the shape changes, or else the one in the middle of the
    /// way.
    void divide(const std::vector<std::size_t> &nodes, std::size_t a, std::size_t b, double gap)
    {
        const auto way = [&](std::size_t i) { return m_ways[nodes[i]]; };
        const auto side = [&](std::size_t i) { return std::min(way(i) - way(a), way(b) - way(i)); };
        if (b < a + 2 || way(b) - way(a) < 2 * gap)
            return;
        std::size_t middle = (a + b) / 2;
        if (side(middle) < unevenShare * (way(b) - way(a))) {
            const double half = 0.5 * (way(a) + way(b));
            const auto begin = nodes.begin() + std::ptrdiff_t(a) + 1, end = nodes.begin() + std::ptrdiff_t(b) - 1;
            const auto behind =
                std::lower_bound(begin, end, half, [&](std::size_t n, double w) { return m_ways[n] < w; });
            middle = std::size_t(behind - nodes.begin());
            if (middle > a + 1 && side(middle - 1) > side(middle))
                --middle;
        }
        if (side(middle) < gap)
            return;
        m_kept[nodes[middle]] = true;
        divide(nodes, a, middle, gap);
        divide(nodes, middle, b, gap);
    }

    std::vector<double> m_ways; ///< the way from the chain's start to each of its nodes
    std::vector<std::size_t> m_corners;
    std::vector<bool> m_kept;
};

} // namespace

std::vector<int> coarseNodes(const Stroke &stroke, double gap)
{
    std::vector<int> nodes, ends;
    for (const Chain &chain : chainsOf(stroke)) {
        ChainNodes of(stroke, chain);
        of.keep(gap);
        for (int k = chain.first; k <= chain.last; ++k)
            if (of.isKept(std::size_t(k - chain.first)))
                nodes.push_back(k);
        ends.push_back(int(stroke.segments.size()) + 1 + int(ends.size()));
    }
    if (!ends.empty()) { // The end of the last chain has a lower number than those of the others.
        nodes.push_back(int(stroke.segments.size()));
        nodes.insert(nodes.end(), ends.begin(), ends.end() - 1);
    }
    return nodes;
}

bool isCrowded(const Stroke &stroke, const CurvePlace &place, double gap, double way)
{
    const Chain chain = chainAt(stroke, place.segment);
    ChainNodes of(stroke, chain);
    of.keep(gap);
    const std::vector<double> &ways = of.ways();
    const auto k = std::size_t(place.segment - chain.first);
    const double at = ways[k] + place.p * (ways[k + 1] - ways[k]);
    int all = 0, kept = 0;
    for (std::size_t i = 0; i < ways.size(); ++i)
        if (std::abs(ways[i] - at) <= way) {
            ++all;
            kept += of.isKept(i);
        }
    return kept < all && 2 * kept <= all + 1;
}

CurvePlace placeOfNode(const Stroke &stroke, int node)
{
    const NodeSides sides = sidesOf(stroke, node);
    return sides.after >= 0 ? CurvePlace{sides.after, 0} : CurvePlace{std::max(sides.before, 0), 1};
}

} // namespace suffuse
