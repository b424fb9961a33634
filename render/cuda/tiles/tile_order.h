// These programs of a warp put tiles in order: heavy ones are painted first, so that no long one is begun last. Every
// tile has a class by its weight. Who finds a weight puts the tile into its class, and the warps that paint count
// through the classes. Which of two tiles of a class comes first may differ from call to call, but pixels do not depend
// on it.
#pragma once

#include "render/cuda/tiles/tile_nodes.h"

namespace suffuse::cuda {

/// Returns the class of a weight. There are sixteen classes for each octave, heavy ones first.
SUFFUSE_PROGRAM int weightClassOf(std::uint32_t weight)
{
    constexpr float perOctave = 16, lightest = 7, last = weightClasses - 1; // Weights up to 2⁷ are one class.
    const float above = (math::log2_(float(weight + 1)) - lightest) * perOctave;
    return int(last - math::min_(math::max_(above, 0.0f), last));
}

/// Puts a tile job behind those that are in its class already.
template <class Warp>
SUFFUSE_PROGRAM void putInOrder(const Frame &frame, std::uint32_t job, std::uint32_t weight)
{
    const int own = weightClassOf(weight);
    frame.order[std::size_t(own) * frame.tileCount + Warp::add(frame.classCounts + own, 1)] = std::uint16_t(job);
}

/// A warp that goes through tiles in order has this in shared memory.
struct OrderScratch {
    std::uint16_t ends[weightClasses]; ///< how many tiles there are up to the end of each class
};

/// Gives tiles in order, once all of them are in their classes.
template <class Warp>
class TileOrder {
public:
    template <class T>
    using Var = typename Warp::template Var<T>;

    SUFFUSE_PROGRAM TileOrder(Warp &warp, const Frame &frame, OrderScratch &scratch)
        : m_warp(warp), m_frame(frame), m_s(scratch)
    {
        if (!frame.ordered)
            return;
        Var<std::uint32_t> end;
        m_warp.each([&](int lane) {
            std::uint32_t sum = 0;
            SUFFUSE_UNROLL
            for (int k = 0; k < classes; ++k)
                sum += frame.classCounts[lane * classes + k];
            end[lane] = sum;
        });
        m_warp.sumUp(end);
        m_warp.each([&](int lane) {
            std::uint32_t sum = end[lane];
            SUFFUSE_UNROLL
            for (int k = classes - 1; k >= 0; --k) {
                m_s.ends[lane * classes + k] = std::uint16_t(sum);
                sum -= frame.classCounts[lane * classes + k];
            }
        });
    }

    /// Returns the job of the i-th tile.
    SUFFUSE_PROGRAM std::uint32_t job(std::uint32_t i)
    {
        if (!m_frame.ordered)
            return i;
        const std::uint32_t beyond =
            m_warp.ballot([&](int lane) { return i < m_s.ends[lane * classes + classes - 1]; });
        int own = Warp::lowest(beyond) * classes;
        SUFFUSE_UNROLL
        for (int k = 1; k < classes; ++k)
            own += m_s.ends[own] <= i;
        const std::uint32_t before = own == 0 ? 0 : m_s.ends[own - 1];
        return m_frame.order[std::size_t(own) * m_frame.tileCount + (i - before)];
    }

private:
    static constexpr int classes = weightClasses / warpLanes; ///< how many classes a lane counts

    Warp &m_warp;
    const Frame &m_frame;
    OrderScratch &m_s;
};

} // namespace suffuse::cuda
