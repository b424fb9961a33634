// One warp evaluates a stroke that is not plain at one tile here, in parts: the pixels that one sample is enough for,
// and by quadrants those that are supersampled, since something at them is too narrow.
#pragma once

#include "render/cuda/tiles/tile_any.h"
#include "render/cuda/tiles/tile_block.h"
#include "render/math/picture.h"

namespace suffuse::cuda {

/// A warp has this in shared memory.
struct GeneralScratch {
    Float4 quadrant[tileSize / 4]; ///< w and colour at the pixels of a quadrant, row by row
    std::uint8_t level[tileSize];  ///< of the tile's pixels, in the order of `sampleAt`
};

/// Returns the quadrant of a tile in which a pixel lies.
SUFFUSE_PROGRAM int quadrantOf(int column, int row)
{
    constexpr int half = tileSide / 2;
    return column / half + 2 * (row / half);
}
/// Returns the part of a stroke's job to which a lane's pixel belongs, by the level that `markLevels` has found there.
SUFFUSE_PROGRAM int partOf(const StrokeRecord &stroke, int level, int lane, int k)
{
    return !isSupersampled(stroke) || level == 0 ? 0 : 1 + quadrantOf(sampleColumn(lane, k), sampleRow(lane, k));
}

/// Returns the place of a pixel in GeneralScratch::quadrant.
SUFFUSE_PROGRAM int quadrantAt(int column, int row)
{
    constexpr int half = tileSide / 2;
    return row % half * half + column % half;
}
/// Returns w and colour at a pixel of a part that has been evaluated.
SUFFUSE_PROGRAM Float4 &partSample(PaintScratch &paint, GeneralScratch &general, int part, int lane, int k)
{
    return part == 0 ? paintedSamples(paint.sums)[sampleAt(lane, k)]
                     : general.quadrant[quadrantAt(sampleColumn(lane, k), sampleRow(lane, k))];
}

/// Says whether the levels of pixels are found before a part is evaluated: those of all pixels, those of the part
/// alone, or none, since they are known.
enum class Levels { FindAll, FindOwn, Known };

/// If `fills`, the stroke may have a fill.
template <class Warp, bool fills>
class GeneralStroke {
public:
    template <class T>
    using Var = typename Warp::template Var<T>;

    /// The stroke's record has arrived.
    SUFFUSE_PROGRAM GeneralStroke(Warp &warp, const Frame &frame, const ApartJob &job, PaintScratch &paint,
                                  GeneralScratch &scratch)
        : m_warp(warp), m_frame(frame), m_stroke(strokeOf(paint.stroke)), m_job(job), m_left(job.column * tileSide),
          m_top(job.row * tileSide), m_paint(paint), m_sums(paint.sums), m_s(scratch)
    {}

    /// Finds what the stroke shows at the pixels of one part of its job (`partOf`, `partSample`). Returns whether some
    /// pixels whose levels were found are supersampled.
    SUFFUSE_PROGRAM bool evaluate(int part, Levels levels)
    {
        const bool some = levels != Levels::Known && markLevels(levels == Levels::FindAll ? 0 : part);
        if (part == 0)
            evaluateBlock(Block{}, 0);
        else if (some || levels == Levels::Known)
            evaluateQuadrant(part - 1);
        if (m_stroke.picture)
            showPicture(part);
        return some;
    }

private:
    /// Tells whether the stroke has a fill of this kind.
    SUFFUSE_PROGRAM bool has(FillFlag flag) const { return fills && (m_stroke.fill & flag) != 0; }
    SUFFUSE_PROGRAM Float4 *painted() { return paintedSamples(m_sums); }

