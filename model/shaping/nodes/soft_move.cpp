#include "model/shaping/nodes/soft_move.h"

#include "model/brush/stroke_fit.h"
#include "model/shaping/curves/split.h"
#include "model/shaping/nodes/reshape.h"

#include <algorithm>

namespace suffuse {

namespace {

constexpr double leastPlaceShare = 0.75; ///< of the move; below it the segment of a place is too long for the reach
constexpr double nearEnd = 0.25;         ///< in reaches; an end that is nearer follows in any case

/// The way from the start of a chain to each of its nodes, in canvas units.
std::vector<double> waysAlong(const Stroke &stroke, const Chain &chain)
{
    std::vector<double> ways{0};
    for (int k = chain.first; k <= chain.last; ++k)
        ways.push_back(ways.back() + arcLength(offsetsOf(stroke.segments[std::size_t(k)])));
    return ways;
}

struct Falloff {
    double share = 0;
    double slope = 0; ///< of the share, by the way along the curve
};

/// The falloff at some way behind a moved place; before the place the way is below 0.
Falloff falloffAt(double way, double reach)
{
    const double u = way / reach, rest = 1 - u * u;
    return rest > 0 ? Falloff{rest * rest, -4 * u * rest / reach} : Falloff();
}

/// How far moved places reach: towards the start of the chain, among themselves, and towards its end.
struct Reaches {
    double before = 0, between = 0, behind = 0;
};

/// The reach towards an end of the chain that stays.
double reachTo(double end, double reach)
{
    return end > nearEnd * reach ? std::min(end, reach) : reach;
}

/// The falloff at `at` beside the moved places, which are in order.
Falloff falloffBeside(const std::vector<double> &places, double at, const Reaches &reach)
{
    const auto next = std::lower_bound(places.begin(), places.end(), at);
    if (next != places.end() && *next == at)
        return {1, 0};
    const bool isBefore = next == places.begin(), isBehind = next == places.end();
    const Falloff a = !isBefore ? falloffAt(at - *std::prev(next), isBehind ? reach.behind : reach.between) : Falloff();
    const Falloff b = !isBehind ? falloffAt(at - *next, isBefore ? reach.before : reach.between) : Falloff();
    return {1 - (1 - a.share) * (1 - b.share), a.slope * (1 - b.share) + b.slope * (1 - a.share)};
}

/// How much of the slope at a node its handles follow. Handles that are long compared with the reach follow less of it,
/// since they would lead beyond the reach.
double slopeShare(double handle, double reach)
{
    const double u = 2 * handle / reach;
    return 1 / (1 + u * u);
}

} // namespace

SoftMove::SoftMove(const Stroke &stroke, std::vector<int> nodes, double reach, Ends ends)
    : m_stroke(stroke), m_ends(ends), m_nodes(std::move(nodes))
{
    if (!(reach > 0))
        return;
    m_shares.resize(stroke.segments.size());
    std::sort(m_nodes.begin(), m_nodes.end());
    for (const Chain &chain : chainsOf(stroke)) {
        const std::vector<double> ways = waysAlong(stroke, chain);
        std::vector<double> places;
        for (auto it = std::lower_bound(m_nodes.begin(), m_nodes.end(), chain.first);
             it != m_nodes.end() && *it <= chain.last; ++it)
            places.push_back(ways[std::size_t(*it - chain.first)]);
        if (std::binary_search(m_nodes.begin(), m_nodes.end(), endNode(stroke, chain.last)))
            places.push_back(ways.back());
        spread(chain, ways, places, reach);
    }
    if (!takesOthersAlong())
        m_segments.clear();
}

SoftMove::SoftMove(const Stroke &stroke, const CurvePlace &place, double reach, Ends ends)
    : m_stroke(stroke), m_ends(ends), m_place(place)
{
    if (!(reach > 0) || place.segment < 0 || place.segment >= int(stroke.segments.size()))
        return;
    m_shares.resize(stroke.segments.size());
    const Chain chain = chainAt(stroke, place.segment);
    const std::vector<double> ways = waysAlong(stroke, chain);
    const Cubic curve = offsetsOf(stroke.segments[std::size_t(place.segment)]);
    const double at = ways[std::size_t(place.segment - chain.first)] + arcLength(partOf(curve, 0, place.p));
    spread(chain, ways, {at}, reach);
    const auto &c = m_shares[std::size_t(place.segment)].control;
    const double p = place.p, q = 1 - p;
    m_placeShare = q * q * q * c[0] + 3 * q * q * p * c[1] + 3 * q * p * p * c[2] + p * p * p * c[3];
    if (m_placeShare < leastPlaceShare)
        m_segments.clear();
}

void SoftMove::spread(const Chain &chain, const std::vector<double> &ways, const std::vector<double> &places,
                      double reach)
{
    if (places.empty())
        return;
    std::vector<double> around = places;
    Reaches reaches{reach, reach, reach};
    if (m_ends == Ends::Stay && !isClosed(m_stroke, chain)) {
        reaches.before = reachTo(places.front(), reach);
        reaches.behind = reachTo(ways.back() - places.back(), reach);
    }
    if (isClosed(m_stroke, chain)) { // The nearest places beyond the seam count, too.
        around.insert(around.begin(), places.back() - ways.back());
        around.push_back(places.front() + ways.back());
    }
    // Both handles of a node follow the same slope, and so stay in one line.
    std::vector<Falloff> atNode;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        Falloff f = falloffBeside(around, ways[i], reaches);
        double handle = 0;
        if (const std::size_t before = std::size_t(chain.first) + i; i > 0) {
            const Cubic c = offsetsOf(m_stroke.segments[before - 1]);
            handle = length(c.p[3] - c.p[2]);
        }
        if (const std::size_t after = std::size_t(chain.first) + i; i + 1 < ways.size()) {
            const Cubic c = offsetsOf(m_stroke.segments[after]);
            handle = std::max(handle, length(c.p[1] - c.p[0]));
        }
        f.slope *= slopeShare(handle, ways[i] < places.front()  ? reaches.before
                                      : ways[i] > places.back() ? reaches.behind
                                                                : reach);
        atNode.push_back(f);
    }
    if (around.size() > places.size()) // Both ends of a closed chain are one node.
        atNode.back().slope = atNode.front().slope =
            std::abs(atNode.front().slope) < std::abs(atNode.back().slope) ? atNode.front().slope : atNode.back().slope;
    for (int k = chain.first; k <= chain.last; ++k) {
        const Cubic c = offsetsOf(m_stroke.segments[std::size_t(k)]);
        const auto i = std::size_t(k - chain.first);
        const Falloff &from = atNode[i], &to = atNode[i + 1];
        if (from.share == 0 && to.share == 0)
            continue;
        m_shares[std::size_t(k)] = {{from.share, from.share + from.slope * length(c.p[1] - c.p[0]),
                                     to.share - to.slope * length(c.p[3] - c.p[2]), to.share}};
        m_segments.push_back(k);
    }
}

