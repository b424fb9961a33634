// This is what the host asks of a device that renders, without how CUDA does it. The header is C++17 and knows no Qt.
#pragma once

#include "render/cuda/gradient/gradient_records.h"
#include "render/cuda/nodes/node_records.h"
#include "render/cuda/tiles/records.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace suffuse::cuda {

/// Says why a call failed, or by None that it did not fail.
struct Fault {
    /// Lost means that this process can no longer use the device, Refused that nothing was asked of it.
    enum Kind { None, OutOfMemory, Lost, Refused };
    Kind kind = None;
    std::string what; ///< the reason in the words of the driver

    explicit operator bool() const { return kind != None; }
};

/// Says which kernels of a frame a call needs.
struct Work {
    bool plain = true;   ///< whether some tiles have the flag plainTile
    bool general = true; ///< whether some have not
};

/// The device writes to such an OpenGL texture. It must be used and destroyed on the thread whose context is current
/// (the window's), also while another thread renders.
class GlTexture {
public:
    virtual ~GlTexture() = default;
    /// Copies rectangles {x, y, width, height} of a picture (device memory, 0xAARRGGBB, `rowPixels` in a row) to the
    /// texture. The context in which it was registered must be current.
    virtual Fault copyFrom(const std::uint32_t *picture, int rowPixels, const int (*rects)[4], int count) = 0;
};

/// Calls must be made by one thread at a time, but the window's thread may call `registerTexture` while another one
/// renders. After a Fault of kind Lost every call fails.
class Device {
public:
    virtual ~Device() = default;
    virtual std::string name() const = 0; ///< for example "NVIDIA H100 80GB HBM3"
    /// Returns the number of bytes that are free now, at least roughly.
    virtual std::size_t freeMemory() const = 0;

    virtual Fault allocate(std::size_t bytes, void **memory) = 0;
    virtual void release(void *memory) = 0;
    /// Allocates host memory that is transferred at full speed and without waiting.
    virtual Fault allocateHost(std::size_t bytes, void **memory) = 0;
    virtual void releaseHost(void *memory) = 0;

    // The device does these calls one after another, in their order. Host memory that comes from allocateHost must stay
    // as it is until finish().
    virtual Fault upload(void *to, const void *from, std::size_t bytes) = 0;
    virtual Fault download(void *to, const void *from, std::size_t bytes) = 0;
    /// Copies rectangles {x, y, width, height} of pictures with `rowPixels` in a row, within the device.
    virtual Fault copyRects(std::uint32_t *to, const std::uint32_t *from, int rowPixels, const int (*rects)[4],
                            int count) = 0;
    virtual Fault clear(void *memory, std::size_t bytes) = 0; ///< sets the memory to zeros
    /// Runs the kernels for lists, then those for tiles (render/cuda/tiles/tile_program.h).
    virtual Fault run(const Frame &frame, Work work) = 0;
    /// Runs the programs that build nodes (render/cuda/nodes/node_place.h and node_merge.h).
    virtual Fault buildNodes(const NodeWork &work) = 0;
    /// Returns how many warps find gradients at the same time, which GradientWork::warps need not exceed.
    virtual std::uint32_t gradientWarps() const = 0;
    /// Runs the programs that find the gradient of a picture (render/cuda/gradient).
    virtual Fault findGradient(const GradientWork &work) = 0;
    /// Waits for everything that was asked for. `milliseconds`, if not null, gets the time of the last run() or
    /// findGradient() on the device's clock.
    virtual Fault finish(double *milliseconds) = 0;

    /// Registers a texture of the current OpenGL context. Returns null if this device does not draw it (another GPU,
    /// Mesa).
    virtual std::unique_ptr<GlTexture> registerTexture(unsigned texture, Fault &fault) = 0;
};

/// Says why there is no device.
enum class NoDevice { NotBuilt, NoDriver, NoGpu, Failed };
/// Says which devices can be opened, by an index below `count`.
struct Devices {
    int count = 0;
    NoDevice why = NoDevice::NotBuilt; ///< why there is none, if there is none
    std::string said;                  ///< what the driver says about it
};
Devices findDevices();
/// Opens a device. Returns null, and says why, if that fails.
std::unique_ptr<Device> openDevice(int index, std::string &why);

} // namespace suffuse::cuda
