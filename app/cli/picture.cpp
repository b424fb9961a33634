#include "app/cli/options.h"

#include <QCoreApplication>
#include <QElapsedTimer>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <new>

#include <unistd.h>

namespace suffuse::cli {

namespace {

std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free, "it is set in a signal handler");

/// Passes pixels on and keeps a line like "render 42 %" on the terminal.
class ProgressTarget : public Target {
public:
    explicit ProgressTarget(FloatPicture &picture) : m_picture(picture), m_shown(::isatty(STDERR_FILENO) != 0)
    {
        m_clock.start();
    }
    ~ProgressTarget() override
    {
        if (m_percent >= 0)
            std::fputs("\r\033[K", stderr);
    }
    void resize(int width, int height) override
    {
        m_total = qint64(width) * height;
        m_done = 0; // another renderer may begin anew
        m_percent = std::min(m_percent, 0);
        m_picture.resize(width, height);
    }
    void store(const PixelRect &rect, const float *rgba, int stride) override
    {
        m_picture.store(rect, rgba, stride);
        const qint64 done = m_done += qint64(rect.width) * rect.height;
        if (m_shown && m_total > 0)
            show(int(100 * done / m_total));
    }

private:
    void show(int percent)
    {
        const std::lock_guard lock(m_mutex);
        if (percent <= m_percent || m_clock.elapsed() < 300) // quick work shows nothing
            return;
        m_percent = percent;
        const QByteArray text = QCoreApplication::translate("Cli", "drawing").toLocal8Bit();
        std::fprintf(stderr, "\r%s %d %%", text.constData(), percent);
        std::fflush(stderr);
    }

    FloatPicture &m_picture;
    const bool m_shown;
    QElapsedTimer m_clock;
    std::mutex m_mutex;
    std::atomic<qint64> m_done{0};
    qint64 m_total = 0;
    int m_percent = -1;
};

} // namespace

const std::atomic<bool> &interrupted()
{
    static const bool installed = [] {
        for (int signal : {SIGINT, SIGTERM})
            std::signal(signal, [](int) { stop = true; });
        return true;
    }();
    (void)installed;
    return stop;
}

Result<RenderStats> renderPicture(Renderer &renderer, const RenderRequest &request, FloatPicture &picture)
{
    try {
        ProgressTarget target(picture);
        const Result<RenderStats> stats = renderer.render(request, target, &interrupted());
        if (stats && stats->cancelled)
            return Error{QCoreApplication::translate("Cli", "stopped; nothing was written")};
        return stats;
    } catch (const std::bad_alloc &) {
        return Error{
            QCoreApplication::translate("Cli", "there is not enough memory for %1 × %2 pixels. Choose a smaller size.")
                .arg(request.view.width)
                .arg(request.view.height)};
    }
}

} // namespace suffuse::cli