    /// Puts the stroke's picture in the place of its colours, at the pixels of a part.
    SUFFUSE_PROGRAM void showPicture(int part)
    {
        const PictureView &picture = m_frame.pictures[m_stroke.picture - 1];
        m_warp.each([&](int lane) {
            SUFFUSE_ROLLED
            for (int k = 0; k < laneSamples; ++k) {
                if (partOf(m_stroke, m_s.level[sampleAt(lane, k)], lane, k) != part)
                    continue;
                Float4 &sample = partSample(m_paint, m_s, part, lane, k);
                const math::PicturePaint paint = math::shown(picture, m_left + sampleColumn(lane, k) + 0.5,
                                                             m_top + sampleRow(lane, k) + 0.5, sample.x);
                sample = {paint.w, paint.red, paint.yellow, paint.blue};
            }
        });
    }

    /// Finds for each pixel of a part the greatest level of the small segments that reach it (docs/reference.md).
    /// Returns false if none reaches any.
    SUFFUSE_PROGRAM bool markLevels(int part)
    {
        const bool thin = has(thinFill);
        if (m_stroke.small == 0 && !thin)
            return false;
        m_warp.each([&](int lane) {
            for (int k = 0; k < laneSamples; ++k)
                m_s.level[sampleAt(lane, k)] = 0;
        });
        const bool marked = thin && markThinFill(m_warp, m_frame, m_job, m_stroke, m_s.level);
        if (m_stroke.small == 0)
            return marked;
        const bool any = m_frame.toCanvas.xy == 0 && m_frame.toCanvas.yx == 0 ? markUpright(part) : markTurned(part);
        return marked || any;
    }

    /// A part's pixels are those in `width` columns and rows from (left, top) on, but for the first part, which has
    /// some of all.
    struct Extent {
        int left, top, width;
    };
    static SUFFUSE_PROGRAM Extent extentOf(int part)
    {
        constexpr int half = tileSide / 2;
        if (part == 0)
            return {0, 0, tileSide};
        return {(part - 1) % 2 * half, (part - 1) / 2 * half, half};
    }

    /// Marks pixels in a view that is not turned, where those that a segment reaches are columns and rows. Each lane
    /// finds these of one segment.
    SUFFUSE_PROGRAM bool markUpright(int part)
    {
        const Extent extent = extentOf(part);
        const double margin = m_frame.toCanvas.margin;
        const SmallRecord *small = m_frame.small + m_stroke.firstSmall;
        Var<std::uint32_t> reached, level; // of a segment: its columns, and its rows from bit 16 on
        Var<std::uint32_t> own;            // levels of the lane's pixels, four bits each
        m_warp.each([&](int lane) { own[lane] = 0; });
        for (std::uint32_t base = 0; base < m_stroke.small; base += warpLanes) {
            std::uint32_t hits = m_warp.ballot([&](int lane) {
                reached[lane] = level[lane] = 0;
                if (base + std::uint32_t(lane) >= m_stroke.small)
                    return false;
                const SmallRecord s = small[base + std::uint32_t(lane)];
                double x, y;
                toCanvas(m_frame, m_left + extent.left, m_top + extent.top, x, y);
                if (s.left - margin > x + extent.width * m_frame.toCanvas.xx || s.right + margin < x ||
                    s.top - margin > y + extent.width * m_frame.toCanvas.yy || s.bottom + margin < y)
                    return false;
                std::uint32_t columns = 0, rows = 0;
                SUFFUSE_ROLLED
                for (int i = 0; i < extent.width; ++i) {
                    const int column = extent.left + i, row = extent.top + i;
                    toCanvas(m_frame, m_left + column + 0.5, m_top + row + 0.5, x, y);
                    columns |= std::uint32_t(x >= s.left - margin && x <= s.right + margin) << column;
                    rows |= std::uint32_t(y >= s.top - margin && y <= s.bottom + margin) << row;
                }
                reached[lane] = columns | rows << tileSide, level[lane] = std::uint32_t(s.level);
                return columns != 0 && rows != 0;
            });
            for (; hits; hits &= hits - 1) {
                const std::uint32_t where = m_warp.read(reached, Warp::lowest(hits));
                const std::uint32_t from = m_warp.read(level, Warp::lowest(hits));
                m_warp.each([&](int lane) {
                    SUFFUSE_UNROLL
                    for (int k = 0; k < laneSamples; ++k) {
                        const std::uint32_t before = own[lane] >> 4 * k & 15;
                        const std::uint32_t there =
                            where >> sampleColumn(lane, k) & where >> (tileSide + sampleRow(lane, k)) & 1;
                        own[lane] += there && from > before ? (from - before) << 4 * k : 0;
                    }
                });
            }
        }
        m_warp.each([&](int lane) {
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k) {
                std::uint8_t &kept = m_s.level[sampleAt(lane, k)];
                const auto found = std::uint8_t(own[lane] >> 4 * k & 15);
                kept = kept < found ? found : kept;
            }
        });
        return m_warp.any([&](int lane) { return own[lane] != 0; });
    }

