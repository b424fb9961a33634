#include "model/shaping/curves/chains.h"

#include <algorithm>

namespace suffuse {

std::vector<Chain> chainsOf(const Stroke &stroke)
{
    std::vector<Chain> chains;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        if (stroke.beginsChain(k))
            chains.push_back({int(k), int(k)});
        chains.back().last = int(k);
    }
    return chains;
}

Chain chainAt(const Stroke &stroke, int segment)
{
    Chain chain{segment, segment};
    while (!stroke.beginsChain(std::size_t(chain.first)))
        --chain.first;
    while (chain.last + 1 < int(stroke.segments.size()) && !stroke.beginsChain(std::size_t(chain.last) + 1))
        ++chain.last;
    return chain;
}

int nodeCount(const Stroke &stroke)
{
    int count = int(stroke.segments.size()) + 1;
    for (std::size_t k = 1; k < stroke.segments.size(); ++k)
        count += stroke.segments[k].start;
    return count;
}

NodeSides sidesOf(const Stroke &stroke, int node)
{
    const int n = int(stroke.segments.size());
    if (node < 0)
        return {};
    if (node < n)
        return {stroke.beginsChain(std::size_t(node)) ? -1 : node - 1, node};
    if (node == n)
        return {n - 1, -1};
    int ends = node - n; // counts the ends of the chains before the last one
    for (int k = 1; k < n; ++k)
        if (stroke.segments[std::size_t(k)].start && --ends == 0)
            return {k - 1, -1};
    return {};
}

int endNode(const Stroke &stroke, int segment)
{
    const int n = int(stroke.segments.size()), next = segment + 1;
    if (next >= n || !stroke.segments[std::size_t(next)].start)
        return next;
    int ends = 0;
    for (int k = 1; k <= next; ++k)
        ends += stroke.segments[std::size_t(k)].start;
    return n + ends;
}

bool isInnerNode(const Stroke &stroke, int node)
{
    return node > 0 && node < int(stroke.segments.size()) && !stroke.segments[std::size_t(node)].start;
}

bool isEndNode(const Stroke &stroke, int node)
{
    const NodeSides sides = sidesOf(stroke, node);
    return (sides.before < 0) != (sides.after < 0);
}

bool isClosed(const Stroke &stroke, const Chain &chain)
{
    return stroke.segments[std::size_t(chain.first)].bezier[0] == stroke.segments[std::size_t(chain.last)].bezier[3];
}

std::vector<int> nodesTogether(const Stroke &stroke, int node)
{
    const NodeSides sides = sidesOf(stroke, node);
    if (sides.before < 0 && sides.after < 0)
        return {};
    if (sides.before >= 0 && sides.after >= 0)
        return {node};
    const Chain chain = chainAt(stroke, std::max(sides.before, sides.after));
    return isClosed(stroke, chain) ? std::vector{chain.first, endNode(stroke, chain.last)} : std::vector{node};
}

int erasureCount(const Stroke &stroke)
{
    int count = 0;
    for (const Chain &chain : chainsOf(stroke))
        count += std::all_of(stroke.segments.begin() + chain.first, stroke.segments.begin() + chain.last + 1,
                             [](const Segment &segment) { return segment.takesPaint(); });
    return count;
}

std::vector<int> endNodesOf(const Stroke &stroke)
{
    std::vector<int> nodes;
    for (const Chain &chain : chainsOf(stroke)) {
        if (!stroke.segments[std::size_t(chain.first)].takesPaint())
            nodes.push_back(chain.first);
        if (!stroke.segments[std::size_t(chain.last)].takesPaint())
            nodes.push_back(endNode(stroke, chain.last));
    }
    return nodes;
}

Stroke chainOnly(const Stroke &stroke, const Chain &chain)
{
    Stroke one = stroke;
    one.segments.assign(stroke.segments.begin() + chain.first, stroke.segments.begin() + chain.last + 1);
    one.segments.front().start = false;
    return one;
}

void appendChain(Stroke &stroke, std::vector<Segment> segments)
{
    if (segments.empty())
        return;
    segments.front().start = !stroke.segments.empty();
    stroke.segments.insert(stroke.segments.end(), std::make_move_iterator(segments.begin()),
                           std::make_move_iterator(segments.end()));
}

} // namespace suffuse
