#include "model/shaping/nodes/coarse_nodes.h"

#include "model/brush/stroke_fit.h"
#include "model/shaping/curves/curve_fit.h"
#include "model/shaping/curves/runs.h"
#include "model/shaping/curves/split.h"

#include <algorithm>
#include <numeric>
#include <set>

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

/// Gives a run of segments the curve of one cubic, which keeps the tangents at both ends and comes near to what was
/// there. Returns false, and changes nothing, where that cannot be stored.
bool takeOneCurve(Stroke &stroke, const Chain &run)
{
    const RunPath path(stroke, run);
    CurveFit fit(path.curves);
    const Cubic whole = fittedCubic(fit, startDirection(path.curves.front()), endDirection(path.curves.back()));
    const double way = arcLength(whole);
    std::vector<Cubic> curves;
    double from = 0;
    for (std::size_t k = 1; k < path.lengths.size(); ++k) {
        double to = 1;
        if (k + 1 < path.lengths.size()) {
            double low = from, high = 1;
            const double wanted = way * path.lengths[k] / path.total();
            for (int i = 0; i < 30; ++i) {
                to = 0.5 * (low + high);
                (arcLength(partOf(whole, 0, to)) < wanted ? low : high) = to;
            }
        }
        curves.push_back(partOf(whole, from, to));
        from = to;
    }
    curves.front().p[0] = path.curves.front().p[0];
    curves.back().p[3] = path.curves.back().p[3];
    Stroke result = stroke;
    writeCurves(result, run.first, curves);
    for (int k = run.first; k <= run.last; ++k)
        if (isPoint(result.segments[std::size_t(k)]))
            return false;
    for (int k = run.first + 1; k <= run.last; ++k)
        result.segments[std::size_t(k)].node = NodeKind::Smooth;
    result = validOr(std::move(result), stroke);
    const bool changed = result != stroke;
    stroke = std::move(result);
    return changed;
}

/// Removes bends of one chain, whose nodes are counted from its start.
class ChainBends {
public:
    ChainBends(const Stroke &stroke, const Chain &chain, double gap) : m_stroke(stroke), m_chain(chain)
    {
        ChainNodes of(stroke, chain);
        of.keep(gap);
        for (int i = 0; i < int(of.ways().size()); ++i)
            m_shown.push_back(of.isKept(std::size_t(i)));
    }

    /// The place of a node in the chain; −1: it belongs to another one.
    int placeOf(int node) const
    {
        if (node == endNode(m_stroke, m_chain.last))
            return m_chain.last - m_chain.first + 1;
        return node >= m_chain.first && node <= m_chain.last ? node - m_chain.first : -1;
    }

    void remove(const std::set<int> &places, BendsRemoved &result) const
    {
        for (auto it = places.begin(); it != places.end();) {
            const int before = shownBeside(*it, -1, places);
            const int behind = shownBeside(*it, 1, places);
            const auto end = places.lower_bound(behind);
            removeBetween(before, behind, std::set<int>(it, end), result);
            it = end;
        }
    }

private:
    /// The next shown node that stays; beyond the end of the chain where there is none.
    int shownBeside(int place, int step, const std::set<int> &places) const
    {
        const int count = int(m_shown.size());
        for (place += step; place >= 0 && place < count; place += step)
            if (m_shown[std::size_t(place)] && !places.contains(place))
                return place;
        return step > 0 ? count : -1;
    }

    void removeBetween(int before, int behind, const std::set<int> &places, BendsRemoved &result) const
    {
        const int count = int(m_shown.size());
        const bool isRun =
            std::adjacent_find(places.begin(), places.end(), [](int a, int b) { return b == a + 1; }) != places.end();
        const bool inner = before >= 0 && behind < count;
        const bool stands = !isRun && int(places.size()) < behind - before - 1;
        if (stands && inner && takeOneCurve(result.stroke, {m_chain.first + before, m_chain.first + behind - 1}))
            return;
        std::set<int> gone = places;
        if (stands && !inner)
            for (int i = before + 1; i < behind; ++i)
                gone.insert(i);
        for (const int i : gone)
            result.deleted.push_back(i + 1 < count ? m_chain.first + i : endNode(m_stroke, m_chain.last));
    }

    const Stroke &m_stroke;
    Chain m_chain;
    std::vector<bool> m_shown;
};

} // namespace

BendsRemoved withoutBends(const Stroke &stroke, const std::vector<int> &nodes, double gap)
{
    BendsRemoved result{stroke, {}};
    for (const Chain &chain : chainsOf(stroke)) {
        const ChainBends bends(stroke, chain, gap);
        std::set<int> places;
        for (const int node : nodes)
            if (const int place = bends.placeOf(node); place >= 0)
                places.insert(place);
        bends.remove(places, result);
    }
    return result;
}

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
