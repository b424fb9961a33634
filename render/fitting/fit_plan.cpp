#include "render/fitting/fit_plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::fitting {

namespace {

constexpr int mostHalvings = 2;
constexpr int leastPixels = 6000; ///< Below, a halved picture says too little.
// Of all steps, so great a share is for growing and for moving strokes elsewhere; the rest is for the whole picture.
constexpr double growingShare = 0.25, movingShare = 0.4;
constexpr int moves = 5;            ///< so often strokes are moved elsewhere
constexpr double movedShare = 0.06; ///< so many of them

int halvingsFor(int wanted, int width, int height)
{
    int halvings = 0;
    while (halvings < std::min(wanted, mostHalvings) &&
           (double(width) * height) / double(4 << (2 * halvings)) >= leastPixels)
        ++halvings;
    return halvings;
}

/// How many strokes there are after each growth.
std::vector<int> countsOf(int have, int strokes, bool byError)
{
    std::vector<int> out;
    const double factor = byError ? 1.4 : 2;
    double count = byError ? std::min(strokes, 16) : std::max(std::min(strokes, 8), strokes / 16);
    for (; count < strokes * 0.99; count *= factor)
        if (const int whole = int(std::lround(count)); whole > have)
            out.push_back(whole);
    if (strokes > have)
        out.push_back(strokes);
    return out;
}

/// Gives phases their steps by their shares of all of them. Rounding adds up to no difference.
void shareSteps(std::vector<FitPhase> &phases, const std::vector<double> &shares, double all, int steps, int least)
{
    double passed = 0;
    int given = 0;
    for (std::size_t k = 0; k < phases.size(); ++k) {
        passed += shares[k] / all;
        const int upTo = int(std::lround(steps * passed));
        phases[k].steps = std::max(least, upTo - given);
        given = upTo;
    }
}

} // namespace

std::vector<FitPhase> planOf(int have, int strokes, bool byError, int steps, int width, int height)
{
    std::vector<FitPhase> out;
    std::vector<double> shares;
    const auto add = [&](const FitPhase &phase, double share) {
        out.push_back(phase);
        shares.push_back(share);
    };
    const std::vector<int> counts = countsOf(have, strokes, byError);
    for (const int count : counts)
        add({count, true, halvingsFor(2, width, height), 0, 0, 1, byError ? 0.1 : 0.3},
            growingShare / (byError ? 3 : double(counts.size())));
    for (int k = 0; k < moves; ++k)
        add({strokes, false, halvingsFor(1, width, height), 0, movedShare, 1, 0.3}, movingShare / moves);
    add({strokes, false, 0, 0, 0, 0.6, 0.03}, 1 - growingShare - movingShare);
    // How often strokes grow until an error is reached is not known before, so that does not shorten what follows.
    const double all = byError ? 1 : std::accumulate(shares.begin(), shares.end(), 0.0);
    shareSteps(out, shares, all, steps, byError ? 1 : 0);
    return out;
}

} // namespace suffuse::fitting
