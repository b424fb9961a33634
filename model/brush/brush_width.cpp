#include "model/brush/brush_width.h"

#include "model/paint/half_width.h"

#include <algorithm>

namespace suffuse {

double halfWidthOf(const Brush &brush)
{
    return halfWidth(double(brush.diffusion), densityOfPeak(double(brush.peak), brush.spread()), double(brush.maxAge),
                     visibleCut(brush.style));
}

Segment valuesAtFullPressure(const Brush &brush)
{
    Segment segment;
    segment.diffusion = brush.diffusion;
    segment.density = float(densityOfPeak(double(brush.peak), brush.spread()));
    segment.granulation = brush.granulation;
    segment.maxAge = brush.maxAge;
    segment.colour = brush.colour;
    return segment;
}

double visibleWidth(const Brush &brush)
{
    const double half = halfWidthOf(brush);
    return 2 * (half > 0 ? half : brush.spread());
}

void setVisibleWidth(Brush &brush, double width)
{
    constexpr double least = 1e-7, greatest = 1e5;
    brush.setSpread(std::clamp(brush.spread() * width / visibleWidth(brush), least, greatest));
}

} // namespace suffuse
