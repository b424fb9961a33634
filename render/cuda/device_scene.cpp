#include "render/cuda/device_scene.h"

#include "render/cuda/fill_records.h"
#include "render/cuda/stroke_records.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace suffuse::cuda {

DeviceScene::DeviceScene(Device &device)
    : m_nodes(device), m_values(device), m_deep(device), m_small(device), m_fills(device), m_pictureViews(device),
      m_chunks(device), m_strokes(device), m_pictures(device)
{}

void DeviceScene::forget()
{
    m_valid = false;
}

void DeviceScene::reset(int width, int height)
{
    m_width = width, m_height = height;
    m_columns = (width + tileSide - 1) / tileSide;
    m_general.assign(std::size_t(m_columns) * std::size_t((height + tileSide - 1) / tileSide), 0);
    m_nodes.resize(0), m_values.resize(0), m_deep.resize(0), m_small.resize(0), m_fills.resize(0),
        m_pictureViews.resize(0), m_chunks.resize(0), m_strokes.resize(0);
    m_nodeRuns.clear(), m_valueRuns.clear(), m_deepRuns.clear(), m_smallRuns.clear(), m_fillRuns.clear();
    m_pictureRuns.clear();
    m_freeSlots.clear();
    for (Entry &entry : m_entries)
        m_dropped.push_back(std::move(entry.stroke));
    m_entries.clear();
    m_valid = true;
}

void DeviceScene::countGeneral(const Entry &entry, int by)
{
    const StrokeRecord &record = m_strokes.host()[entry.slot];
    if (record.plain)
        return;
    for (std::uint32_t i = 0; i < record.chunks; ++i) {
        const ChunkRecord &c = m_chunks.host()[entry.firstChunk + i];
        if (c.left >= c.right || c.top >= c.bottom)
            continue;
        for (int row = c.top / tileSide; row <= (c.bottom - 1) / tileSide; ++row)
            for (int column = c.left / tileSide; column <= (c.right - 1) / tileSide; ++column)
                m_general[std::size_t(row) * m_columns + column] += by;
    }
}

void DeviceScene::drop(Entry &entry)
{
    countGeneral(entry, -1);
    m_nodeRuns.give(entry.nodes);
    m_valueRuns.give(entry.values);
    m_deepRuns.give(entry.deep);
    m_smallRuns.give(entry.small);
    m_fillRuns.give(entry.fill);
    m_pictureRuns.give(entry.picture);
    m_freeSlots.push_back(entry.slot);
    m_dropped.push_back(std::move(entry.stroke));
}

void DeviceScene::freeDropped(Threads threads)
{
    constexpr std::size_t share = 16;
    parallelFor((m_dropped.size() + share - 1) / share, threads, [this](std::size_t k) {
        for (std::size_t i = k * share; i < std::min((k + 1) * share, m_dropped.size()); ++i)
            m_dropped[i] = nullptr;
    });
    m_dropped.clear();
}

bool DeviceScene::knowsAny(const std::vector<SceneStrokePtr> &strokes) const
{
    std::unordered_set<const SceneStroke *> known;
    for (const Entry &entry : m_entries)
        known.insert(entry.stroke.get());
    return std::ranges::any_of(strokes, [&](const SceneStrokePtr &stroke) { return known.contains(stroke.get()); });
}

std::size_t DeviceScene::align(const std::vector<SceneStrokePtr> &strokes, std::vector<Prepared> &changed)
{
    std::size_t same = 0;
    while (same < strokes.size() && same < m_entries.size() && m_entries[same].stroke == strokes[same])
        ++same;
    std::unordered_map<const SceneStroke *, Entry> old;
    for (std::size_t i = same; i < m_entries.size(); ++i)
        old.emplace(m_entries[i].stroke.get(), std::move(m_entries[i]));
    m_entries.resize(same);
    for (std::size_t i = same; i < strokes.size(); ++i) {
        const auto it = old.find(strokes[i].get());
        if (it != old.end()) {
            m_entries.push_back(std::move(it->second));
            old.erase(it);
        } else {
            m_entries.emplace_back().stroke = strokes[i];
            changed.emplace_back().index = i;
        }
    }
    for (auto &[stroke, entry] : old)
        drop(entry);
    for (const Prepared &p : changed) {
        std::uint32_t &slot = m_entries[p.index].slot;
        if (m_freeSlots.empty()) {
            slot = std::uint32_t(m_strokes.host().size());
            m_strokes.resize(slot + 1);
        } else {
            slot = m_freeSlots.back();
            m_freeSlots.pop_back();
        }
    }
    return same;
}

void DeviceScene::prepareFills(std::vector<Prepared> &changed, Threads threads)
{
    parallelFor(changed.size(), threads, [&](std::size_t i) {
        const SceneFill *fill = m_entries[changed[i].index].stroke->fill.get();
        if (!fill)
            return;
        if (fill->deep)
            changed[i].deepFill = deepFillRecords(*fill);
        else
            changed[i].fillRecords = fillRecords(*fill);
    });
}

