// The paper's kernel as its section 6.1 tells it: "a CUDA thread for each screen pixel", a launch a stroke.
#pragma once

#include "tests/bench/cuda/shading.cuh"

namespace suffuse::baseline {

__constant__ float ruleX[mostPoints];
__constant__ float ruleWeight[mostPoints];

__global__ void clearCanvas(float4 *canvas, int pixels, float3 background)
{
    const int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < pixels)
        canvas[i] = make_float4(background.x, background.y, background.z, 1);
}

__global__ void finishCanvas(float4 *canvas, int pixels)
{
    const int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < pixels)
        canvas[i] = finished(make_float3(canvas[i].x, canvas[i].y, canvas[i].z));
}

/// φ_k at (x, y) by eq 13. Operations: 34 a point, then 5.
template <int points>
__device__ inline float segmentDensity(const CurveRecord &s, float x, float y)
{
    const float inverse = 1 / (s.spread * s.spread);
    float sum = 0;
#pragma unroll
    for (int i = 0; i < points; ++i) {
        const float p = ruleX[i];
        const float dx = x - (s.x[0] + p * (s.x[1] + p * (s.x[2] + p * s.x[3])));
        const float dy = y - (s.y[0] + p * (s.y[1] + p * (s.y[2] + p * s.y[3])));
        const float fx = s.x[1] + p * (2 * s.x[2] + p * (3 * s.x[3]));
        const float fy = s.y[1] + p * (2 * s.y[2] + p * (3 * s.y[3]));
        sum += ruleWeight[i] * sqrtf(fx * fx + fy * fy) * expf(-(dx * dx + dy * dy) * inverse);
    }
    return s.density * 0.31830989f * inverse * sum;
}

/// One stroke into the canvas (RYB), each thread one pixel. Operations: 5 a segment, and 9 a segment within reach.
template <int points>
__global__ void paintStroke(const CurveRecord *__restrict__ curves, ShadeRecord stroke, float4 *canvas, int width,
                            int height)
{
    const int column = blockIdx.x * blockDim.x + threadIdx.x, row = blockIdx.y * blockDim.y + threadIdx.y;
    if (column >= width || row >= height)
        return;
    const float x = float(column) + 0.5f, y = float(row) + 0.5f;
    Sums sums;
    for (std::uint32_t k = 0; k < stroke.segments; ++k) {
        const CurveRecord &s = curves[stroke.firstSegment + k];
        const float dx = x - s.middleX, dy = y - s.middleY;
        if (dx * dx + dy * dy >= s.reach * s.reach)
            continue;
        const float phi = segmentDensity<points>(s, x, y);
        sums.density += phi;
        for (int c = 0; c < 4; ++c)
            sums.colour[c] += phi * s.colour[c];
    }
    float4 &pixel = canvas[std::size_t(row) * width + column];
    float3 backdrop = make_float3(pixel.x, pixel.y, pixel.z);
    mix(stroke, sums, backdrop);
    pixel = make_float4(backdrop.x, backdrop.y, backdrop.z, 1);
}

} // namespace suffuse::baseline
