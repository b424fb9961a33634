// The program that merges the Level 0 nodes of a window (docs/solver.md, "Level 1"). One warp takes a window, and
// others help it (node_field.h). It does what render/nodes/level1 and span_rule do, with the same sums in the same
// order.
#pragma once

#include "render/cuda/nodes/node_field.h"

namespace suffuse::cuda {

/// The shared memory of the program.
struct MergeScratch {
    FieldScratch field;

    // The run: see SpanPolynomials (render/nodes/span_rule.h).
    double weight[spans::mostFine], at[spans::mostFine], p[spans::mostFine], before[spans::mostFine];
    double weighted[spans::mostFine];
    /// The rows lie in different banks of memory.
    double carried[spans::moments][spans::mostFine + spans::parts];
    double alpha[spans::mostNodes], beta[spans::mostNodes], inverseBeta[spans::mostNodes];
    double moment[spans::mostNodes][spans::moments];
    double root[spans::mostNodes], square[spans::mostNodes], value[spans::places];

    /// The nodes of a rule, with the values that vary.
    struct Nodes {
        double x[spans::mostNodes], y[spans::mostNodes], weight[spans::mostNodes];
        double value[spans::values][spans::mostNodes];
    };
    Nodes now, best;
    int which[spans::values]; ///< the values that vary

    std::uint32_t begin[16], end[16]; ///< windows that are still to be merged
};

template <class Crew>
class SpanMerger {
public:
    using Warp = typename Crew::Warp;

    SUFFUSE_PROGRAM SpanMerger(Crew &crew, const NodeWork &work, MergeScratch &scratch)
        : m_crew(crew), m_warp(crew.warp()), m_work(work), m_tables(*work.spans), m_s(scratch)
    {}

    SUFFUSE_PROGRAM void merge(std::uint32_t leaf)
    {
        const SpanLeaf whole = m_work.leaves[leaf];
        follow(whole.begin, whole.end);
        m_excess = 0;
        std::uint32_t waiting = 0, begin = whole.begin, end = whole.end;
        for (;;) {
            const int count = int(end - begin);
            int nodes = 0;
            if (count >= spans::fewest && count <= spans::mostFine)
                nodes = fewestNodes(begin, count);
            if (nodes > 0) {
                keepBest(nodes, begin, end);
            } else if (count <= spans::smallest) {
                keepFine(begin, end);
            } else { // Its halves are merged.
                const std::uint32_t middle = begin + std::uint32_t(count / 2);
                m_warp.each([&](int lane) {
                    if (lane == 0)
                        m_s.begin[waiting] = middle, m_s.end[waiting] = end;
                });
                ++waiting, end = middle;
                continue;
            }
            if (waiting == 0)
                return;
            --waiting;
            begin = m_s.begin[waiting], end = m_s.end[waiting];
            m_warp.meet();
        }
    }

private:
    template <class T>
    using Var = typename Warp::template Var<T>;

    SUFFUSE_PROGRAM const SegmentRecord &segmentOf(const FineNode &node) const { return m_work.segments[node.segment]; }

    /// Replaces the distances and turnings of the window by their sums up to each node.
    SUFFUSE_PROGRAM void follow(std::uint32_t begin, std::uint32_t end)
    {
        double arc = 0, size = 0;
        SUFFUSE_ROLLED
        for (std::uint32_t base = begin; base < end; base += warpLanes) {
            Var<double> length, turning, arcs, sizes;
            m_warp.each([&](int lane) {
                const std::uint32_t i = base + std::uint32_t(lane);
                length[lane] = i > begin && i < end ? m_work.length[i] : 0;
                turning[lane] = i > begin + 1 && i < end ? m_work.turning[i] : 0;
                arcs[lane] = sizes[lane] = 0;
            });
            SUFFUSE_UNROLL_BY_4
            for (int j = 0; j < warpLanes; ++j) {
                const double step = m_warp.read(length, j);
                arc = arc + step;
                size = size + step + m_warp.read(turning, j);
                m_warp.put(arcs, j, arc);
                m_warp.put(sizes, j, size);
            }
            m_warp.each([&](int lane) {
                const std::uint32_t i = base + std::uint32_t(lane);
                if (i < end)
                    m_work.length[i] = arcs[lane], m_work.turning[i] = sizes[lane];
            });
        }
    }

