#include "render/compare.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse {

Result<PictureDifference> compare(const FloatPicture &a, const FloatPicture &b)
{
    if (a.width != b.width || a.height != b.height)
        return Error{QCoreApplication::translate(
                         "compare", "The pictures differ in size (%1 × %2 and %3 × %4): render both at one size.")
                         .arg(a.width)
                         .arg(a.height)
                         .arg(b.width)
                         .arg(b.height)};
    PictureDifference result;
    result.pixels = std::size_t(a.width) * std::size_t(a.height);
    double worst = -1;
    for (std::size_t p = 0; p < result.pixels; ++p) {
        const float *const u = &a.rgba[4 * p], *const v = &b.rgba[4 * p];
        double here = 0;
        for (std::size_t c = 0; c < 4; ++c) {
            const bool isColour = c < 3;
            double difference =
                std::abs((isColour ? double(u[c]) * u[3] : u[c]) - (isColour ? double(v[c]) * v[3] : v[c]));
            if (!std::isfinite(difference))
                difference = std::numeric_limits<double>::infinity();
            result.maximum[c] = std::max(result.maximum[c], difference);
            result.mean[c] += difference / double(result.pixels);
            here = std::max(here, difference);
        }
        result.over += here > pictureTolerance ? 1 : 0;
        result.notFinite += std::isinf(here) ? 1 : 0;
        if (here > worst) {
            worst = here;
            result.x = int(p % std::size_t(a.width));
            result.y = int(p / std::size_t(a.width));
            std::copy_n(u, 4, result.first.begin());
            std::copy_n(v, 4, result.second.begin());
        }
    }
    return result;
}

} // namespace suffuse