/// Whether anything but the nodes themselves moves.
bool SoftMove::takesOthersAlong() const
{
    const auto isMoved = [this](int node) { return std::binary_search(m_nodes.begin(), m_nodes.end(), node); };
    return std::any_of(m_segments.begin(), m_segments.end(), [&](int k) {
        const auto &c = m_shares[std::size_t(k)].control;
        return (c[0] > 0 && !isMoved(k)) || (c[3] > 0 && !isMoved(endNode(m_stroke, k)));
    });
}

Stroke SoftMove::by(Point move) const
{
    if (m_segments.empty())
        return m_place ? withCurveDragged(m_stroke, m_place->segment, m_place->p, move)
                       : withNodeMoved(m_stroke, m_nodes, move);
    if (m_place)
        move = (1 / m_placeShare) * move;
    Stroke result = m_stroke;
    for (const int k : m_segments) {
        Segment &segment = result.segments[std::size_t(k)];
        for (std::size_t i = 0; i < 4; ++i)
            segment.bezier[i] = toOffset(m_shares[std::size_t(k)].control[i] * move + segment.bezier[i], {});
        if (isPoint(segment) && !isPoint(m_stroke.segments[std::size_t(k)]))
            return m_stroke;
    }
    return validOr(std::move(result), m_stroke);
}

} // namespace suffuse
