#include "tests/render/cuda/emulated_device.h"

#include "render/cuda/gradient/gradient_place.h"
#include "render/cuda/gradient/gradient_sum.h"
#include "render/cuda/gradient/gradient_tile.h"
#include "render/cuda/nodes/node_merge.h"
#include "render/cuda/nodes/node_place.h"
#include "render/cuda/tiles/tile_lists.h"
#include "render/cuda/tiles/tile_program.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

namespace suffuse::test {

using namespace cuda;

namespace {

constexpr std::align_val_t alignment{256};
const Fault outside{Fault::Lost, "an address outside of the device's memory"};

} // namespace

EmulatedDevice::~EmulatedDevice()
{
    for (const Blocks &blocks : {m_blocks, m_pinned})
        for (const auto &[block, bytes] : blocks)
            ::operator delete(const_cast<std::byte *>(block), alignment);
}

bool EmulatedDevice::holds(const Blocks &blocks, const void *memory, std::size_t bytes)
{
    const auto *at = static_cast<const std::byte *>(memory);
    auto it = blocks.upper_bound(at);
    return it != blocks.begin() && (--it, at + bytes <= it->first + it->second);
}

void EmulatedDevice::perform(std::function<void()> work)
{
    if (m_timing == Timing::Late)
        m_late.push_back(std::move(work));
    else
        work();
}

void EmulatedDevice::performLate()
{
    for (const auto &work : std::exchange(m_late, {}))
        work();
}

Fault EmulatedDevice::allocate(std::size_t bytes, void **memory)
{
    if (bytes > m_memory - m_used)
        return {Fault::OutOfMemory, "out of memory"};
    *memory = ::operator new(bytes, alignment);
    std::memset(*memory, 0xcd, bytes); // nobody may rely on what new memory holds
    m_blocks[static_cast<std::byte *>(*memory)] = bytes;
    m_used += bytes;
    return {};
}

void EmulatedDevice::release(void *memory)
{
    performLate(); // as cudaFree does
    const auto it = m_blocks.find(static_cast<std::byte *>(memory));
    m_used -= it->second;
    ::operator delete(memory, alignment);
    m_blocks.erase(it);
}

Fault EmulatedDevice::allocateHost(std::size_t bytes, void **memory)
{
    *memory = ::operator new(bytes, alignment);
    m_pinned[static_cast<std::byte *>(*memory)] = bytes;
    return {};
}

void EmulatedDevice::releaseHost(void *memory)
{
    performLate();
    m_pinned.erase(static_cast<std::byte *>(memory));
    ::operator delete(memory, alignment);
}

Fault EmulatedDevice::upload(void *to, const void *from, std::size_t bytes)
{
    if (!holds(m_blocks, to, bytes))
        return outside;
    if (bytes == 0) // the addresses may be null then, which std::memcpy does not take
        return {};
    counts.uploaded += bytes;
    if (holds(m_pinned, from, bytes)) {
        perform([=] { std::memcpy(to, from, bytes); });
    } else { // it may change at once
        const auto *begin = static_cast<const std::byte *>(from);
        perform([to, kept = std::vector(begin, begin + bytes)] { std::memcpy(to, kept.data(), kept.size()); });
    }
    return {};
}

Fault EmulatedDevice::download(void *to, const void *from, std::size_t bytes)
{
    if (!holds(m_blocks, from, bytes))
        return outside;
    if (bytes == 0)
        return {};
    perform([=] { std::memcpy(to, from, bytes); });
    if (!holds(m_pinned, to, bytes))
        performLate();
    return {};
}

Fault EmulatedDevice::copyRects(std::uint32_t *to, const std::uint32_t *from, int rowPixels, const int (*rects)[4],
                                int count)
{
    for (int i = 0; i < count; ++i) {
        const auto [x, y, width, height] = rects[i];
        for (int row = y; row < y + height; ++row) {
            const std::size_t at = std::size_t(row) * std::size_t(rowPixels) + std::size_t(x);
            const std::size_t bytes = std::size_t(width) * sizeof(*to);
            if (!holds(m_blocks, to + at, bytes) || !holds(m_blocks, from + at, bytes))
                return outside;
            perform([=] { std::memcpy(to + at, from + at, bytes); });
        }
    }
    return {};
}

Fault EmulatedDevice::clear(void *memory, std::size_t bytes)
{
    if (!holds(m_blocks, memory, bytes))
        return outside;
    perform([=] { std::memset(memory, 0, bytes); });
    return {};
}

Fault EmulatedDevice::run(const Frame &frame, Work work)
{
    perform([=, this] { paint(frame, work); });
    return {};
}

void EmulatedDevice::paint(Frame frame, Work work)
{
    frame.ordered = true; // as a device does for pictures of many tiles
    HostWarp warp;
    HostBlock<listWarps> block;
    const auto makeLists = [&](auto fills) {
        const auto scratch = std::make_unique<ListScratch<fills.value>>();
        for (std::uint32_t i = 0; i < frame.macroCount * listParts; ++i)
            ListMaker<HostBlock<listWarps>, fills.value>(block, frame, i, *scratch).make();
    };
    if (frame.fills)
        makeLists(std::true_type{});
    else
        makeLists(std::false_type{});
    const auto plain = std::make_unique<TileScratch<false>>();
    const auto general = std::make_unique<TileScratch<true>>();
    const auto apart = [&](auto general, auto &scratch) {
        if (frame.fills)
            paintApart<general.value, true>(warp, frame, scratch);
        else
            paintApart<general.value, false>(warp, frame, scratch);
    };
    if (work.plain)
        apart(std::false_type{}, *plain);
    if (work.general)
        apart(std::true_type{}, *general);
    for (int kind = 0; kind < apartClasses; ++kind)
        counts.apart += frame.status[firstApartCount + kind];
    OrderScratch ordering;
    TileOrder order(warp, frame, ordering);
    for (std::uint32_t i = 0; i < frame.tileCount; ++i) {
        const std::uint32_t job = order.job(i);
        const int flags = frame.tiles[job].flags;
        counts.haveUnder += (flags & haveUnder) != 0;
        counts.applyOver += (flags & applyOver) != 0;
        counts.plainTiles += (flags & plainTile) != 0;
        const bool isPlain = flags & plainTile;
        if (!(isPlain ? work.plain : work.general))
            continue;
        if (isPlain && frame.layers)
            paintTile<false, true, true, true>(warp, frame, job, *plain);
        else if (isPlain && frame.apartRoom && frame.fills)
            paintTile<false, true, true, false>(warp, frame, job, *plain);
        else if (isPlain && frame.fills)
            paintTile<false, false, true, false>(warp, frame, job, *plain);
        else if (isPlain && frame.apartRoom)
            paintTile<false, true, false, false>(warp, frame, job, *plain);
        else if (isPlain)
            paintTile<false, false, false, false>(warp, frame, job, *plain);
        else if (frame.layers)
            paintTile<true, true, true, true>(warp, frame, job, *general);
        else if (!frame.fills)
            paintTile<true, true, false, false>(warp, frame, job, *general);
        else
            paintTile<true, true, true, false>(warp, frame, job, *general);
    }
    ++counts.runs;
    counts.tiles += frame.tileCount;
    counts.longestList = std::max(counts.longestList, frame.status[longestList]);
}

Fault EmulatedDevice::buildNodes(const NodeWork &work)
{
    perform([=, this] { makeNodes(work); });
    return {};
}

void EmulatedDevice::makeNodes(NodeWork work)
{
    HostWarp warp;
    PlaceScratch placing{};
    for (std::uint32_t job = 0; job < work.jobCount; ++job)
        NodePlacer<HostWarp>(warp, work, job, placing).run();
    const auto merging = std::make_unique<MergeScratch>();
    const std::uint32_t leaves = work.status[leavesTaken];
    HostFieldCrew crew(merging->field, reinterpret_cast<Four *>(work.planes));
    SpanMerger<HostFieldCrew> merger(crew, work, *merging);
    for (std::uint32_t leaf; (leaf = warp.take(work.status + nextLeaf)) < leaves;)
        merger.merge(leaf);
    counts.nodeJobs += work.jobCount;
}

Fault EmulatedDevice::findGradient(const GradientWork &work)
{
    perform([=, this] { makeGradient(work); });
    return {};
}

void EmulatedDevice::makeGradient(GradientWork work)
{
    HostWarp warp;
    for (std::uint32_t stroke = 0; stroke < work.strokeCount; ++stroke)
        GradientPlacer<HostWarp>(warp, work, stroke).run();
    const auto tiles = std::uint32_t(work.columns) * std::uint32_t(work.rows);
    const auto draw = [&](auto varies) {
        const auto scratch = std::make_unique<GradientScratch<varies.value>>();
        for (std::uint32_t tile; (tile = warp.take(work.status + nextGradientTile)) < tiles;)
            GradientTile<HostWarp, varies.value>(warp, work, *scratch, tile, tile % work.warps).run();
    };
    if (work.varies)
        draw(std::true_type{});
    else
        draw(std::false_type{});
    if (work.target || work.byRgb)
        for (std::uint32_t segment = 0; segment < work.segmentCount; ++segment)
            GradientSummer<HostWarp>(warp, work, segment).run();
}

Fault EmulatedDevice::finish(double *milliseconds)
{
    performLate();
    if (milliseconds)
        *milliseconds = 0;
    return {};
}

std::unique_ptr<GlTexture> EmulatedDevice::registerTexture(unsigned, Fault &)
{
    return nullptr;
}

} // namespace suffuse::test
