// A warp is 32 lanes (threads of a GPU) that do the same at the same time. A program of one warp is written once, as a
// template over the warp on which it runs: DeviceWarp is a warp of a GPU; HostWarp does the same lane after lane, for
// tests and for machines without a GPU.
// Warps that work together are a block. A block has fast memory of its own, the shared memory; it lies in 32 banks, and
// lanes that need different words of one bank wait for each other.
// A program's own variables are the same in all lanes. What differs by lane is a Var, and is used inside `each`. There,
// a lane sees what other lanes write to shared memory only after `each` has ended.
#pragma once

#include "render/math/compat.h"

#include <cstdint>

#ifdef __CUDACC__
#include <cuda_pipeline.h>
#define SUFFUSE_PROGRAM __device__ __forceinline__
#define SUFFUSE_CALL static __device__ __noinline__
#define SUFFUSE_UNROLL _Pragma("unroll")
#define SUFFUSE_UNROLL_BY_2 _Pragma("unroll 2")
#define SUFFUSE_UNROLL_BY_4 _Pragma("unroll 4")
#define SUFFUSE_ROLLED _Pragma("unroll 1")
// A function that is called does not know in which memory its references lie, and loads that may go anywhere are
// slower. These say that it is shared memory, or what a kernel was launched with.
#define SUFFUSE_IN_SHARED(reference) __builtin_assume(__isShared(&(reference)))
#define SUFFUSE_IS_LAUNCHED(reference) __builtin_assume(__isGridConstant(&(reference)))
#else
#include <array>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <utility>
#define SUFFUSE_PROGRAM inline
#define SUFFUSE_CALL static inline
#define SUFFUSE_UNROLL
#define SUFFUSE_UNROLL_BY_2
#define SUFFUSE_UNROLL_BY_4
#define SUFFUSE_ROLLED
#define SUFFUSE_IN_SHARED(reference)
#define SUFFUSE_IS_LAUNCHED(reference)
#endif

namespace suffuse::cuda {

inline constexpr int warpLanes = 32;
inline constexpr int fetchBytes = 16;

/// Four numbers that are read and written together.
struct alignas(16) Four {
    float x, y, z, w;
};
/// Two such numbers.
struct alignas(8) Two {
    float x, y;
};

#ifdef __CUDACC__

class DeviceWarp {
public:
    template <class T>
    struct Var {
        T value;
        SUFFUSE_PROGRAM T &operator[](int) { return value; }
        SUFFUSE_PROGRAM const T &operator[](int) const { return value; }
    };

    SUFFUSE_PROGRAM DeviceWarp() : m_lane(int(threadIdx.x) % warpLanes) {}