    /// Marks pixels in any view.
    SUFFUSE_PROGRAM bool markTurned(int part)
    {
        const Extent extent = extentOf(part);
        double left = 1e300, top = 1e300, right = -1e300, bottom = -1e300; // the part's box in canvas units
        for (int corner = 0; corner < 4; ++corner) {
            double x, y;
            toCanvas(m_frame, m_left + extent.left + corner % 2 * extent.width,
                     m_top + extent.top + corner / 2 * extent.width, x, y);
            left = x < left ? x : left, right = x > right ? x : right;
            top = y < top ? y : top, bottom = y > bottom ? y : bottom;
        }
        const double margin = m_frame.toCanvas.margin;
        const SmallRecord *small = m_frame.small + m_stroke.firstSmall;
        bool any = false;
        for (std::uint32_t base = 0; base < m_stroke.small; base += warpLanes) {
            std::uint32_t hits = m_warp.ballot([&](int lane) {
                if (base + std::uint32_t(lane) >= m_stroke.small)
                    return false;
                const SmallRecord &s = small[base + std::uint32_t(lane)];
                return s.left - margin <= right && left <= s.right + margin && s.top - margin <= bottom &&
                       top <= s.bottom + margin;
            });
            for (; hits; hits &= hits - 1) {
                const SmallRecord s = small[base + std::uint32_t(Warp::lowest(hits))];
                any |= m_warp.any([&](int lane) {
                    bool marked = false;
                    SUFFUSE_ROLLED
                    for (int k = 0; k < laneSamples; ++k) {
                        double x, y;
                        toCanvas(m_frame, m_left + sampleColumn(lane, k) + 0.5, m_top + sampleRow(lane, k) + 0.5, x, y);
                        std::uint8_t &level = m_s.level[sampleAt(lane, k)];
                        if (level < s.level && x >= s.left - margin && x <= s.right + margin && y >= s.top - margin &&
                            y <= s.bottom + margin)
                            level = std::uint8_t(s.level), marked = true;
                    }
                    return marked;
                });
            }
        }
        m_warp.meet();
        return any;
    }

    SUFFUSE_PROGRAM void evaluateQuadrant(int quadrant)
    {
        constexpr int half = tileSide / 2, levels = 7;
        const int left = quadrant % 2 * half, top = quadrant / 2 * half;
        for (int level = 1; level < levels; ++level) {
            if (!isLevelIn(left, top, half, level))
                continue;
            const int side = tileSide >> (level < 4 ? level : 4);
            for (int j = top; j < top + half; j += side)
                for (int i = left; i < left + half; i += side)
                    evaluateGroup(level, i, j, side);
        }
    }

    /// Tells whether some of side × side pixels from (i, j) on have a level.
    SUFFUSE_PROGRAM bool isLevelIn(int i, int j, int side, int level)
    {
        return m_warp.any([&](int lane) {
            bool there = false;
            for (int p = lane; p < side * side; p += warpLanes)
                there = there || m_s.level[sampleAtPixel(i + p % side, j + p / side)] == level;
            return there;
        });
    }

