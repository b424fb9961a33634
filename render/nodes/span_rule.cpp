#include "render/nodes/span_rule.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

template <class Term>
double SpanRule::sum(Term term) const
{
    double part[lanes]{};
    for (int i = 0; i < m_count; i += lanes)
        for (int k = 0; k < lanes; ++k)
            part[k] += term(i + k);
    return (part[0] + part[1]) + (part[2] + part[3]);
}

void SpanRule::start(const SpanNode *fine, const double *arc, int count, bool valuesVary)
{
    m_fine = fine;
    m_count = (count + lanes - 1) / lanes * lanes;
    m_used = valuesVary ? moments : 2;
    m_degree = 0;
    const double middle = 0.5 * (arc[0] + arc[count - 1]), half = std::max(1e-9, 0.5 * (arc[count - 1] - arc[0]));
    for (int i = 0; i < m_count; ++i) {
        const SpanNode &n = fine[std::min(i, count - 1)];
        m_weight[i] = i < count ? n.weight : 0;
        m_at[i] = i < count ? std::sin((arc[i] - middle) / half) : 0;
        m_carried[0][i] = n.x - fine[0].x;
        m_carried[1][i] = n.y - fine[0].y;
        for (int v = 2; v < m_used; ++v)
            m_carried[v][i] = n.values[std::size_t(v - 2)];
    }
    m_mass = sum([this](int i) { return m_weight[i]; });
    std::fill_n(m_p, m_count, 1 / std::sqrt(m_mass));
    std::fill_n(m_before, m_count, 0.0);
    m_beta[0] = 0;
}

/// Computes orthonormal polynomials up to degree n − 1. Returns false if the nodes lie at fewer than n places.
bool SpanRule::extend(int n)
{
    if (m_degree > maxNodes)
        return false;
    for (; m_degree < n; ++m_degree) {
        const int k = m_degree;
        if (k > 0) {
            const double alpha = m_alpha[k - 1], beta = m_beta[k - 1];
            for (int i = 0; i < m_count; ++i) {
                const double next = (m_at[i] - alpha) * m_p[i] - beta * m_before[i];
                m_before[i] = m_p[i];
                m_p[i] = next;
            }
            m_beta[k] = std::sqrt(sum([this](int i) { return m_weight[i] * m_p[i] * m_p[i]; }));
            if (!(m_beta[k] > 1e-7)) {
                m_degree = maxNodes + 1;
                return false;
            }
            const double scale = 1 / m_beta[k];
            for (int i = 0; i < m_count; ++i)
                m_p[i] *= scale;
        }
        m_alpha[k] = sum([this](int i) { return m_weight[i] * m_p[i] * m_p[i] * m_at[i]; });
        for (int v = 0; v < m_used; ++v)
            m_moment[k][v] = sum([this, v](int i) { return m_weight[i] * m_p[i] * m_carried[v][i]; });
    }
    return true;
}

/// Finds the zeros of the polynomial of degree n. They are the eigenvalues of the Jacobi matrix, found by the QL method
/// with implicit shifts in the form without square roots (Pal, Walker and Kahan).
void SpanRule::roots(int n, double *d) const
{
    double e2[maxNodes]; // the squares of the entries beside the diagonal
    for (int i = 0; i < n; ++i) {
        d[i] = m_alpha[i];
        e2[i] = i + 1 < n ? m_beta[i + 1] * m_beta[i + 1] : 0;
    }
    for (int first = 0; first < n; ++first)
        for (int step = 0; step < 60; ++step) {
            // Leaving out an entry e moves an eigenvalue by e² divided by the gap to the next one.
            int last = first;
            while (last + 1 < n && e2[last] > 1e-12)
                ++last;
            if (last == first)
                break;
            const double e = std::sqrt(e2[first]), p = (d[first + 1] - d[first]) / (2 * e);
            const double shift = d[first] - e / (p + std::copysign(std::sqrt(p * p + 1), p));
            double cosine = 1, sine = 0, gamma = d[last] - shift, rest = gamma * gamma;
            for (int i = last - 1; i >= first; --i) {
                const double r = rest + e2[i], inverse = 1 / r, ratio = r / rest, gammaBefore = gamma;
                if (i + 1 < last)
                    e2[i + 1] = sine * r;
                const double unturned = cosine * e2[i]; // what takes its place if rest is 0
                cosine = rest * inverse;
                sine = e2[i] * inverse;
                gamma = cosine * (d[i] - shift) - sine * gammaBefore;
                d[i + 1] = gammaBefore + (d[i] - gamma);
                rest = rest > 0 ? gamma * gamma * ratio : unturned;
            }
            e2[first] = sine * rest;
            d[first] = shift + gamma;
        }
    std::sort(d, d + n);
}

bool SpanRule::nodes(int n, SpanNode *out)
{
    if (!extend(n))
        return false;
    double at[maxNodes];
    roots(n, at);
    for (int j = 0; j < n; ++j) {
        double p = 1 / std::sqrt(m_mass), before = 0, norm = 0, sums[moments]{};
        for (int k = 0; k < n; ++k) {
            norm += p * p;
            for (int v = 0; v < m_used; ++v)
                sums[v] += m_moment[k][v] * p;
            if (k + 1 == n)
                break;
            const double next = ((at[j] - m_alpha[k]) * p - m_beta[k] * before) / m_beta[k + 1];
            before = p;
            p = next;
        }
        SpanNode &node = out[j];
        node = m_fine[0];
        node.weight = 1 / norm;
        node.x += sums[0];
        node.y += sums[1];
        for (int v = 2; v < m_used; ++v)
            node.values[std::size_t(v - 2)] = std::min(1.0, std::max(0.0, sums[v]));
    }
    return true;
}

} // namespace suffuse
