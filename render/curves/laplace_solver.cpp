#include "render/curves/laplace_solver.h"

#include <algorithm>
#include <cmath>

namespace suffuse::curves {

namespace {

constexpr int coarsest = 4;      ///< pixels: a grid of that size is solved by sweeps alone
constexpr int coarseSweeps = 16; ///< there, each way
constexpr int sweeps = 2;        ///< on each grid, before and after the smaller one
constexpr int mostSteps = 300;
/// Where the root of the energy norm of the error is below this, a smooth error is below some 1e-4.
constexpr double enough = 5e-4;

double product(const std::vector<float> &a, const std::vector<float> &b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += double(a[i]) * double(b[i]);
    return sum;
}

} // namespace

struct LaplaceSolver::Grid {
    int width = 0, height = 0;
    std::vector<float> right, down; ///< conductances to the next pixels; 0 at the border
    std::vector<float> anchors;
    std::vector<float> inverse; ///< 1 by the sum of all conductances of a pixel

    std::size_t pixels() const { return anchors.size(); }

    void finish()
    {
        inverse.resize(pixels());
        const auto across = std::size_t(width);
        for (std::size_t y = 0, p = 0; y < std::size_t(height); ++y)
            for (std::size_t x = 0; x < across; ++x, ++p) {
                float sum = anchors[p] + right[p] + down[p];
                if (x > 0)
                    sum += right[p - 1];
                if (y > 0)
                    sum += down[p - across];
                inverse[p] = sum > 0 ? 1 / sum : 0;
            }
    }

    /// The sum of neighbours' values times conductances.
    float around(const float *u, std::size_t p, std::size_t x, std::size_t y) const
    {
        const auto across = std::size_t(width);
        float sum = 0;
        if (x + 1 < across)
            sum += right[p] * u[p + 1];
        if (x > 0)
            sum += right[p - 1] * u[p - 1];
        if (y + 1 < std::size_t(height))
            sum += down[p] * u[p + across];
        if (y > 0)
            sum += down[p - across] * u[p - across];
        return sum;
    }

    /// out = A u
    void apply(const std::vector<float> &u, std::vector<float> &out) const
    {
        for (std::size_t y = 0, p = 0; y < std::size_t(height); ++y)
            for (std::size_t x = 0; x < std::size_t(width); ++x, ++p)
                out[p] = inverse[p] > 0 ? u[p] / inverse[p] - around(u.data(), p, x, y) : 0;
    }

    /// The grid of half the size.
    Grid coarser() const
    {
        Grid out;
        out.width = (width + 1) / 2, out.height = (height + 1) / 2;
        const std::size_t count = std::size_t(out.width) * std::size_t(out.height);
        out.right.assign(count, 0), out.down.assign(count, 0), out.anchors.assign(count, 0);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const std::size_t p = std::size_t(y) * std::size_t(width) + std::size_t(x);
                const std::size_t c = std::size_t(y / 2) * std::size_t(out.width) + std::size_t(x / 2);
                out.anchors[c] += anchors[p];
                if (x % 2 == 1)
                    out.right[c] += 0.5f * right[p];
                if (y % 2 == 1)
                    out.down[c] += 0.5f * down[p];
            }
        out.finish();
        return out;
    }
};

/// What one solution needs on each grid.
struct LaplaceSolver::Memory {
    struct Level {
        std::vector<float> u, right, residual;
    };
    std::vector<Level> levels;
};

LaplaceSolver::LaplaceSolver(int width, int height, std::span<const std::uint8_t> right,
                             std::span<const std::uint8_t> down, std::span<const float> anchors)
{
    Grid first;
    first.width = width, first.height = height;
    first.right.assign(right.begin(), right.end());
    first.down.assign(down.begin(), down.end());
    first.anchors.assign(anchors.begin(), anchors.end());
    first.finish();
    m_grids.push_back(std::move(first));
    while (m_grids.back().width > coarsest || m_grids.back().height > coarsest)
        m_grids.push_back(m_grids.back().coarser());
}

LaplaceSolver::~LaplaceSolver() = default;

/// A sweep over the pixels of one colour of a chessboard, and one over the others.
void LaplaceSolver::smooth(const Grid &grid, const std::vector<float> &right, std::vector<float> &u,
                           bool redFirst) const
{
    for (int pass = 0; pass < 2; ++pass) {
        const int colour = (pass == 0) == redFirst ? 0 : 1;
        for (int y = 0; y < grid.height; ++y)
            for (int x = (y + colour) % 2; x < grid.width; x += 2) {
                const std::size_t p = std::size_t(y) * std::size_t(grid.width) + std::size_t(x);
                u[p] = grid.inverse[p] * (right[p] + grid.around(u.data(), p, std::size_t(x), std::size_t(y)));
            }
    }
}

