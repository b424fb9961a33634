#include "model/shaping/erasing/erasure_size.h"

#include "model/paint/derived_figures.h"
#include "model/shaping/erasing/soft_eraser.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

float spreadKey(const Segment &segment)
{
    return segment.diffusion * segment.maxAge;
}

} // namespace

double erasureSpread(const Segment &segment)
{
    return spreadAt(curveDiffusion(segment).across, segment.maxAge);
}

void ErasureSizes::add(const Stroke &stroke)
{
    for (const Segment &segment : stroke.segments)
        add(segment);
}

void ErasureSizes::add(const Segment &segment)
{
    if (!segment.fade)
        return;
    double &most = m_peaks[spreadKey(segment)];
    most = std::max(most, peakDensity(segment.density, erasureSpread(segment)));
}

double ErasureSizes::of(const Segment &segment) const
{
    SoftTip tip{.radius = 1, .way = segment.fade ? SoftWay::Fade : SoftWay::Lift};
    const auto most = m_peaks.find(spreadKey(segment));
    tip.strength = segment.fade && most != m_peaks.end() ? -std::expm1(-most->second) : 0;
    return 2 * erasureSpread(segment) / tip.spread();
}

void widenErasure(Segment &segment, double factor)
{
    constexpr double most = 1e12;
    segment.diffusion = float(std::min(segment.diffusion * factor * factor, most));
    segment.density = float(std::min(segment.density * factor, most));
}

} // namespace suffuse
