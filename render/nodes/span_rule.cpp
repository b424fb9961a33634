// Highway's foreach_target compiles this file once for each SIMD instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/nodes/span_rule.cpp"
// These instruction sets would bring nothing.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include "hwy/foreach_target.h" // It comes first, since it includes this file again for each set.

#include "hwy/highway.h"
#include "render/nodes/span_rule.h"

#include <algorithm>
#include <cmath>
#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace suffuse::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, 8>;
using Vec = hn::Vec<Tag>;
constexpr Tag tag;
constexpr int lanes = int(hn::MaxLanes(Tag()));
// Products and sums are rounded one by one. Where a machine fused them into one instruction, its nodes would differ
// from those of others.

/// A sum over a run, in eight parts whatever the instruction set is, so that all of them round alike.
class Sum {
public:
    HWY_INLINE Sum()
    {
        for (Vec &part : m_parts)
            part = hn::Zero(tag);
    }
    HWY_INLINE void add(int part, Vec v) { m_parts[part] = hn::Add(m_parts[part], v); }
    HWY_INLINE double total() const
    {
        alignas(64) double v[8];
        for (int i = 0; i < vectors; ++i)
            hn::Store(m_parts[i], tag, v + i * lanes);
        return ((v[0] + v[1]) + (v[2] + v[3])) + ((v[4] + v[5]) + (v[6] + v[7]));
    }
    static constexpr int vectors = 8 / lanes;

private:
    Vec m_parts[vectors];
};

/// Calls use(i, part) for each vector of the run, from node i on.
template <class Use>
HWY_INLINE void forEachVector(int count, Use use)
{
    for (int i = 0; i < count; i += 8)
        for (int part = 0; part < Sum::vectors; ++part)
            use(i + part * lanes, part);
}

/// Replaces the angles of the run by their sines, for angles of −1.4 to 1.4, exact to 1e-10.
void makeSines(SpanPolynomials &run)
{
    forEachVector(run.count, [&](int i, int) {
        const Vec x = hn::Load(tag, run.at + i), xx = hn::Mul(x, x);
        Vec p = hn::Set(tag, 1.0);
        for (const double divisor : {1.0 / 156, 1.0 / 110, 1.0 / 72, 1.0 / 42, 1.0 / 20, 1.0 / 6})
            p = hn::Sub(hn::Set(tag, 1.0), hn::Mul(hn::Mul(xx, p), hn::Set(tag, divisor)));
        hn::Store(hn::Mul(x, p), tag, run.at + i);
    });
}

/// Makes the next polynomial, not yet normalised, and returns its norm.
double nextPolynomial(SpanPolynomials &run, double alpha, double beta)
{
    const Vec a = hn::Set(tag, alpha), b = hn::Set(tag, beta);
    Sum norm;
    forEachVector(run.count, [&](int i, int part) {
        const Vec p = hn::Load(tag, run.p + i), before = hn::Load(tag, run.before + i);
        const Vec next = hn::Sub(hn::Mul(hn::Sub(hn::Load(tag, run.at + i), a), p), hn::Mul(b, before));
        hn::Store(p, tag, run.before + i);
        hn::Store(next, tag, run.p + i);
        norm.add(part, hn::Mul(hn::Mul(hn::Load(tag, run.weight + i), next), next));
    });
    return std::sqrt(norm.total());
}

/// Multiplies the last polynomial by `scale`, and computes its alpha and moments.
void addMoments(SpanPolynomials &run, int k, double scale)
{
    const Vec factor = hn::Set(tag, scale);
    Sum alpha, x, y;
    alignas(64) double weighted[SpanPolynomials::maxFine];
    forEachVector(run.count, [&](int i, int part) {
        const Vec p = hn::Mul(hn::Load(tag, run.p + i), factor), wp = hn::Mul(hn::Load(tag, run.weight + i), p);
        hn::Store(p, tag, run.p + i);
        hn::Store(wp, tag, weighted + i);
        alpha.add(part, hn::Mul(hn::Mul(wp, p), hn::Load(tag, run.at + i)));
        x.add(part, hn::Mul(wp, hn::Load(tag, run.carried[0] + i)));
        y.add(part, hn::Mul(wp, hn::Load(tag, run.carried[1] + i)));
    });
    run.alpha[k] = alpha.total();
    run.moment[k][0] = x.total();
    run.moment[k][1] = y.total();
    for (int v = 2; v < run.used; ++v) {
        Sum sum;
        forEachVector(run.count, [&](int i, int part) {
            sum.add(part, hn::Mul(hn::Load(tag, weighted + i), hn::Load(tag, run.carried[v] + i)));
        });
        run.moment[k][v] = sum.total();
    }
}

