// The density of a run on a grid, and how far that of other nodes is from it (render/nodes/span_field, with the same
// sums in the same order). Several warps share this, which is most of the work of merging. One of them, the leader,
// does all the rest, and says what is to be done; the others help.
#pragma once

#include "render/cuda/nodes/node_records.h"
#include "render/cuda/warp.h"

namespace suffuse::cuda {

inline constexpr int fieldWarps = 4;

enum class FieldTask { Tables, Begin, Add, Compare, End };

/// The shared memory of the warps of a field. The leader writes it before it asks for a task.
struct FieldScratch {
    static constexpr int side = spans::Grid::side;
    static constexpr int mostSums = 1 + spans::values; ///< density, and density times each value that varies

    alignas(16) float column[spans::mostNodes][side]; ///< Gaussians of nodes along the axes of the grid
    alignas(16) float row[spans::mostNodes][side];
    float x[spans::mostNodes], y[spans::mostNodes]; ///< where the nodes are, from the grid's first point
    float factor[mostSums][spans::mostNodes];       ///< what each sum has of a node
    float step;
    int columns, rows, count, sums;
    FieldTask task;
    float worst[fieldWarps]; ///< the greatest difference that each warp found
};

/// Does one warp's part of a task. `planes` has planeSize numbers of memory.
template <class Warp>
class FieldPart {
public:
    SUFFUSE_PROGRAM FieldPart(Warp &warp, int own, FieldScratch &scratch, Four *planes)
        : m_warp(warp), m_own(own), m_s(scratch), m_planes(planes)
    {}

    SUFFUSE_PROGRAM void run()
    {
        if (m_s.task == FieldTask::Tables)
            fillTables();
        else if (m_s.task == FieldTask::Compare)
            compare();
        else
            add(m_s.task == FieldTask::Begin);
    }

private:
    static constexpr int lanes = fieldWarps * warpLanes;

    SUFFUSE_PROGRAM void fillTables()
    {
        const int columns = m_s.columns, width = columns + m_s.rows, count = m_s.count;
        const float step = m_s.step;
        m_warp.each([&](int lane) {
            for (int n = 0, i = m_own * warpLanes + lane;; i += lanes) {
                while (i >= width)
                    i -= width, ++n;
                if (n >= count)
                    return;
                if (i < columns)
                    m_s.column[n][i] = spans::gaussian(i, step, m_s.x[n]);
                else
                    m_s.row[n][i - columns] = spans::gaussian(i - columns, step, m_s.y[n]);
            }
        });
    }

    /// Adds the nodes to the planes or, if `first`, makes the planes their sums.
    SUFFUSE_PROGRAM void add(bool first)
    {
        for (int sum = 0; sum < m_s.sums; ++sum)
            forEachFour(sum, [&](int, Four *plane, int y, int x) {
                *plane = with(first ? Four{0, 0, 0, 0} : *plane, sum, y, x);
            });
    }

    SUFFUSE_PROGRAM void compare()
    {
        typename Warp::template Var<float> worst; // It is negative, so that the greatest is the least.
        m_warp.each([&](int lane) { worst[lane] = 0; });
        for (int sum = 0; sum < m_s.sums; ++sum)
            forEachFour(sum, [&](int lane, Four *plane, int y, int x) {
                const Four rest = with(*plane, sum, y, x);
                const auto take = [&](float value) {
                    const float least = -std::fabs(value);
                    worst[lane] = least < worst[lane] ? least : worst[lane];
                };
                take(rest.x), take(rest.y), take(rest.z), take(rest.w);
            });
        const float least = m_warp.least(worst);
        m_warp.each([&](int lane) {
            if (lane == 0)
                m_s.worst[m_own] = -least;
        });
    }

    /// Calls use(lane, place in the plane, row, column) for each four rows of a column.
    template <class Use>
    SUFFUSE_PROGRAM void forEachFour(int sum, Use use)
    {
        const int columns = m_s.columns, rows = m_s.rows;
        Four *plane = m_planes + sum * (planeSize / FieldScratch::mostSums / 4);
        m_warp.each([&](int lane) {
            for (int y = 0, x = m_own * warpLanes + lane;; x += lanes) {
                while (x >= columns)
                    x -= columns, y += 4;
                if (y >= rows)
                    return;
                use(lane, plane + y / 4 * columns + x, y, x);
            }
        });
    }

    /// Returns sums at four rows with all nodes added.
    SUFFUSE_PROGRAM Four with(Four s, int sum, int y, int x) const
    {
        const int count = m_s.count;
        SUFFUSE_UNROLL_BY_4
        for (int n = 0; n < count; ++n) {
            const float c = m_s.column[n][x], f = m_s.factor[sum][n];
            const Four r = Warp::readFour(m_s.row[n] + y);
            s.x = s.x + c * (f * r.x);
            s.y = s.y + c * (f * r.y);
            s.z = s.z + c * (f * r.z);
            s.w = s.w + c * (f * r.w);
        }
        return s;
    }

    Warp &m_warp;
    const int m_own;
    FieldScratch &m_s;
    Four *const m_planes;
};

template <class Warp>
SUFFUSE_CALL void doFieldPart(Warp &warp, int own, FieldScratch &scratch, Four *planes)
{
    FieldPart<Warp>(warp, own, scratch, planes).run();
}

#ifdef __CUDACC__

/// The warps of a block, of which warp 0 leads.
class DeviceFieldCrew {
public:
    using Warp = DeviceWarp;

    SUFFUSE_PROGRAM DeviceFieldCrew(FieldScratch &scratch, Four *planes)
        : m_own(int(threadIdx.x) / warpLanes), m_s(scratch), m_planes(planes)
    {}
    SUFFUSE_PROGRAM Warp &warp() { return m_warp; }
    SUFFUSE_PROGRAM bool leads() const { return threadIdx.x < warpLanes; }
    /// Has a task done by all warps. Only the leader calls it.
    SUFFUSE_PROGRAM void share(FieldTask task)
    {
        m_warp.each([&](int lane) {
            if (lane == 0)
                m_s.task = task;
        });
        __syncthreads();
        if (task == FieldTask::End)
            return;
        doFieldPart(m_warp, m_own, m_s, m_planes);
        __syncthreads();
    }
    /// Does what the leader asks for, until it asks for the end.
    SUFFUSE_PROGRAM void help()
    {
        for (;;) {
            __syncthreads();
            if (m_s.task == FieldTask::End)
                return;
            doFieldPart(m_warp, m_own, m_s, m_planes);
            __syncthreads();
        }
    }

private:
    DeviceWarp m_warp;
    const int m_own;
    FieldScratch &m_s;
    Four *const m_planes;
};

#else

class HostFieldCrew {
public:
    using Warp = HostWarp;

    HostFieldCrew(FieldScratch &scratch, Four *planes) : m_s(scratch), m_planes(planes) {}
    Warp &warp() { return m_warp; }
    void share(FieldTask task)
    {
        m_s.task = task;
        for (int own = 0; own < fieldWarps; ++own)
            doFieldPart(m_warp, own, m_s, m_planes);
    }

private:
    HostWarp m_warp;
    FieldScratch &m_s;
    Four *m_planes;
};

#endif

} // namespace suffuse::cuda
