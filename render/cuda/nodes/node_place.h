// The program that turns segments into Level 0 nodes (docs/solver.md, "Nodes"), and cuts runs that are to be merged
// into windows. A warp takes a few neighbouring segments, one a lane.
#pragma once

#include "render/cuda/nodes/node_records.h"
#include "render/cuda/warp.h"

namespace suffuse::cuda {

/// A segment of more nodes is left to the host.
inline constexpr std::uint32_t mostSegmentNodes = 1024;

/// The shared memory of the program.
struct PlaceScratch {
    panels::Differences differences; ///< of the piece that is sampled
    std::uint32_t from[16], to[16];  ///< windows that are still to be looked at
};

SUFFUSE_CALL int quickNodes(const panels::Curve &metric, double tolerance, const panels::Tables &tables)
{
    return panels::quickNodes(metric, metric, tolerance, [&](const panels::EvenCurve &curve, float logAllowed) {
        float least = 1e30f;
        SUFFUSE_UNROLL_BY_2
        for (int e = 0; e < panels::ellipses; ++e) {
            const float n = panels::evenNodesOn(tables.bounds, e, curve, logAllowed);
            least = n < least ? n : least;
        }
        return least;
    });
}

template <class Warp>
class NodePlacer {
public:
    SUFFUSE_PROGRAM NodePlacer(Warp &warp, const NodeWork &work, std::uint32_t job, PlaceScratch &scratch)
        : m_warp(warp), m_work(work), m_job(work.jobs[job]), m_s(scratch)
    {}

    SUFFUSE_PROGRAM void run()
    {
        const bool fits = count();
        const std::uint32_t room = m_job.merge ? m_work.fineRoom : m_work.plainRoom;
        m_begin = fits ? m_warp.take(m_work.status + (m_job.merge ? fineTaken : plainTaken), m_total) : room;
        if (m_begin > room || m_total > room - m_begin || !fits) {
            m_warp.each([&](int lane) {
                if (lane == 0)
                    m_work.places[m_job.first].nodes = NodePlace::refused;
            });
            return;
        }
        write();
        if (!m_job.merge)
            return;
        measure();
        cut();
    }

private:
    template <class T>
    using Var = typename Warp::template Var<T>;

    /// Where each lane is in its segment.
    struct Cursor {
        panels::Place place;
        std::uint32_t nodes = 0, pieces = 0;
        bool more = false;
    };

    static SUFFUSE_PROGRAM panels::Curve curveOf(const SegmentRecord &s)
    {
        const auto at = [](float x, float y) { return panels::Vector{0.0 + double(x), 0.0 + double(y)}; };
        return {at(s.x[0], s.y[0]), at(s.x[1], s.y[1]), at(s.x[2], s.y[2]), at(s.x[3], s.y[3])};
    }
    /// Returns a piece of a segment in spreads.
    static SUFFUSE_PROGRAM panels::Curve metricOf(const SegmentRecord &s, const panels::Place &place)
    {
        const panels::Curve curve = curveOf(s);
        return panels::scaledFrom(place.piece(curve), curve.a, s.inverse);
    }

    /// Cuts segments into panels, one segment a lane, and counts their nodes. Returns false if one has too many.
    SUFFUSE_PROGRAM bool count()
    {
        bool fits = true;
        for (std::uint32_t base = 0; base < m_job.count; base += warpLanes) {
            Var<Cursor> cursor;
            Var<int> nodes; // of each lane's piece, as quickNodes gives them
            Var<double> radius, allowed;
            m_warp.each([&](int lane) {
                cursor[lane] = {};
                cursor[lane].more = base + std::uint32_t(lane) < m_job.count;
            });
            while (m_warp.any([&](int lane) { return cursor[lane].more; })) {
                m_warp.each([&](int lane) {
                    if (!cursor[lane].more) {
                        nodes[lane] = 0;
                        return;
                    }
                    const SegmentRecord &s = m_work.segments[m_job.first + base + std::uint32_t(lane)];
                    const panels::Curve metric = metricOf(s, cursor[lane].place);
                    const double tolerance = cursor[lane].place.tolerance(s.tolerance);
                    nodes[lane] = quickNodes(metric, tolerance, *m_work.panels);
                    if (nodes[lane] < 0)
                        radius[lane] = panels::analyticRadius(metric), allowed[lane] = panels::allowedOf(tolerance);
                });
                std::uint32_t unsure = m_warp.ballot([&](int lane) { return nodes[lane] < 0; });
                for (; unsure; unsure &= unsure - 1)
                    sample(Warp::lowest(unsure), base, cursor, radius, allowed, nodes);
                m_warp.each([&](int lane) {
                    if (cursor[lane].more)
                        step(m_job.first + base + std::uint32_t(lane), nodes[lane], cursor[lane]);
                });
            }
            fits = fits && !m_warp.any([&](int lane) { return cursor[lane].nodes > mostSegmentNodes; });
            place(base, cursor);
        }
        return fits;
    }

