#include "render/dirty_region.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace suffuse {

void DirtyRegion::reset(int width, int height, int tileSize)
{
    m_width = width, m_height = height, m_tileSize = tileSize;
    m_columns = (width + tileSize - 1) / tileSize;
    m_rows = (height + tileSize - 1) / tileSize;
    m_dirty.assign(std::size_t(m_columns) * m_rows, 1);
}

PixelRect DirtyRegion::tile(int column, int row) const
{
    const int x = column * m_tileSize, y = row * m_tileSize;
    return {x, y, std::min(m_tileSize, m_width - x), std::min(m_tileSize, m_height - y)};
}

TileRange DirtyRegion::tilesOf(const PixelRect &r) const
{
    if (r.isEmpty())
        return {};
    return {std::max(0, r.x / m_tileSize), std::max(0, r.y / m_tileSize),
            std::min((r.x + r.width - 1) / m_tileSize + 1, m_columns),
            std::min((r.y + r.height - 1) / m_tileSize + 1, m_rows)};
}

void DirtyRegion::mark(const PixelRect &pixels)
{
    const TileRange tiles = tilesOf(pixels);
    for (int y = tiles.top; y < tiles.bottom; ++y)
        for (int x = tiles.left; x < tiles.right; ++x)
            m_dirty[index(x, y)] = 1;
}

namespace {

bool sameGroup(const StrokeNodes &a, const NodeGroup &g, const StrokeNodes &b, const NodeGroup &h)
{
    const std::uint32_t count = g.end - g.begin, rows = g.rowPerNode ? count : 1;
    return count == h.end - h.begin && g.rowPerNode == h.rowPerNode &&
           std::equal(a.nodes.begin() + g.begin, a.nodes.begin() + g.end, b.nodes.begin() + h.begin) &&
           std::equal(a.rows.begin() + g.row, a.rows.begin() + g.row + rows, b.rows.begin() + h.row) &&
           std::equal(a.reaches.begin() + g.reachBegin, a.reaches.begin() + g.reachEnd, b.reaches.begin() + h.reachBegin,
                      b.reaches.begin() + h.reachEnd);
}

/// Everything about a stroke that is not a segment's own.
bool samePlan(const SceneStroke &a, const SceneStroke &b)
{
    const auto sameKinds = [&] {
        if (a.shade.kinds != b.shade.kinds)
            return false;
        for (int i = 0; i < a.shade.kinds; ++i) {
            const KindParams &p = a.shade.kind[i], &q = b.shade.kind[i];
            if (p.kind != q.kind || p.xiChannel != q.xiChannel || p.shareChannel != q.shareChannel ||
                (p.xiChannel < 0 && !std::equal(p.xi, p.xi + 3, q.xi)))
                return false;
        }
        return true;
    };
    return a.keep == b.keep && a.granulated == b.granulated && a.channels == b.channels &&
           a.shade.colourChannel == b.shade.colourChannel && a.shade.lineChannel == b.shade.lineChannel &&
           a.shade.grainChannel == b.shade.grainChannel &&
           (a.shade.colourChannel >= 0 || a.shade.colour == b.shade.colour) &&
           (a.shade.lineChannel < 0 || a.shade.colourEnd == b.shade.colourEnd) &&
           (a.shade.grainChannel >= 0 || a.shade.grain == b.shade.grain) && a.deep.empty() == b.deep.empty() &&
           a.stroke->origin == b.stroke->origin && sameKinds();
}

} // namespace

void markChanged(const SceneStroke &before, const SceneStroke &after, const View &view, DirtyRegion &region)
{
    const auto &a = before.source->groups, &b = after.source->groups;
    if (before.source == after.source && samePlan(before, after))
        return;
    if (a.empty() || b.empty() || !samePlan(before, after)) {
        region.mark(before.bounds);
        region.mark(after.bounds);
        return;
    }
    const auto same = [&](std::size_t i, std::size_t j) {
        return sameGroup(*before.source, a[i], *after.source, b[j]);
    };
    const auto markBefore = [&](std::size_t i) {
        region.mark(pixelBounds(*before.source, a[i], before.stroke->origin, view));
    };
    const auto markAfter = [&](std::size_t j) {
        region.mark(pixelBounds(*after.source, b[j], after.stroke->origin, view));
    };
    std::size_t suffix = 0;
    if (a.size() == b.size()) { // the same groups, some with other values
        for (std::size_t i = 0; i < a.size(); ++i)
            if (!same(i, i))
                markBefore(i), markAfter(i);
        return;
    }
    std::size_t prefix = 0; // groups came or went in the middle
    const std::size_t shorter = std::min(a.size(), b.size());
    while (prefix < shorter && same(prefix, prefix))
        ++prefix;
    while (suffix < shorter - prefix && same(a.size() - 1 - suffix, b.size() - 1 - suffix))
        ++suffix;
    for (std::size_t i = prefix; i < a.size() - suffix; ++i)
        markBefore(i);
    for (std::size_t j = prefix; j < b.size() - suffix; ++j)
        markAfter(j);
}

std::vector<StrokeId> movedInOrder(const std::vector<StrokeId> &before, const std::vector<StrokeId> &after)
{
    std::unordered_map<StrokeId, std::size_t> position;
    for (std::size_t i = 0; i < before.size(); ++i)
        position[before[i]] = i;
    // Longest increasing subsequence of the old positions, by patience sorting: O(n log n).
    std::vector<StrokeId> common;
    std::vector<std::size_t> old;
    for (StrokeId id : after)
        if (const auto it = position.find(id); it != position.end())
            common.push_back(id), old.push_back(it->second);
    if (std::is_sorted(old.begin(), old.end()))
        return {};
    std::vector<std::size_t> tails, previous(old.size(), SIZE_MAX);
    for (std::size_t i = 0; i < old.size(); ++i) {
        const auto at = std::lower_bound(tails.begin(), tails.end(), i,
                                         [&](std::size_t tail, std::size_t k) { return old[tail] < old[k]; });
        if (at != tails.begin())
            previous[i] = *(at - 1);
        if (at == tails.end())
            tails.push_back(i);
        else
            *at = i;
    }
    std::unordered_set<StrokeId> kept;
    for (std::size_t i = tails.back(); i != SIZE_MAX; i = previous[i])
        kept.insert(common[i]);
    std::vector<StrokeId> moved;
    for (StrokeId id : common)
        if (!kept.contains(id))
            moved.push_back(id);
    return moved;
}

} // namespace suffuse
