// One warp finds here how much of each sample a crisp fill covers, and which pixels lie near the boundary of a thin one
// (docs/cuda.md, "Fills").
#pragma once

#include "render/cuda/tiles/tile_fill.h"

namespace suffuse::cuda {

/// Puts a FillCurveRecord together from its parts of 16 bytes.
template <class PartOf>
SUFFUSE_PROGRAM FillCurveRecord curveRecordOf(PartOf partOf)
{
    const Float4 first = partOf(0), second = partOf(1);
    FillCurveRecord record;
    record.x1 = first.x, record.y1 = first.y, record.x2 = first.z, record.y2 = first.w;
    record.x3 = second.x, record.y3 = second.y;
    return record;
}

/// A panel's curve, in samples of a block whose first one is the square from 0 to 1. Both coordinates are monotone.
struct FillCurve {
    float x[4], y[4];

    SUFFUSE_PROGRAM FillCurve(const FillRecord &from, const FillCurveRecord &curve, std::int32_t cellX,
                              std::int32_t cellY, const Block &block)
    {
        constexpr float half = tileSide / 2;
        const float scale = math::reciprocal_(block.step); // a power of two
        x[0] = (float((from.cellX - cellX) * tileSide) + (from.x - half) - block.x) * scale + half;
        y[0] = (float((from.cellY - cellY) * tileSide) + (from.y - half) - block.y) * scale + half;
        x[1] = math::mulAdd_(curve.x1, scale, x[0]), y[1] = math::mulAdd_(curve.y1, scale, y[0]);
        x[2] = math::mulAdd_(curve.x2, scale, x[0]), y[2] = math::mulAdd_(curve.y2, scale, y[0]);
        x[3] = math::mulAdd_(curve.x3, scale, x[0]), y[3] = math::mulAdd_(curve.y3, scale, y[0]);
    }

