// Highway's foreach_target compiles this file once for each SIMD instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/contours/gauss_sums.cpp"
#include "hwy/foreach_target.h" // It comes first, since it includes this file again for each set.

#include "hwy/highway.h"
#include "render/contours/gauss_sums.h"
#include "render/math/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace suffuse::HWY_NAMESPACE {

HWY_INLINE float sumOfLanes(Vec v)
{
    return hn::GetLane(hn::SumOfLanes(Tag(), v));
}

template <int channels>
HWY_INLINE void addSums(const contours::GaussColumns &columns, float atX, float atY, contours::GaussSums &out)
{
    const Tag tag;
    const auto load = [&](const float *from) { return Lanes(hn::LoadU(tag, from)); };
    const Lanes x(atX), y(atY);
    Lanes value[channels], alongX[channels], alongY[channels];
    for (std::size_t i = 0; i < columns.count; i += hn::Lanes(tag)) {
        const Lanes dx = x - load(columns.x + i), dy = y - load(columns.y + i);
        const Lanes b = load(columns.b + i);
        const Lanes u = mulAdd_(load(columns.a + i), dx, b * dy), v = mulAdd_(load(columns.c + i), dy, b * dx);
        const Lanes gauss = exp2Down(mulAdd_(u, dx, v * dy)), gu = gauss * u, gv = gauss * v;
        for (int k = 0; k < channels; ++k) {
            const Lanes weight = load(columns.weight[std::size_t(k)] + i);
            value[k] = mulAdd_(weight, gauss, value[k]);
            alongX[k] = mulAdd_(weight, gu, alongX[k]);
            alongY[k] = mulAdd_(weight, gv, alongY[k]);
        }
    }
    constexpr float perExponent = 2 * 0.69314718f; // of 2^q by dx: 2 ln 2 · u
    for (int k = 0; k < channels; ++k)
        out[std::size_t(k)] = {sumOfLanes(value[k].v), perExponent * sumOfLanes(alongX[k].v),
                               perExponent * sumOfLanes(alongY[k].v)};
}

void sumsOf(const contours::GaussColumns &columns, int channels, float x, float y, contours::GaussSums &out)
{
    if (channels == 1)
        addSums<1>(columns, x, y, out);
    else if (channels == 3)
        addSums<3>(columns, x, y, out);
    else
        addSums<4>(columns, x, y, out);
}

} // namespace suffuse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace suffuse {

HWY_EXPORT(sumsOf);

contours::GaussSums contours::gaussSums(const GaussColumns &columns, int channels, float x, float y)
{
    GaussSums out{};
    HWY_DYNAMIC_DISPATCH(sumsOf)(columns, channels, x, y, out);
    return out;
}

} // namespace suffuse
#endif
