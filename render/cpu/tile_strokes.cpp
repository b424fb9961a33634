#include "render/cpu/tile_strokes.h"

#include <algorithm>

namespace suffuse::cpu {

namespace {

bool meets(const PixelRect &bounds, int x, int y)
{
    return bounds.x < x + blockSide && x < bounds.x + bounds.width && bounds.y < y + blockSide &&
           y < bounds.y + bounds.height;
}

} // namespace

Area areaOf(const Rect &r)
{
    const Point centre = r.centre();
    return {centre.x, centre.y, 0.5 * r.width(), 0.5 * r.height()};
}

ListedNodes listedOf(const SceneStroke &stroke, NodeList nodes)
{
    const auto before = [nodes](int index) {
        return int(std::ranges::lower_bound(nodes, std::uint32_t(index)) - nodes.begin());
    };
    const ShadeParams &shade = stroke.shade;
    return {stroke.nodes.data(),
            nodes.data(),
            before(stroke.laying),
            before(stroke.painted),
            before(stroke.separable),
            int(nodes.size()),
            stroke.values.data(),
            stroke.channels,
            shade.fadeChannel >= 0 ? shade.fadeChannel : stroke.channels,
            shade.laidChannel >= 0};
}

int findRuns(const Kernels &kernels, const SceneStroke &stroke, const NodeRange &range, const Area &area,
             std::vector<std::uint32_t> &room, Meeting &meeting)
{
    const std::size_t most = (range.to - range.from + boxRun - 1) / boxRun;
    if (room.size() < most)
        room.resize(most);
    return kernels.findRuns(stroke.boxes.boxes().from(range.from), range.size(), area, room.data(), meeting);
}

bool shows(const SceneStroke &stroke, const Meeting &meeting)
{
    return meeting.count == 0 ? isDeep(stroke) : !canVanish(stroke, meeting.density, meeting.slope);
}

void include(const SceneFill &fill, FillPresence presence, Meeting &meeting)
{
    if (presence == FillPresence::Nothing)
        return;
    ++meeting.count;
    meeting.density += float(fill.density);
    if (presence == FillPresence::Outline && !fill.crisp)
        meeting.slope += float(fill.steepest);
}

void TileStrokes::begin(const Kernels &kernels, const PixelRect &tile, const PixelRect &window)
{
    const auto blocks = [](int pixels) { return (pixels + blockSide - 1) / blockSide; };
    m_kernels = &kernels;
    m_tile = tile;
    m_grid = {double(tile.x - window.x), double(tile.y - window.y), blockSide, blocks(tile.width), blocks(tile.height)};
    m_area = areaOf(Rect::of(m_grid.x, m_grid.y, m_grid.columns * blockSide, m_grid.rows * blockSide));
    m_strokes.clear();
    m_used = 0;
    m_usedFills = 0;
}

bool TileStrokes::findFill(const SceneStroke &stroke, Entry &entry)
{
    if (!stroke.fill || !m_tile.width)
        return false;
    if (m_fills.size() == m_usedFills)
        m_fills.push_back(std::make_unique<TileFill>());
    TileFill &fill = *m_fills[m_usedFills];
    fill.begin(*stroke.fill, m_tile);
    bool any = false;
    for (std::size_t i = 0; i < blockCount(); ++i) {
        const int column = int(i) % m_grid.columns, row = int(i) / m_grid.columns;
        entry.presence[i] = fill.presence(m_tile.x + column * blockSide, m_tile.y + row * blockSide);
        any |= entry.presence[i] != FillPresence::Nothing;
    }
    if (any)
        entry.fill = int(m_usedFills++);
    return any;
}

std::size_t TileStrokes::list(const SceneStroke &stroke, const NodeRange &range, int runs, Cells &cells)
{
    const std::size_t room = std::size_t(runs) * boxRun, end = m_used + room * blockCount();
    if (m_nodes.size() < end)
        m_nodes.resize(2 * end);
    m_kernels->listNodes(stroke.boxes.boxes().from(range.from), range.size(), m_runs.data(), runs, m_grid,
                         m_nodes.data() + m_used, cells.data());
    return room;
}

bool TileStrokes::add(const SceneStroke &stroke, std::size_t place, const StrokePrefix *prefix)
{
    const NodeRange range{prefix ? prefix->nodes : 0, stroke.nodes.size()};
    Meeting tile;
    const int runs = findRuns(*m_kernels, stroke, range, m_area, m_runs, tile);
    if (prefix)
        tile += prefix->meeting;
    Entry filled;
    const bool hasFill = stroke.fill && findFill(stroke, filled);
    if (!hasFill && !shows(stroke, tile))
        return false;
    Cells cells;
    const std::size_t room = list(stroke, range, runs, cells);
    Entry &entry = m_strokes.emplace_back(filled);
    entry.scene = &stroke;
    entry.place = place;
    entry.prefix = prefix;
    bool shown = false;
    for (std::size_t i = 0; i < blockCount(); ++i) {
        const int listed = cells[i].count, column = int(i) % m_grid.columns, row = int(i) / m_grid.columns;
        if (prefix)
            cells[i] += prefix->blocks[i].meeting;
        if (hasFill)
            include(*stroke.fill, entry.presence[i], cells[i]);
        if (!shows(stroke, cells[i]) ||
            !meets(stroke.bounds, m_tile.x + column * blockSide, m_tile.y + row * blockSide))
            continue;
        entry.blocks[i] = {std::uint32_t(m_used + i * room), listed};
        shown = true;
    }
    if (shown)
        m_used += room * blockCount();
    else
        m_strokes.pop_back();
    return shown;
}

void TileStrokes::settle(const SceneStroke &stroke, std::size_t steady, StrokePrefix &prefix)
{
    if (steady <= prefix.nodes)
        return;
    const NodeRange range{prefix.nodes, steady};
    Meeting tile;
    const int runs = findRuns(*m_kernels, stroke, range, m_area, m_runs, tile);
    Cells cells;
    const std::size_t room = list(stroke, range, runs, cells);
    prefix.meeting += tile;
    prefix.nodes = steady;
    prefix.blocks.resize(blockCount());
    const std::size_t floats = std::size_t(fixedSums + stroke.channels) * blockSize;
    Sums sums;
    for (std::size_t i = 0; i < blockCount(); ++i) {
        BlockPrefix &block = prefix.blocks[i];
        const int count = cells[i].count;
        if (count == 0)
            continue;
        block.meeting += cells[i];
        sums.take(block.sums);
        const Block place{double(m_tile.x + int(i) % m_grid.columns * blockSide),
                          double(m_tile.y + int(i) / m_grid.columns * blockSide)};
        m_kernels->accumulate(place, listedOf(stroke, NodeList(m_nodes.data() + m_used + i * room, std::size_t(count))),
                              !block.sums.empty(), sums);
        block.sums.resize(floats);
        sums.give(block.sums);
    }
}

} // namespace suffuse::cpu
