#include "render/nodes/level1.h"

#include "render/nodes/span_field.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace suffuse {

namespace {

/// What lies between each node of a run and the one before it: the distance in spreads, and 1.5 times the turning from
/// the step before, in radians.
struct Steps {
    std::vector<double> length;
    std::vector<double> turning;

    void measure(std::span<const SpanNode> nodes)
    {
        length.assign(nodes.size(), 0);
        turning.assign(nodes.size(), 0);
        double beforeX = 0, beforeY = 0; // the direction of the last step
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            const double dx = nodes[i].x - nodes[i - 1].x, dy = nodes[i].y - nodes[i - 1].y;
            const double step = std::sqrt(dx * dx + dy * dy);
            length[i] = step;
            if (!(step > 1e-9))
                continue;
            const double x = dx / step, y = dy / step;
            if (beforeX != 0 || beforeY != 0)
                turning[i] = spans::turning({beforeX, beforeY}, {x, y});
            beforeX = x;
            beforeY = y;
        }
    }
};

/// Measures a window up to each of its nodes: its length (`arc`), and its length plus its turning (`size`), which
/// decides how many nodes it needs. Nothing outside of the window makes a difference.
struct Course {
    std::vector<double> arc;
    std::vector<double> size;

    void follow(const Steps &steps, std::size_t begin, std::size_t end)
    {
        arc.assign(end - begin, 0);
        size.assign(end - begin, 0);
        for (std::size_t i = 1; i < end - begin; ++i) {
            const double length = steps.length[begin + i];
            arc[i] = arc[i - 1] + length;
            size[i] = size[i - 1] + length + (i > 1 ? steps.turning[begin + i] : 0);
        }
    }
};

class Merger {
public:
    /// Merges the whole run. `segments` says where each segment begins in `fine`.
    void merge(std::span<const SpanNode> fine, std::span<const std::size_t> segments, MergedSpan &out)
    {
        m_fine = fine;
        m_segments = segments;
        m_out = &out;
        m_steps.measure(fine);
        cut(0, segments.size());
    }

private:
    /// Merges segments [from, to). What becomes of a window depends on no others, to the bit. A segment that becomes
    /// longer moves no cut, since cuts halve the number of segments, not the length.
    void cut(std::size_t from, std::size_t to)
    {
        const std::size_t begin = m_segments[from], end = to < m_segments.size() ? m_segments[to] : m_fine.size();
        if (begin == end)
            return;
        m_course.follow(m_steps, begin, end);
        if (m_course.size.back() > spans::windowSize && to - from > 1) {
            const std::size_t middle = from + (to - from) / 2;
            cut(from, middle);
            cut(middle, to);
            return;
        }
        m_first = begin;
        m_excess = 0;
        merge(begin, end);
    }

    /// Merges fine nodes [begin, end) of the window, or its halves if no rule will do.
    void merge(std::size_t begin, std::size_t end)
    {
        const int count = int(end - begin);
        if (count < spans::fewest)
            return keep(&m_fine[begin], count, begin, end);
        if (count <= SpanRule::maxFine)
            if (const int n = fewestNodes(begin, count))
                return keep(m_best, n, begin, end);
        if (count <= spans::smallest)
            return keep(&m_fine[begin], count, begin, end);
        const std::size_t middle = begin + std::size_t(count / 2);
        merge(begin, middle);
        merge(middle, end);
    }

    void keep(const SpanNode *nodes, int count, std::size_t begin, std::size_t end)
    {
        const std::size_t first = m_out->nodes.size();
        m_out->nodes.insert(m_out->nodes.end(), nodes, nodes + count);
        m_out->windows.push_back({begin, end, first, m_out->nodes.size()});
    }

    /// Leaves the nodes in m_best and returns how many there are. 0 means that no rule of up to maxNodes nodes will do.
    int fewestNodes(std::size_t begin, int count)
    {
        const SpanNode *fine = &m_fine[begin];
        double tolerance = fine[0].tolerance;
        for (int i = 0; i < count; ++i)
            tolerance = std::min(tolerance, fine[i].tolerance);
        const std::size_t first = begin - m_first, last = first + std::size_t(count) - 1;
        const double size = m_course.size[last] - m_course.size[first], arc = m_course.arc[last] - m_course.arc[first];
        const VaryingValues varying(std::span(fine, std::size_t(count)));
        const double mass = massOf(fine, count);
        const double usual = spans::usualNodes(size, arc, mass, tolerance, varying.count > 0);
        if (usual + m_excess > SpanRule::maxNodes + spans::tooMany)
            return 0;
        m_rule.start(fine, &m_course.arc[first], count, varying, mass);
        m_field.start(fine, count, varying);
        spans::Search search(usual, m_excess, count);
        for (;;) {
            SpanNode nodes[SpanRule::maxNodes];
            if (!m_rule.nodes(search.n, nodes))
                break;
            const int n = search.n;
            const bool ends = search.take(double(m_field.difference(nodes, n)) / (spans::share * tolerance));
            if (search.best == n)
                std::copy_n(nodes, n, m_best);
            if (ends)
                break;
        }
        if (search.best)
            m_excess = search.excess();
        return search.best;
    }

    std::span<const SpanNode> m_fine;
    std::span<const std::size_t> m_segments;
    MergedSpan *m_out = nullptr;
    Steps m_steps;
    Course m_course;         // that of the window
    std::size_t m_first = 0; // the fine node at which the window begins
    SpanRule m_rule;
    SpanField m_field;
    SpanNode m_best[SpanRule::maxNodes];
    double m_excess = 0; // how many more nodes than usual the last part of the window makes this one expect
};

} // namespace

void mergeSpan(std::span<const SpanNode> fine, std::span<const std::size_t> segments, MergedSpan &out)
{
    out.nodes.clear();
    out.windows.clear();
    // A merger is too large for the stack, and keeps its memory.
    thread_local const auto merger = std::make_unique<Merger>();
    merger->merge(fine, segments, out);
}

} // namespace suffuse
