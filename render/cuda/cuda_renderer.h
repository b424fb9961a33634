// Draws on one or several CUDA devices, evaluating only what differs from the last call.
#pragma once

#include "render/cuda/cuda_frame.h"
#include "render/cuda/tile_worker.h"
#include "render/renderer.h"
#include "render/threads/crew.h"

#include <functional>

namespace suffuse {

class CudaRenderer : public Renderer {
public:
    /// `devices`: at least one; they share each picture by macro-tiles. `threads`: of the host, 0 for all cores.
    CudaRenderer(const std::vector<std::shared_ptr<cuda::Device>> &devices, int threads, bool cull = true);
    ~CudaRenderer() override;

    Backend backend() const override { return Backend::Cuda; }
    QString deviceName() const override { return m_deviceName; }
    Result<RenderStats> render(const RenderRequest &request, Target &target,
                               const std::atomic<bool> *cancel = nullptr) override;
    void invalidate() override { m_history.forget(); }
    bool isLost() const override { return m_lost; }

private:
    /// The tiles that a device evaluates.
    struct Share {
        std::vector<cuda::TileTask> room; ///< kept from frame to frame
        std::span<cuda::TileTask> tasks;
    };
    /// The picture on the device where the target takes it and the device has room, else null: then into the target.
    std::uint32_t *pictureFor(const RenderRequest &request, const Target &target);
    /// Lists the tiles to evaluate, for each device its own.
    void planTasks();
    /// Calls work(i) for each device, at the same time; the first fault.
    cuda::Fault onDevices(const std::function<cuda::Fault(std::size_t)> &work);
    /// Notes what was drawn.
    void finish(RenderStats &stats);
    /// A byte for each tile of the picture, row by row: 1 where it was drawn.
    std::vector<std::uint8_t> drawnTiles() const;
    Error lose(const QString &why);

    Crew m_crew;
    Threads m_threads; ///< the crew
    QString m_deviceName;
    FrameHistory m_history;
    std::vector<std::unique_ptr<cuda::TileWorker>> m_workers;
    std::vector<Share> m_shares; ///< of each of them
    std::vector<std::shared_ptr<cuda::Device>> m_devices;
    std::shared_ptr<CudaFrame> m_frame;
    bool m_noFrame = false; ///< the device has no room for one of this size
    int m_frameWidth = 0, m_frameHeight = 0;
    bool m_onDevice = false; ///< where the last picture went
    bool m_lost = false;
};

/// For a user: why there is no device.
QString whyNone(const cuda::Devices &devices);
/// Opens devices as RendererOptions::devices says, those that can be opened; fails with the reason where none can.
Result<std::unique_ptr<Renderer>> makeCudaRenderer(const RendererOptions &options);

} // namespace suffuse