    /// Finds by samples how many nodes the piece of one lane needs. Each lane takes an ellipse.
    SUFFUSE_PROGRAM void sample(int asking, std::uint32_t base, const Var<Cursor> &cursor, const Var<double> &radius,
                                const Var<double> &allowed, Var<int> &nodes)
    {
        const panels::Tables &tables = *m_work.panels;
        Var<double> needed;
        m_warp.each([&](int lane) {
            if (lane != asking)
                return;
            const SegmentRecord &s = m_work.segments[m_job.first + base + std::uint32_t(lane)];
            const panels::Curve metric = metricOf(s, cursor[lane].place);
            m_s.differences = panels::differencesOf(metric, metric);
        });
        const double within = m_warp.read(radius, asking), target = m_warp.read(allowed, asking);
        const std::uint32_t counts = m_warp.ballot([&](int lane) {
            needed[lane] = 1e300;
            if (lane >= panels::ellipses || !panels::isWithin(tables, lane, within, 0))
                return false;
            const panels::Differences differences = m_s.differences;
            float lift = 0, speed = 0;
            SUFFUSE_UNROLL_BY_4
            for (int k = 0; k < panels::ellipsePoints; ++k)
                panels::sampleAt(tables.basis[lane], k, differences, lift, speed);
            needed[lane] = panels::sampledNodesOn(tables, lane, lift, speed, target);
            return panels::isWithin(tables, lane, within, lift);
        });
        const int last = Warp::lowest(~counts); // The first ellipse that does not count.
        m_warp.each([&](int lane) { needed[lane] = lane < last ? needed[lane] : 1e300; });
        const int n = panels::roundedNodes(m_warp.least(needed));
        m_warp.put(nodes, asking, n);
        m_warp.meet();
    }

    /// Takes the number of nodes of a lane's piece, or halves it, and goes on to the next piece.
    SUFFUSE_PROGRAM void step(std::uint32_t segment, int nodes, Cursor &cursor)
    {
        const SegmentRecord &s = m_work.segments[segment];
        if (nodes == 0 && (cursor.place.depth == panels::mostHalvings ||
                           panels::isTiny(metricOf(s, cursor.place), cursor.place.tolerance(s.tolerance))))
            nodes = panels::anyRule;
        if (nodes == 0) {
            cursor.place.halve();
            return;
        }
        if (cursor.pieces < keptPieces)
            m_work.pieces[std::size_t(segment) * keptPieces + cursor.pieces] =
                std::uint16_t(cursor.place.depth << 4 | nodes);
        ++cursor.pieces;
        // Nodes without weight are left out, which is rare.
        forEachNode(s, cursor.place, nodes, [&](double, double, double) { ++cursor.nodes; });
        cursor.more = cursor.place.next() && cursor.nodes <= mostSegmentNodes && cursor.pieces < keptPieces;
        if (cursor.pieces == keptPieces && cursor.place.depth > 0)
            cursor.nodes = mostSegmentNodes + 1;
    }

    /// Calls use(x, y, weight) for each node of a piece, in canvas units.
    template <class Use>
    SUFFUSE_PROGRAM void forEachNode(const SegmentRecord &s, const panels::Place &place, int n, Use use)
    {
        const panels::Curve piece = place.piece(curveOf(s));
        const panels::Tables &tables = *m_work.panels;
        SUFFUSE_ROLLED
        for (int i = 0; i < n; ++i) {
            const double t = tables.x[n][i];
            const double weight = s.gain * tables.weight[n][i] * panels::size(panels::derivativeAt(piece, t));
            if (weight > 0) {
                const panels::Vector p = panels::pointAt(piece, t);
                use(p.x, p.y, weight);
            }
        }
    }

    /// Notes where the nodes of the lanes' segments begin, counted within the job.
    SUFFUSE_PROGRAM void place(std::uint32_t base, const Var<Cursor> &cursor)
    {
        Var<std::uint32_t> upTo;
        m_warp.each([&](int lane) { upTo[lane] = cursor[lane].nodes; });
        m_warp.sumUp(upTo);
        m_warp.each([&](int lane) {
            const std::uint32_t i = base + std::uint32_t(lane), nodes = cursor[lane].nodes;
            if (i < m_job.count)
                m_work.places[m_job.first + i] = {m_total + upTo[lane] - nodes, std::uint16_t(nodes),
                                                  std::uint16_t(cursor[lane].pieces)};
        });
        m_total += m_warp.read(upTo, warpLanes - 1);
    }