    template <class F>
    SUFFUSE_PROGRAM void each(F f)
    {
        f(m_lane);
        __syncwarp();
    }
    /// After this, what lanes read outside of `each` may be written to.
    SUFFUSE_PROGRAM void meet() { __syncwarp(); }
    /// Returns a mask whose bit i is f(i).
    template <class F>
    SUFFUSE_PROGRAM std::uint32_t ballot(F f)
    {
        return __ballot_sync(everyLane, f(m_lane));
    }
    template <class F>
    SUFFUSE_PROGRAM bool any(F f)
    {
        return __any_sync(everyLane, f(m_lane)) != 0;
    }
    /// Returns the value of lane `from`.
    template <class T>
    SUFFUSE_PROGRAM T read(const Var<T> &v, int from)
    {
        return __shfl_sync(everyLane, v.value, from);
    }
    /// Returns the sum over all lanes, always added in the same order.
    template <class T>
    SUFFUSE_PROGRAM T sum(const Var<T> &v)
    {
        T s = v.value;
        for (int by = warpLanes / 2; by > 0; by /= 2)
            s += __shfl_xor_sync(everyLane, s, by);
        return s;
    }
    /// Adds to each lane's value those of the lanes before it.
    SUFFUSE_PROGRAM void sumUp(Var<std::uint32_t> &v)
    {
        SUFFUSE_UNROLL
        for (int by = 1; by < warpLanes; by *= 2) {
            const std::uint32_t before = __shfl_up_sync(everyLane, v.value, by);
            v.value += m_lane >= by ? before : 0;
        }
    }
    template <class T>
    SUFFUSE_PROGRAM T least(const Var<T> &v)
    {
        T s = v.value;
        for (int by = warpLanes / 2; by > 0; by /= 2)
            s = fmin(s, __shfl_xor_sync(everyLane, s, by));
        return s;
    }
    /// Makes each lane's value the sum over its eight lanes (0 to 7, 8 to 15, …): ((0+1)+(2+3))+((4+5)+(6+7)).
    template <class T>
    SUFFUSE_PROGRAM void sumEights(Var<T> &v)
    {
        SUFFUSE_UNROLL
        for (int by = 1; by < 8; by *= 2)
            v.value += __shfl_xor_sync(everyLane, v.value, by);
    }
    /// Makes each lane's value the sum over its four lanes: (0+1)+(2+3).
    template <class T>
    SUFFUSE_PROGRAM void sumFours(Var<T> &v)
    {
        SUFFUSE_UNROLL
        for (int by = 1; by < 4; by *= 2)
            v.value += __shfl_xor_sync(everyLane, v.value, by);
    }
    /// Sets the value of lane `to`.
    template <class T>
    SUFFUSE_PROGRAM void put(Var<T> &v, int to, T value)
    {
        v.value = m_lane == to ? value : v.value;
    }
    /// Starts copies of 16 bytes to shared memory in each lane: copy(lane, start) calls start(to, from) as often as it
    /// likes. They have arrived after `arrive`, which may leave the copies of the last `fetch` on their way.
    template <class Copy>
    SUFFUSE_PROGRAM void fetch(Copy copy)
    {
        copy(m_lane, [](void *to, const void *from) { __pipeline_memcpy_async(to, from, fetchBytes); });
        __pipeline_commit();
    }
    SUFFUSE_PROGRAM void arrive(bool allButLast)
    {
        if (allButLast)
            __pipeline_wait_prior(1);
        else
            __pipeline_wait_prior(0);
        __syncwarp();
    }
    /// Returns how many bits of a mask are set below that of a lane.
    static SUFFUSE_PROGRAM int rank(std::uint32_t mask, int lane) { return __popc(mask & ((1u << lane) - 1)); }
    static SUFFUSE_PROGRAM int count(std::uint32_t mask) { return __popc(mask); }
    static SUFFUSE_PROGRAM int lowest(std::uint32_t mask) { return __ffs(int(mask)) - 1; }
    /// Makes a word at least `to`. Other warps may change it at the same time.
    static SUFFUSE_PROGRAM void raise(std::uint32_t *word, std::uint32_t to) { atomicMax(word, to); }
    /// Adds to a word, and returns what it was before.
    static SUFFUSE_PROGRAM std::uint32_t add(std::uint32_t *word, std::uint32_t value)
    {
        return atomicAdd(word, value);
    }
    /// Adds to a word once, and returns in all lanes what it was before.
    SUFFUSE_PROGRAM std::uint32_t take(std::uint32_t *word, std::uint32_t count = 1)
    {
        return __shfl_sync(everyLane, m_lane == 0 ? atomicAdd(word, count) : 0, 0);
    }
    /// Sets a word. Whoever finds the value by `await` or `look` finds what this warp wrote before, too.
    SUFFUSE_PROGRAM void publish(std::uint32_t *word, std::uint32_t value)
    {
        __threadfence();
        __syncwarp();
        if (m_lane == 0)
            atomicExch(word, value);
        __syncwarp();
    }
    /// Waits in one lane until found(value of a word), and returns the value.
    template <class Found>
    static SUFFUSE_PROGRAM std::uint32_t await(const std::uint32_t *word, Found found)
    {
        const volatile std::uint32_t *now = word;
        std::uint32_t value = *now;
        while (!found(value)) {
#if __CUDA_ARCH__ >= 700
            __nanosleep(200);
#endif
            value = *now;
        }
        __threadfence();
        return value;
    }
    /// Returns what a word is now. Other warps may change it at the same time.
    static SUFFUSE_PROGRAM std::uint32_t look(const std::uint32_t *word)
    {
        const std::uint32_t value = *static_cast<const volatile std::uint32_t *>(word);
        __threadfence();
        return value;
    }
    /// Reads four numbers from an address that is a multiple of 16.
    static SUFFUSE_PROGRAM Four readFour(const float *from)
    {
        const float4 v = *reinterpret_cast<const float4 *>(from);
        return {v.x, v.y, v.z, v.w};
    }
    static SUFFUSE_PROGRAM void writeFour(float *to, const Four &v)
    {
        *reinterpret_cast<float4 *>(to) = make_float4(v.x, v.y, v.z, v.w);
    }
    /// The same for two numbers, and a multiple of 8.
    static SUFFUSE_PROGRAM Two readTwo(const float *from)
    {
        const float2 v = *reinterpret_cast<const float2 *>(from);
        return {v.x, v.y};
    }
    static SUFFUSE_PROGRAM void writeTwo(float *to, const Two &v)
    {
        *reinterpret_cast<float2 *>(to) = make_float2(v.x, v.y);
    }
    /// Reads 16 bytes that another warp has published.
    template <class T>
    static SUFFUSE_PROGRAM T readPublished(const T *from)
    {
        const float4 v = __ldcg(reinterpret_cast<const float4 *>(from));
        return {v.x, v.y, v.z, v.w};
    }

private:
    static constexpr std::uint32_t everyLane = 0xffffffffu;

    int m_lane;
};

/// The warps of a block work on one thing, in phases. After each phase they see what the others wrote. Outside of
/// phases all do the same.
class DeviceBlock {
public:
    using Warp = DeviceWarp;

