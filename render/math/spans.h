// What merging a span of nodes does (docs/solver.md, "Level 1"), as far as host and device have it in common. The rest
// is written twice, as SIMD in render/nodes and as a program of a warp in render/cuda, with the same sums in the same
// order: both get the same bits. The header is C++17, since .cu files include it.
#pragma once

#include "render/math/panels.h"

namespace suffuse::spans {

inline constexpr int mostFine = 128; ///< A window of more nodes is halved.
inline constexpr int mostNodes = 24; ///< of a rule
inline constexpr int values = 5;     ///< R, Y, B, opacity, ω
inline constexpr int moments = 2 + values;
inline constexpr int places = 4 * mostNodes;
inline constexpr int bends = 6;
/// Runs are summed up in so many parts, the i-th node in part i % parts, and then ((0+1)+(2+3))+((4+5)+(6+7)).
inline constexpr int parts = 8;

/// Holds what is the same for all runs. The host makes it once.
struct Tables {
    double bend[bends];                           ///< the numbers a
    double even[bends][mostNodes + 1][mostNodes]; ///< where the roots of each polynomial lie if the run is even
    alignas(64) double place[bends][places]; ///< between which roots are looked for, from the least to the greatest
};

/// Returns which of the numbers a belongs to a length, in spreads.
SUFFUSE_INLINE int bendOf(const Tables &tables, double arc)
{
    const double wanted = 0.65 + 0.047 * arc;
    int i = 0;
    while (i + 1 < bends && tables.bend[i + 1] <= wanted)
        ++i;
    return i;
}

/// Returns the sine of an angle of −1.4 to 1.4, exact to 1e-10.
SUFFUSE_INLINE double sine(double x)
{
    const double xx = x * x;
    double p = 1;
    p = 1 - xx * p * (1.0 / 156);
    p = 1 - xx * p * (1.0 / 110);
    p = 1 - xx * p * (1.0 / 72);
    p = 1 - xx * p * (1.0 / 42);
    p = 1 - xx * p * (1.0 / 20);
    p = 1 - xx * p * (1.0 / 6);
    return x * p;
}

inline constexpr double share = 0.5;     ///< the part of the tolerance that merging may use
inline constexpr double windowSize = 16; ///< the largest window, in spreads and 1.5 times radians
inline constexpr int fewest = 3;         ///< the least number of fine nodes that is worth merging
inline constexpr int smallest = 6;       ///< A window of so many fine nodes is not halved.
/// A rule that is expected to need so many more nodes than there may be is not tried.
inline constexpr int tooMany = 2;

/// Returns the weight of turning between two steps of the directions a and b.
SUFFUSE_INLINE double turning(panels::Vector a, panels::Vector b)
{
    return 1.5 * std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
}

/// Returns how many nodes a window usually takes, as windows of the sample paintings do: within 1.5 for three quarters
/// of them.
SUFFUSE_INLINE double usualNodes(double size, double arc, double mass, double tolerance, bool vary)
{
    return 1.15 * size + 1.05 * panels::logarithm(mass / (tolerance * (arc + 1))) + (vary ? 1.2 : 0.0) - 6.4;
}

/// Decides which rules of a window are tried, one after the other.
struct Search {
    double expected;
    int n, most;
    int best = 0, failed = 0;

