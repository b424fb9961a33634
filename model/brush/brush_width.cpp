#include "model/brush/brush_width.h"

#include "model/paint/half_width.h"

namespace suffuse {

double halfWidthOf(const Brush &brush)
{
    return halfWidth(double(brush.diffusion), densityOfPeak(double(brush.peak), brush.spread()), double(brush.maxAge),
                     visibleCut(brush.style));
}

double visibleWidth(const Brush &brush)
{
    const double half = halfWidthOf(brush);
    return 2 * (half > 0 ? half : brush.spread());
}

} // namespace suffuse