    static SUFFUSE_PROGRAM float at(const float (&p)[4], float t)
    {
        const float u = 1 - t;
        return u * u * (u * p[0] + 3 * t * p[1]) + t * t * (3 * u * p[2] + t * p[3]);
    }
    static SUFFUSE_PROGRAM float slopeAt(const float (&p)[4], float t)
    {
        const float u = 1 - t;
        return 3 * (u * u * (p[1] - p[0]) + 2 * u * t * (p[2] - p[1]) + t * t * (p[3] - p[2]));
    }
    /// Returns the parameter where a coordinate has a value, or the nearer end if it never has.
    static SUFFUSE_PROGRAM float parameterAt(const float (&p)[4], float value)
    {
        const bool rises = p[0] < p[3];
        if (rises ? value <= p[0] : value >= p[0])
            return 0;
        if (rises ? value >= p[3] : value <= p[3])
            return 1;
        float low = 0, high = 1;
        SUFFUSE_ROLLED
        for (int i = 0; i < 22; ++i) {
            const float middle = 0.5f * (low + high);
            ((at(p, middle) > value) == rises ? high : low) = middle;
        }
        return 0.5f * (low + high);
    }
};

/// Sums up how much of each sample lies inside. `covered` has room for all samples, and `borders` for two more than
/// twice a tile's side.
struct FillCover {
    float *covered, *borders;
};

/// Returns where plain strokes sum up what they cover. They have no nodes, whose channels and means would lie there.
SUFFUSE_PROGRAM FillCover plainCover(SumScratch &s)
{
    static_assert(sizeof s.sums.channel >= tileSize * sizeof(float));
    return {reinterpret_cast<float *>(s.sums.channel), s.means.h2};
}

template <class Warp>
SUFFUSE_PROGRAM void clearCover(Warp &warp, const FillCover &cover)
{
    warp.each([&](int lane) {
        for (int k = 0; k < laneSamples; ++k)
            cover.covered[sampleAt(lane, k)] = 0;
    });
}

/// Returns how much of a sample is covered, from the sum of all panels and `base`. What is 0 or 1 but for rounding is
/// so.
SUFFUSE_PROGRAM float coveredShare(float sum)
{
    return sum < 1e-4f ? 0.0f : sum > 1 - 1e-4f ? 1.0f : sum;
}

/// Adds a number to all that lies below a height.
template <class Warp>
SUFFUSE_PROGRAM void addBelow(Warp &warp, const FillCover &cover, float y, float jump)
{
    warp.each([&](int lane) {
        for (int k = 0; k < laneSamples; ++k) {
            const float above = y - float(sampleRow(lane, k));
            cover.covered[sampleAt(lane, k)] += jump * (1 - math::min_(math::max_(above, 0.0f), 1.0f));
        }
    });
}

/// Returns ∫(right − x) dy by a rule that is exact for cubics.
SUFFUSE_PROGRAM float areaRightOf(const FillCurve &curve, float from, float to, float right)
{
    constexpr float node = 0.38729833f; // from the middle, of the whole
    const float middle = 0.5f * (from + to), width = to - from;
    const auto term = [&](float t) { return (right - FillCurve::at(curve.x, t)) * FillCurve::slopeAt(curve.y, t); };
    const float ends = term(middle - node * width) + term(middle + node * width);
    return width * math::mulAdd_(5.0f / 18, ends, 8.0f / 18 * term(middle));
}

/// Adds what lies right of a curve at its heights.
template <class Warp>
SUFFUSE_PROGRAM void addRightOf(Warp &warp, const FillCover &cover, const FillCurve &curve, float enters)
{
    constexpr int borders = tileSide + 1; // The parameters where it crosses those of rows come first, then of columns.
    warp.each([&](int lane) {
        for (int i = lane; i < borders; i += warpLanes) {
            cover.borders[i] = FillCurve::parameterAt(curve.y, float(i));
            cover.borders[borders + i] = FillCurve::parameterAt(curve.x, float(i));
        }
    });
    const bool rises = curve.x[0] < curve.x[3];
    warp.each([&](int lane) {
        SUFFUSE_ROLLED
        for (int k = 0; k < laneSamples; ++k) {
            const int column = sampleColumn(lane, k), row = sampleRow(lane, k);
            const float from = cover.borders[row], to = cover.borders[row + 1];
            if (!(from < to))
                continue;
            const float left = cover.borders[borders + column], right = cover.borders[borders + column + 1];
            const auto cut = [&](float t) { return math::min_(math::max_(t, from), to); };
            // Where it lies left of the column, and where it lies in it.
            const float leftFrom = rises ? from : cut(left), leftTo = rises ? cut(left) : to;
            const float inFrom = rises ? leftTo : cut(right), inTo = rises ? cut(right) : leftFrom;
            float area = FillCurve::at(curve.y, leftTo) - FillCurve::at(curve.y, leftFrom);
            if (inFrom < inTo)
                area += areaRightOf(curve, inFrom, inTo, float(column + 1));
            cover.covered[sampleAt(lane, k)] += enters * area;
        }
    });
}

/// Adds a chunk of a fill, which must have arrived. Returns how often the area is entered left of what the chunk tells.
template <class Warp>
SUFFUSE_CALL int addCover(Warp warp, const FillCover cover, const Fetched &chunk, int records, const FillValues &fill,
                          std::int32_t cellX, std::int32_t cellY, const Block block)
{
    SUFFUSE_IN_SHARED(chunk);
    SUFFUSE_IN_SHARED(*cover.covered);
    SUFFUSE_IN_SHARED(*cover.borders);
    const FillRegion region = fillRegion(fill, cellX, cellY, block.x, block.y, block.step);
    typename Warp::template Var<std::uint32_t> use;
    std::uint32_t hits = warp.ballot([&](int lane) {
        use[lane] = lane < records ? useOf(endsOf(fillRecordOf(chunk, lane)), region) : 0;
        return (use[lane] & metFill) != 0;
    });
    const int base = Warp::count(warp.ballot([&](int lane) { return (use[lane] & enteredFill) != 0; })) -
                     Warp::count(warp.ballot([&](int lane) { return (use[lane] & leftFill) != 0; }));
    for (; hits; hits &= hits - 1) {
        const int n = Warp::lowest(hits);
        const FillRecord record = fillRecordOf(chunk, n);
        FillCurveRecord rest;
        if (record.kind & fillShape)
            rest = curveRecordOf([&](int part) { return chunk.nodes[part][n + 1]; });
        const FillCurve curve(record, rest, cellX, cellY, block);
        const std::uint32_t own = warp.read(use, n);
        if (own & fillEvent)
            addBelow(warp, cover, own & fillFalls ? curve.y[3] : curve.y[0], jumpOf(record.kind, own));
        if (record.kind & fillShape)
            addRightOf(warp, cover, curve, float(record.kind >> 8));
    }
    return base;
}

/// Raises the level of the pixels of a job's tile that lie near one panel or flat, whose curve runs through their
/// squares if these are grown by `nearby` on all sides. Returns whether there are any. Both coordinates of the curve
/// are monotone, so that its part at the heights of a row of squares lies between the ends of that part. Each lane
/// finds one such end.
template <class Warp>
SUFFUSE_PROGRAM bool markNear(Warp &warp, const NodeRecord *from, const ApartJob &job, float nearby, std::uint8_t level,
                              std::uint8_t *levels)
{
    const FillRecord record = readFillRecord(from);
    FillCurveRecord rest;
    if (record.kind & fillShape) {
        const auto *parts = reinterpret_cast<const Float4 *>(from + 1);
        rest = curveRecordOf([&](int part) { return parts[part]; });
    } else {
        rest.x1 = rest.x2 = rest.x3 = float(record.x1 - record.x0) * (1.0f / fillUnits);
    }
    const FillCurve curve(record, rest, job.column, job.row, Block{});
    const auto meets = [&](float x0, float x1, float left, float side) {
        return math::min_(x0, x1) < left + side + nearby && math::max_(x0, x1) > left - nearby;
    };
    constexpr float side = tileSide;
    if (!(curve.y[0] < side + nearby && curve.y[3] > -nearby && meets(curve.x[0], curve.x[3], 0, side)))
        return false;
    typename Warp::template Var<float>
        end; // of the part at a row: its upper end, and from lane tileSide on its lower one
    warp.each([&](int lane) {
        const float row = float(lane % tileSide);
        end[lane] =
            FillCurve::at(curve.x, FillCurve::parameterAt(curve.y, lane < tileSide ? row - nearby : row + 1 + nearby));
    });
    return warp.any([&](int lane) {
        bool marked = false;
        SUFFUSE_UNROLL
        for (int k = 0; k < laneSamples; ++k) {
            const int row = sampleRow(lane, k);
            const float upper = warp.read(end, row), lower = warp.read(end, row + tileSide);
            const float left = float(sampleColumn(lane, k)), top = float(row);
            std::uint8_t &own = levels[sampleAt(lane, k)];
            if (own < level && curve.y[0] < top + 1 + nearby && curve.y[3] > top - nearby &&
                meets(curve.x[0], curve.x[3], left, 1) && meets(upper, lower, left, 1))
                own = level, marked = true;
        }
        return marked;
    });
}

/// Raises the level of the pixels of a job's tile that lie as near to the boundary of a thin fill as docs/solver.md
/// says ("Supersampling"). Returns whether there are any. `levels` is arranged as sampleAt says.
template <class Warp>
SUFFUSE_CALL bool markThinFill(Warp warp, const Frame &frame, const ApartJob job, const StrokeRecord &stroke,
                               std::uint8_t *levels)
{
    SUFFUSE_IS_LAUNCHED(frame);
    SUFFUSE_IN_SHARED(stroke);
    SUFFUSE_IN_SHARED(*levels);
    const std::int32_t cellX = job.column, cellY = job.row;
    const FillValues &fill = frame.fills[stroke.fillValues];
    const float nearby = float(fill.nearby);
    const FillRegion region = fillRegion(fill, cellX, cellY);
    const auto level = std::uint8_t(stroke.fill / fillLevel);
    bool any = false;
    typename Warp::template Var<std::uint32_t> firstNode, count; // of 32 chunks
    for (std::uint32_t base = job.from; base < job.to; base += warpLanes) {
        std::uint32_t near = warp.ballot([&](int lane) {
            const std::uint32_t i = base + std::uint32_t(lane);
            if (i >= job.to)
                return false;
            const ChunkRecord chunk = frame.chunks[i];
            firstNode[lane] = chunk.firstNode, count[lane] = chunk.nodes & chunkCountBits;
            return (chunk.nodes & fillChunk) != 0 && meetsTile(chunk, cellX, cellY);
        });
        for (; near; near &= near - 1) {
            const NodeRecord *records = frame.nodes + warp.read(firstNode, Warp::lowest(near));
            const std::uint32_t listed = warp.read(count, Warp::lowest(near));
            std::uint32_t hits = warp.ballot([&](int lane) {
                if (std::uint32_t(lane) >= listed)
                    return false;
                const FillEnds ends = endsOf(readFillRecord(records + lane));
                return (ends.kind & (fillShape | fillFlat)) != 0 && (useOf(ends, region) & metFill) != 0;
            });
            for (; hits; hits &= hits - 1)
                any |= markNear(warp, records + Warp::lowest(hits), job, nearby, level, levels);
        }
    }
    warp.meet();
    return any;
}

} // namespace suffuse::cuda
