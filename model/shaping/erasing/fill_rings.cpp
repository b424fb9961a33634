#include "model/shaping/erasing/fill_rings.h"

#include "model/area/offset_curve.h"
#include "model/shaping/curves/split.h"

#include <algorithm>
#include <map>
#include <numbers>

namespace suffuse {

namespace {

/// The angle by which the way to a curve's point turns around a place, along the curve.
double turnOf(const Cubic &curve, Point around, int depth = 0)
{
    constexpr int deepest = 40;
    const Rect box = curve.controlBox();
    const Point a = curve.p[0] - around, b = curve.p[3] - around;
    // Seen from outside of the box the curve turns by less than half a turn.
    if (depth == deepest || !box.contains(around))
        return std::atan2(cross(a, b), dot(a, b));
    const auto [first, second] = curve.split(0.5);
    return turnOf(first, around, depth + 1) + turnOf(second, around, depth + 1);
}

double lengthOf(const std::array<Offset, 4> &bezier)
{
    return length((Point() + bezier[3]) - (Point() + bezier[0]));
}

} // namespace

std::vector<Ring> ringsOf(const Stroke &stroke)
{
    std::vector<Ring> rings;
    for (const Chain &chain : chainsOf(stroke)) {
        Ring ring{chain, {}, false};
        for (int k = chain.first; k <= chain.last; ++k) {
            const Segment &segment = stroke.segments[std::size_t(k)];
            if (segment.takesPaint())
                continue;
            const Cubic curve = offsetsOf(segment);
            if (!ring.curves.empty() && ring.curves.back().curve.p[3] != curve.p[0])
                ring.curves.push_back({-1, straightCubic(ring.curves.back().curve.p[3], curve.p[0])});
            ring.curves.push_back({k, curve});
        }
        if (ring.curves.empty())
            continue;
        const Point end = ring.curves.back().curve.p[3], start = ring.curves.front().curve.p[0];
        ring.isOpen = end != start;
        if (ring.isOpen)
            ring.curves.push_back({-1, straightCubic(end, start)});
        rings.push_back(std::move(ring));
    }
    return rings;
}

int windingOf(const std::vector<Ring> &rings, Point at)
{
    double turn = 0;
    for (const Ring &ring : rings)
        for (const RingCurve &part : ring.curves)
            turn += turnOf(part.curve, at);
    return int(std::lround(turn / (2 * std::numbers::pi)));
}

RingCutter::RingCutter(const Stroke &stroke, std::vector<Ring> rings, std::vector<RingGate> gates)
    : m_stroke(stroke), m_rings(std::move(rings)), m_gates(std::move(gates)), m_result(stroke)
{
    m_result.segments.clear();
    const auto lays = std::ranges::find_if(stroke.segments, [](const Segment &s) { return !s.takesPaint(); });
    m_model = lays == stroke.segments.end() ? stroke.segments.front() : *lays;
    m_model.density = 0;
    m_model.start = m_model.lift = m_model.fade = false;
    m_model.node = NodeKind::Corner;
    cut();
}

void RingCutter::cut()
{
    std::map<std::pair<int, int>, std::map<double, int>> gatesOf; // of a ring's curve, by p
    std::vector<std::vector<double>> parameters(m_stroke.segments.size());
    for (int g = 0; g < int(m_gates.size()); ++g) {
        const RingGate &gate = m_gates[std::size_t(g)];
        if (gate.partner < 0)
            continue;
        gatesOf[{gate.ring, gate.curve}].emplace(gate.p, g);
        const int segment = m_rings[std::size_t(gate.ring)].curves[std::size_t(gate.curve)].segment;
        if (segment >= 0 && gate.p > 0)
            parameters[std::size_t(segment)].push_back(gate.p);
    }
    for (std::vector<double> &ps : parameters)
        std::ranges::sort(ps);
    std::vector<std::vector<Piece>> pieces(m_stroke.segments.size());
    for (Piece &piece : piecesOf(m_stroke, parameters))
        pieces[std::size_t(piece.source)].push_back(std::move(piece));

    for (int r = 0; r < int(m_rings.size()); ++r) {
        Elements &elements = m_elements.emplace_back();
        for (int c = 0; c < int(m_rings[std::size_t(r)].curves.size()); ++c) {
            const RingCurve &curve = m_rings[std::size_t(r)].curves[std::size_t(c)];
            const auto found = gatesOf.find({r, c});
            const std::map<double, int> gates = found == gatesOf.end() ? std::map<double, int>() : found->second;
            const auto gateAt = [&](double p) {
                const auto gate = gates.find(p);
                return gate == gates.end() ? -1 : gate->second;
            };
            if (curve.segment >= 0) {
                for (const Piece &piece : pieces[std::size_t(curve.segment)])
                    elements.push_back({curve.segment, piece.segment, gateAt(piece.from), false});
                continue;
            }
            Segment line = m_model;
            std::vector<double> from{0};
            for (const auto &[p, gate] : gates)
                if (p > 0)
                    from.push_back(p);
            Offset start = toOffset(curve.curve.p[0], {});
            for (std::size_t i = 0; i < from.size(); ++i) {
                const Offset end = toOffset(curve.curve.at(i + 1 < from.size() ? from[i + 1] : 1), {});
                line.bezier = toOffsets(straightCubic(Point() + start, Point() + end));
                elements.push_back({-1, line, gateAt(from[i]), true});
                start = end;
            }
        }
        for (const Element &element : elements)
            if (element.gate >= 0)
                m_gates[std::size_t(element.gate)].at = element.segment.bezier[0];
    }
}

std::size_t RingCutter::firstAtGate(std::size_t ring, int gate) const
{
    const Elements &elements = m_elements[ring];
    return std::size_t(std::ranges::find_if(elements, [gate](const Element &e) { return e.gate == gate; }) -
                       elements.begin());
}

void RingCutter::follow(const std::function<bool(int sign)> &keeps, const std::function<bool(int ring)> &stays,
                        const std::function<std::vector<NewCurve>(const RingGate &, const RingGate &)> &bridge)
{
    std::vector<bool> followed(m_gates.size());
    for (int r = 0; r < int(m_rings.size()); ++r) {
        const bool isCut =
            std::ranges::any_of(m_elements[std::size_t(r)], [](const Element &e) { return e.gate >= 0; });
        if (!isCut && stays(r)) {
            keepWhole(m_rings[std::size_t(r)]);
            continue;
        }
        for (int k = m_rings[std::size_t(r)].chain.first; k <= m_rings[std::size_t(r)].chain.last; ++k)
            if (m_stroke.segments[std::size_t(k)].takesPaint())
                m_lifts.push_back(k);
        for (const Element &begin : m_elements[std::size_t(r)]) {
            if (begin.gate < 0 || !keeps(m_gates[std::size_t(begin.gate)].sign))
                continue;
            Elements part;
            for (int g = begin.gate; !followed[std::size_t(g)];) {
                followed[std::size_t(g)] = true;
                const auto ring = std::size_t(m_gates[std::size_t(g)].ring);
                const Elements &around = m_elements[ring];
                std::size_t i = firstAtGate(ring, g);
                do {
                    part.push_back(around[i]);
                    i = (i + 1) % around.size();
                } while (around[i].gate < 0);
                const RingGate &end = m_gates[std::size_t(around[i].gate)];
                const RingGate &next = m_gates[std::size_t(end.partner)];
                appendNew(part, bridge(end, next), end.at, next.at);
                g = end.partner;
            }
            append(std::move(part));
        }
    }
}

void RingCutter::open()
{
    for (std::size_t r = 0; r < m_rings.size(); ++r) {
        const Elements &elements = m_elements[r];
        std::vector<std::size_t> begins;
        for (std::size_t i = 0; i < elements.size(); ++i)
            if (elements[i].gate >= 0)
                begins.push_back(i);
        if (begins.empty()) {
            keepWhole(m_rings[r]);
            continue;
        }
        if (m_rings[r].isOpen && begins.front() != 0)
            begins.insert(begins.begin(), 0);
        for (int k = m_rings[r].chain.first; k <= m_rings[r].chain.last; ++k)
            if (m_stroke.segments[std::size_t(k)].takesPaint())
                m_lifts.push_back(k);
        for (std::size_t b = 0; b < begins.size(); ++b) {
            Elements part;
            std::size_t i = begins[b];
            const std::size_t end = begins[(b + 1) % begins.size()];
            do {
                part.push_back(elements[i]);
                i = (i + 1) % elements.size();
            } while (i != end);
            if (b + 1 < begins.size() || begins.size() == 1) {
                append(std::move(part));
                continue;
            }
            for (std::size_t k = 0; k + 1 < begins.size(); ++k) {
                const Offset from = elements[begins[k]].segment.bezier[0];
                const Offset to = elements[begins[k + 1]].segment.bezier[0];
                appendNew(part, {{straightCubic(Point() + from, Point() + to), true}}, from, to);
            }
            append(std::move(part));
        }
    }
}

void RingCutter::leaveOut(const std::set<int> &segments)
{
    for (std::size_t r = 0; r < m_rings.size(); ++r) {
        const Ring &ring = m_rings[r];
        const auto isGone = [&](const Element &e) { return segments.contains(e.source); };
        const Elements &all = m_elements[r];
        if (std::ranges::none_of(all, isGone)) {
            keepWhole(ring);
            continue;
        }
        for (int k = ring.chain.first; k <= ring.chain.last; ++k)
            if (m_stroke.segments[std::size_t(k)].takesPaint())
                m_lifts.push_back(k);
        // It begins behind what goes, so that this is closed without a segment.
        const auto stays = [&](std::size_t i) { return !isGone(all[i % all.size()]); };
        std::size_t first = 0;
        while (first < all.size() && !(stays(first) && !stays(first + all.size() - 1)))
            ++first;
        Elements part;
        for (std::size_t i = first; first < all.size() && i < first + all.size(); ++i) {
            const Element &element = all[i % all.size()];
            if (!stays(i))
                continue;
            if (!part.empty()) {
                const Offset from = part.back().segment.bezier[3], to = element.segment.bezier[0];
                if (from != to)
                    appendNew(part, {{straightCubic(Point() + from, Point() + to), true}}, from, to);
            }
            part.push_back(element);
        }
        if (!part.empty()) {
            const Offset from = part.back().segment.bezier[3], to = part.front().segment.bezier[0];
            if (from != to)
                appendNew(part, {{straightCubic(Point() + from, Point() + to), true}}, from, to);
        }
        append(std::move(part));
    }
    m_left = segments;
}

void RingCutter::addLoop(const std::vector<NewCurve> &curves)
{
    Elements elements;
    const Offset start = toOffset(curves.front().curve.p[0], {});
    appendNew(elements, curves, start, start);
    append(std::move(elements));
}

void RingCutter::appendNew(Elements &elements, const std::vector<NewCurve> &curves, Offset from, Offset to) const
{
    Segment segment = m_model;
    if (!elements.empty() && elements.back().source >= 0) {
        segment = elements.back().segment;
        segment.density = 0;
        segment.start = false;
        segment.node = NodeKind::Corner;
    }
    if (curves.empty() && from != to) {
        appendNew(elements, {{straightCubic(Point() + from, Point() + to), true}}, from, to);
        return;
    }
    Offset start = from;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        segment.bezier = toOffsets(curves[i].curve);
        segment.bezier[0] = start;
        if (i + 1 == curves.size())
            segment.bezier[3] = to;
        start = segment.bezier[3];
        elements.push_back({-1, segment, -1, curves[i].isLine});
    }
}