    /// Evaluates a group of side × side pixels from (i, j) on, by means over 2^level × 2^level points.
    SUFFUSE_PROGRAM void evaluateGroup(int level, int i, int j, int side)
    {
        if (!isLevelIn(i, j, side, level))
            return;
        const float step = 1.0f / float(1 << level);
        const int blocks = level > 4 ? 1 << (level - 4) : 1; // blocks of samples along a side of the group
        float total[4] = {0, 0, 0, 0};                       // w and w·C, used if the group is one pixel
        for (int b = 0; b < blocks * blocks; ++b) {
            constexpr float half = tileSide / 2;
            const Block block{float(i - tileSide / 2) + (float(b % blocks * tileSide) + half) * step,
                              float(j - tileSide / 2) + (float(b / blocks * tileSide) + half) * step, step};
            evaluateBlock(block, level == 1 ? 1 + quadrantOf(i, j) : -1);
            if (side == 1)
                addToTotal(total);
        }
        if (side == 1)
            m_warp.each([&](int lane) {
                if (lane == 0)
                    setMean(i, j, total, step);
            });
        else
            averageGroup(level, i, j, side, step);
    }

    /// Adds w and w·C of all samples of the block to `total`.
    SUFFUSE_PROGRAM void addToTotal(float (&total)[4])
    {
        Var<float> part[4];
        m_warp.each([&](int lane) {
            for (int c = 0; c < 4; ++c)
                part[c][lane] = 0;
            for (int k = 0; k < laneSamples; ++k)
                addSample(painted()[sampleAt(lane, k)], part[0][lane], part[1][lane], part[2][lane], part[3][lane]);
        });
        for (int c = 0; c < 4; ++c)
            total[c] += m_warp.sum(part[c]);
    }
    static SUFFUSE_PROGRAM void addSample(const Float4 &sample, float &w, float &red, float &yellow, float &blue)
    {
        w += sample.x;
        red += sample.x * sample.y, yellow += sample.x * sample.z, blue += sample.x * sample.w;
    }

    SUFFUSE_PROGRAM void setMean(int column, int row, const float (&total)[4], float step)
    {
        const bool shows = total[0] > 0;
        m_s.quadrant[quadrantAt(column, row)] = {total[0] * (step * step), shows ? total[1] / total[0] : 0.0f,
                                                 shows ? total[2] / total[0] : 0.0f,
                                                 shows ? total[3] / total[0] : 0.0f};
    }

    SUFFUSE_PROGRAM void averageGroup(int level, int i, int j, int side, float step)
    {
        m_warp.each([&](int lane) {
            const int samples = 1 << level;
            for (int p = lane; p < side * side; p += warpLanes) {
                const int column = p % side, row = p / side;
                if (m_s.level[sampleAtPixel(i + column, j + row)] != level)
                    continue;
                float total[4] = {0, 0, 0, 0};
                for (int y = row * samples; y < (row + 1) * samples; ++y)
                    for (int x = column * samples; x < (column + 1) * samples; ++x)
                        addSample(painted()[sampleAtPixel(x, y)], total[0], total[1], total[2], total[3]);
                setMean(i + column, j + row, total, step);
            }
        });
    }

    /// Finds w and colour at a block of samples, and leaves them in `painted`. `plane` is that of the block's η
    /// (`etaPlane`).
    SUFFUSE_PROGRAM void evaluateBlock(const Block &block, int plane)
    {
        if (m_stroke.simple)
            evaluateSimple<fills>(m_warp, m_frame, m_job, block, plane, m_paint);
        else
            evaluateAny<fills>(m_warp, m_frame, m_job, block, plane, m_paint);
    }

    Warp &m_warp;
    const Frame &m_frame;
    const StrokeRecord &m_stroke;
    const ApartJob m_job;
    int m_left, m_top;
    PaintScratch &m_paint;
    SumScratch &m_sums;
    GeneralScratch &m_s;
};

} // namespace suffuse::cuda
