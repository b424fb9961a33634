#include "model/brush/brush_width.h"

#include "model/paint/half_width.h"

#include <algorithm>

namespace suffuse {

namespace {

/// The brush without what is random.
Brush steady(Brush brush)
{
    for (BrushDynamic &dynamic : brush.dynamics)
        if (dynamic.input == BrushInput::StrokeRandom || dynamic.input == BrushInput::Drift) {
            const auto mean = float(dynamic.curve.at(0.5));
            dynamic.curve = {{{0, mean}, {1, mean}}};
        }
    return brush;
}

} // namespace

double halfWidthOf(const Brush &brush, const PenState &pen)
{
    const Paint paint = paintAt(steady(brush), pen, 0);
    const double spread = spreadOf(brush, paint.size, paint.maxAge);
    return halfWidth(spread * spread / (4 * paint.maxAge), densityOfPeak(paint.peak, spread), paint.maxAge,
                     visibleCut(brush.style));
}

double spreadOf(const Brush &brush, const PenState &pen)
{
    const Paint paint = paintAt(steady(brush), pen, 0);
    return spreadOf(brush, paint.size, paint.maxAge);
}

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