    /// Leaves nodes in m_s.best and returns how many there are. 0 means that no rule of up to mostNodes nodes will do.
    SUFFUSE_PROGRAM int fewestNodes(std::uint32_t begin, int count)
    {
        m_fine = m_work.fine + begin;
        m_fines = count;
        m_count = (count + spans::parts - 1) / spans::parts * spans::parts;
        load();
        const double *arcs = m_work.length + begin, *sizes = m_work.turning + begin;
        const double usual = spans::usualNodes(sizes[count - 1] - sizes[0], arcs[count - 1] - arcs[0], m_mass,
                                               m_tolerance, m_varying > 0);
        if (usual + m_excess > spans::mostNodes + spans::tooMany)
            return 0;
        startRule(arcs);
        startField();
        spans::Search search(usual, m_excess, count);
        for (;;) {
            if (!findRule(search.n))
                break;
            const int n = search.n;
            const bool ends = search.take(double(difference(n)) / (spans::share * m_tolerance));
            if (search.best == n)
                m_warp.each([&](int lane) {
                    if (lane >= n)
                        return;
                    m_s.best.x[lane] = m_s.now.x[lane], m_s.best.y[lane] = m_s.now.y[lane];
                    m_s.best.weight[lane] = m_s.now.weight[lane];
                    SUFFUSE_ROLLED
                    for (int k = 0; k < m_varying; ++k)
                        m_s.best.value[k][lane] = m_s.now.value[k][lane];
                });
            if (ends)
                break;
        }
        if (search.best)
            m_excess = search.excess();
        return search.best;
    }

    /// Reads the run: its weights, their sum, the least tolerance, and which values vary.
    SUFFUSE_PROGRAM void load()
    {
        const FineNode begin = m_fine[0];
        m_x = begin.x, m_y = begin.y;
        Var<double> tolerance;
        std::uint32_t varies = 0;
        m_warp.each([&](int lane) { tolerance[lane] = 1e300; });
        SUFFUSE_ROLLED
        for (int base = 0; base < m_count; base += warpLanes) {
            Var<std::uint32_t> differs;
            m_warp.each([&](int lane) {
                const int i = base + lane;
                differs[lane] = 0;
                if (i >= m_count)
                    return;
                const FineNode node = m_fine[i < m_fines ? i : m_fines - 1];
                const SegmentRecord &segment = segmentOf(node), &first = segmentOf(begin);
                m_s.weight[i] = i < m_fines ? node.weight : 0;
                m_s.carried[0][i] = node.x - m_x;
                m_s.carried[1][i] = node.y - m_y;
                tolerance[lane] = segment.allowed < tolerance[lane] ? segment.allowed : tolerance[lane];
                for (int v = 0; v < spans::values; ++v)
                    differs[lane] |= segment.values[v] != first.values[v] ? 1u << v : 0u;
            });
            for (int v = 0; v < spans::values; ++v)
                varies |= m_warp.any([&](int lane) { return (differs[lane] >> v & 1) != 0; }) ? 1u << v : 0u;
        }
        m_tolerance = m_warp.least(tolerance);
        m_varying = Warp::count(varies);
        m_warp.each([&](int lane) {
            if (lane < spans::values && (varies >> lane & 1))
                m_s.which[Warp::rank(varies, lane)] = lane;
        });
        SUFFUSE_ROLLED
        for (int k = 0; k < m_varying; ++k) {
            const int v = m_s.which[k];
            SUFFUSE_ROLLED
            for (int base = 0; base < m_count; base += warpLanes)
                m_warp.each([&](int lane) {
                    const int i = base + lane;
                    if (i < m_count)
                        m_s.carried[2 + k][i] = double(segmentOf(m_fine[i < m_fines ? i : m_fines - 1]).values[v]);
                });
        }
        Var<double> mass = sumsOf([&](int, int i) { return m_s.weight[i]; });
        m_mass = m_warp.read(mass, 0);
    }

    /// Returns sums over the run, four at once: lane l has that of term(l / 8, i).
    template <class Term>
    SUFFUSE_PROGRAM Var<double> sumsOf(Term term)
    {
        Var<double> sum;
        m_warp.each([&](int lane) {
            double part = 0;
            SUFFUSE_UNROLL_BY_4
            for (int i = lane % spans::parts; i < m_count; i += spans::parts)
                part = part + term(lane / spans::parts, i);
            sum[lane] = part;
        });
        m_warp.sumEights(sum);
        return sum;
    }

