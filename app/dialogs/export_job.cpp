#include "app/dialogs/export_job.h"

#include <functional>

namespace suffuse {

namespace {

constexpr int renderShare = 850; ///< per mille of the bar for rendering, the rest for writing

/// Counts what is stored, so that the bar moves.
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
    m_thread = std::jthread([this, order] { run(order); });
}

void ExportJob::run(const ExportOrder &order)
{
    const auto done = [this](bool written, const QString &error) {
        QMetaObject::invokeMethod(
            this,
            [this, written, error] {
                m_running = false;
                emit finished(written, error);
            },
            Qt::QueuedConnection);
    };
    const auto progress = [this](int perMille) {
        QMetaObject::invokeMethod(
            this, [this, perMille] { emit progressed(perMille); }, Qt::QueuedConnection);
    };
    auto renderer = makeRenderer({.backend = Backend::Auto, .threads = order.threads});
    if (!renderer)
        return done(false, renderer.error());
    RenderRequest request;
    request.painting = order.painting;
    request.time = order.time;
    request.view = View::ofArea(order.area, order.width, order.height);
    request.transparent = order.transparent;
    CountingPicture picture(progress);
    const auto stats = (*renderer)->render(request, picture, &m_cancel);
    if (!stats)
        return done(false, stats.error());
    if (m_cancel)
        return done(false, {});
    ImageOptions image = order.image;
    image.cancel = &m_cancel;
    image.progress = [&](int row, int rows) {
        if (row % 16 == 0)
            progress(renderShare + (1000 - renderShare) * row / std::max(rows, 1));
    };
    const Result<void> written = writeImage(order.path, picture, image);
    done(bool(written), written || m_cancel ? QString() : written.error());
}

} // namespace suffuse
