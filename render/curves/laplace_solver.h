// The Laplace equation on a grid of pixels, by conjugate gradients with multigrid.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace suffuse::curves {

/// Finds u of Σ over open links (u(q) − u(p)) + anchors(p) (value − u(p)) = 0 for each pixel p, where sources(p) is
/// anchors(p) times the value that p is held at. There must be an anchor in each part that open links connect.
///
/// The matrix is symmetric and positive definite. Conjugate gradients (Hestenes & Stiefel 1952) solve it, with one
/// V-cycle as what they are preconditioned by: red-black Gauss-Seidel on each grid, and grids of half the size where
/// links have half the conductance of two that lie side by side, and anchors add up. The number of steps hardly grows
/// with the picture.
class LaplaceSolver {
public:
    LaplaceSolver(int width, int height, std::span<const std::uint8_t> right, std::span<const std::uint8_t> down,
                  std::span<const float> anchors);
    ~LaplaceSolver();

    /// Solves for values in [0, 1] about, to some 1e-4. `solution` holds the first guess and gets the result. Any
    /// number of threads may solve at the same time. Returns the number of steps, and stops early when `cancel` is set.
    int solve(std::span<const float> sources, std::span<float> solution,
              const std::atomic<bool> *cancel = nullptr) const;

private:
    struct Grid;
    struct Memory;
    void smooth(const Grid &grid, const std::vector<float> &right, std::vector<float> &u, bool redFirst) const;
    void cycle(std::size_t level, Memory &memory) const;

    std::vector<Grid> m_grids;
};

} // namespace suffuse::curves