    // The Gauss rule.

    SUFFUSE_PROGRAM void startRule(const double *arcs)
    {
        const double first = arcs[0], last = arcs[m_fines - 1];
        const double middle = 0.5 * (first + last), length = 0.5 * (last - first), half = length > 1e-9 ? length : 1e-9;
        m_bend = spans::bendOf(m_tables, 2 * half);
        const double scale = m_tables.bend[m_bend] / half;
        m_first = 1 / std::sqrt(m_mass);
        m_degree = 0;
        m_isEven = true;
        SUFFUSE_ROLLED
        for (int base = 0; base < m_count; base += warpLanes)
            m_warp.each([&](int lane) {
                const int i = base + lane;
                if (i >= m_count)
                    return;
                m_s.at[i] = spans::sine(i < m_fines ? (arcs[i] - middle) * scale : 0);
                m_s.p[i] = m_first;
                m_s.before[i] = 0;
                if (i == 0)
                    m_s.beta[0] = m_s.inverseBeta[0] = 0;
            });
    }

    /// Computes orthonormal polynomials up to degree n − 1. Returns false if the nodes lie at fewer than n places.
    SUFFUSE_PROGRAM bool extend(int n)
    {
        if (m_degree > spans::mostNodes)
            return false;
        SUFFUSE_ROLLED
        for (; m_degree < n; ++m_degree) {
            const int k = m_degree;
            double scale = 1;
            if (k > 0) {
                const double beta = nextPolynomial(m_s.alpha[k - 1], m_s.beta[k - 1]);
                if (!(beta > 1e-7)) {
                    m_degree = spans::mostNodes + 1;
                    return false;
                }
                scale = 1 / beta;
                m_warp.each([&](int lane) {
                    if (lane == 0)
                        m_s.beta[k] = beta, m_s.inverseBeta[k] = scale;
                });
            }
            addMoments(k, scale);
        }
        return true;
    }

    /// Makes the next polynomial, not yet normalised, and returns its norm.
    SUFFUSE_PROGRAM double nextPolynomial(double alpha, double beta)
    {
        SUFFUSE_UNROLL_BY_2
        for (int base = 0; base < m_count; base += warpLanes)
            m_warp.each([&](int lane) {
                const int i = base + lane;
                if (i >= m_count)
                    return;
                const double p = m_s.p[i], next = (m_s.at[i] - alpha) * p - beta * m_s.before[i];
                m_s.before[i] = p;
                m_s.p[i] = next;
                m_s.weighted[i] = m_s.weight[i] * next * next;
            });
        Var<double> norm = sumsOf([&](int, int i) { return m_s.weighted[i]; });
        return std::sqrt(m_warp.read(norm, 0));
    }

    /// Multiplies the last polynomial by `scale`, and computes its alpha and moments.
    SUFFUSE_PROGRAM void addMoments(int k, double scale)
    {
        SUFFUSE_UNROLL_BY_2
        for (int base = 0; base < m_count; base += warpLanes)
            m_warp.each([&](int lane) {
                const int i = base + lane;
                if (i >= m_count)
                    return;
                const double p = m_s.p[i] * scale;
                m_s.p[i] = p;
                m_s.weighted[i] = m_s.weight[i] * p;
            });
        constexpr int together = warpLanes / spans::parts;
        const int all = 3 + m_varying; // alpha and the moments
        SUFFUSE_ROLLED
        for (int from = 0; from < all; from += together) {
            Var<double> sums = sumsOf([&](int own, int i) {
                const int sum = from + own;
                if (sum == 0)
                    return m_s.weighted[i] * m_s.p[i] * m_s.at[i];
                return m_s.weighted[i] * m_s.carried[sum < all ? sum - 1 : 0][i];
            });
            m_warp.each([&](int lane) {
                const int sum = from + lane / spans::parts;
                if (lane % spans::parts != 0 || sum >= all)
                    return;
                if (sum == 0)
                    m_s.alpha[k] = sums[lane];
                else
                    m_s.moment[k][sum - 1] = sums[lane];
            });
        }
    }

