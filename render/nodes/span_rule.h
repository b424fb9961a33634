// Level 0 nodes are a discrete measure. This computes its Gauss rules.
#pragma once

#include "render/math/spans.h"

#include <array>
#include <span>

namespace suffuse {

/// Holds a node in units of the span's spread, with the values of its segment: R, Y, B, opacity, ω.
struct SpanNode {
    double x = 0;
    double y = 0;
    double weight = 0;    ///< the density at its centre
    double tolerance = 0; ///< the error of density that its segment allows
    std::array<double, 5> values{};
    friend bool operator==(const SpanNode &, const SpanNode &) = default;
};

/// Says which values differ between the nodes of a run. The others stay exactly as they are: rounding must not make
/// them differ from node to node.
struct VaryingValues {
    int count = 0;
    std::array<std::size_t, 5> which{}; ///< the first `count` of them, ascending

    VaryingValues() = default;
    explicit VaryingValues(std::span<const SpanNode> nodes);
};

/// Holds a run of nodes, and the polynomials that are orthonormal over it. They follow p[k+1] · beta[k+1] =
/// (t − alpha[k]) p[k] − beta[k] p[k−1].
struct SpanPolynomials {
    static constexpr int maxFine = spans::mostFine;
    static constexpr int maxNodes = spans::mostNodes;
    static constexpr int moments = spans::moments; ///< x, y, the values that vary

    int count = 0; ///< of nodes, rounded up to a multiple of 8; those that were added weigh nothing
    int used = 0;  ///< how many of the moments are used
    alignas(64) double weight[maxFine];
    alignas(64) double at[maxFine]; ///< t
    alignas(64) double p[maxFine];  ///< the last polynomial that is known, at the nodes, and the one before
    alignas(64) double before[maxFine];
    alignas(64) double carried[moments][maxFine];
    double alpha[maxNodes], beta[maxNodes], inverseBeta[maxNodes];
    double moment[maxNodes][moments];
};

/// Returns the sum of the weights of a run.
double massOf(const SpanNode *nodes, int count);

/// Returns the tables that all runs share.
const spans::Tables &spanTables();

/// Computes the n-point Gauss rule of a run of nodes, for growing n at little cost (Stieltjes; the roots by Newton's
/// method, or by Golub and Welsch's where that fails). The polynomials are in t = sin(aℓ), where ℓ is the arc length
/// scaled to [−1, 1]: their nodes lie more evenly than those of polynomials in ℓ, and fewer are needed. The rule has
/// the same weighted sums of polynomials up to degree 2n − 1 as the run, and the same sums of positions and values
/// times polynomials up to degree n − 1. Weights are positive. All SIMD instruction sets give the same bits.
class SpanRule {
public:
    static constexpr int maxFine = SpanPolynomials::maxFine;
    static constexpr int maxNodes = SpanPolynomials::maxNodes;

    /// Begins a run. `arc` has the arc lengths of the nodes; count is in [1, maxFine], `mass` is massOf
    /// the run. The nodes must outlive the rule.
    void start(const SpanNode *fine, const double *arc, int count, const VaryingValues &varying, double mass);
    /// Returns the number a, which depends on the run's length.
    double bend() const;
    /// Writes n nodes, n in [1, min(maxNodes, count)]. Returns false if the run lies at too few places for that many.
    bool nodes(int n, SpanNode *out);

private:
    bool extend(int n);
    bool improve(int n, double *out) const;
    bool rootsOfEvenRun(int n, double *out) const;
    bool rootsBetweenPlaces(int n, double *out) const;
    void rootsAsEigenvalues(int n, double *out) const;

    const SpanNode *m_fine;
    VaryingValues m_varying;
    int m_bend;    // which of the numbers a
    bool m_isEven; // whether its roots have been found from those of an even run so far
    int m_degree;  // how many polynomials are known so far; more than maxNodes if there are no others
    double m_mass;
    SpanPolynomials m_run;
};

} // namespace suffuse
