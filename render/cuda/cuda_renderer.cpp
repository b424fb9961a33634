#include "render/cuda/cuda_renderer.h"

#include "render/cuda/failing_device.h"
#include "render/parallel.h"

#include <QCoreApplication>
#include <QElapsedTimer>

#include <thread>

namespace suffuse {

using cuda::Fault;
using cuda::TileTask;

namespace {

/// Tiles and macro-tiles are counted by 16 bits a side.
constexpr int mostPixels = 65535 * cuda::tileSide;

double milliseconds(const QElapsedTimer &timer)
{
    return double(timer.nsecsElapsed()) * 1e-6;
}

/// Tiles that lie side by side in a row as one rectangle, and such rectangles below each other.
class DirtyRects {
public:
    explicit DirtyRects(std::vector<PixelRect> &out) : m_out(out) {}

    /// In order of rows, then columns.
    void add(const PixelRect &tile)
    {
        if (m_run.height > 0 && m_run.y == tile.y && m_run.x + m_run.width == tile.x) {
            m_run.width += tile.width;
            return;
        }
        flush();
        m_run = tile;
    }
    void flush()
    {
        if (m_run.height == 0)
            return;
        const auto above = std::find_if(m_out.rbegin(), m_out.rend(), [&](const PixelRect &r) {
            return r.x == m_run.x && r.width == m_run.width && r.y + r.height == m_run.y;
        });
        if (above != m_out.rend())
            above->height += m_run.height;
        else
            m_out.push_back(m_run);
        m_run = {};
    }

private:
    std::vector<PixelRect> &m_out;
    PixelRect m_run;
};

} // namespace

CudaRenderer::CudaRenderer(const std::vector<std::shared_ptr<cuda::Device>> &devices, int threads, bool cull)
    : m_threads(threads > 0 ? threads : hardwareThreads()), m_history(cuda::tileSide, cull), m_devices(devices)
{
    m_deviceName = QString::fromStdString(devices.front()->name());
    if (devices.size() > 1)
        m_deviceName = QStringLiteral("%1 × %2").arg(devices.size()).arg(m_deviceName);
    for (const auto &device : devices)
        m_workers.push_back(std::make_unique<cuda::TileWorker>(device, cull, m_threads));
}

CudaRenderer::~CudaRenderer() = default;

std::uint32_t *CudaRenderer::pictureFor(const RenderRequest &request, const Target &target)
{
    if (!target.takesDeviceFrames() || m_devices.size() > 1)
        return nullptr;
    const int width = request.view.width, height = request.view.height;
    if (width != m_frameWidth || height != m_frameHeight) {
        m_frame = nullptr;
        m_noFrame = false;
        m_frameWidth = width, m_frameHeight = height;
    }
    if (!m_frame && !m_noFrame) {
        std::string why;
        m_frame = makeCudaFrame(m_devices.front(), width, height, why);
        m_noFrame = !m_frame;
        m_history.forget();
    }
    return m_frame ? m_frame->picture() : nullptr;
}

std::vector<std::vector<TileTask>> CudaRenderer::planTasks() const
{
    constexpr int side = cuda::macroSide / cuda::tileSide;
    const DirtyRegion &region = m_history.region();
    std::vector<std::vector<TileTask>> tasks(m_workers.size());
    for (int macroRow = 0; macroRow * side < region.rows(); ++macroRow) {
        for (int macroColumn = 0; macroColumn * side < region.columns(); ++macroColumn) {
            // Always the same device's, which may have layers of it.
            auto &share = tasks[std::size_t(macroRow + macroColumn) % tasks.size()];
            for (int row = macroRow * side; row < std::min((macroRow + 1) * side, region.rows()); ++row)
                for (int column = macroColumn * side; column < std::min((macroColumn + 1) * side, region.columns());
                     ++column)
                    if (region.isDirty(column, row))
                        share.push_back({column, row});
        }
    }
    return tasks;
}

Fault CudaRenderer::onDevices(const std::function<Fault(std::size_t)> &work)
{
    std::vector<Fault> faults(m_workers.size());
    {
        std::vector<std::jthread> others;
        for (std::size_t i = 1; i < m_workers.size(); ++i)
            others.emplace_back([&, i] { faults[i] = work(i); });
        faults[0] = work(0);
    }
    for (const Fault &fault : faults)
        if (fault)
            return fault;
    return {};
}

Error CudaRenderer::lose(const QString &why)
{
    m_lost = true;
    return Error{why};
}

Result<RenderStats> CudaRenderer::render(const RenderRequest &request, Target &target, const std::atomic<bool> *cancel)
{
    RenderStats stats;
    QElapsedTimer total, stage;
    total.start();
    stage.start();
    const auto paper = paperTexture(request.painting->canvas.paper);
    if (!paper)
        return Error{paper.error()};
    if (std::max(request.view.width, request.view.height) > mostPixels)
        return lose(QCoreApplication::translate("Renderer", "the picture is too large"));
    std::uint32_t *picture = pictureFor(request, target);
    if (m_onDevice != (picture != nullptr))
        m_history.forget();
    m_onDevice = picture != nullptr;

    const FrameHistory::Step step = m_history.advance(request, target, m_threads);
    stats.nodes = m_history.scene().nodeCount();
    stats.nodesMs = milliseconds(stage);
    stage.restart();
    if (const Fault fault =
            onDevices([&](std::size_t i) { return m_workers[i]->prepare(m_history, step, request, *paper); }))
        return lose(QString::fromStdString(fault.what));
    auto tasks = planTasks();
    stats.binningMs = milliseconds(stage);
    stage.restart();

    const Fault fault = onDevices([&](std::size_t i) {
        return m_workers[i]->paint(m_history, request.interactive, tasks[i], picture, target, cancel);
    });
    if (fault)
        return lose(QString::fromStdString(fault.what));
    finish(tasks, stats);
    stats.frame = picture ? m_frame : nullptr;
    stats.tilesMs = milliseconds(stage);
    stats.totalMs = milliseconds(total);
    return stats;
}

void CudaRenderer::finish(const std::vector<std::vector<TileTask>> &tasks, RenderStats &stats)
{
    const DirtyRegion &region = m_history.region();
    std::vector<std::uint8_t> drawn(std::size_t(region.columns()) * std::size_t(region.rows()), 0);
    for (const auto &share : tasks)
        for (const TileTask &task : share) {
            stats.cancelled |= !task.drawn;
            if (!task.drawn)
                continue;
            ++stats.tilesEvaluated;
            m_history.drawn(task.column, task.row, task.approximate);
            drawn[m_history.tileIndex(task.column, task.row)] = 1;
        }
    DirtyRects rects(stats.dirty);
    for (int row = 0; row < region.rows(); ++row)
        for (int column = 0; column < region.columns(); ++column)
            if (drawn[m_history.tileIndex(column, row)])
                rects.add(region.tile(column, row));
    rects.flush();
    stats.tiles = region.columns() * region.rows();
    for (const auto &worker : m_workers)
        stats.deviceMs = std::max(stats.deviceMs, worker->deviceMs());
}

QString whyNone(const cuda::Devices &devices)
{
    const auto reason = [&] {
        switch (devices.why) {
        case cuda::NoDevice::NotBuilt:
            return QCoreApplication::translate("Renderer", "this program was built without the CUDA renderer");
        case cuda::NoDevice::NoDriver:
            return QCoreApplication::translate("Renderer", "no NVIDIA driver, or one that is too old for this program");
        case cuda::NoDevice::NoGpu:
            return QCoreApplication::translate("Renderer", "there is no NVIDIA GPU");
        case cuda::NoDevice::Failed:
            break;
        }
        return QCoreApplication::translate("Renderer", "the NVIDIA driver does not work");
    }();
    return devices.said.empty() ? reason : QStringLiteral("%1 (%2)").arg(reason, QString::fromStdString(devices.said));
}

Result<std::unique_ptr<Renderer>> makeCudaRenderer(const RendererOptions &options)
{
    const cuda::Devices found = cuda::findDevices();
    if (found.count == 0)
        return Error{whyNone(found)};
    const auto wanted = std::size_t(options.devices == allDevices ? found.count : std::max(options.devices, 1));
    std::vector<std::shared_ptr<cuda::Device>> devices;
    std::string why;
    for (int i = options.firstDevice; i < found.count && devices.size() < wanted; ++i)
        if (auto device = cuda::openDevice(i, why))
            devices.push_back(cuda::failingIfAsked(std::move(device)));
    if (devices.empty())
        return Error{QString::fromStdString(why)};
    return std::unique_ptr<Renderer>(std::make_unique<CudaRenderer>(devices, options.threads, options.cull));
}

} // namespace suffuse
