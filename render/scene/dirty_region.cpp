#include "render/scene/dirty_region.h"

#include <algorithm>
#include <array>
#include <bit>

namespace suffuse {

namespace {

/// The number of the cell of this size in which a pixel lies.
int cellOf(int pixel, int size)
{
    return pixel >= 0 ? pixel / size : -((-pixel + size - 1) / size);
}

bool containsRect(const PixelRect &outer, const PixelRect &r)
{
    return r.x >= outer.x && r.y >= outer.y && r.x + r.width <= outer.x + outer.width &&
           r.y + r.height <= outer.y + outer.height;
}

} // namespace

void DirtyRegion::reset(const PixelRect &picture, int tileSize)
{
    m_picture = picture;
    m_tileSize = tileSize;
    m_shift = std::has_single_bit(unsigned(tileSize)) ? std::countr_zero(unsigned(tileSize)) : -1;
    m_left = cellOf(picture.x, tileSize);
    m_top = cellOf(picture.y, tileSize);
    m_columns = cellOf(picture.x + picture.width + tileSize - 1, tileSize) - m_left;
    m_rows = cellOf(picture.y + picture.height + tileSize - 1, tileSize) - m_top;
    m_dirty.assign(std::size_t(m_columns) * m_rows, 1);
}

PixelRect DirtyRegion::tile(int column, int row) const
{
    const auto range = [this](int number, int first, int size) -> std::array<int, 2> {
        const int begin = number * m_tileSize, step = std::min(alignment, m_tileSize);
        return {std::max(begin, cellOf(first, step) * step), std::min(begin + m_tileSize, first + size)};
    };
    const auto [left, right] = range(m_left + column, m_picture.x, m_picture.width);
    const auto [top, bottom] = range(m_top + row, m_picture.y, m_picture.height);
    return {left, top, right - left, bottom - top};
}

void DirtyRegion::moveTo(const PixelRect &picture)
{
    const DirtyRegion before = *this;
    reset(picture, m_tileSize);
    for (int row = 0; row < m_rows; ++row)
        for (int column = 0; column < m_columns; ++column) {
            const int x = m_left + column - before.m_left, y = m_top + row - before.m_top;
            const bool there = x >= 0 && y >= 0 && x < before.m_columns && y < before.m_rows;
            if (there && !before.isDirty(x, y) && containsRect(before.m_picture, clipped(tile(column, row))))
                clean(column, row);
        }
}

PixelRect DirtyRegion::clipped(const PixelRect &r) const
{
    const int left = std::max(r.x, m_picture.x), top = std::max(r.y, m_picture.y);
    return {left, top, std::min(r.x + r.width, m_picture.x + m_picture.width) - left,
            std::min(r.y + r.height, m_picture.y + m_picture.height) - top};
}

TileRange DirtyRegion::tilesOf(const PixelRect &r) const
{
    if (r.isEmpty())
        return {};
    const auto tile = [this](int pixel) { return m_shift >= 0 ? pixel >> m_shift : cellOf(pixel, m_tileSize); };
    return {std::max(0, tile(r.x) - m_left), std::max(0, tile(r.y) - m_top),
            std::min(tile(r.x + r.width - 1) + 1 - m_left, m_columns),
            std::min(tile(r.y + r.height - 1) + 1 - m_top, m_rows)};
}

void DirtyRegion::mark(const TileRange &tiles)
{
    for (int y = tiles.top; y < tiles.bottom; ++y)
        std::fill_n(m_dirty.begin() + std::ptrdiff_t(index(tiles.left, y)), std::max(0, tiles.right - tiles.left),
                    std::uint8_t(1));
}

void DirtyRegion::mark(const std::vector<TileRange> &ranges)
{
    constexpr std::size_t many = 256;
    if (ranges.size() < many) {
        for (const TileRange &range : ranges)
            mark(range);
        return;
    }
    TileRange box{m_columns, m_rows, 0, 0}; // around all ranges
    for (const TileRange &t : ranges)
        if (!t.isEmpty())
            box = {std::min(box.left, t.left), std::min(box.top, t.top), std::max(box.right, t.right),
                   std::max(box.bottom, t.bottom)};
    if (box.isEmpty())
        return;
    // At each tile stands the difference of how many ranges cover it, along columns and rows. The differences are
    // summed up at the end.
    const std::size_t columns = std::size_t(box.right - box.left), stride = columns + 1;
    std::vector<std::int32_t> covered(stride * std::size_t(box.bottom - box.top + 1), 0);
    for (const TileRange &t : ranges) {
        if (t.isEmpty())
            continue;
        const auto at = [&](int x, int y) -> std::int32_t & {
            return covered[std::size_t(y - box.top) * stride + std::size_t(x - box.left)];
        };
        ++at(t.left, t.top), --at(t.right, t.top), --at(t.left, t.bottom), ++at(t.right, t.bottom);
    }
    std::vector<std::int32_t> column(stride, 0);
    for (int y = box.top; y < box.bottom; ++y) {
        const std::int32_t *row = covered.data() + std::size_t(y - box.top) * stride;
        for (std::size_t x = 0; x < stride; ++x)
            column[x] += row[x];
        std::int32_t count = 0;
        std::uint8_t *dirty = m_dirty.data() + index(box.left, y);
        for (std::size_t x = 0; x < columns; ++x) {
            count += column[x];
            dirty[x] |= std::uint8_t(count != 0);
        }
    }
}

namespace {

bool sameGroup(const StrokeNodes &a, const NodeGroup &g, const StrokeNodes &b, const NodeGroup &h)
{
    const std::uint32_t count = g.end - g.begin, rows = g.rowPerNode ? count : 1;
    return count == h.end - h.begin && g.rowPerNode == h.rowPerNode &&
           std::equal(a.nodes.begin() + g.begin, a.nodes.begin() + g.end, b.nodes.begin() + h.begin) &&
           std::equal(a.rows.begin() + g.row, a.rows.begin() + g.row + rows, b.rows.begin() + h.row) &&
           std::equal(a.reaches.begin() + g.reachBegin, a.reaches.begin() + g.reachEnd,
                      b.reaches.begin() + h.reachBegin, b.reaches.begin() + h.reachEnd);
}

/// Whether all numbers of two fills are the same, if there are any.
bool sameFillValues(const SceneFill *a, const SceneFill *b)
{
    if (!a || !b)
        return !a && !b;
    return a->density == b->density && a->a == b->a && a->b == b->b && a->c == b->c && a->reach == b->reach &&
           a->level == b->level && a->nearby == b->nearby && a->crisp == b->crisp && a->deep == b->deep &&
           a->epsilon == b->epsilon && a->from == b->from && a->step == b->step && a->hasGradient == b->hasGradient &&
           (!a->hasGradient || (a->place == b->place && a->placeSlope == b->placeSlope));
}

/// Whether everything about a stroke is the same that does not belong to single segments.
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
    return isSamePicture(a.picture.get(), b.picture.get()) && a.keep == b.keep && a.granulated == b.granulated &&
           a.calm == b.calm && a.channels == b.channels && a.shade.colourChannel == b.shade.colourChannel &&
           a.shade.lineChannel == b.shade.lineChannel && a.shade.grainChannel == b.shade.grainChannel &&
           a.shade.laidChannel == b.shade.laidChannel && a.shade.fadeChannel == b.shade.fadeChannel &&
           (a.shade.colourChannel >= 0 || a.shade.colour == b.shade.colour) &&
           (a.shade.lineChannel < 0 || a.shade.colourEnd == b.shade.colourEnd) &&
           (a.shade.grainChannel >= 0 || a.shade.grain == b.shade.grain) && a.deep.empty() == b.deep.empty() &&
           a.stroke->origin == b.stroke->origin && sameKinds() && sameFillValues(a.fill.get(), b.fill.get());
}

/// Tells along a level line what lies inside, for places that follow each other.
class LevelLine {
public:
    LevelLine(const SceneFill &fill, double y)
    {
        for (std::size_t run = 0; run < fill.arcRuns.size(); ++run) {
            const Rect &box = fill.arcRuns[run];
            const std::size_t first = run * fillRun, count = std::min(fillRun, fill.arcs.size() - first);
            if (box.top <= y && y <= box.bottom)
                for (std::size_t i = first; i < first + count; ++i)
                    if (const RisingArc &arc = fill.arcs[i].arc; arc.top() <= y && y < arc.bottom())
                        m_crossings.emplace_back(arc.xAt(y), fill.arcs[i].enters);
        }
        std::sort(m_crossings.begin(), m_crossings.end());
    }
    int enteredAt(double x)
    {
        for (; m_next < m_crossings.size() && m_crossings[m_next].first < x; ++m_next)
            m_entered += m_crossings[m_next].second;
        return m_entered;
    }

private:
    std::vector<std::pair<double, int>> m_crossings;
    std::size_t m_next = 0;
    int m_entered = 0;
};

/// Marks where the boundary of a fill differs, and what lies inside now and did not before.
void markFill(const SceneFill &before, const SceneFill &after, DirtyRegion &region)
{
    const auto boxOf = [](const SceneFill &fill, const Rect &box) {
        // A device looks a little farther than the fill reaches.
        const double more = 1 + fill.nearby, beyond = 1.0 / 128;
        const double x = std::max(fill.reach.x + beyond, more), y = std::max(fill.reach.y + beyond, more);
        const double limit = 1e8; // It is clipped to the picture anyhow.
        const int left = int(std::clamp(std::floor(box.left - x), -limit, limit));
        const int top = int(std::clamp(std::floor(box.top - y), -limit, limit));
        return PixelRect{left, top, int(std::clamp(std::ceil(box.right + x), -limit, limit)) - left,
                         int(std::clamp(std::ceil(box.bottom + y), -limit, limit)) - top};
    };
    std::vector<TileRange> ranges;
    // Where pieces of the boundary differ; in the middle of the list some may have come or gone.
    const auto compare = [&](const auto &a, const auto &b, auto placeOf) {
        const std::size_t shorter = std::min(a.size(), b.size());
        const bool inPlace = a.size() == b.size();
        std::size_t prefix = 0, suffix = 0;
        while (!inPlace && prefix < shorter && a[prefix] == b[prefix])
            ++prefix;
        while (!inPlace && suffix < shorter - prefix && a[a.size() - 1 - suffix] == b[b.size() - 1 - suffix])
            ++suffix;
        for (std::size_t i = prefix; i < std::max(a.size(), b.size()) - suffix; ++i) {
            if (inPlace && a[i] == b[i])
                continue;
            if (i < a.size() - suffix)
                ranges.push_back(region.tilesOf(region.clipped(boxOf(before, placeOf(a[i])))));
            if (i < b.size() - suffix)
                ranges.push_back(region.tilesOf(region.clipped(boxOf(after, placeOf(b[i])))));
        }
    };
    compare(before.panels, after.panels, [](const FillPanel &panel) { return panel.box; });
    compare(before.flats, after.flats, [](const BoundaryFlat &flat) {
        return Rect{flat.left, flat.y, flat.right, flat.y};
    });
    // Where the window has no boundary, one may be all inside, and the other all outside.
    const bool bare = before.panels.empty() || after.panels.empty();
    if (ranges.empty() && !bare && before.arcs == after.arcs)
        return;
    region.mark(ranges);
    for (const PixelRect &bounds : {before.bounds, after.bounds}) {
        const TileRange tiles = region.tilesOf(bounds);
        for (int row = tiles.top; row < tiles.bottom; ++row) {
            bool all = true;
            for (int column = tiles.left; column < tiles.right; ++column)
                all = all && region.isDirty(column, row);
            if (all)
                continue;
            const PixelRect first = region.tile(tiles.left, row);
            LevelLine was(before, first.y + 0.5 * first.height), is(after, first.y + 0.5 * first.height);
            for (int column = tiles.left; column < tiles.right; ++column) {
                const PixelRect tile = region.tile(column, row);
                const double middle = tile.x + 0.5 * tile.width;
                if (was.enteredAt(middle) != is.enteredAt(middle))
                    region.mark(TileRange{column, row, column + 1, row + 1});
            }
        }
    }
}

} // namespace

