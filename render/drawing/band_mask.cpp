#include "render/drawing/band_mask.h"

#include <cmath>

namespace suffuse {

namespace {

/// Masks reach so much farther than their paths that their own border is nowhere seen, canvas units.
constexpr double maskMargin = 3;

/// Renderers take curves for lines to within a tenth of a pixel, which shows where opacity changes steeply. Bands are
/// cut into pieces that lie so near to lines, canvas units: the nearer the more bands there are, as these may lie close
/// together, and where opacity jumps by a step of many levels, so near that it is off by less than half a usual step.
double bendFor(int bands, int step)
{
    return std::min(100.0 / (double(bands) * bands), 100.0 / (double(bands) * std::max(step, 1)));
}

int levelOf(const contours::Band &band)
{
    return int(std::lround(255 * std::clamp(band.opacity, 0.0, 1.0)));
}

Rect boxOf(const std::vector<contours::Band> &bands)
{
    Rect box;
    for (const contours::Band &band : bands)
        for (const std::vector<Cubic> &loop : band.loops)
            for (const Cubic &curve : loop)
                box = box.united(curve.controlBox());
    box = box.grown(maskMargin);
    return {std::floor(box.left), std::floor(box.top), std::ceil(box.right), std::ceil(box.bottom)};
}

} // namespace

BandMask bandMaskOf(const DrawnStroke &drawn, int bandCount)
{
    // While bands become more opaque, each takes its step outside; where they become fainter, inside. Where they
    // become more opaque again (within a rim) that is gentle, and each may lie over the one around it.
    const std::vector<contours::Band> &bands = drawn.bands;
    std::size_t rising = 1;
    while (rising < bands.size() && bands[rising].opacity > bands[rising - 1].opacity)
        ++rising;
    std::size_t falling = rising;
    while (falling < bands.size() && bands[falling].opacity < bands[falling - 1].opacity)
        ++falling;
    BandMask mask{boxOf(bands), levelOf(bands[rising - 1]), {}};
    for (std::size_t k = 0; k < bands.size(); ++k) {
        const int level = levelOf(bands[k]), step = level - (k > 0 ? levelOf(bands[k - 1]) : 0);
        if (step == 0)
            continue;
        using enum BandMask::Put;
        const double bend = bendFor(bandCount, std::abs(step));
        if (k < rising)
            mask.steps.push_back({&bands[k].loops, Outside, step, bend});
        else
            mask.steps.push_back({&bands[k].loops, k < falling ? Inside : Over, k < falling ? -step : level, bend});
    }
    return mask;
}

} // namespace suffuse
