#include "render/cuda/stroke_records.h"

#include "render/cuda/fill_records.h"

#include "render/math/scalar.h"
// This header has templates over the numbers of scalar.h, which must be declared before it.
#include "render/math/shade.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace suffuse::cuda {

namespace {

/// Keeps a style that the host has made, as the bytes that the device takes for it.
template <class Style>
void keepStyle(const Style &style, float (&bytes)[12])
{
    static_assert(std::is_trivially_copyable_v<Style> && sizeof(Style) <= sizeof(bytes));
    std::memcpy(bytes, &style, sizeof(Style));
}

/// Tells whether a stroke is plain but for its picture, for samples and for nodes beside a crisp fill.
bool isPlainAtSamples(const SceneStroke &s)
{
    const SceneFill *fill = s.fill.get();
    if (fill && (fill->deep || fill->b != 0 || s.shade.colourChannel >= 0))
        return false;
    return math::hasOneStyle(s.shade) && s.shade.grainChannel < 0 && s.shade.laidChannel < 0 &&
           s.shade.fadeChannel < 0 && s.separable == int(s.nodes.size()) && s.deep.empty();
}

/// Sets StrokeRecord::plain and simple, as these explain it.
void noteKind(const SceneStroke &s, StrokeRecord &record)
{
    const bool easy = isPlainAtSamples(s), crisp = s.fill && s.fill->crisp;
    record.simple = easy && !crisp;
    record.plain =
        easy && !s.picture && s.small.empty() && !(s.fill && s.fill->level > 0) && !(crisp && !s.nodes.empty());
}

/// Finds the pixels that nodes [begin, end) may show in: their boxes and a pixel around them, since coverage looks at
/// the whole pixel.
void bound(const SceneStroke &s, std::size_t begin, std::size_t end, int width, int height, ChunkRecord &chunk)
{
    const NodeBoxes boxes = s.boxes.boxes();
    double left = 1e30, top = 1e30, right = -1e30, bottom = -1e30;
    for (std::size_t i = begin; i < end; ++i) {
        const double x = s.nodes[i].x, y = s.nodes[i].y;
        const double reachX = double(boxes.reachX[i]) + 1, reachY = double(boxes.reachY[i]) + 1;
        left = std::min(left, x - reachX), right = std::max(right, x + reachX);
        top = std::min(top, y - reachY), bottom = std::max(bottom, y + reachY);
    }
    const auto cut = [](double v, int size) { return std::int32_t(std::clamp(v, 0.0, double(size))); };
    chunk.left = cut(std::floor(left), width), chunk.right = cut(std::ceil(right), width);
    chunk.top = cut(std::floor(top), height), chunk.bottom = cut(std::ceil(bottom), height);
}

/// Returns ⌊v / tileSide⌋, without a call.
std::int32_t cellOf(double v)
{
    const double cells = v / tileSide;
    const auto cell = std::int32_t(cells);
    return cell - (cells < cell);
}

} // namespace

NodeRecord nodeRecord(const SceneStroke &stroke, std::size_t i)
{
    const ViewNode &n = stroke.nodes[i];
    const NodeBoxes boxes = stroke.boxes.boxes();
    NodeRecord r;
    r.cellX = cellOf(n.x), r.cellY = cellOf(n.y);
    r.x = float(n.x - double(tileSide) * r.cellX), r.y = float(n.y - double(tileSide) * r.cellY);
    r.reachX = boxes.reachX[i], r.reachY = boxes.reachY[i];
    r.a = n.a, r.b = n.b, r.c = n.c;
    r.weight = n.weight;
    r.cut = n.cut;
    r.row = n.row;
    return r;
}

DeepRecord deepRecord(const DeepNode &n)
{
    return {n.x, n.y, n.a, n.b, n.c, n.weight, n.row, 0};
}

SmallRecord smallRecord(const SmallSegment &s)
{
    return {s.reach.left, s.reach.top, s.reach.right, s.reach.bottom, s.level, 0};
}

StrokeRecord strokeRecord(const SceneStroke &s)
{
    StrokeRecord r;
    r.shade = s.shade;
    for (int k = 0; k < s.shade.kinds; ++k) {
        const KindParams &kind = s.shade.kind[k];
        r.level[k] = s.level[k];
        if (kind.xiChannel < 0)
            math::withStyle<float>(
                kind.kind, [&](int i) { return kind.xi[i]; }, [&](const auto &style) { keepStyle(style, r.style[k]); });
    }
    r.lowest = s.lowest;
    r.keep = s.keep;
    r.hasLevels = s.hasLevels;
    r.channels = std::uint32_t(s.channels);
    r.granulated = s.granulated;
    noteKind(s, r);
    if (s.fill)
        noteFill(*s.fill, r);
    return r;
}

std::size_t nodeChunks(const SceneStroke &s)
{
    const std::size_t nodes = s.nodes.size(), separable = std::size_t(s.separable);
    return (separable + chunkNodes - 1) / chunkNodes + (nodes - separable + chunkNodes - 1) / chunkNodes;
}

ChunkRecord chunkOf(const SceneStroke &s, std::size_t i, int width, int height)
{
    const std::size_t separable = std::size_t(s.separable), chunks = (separable + chunkNodes - 1) / chunkNodes;
    const bool oblique = i >= chunks;
    const std::size_t begin = oblique ? separable + (i - chunks) * chunkNodes : i * chunkNodes;
    const std::size_t end = std::min(begin + chunkNodes, oblique ? s.nodes.size() : separable);
    ChunkRecord chunk;
    bound(s, begin, end, width, height, chunk);
    chunk.firstNode = std::uint32_t(begin);
    chunk.nodes = std::uint32_t(end - begin);
    return chunk;
}

ChunkRecord deepChunk(const SceneStroke &s)
{
    ChunkRecord chunk;
    chunk.left = s.bounds.x, chunk.top = s.bounds.y;
    chunk.right = s.bounds.x + s.bounds.width, chunk.bottom = s.bounds.y + s.bounds.height;
    return chunk;
}

} // namespace suffuse::cuda