void markChanged(const SceneStroke &before, const SceneStroke &after, const PictureGrid &grid, Threads threads,
                 DirtyRegion &region)
{
    const auto &a = before.source->groups, &b = after.source->groups;
    const bool alike = samePlan(before, after), fillOnly = alike && before.fill && a.empty() && b.empty();
    if (alike && before.fill)
        markFill(*before.fill, *after.fill, region);
    if ((before.source == after.source && alike) || fillOnly)
        return;
    if (a.empty() || b.empty() || !alike) {
        region.mark(before.bounds);
        region.mark(after.bounds);
        return;
    }
    const auto tilesOf = [&](const SceneStroke &s, std::size_t i) {
        return region.tilesOf(s.groupBounds.empty()
                                  ? pixelBounds(*s.source, s.source->groups[i], s.stroke->origin, grid)
                                  : s.groupBounds[i]);
    };
    const auto same = [&](std::size_t i, std::size_t j) {
        return sameGroup(*before.source, a[i], *after.source, b[j]);
    };
    std::size_t prefix = 0, suffix = 0;        // how many groups stay the same at both ends
    const bool inPlace = a.size() == b.size(); // The groups are the same, and some have other values.
    const std::size_t shorter = std::min(a.size(), b.size());
    while (!inPlace && prefix < shorter && same(prefix, prefix)) // Groups were added or removed in the middle.
        ++prefix;
    while (!inPlace && suffix < shorter - prefix && same(a.size() - 1 - suffix, b.size() - 1 - suffix))
        ++suffix;
    const std::size_t end = std::max(a.size(), b.size()) - suffix, count = end - prefix;
    const auto changedBy = [&](std::size_t i) -> std::array<TileRange, 2> { // before and after
        if (inPlace && same(i, i))
            return {};
        return {i < a.size() - suffix ? tilesOf(before, i) : TileRange{},
                i < b.size() - suffix ? tilesOf(after, i) : TileRange{}};
    };
    std::vector<TileRange> ranges;
    const auto add = [&](const TileRange &range) { // Neighbours along a stroke reach the same tiles.
        if (!range.isEmpty() && (ranges.empty() || !ranges.back().contains(range)))
            ranges.push_back(range);
    };
    constexpr std::size_t share = 256;
    const bool isQuick = !inPlace && !before.groupBounds.empty() && !after.groupBounds.empty();
    std::vector<std::array<TileRange, 2>> changed(isQuick ? 0 : count);
    parallelFor((changed.size() + share - 1) / share, count < 2 * share ? Threads(1) : threads, [&](std::size_t k) {
        for (std::size_t i = k * share; i < std::min((k + 1) * share, count); ++i)
            changed[i] = changedBy(prefix + i);
    });
    for (std::size_t i = 0; i < count; ++i) {
        const auto [was, is] = isQuick ? changedBy(prefix + i) : changed[i];
        add(is);
        add(was);
    }
    region.mark(ranges);
}

} // namespace suffuse
