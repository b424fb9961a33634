// One warp evaluates a stroke of any kind at one tile here: granulated, of several styles or colours, anisotropic, too
// wide on screen for floats, or too narrow for single samples.
#pragma once

#include "render/cuda/tiles/tile_crisp.h"
#include "render/cuda/tiles/tile_deep.h"
#include "render/cuda/tiles/tile_paper.h"
#include "render/cuda/tiles/tile_shade.h"
#include "render/cuda/tiles/tile_stream.h"
#include "render/math/picture.h"

namespace suffuse::cuda {

/// A warp has this in shared memory. Samples lie as `sampleAt` says, so that no two lanes need the same bank at once
/// (warp.h).
struct GeneralScratch {
    float sums[fixedSums + maxChannels][tileSize];
    float paint[4][tileSize];  ///< w and colour at a block of samples
    float result[4][tileSize]; ///< w and colour at the tile's pixels
    std::uint8_t level[tileSize];
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

/// If `fills`, the stroke may have a fill.
template <class Warp, bool fills>
class GeneralStroke {
public:
    template <class T>
    using Var = typename Warp::template Var<T>;

    /// `fetched` has two places.
    SUFFUSE_PROGRAM GeneralStroke(Warp &warp, const Frame &frame, const ApartJob &job, const StrokeRecord &stroke,
                                  Fetched *fetched, SumScratch &sums, GeneralScratch &scratch)
        : m_warp(warp), m_frame(frame), m_stroke(stroke), m_column(job.column), m_row(job.row),
          m_left(job.column * tileSide), m_top(job.row * tileSide),
          m_nodes(warp, frame, job, fetched, sums), m_cover{sums.means.density, sums.means.h2}, m_sums(sums),
          m_s(scratch)
    {}

    static constexpr int allParts = -1;

    /// Leaves what the stroke shows at the tile's pixels in the scratch's `result`: at those of one part of the job
    /// (`partOf`), or at all.
    SUFFUSE_PROGRAM void evaluateTile(int part)
    {
        const bool small = markLevels(part);
        const int levels = small ? 7 : 1;
        for (int level = part > 0 ? 1 : 0; level < (part == 0 ? 1 : levels); ++level) {
            if (small && !m_warp.any([&](int lane) {
                    bool there = false;
                    for (int k = 0; k < laneSamples; ++k)
                        there = there || m_s.level[sampleAt(lane, k)] == level;
                    return there;
                }))
                continue;
            const int side = level == 0 ? 1 : tileSide >> (level < 4 ? level : 4);
            const int groups = level == 0 ? 1 : tileSide / side;
            for (int group = 0; group < groups * groups; ++group) {
                const int i = group % groups * side, j = group / groups * side;
                if (part <= 0 || 1 + quadrantOf(i, j) == part)
                    evaluateGroup(level, i, j, side);
            }
        }
        if (m_stroke.picture)
            showPicture(part);
    }

private:
    /// Tells whether the stroke has a fill of this kind.
    SUFFUSE_PROGRAM bool has(FillFlag flag) const { return fills && (m_stroke.fill & flag) != 0; }
    SUFFUSE_PROGRAM const FillValues &fillValues() const { return m_frame.fills[m_stroke.fillValues]; }
    SUFFUSE_PROGRAM bool hasPaper() const { return m_stroke.granulated && m_frame.paper.kind != 0; }