namespace {

/// A pixel of a grid lies between two of the smaller one: three quarters of it belong to the first.
struct Between {
    std::size_t near, far;
};

Between betweenOf(int i, int count)
{
    const int near = i / 2, far = std::clamp(near + (i % 2 ? 1 : -1), 0, count - 1);
    return {std::size_t(near), std::size_t(far)};
}

/// Calls use(pixel, pixel of the smaller grid, share).
template <typename Use>
void forShares(int width, int height, int smallWidth, int smallHeight, Use use)
{
    std::vector<Between> columns;
    for (int x = 0; x < width; ++x)
        columns.push_back(betweenOf(x, smallWidth));
    std::size_t p = 0;
    for (int y = 0; y < height; ++y) {
        const Between row = betweenOf(y, smallHeight);
        const std::size_t near = row.near * std::size_t(smallWidth), far = row.far * std::size_t(smallWidth);
        for (int x = 0; x < width; ++x, ++p) {
            const Between &column = columns[std::size_t(x)];
            use(p, near + column.near, 0.5625f);
            use(p, near + column.far, 0.1875f);
            use(p, far + column.near, 0.1875f);
            use(p, far + column.far, 0.0625f);
        }
    }
}

} // namespace

/// Finds about the solution u of a level's equation, beginning with 0. As a map of its right side it is symmetric.
void LaplaceSolver::cycle(std::size_t level, Memory &memory) const
{
    const Grid &grid = m_grids[level];
    Memory::Level &here = memory.levels[level];
    std::fill(here.u.begin(), here.u.end(), 0.0f);
    const bool isLast = level + 1 == m_grids.size();
    for (int i = 0; i < (isLast ? coarseSweeps : sweeps); ++i)
        smooth(grid, here.right, here.u, true);
    if (!isLast) {
        const Grid &small = m_grids[level + 1];
        Memory::Level &below = memory.levels[level + 1];
        grid.apply(here.u, here.residual);
        std::fill(below.right.begin(), below.right.end(), 0.0f);
        forShares(grid.width, grid.height, small.width, small.height, [&](std::size_t p, std::size_t c, float share) {
            below.right[c] += share * (here.right[p] - here.residual[p]);
        });
        cycle(level + 1, memory);
        forShares(grid.width, grid.height, small.width, small.height,
                  [&](std::size_t p, std::size_t c, float share) { here.u[p] += share * below.u[c]; });
    }
    for (int i = 0; i < (isLast ? coarseSweeps : sweeps); ++i)
        smooth(grid, here.right, here.u, false);
}

int LaplaceSolver::solve(std::span<const float> sources, std::span<float> solution,
                         const std::atomic<bool> *cancel) const
{
    const Grid &grid = m_grids.front();
    Memory memory;
    for (const Grid &g : m_grids) {
        Memory::Level level;
        level.u.resize(g.pixels()), level.right.resize(g.pixels()), level.residual.resize(g.pixels());
        memory.levels.push_back(std::move(level));
    }
    // The right side of the first level is the residual, and its u what the V-cycle makes of that.
    std::vector<float> &residual = memory.levels[0].right, &improved = memory.levels[0].u;
    std::vector<float> u(solution.begin(), solution.end()), direction(u.size()), applied(u.size());
    grid.apply(u, applied);
    for (std::size_t p = 0; p < u.size(); ++p)
        residual[p] = sources[p] - applied[p];
    double before = 0;
    int step = 0;
    for (; step < mostSteps && !(cancel && *cancel); ++step) {
        cycle(0, memory);
        const double error = product(residual, improved);
        if (!(error > enough * enough))
            break;
        const auto kept = float(step > 0 ? error / before : 0);
        before = error;
        for (std::size_t p = 0; p < u.size(); ++p)
            direction[p] = improved[p] + kept * direction[p];
        grid.apply(direction, applied);
        const double bent = product(direction, applied);
        if (!(bent > 0))
            break;
        const auto along = float(error / bent);
        for (std::size_t p = 0; p < u.size(); ++p) {
            u[p] += along * direction[p];
            residual[p] -= along * applied[p];
        }
    }
    std::copy(u.begin(), u.end(), solution.begin());
    return step;
}

} // namespace suffuse::curves