    SUFFUSE_PROGRAM Warp &warp() { return m_warp; }
    /// Calls f(warp, own) once in each warp.
    template <class F>
    SUFFUSE_PROGRAM void each(F f)
    {
        f(m_warp, int(threadIdx.x) / warpLanes);
        __syncthreads();
    }
    /// Calls f(warp) in one of the warps. The others go on to the next phase meanwhile.
    template <class F>
    SUFFUSE_PROGRAM void one(F f)
    {
        if (threadIdx.x >= blockDim.x - warpLanes)
            f(m_warp);
    }

private:
    DeviceWarp m_warp;
};

#else

class HostWarp {
public:
    template <class T>
    struct Var {
        std::array<T, warpLanes> values{};
        T &operator[](int lane) { return values[std::size_t(lane)]; }
        const T &operator[](int lane) const { return values[std::size_t(lane)]; }
    };

    template <class F>
    void each(F f)
    {
        for (int lane = 0; lane < warpLanes; ++lane)
            f(lane);
    }
    void meet() {}
    template <class F>
    std::uint32_t ballot(F f)
    {
        std::uint32_t mask = 0;
        for (int lane = 0; lane < warpLanes; ++lane)
            mask |= std::uint32_t(bool(f(lane))) << lane;
        return mask;
    }
    template <class F>
    bool any(F f)
    {
        return ballot(f) != 0;
    }
    template <class T>
    T read(const Var<T> &v, int from)
    {
        return v[from];
    }
    template <class T>
    T sum(const Var<T> &v)
    {
        Var<T> s = v;
        for (int by = warpLanes / 2; by > 0; by /= 2)
            for (int lane = 0; lane < by; ++lane)
                s[lane] += s[lane + by];
        return s[0];
    }
    void sumUp(Var<std::uint32_t> &v)
    {
        for (int lane = 1; lane < warpLanes; ++lane)
            v[lane] += v[lane - 1];
    }
    template <class T>
    T least(const Var<T> &v)
    {
        T s = v[0];
        for (const T value : v.values)
            s = value < s ? value : s;
        return s;
    }
    template <class T>
    void sumEights(Var<T> &v)
    {
        for (int i = 0; i < warpLanes; i += 8) {
            const T sum = ((v[i] + v[i + 1]) + (v[i + 2] + v[i + 3])) + ((v[i + 4] + v[i + 5]) + (v[i + 6] + v[i + 7]));
            for (int lane = i; lane < i + 8; ++lane)
                v[lane] = sum;
        }
    }
    template <class T>
    void sumFours(Var<T> &v)
    {
        for (int i = 0; i < warpLanes; i += 4) {
            const T sum = (v[i] + v[i + 1]) + (v[i + 2] + v[i + 3]);
            for (int lane = i; lane < i + 4; ++lane)
                v[lane] = sum;
        }
    }
    template <class T>
    void put(Var<T> &v, int to, T value)
    {
        v[to] = value;
    }
    template <class Copy>
    void fetch(Copy copy)
    {
        for (int lane = 0; lane < warpLanes; ++lane)
            copy(lane, [](void *to, const void *from) { std::memcpy(to, from, fetchBytes); });
    }
    void arrive(bool) {}
    static int rank(std::uint32_t mask, int lane) { return std::popcount(mask & ((1u << lane) - 1)); }
    static int count(std::uint32_t mask) { return std::popcount(mask); }
    static int lowest(std::uint32_t mask) { return std::countr_zero(mask); }
    static void raise(std::uint32_t *word, std::uint32_t to) { *word = *word < to ? to : *word; }
    static std::uint32_t add(std::uint32_t *word, std::uint32_t value) { return std::exchange(*word, *word + value); }
    std::uint32_t take(std::uint32_t *word, std::uint32_t count = 1) { return add(word, count); }
    void publish(std::uint32_t *word, std::uint32_t value) { *word = value; }
    template <class Found>
    static std::uint32_t await(const std::uint32_t *word, Found found)
    {
        if (!found(*word)) // Nobody else is working.
            std::abort();
        return *word;
    }
    static std::uint32_t look(const std::uint32_t *word) { return *word; }
    static Four readFour(const float *from) { return {from[0], from[1], from[2], from[3]}; }
    static void writeFour(float *to, const Four &v) { to[0] = v.x, to[1] = v.y, to[2] = v.z, to[3] = v.w; }
    static Two readTwo(const float *from) { return {from[0], from[1]}; }
    static void writeTwo(float *to, const Two &v) { to[0] = v.x, to[1] = v.y; }
    template <class T>
    static T readPublished(const T *from)
    {
        return *from;
    }
};

template <int warps>
class HostBlock {
public:
    using Warp = HostWarp;

    Warp &warp() { return m_warp; }
    template <class F>
    void each(F f)
    {
        for (int own = 0; own < warps; ++own)
            f(m_warp, own);
    }
    template <class F>
    void one(F f)
    {
        f(m_warp);
    }

private:
    HostWarp m_warp;
};

#endif

} // namespace suffuse::cuda
