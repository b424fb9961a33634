// The kernels in double, one pixel at a time: what derivatives in float are checked by.
#include "render/gradient/tile_kernels.h"
#include "render/math/scalar.h"
// This has templates over the numbers of scalar.h, which must be declared before.
#include "render/gradient/tile_kernels-inl.h"

namespace suffuse {

namespace math {

template <>
struct Pixels<double> {
    using Number = double;
    static constexpr int mostCount = 1;
    static constexpr int count() { return 1; }
    static double load(const double *from) { return *from; }
    static void store(double v, double *to) { *to = v; }
    static double ramp() { return 0; }
    static double total(double v) { return v; }
    static double halfErfc(double u, double) { return 0.5 * std::erfc(-u); }
    static std::size_t findNodes(const NodeSearch &search, std::uint32_t *found)
    {
        constexpr float half = 0.5f * (tileSide - 1);
        std::size_t count = 0;
        for (std::uint32_t i = search.first; i < search.end; ++i) {
            const float across = search.x[i] - (search.left + half);
            const float dx = std::max((search.leftwards ? across : std::fabs(across)) - half, 0.0f);
            const float dy = std::max(std::fabs(search.y[i] - (search.top + half)) - half, 0.0f);
            if (dx * dx + dy * dy <= search.near * search.near)
                found[count++] = i;
        }
        return count;
    }
};

} // namespace math

template <>
const gradient::TileKernels<double> &gradient::tileKernels<double>()
{
    static const TileKernels<double> kernels = math::kernelsOf<double>();
    return kernels;
}

} // namespace suffuse