    /// Makes guesses of the zeros of the polynomial of degree n, m_s.root, exact by Newton's method. Returns false if
    /// they do not lead to all of them.
    SUFFUSE_PROGRAM bool improve(int n)
    {
        Var<double> root, step;
        m_warp.each([&](int lane) { root[lane] = m_s.root[lane < n ? lane : n - 1]; });
        double moved = 1;
        SUFFUSE_ROLLED
        for (int i = 0; i < 5 && moved > 1e-7; ++i) {
            m_warp.each([&](int lane) {
                const double t = root[lane];
                double p = 1, d = 0, pBefore = 0, dBefore = 0;
                SUFFUSE_UNROLL_BY_2
                for (int k = 0; k < n; ++k) {
                    const double beta = m_s.beta[k], scale = k + 1 < n ? m_s.inverseBeta[k + 1] : 1;
                    const double from = t - m_s.alpha[k];
                    const double next = (from * p - beta * pBefore) * scale;
                    const double slope = (p + from * d - beta * dBefore) * scale;
                    pBefore = p, dBefore = d;
                    p = next, d = slope;
                }
                const double by = p / d;
                root[lane] = t - by;
                step[lane] = -std::fabs(by);
            });
            if (m_warp.any([&](int lane) { return !(step[lane] <= 0); })) // Not a number.
                return false;
            moved = -m_warp.least(step);
        }
        if (!(moved <= 1e-7))
            return false;
        m_warp.each([&](int lane) {
            if (lane < n)
                m_s.root[lane] = root[lane];
        });
        return !m_warp.any([&](int lane) { return lane + 1 < n && !(m_s.root[lane + 1] - m_s.root[lane] > 1e-5); }) &&
               std::fabs(m_s.root[0]) <= 1 && std::fabs(m_s.root[n - 1]) <= 1;
    }

    /// Finds guesses from changes of sign between places that lie four times as close as the roots of an even run.
    SUFFUSE_PROGRAM bool rootsBetweenPlaces(int n)
    {
        const double *places = m_tables.place[m_bend];
        SUFFUSE_ROLLED
        for (int base = 0; base < spans::places; base += warpLanes)
            m_warp.each([&](int lane) {
                const double t = places[base + lane];
                double p = 1, before = 0;
                SUFFUSE_UNROLL_BY_2
                for (int k = 0; k < n; ++k) {
                    const double scale = k + 1 < n ? m_s.inverseBeta[k + 1] : 1;
                    const double next = ((t - m_s.alpha[k]) * p - m_s.beta[k] * before) * scale;
                    before = p;
                    p = next;
                }
                m_s.value[base + lane] = p;
            });
        int found = 0;
        SUFFUSE_ROLLED
        for (int base = 0; base < spans::places; base += warpLanes) {
            const std::uint32_t changes = m_warp.ballot([&](int lane) {
                const int i = base + lane;
                return i + 1 < spans::places && (m_s.value[i] < 0) != (m_s.value[i + 1] < 0);
            });
            m_warp.each([&](int lane) {
                const int i = base + lane, slot = found + Warp::rank(changes, lane);
                if ((changes >> lane & 1) && slot < n)
                    m_s.root[slot] =
                        places[i] + (places[i + 1] - places[i]) * (m_s.value[i] / (m_s.value[i] - m_s.value[i + 1]));
            });
            found += Warp::count(changes);
        }
        return found == n;
    }

    SUFFUSE_PROGRAM void findRoots(int n)
    {
        // At first those of an even run are guessed, until that fails once.
        SUFFUSE_ROLLED
        for (int attempt = m_isEven ? 0 : 1; attempt < 2; ++attempt) {
            bool guessed = true;
            if (attempt == 0)
                m_warp.each([&](int lane) {
                    if (lane < n)
                        m_s.root[lane] = m_tables.even[m_bend][n][lane];
                });
            else
                guessed = rootsBetweenPlaces(n);
            if (guessed && improve(n))
                return;
            m_isEven = false;
        }
        m_warp.each([&](int lane) {
            if (lane == 0)
                spans::eigenvalues(n, m_s.alpha, m_s.beta, m_s.root, m_s.square);
        });
    }

