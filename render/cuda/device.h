// A device that renders: what the host side asks of it, and nothing of how CUDA does it. C++17, no Qt.
#pragma once

#include "render/cuda/records.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace suffuse::cuda {

/// Why a call failed; empty: it did not.
struct Fault {
    enum Kind { None, OutOfMemory, Lost }; ///< Lost: this process can use the device no more
    Kind kind = None;
    std::string what; ///< as the driver says it

    explicit operator bool() const { return kind != None; }
};

/// Which frames' kernels a call needs.
struct Work {
    bool plain = true;   ///< tiles with the flag plainTile
    bool general = true; ///< the others
};

/// An OpenGL texture that the device writes to. Its calls and its end come from the thread whose context is current
/// (the window's), also while another one renders.
class GlTexture {
public:
    virtual ~GlTexture() = default;
    /// Copies rectangles {x, y, width, height} of a picture (device memory, 0xAARRGGBB, `rowPixels` a row) into the
    /// texture; the context that it was registered in.
    virtual Fault copyFrom(const std::uint32_t *picture, int rowPixels, const int (*rects)[4], int count) = 0;
};

/// Calls are made by one thread at a time, but `registerTexture` may be called by the window's while another one
/// renders. After a Fault of kind Lost every call fails.
class Device {
public:
    virtual ~Device() = default;
    virtual std::string name() const = 0; ///< "NVIDIA H100 80GB HBM3"
    /// Bytes free now, at least roughly.
    virtual std::size_t freeMemory() const = 0;

    virtual Fault allocate(std::size_t bytes, void **memory) = 0;
    virtual void release(void *memory) = 0;
    /// Host memory that transfers at full speed and need not wait.
    virtual Fault allocateHost(std::size_t bytes, void **memory) = 0;
    virtual void releaseHost(void *memory) = 0;

    // In the order of the calls, all of them after one another on the device; `from` and `to` on the host must stay
    // until finish() where they come from allocateHost.
    virtual Fault upload(void *to, const void *from, std::size_t bytes) = 0;
    virtual Fault download(void *to, const void *from, std::size_t bytes) = 0;
    /// Within the device: rectangles {x, y, width, height} of pictures with `rowPixels` a row.
    virtual Fault copyRects(std::uint32_t *to, const std::uint32_t *from, int rowPixels, const int (*rects)[4],
                            int count) = 0;
    virtual Fault clear(void *memory, std::size_t bytes) = 0; ///< to zeros
    /// Lists, then tiles (render/cuda/tile_program.h).
    virtual Fault run(const Frame &frame, Work work) = 0;
    /// Waits for everything asked for. `milliseconds`, where not null: of the last run(), on the device's clock.
    virtual Fault finish(double *milliseconds) = 0;

    /// A texture of the current OpenGL context; null where this device does not draw it (another GPU, Mesa).
    virtual std::unique_ptr<GlTexture> registerTexture(unsigned texture, Fault &fault) = 0;
};

/// Why there is no device.
enum class NoDevice { NotBuilt, NoDriver, NoGpu, Failed };
/// The devices that can be opened by an index below `count`.
struct Devices {
    int count = 0;
    NoDevice why = NoDevice::NotBuilt; ///< where there is none
    std::string said;                  ///< by the driver, then
};
Devices findDevices();
/// Null, and why.
std::unique_ptr<Device> openDevice(int index, std::string &why);

} // namespace suffuse::cuda