/// Moves each of the points of `at` by one step of Newton's method towards a root of polynomial n. There are points up
/// to a multiple of 8. Returns the longest step.
double newtonStep(const SpanPolynomials &run, int n, double *at)
{
    constexpr int together = 3; // vectors; one alone would wait for its own results most of the time
    Vec longest = hn::Zero(tag);
    for (int from = 0; from < n; from += together * lanes) {
        Vec t[together], p[together], d[together], pBefore[together], dBefore[together];
        for (int i = 0; i < together; ++i) {
            t[i] = hn::Load(tag, at + std::min(from + i * lanes, SpanPolynomials::maxNodes - lanes));
            p[i] = hn::Set(tag, 1), d[i] = pBefore[i] = dBefore[i] = hn::Zero(tag);
        }
        for (int k = 0; k < n; ++k) {
            const Vec a = hn::Set(tag, run.alpha[k]), b = hn::Set(tag, run.beta[k]);
            const Vec scale = hn::Set(tag, k + 1 < n ? run.inverseBeta[k + 1] : 1);
            for (int i = 0; i < together; ++i) {
                const Vec at0 = hn::Sub(t[i], a);
                const Vec next = hn::Mul(hn::Sub(hn::Mul(at0, p[i]), hn::Mul(b, pBefore[i])), scale);
                const Vec slope = hn::Mul(hn::Sub(hn::Add(p[i], hn::Mul(at0, d[i])), hn::Mul(b, dBefore[i])), scale);
                pBefore[i] = p[i], dBefore[i] = d[i];
                p[i] = next, d[i] = slope;
            }
        }
        for (int i = 0; i < together; ++i)
            if (from + i * lanes < n) {
                const Vec step = hn::Div(p[i], d[i]);
                hn::Store(hn::Sub(t[i], step), tag, at + from + i * lanes);
                longest = hn::Max(longest, hn::Abs(step));
            }
    }
    return hn::GetLane(hn::MaxOfLanes(tag, longest));
}

/// Writes polynomial n, but for a positive factor, at `count` places, a multiple of 24.
void valuesAt(const SpanPolynomials &run, int n, const double *at, int count, double *values)
{
    constexpr int together = 3;
    for (int from = 0; from < count; from += together * lanes) {
        Vec t[together], p[together], before[together];
        for (int i = 0; i < together; ++i) {
            t[i] = hn::Load(tag, at + from + i * lanes);
            p[i] = hn::Set(tag, 1), before[i] = hn::Zero(tag);
        }
        for (int k = 0; k < n; ++k) {
            const Vec a = hn::Set(tag, run.alpha[k]), b = hn::Set(tag, run.beta[k]);
            const Vec scale = hn::Set(tag, k + 1 < n ? run.inverseBeta[k + 1] : 1);
            for (int i = 0; i < together; ++i) {
                const Vec next = hn::Mul(hn::Sub(hn::Mul(hn::Sub(t[i], a), p[i]), hn::Mul(b, before[i])), scale);
                before[i] = p[i];
                p[i] = next;
            }
        }
        for (int i = 0; i < together; ++i)
            hn::Store(p[i], tag, values + from + i * lanes);
    }
}

/// Writes for each of n points the sum of the squares of the first n polynomials, and those of the moments times the
/// polynomials.
void sumsAt(const SpanPolynomials &run, int n, double first, const double *at, double *norm,
            double (*sums)[SpanPolynomials::maxNodes])
{
    for (int from = 0; from < n; from += lanes) {
        const Vec t = hn::Load(tag, at + from);
        Vec p = hn::Set(tag, first), before = hn::Zero(tag), squares = hn::Zero(tag);
        Vec total[SpanPolynomials::moments];
        for (int v = 0; v < run.used; ++v)
            total[v] = hn::Zero(tag);
        for (int k = 0; k < n; ++k) {
            squares = hn::Add(squares, hn::Mul(p, p));
            for (int v = 0; v < run.used; ++v)
                total[v] = hn::Add(total[v], hn::Mul(hn::Set(tag, run.moment[k][v]), p));
            if (k + 1 == n)
                break;
            const Vec a = hn::Set(tag, run.alpha[k]), b = hn::Set(tag, run.beta[k]);
            const Vec next =
                hn::Mul(hn::Sub(hn::Mul(hn::Sub(t, a), p), hn::Mul(b, before)), hn::Set(tag, run.inverseBeta[k + 1]));
            before = p;
            p = next;
        }
        hn::Store(squares, tag, norm + from);
        for (int v = 0; v < run.used; ++v)
            hn::Store(total[v], tag, sums[v] + from);
    }
}

} // namespace suffuse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace suffuse {

