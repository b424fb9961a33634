// What both kernels do with a stroke's sums at a pixel: eq 17-23.
#pragma once

#include "tests/bench/cuda/paper_device.h"
// Before the templates that call its functions.
#include "render/math/scalar.h"

#include "render/math/colour.h"

namespace suffuse::baseline {

/// φ, and Σφ_kC_k where colours vary.
struct Sums {
    float density = 0;
    float colour[4] = {0, 0, 0, 0};
};

__device__ inline float modifiedDensity(const ShadeRecord &s, float phi)
{
    if (s.kind == 0)
        return fmaxf(0.0f, (1 / (1 + __expf((s.xi1 - phi) / s.xi2)) - s.f0) * s.gain);
    const float safe = fmaxf(phi, 1e-10f);
    if (s.kind == 1)
        return fminf(1.0f, exp2f(s.xi2 * log2f(safe / s.xi1)));
    const float u = s.xi1 / safe, v = s.xi2 / safe, u3 = u * u * u;
    const float f = s.xi3 * (u3 * u3 - v * v * v + 1);
    return phi < s.cut ? 0.0f : fminf(1.0f, fmaxf(0.0f, f));
}

/// Mixes the stroke into the RYB backdrop.
__device__ inline void mix(const ShadeRecord &s, const Sums &sums, float3 &backdrop)
{
    if (!(sums.density > 0))
        return;
    const float inverse = 1 / fmaxf(sums.density, 1e-36f);
    float colour[4];
    for (int c = 0; c < 4; ++c)
        colour[c] = s.varies ? fminf(1.0f, sums.colour[c] * inverse) : s.colour[c];
    const float w = modifiedDensity(s, sums.density) * colour[3];
    backdrop.x = math::mixed(backdrop.x, colour[0], w, s.keep);
    backdrop.y = math::mixed(backdrop.y, colour[1], w, s.keep);
    backdrop.z = math::mixed(backdrop.z, colour[2], w, s.keep);
}

__device__ inline float4 finished(float3 ryb)
{
    const math::Triple<float> rgb = math::rgbFromRyb(ryb.x, ryb.y, ryb.z);
    return make_float4(rgb.x, rgb.y, rgb.z, 1);
}

} // namespace suffuse::baseline
