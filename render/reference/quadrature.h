// Quadrature rules of the reference: Gauss-Legendre of any order and the adaptive pair G7, K15.
#pragma once

#include <array>
#include <vector>

namespace suffuse::reference {

/// Nodes in (0, 1) in increasing order and weights with sum 1.
struct GaussRule {
    std::vector<double> nodes;
    std::vector<double> weights;
};

/// The Gauss-Legendre rule of n ≥ 1 points on [0, 1], by Newton's method on P_n. It is exact for polynomials of degree
/// 2n − 1.
GaussRule gaussLegendre(int n);

/// The same rules, computed once for the orders that the reference uses.
const GaussRule &gauss10();
const GaussRule &gauss20();

/// The 15 points of the Kronrod rule on [−1, 1] from the middle outwards (the other half is mirrored), its weights, and
/// the weights of the embedded 7-point Gauss rule (0 where it has no node).
struct KronrodRule {
    std::array<double, 8> nodes;
    std::array<double, 8> weights;
    std::array<double, 8> gaussWeights;
};
const KronrodRule &kronrod15();

} // namespace suffuse::reference
