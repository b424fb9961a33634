// A picture from a painting, by any backend.
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"
#include "render/device_frame.h"
#include "render/target.h"
#include "render/view.h"

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace suffuse {

/// What is to be drawn. The picture is a pure function of this.
struct RenderRequest {
    PaintingPtr painting;
    Microseconds time = 0; ///< document time T
    View view;
    bool transparent = false; ///< no background: alpha holds the coverage
    /// A value is being dragged: this frame may differ by 1e-5 a channel from the exact one, if that makes it faster.
    /// The next frame without it is exact again.
    bool interactive = false;
};

struct RenderStats {
    double nodesMs = 0;   ///< segments to Gaussian nodes
    double binningMs = 0; ///< nodes to tiles
    double tilesMs = 0;   ///< pixels
    double totalMs = 0;
    int tiles = 0;                      ///< in the picture
    int tilesEvaluated = 0;             ///< of them evaluated in this call
    std::size_t nodes = 0;              ///< in the scene
    std::vector<PixelRect> dirty;       ///< what was stored, disjoint
    double deviceMs = 0;                ///< of the device alone, by its clock; 0 on the CPU
    std::shared_ptr<DeviceFrame> frame; ///< where the picture stayed on the device; null: it is in the target
    bool cancelled = false;             ///< `cancel` was set: what was not stored is still dirty for the next call
};

enum class Backend { Auto, Cpu, Cuda, Reference };
/// "CPU", "CUDA", "reference": what people and JSON call it, in every language.
QString nameOf(Backend backend);

/// Draws into one target again and again, evaluating only what differs from its last call.
class Renderer {
public:
    virtual ~Renderer() = default;
    virtual Backend backend() const = 0;    ///< which one draws now, never Auto
    virtual QString deviceName() const = 0; ///< "2 threads · AVX2", "H100"

    /// Brings `target` up to date with the request. The first call, another target, size, view or paper draw all of it.
    /// Returns early, with `cancelled`, soon after `cancel` becomes true.
    virtual Result<RenderStats> render(const RenderRequest &request, Target &target,
                                       const std::atomic<bool> *cancel = nullptr) = 0;
    /// Forgets what was drawn: the next call draws all of it.
    virtual void invalidate() = 0;
    /// Empty, or why another backend draws than the one that was asked for: "CUDA stopped: out of memory. …".
    virtual QString notice() const { return {}; }
    /// True once its device failed: every further call would fail, and another renderer may take the same request over.
    virtual bool isLost() const { return false; }
};

/// For RendererOptions::devices.
inline constexpr int allDevices = -1;

struct RendererOptions {
    Backend backend = Backend::Auto;
    int threads = 0;     ///< 0: all cores
    int tileSize = 0;    ///< 0: the backend's choice; the picture's bits do not depend on it
    bool cull = true;    ///< false: every stroke is evaluated everywhere, to test that culling changes no bit
    int firstDevice = 0; ///< the GPU to begin with
    int devices = 1; ///< of several GPUs so many share each picture, or allDevices; the picture's bits stay the same
};

/// How renderers are made: makeRenderer (render/backends.h), or what a test has in its place.
using MakeRenderer = std::function<Result<std::unique_ptr<Renderer>>(const RendererOptions &)>;

} // namespace suffuse
