// A device in host memory that runs the kernels' own programs, lane after lane.
#pragma once

#include "render/cuda/device/device.h"

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

namespace suffuse::test {

class EmulatedDevice : public cuda::Device {
public:
    /// When what is asked for is done: with the call, or as late as a stream may do it, in `finish`.
    enum class Timing { AtOnce, Late };
    /// `memory`: bytes that it has.
    explicit EmulatedDevice(std::size_t memory = std::size_t(1) << 30, Timing timing = Timing::AtOnce)
        : m_memory(memory), m_timing(timing)
    {}
    ~EmulatedDevice() override;

    std::string name() const override { return "emulated"; }
    std::size_t freeMemory() const override { return m_memory - m_used; }
    cuda::Fault allocate(std::size_t bytes, void **memory) override;
    void release(void *memory) override;
    cuda::Fault allocateHost(std::size_t bytes, void **memory) override;
    void releaseHost(void *memory) override;
    cuda::Fault upload(void *to, const void *from, std::size_t bytes) override;
    cuda::Fault download(void *to, const void *from, std::size_t bytes) override;
    cuda::Fault copyRects(std::uint32_t *to, const std::uint32_t *from, int rowPixels, const int (*rects)[4],
                          int count) override;
    cuda::Fault clear(void *memory, std::size_t bytes) override;
    cuda::Fault run(const cuda::Frame &frame, cuda::Work work) override;
    cuda::Fault buildNodes(const cuda::NodeWork &work) override;
    std::uint32_t gradientWarps() const override { return 3; }
    cuda::Fault findGradient(const cuda::GradientWork &work) override;
    cuda::Fault finish(double *milliseconds) override;
    std::unique_ptr<cuda::GlTexture> registerTexture(unsigned texture, cuda::Fault &fault) override;

    /// What was asked of it so far.
    struct Counts {
        std::size_t uploaded = 0; ///< bytes
        std::size_t runs = 0, tiles = 0, plainTiles = 0;
        std::size_t haveUnder = 0, applyOver = 0; ///< tiles that used layers
        std::size_t apart = 0;                    ///< strokes at tiles that were evaluated apart
        std::uint32_t longestList = 0;
        std::size_t nodeJobs = 0; ///< jobs for nodes, of which some found no room
    };
    Counts counts;

private:
    using Blocks = std::map<const std::byte *, std::size_t>; ///< sizes by address

    static bool holds(const Blocks &blocks, const void *memory, std::size_t bytes);
    void perform(std::function<void()> work);
    void performLate();
    void makeNodes(cuda::NodeWork work);
    void makeGradient(cuda::GradientWork work);
    void paint(cuda::Frame frame, cuda::Work work);

    std::size_t m_memory, m_used = 0;
    Timing m_timing;
    Blocks m_blocks, m_pinned; ///< of the device, of the host
    std::vector<std::function<void()>> m_late;
};

} // namespace suffuse::test