HWY_EXPORT(makeSines);
HWY_EXPORT(nextPolynomial);
HWY_EXPORT(addMoments);
HWY_EXPORT(newtonStep);
HWY_EXPORT(valuesAt);
HWY_EXPORT(sumsAt);

namespace {

constexpr int maxNodes = SpanPolynomials::maxNodes;
/// The longer a run, the more evenly its nodes may lie.
constexpr std::array<double, spans::bends> bendNumbers{0.7, 0.85, 1.0, 1.1, 1.2, 1.3};

/// Where the roots of polynomials lie if the run is even, by Szegő's asymptotics of those with the weight (1 − t²)^−½ on
/// [−c, c].
void fillEvenRoots(double bend, double (&at)[maxNodes + 1][maxNodes])
{
    const double c = std::sin(bend), half = c * c / (4 - 2 * c * c);
    const double q = 2 * half / (1 + std::sqrt(1 - 4 * half * half)); // q / (1 + q²) = half
    for (int n = 1; n <= maxNodes; ++n)
        for (int j = 0; j < maxNodes; ++j) {
            const double phase = std::numbers::pi * (std::max(n - j, 1) - 0.25);
            double angle = phase / (n + 0.5);
            for (int step = 0; step < 4; ++step)
                angle = (phase - 0.5 * std::atan2(q * std::sin(2 * angle), 1 - q * std::cos(2 * angle))) / (n + 0.5);
            at[n][j] = c * std::cos(angle);
        }
}

/// Places between which roots are looked for, from the least to the greatest, denser towards the ends.
void fillPlaces(double bend, double (&at)[spans::places])
{
    for (int k = 0; k < spans::places; ++k)
        at[k] = -(1 + 1e-9) * std::sin(bend) * std::cos(std::numbers::pi * k / (spans::places - 1));
}

spans::Tables makeTables()
{
    spans::Tables tables{};
    for (std::size_t i = 0; i < bendNumbers.size(); ++i) {
        tables.bend[i] = bendNumbers[i];
        fillEvenRoots(bendNumbers[i], tables.even[i]);
        fillPlaces(bendNumbers[i], tables.place[i]);
    }
    return tables;
}

} // namespace

const spans::Tables &spanTables()
{
    static const spans::Tables tables = makeTables();
    return tables;
}

double massOf(const SpanNode *nodes, int count)
{
    double part[spans::parts] = {};
    int i = 0;
    for (; i + spans::parts <= count; i += spans::parts)
        for (int k = 0; k < spans::parts; ++k)
            part[k] += nodes[i + k].weight;
    for (int k = 0; i + k < count; ++k)
        part[k] += nodes[i + k].weight;
    return ((part[0] + part[1]) + (part[2] + part[3])) + ((part[4] + part[5]) + (part[6] + part[7]));
}

VaryingValues::VaryingValues(std::span<const SpanNode> nodes)
{
    for (std::size_t v = 0; v < which.size(); ++v)
        if (std::ranges::any_of(nodes, [&](const SpanNode &n) { return n.values[v] != nodes[0].values[v]; }))
            which[std::size_t(count++)] = v;
}

void SpanRule::start(const SpanNode *fine, const double *arc, int count, const VaryingValues &varying, double mass)
{
    m_fine = fine;
    m_varying = varying;
    m_degree = 0;
    m_isEven = true;
    m_run.count = (count + 7) / 8 * 8;
    m_run.used = 2 + varying.count;
    const double middle = 0.5 * (arc[0] + arc[count - 1]), half = std::max(1e-9, 0.5 * (arc[count - 1] - arc[0]));
    m_bend = spans::bendOf(spanTables(), 2 * half);
    const double scale = bend() / half;
    for (int i = 0; i < m_run.count; ++i) {
        const SpanNode &n = fine[std::min(i, count - 1)];
        m_run.weight[i] = i < count ? n.weight : 0;
        m_run.at[i] = i < count ? (arc[i] - middle) * scale : 0;
        m_run.carried[0][i] = n.x - fine[0].x;
        m_run.carried[1][i] = n.y - fine[0].y;
        for (int v = 0; v < varying.count; ++v)
            m_run.carried[2 + v][i] = n.values[varying.which[std::size_t(v)]];
    }
    m_mass = mass;
    HWY_DYNAMIC_DISPATCH(makeSines)(m_run);
    std::fill_n(m_run.p, m_run.count, 1 / std::sqrt(m_mass));
    std::fill_n(m_run.before, m_run.count, 0.0);
    m_run.beta[0] = m_run.inverseBeta[0] = 0;
}