void DeviceScene::placeRecords(const std::vector<Prepared> &changed)
{
    for (const Prepared &p : changed) {
        Entry &e = m_entries[p.index];
        const SceneStroke &s = *e.stroke;
        m_nodeRuns.fit(e.nodes, std::uint32_t(p.fillRecords.size() + s.nodes.size()));
        m_valueRuns.fit(e.values, std::uint32_t(s.values.size()));
        m_deepRuns.fit(e.deep, std::uint32_t(s.deep.size() + p.deepFill.size()));
        m_smallRuns.fit(e.small, std::uint32_t(s.small.size()));
        m_fillRuns.fit(e.fill, s.fill ? 1 : 0);
        m_pictureRuns.fit(e.picture, s.picture ? 1 : 0);
    }
    m_nodes.resize(m_nodeRuns.size());
    m_values.resize(m_valueRuns.size());
    m_deep.resize(m_deepRuns.size());
    m_small.resize(m_smallRuns.size());
    m_fills.resize(m_fillRuns.size());
    m_pictureViews.resize(m_pictureRuns.size());
}

void DeviceScene::setNodes(Prepared &p, Threads threads)
{
    const Entry &e = m_entries[p.index];
    const SceneStroke &s = *e.stroke;
    const std::size_t deep = isDeep(s) ? 1 : 0, count = nodeChunks(s), records = p.fillRecords.size();
    const std::size_t before = deep + (records + chunkNodes - 1) / chunkNodes;
    p.chunks.resize(before + count);
    if (deep)
        p.chunks[0] = deepChunk(s);
    for (std::size_t i = deep, begin = 0; i < before; ++i, begin += chunkNodes)
        p.chunks[i] =
            fillChunkOf(*s.fill, p.fillRecords, begin, std::min(begin + chunkNodes, records), m_width, m_height);
    constexpr std::size_t share = 16, worthSharing = 4 * share; // Both are numbers of chunks.
    const std::size_t shares = (count + share - 1) / share;
    std::vector<IndexRange> changed(count);
    parallelFor(shares, count < worthSharing ? Threads(1) : threads, [&](std::size_t k) {
        for (std::size_t i = k * share; i < std::min((k + 1) * share, count); ++i) {
            ChunkRecord &chunk = p.chunks[before + i] = chunkOf(s, i, m_width, m_height);
            const std::size_t first = chunk.firstNode;
            chunk.firstNode += std::uint32_t(records);
            changed[i] = m_nodes.set(e.nodes.begin + chunk.firstNode, chunk.nodes,
                                     [&](std::size_t node) { return nodeRecord(s, first + node); });
        }
    });
    for (ChunkRecord &chunk : p.chunks)
        chunk.firstNode += e.nodes.begin, chunk.stroke = e.slot;
    p.nodes = m_nodes.set(e.nodes.begin, records, [&](std::size_t i) { return p.fillRecords[i]; });
    if (p.nodes.first >= p.nodes.second)
        p.nodes = {m_nodes.host().size(), 0};
    for (const auto &[begin, end] : changed)
        if (begin < end)
            p.nodes = {std::min(p.nodes.first, begin), end};
}

void DeviceScene::prepare(Prepared &p, Threads threads)
{
    const Entry &e = m_entries[p.index];
    const SceneStroke &s = *e.stroke;
    setNodes(p, threads);
    p.values = m_values.set(e.values.begin, e.values.count, [&](std::size_t i) { return s.values[i]; });
    const std::size_t ownDeep = s.deep.size();
    p.deep = m_deep.set(e.deep.begin, e.deep.count,
                        [&](std::size_t i) { return i < ownDeep ? deepRecord(s.deep[i]) : p.deepFill[i - ownDeep]; });
    p.fill = m_fills.set(e.fill.begin, e.fill.count, [&](std::size_t) { return fillValues(*s.fill); });
    p.picture = m_pictureViews.set(e.picture.begin, e.picture.count,
                                   [&](std::size_t) { return m_pictures.viewOf(*s.picture); });
    p.small = m_small.set(e.small.begin, e.small.count, [&](std::size_t i) { return smallRecord(s.small[i]); });
    p.record = strokeRecord(s);
    p.record.chunks = std::uint32_t(p.chunks.size());
    p.record.firstValue = e.values.begin;
    p.record.firstDeep = e.deep.begin, p.record.deep = std::uint32_t(ownDeep);
    p.record.fillValues = e.fill.begin;
    p.record.picture = s.picture ? e.picture.begin + 1 : 0;
    p.record.firstSmall = e.small.begin, p.record.small = e.small.count;
}

void DeviceScene::writeChunks(std::size_t at, const std::vector<ChunkRecord> &chunks, std::uint32_t room)
{
    m_chunks.touch(
        m_chunks.set(at, room, [&](std::size_t i) { return i < chunks.size() ? chunks[i] : ChunkRecord{}; }));
}