    SUFFUSE_INLINE Search(double usual, double excess, int count)
        : expected(usual), n(int(std::lround(usual + excess))), most(count - 1 < mostNodes ? count - 1 : mostNodes)
    {
        n = n < most ? n : most;
        n = n > 1 ? n : 1;
    }
    /// Takes the error of the rule of n nodes, in units of what is allowed. Returns true if the search ends; otherwise
    /// n is to be tried next.
    SUFFUSE_INLINE bool take(double error)
    {
        if (error <= 1) {
            best = n;
            if (n - 1 == failed || error > 0.3) // One node less would seldom pass.
                return true;
            --n;
            return false;
        }
        // Another node makes the error two or three times smaller.
        const double steps = error < 1e300 ? 1.1 * panels::logarithm(error) : 1000.0;
        const int missing = steps > 1 ? int(steps) : 1;
        failed = n;
        if (best || n == most || n + missing > most + 1)
            return true;
        const int next = n + (missing < 3 ? missing : 3);
        n = next < most ? next : most;
        return false;
    }
    /// Returns how many more nodes than usual the next part of the window is expected to take.
    SUFFUSE_INLINE double excess() const { return 0.4 * (best - expected); }
};

/// Finds the roots of polynomial n as the eigenvalues of the Jacobi matrix, by the QL method with implicit shifts in
/// the form without square roots (Pal, Walker and Kahan). `e2` has room for n numbers.
SUFFUSE_SHARED void eigenvalues(int n, const double *alpha, const double *beta, double *d, double *e2)
{
    for (int i = 0; i < n; ++i) { // e2 has the squares of the entries beside the diagonal.
        d[i] = alpha[i];
        e2[i] = i + 1 < n ? beta[i + 1] * beta[i + 1] : 0;
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
            const double root = std::sqrt(p * p + 1);
            const double shift = d[first] - e / (p + (p < 0 ? -root : root));
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
    for (int i = 1; i < n; ++i) { // There are few, and most are in order.
        const double own = d[i];
        int at = i;
        for (; at > 0 && d[at - 1] > own; --at)
            d[at] = d[at - 1];
        d[at] = own;
    }
}

/// The grid on which the density of a run is compared, along the chord from its first node, in spreads.
struct Grid {
    static constexpr int side = 40; ///< points along an axis at most

    double left, top; ///< the first point
    float step;
    int columns, rows; ///< multiples of 8 and 4

    /// Lays the grid over all that nodes in a box reach, so fine that no ripple of their sum falls between its points.
    SUFFUSE_INLINE Grid(double boxLeft, double boxTop, double boxRight, double boxBottom)
    {
        // What merging adds has no waves shorter than 0.9, and falls off as fast as the density.
        constexpr double finestStep = 0.55, margin = 1.3;
        // Across a run that is straight the difference falls off as the density does, so that few rows are enough.
        const bool straight = boxBottom - boxTop < 0.02;
        const double width = boxRight - boxLeft + 2 * margin, height = boxBottom - boxTop + 2 * margin;
        const double longest = (width > height ? width : height) / (side - 2);
        const double wide = finestStep > longest ? finestStep : longest;
        left = boxLeft - margin;
        top = straight ? 0.5 * (boxTop + boxBottom) - wide : boxTop - margin;
        step = float(wide);
        columns = (int(width / wide) + 2 + 7) / 8 * 8;
        rows = straight ? 4 : (int(height / wide) + 2 + 3) / 4 * 4;
    }
};

/// Farther than so many spreads away there is less than 1.2e-7.
inline constexpr float reach = 4;

/// Returns e^(−(i·step − at)²), exact to 2e-7, or 0 where that is farther than `reach`.
SUFFUSE_INLINE float gaussian(int i, float step, float at)
{
    const float d = float(i) * step - at;
    if (!(std::fabs(d) <= reach))
        return 0;
    const float e = -1.44269504f * d * d, x = e > -60.0f ? e : -60.0f;
    const auto whole = std::int32_t(x + -0.5f); // 2^x = 2^whole 2^f with |f| ≤ ½
    const float f = x - float(whole);
    float p = 1.32647425e-3f;
    p = p * f + 9.671518e-3f;
    p = p * f + 5.55073376e-2f;
    p = p * f + 2.4022242e-1f;
    p = p * f + 6.93146978e-1f;
    p = p * f + 1.0f;
    const std::int32_t bits = (whole + 127) << 23;
    float power = 0;
    std::memcpy(&power, &bits, sizeof power);
    return p * power;
}

} // namespace suffuse::spans
