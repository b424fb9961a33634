#include "render/fitting/fit_plan.h"

#include <algorithm>
#include <cmath>

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

} // namespace

std::vector<FitPhase> planOf(int have, int strokes, bool byError, int steps, int width, int height)
{
    std::vector<FitPhase> out;
    const auto part = [steps](double share) { return std::max(1, int(std::lround(steps * share))); };
    const std::vector<int> counts = countsOf(have, strokes, byError);
    for (const int count : counts)
        out.push_back({count, true, halvingsFor(2, width, height),
                       part(growingShare / (byError ? 3 : double(counts.size()))), 0, 1, byError ? 0.1 : 0.3});
    for (int k = 0; k < moves; ++k)
        out.push_back({strokes, false, halvingsFor(1, width, height), part(movingShare / moves), movedShare, 1, 0.3});
    out.push_back({strokes, false, 0, part(1 - growingShare - movingShare), 0, 0.6, 0.03});
    return out;
}

} // namespace suffuse::fitting
