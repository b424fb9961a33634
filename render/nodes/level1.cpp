#include "render/nodes/level1.h"

#include "render/nodes/span_field.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace suffuse {

namespace {

constexpr double share = 0.5;    // the part of the tolerance that merging may use
constexpr double windowSize = 8; // the largest window: length in spreads plus turning in radians
constexpr int fewest = 3;        // the least number of fine nodes that is worth merging

double distance(const SpanNode &a, const SpanNode &b)
{
    const double dx = b.x - a.x, dy = b.y - a.y;
    return std::sqrt(dx * dx + dy * dy);
}

/// Measures a run of nodes up to each of them: its length (`arc`), and its length plus its turning (`size`).
struct Course {
    std::vector<double> arc;
    std::vector<double> size;

    void follow(const SpanNode *nodes, std::size_t count)
    {
        arc.assign(count, 0);
        size.assign(count, 0);
        double beforeX = 0, beforeY = 0; // the direction of the last step
        for (std::size_t i = 1; i < count; ++i) {
            const double step = distance(nodes[i - 1], nodes[i]);
            arc[i] = arc[i - 1] + step;
            size[i] = size[i - 1] + step;
            if (!(step > 1e-9))
                continue;
            const double x = (nodes[i].x - nodes[i - 1].x) / step, y = (nodes[i].y - nodes[i - 1].y) / step;
            if (beforeX != 0 || beforeY != 0)
                size[i] += std::sqrt((x - beforeX) * (x - beforeX) + (y - beforeY) * (y - beforeY));
            beforeX = x;
            beforeY = y;
        }
    }
};

class Merger {
public:
    /// `segments` says where each segment begins in `fine`.
    Merger(const std::vector<SpanNode> &fine, std::span<const std::size_t> segments, MergedSpan &out)
        : m_fine(fine), m_segments(segments), m_out(out)
    {}

    /// Merges segments [from, to). What becomes of a window depends on no others, to the bit. A segment that becomes
    /// longer moves no cut, since cuts halve the number of segments, not the length.
    void cut(std::size_t from, std::size_t to)
    {
        const std::size_t begin = m_segments[from], end = to < m_segments.size() ? m_segments[to] : m_fine.size();
        if (begin == end)
            return;
        m_course.follow(&m_fine[begin], end - begin);
        if (m_course.size.back() > windowSize && to - from > 1) {
            const std::size_t middle = from + (to - from) / 2;
            cut(from, middle);
            cut(middle, to);
            return;
        }
        m_first = begin;
        m_excess = 0;
        merge(begin, end);
    }

private:
    /// Merges fine nodes [begin, end) of the window, or its halves if no rule will do.
    void merge(std::size_t begin, std::size_t end)
    {
        const int count = int(end - begin);
        if (count < fewest)
            return keep(&m_fine[begin], count, begin, end);
        if (count <= SpanRule::maxFine)
            if (const int n = fewestNodes(begin, count))
                return keep(m_best, n, begin, end);
        if (count <= SpanRule::maxNodes / 2)
            return keep(&m_fine[begin], count, begin, end);
        const std::size_t middle = begin + std::size_t(count / 2);
        merge(begin, middle);
        merge(middle, end);
    }

    void keep(const SpanNode *nodes, int count, std::size_t begin, std::size_t end)
    {
        const std::size_t first = m_out.nodes.size();
        m_out.nodes.insert(m_out.nodes.end(), nodes, nodes + count);
        m_out.windows.push_back({begin, end, first, m_out.nodes.size()});
    }

    /// Returns how many nodes a window usually takes.
    double usual(std::size_t begin, int count, double mass, double tolerance) const
    {
        const std::size_t first = begin - m_first, last = first + std::size_t(count) - 1;
        const double size = m_course.size[last] - m_course.size[first], arc = m_course.arc[last] - m_course.arc[first];
        return 1.1 * size + 0.5 * std::log(mass / (tolerance * (arc + 1))) - 1.5;
    }

    /// Leaves the nodes in m_best and returns how many there are. 0 means that no rule of up to maxNodes nodes will do.
    int fewestNodes(std::size_t begin, int count)
    {
        const SpanNode *fine = &m_fine[begin];
        double tolerance = fine[0].tolerance, mass = 0;
        bool vary = false;
        for (int i = 0; i < count; ++i) {
            mass += fine[i].weight;
            tolerance = std::min(tolerance, fine[i].tolerance);
            vary |= fine[i].values != fine[0].values;
        }
        const double expected = usual(begin, count, mass, tolerance);
        const int most = std::min(SpanRule::maxNodes, count - 1);
        m_rule.start(fine, &m_course.arc[begin - m_first], count, vary);
        m_field.start(fine, count, vary);
        int n = std::clamp(int(std::lround(expected + m_excess)), 1, most), best = 0, failed = 0;
        for (;;) {
            SpanNode nodes[SpanRule::maxNodes];
            if (!m_rule.nodes(n, nodes))
                break;
            const double error = double(m_field.difference(nodes, n)) / (share * tolerance);
            if (error <= 1) {
                best = n;
                std::copy_n(nodes, n, m_best);
                if (n - 1 == failed || error > 0.3) // One node less would seldom pass.
                    break;
                --n;
            } else {
                // Another node makes the error two or three times smaller.
                const int missing = std::max(1, int(std::log(error)));
                failed = n;
                if (best || n == most || n + missing > most + 1)
                    break;
                n = std::min(most, n + std::min(missing, 3));
            }
        }
        if (best)
            m_excess = 0.4 * (best - expected);
        return best;
    }

    const std::vector<SpanNode> &m_fine;
    const std::span<const std::size_t> m_segments;
    MergedSpan &m_out;
    Course m_course;         // that of the window
    std::size_t m_first = 0; // the fine node at which the window begins
    SpanRule m_rule;
    SpanField m_field;
    SpanNode m_best[SpanRule::maxNodes];
    double m_excess = 0; // how many more nodes than usual the last part of the window makes this one expect
};

} // namespace

MergedSpan mergeSpan(const std::vector<SpanNode> &fine, std::span<const std::size_t> segments)
{
    MergedSpan out;
    // A merger is too large for the stack.
    std::make_unique<Merger>(fine, segments, out)->cut(0, segments.size());
    return out;
}

} // namespace suffuse
