// The paper's method as a device likes it: all strokes in one launch, tiles of 16 × 16 pixels.
#pragma once

#include "tests/bench/cuda/shading.cuh"

namespace suffuse::baseline {

inline constexpr int tileSide = 16;
inline constexpr int macroSide = 128;
inline constexpr int rowsOfThread = 4; ///< pixels of a thread, one under another
inline constexpr int tileThreads = tileSide * tileSide / rowsOfThread;
inline constexpr int batch = 32; ///< segments in shared memory
inline constexpr int listThreads = 1024;

/// Whether a segment reaches one of the pixels' centres of a square of `side` pixels at (left, top).
__device__ inline bool reaches(float4 circle, float left, float top, float side)
{
    const float x = fminf(fmaxf(circle.x, left + 0.5f), left + side - 0.5f) - circle.x;
    const float y = fminf(fmaxf(circle.y, top + 0.5f), top + side - 0.5f) - circle.y;
    return x * x + y * y < circle.z * circle.z;
}

/// The segments that reach each macro-tile, in document order: a block a macro-tile. `circles`: midpoint and reach.
__global__ void __launch_bounds__(listThreads)
    listSegments(const float4 *__restrict__ circles, int segments, int macroColumns, std::uint32_t *lists,
                 std::uint32_t room, std::uint32_t *counts)
{
    __shared__ int warpSums[listThreads / 32];
    const float left = float(blockIdx.x % macroColumns) * macroSide, top = float(blockIdx.x / macroColumns) * macroSide;
    const int lane = threadIdx.x % 32, warp = threadIdx.x / 32;
    std::uint32_t *list = lists + std::size_t(blockIdx.x) * room;
    int count = 0;
    for (int base = 0; base < segments; base += listThreads) {
        const int i = base + int(threadIdx.x);
        const bool hit = i < segments && reaches(circles[i], left, top, macroSide);
        const unsigned hits = __ballot_sync(~0u, hit);
        if (lane == 0)
            warpSums[warp] = __popc(hits);
        __syncthreads();
        int before = warpSums[lane]; // of all warps, then summed up to each
        for (int step = 1; step < 32; step *= 2) {
            const int other = __shfl_up_sync(~0u, before, step);
            before += lane >= step ? other : 0;
        }
        const int place = __shfl_sync(~0u, before, warp) - __popc(hits) + __popc(hits & ((1u << lane) - 1));
        if (hit)
            list[count + place] = std::uint32_t(i);
        count += __shfl_sync(~0u, before, 31);
        __syncthreads();
    }
    if (threadIdx.x == 0)
        counts[blockIdx.x] = std::uint32_t(count);
}

__device__ inline float specialExp2(float x)
{
    float y;
    asm("ex2.approx.ftz.f32 %0, %1;" : "=f"(y) : "f"(x));
    return y;
}

/// 2^x for x ≤ 127 in the multiply-add units: the whole part from the low bits of x + 1.5·2²³, the rest a polynomial.
__device__ inline float polynomialExp2(float x)
{
    x = fmaxf(x, -126.0f);
    const float shifted = x + 12582912.0f, f = x - (shifted - 12582912.0f);
    float p = fmaf(1.32647425e-3f, f, 9.671518e-3f);
    p = fmaf(p, f, 5.55073376e-2f);
    p = fmaf(p, f, 2.4022242e-1f);
    p = fmaf(p, f, 6.93146978e-1f);
    p = fmaf(p, f, 1.0f);
    return __int_as_float(__float_as_int(p) + (__float_as_int(shifted) << 23));
}

/// A batch of segments, relative to the tile's corner.
template <int points>
struct Stage {
    float4 circle[batch]; ///< x, y, reach², scale
    float4 colour[batch];
    std::uint32_t stroke[batch];
    float4 point[batch][points]; ///< x·scale, y·scale, exponent
    std::uint32_t chosen[tileThreads];
    int chosenOfWarp[2];
};

/// Those of up to 64 listed segments that reach the tile, in order, into stage.chosen; returns how many.
template <int points>
__device__ inline int choose(Stage<points> &stage, const std::uint32_t *list, int left, const float4 *circles, float x,
                             float y)
{
    const int lane = threadIdx.x % 32, warp = threadIdx.x / 32;
    const std::uint32_t id = int(threadIdx.x) < left ? list[threadIdx.x] : 0;
    const bool hit = int(threadIdx.x) < left && reaches(circles[id], x, y, tileSide);
    const unsigned hits = __ballot_sync(~0u, hit);
    if (lane == 0)
        stage.chosenOfWarp[warp] = __popc(hits);
    __syncthreads();
    if (hit)
        stage.chosen[(warp > 0 ? stage.chosenOfWarp[0] : 0) + __popc(hits & ((1u << lane) - 1))] = id;
    const int count = stage.chosenOfWarp[0] + stage.chosenOfWarp[1];
    __syncthreads();
    return count;
}

template <int points>
__device__ inline void load(Stage<points> &stage, int from, int count, const QuadratureRecord *segments, float x,
                            float y)
{
    for (int i = threadIdx.x; i < count * points; i += tileThreads) {
        const int k = i / points, p = i % points;
        const QuadratureRecord &s = segments[stage.chosen[from + k]];
        stage.point[k][p] = make_float4((s.x[p] - x) * s.scale, (s.y[p] - y) * s.scale, s.exponent[p], 0);
    }
    if (int(threadIdx.x) < count) {
        const QuadratureRecord &s = segments[stage.chosen[from + threadIdx.x]];
        stage.circle[threadIdx.x] = make_float4(s.middleX - x, s.middleY - y, s.reach * s.reach, s.scale);
        stage.colour[threadIdx.x] = make_float4(s.colour[0], s.colour[1], s.colour[2], s.colour[3]);
        stage.stroke[threadIdx.x] = s.stroke;
    }
}

/// Adds segment k of the batch to the sums of a thread's pixels, the first at (x, y) in the tile. Operations: 5 a pixel
/// and point and 3 a point, the test 4, sums 1 or 9.
template <int points, int polynomials>
__device__ inline void addSegment(const Stage<points> &stage, int k, bool varies, float x, float y, Sums *sums)
{
    const float4 circle = stage.circle[k];
    const float dx = x - circle.x, dx2 = dx * dx, u = x * circle.w;
    bool inside[rowsOfThread], any = false;
    float v[rowsOfThread], phi[rowsOfThread] = {};
#pragma unroll
    for (int r = 0; r < rowsOfThread; ++r) {
        const float dy = y + r - circle.y;
        inside[r] = fmaf(dy, dy, dx2) < circle.z;
        any = any || inside[r];
        v[r] = (y + r) * circle.w;
    }
    if (!any)
        return;
#pragma unroll
    for (int p = 0; p < points; ++p) {
        const float4 point = stage.point[k][p];
        const float across = u - point.x, rest = fmaf(-across, across, point.z);
#pragma unroll
        for (int r = 0; r < rowsOfThread; ++r) {
            const float d = v[r] - point.y, e = fmaf(-d, d, rest);
            phi[r] += p < points - polynomials ? specialExp2(e) : polynomialExp2(e);
        }
    }
    const float4 c = stage.colour[k];
#pragma unroll
    for (int r = 0; r < rowsOfThread; ++r) {
        const float part = inside[r] ? phi[r] : 0;
        sums[r].density += part;
        if (varies) {
            sums[r].colour[0] = fmaf(part, c.x, sums[r].colour[0]);
            sums[r].colour[1] = fmaf(part, c.y, sums[r].colour[1]);
            sums[r].colour[2] = fmaf(part, c.z, sums[r].colour[2]);
            sums[r].colour[3] = fmaf(part, c.w, sums[r].colour[3]);
        }
    }
}

struct PortScene {
    const float4 *circles;
    const QuadratureRecord *segments;
    const ShadeRecord *strokes;
    const std::uint32_t *lists;
    const std::uint32_t *counts;
    std::uint32_t room;
    int macroColumns;
    int width, height;
    float3 background;
};

__device__ inline void mixStroke(const ShadeRecord &stroke, Sums *sums, float3 *backdrop)
{
#pragma unroll
    for (int r = 0; r < rowsOfThread; ++r) {
        mix(stroke, sums[r], backdrop[r]);
        sums[r] = Sums();
    }
}

/// A tile: 64 threads of four pixels each.
template <int points, int polynomials>
__global__ void __launch_bounds__(tileThreads, 12) paintTile(PortScene scene, float4 *canvas)
{
    __shared__ Stage<points> stage;
    const int left = blockIdx.x * tileSide, top = blockIdx.y * tileSide;
    const int column = threadIdx.x % tileSide, row = int(threadIdx.x) / tileSide * rowsOfThread;
    const int macro = top / macroSide * scene.macroColumns + left / macroSide;
    const std::uint32_t *list = scene.lists + std::size_t(macro) * scene.room;
    const int listed = int(scene.counts[macro]);
    float3 backdrop[rowsOfThread];
    for (float3 &b : backdrop)
        b = scene.background;
    Sums sums[rowsOfThread];
    std::uint32_t stroke = ~0u;
    bool varies = false;
    for (int base = 0; base < listed; base += tileThreads) {
        const int chosen = choose(stage, list + base, listed - base, scene.circles, float(left), float(top));
        for (int from = 0; from < chosen; from += batch) {
            const int count = min(batch, chosen - from);
            load(stage, from, count, scene.segments, float(left), float(top));
            __syncthreads();
            for (int k = 0; k < count; ++k) {
                if (stage.stroke[k] != stroke) {
                    if (stroke != ~0u)
                        mixStroke(scene.strokes[stroke], sums, backdrop);
                    stroke = stage.stroke[k];
                    varies = scene.strokes[stroke].varies != 0;
                }
                addSegment<points, polynomials>(stage, k, varies, column + 0.5f, row + 0.5f, sums);
            }
            __syncthreads();
        }
    }
    if (stroke != ~0u)
        mixStroke(scene.strokes[stroke], sums, backdrop);
    for (int r = 0; r < rowsOfThread; ++r)
        if (left + column < scene.width && top + row + r < scene.height)
            canvas[std::size_t(top + row + r) * scene.width + left + column] = finished(backdrop[r]);
}

} // namespace suffuse::baseline
