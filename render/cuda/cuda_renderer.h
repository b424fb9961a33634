// This renderer draws on one or several CUDA devices, and evaluates only what differs from the last call.
#pragma once

#include "render/cuda/cuda_frame.h"
#include "render/cuda/device_nodes.h"
#include "render/cuda/tile_worker.h"
#include "render/renderer.h"
#include "render/threads/crew.h"

#include <functional>

namespace suffuse {

class CudaRenderer : public Renderer {
public:
    /// `devices` has at least one device; they share each picture by macro-tiles. `threads` are those of the host, 0
    /// for all cores. `apart` says which strokes are evaluated apart from their tiles, and `worthwhile` from how many
    /// segments a thread on the first device builds nodes; neither changes a bit.
    CudaRenderer(const std::vector<std::shared_ptr<cuda::Device>> &devices, int threads, bool cull = true,
                 const cuda::ApartLimits &apart = {}, std::size_t worthwhile = cuda::DeviceNodes::usuallyWorthwhile);
    ~CudaRenderer() override;

    /// Takes memory that the first picture will need.
    void makeReady() { m_nodes.makeReady(); }

    Backend backend() const override { return Backend::Cuda; }
    QString deviceName() const override { return m_deviceName; }
    Result<RenderStats> render(const RenderRequest &request, Target &target,
                               const std::atomic<bool> *cancel = nullptr) override;
    void invalidate() override { m_history.forget(); }
    bool isLost() const override { return m_lost; }

private:
    /// Holds the tiles that one device evaluates.
    struct Share {
        std::vector<cuda::TileTask> room; ///< the memory of the tasks, kept from frame to frame
        std::span<cuda::TileTask> tasks;
    };
    /// Returns the picture on the device, if the target takes it and the device has room. Otherwise returns null, and
    /// the picture goes into the target.
    std::uint32_t *pictureFor(const RenderRequest &request, const Target &target);
    /// Lists the tiles to evaluate, for each device its own.
    void planTasks();
    /// Calls work(i) for all devices at the same time, and returns the first fault.
    cuda::Fault onDevices(const std::function<cuda::Fault(std::size_t)> &work);
    /// Notes what was drawn.
    void finish(RenderStats &stats);
    /// Returns a byte for each tile of the picture, row by row, which is 1 where it was drawn.
    std::vector<std::uint8_t> drawnTiles() const;
    Error lose(const QString &why);

    Crew m_crew;
    Threads m_threads; ///< the threads of the crew
    QString m_deviceName;
    cuda::DeviceNodes m_nodes;
    FrameHistory m_history;
    std::vector<std::unique_ptr<cuda::TileWorker>> m_workers;
    std::vector<Share> m_shares; ///< the share of each worker
    std::vector<std::shared_ptr<cuda::Device>> m_devices;
    std::shared_ptr<CudaFrame> m_frame;
    bool m_noFrame = false; ///< whether the device has no room for a picture of this size
    int m_frameWidth = 0, m_frameHeight = 0;
    bool m_onDevice = false; ///< whether the last picture stayed on the device
    bool m_lost = false;
};

/// Says to a user why there is no device.
QString whyNone(const cuda::Devices &devices);
/// Opens the devices that RendererOptions::devices asks for, as far as they can be opened. It fails with the reason if
/// none can.
Result<std::unique_ptr<Renderer>> makeCudaRenderer(const RendererOptions &options);
/// GPUs that makeCudaRenderer can try; 0 where there is no driver.
int cudaDeviceCount();

} // namespace suffuse
