// The interface of all backends: a picture from a painting.
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

/// What is to be drawn. The picture is a pure function of it.
struct RenderRequest {
    PaintingPtr painting;
    Microseconds time = 0; ///< document time T
    View view;
    bool transparent = false; ///< whether there is no background, so that alpha is the coverage
    /// Whether a value is being dragged. Then this frame may differ by 1e-5 a channel from the exact one, if that makes
    /// it faster. The next frame without it is exact again.
    bool interactive = false;
    /// The pixels of the view's picture that are drawn, in a target of their size; empty: all. Drawn by the CPU they have
    /// the bits that they have in the whole picture. Other backends draw them as a picture of their own.
    PixelRect part = {};
    /// A larger rectangle around the part, for which the CPU prepares the strokes: parts around which it is the same share
    /// what was prepared. Empty: the part alone.
    PixelRect near = {};
};

/// The request for the part alone, as a picture of its own.
inline RenderRequest ofPart(const RenderRequest &request)
{
    RenderRequest out = request;
    out.view = request.view.part(request.part);
    out.part = out.near = {};
    return out;
}

struct RenderStats {
    double nodesMs = 0;   ///< time for making nodes of segments
    double binningMs = 0; ///< time for sorting nodes into tiles
    double tilesMs = 0;   ///< time for the pixels
    double totalMs = 0;
    int tiles = 0;                      ///< tiles of the picture
    int tilesEvaluated = 0;             ///< tiles that were evaluated in this call
    std::size_t nodes = 0;              ///< nodes of the scene
    std::vector<PixelRect> dirty;       ///< where the target's pixels may differ, in rectangles that do not overlap
    double pixelsEvaluated = 0;         ///< those that were drawn; the rest of `dirty` was moved there
    double deviceMs = 0;                ///< time of the device alone, by its clock; 0 on the CPU
    std::shared_ptr<DeviceFrame> frame; ///< the picture if it stayed on the device; null if it is in the target
    /// whether `cancel` was set; what was not stored is then still dirty for the next call
    bool cancelled = false;
};

enum class Backend { Auto, Cpu, Cuda, Reference };
/// The name that people and JSON use for a backend, in every language: "CPU", "CUDA", "reference".
QString nameOf(Backend backend);

/// Draws into one target again and again, and evaluates only what differs from the last call.
class Renderer {
public:
    virtual ~Renderer() = default;
    virtual Backend backend() const = 0;    ///< the one that draws now, never Auto
    virtual QString deviceName() const = 0; ///< "2 threads · AVX2", "H100"

    /// Brings `target` up to date with the request. The first call draws all of it, and so does a call with another
    /// target, size, view or paper. It returns early, with `cancelled`, soon after `cancel` becomes true.
    virtual Result<RenderStats> render(const RenderRequest &request, Target &target,
                                       const std::atomic<bool> *cancel = nullptr) = 0;
    /// Forgets what was drawn, so that the next call draws all of it.
    virtual void invalidate() = 0;
    /// Why another backend draws than the one that was asked for, as "CUDA stopped: out of memory. …"; empty if that is
    /// not so.
    virtual QString notice() const { return {}; }
    /// Whether the device has failed. Then every further call fails, too, and another renderer may take the same
    /// request over.
    virtual bool isLost() const { return false; }
};

/// A value of RendererOptions::devices that means all of them.
inline constexpr int allDevices = -1;

struct RendererOptions {
    Backend backend = Backend::Auto;
    int threads = 0;     ///< 0: all cores
    int tileSize = 0;    ///< 0: the backend's choice; the picture's bits do not depend on it
    bool cull = true;    ///< if false, every stroke is evaluated everywhere, to test that culling changes no bit
    int firstDevice = 0; ///< the first GPU to use
    int devices = 1; ///< how many GPUs share each picture, or allDevices; the bits of the picture do not depend on it
};

/// A function that makes renderers: makeRenderer (render/backends.h), or a substitute in tests.
using MakeRenderer = std::function<Result<std::unique_ptr<Renderer>>(const RendererOptions &)>;

} // namespace suffuse
