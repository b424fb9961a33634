// A device in host memory that runs the kernels' own programs, lane after lane.
#pragma once

#include "render/cuda/device.h"

#include <cstddef>
#include <map>

namespace suffuse::test {

class EmulatedDevice : public cuda::Device {
public:
    /// `memory`: bytes that it has.
    explicit EmulatedDevice(std::size_t memory = std::size_t(1) << 30) : m_memory(memory) {}
    ~EmulatedDevice() override;

    std::string name() const override { return "emulated"; }
    std::size_t freeMemory() const override { return m_memory - m_used; }
    cuda::Fault allocate(std::size_t bytes, void **memory) override;
    void release(void *memory) override;
    cuda::Fault allocateHost(std::size_t bytes, void **memory) override;
    void releaseHost(void *memory) override;
    cuda::Fault upload(void *to, const void *from, std::size_t bytes) override;
    cuda::Fault download(void *to, const void *from, std::size_t bytes) override;
    cuda::Fault copy(void *to, const void *from, std::size_t bytes) override;
    cuda::Fault copyRects(std::uint32_t *to, const std::uint32_t *from, int rowPixels, const int (*rects)[4],
                          int count) override;
    cuda::Fault clear(void *memory, std::size_t bytes) override;
    cuda::Fault run(const cuda::Frame &frame, cuda::Work work) override;
    cuda::Fault finish(double *milliseconds) override;
    std::unique_ptr<cuda::GlTexture> registerTexture(unsigned texture, cuda::Fault &fault) override;

    /// What was asked of it so far.
    struct Counts {
        std::size_t uploaded = 0; ///< bytes
        std::size_t runs = 0, tiles = 0, plainTiles = 0;
        std::size_t haveUnder = 0, applyOver = 0; ///< tiles that used layers
        std::uint32_t longestList = 0;
    };
    Counts counts;

private:
    bool holds(const void *memory, std::size_t bytes) const;

    std::size_t m_memory, m_used = 0;
    std::map<const std::byte *, std::size_t> m_blocks; ///< sizes of the device's memory, by address
};

} // namespace suffuse::test
