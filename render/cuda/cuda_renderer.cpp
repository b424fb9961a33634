#include "render/cuda/cuda_renderer.h"

#include "render/cuda/device/failing_device.h"
#include "render/elapsed.h"

#include <QCoreApplication>

#include <cstring>
#include <thread>

namespace suffuse {

using cuda::Fault;
using cuda::TileTask;

namespace {

/// Tiles and macro-tiles are counted by 16 bits along each side.
constexpr int mostPixels = 65535 * cuda::tileSide;

/// Joins tiles that lie side by side in a row to one rectangle, and such rectangles that lie below each other.
class DirtyRects {
public:
    explicit DirtyRects(std::vector<PixelRect> &out) : m_out(out) {}

    void beginRow()
    {
        m_above.swap(m_row);
        m_row.clear();
        m_next = 0;
    }
    /// Adds a run of tiles. The runs of a row do not touch, and come in order of columns.
    void add(const PixelRect &run)
    {
        while (m_next < m_above.size() && m_out[m_above[m_next]].x < run.x)
            ++m_next;
        if (m_next < m_above.size() && m_out[m_above[m_next]].x == run.x && m_out[m_above[m_next]].width == run.width) {
            m_out[m_above[m_next]].height += run.height;
            m_row.push_back(m_above[m_next]);
        } else {
            m_row.push_back(m_out.size());
            m_out.push_back(run);
        }
    }

private:
    std::vector<PixelRect> &m_out;
    std::vector<std::size_t> m_above, m_row; ///< the rectangles that end with the last row and with this one
    std::size_t m_next = 0;
};

/// Covers the marked tiles of the region by few rectangles. `marked` has a byte for each tile, row by row: 1 where the
/// tile is marked, else 0.
std::vector<PixelRect> dirtyRects(const DirtyRegion &region, const std::uint8_t *marked)
{
    const auto find = [](const std::uint8_t *from, const std::uint8_t *end, int value) {
        const void *found = std::memchr(from, value, std::size_t(end - from));
        return found ? static_cast<const std::uint8_t *>(found) : end;
    };
    std::vector<PixelRect> out;
    DirtyRects rects(out);
    for (int row = 0; row < region.rows(); ++row) {
        rects.beginRow();
        const std::uint8_t *begin = marked + std::size_t(row) * std::size_t(region.columns());
        const std::uint8_t *end = begin + region.columns();
        for (const std::uint8_t *from = find(begin, end, 1); from != end;) {
            const std::uint8_t *to = find(from, end, 0);
            PixelRect run = region.tile(int(from - begin), row);
            const PixelRect last = region.tile(int(to - begin) - 1, row);
            run.width = last.x + last.width - run.x;
            rects.add(run);
            from = find(to, end, 1);
        }
    }
    return out;
}

} // namespace

CudaRenderer::CudaRenderer(const std::vector<std::shared_ptr<cuda::Device>> &devices, int threads, bool cull,
                           const cuda::ApartLimits &apart, std::size_t worthwhile)
    : m_crew(Threads(threads).count()), m_threads(threads, &m_crew), m_nodes(devices.front(), worthwhile),
      m_history(cuda::tileSide, cull, &m_nodes), m_devices(devices)
{
    m_deviceName = QString::fromStdString(devices.front()->name());
    if (devices.size() > 1)
        m_deviceName = QStringLiteral("%1 × %2").arg(devices.size()).arg(m_deviceName);
    m_shares.resize(devices.size());
    for (const auto &device : devices) { // Further devices work beside the first one, which has the crew.
        const Threads own = m_workers.empty() ? m_threads : Threads(m_threads.count());
        m_workers.push_back(std::make_unique<cuda::TileWorker>(device, cull, own, apart));
    }
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

void CudaRenderer::planTasks()
{
    constexpr int side = cuda::macroTiles;
    const DirtyRegion &region = m_history.region();
    const std::size_t tiles = std::size_t(region.columns()) * std::size_t(region.rows());
    std::vector<TileTask *> next;
    for (Share &share : m_shares) {
        if (share.room.size() <= tiles)
            share.room.resize(tiles + 1);
        next.push_back(share.room.data());
    }
    for (int top = 0; top < region.rows(); top += side) {
        for (int left = 0; left < region.columns(); left += side) {
            // A macro-tile always goes to the same device, which may have layers of it.
            TileTask *&share = next[std::size_t((top + left) / side) % next.size()], *task = share;
            for (int row = top; row < std::min(top + side, region.rows()); ++row) {
                const std::uint8_t *dirty = region.dirtyRow(row);
                const int right = std::min(left + side, region.columns());
                if (!std::memchr(dirty + left, 1, std::size_t(right - left)))
                    continue;
                for (int column = left; column < right; ++column) {
                    *task = {std::uint16_t(column), std::uint16_t(row),
                             std::uint32_t(m_history.tileIndex(column, row))};
                    task += dirty[column]; // A branch here would often be predicted wrongly.
                }
            }
            share = task;
        }
    }
    for (std::size_t i = 0; i < next.size(); ++i)
        m_shares[i].tasks = {m_shares[i].room.data(), next[i]};
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
    if (!request.part.isEmpty())
        return render(ofPart(request), target, cancel);
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

    const FrameHistory::Step step =
        m_history.advance(request, PictureGrid::ofPicture(request.view), target, m_threads, cancel);
    stats.nodes = m_history.scene().nodeCount();
    stats.nodesMs = milliseconds(stage);
    stage.restart();
    if (const Fault fault =
            onDevices([&](std::size_t i) { return m_workers[i]->prepare(m_history, step, request, *paper); }))
        return lose(QString::fromStdString(fault.what));
    planTasks();
    stats.binningMs = milliseconds(stage);
    stage.restart();

    const Fault fault = onDevices([&](std::size_t i) {
        const auto findDirty = [&] { stats.dirty = dirtyRects(m_history.region(), m_history.region().dirtyRow(0)); };
        return m_workers[i]->paint(m_history, request.interactive, m_shares[i].tasks, picture, target, cancel,
                                   i == 0 ? std::function<void()>(findDirty) : nullptr);
    });
    if (fault)
        return lose(QString::fromStdString(fault.what));
    finish(stats);
    stats.frame = picture ? m_frame : nullptr;
    stats.tilesMs = milliseconds(stage);
    stats.totalMs = milliseconds(total);
    return stats;
}

void CudaRenderer::finish(RenderStats &stats)
{
    const DirtyRegion &region = m_history.region();
    std::size_t all = 0, drawn = 0;
    for (const Share &share : m_shares)
        all += share.tasks.size();
    if (all > 0 && stats.dirty.empty()) // The first device had nothing to do.
        stats.dirty = dirtyRects(region, region.dirtyRow(0));
    if (std::ranges::all_of(m_workers, &cuda::TileWorker::drewAll)) {
        drawn = all;
        m_history.drawnAll();
    } else {
        for (const Share &share : m_shares)
            for (const TileTask &task : share.tasks)
                if (task.drawn) {
                    ++drawn;
                    m_history.drawn(task.column, task.row, task.approximate);
                }
    }
    if (drawn < all)
        stats.dirty = dirtyRects(region, drawnTiles().data());
    stats.cancelled = drawn < all;
    stats.pixelsEvaluated = pixelsIn(stats.dirty);
    stats.tilesEvaluated = int(drawn);
    stats.tiles = region.columns() * region.rows();
    for (const auto &worker : m_workers)
        stats.deviceMs = std::max(stats.deviceMs, worker->deviceMs());
}

std::vector<std::uint8_t> CudaRenderer::drawnTiles() const
{
    std::vector<std::uint8_t> tiles(std::size_t(m_history.region().columns() * m_history.region().rows()), 0);
    for (const Share &share : m_shares)
        for (const TileTask &task : share.tasks)
            tiles[task.index] = task.drawn;
    return tiles;
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

int cudaDeviceCount()
{
    return cuda::findDevices().count;
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
    auto renderer = std::make_unique<CudaRenderer>(devices, options.threads, options.cull);
    renderer->makeReady();
    return std::unique_ptr<Renderer>(std::move(renderer));
}

} // namespace suffuse