    /// Leaves the rule of n nodes in m_s.now. Returns false if the run lies at too few places for that many.
    SUFFUSE_PROGRAM bool findRule(int n)
    {
        if (!extend(n))
            return false;
        findRoots(n);
        m_warp.each([&](int lane) {
            if (lane >= n)
                return;
            double norm = 0, x = 0, y = 0;
            forEachPolynomial(n, m_s.root[lane], [&](int k, double p) {
                norm = norm + p * p;
                x = x + m_s.moment[k][0] * p;
                y = y + m_s.moment[k][1] * p;
            });
            m_s.now.weight[lane] = 1 / norm;
            m_s.now.x[lane] = m_x + x;
            m_s.now.y[lane] = m_y + y;
        });
        SUFFUSE_ROLLED
        for (int k = 0; k < m_varying; ++k)
            m_warp.each([&](int lane) {
                if (lane >= n)
                    return;
                double sum = 0;
                forEachPolynomial(n, m_s.root[lane],
                                  [&](int degree, double p) { sum = sum + m_s.moment[degree][2 + k] * p; });
                const double least = sum > 0 ? sum : 0;
                m_s.now.value[k][lane] = least < 1 ? least : 1;
            });
        return true;
    }

    /// Calls use(k, value) for the first n polynomials at a point.
    template <class Use>
    SUFFUSE_PROGRAM void forEachPolynomial(int n, double t, Use use)
    {
        double p = m_first, before = 0;
        SUFFUSE_UNROLL_BY_2
        for (int k = 0; k < n; ++k) {
            use(k, p);
            if (k + 1 == n)
                return;
            const double next = ((t - m_s.alpha[k]) * p - m_s.beta[k] * before) * m_s.inverseBeta[k + 1];
            before = p;
            p = next;
        }
    }

    // The grid on which densities are compared.

    SUFFUSE_PROGRAM void startField()
    {
        const double chordX = m_s.carried[0][m_fines - 1], chordY = m_s.carried[1][m_fines - 1];
        const double chord = std::sqrt(chordX * chordX + chordY * chordY);
        m_cos = chord > 0 ? chordX / chord : 1;
        m_sin = chord > 0 ? chordY / chord : 0;
        Var<double> left, top, right, bottom; // The latter two are negative, so that all are least ones.
        m_warp.each([&](int lane) {
            left[lane] = top[lane] = right[lane] = bottom[lane] = 0;
            SUFFUSE_ROLLED
            for (int i = lane; i < m_fines; i += warpLanes) {
                const double dx = m_s.carried[0][i], dy = m_s.carried[1][i];
                const double x = dx * m_cos + dy * m_sin, y = dy * m_cos - dx * m_sin;
                left[lane] = x < left[lane] ? x : left[lane], right[lane] = -x < right[lane] ? -x : right[lane];
                top[lane] = y < top[lane] ? y : top[lane], bottom[lane] = -y < bottom[lane] ? -y : bottom[lane];
            }
        });
        const spans::Grid grid(m_warp.least(left), m_warp.least(top), -m_warp.least(right), -m_warp.least(bottom));
        m_left = grid.left, m_top = grid.top;
        m_warp.each([&](int lane) {
            if (lane == 0)
                m_s.field.step = grid.step, m_s.field.columns = grid.columns, m_s.field.rows = grid.rows,
                m_s.field.sums = 1 + m_varying;
        });
        SUFFUSE_ROLLED
        for (int from = 0; from < m_fines; from += spans::mostNodes) {
            const int count = m_fines - from < spans::mostNodes ? m_fines - from : spans::mostNodes;
            giveNodes(count, 1, [&](int lane, int sum) {
                const int i = from + lane;
                return sum == 0   ? m_s.carried[0][i]
                       : sum == 1 ? m_s.carried[1][i]
                       : sum == 2 ? m_s.weight[i]
                                  : m_s.carried[sum - 1][i];
            });
            m_crew.share(FieldTask::Tables);
            m_crew.share(from == 0 ? FieldTask::Begin : FieldTask::Add);
        }
    }