void RingCutter::keepWhole(const Ring &ring)
{
    for (int k = ring.chain.first; k <= ring.chain.last; ++k) {
        m_result.segments.push_back(m_stroke.segments[std::size_t(k)]);
        if (k == ring.chain.first)
            m_result.segments.back().start = m_result.segments.size() > 1;
        m_sources.push_back(k);
    }
}

/// The longest of the lines is left out: the chain closes by it.
void RingCutter::append(Elements elements)
{
    std::erase_if(elements, [](const Element &e) { return e.source < 0 && isPoint(e.segment); });
    const auto isBetter = [](const Element &a, const Element &b) {
        return (a.isLine ? lengthOf(a.segment.bezier) : -1) < (b.isLine ? lengthOf(b.segment.bezier) : -1);
    };
    const auto closing = std::ranges::max_element(elements, isBetter);
    if (closing != elements.end() && closing->isLine) {
        std::rotate(elements.begin(), closing + 1, elements.end());
        elements.pop_back();
    }
    if (std::ranges::all_of(elements, [](const Element &e) { return e.isLine; }) && elements.size() < 2)
        return; // It encloses nothing.
    for (std::size_t i = 0; i < elements.size(); ++i) {
        Segment &segment = elements[i].segment;
        // Where the chain began before, or a line or a cut meets a curve, there is a corner.
        const bool joins = i > 0 && elements[i].gate < 0 && elements[i].source >= 0 && elements[i - 1].source >= 0 &&
                           !m_stroke.beginsChain(std::size_t(elements[i].source));
        if (i > 0 && !joins)
            segment.node = NodeKind::Corner;
        segment.start = i == 0 && !m_result.segments.empty();
        m_result.segments.push_back(std::move(segment));
        m_sources.push_back(elements[i].source);
    }
}

Stroke RingCutter::result(std::vector<int> *sources)
{
    // Chains that only take paint away bound nothing, and no ring is theirs.
    for (const Chain &chain : chainsOf(m_stroke))
        if (std::ranges::none_of(m_rings, [&](const Ring &ring) { return ring.chain == chain; }))
            for (int k = chain.first; k <= chain.last; ++k)
                m_lifts.push_back(k);
    std::erase_if(m_lifts, [this](int k) { return m_left.contains(k); });
    std::ranges::sort(m_lifts);
    for (std::size_t i = 0; i < m_lifts.size(); ++i) {
        const int k = m_lifts[i];
        const bool goesOn = i > 0 && m_lifts[i - 1] == k - 1 && !m_stroke.beginsChain(std::size_t(k));
        m_result.segments.push_back(m_stroke.segments[std::size_t(k)]);
        m_result.segments.back().start = m_result.segments.size() > 1 && !goesOn;
        m_sources.push_back(k);
    }
    if (sources)
        *sources = std::move(m_sources);
    return std::move(m_result);
}

} // namespace suffuse