void DeviceScene::moveChunks(std::vector<Prepared> &changed, std::size_t from)
{
    const auto &host = m_chunks.host();
    std::vector<ChunkRecord> tail;
    const std::size_t begin = from == 0 ? 0 : m_entries[from - 1].firstChunk + m_entries[from - 1].chunkRoom;
    std::size_t next = 0;
    for (std::size_t i = from; i < m_entries.size(); ++i) {
        Entry &e = m_entries[i];
        const auto first = std::uint32_t(begin + tail.size());
        while (next < changed.size() && changed[next].index < i)
            ++next;
        if (next < changed.size() && changed[next].index == i) {
            const auto count = std::uint32_t(changed[next].chunks.size());
            // A stroke that has grown once may grow again.
            if (count > e.chunkRoom)
                e.chunkRoom = e.chunkRoom ? count + count / 2 : count;
            tail.insert(tail.end(), changed[next].chunks.begin(), changed[next].chunks.end());
            tail.resize(first - begin + e.chunkRoom);
        } else {
            tail.insert(tail.end(), host.begin() + e.firstChunk, host.begin() + e.firstChunk + e.chunkRoom);
            if (StrokeRecord &record = m_strokes.host()[e.slot]; record.firstChunk != first) {
                record.firstChunk = first;
                m_strokes.touch({e.slot, e.slot + 1});
            }
        }
        e.firstChunk = first;
    }
    m_chunks.resize(begin + tail.size());
    writeChunks(begin, tail, std::uint32_t(tail.size()));
}

void DeviceScene::placeChunks(std::vector<Prepared> &changed, std::size_t from)
{
    for (const Prepared &p : changed) {
        const Entry &e = m_entries[p.index];
        if (p.index >= from)
            break;
        if (p.chunks.size() > e.chunkRoom)
            from = p.index;
        else
            writeChunks(e.firstChunk, p.chunks, e.chunkRoom);
    }
    if (from < m_entries.size() || from == 0 ||
        m_entries.back().firstChunk + m_entries.back().chunkRoom < m_chunks.host().size())
        moveChunks(changed, from);
    for (Prepared &p : changed) {
        const Entry &e = m_entries[p.index];
        p.record.firstChunk = e.firstChunk;
        m_strokes.touch(m_strokes.set(e.slot, 1, [&](std::size_t) { return p.record; }));
        countGeneral(e, 1);
    }
}

Fault DeviceScene::upload()
{
    for (const Fault &fault : {m_nodes.upload(), m_values.upload(), m_deep.upload(), m_small.upload(), m_fills.upload(),
                               m_pictureViews.upload(), m_chunks.upload(), m_strokes.upload()})
        if (fault)
            return fault;
    return {};
}

Fault DeviceScene::update(const std::vector<SceneStrokePtr> &strokes, const SceneChange &change, int width, int height,
                          Threads threads)
{
    freeDropped(threads);
    const bool wasteful = m_nodeRuns.size() > 2 * m_nodeRuns.used() + (std::size_t(1) << 16);
    // If all strokes are new, they are packed again.
    const bool anew =
        !m_valid || wasteful || width != m_width || height != m_height || (change.reordered && !knowsAny(strokes));
    if (anew)
        reset(width, height);
    std::vector<Prepared> changed;
    std::size_t from = m_entries.size();
    if (anew || change.reordered) {
        from = align(strokes, changed);
    } else {
        for (const SceneChange::Replaced &r : change.replaced) {
            countGeneral(m_entries[r.index], -1);
            m_entries[r.index].stroke = strokes[r.index];
            changed.emplace_back().index = r.index;
        }
    }
    const auto hasPicture = [&](const Prepared &p) { return m_entries[p.index].stroke->picture != nullptr; };
    if (!m_pictures.isEmpty() || std::ranges::any_of(changed, hasPicture))
        if (Fault fault = m_pictures.keep(strokes))
            return fault;
    prepareFills(changed, threads);
    placeRecords(changed);
    const Threads threadsEach = threads.within(changed.size());
    parallelFor(changed.size(), threads, [&](std::size_t i) { prepare(changed[i], threadsEach); });
    for (const Prepared &p : changed)
        m_nodes.touch(p.nodes), m_values.touch(p.values), m_deep.touch(p.deep), m_small.touch(p.small),
            m_fills.touch(p.fill), m_pictureViews.touch(p.picture);
    placeChunks(changed, from);
    return upload();
}

void DeviceScene::fill(Frame &frame) const
{
    frame.nodes = m_nodes.device();
    frame.values = m_values.device();
    frame.deep = m_deep.device();
    frame.small = m_small.device();
    frame.pictures = m_pictureViews.device();
    frame.fills = m_fillRuns.used() ? m_fills.device() : nullptr;
    frame.chunks = m_chunks.device();
    frame.strokes = m_strokes.device();
}

std::uint32_t DeviceScene::firstChunk(std::size_t i) const
{
    return i < m_entries.size() ? m_entries[i].firstChunk : chunkCount();
}

} // namespace suffuse::cuda