    /// Returns the greatest difference of the density of m_s.now at a point of the grid, or half the difference of
    /// density times a value if that is greater.
    SUFFUSE_PROGRAM float difference(int count)
    {
        giveNodes(count, -1, [&](int lane, int sum) {
            return sum == 0   ? m_s.now.x[lane] - m_x
                   : sum == 1 ? m_s.now.y[lane] - m_y
                   : sum == 2 ? m_s.now.weight[lane]
                              : m_s.now.value[sum - 3][lane];
        });
        m_crew.share(FieldTask::Tables);
        m_crew.share(FieldTask::Compare);
        float worst = 0;
        for (int own = 0; own < fieldWarps; ++own)
            worst = worst < m_s.field.worst[own] ? m_s.field.worst[own] : worst;
        m_warp.meet();
        return worst;
    }

    /// Gives nodes to the field: of(lane, 0) and of(lane, 1) are their places from the run's first node, then come
    /// weight and values.
    template <class Of>
    SUFFUSE_PROGRAM void giveNodes(int count, float sign, Of of)
    {
        m_warp.each([&](int lane) {
            if (lane == 0)
                m_s.field.count = count;
            if (lane >= count)
                return;
            const double dx = of(lane, 0), dy = of(lane, 1), weight = of(lane, 2);
            m_s.field.x[lane] = float(dx * m_cos + dy * m_sin - m_left);
            m_s.field.y[lane] = float(dy * m_cos - dx * m_sin - m_top);
            m_s.field.factor[0][lane] = sign * float(weight);
            SUFFUSE_ROLLED
            for (int k = 0; k < m_varying; ++k)
                m_s.field.factor[1 + k][lane] = sign * float(weight * (0.5 * of(lane, 3 + k)));
        });
    }

    // What becomes of a window.

    SUFFUSE_PROGRAM void keepBest(int count, std::uint32_t begin, std::uint32_t end)
    {
        MergedNode *out = keep(std::uint32_t(count), begin, end);
        m_warp.each([&](int lane) {
            if (lane >= count)
                return;
            MergedNode &node = out[lane];
            node.x = m_s.best.x[lane], node.y = m_s.best.y[lane], node.weight = m_s.best.weight[lane];
            const SegmentRecord &first = segmentOf(m_work.fine[begin]);
            for (int v = 0; v < spans::values; ++v)
                node.values[v] = first.values[v];
            SUFFUSE_ROLLED
            for (int k = 0; k < m_varying; ++k)
                node.values[m_s.which[k]] = float(m_s.best.value[k][lane]);
        });
    }

    SUFFUSE_PROGRAM void keepFine(std::uint32_t begin, std::uint32_t end)
    {
        MergedNode *out = keep(end - begin, begin, end);
        m_warp.each([&](int lane) {
            if (lane >= int(end - begin))
                return;
            const FineNode fine = m_work.fine[begin + std::uint32_t(lane)];
            MergedNode &node = out[lane];
            node.x = fine.x, node.y = fine.y, node.weight = fine.weight;
            for (int v = 0; v < spans::values; ++v)
                node.values[v] = segmentOf(fine).values[v];
        });
    }

    SUFFUSE_PROGRAM MergedNode *keep(std::uint32_t count, std::uint32_t begin, std::uint32_t end)
    {
        const std::uint32_t window = m_warp.take(m_work.status + windowsTaken);
        const std::uint32_t first = m_warp.take(m_work.status + mergedTaken, count);
        m_warp.each([&](int lane) {
            if (lane == 0)
                m_work.windows[window] = {begin, end, first, count};
        });
        return m_work.merged + first;
    }

    Crew &m_crew;
    Warp &m_warp;
    const NodeWork &m_work;
    const spans::Tables &m_tables;
    MergeScratch &m_s;
    double m_excess = 0; ///< how many more nodes than usual the last part of the window makes this one expect

    const FineNode *m_fine = nullptr;
    int m_fines = 0, m_count = 0; ///< of the run, and the same rounded up to parts of equal length
    double m_mass = 0, m_tolerance = 0;
    int m_varying = 0;
    int m_bend = 0;       // which of the numbers a
    bool m_isEven = true; // whether its roots have been found from those of an even run so far
    int m_degree = 0;     // how many polynomials are known so far; more than mostNodes if there are no others
    double m_first = 0;   // the first polynomial, which is constant

    double m_x = 0, m_y = 0, m_cos = 1, m_sin = 0; ///< the grid's axes, which lie along the chord from the first node
    double m_left = 0, m_top = 0;
};

} // namespace suffuse::cuda
