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
};

} // namespace math

template <>
const gradient::TileKernels<double> &gradient::tileKernels<double>()
{
    static const TileKernels<double> kernels = math::kernelsOf<double>();
    return kernels;
}

} // namespace suffuse