double SpanRule::bend() const
{
    return bendNumbers[std::size_t(m_bend)];
}

/// Computes orthonormal polynomials up to degree n − 1. Returns false if the nodes lie at fewer than n places.
bool SpanRule::extend(int n)
{
    if (m_degree > maxNodes)
        return false;
    for (; m_degree < n; ++m_degree) {
        const int k = m_degree;
        double scale = 1;
        if (k > 0) {
            m_run.beta[k] = HWY_DYNAMIC_DISPATCH(nextPolynomial)(m_run, m_run.alpha[k - 1], m_run.beta[k - 1]);
            if (!(m_run.beta[k] > 1e-7)) {
                m_degree = maxNodes + 1;
                return false;
            }
            scale = m_run.inverseBeta[k] = 1 / m_run.beta[k];
        }
        HWY_DYNAMIC_DISPATCH(addMoments)(m_run, k, scale);
    }
    return true;
}

/// Makes guesses of the zeros of the polynomial of degree n exact. Returns false if they do not lead to all of them.
bool SpanRule::improve(int n, double *out) const
{
    const auto step = HWY_DYNAMIC_DISPATCH(newtonStep);
    double moved = 1;
    for (int i = 0; i < 5 && moved > 1e-7; ++i)
        moved = step(m_run, n, out);
    if (!(moved <= 1e-7)) // Not a number, too.
        return false;
    for (int j = 0; j + 1 < n; ++j)
        if (!(out[j + 1] - out[j] > 1e-5))
            return false;
    return std::abs(out[0]) <= 1 && std::abs(out[n - 1]) <= 1;
}

/// Finds them from those of an even run.
bool SpanRule::rootsOfEvenRun(int n, double *out) const
{
    std::copy_n(spanTables().even[m_bend][n], maxNodes, out);
    return improve(n, out);
}

/// Finds them from changes of sign between places that lie four times as close as the roots of an even run.
bool SpanRule::rootsBetweenPlaces(int n, double *out) const
{
    const double *at = spanTables().place[m_bend];
    alignas(64) double values[spans::places];
    HWY_DYNAMIC_DISPATCH(valuesAt)(m_run, n, at, spans::places, values);
    int found = 0;
    for (int i = 0; i + 1 < spans::places; ++i)
        if ((values[i] < 0) != (values[i + 1] < 0)) {
            if (found == n)
                return false;
            out[found++] = at[i] + (at[i + 1] - at[i]) * (values[i] / (values[i] - values[i + 1]));
        }
    if (found < n)
        return false;
    std::fill(out + n, out + maxNodes, out[n - 1]);
    return improve(n, out);
}

void SpanRule::rootsAsEigenvalues(int n, double *out) const
{
    double squares[maxNodes];
    spans::eigenvalues(n, m_run.alpha, m_run.beta, out, squares);
    std::fill(out + n, out + maxNodes, out[n - 1]);
}

bool SpanRule::nodes(int n, SpanNode *out)
{
    if (!extend(n))
        return false;
    alignas(64) double at[maxNodes], norm[maxNodes], sums[SpanPolynomials::moments][maxNodes];
    m_isEven = m_isEven && rootsOfEvenRun(n, at);
    if (!m_isEven && !rootsBetweenPlaces(n, at))
        rootsAsEigenvalues(n, at);
    HWY_DYNAMIC_DISPATCH(sumsAt)(m_run, n, 1 / std::sqrt(m_mass), at, norm, sums);
    for (int j = 0; j < n; ++j) {
        SpanNode &node = out[j];
        node = m_fine[0];
        node.weight = 1 / norm[j];
        node.x += sums[0][j];
        node.y += sums[1][j];
        for (int v = 0; v < m_varying.count; ++v)
            node.values[m_varying.which[std::size_t(v)]] = std::min(1.0, std::max(0.0, sums[2 + v][j]));
    }
    return true;
}

} // namespace suffuse
#endif
