#include "app/cli/options.h"
#include "app/cli/progress.h"

#include <QCoreApplication>

#include <csignal>
#include <new>

namespace suffuse::cli {

namespace {

std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free, "it is set in a signal handler");

/// Passes pixels on and shows how far it is.
class ProgressTarget : public Target {
public:
    explicit ProgressTarget(FloatPicture &picture) : m_picture(picture) {}

    void resize(int width, int height) override
    {
        m_total = qint64(width) * height;
        m_done = 0; // another renderer may begin anew
        m_picture.resize(width, height);
    }
    void store(const PixelRect &rect, const float *rgba, int stride) override
    {
        m_picture.store(rect, rgba, stride);
        m_line.show(m_done += qint64(rect.width) * rect.height, m_total);
    }

private:
    FloatPicture &m_picture;
    ProgressLine m_line{QCoreApplication::translate("Cli", "drawing")};
    std::atomic<qint64> m_done{0};
    qint64 m_total = 0;
};

} // namespace

const std::atomic<bool> &interrupted()
{
    static const bool installed = [] {
        for (int signal : {SIGINT, SIGTERM})
            std::signal(signal, [](int which) {
                stop = true;
                std::signal(which, SIG_DFL); // who cannot wait until it is noticed asks again
            });
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
