#include "app/dialogs/export/timelapse_job.h"
#include "render/backends.h"

#include "render/sequence.h"

namespace suffuse {

TimelapseJob::TimelapseJob(QObject *parent) : QObject(parent) {}

TimelapseJob::~TimelapseJob()
{
    m_cancel = true;
    if (m_thread.joinable())
        m_thread.join();
}

void TimelapseJob::start(const TimelapseOrder &order)
{
    Q_ASSERT(!m_running);
    if (m_thread.joinable())
        m_thread.join();
    m_cancel = false;
    m_running = true;
    m_thread = std::jthread([this, order] {
        const Result<void> made = film(order);
        const bool written = bool(made);
        const QString error = m_cancel ? QString() : made.error();
        QMetaObject::invokeMethod(
            this,
            [this, written, error] {
                m_running = false;
                emit finished(written, error);
            },
            Qt::QueuedConnection);
    });
}

Result<void> TimelapseJob::film(TimelapseOrder order)
{
    order.film.image.cancel = &m_cancel;
    const auto renderers = makeRenderers({.backend = Backend::Auto, .threads = order.threads});
    if (!renderers)
        return Error{renderers.error()};
    const auto file = openFilm(order.film);
    if (!file)
        return Error{file.error()};
    RenderRequest request;
    request.painting = withoutDrafts(order.painting);
    request.view = View::ofArea(order.area, order.film.width, order.film.height);
    request.transparent = order.film.image.alpha;
    std::atomic<int> done = 0;
    const auto use = [&](std::size_t i, const FloatPicture &frame) {
        const Result<void> written = (*file)->write(i, frame);
        const int frames = ++done;
        QMetaObject::invokeMethod(
            this, [this, frames] { emit progressed(frames); }, Qt::QueuedConnection);
        return written;
    };
    const Result<SequenceStats> drawn =
        renderSequence(*renderers, request, timelapseMoments(*order.painting, {int(order.film.frames), order.idle}),
                       order.threads, use, &m_cancel);
    if (!drawn)
        return Error{drawn.error()};
    return (*file)->commit();
}

} // namespace suffuse
