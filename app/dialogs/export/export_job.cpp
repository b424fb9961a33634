#include "app/dialogs/export/export_job.h"

#include "render/backends.h"
#include "render/layered/layered_file.h"

#include <functional>
#include <new>

namespace suffuse {

namespace {

constexpr int renderShare = 850; ///< share of the bar for rendering, per mille; the rest is for writing

/// Counts the stored pixels, so that the bar moves.
class CountingPicture : public FloatPicture {
public:
    explicit CountingPicture(std::function<void(int)> progress) : m_progress(std::move(progress)) {}

    void store(const PixelRect &rect, const float *pixels, int stride) override
    {
        FloatPicture::store(rect, pixels, stride);
        const qint64 all = qint64(width) * height;
        const qint64 before = m_stored.fetch_add(qint64(rect.width) * rect.height);
        const qint64 now = before + qint64(rect.width) * rect.height;
        const int share = int(std::min<qint64>(renderShare, renderShare * now / all));
        if (share != int(renderShare * before / all))
            m_progress(share);
    }

private:
    std::function<void(int)> m_progress;
    std::atomic<qint64> m_stored = 0;
};

} // namespace

ExportJob::ExportJob(QObject *parent) : QObject(parent) {}

ExportJob::~ExportJob()
{
    m_cancel = true;
    if (m_thread.joinable())
        m_thread.join();
}

void ExportJob::start(const ExportOrder &order)
{
    Q_ASSERT(!m_running);
    if (m_thread.joinable())
        m_thread.join();
    m_cancel = false;
    m_running = true;
    m_path = order.path;
    m_thread = std::jthread([this, order] { run(order); });
}

void ExportJob::run(const ExportOrder &order)
{
    Result<void> written;
    try {
        written = work(order);
    } catch (const std::bad_alloc &) {
        written = Error{tr("A picture of %1 × %2 pixels does not fit into memory. Choose a smaller size.")
                            .arg(order.width)
                            .arg(order.height)};
    }
    QMetaObject::invokeMethod(
        this,
        [this, isWritten = bool(written), error = written || m_cancel ? QString() : written.error()] {
            m_running = false;
            emit finished(isWritten, error);
        },
        Qt::QueuedConnection);
}

Result<void> ExportJob::work(const ExportOrder &order)
{
    const auto progress = [this](int perMille) { show(perMille); };
    auto renderer = makeRenderer({.backend = Backend::Auto, .threads = order.threads});
    if (!renderer)
        return Error{renderer.error()};
    if (layeredFormatFor(order.path) != LayeredFormat::None)
        return workOnLayers(order, **renderer);
    RenderRequest request;
    request.painting = withoutDrafts(order.painting);
    request.time = order.time;
    request.view = View::ofArea(order.area, order.width, order.height);
    request.transparent = order.transparent;
    CountingPicture picture(progress);
    if (const auto stats = (*renderer)->render(request, picture, &m_cancel); !stats)
        return Error{stats.error()};
    if (m_cancel)
        return Error{};
    ImageOptions image = order.image;
    image.cancel = &m_cancel;
    image.progress = [&](int row, int rows) {
        if (row % 16 == 0)
            progress(renderShare + (1000 - renderShare) * row / std::max(rows, 1));
    };
    return writeImage(order.path, picture, image);
}

/// Each layer is a step of the bar.
Result<void> ExportJob::workOnLayers(const ExportOrder &order, Renderer &renderer)
{
    auto groups = makeRenderer({.backend = Backend::Auto, .threads = order.threads});
    if (!groups)
        return Error{groups.error()};
    LayeredRequest request;
    request.painting = order.painting;
    request.time = order.time;
    request.view = View::ofArea(order.area, order.width, order.height);
    request.bits = order.image.depth == ImageDepth::Bits16 ? 16 : 8;
    request.cancel = &m_cancel;
    request.progress = [this](std::size_t done, std::size_t layers) { show(int(1000 * done / (layers + 1))); };
    const Result<LayeredStats> written = writeLayered(order.path, request, renderer, **groups);
    return written ? Result<void>() : Error{written.error()};
}

void ExportJob::show(int perMille)
{
    QMetaObject::invokeMethod(
        this, [this, perMille] { emit progressed(perMille); }, Qt::QueuedConnection);
}

} // namespace suffuse
