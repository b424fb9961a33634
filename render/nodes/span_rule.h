// Gauss rules of the discrete measures that Level 0 nodes are.
#pragma once

#include <array>

namespace suffuse {

/// A node in units of the span's spread, with what its segment carries: R, Y, B, opacity, ω.
struct SpanNode {
    double x = 0;
    double y = 0;
    double weight = 0;    ///< density at its centre
    double tolerance = 0; ///< density error that its segment lets pass
    std::array<double, 5> values{};
    friend bool operator==(const SpanNode &, const SpanNode &) = default;
};

/// The n-point Gauss rule of a run of nodes, for growing n at little cost (Stieltjes, Golub-Welsch).
///
/// The rule is that of polynomials in sin(ℓ), ℓ the arc length scaled to [−1, 1]: its nodes lie more evenly than those
/// of polynomials in ℓ, and fewer are needed. Weighted sums of polynomials of degree 2n − 1 are kept, those of
/// positions and values times polynomials up to degree n − 1. Weights are positive.
class SpanRule {
public:
    static constexpr int maxFine = 128;
    static constexpr int maxNodes = 12;

    /// `arc`: arc lengths of the nodes. count in [1, maxFine]. The nodes must outlive the rule.
    void start(const SpanNode *fine, const double *arc, int count, bool valuesVary);
    /// Writes n nodes, n in [1, min(maxNodes, count)]; false: the run lies at too few places for that many.
    bool nodes(int n, SpanNode *out);

private:
    static constexpr int lanes = 4;   // sums run in as many parts, in a fixed order
    static constexpr int moments = 7; // x, y, values

    bool extend(int n);
    void roots(int n, double *out) const;
    template <class Term>
    double sum(Term term) const;

    const SpanNode *m_fine;
    int m_count;  // rounded up to lanes; the rest weighs nothing
    int m_used;   // moments
    int m_degree; // known so far; more than maxNodes: there are no more
    double m_mass;
    double m_weight[maxFine], m_at[maxFine], m_p[maxFine], m_before[maxFine];
    double m_carried[moments][maxFine];
    // p[k+1] · beta[k+1] = (t − alpha[k]) p[k] − beta[k] p[k−1]
    double m_alpha[maxNodes], m_beta[maxNodes];
    double m_moment[maxNodes][moments];
};

} // namespace suffuse