    SUFFUSE_PROGRAM void write()
    {
        for (std::uint32_t base = 0; base < m_job.count; base += warpLanes)
            m_warp.each([&](int lane) {
                const std::uint32_t i = base + std::uint32_t(lane);
                if (i < m_job.count)
                    writeSegment(m_job.first + i);
            });
    }

    SUFFUSE_PROGRAM void writeSegment(std::uint32_t segment)
    {
        const SegmentRecord &s = m_work.segments[segment];
        NodePlace &where = m_work.places[segment];
        std::uint32_t at = where.first + m_begin;
        where.first = at;
        const double inverse = s.inverse;
        panels::Place place;
        for (std::uint32_t k = 0; k < where.pieces; ++k) {
            const int piece = m_work.pieces[std::size_t(segment) * keptPieces + k];
            while (place.depth < piece >> 4)
                place.halve();
            forEachNode(s, place, piece & 15, [&](double x, double y, double weight) {
                if (m_job.merge)
                    m_work.fine[at] = {x * inverse, y * inverse, weight, segment, 0};
                else
                    m_work.plain[at] = {x, y, weight};
                ++at;
            });
            place.next();
        }
    }

    /// Finds what lies between each node and the one before it: the distance, and the turning from the step before.
    SUFFUSE_PROGRAM void measure()
    {
        const FineNode *fine = m_work.fine + m_begin;
        for (std::uint32_t base = 0; base < m_total; base += warpLanes)
            m_warp.each([&](int lane) {
                const std::uint32_t i = base + std::uint32_t(lane);
                if (i >= m_total)
                    return;
                double step = 0, turning = 0;
                panels::Vector now{}, before{};
                if (i > 0 && direction(fine, i, step, now))
                    for (std::uint32_t k = i - 1; k > 0; --k) {
                        double length = 0;
                        if (!direction(fine, k, length, before))
                            continue;
                        turning = spans::turning(before, now);
                        break;
                    }
                m_work.length[m_begin + i] = step;
                m_work.turning[m_begin + i] = turning;
            });
    }

    /// Finds the step to node i. Returns false if it is too short to have a direction.
    static SUFFUSE_PROGRAM bool direction(const FineNode *fine, std::uint32_t i, double &step, panels::Vector &along)
    {
        const double dx = fine[i].x - fine[i - 1].x, dy = fine[i].y - fine[i - 1].y;
        step = std::sqrt(dx * dx + dy * dy);
        if (!(step > 1e-9))
            return false;
        along = {dx / step, dy / step};
        return true;
    }

    /// Cuts the run into windows. Cuts halve the number of segments, not the length, so that a segment that becomes
    /// longer moves no cut.
    SUFFUSE_PROGRAM void cut()
    {
        std::uint32_t waiting = 0, from = 0, to = m_job.count;
        for (;;) {
            const std::uint32_t begin = nodesBefore(from), end = nodesBefore(to);
            if (to - from > 1 && begin < end && sizeOf(begin, end) > spans::windowSize) {
                const std::uint32_t middle = from + (to - from) / 2;
                m_warp.each([&](int lane) {
                    if (lane == 0)
                        m_s.from[waiting] = middle, m_s.to[waiting] = to;
                });
                ++waiting, to = middle;
                continue;
            }
            if (begin < end) {
                const std::uint32_t leaf = m_warp.take(m_work.status + leavesTaken);
                m_warp.each([&](int lane) {
                    if (lane == 0)
                        m_work.leaves[leaf] = {begin, end};
                });
            }
            if (waiting == 0)
                return;
            --waiting;
            from = m_s.from[waiting], to = m_s.to[waiting];
            m_warp.meet();
        }
    }

    SUFFUSE_PROGRAM std::uint32_t nodesBefore(std::uint32_t segment) const
    {
        return segment < m_job.count ? m_work.places[m_job.first + segment].first : m_begin + m_total;
    }

    /// Returns the length of a window and its turning. Nothing outside of the window makes a difference.
    SUFFUSE_PROGRAM double sizeOf(std::uint32_t begin, std::uint32_t end)
    {
        double size = 0;
        for (std::uint32_t base = begin; base < end; base += warpLanes) {
            Var<double> length, turning;
            m_warp.each([&](int lane) {
                const std::uint32_t i = base + std::uint32_t(lane);
                length[lane] = i > begin && i < end ? m_work.length[i] : 0;
                turning[lane] = i > begin + 1 && i < end ? m_work.turning[i] : 0;
            });
            SUFFUSE_UNROLL_BY_4
            for (int j = 0; j < warpLanes; ++j)
                size = size + m_warp.read(length, j) + m_warp.read(turning, j);
        }
        return size;
    }

    Warp &m_warp;
    const NodeWork &m_work;
    const NodeJob m_job;
    PlaceScratch &m_s;
    std::uint32_t m_total = 0, m_begin = 0;
};

} // namespace suffuse::cuda