    /// Puts the stroke's picture in the place of its colours, at the pixels of a part.
    SUFFUSE_PROGRAM void showPicture(int part)
    {
        const PictureView &picture = m_frame.pictures[m_stroke.picture - 1];
        m_warp.each([&](int lane) {
            SUFFUSE_ROLLED
            for (int k = 0; k < laneSamples; ++k) {
                const int at = sampleAt(lane, k);
                if (part != allParts && partOf(m_stroke, m_s.level[at], lane, k) != part)
                    continue;
                const math::PicturePaint paint = math::shown(picture, m_left + sampleColumn(lane, k) + 0.5,
                                                             m_top + sampleRow(lane, k) + 0.5, m_s.result[0][at]);
                m_s.result[0][at] = paint.w;
                m_s.result[1][at] = paint.red, m_s.result[2][at] = paint.yellow, m_s.result[3][at] = paint.blue;
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
        const bool marked = thin && markThinFill(m_warp, m_frame, m_nodes.job(), m_stroke, m_s.level);
        if (m_stroke.small == 0)
            return marked;
        double left = 1e300, top = 1e300, right = -1e300, bottom = -1e300; // the tile's box in canvas units
        const int width = part > 0 ? tileSide / 2 : tileSide;              // Of the other quadrants no level is needed.
        const int i = part > 0 ? (part - 1) % 2 * width : 0, j = part > 0 ? (part - 1) / 2 * width : 0;
        for (int corner = 0; corner < 4; ++corner) {
            double x, y;
            toCanvas(m_frame, m_left + i + corner % 2 * width, m_top + j + corner / 2 * width, x, y);
            left = x < left ? x : left, right = x > right ? x : right;
            top = y < top ? y : top, bottom = y > bottom ? y : bottom;
        }
        struct Centres {
            double x[laneSamples], y[laneSamples];
        };
        Var<Centres> centre; // of the pixels, in canvas units
        m_warp.each([&](int lane) {
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k)
                toCanvas(m_frame, m_left + sampleColumn(lane, k) + 0.5, m_top + sampleRow(lane, k) + 0.5,
                         centre[lane].x[k], centre[lane].y[k]);
        });
        const double margin = m_frame.toCanvas.margin;
        const SmallRecord *small = m_frame.small + m_stroke.firstSmall;
        bool any = marked;
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
                    SUFFUSE_UNROLL
                    for (int k = 0; k < laneSamples; ++k) {
                        const double x = centre[lane].x[k], y = centre[lane].y[k];
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

    /// Evaluates a group of side × side pixels from (i, j) on, by means over 2^level × 2^level points. For level 0 the
    /// group is the whole tile, evaluated at the centres of its pixels.
    SUFFUSE_PROGRAM void evaluateGroup(int level, int i, int j, int side)
    {
        if (level > 0 && !m_warp.any([&](int lane) {
                bool there = false;
                for (int p = lane; p < side * side; p += warpLanes)
                    there = there || m_s.level[sampleAtPixel(i + p % side, j + p / side)] == level;
                return there;
            }))
            return;
        const float step = 1.0f / float(1 << level);
        const int blocks = level > 4 ? 1 << (level - 4) : 1; // blocks of samples along a side of the group
        float total[4] = {0, 0, 0, 0};                       // w and w·C, used if the group is one pixel
        for (int b = 0; b < blocks * blocks; ++b) {
            Block block;
            if (level > 0) {
                constexpr float half = tileSide / 2;
                block.x = float(i - tileSide / 2) + (float(b % blocks * tileSide) + half) * step;
                block.y = float(j - tileSide / 2) + (float(b / blocks * tileSide) + half) * step;
                block.step = step;
            }
            evaluateBlock(block, level == 0 ? 0 : level == 1 ? 1 + quadrantOf(i, j) : -1);
            if (side == 1 && level > 0)
                addToTotal(total);
        }
        if (level == 0)
            m_warp.each([&](int lane) {
                for (int k = 0; k < laneSamples; ++k)
                    for (int c = 0; c < 4; ++c)
                        m_s.result[c][sampleAt(lane, k)] = m_s.paint[c][sampleAt(lane, k)];
            });
        else if (side == 1)
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
        for (int c = 0; c < 4; ++c) {
            Var<float> part;
            m_warp.each([&](int lane) {
                part[lane] = 0;
                for (int k = 0; k < laneSamples; ++k) {
                    const float w = m_s.paint[0][sampleAt(lane, k)];
                    part[lane] += c == 0 ? w : w * m_s.paint[c][sampleAt(lane, k)];
                }
            });
            total[c] += m_warp.sum(part);
        }
    }

    SUFFUSE_PROGRAM void setMean(int column, int row, const float (&total)[4], float step)
    {
        const int at = sampleAtPixel(column, row);
        m_s.result[0][at] = total[0] * (step * step);
        for (int c = 1; c < 4; ++c)
            m_s.result[c][at] = total[0] > 0 ? total[c] / total[0] : 0.0f;
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
                    for (int x = column * samples; x < (column + 1) * samples; ++x) {
                        const int at = sampleAtPixel(x, y);
                        const float w = m_s.paint[0][at];
                        total[0] += w;
                        for (int c = 1; c < 4; ++c)
                            total[c] += w * m_s.paint[c][at];
                    }
                setMean(i + column, j + row, total, step);
            }
        });
    }

    /// Finds opacity and colour at a block of samples, and leaves them in the scratch's `paint`. `plane` is that of the
    /// block's η (`etaPlane`).
    SUFFUSE_PROGRAM void evaluateBlock(const Block &block, int plane)
    {
        m_warp.each([&](int lane) {
            for (int k = 0; k < laneSamples; ++k)
                for (int c = 0; c < fixedSums + int(m_stroke.channels); ++c)
                    m_s.sums[c][sampleAt(lane, k)] = 0;
        });
        if constexpr (fills) {
            sumWithFill(block);
        } else {
            m_nodes.forEachListing(block, [&](const Listing &listing) { addNodes(listing, block); });
        }
        if (hasPaper())
            findEta(m_warp, m_frame, m_column, m_row, block, plane, m_s.paint[0]);
        if (m_stroke.deep || has(deepFill)) {
            const double x = double(m_left + tileSide / 2) + double(block.x);
            const double y = double(m_top + tileSide / 2) + double(block.y);
            sumDeep(m_warp, m_frame, m_stroke, x, y, m_sums.deep);
            if (has(deepFill))
                addDeepFill(m_warp, m_frame, m_stroke, x, y, m_sums.deep);
            shade<double>(block);
        } else {
            shade<float>(block);
        }
    }

    SUFFUSE_PROGRAM void addNodes(const Listing &listing, const Block &block)
    {
        addSeparable(listing, block);
        for (int n = wholeStrides(listing.separable); n < listing.count; ++n)
            addOblique(n, block);
    }

    SUFFUSE_PROGRAM void sumWithFill(const Block &block)
    {
        const bool crisp = has(crispFill);
        m_isFillOpen = has(haveFill) && !crisp && !has(deepFill), m_base = 0;
        if (crisp)
            clearCover(m_warp, m_cover);
        m_nodes.forEachListing(
            block,
            [&](const Listing &listing) {
                if (m_isFillOpen)
                    addFill(listing, block);
                addNodes(listing, block);
            },
            [&](const Fetched &chunk, int records, Listing &listing) {
                if (crisp)
                    m_base += addCover(m_warp, m_cover, chunk, records, fillValues(), m_column, m_row, block);
                else if (m_isFillOpen)
                    listFill(m_warp, chunk, records, fillValues(), m_column, m_row, block, m_sums, listing);
            });
        if (m_isFillOpen)
            finishFill(block);
    }

    SUFFUSE_PROGRAM const float *values() const { return m_frame.values + m_stroke.firstValue; }

    /// Adds the listed part of a fill of density 1, and ends it where nodes follow.
    SUFFUSE_PROGRAM void addFill(const Listing &listing, const Block &block)
    {
        m_base += listing.base;
        if (listing.fill > 0 && fillValues().b != 0) {
            addObliqueFill(m_warp, listing.fill, fillValues(), block, m_sums, m_s.sums);
        } else if (listing.fill > 0) {
            Var<SampleSums> sums;
            m_warp.each([&](int lane) {
                for (int k = 0; k < laneSamples; ++k) {
                    sums[lane].density[k] = m_s.sums[0][sampleAt(lane, k)];
                    sums[lane].slopeX[k] = m_s.sums[1][sampleAt(lane, k)];
                    sums[lane].slopeY[k] = m_s.sums[2][sampleAt(lane, k)];
                }
            });
            addFillEntries(m_warp, listing, block, m_sums, sums);
            m_warp.each([&](int lane) {
                for (int k = 0; k < laneSamples; ++k) {
                    m_s.sums[0][sampleAt(lane, k)] = sums[lane].density[k];
                    m_s.sums[1][sampleAt(lane, k)] = sums[lane].slopeX[k];
                    m_s.sums[2][sampleAt(lane, k)] = sums[lane].slopeY[k];
                }
            });
        }
        if (listing.count > wholeStrides(listing.fill))
            finishFill(block);
    }

    SUFFUSE_PROGRAM FillPlace fillPlace() const
    {
        if (!has(gradientFill))
            return {};
        return {fillValues(), double(m_left + tileSide / 2), double(m_top + tileSide / 2)};
    }

    /// Makes sums of a fill of density 1 those of the stroke's fill, with its channels.
    SUFFUSE_PROGRAM void finishFill(const Block &block)
    {
        m_isFillOpen = false;
        const FillValues &values = fillValues();
        const FillPlace place = fillPlace();
        const float full = m_stroke.fillDensity, base = float(m_base);
        m_warp.each([&](int lane) {
            for (int k = 0; k < laneSamples; ++k) {
                const int at = sampleAt(lane, k);
                const float inside = math::min_(math::max_(m_s.sums[0][at] + base, 0.0f), 1.0f);
                float t = 0;
                if (has(gradientFill))
                    t = place.at(sampleX(lane, k, block), sampleY(lane, k, block), inside, m_s.sums[1][at],
                                 m_s.sums[2][at]);
                m_s.sums[0][at] = full * inside;
                m_s.sums[1][at] *= full, m_s.sums[2][at] *= full;
                for (int c = 0; c < int(m_stroke.channels); ++c)
                    m_s.sums[fixedSums + c][at] = full * inside * math::mulAdd_(t, values.step[c], values.from[c]);
            }
        });
    }

    SUFFUSE_PROGRAM float coveredAt(int at) const { return coveredShare(m_cover.covered[at] + float(m_base)); }

    static SUFFUSE_PROGRAM float sampleX(int lane, int k, const Block &block)
    {
        return math::mulAdd_(float(sampleColumn(lane, k)) - 7.5f, block.step, block.x);
    }
    static SUFFUSE_PROGRAM float sampleY(int lane, int k, const Block &block)
    {
        return math::mulAdd_(float(sampleRow(lane, k)) - 7.5f, block.step, block.y);
    }

    SUFFUSE_PROGRAM void addSeparable(const Listing &listing, const Block &block)
    {
        for (int from = wholeStrides(listing.fill); from < listing.separable; from += batch) {
            const int to = from + batch < listing.separable ? from + batch : listing.separable;
            fillTables(m_warp, from, to, block, m_sums);
            Var<SampleSums> sums;
            m_warp.each([&](int lane) {
                SUFFUSE_UNROLL
                for (int k = 0; k < laneSamples; ++k) {
                    sums[lane].density[k] = m_s.sums[0][sampleAt(lane, k)];
                    sums[lane].slopeX[k] = m_s.sums[1][sampleAt(lane, k)];
                    sums[lane].slopeY[k] = m_s.sums[2][sampleAt(lane, k)];
                }
            });
            addBatch(m_warp, to - from, m_sums, sums);
            m_warp.each([&](int lane) {
                SUFFUSE_UNROLL
                for (int k = 0; k < laneSamples; ++k) {
                    m_s.sums[0][sampleAt(lane, k)] = sums[lane].density[k];
                    m_s.sums[1][sampleAt(lane, k)] = sums[lane].slopeX[k];
                    m_s.sums[2][sampleAt(lane, k)] = sums[lane].slopeY[k];
                }
            });
            for (std::uint32_t c = 0; c < m_stroke.channels; ++c) {
                Var<SampleValues> sum;
                float *plane = m_s.sums[fixedSums + c];
                m_warp.each([&](int lane) {
                    SUFFUSE_UNROLL
                    for (int k = 0; k < laneSamples; ++k)
                        sum[lane].v[k] = plane[sampleAt(lane, k)];
                });
                addChannel(m_warp, from, to - from, values(), m_stroke.channels, c, m_sums, sum);
                m_warp.each([&](int lane) {
                    SUFFUSE_UNROLL
                    for (int k = 0; k < laneSamples; ++k)
                        plane[sampleAt(lane, k)] = sum[lane].v[k];
                });
            }
        }
    }

    /// Adds a node whose axes lie askew, so that it is no product of two tables.
    SUFFUSE_PROGRAM void addOblique(int n, const Block &block)
    {
        const ListedNode node = m_sums.listed[n];
        const float a = node.first.z, b = node.first.w, c = node.second.x, cut = node.second.y, weight = node.second.z;
        const float *value = values() + std::size_t(m_sums.rows[n]) * m_stroke.channels;
        m_warp.each([&](int lane) {
            for (int k = 0; k < laneSamples; ++k) {
                const float x = math::mulAdd_(float(sampleColumn(lane, k)) - 7.5f, block.step, block.x) - node.first.x;
                const float y = math::mulAdd_(float(sampleRow(lane, k)) - 7.5f, block.step, block.y) - node.first.y;
                const float ax = a * x + b * y, cy = b * x + c * y;
                const float e = math::exp2_(-float(math::log2e) * (x * ax + y * cy));
                if (!(cut < e))
                    continue;
                const int at = sampleAt(lane, k);
                const float density = (e - cut) * weight, slope = weight * e * (1 / slopeUnit);
                m_s.sums[0][at] += density;
                m_s.sums[1][at] += slope * ax;
                m_s.sums[2][at] += slope * cy;
                for (std::uint32_t i = 0; i < m_stroke.channels; ++i)
                    m_s.sums[fixedSums + i][at] += density * value[i];
            }
        });
    }

    /// Turns sums into opacity and colour, in double if the stroke is so wide that floats would lose its edge.
    template <class V>
    SUFFUSE_PROGRAM void shade(const Block &block)
    {
        const ShadeParams &params = m_stroke.shade;
        const bool crisp = has(crispFill);
        const FillValues *values = crisp ? &fillValues() : nullptr;
        const FillPlace place = crisp ? fillPlace() : FillPlace();
        m_warp.each([&](int lane) {
            for (int k = 0; k < laneSamples; ++k) {
                const int at = sampleAt(lane, k), column = sampleColumn(lane, k), row = sampleRow(lane, k);
                const double x = (double(column) - 7.5) * double(block.step),
                             y = (double(row) - 7.5) * double(block.step);
                DeepSample deep;
                if (sizeof(V) == sizeof(double))
                    deep = deepSample(m_sums.deep[0], x, y);
                V eta(1);
                if (hasPaper())
                    eta = V(m_s.paint[0][at]);
                const V slopeX = V(m_s.sums[1][at]) * V(slopeUnit) + V(deep.slopeX);
                const V slopeY = V(m_s.sums[2][at]) * V(slopeUnit) + V(deep.slopeY);
                // A crisp fill adds `more` where it covers the sample.
                const auto shaded = [&](float more, float t) {
                    const auto channel = [&](int c) {
                        V sum = V(m_s.sums[fixedSums + c][at]);
                        if (sizeof(V) == sizeof(double))
                            sum += V(deepValue(m_sums.deep[1 + c], x, y));
                        if (fills && more > 0)
                            sum += V(more * math::mulAdd_(t, values->step[c], values->from[c]));
                        return sum;
                    };
                    const auto m = math::modulate(params, V(m_s.sums[0][at]) + V(deep.density) + V(more), slopeX,
                                                  slopeY, channel, eta, V(block.step));
                    const V f = meanAt(params, channel, m);
                    const auto paint = math::paintOf(params, m.inverse, channel, f);
                    return Float4{float(paint.w), float(paint.red), float(paint.yellow), float(paint.blue)};
                };
                Float4 mixed = {0, 0, 0, 0};
                if constexpr (fills) {
                    // What it covers and what it leaves are shaded each by itself, but for a sample that is wholly
                    // covered, or not at all. Only one place shades, since its code is long.
                    const float covered = crisp ? coveredAt(at) : 0.0f;
                    SUFFUSE_ROLLED
                    for (int inside = covered < 1 ? 0 : 1; inside <= (covered > 0 ? 1 : 0); ++inside) {
                        float t = 0;
                        if (inside && has(gradientFill))
                            t = place.at(sampleX(lane, k, block), sampleY(lane, k, block), 1, 0, 0);
                        const Float4 own = shaded(inside ? m_stroke.fillDensity : 0.0f, t);
                        mixed = inside && covered < 1 ? shared(mixed, own, covered) : own;
                    }
                } else {
                    mixed = shaded(0, 0);
                }
                m_s.paint[0][at] = mixed.x;
                m_s.paint[1][at] = mixed.y;
                m_s.paint[2][at] = mixed.z;
                m_s.paint[3][at] = mixed.w;
            }
        });
    }

    /// Returns what a sample shows of which a share is covered, from w and colour where it is not and where it is.
    static SUFFUSE_PROGRAM Float4 shared(const Float4 &out, const Float4 &in, float covered)
    {
        const float inside = covered * in.x, left = (1 - covered) * out.x, w = inside + left;
        const float inverse = w > 0 ? 1 / w : 0.0f;
        return {w, (inside * in.y + left * out.y) * inverse, (inside * in.z + left * out.z) * inverse,
                (inside * in.w + left * out.w) * inverse};
    }

    template <class Channel>
    SUFFUSE_PROGRAM double meanAt(const ShadeParams &params, Channel channel, const math::Modulated<double> &m)
    {
        return math::mixedStyles<double>(params, channel, m);
    }
    template <class Channel>
    SUFFUSE_PROGRAM float meanAt(const ShadeParams &params, Channel channel, const math::Modulated<float> &m)
    {
        if (!math::hasOneStyle(params))
            return math::mixedStyles<float>(params, channel, m);
        float f = 0;
        withMadeStyle(m_stroke, 0, [&](const auto &style) { f = math::meanWhere(style, m.phi, m.h2, m.lifted); });
        return f;
    }

    Warp &m_warp;
    const Frame &m_frame;
    const StrokeRecord &m_stroke;
    int m_column, m_row;
    int m_left, m_top;
    NodeStream<Warp, fills> m_nodes;
    const FillCover m_cover;   ///< in shared memory that only plain strokes need
    int m_base = 0;            ///< how often the fill is entered left of what is summed
    bool m_isFillOpen = false; ///< whether the sums are those of a fill so far
    SumScratch &m_sums;
    GeneralScratch &m_s;
};

} // namespace suffuse::cuda
