// Level 0 nodes are a discrete measure. This computes its Gauss rules.
#pragma once

#include <array>

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

/// Computes the n-point Gauss rule of a run of nodes, for growing n at little cost (Stieltjes, Golub-Welsch). The
/// polynomials are in sin(ℓ), where ℓ is the arc length scaled to [−1, 1]: their nodes lie more evenly than those of
/// polynomials in ℓ, and fewer are needed. The rule has the same weighted sums of polynomials up to degree 2n − 1 as
/// the run, and the same sums of positions and values times polynomials up to degree n − 1. Weights are positive.
class SpanRule {
public:
    static constexpr int maxFine = 128;
    static constexpr int maxNodes = 12;

    /// Begins a run. `arc` has the arc lengths of the nodes; count is in [1, maxFine]. The nodes must outlive the rule.
    void start(const SpanNode *fine, const double *arc, int count, bool valuesVary);
    /// Writes n nodes, n in [1, min(maxNodes, count)]. Returns false if the run lies at too few places for that many.
    bool nodes(int n, SpanNode *out);

private:
    static constexpr int lanes = 4;   // Sums are computed in so many parts, in a fixed order.
    static constexpr int moments = 7; // x, y, values

    bool extend(int n);
    void roots(int n, double *out) const;
    template <class Term>
    double sum(Term term) const;

    const SpanNode *m_fine;
    int m_count;  // rounded up to a multiple of lanes; the rest weighs nothing
    int m_used;   // how many of the moments are used
    int m_degree; // how many polynomials are known so far; more than maxNodes if there are no others
    double m_mass;
    double m_weight[maxFine], m_at[maxFine], m_p[maxFine], m_before[maxFine];
    double m_carried[moments][maxFine];
    // The polynomials follow p[k+1] · beta[k+1] = (t − alpha[k]) p[k] − beta[k] p[k−1].
    double m_alpha[maxNodes], m_beta[maxNodes];
    double m_moment[maxNodes][moments];
};

} // namespace suffuse
