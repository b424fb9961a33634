#include "render/sequence.h"

#include "render/parallel.h"

#include <QCoreApplication>

#include <algorithm>
#include <mutex>
#include <new>
#include <thread>

namespace suffuse {

namespace {

using Use = std::function<Result<void>(std::size_t, const FloatPicture &)>;

/// What the threads of one sequence share.
class Work {
public:
    Work(const RenderRequest &request, const std::vector<Microseconds> &moments, const Use &use,
         const std::atomic<bool> *cancel)
        : m_request(request), m_moments(moments), m_use(use), m_cancel(cancel)
    {}

    /// Moments [from, to), in groups of pictures that are used side by side.
    void run(Renderer &renderer, std::size_t from, std::size_t to, int threads)
    {
        try {
            drawAll(renderer, from, to, threads);
        } catch (const std::bad_alloc &) { // it may be a thread of its own
            fail(QCoreApplication::translate("Renderer",
                                             "there is not enough memory for %1 × %2 pixels. Choose a smaller size.")
                     .arg(m_request.view.width)
                     .arg(m_request.view.height));
        }
        const std::lock_guard lock(m_mutex);
        if (m_stats.notice.isEmpty())
            m_stats.notice = renderer.notice();
    }

    Result<SequenceStats> result() const
    {
        if (m_failed)
            return Error{m_error};
        if (m_cancel && *m_cancel)
            return Error{};
        return m_stats;
    }

private:
    bool isOver() const { return m_failed || (m_cancel && m_cancel->load(std::memory_order_relaxed)); }

    void drawAll(Renderer &renderer, std::size_t from, std::size_t to, int threads)
    {
        FloatPicture canvas; // drawn again and again
        std::vector<FloatPicture> pictures(std::min(std::size_t(threads), to - from));
        for (std::size_t first = from; first < to && !isOver(); first += pictures.size()) {
            const std::size_t count = std::min(pictures.size(), to - first);
            for (std::size_t i = 0; i < count && !isOver(); ++i) {
                draw(renderer, m_moments[first + i], canvas);
                pictures[i] = canvas;
            }
            if (isOver())
                break;
            parallelFor(count, threads, [&](std::size_t i) {
                if (const Result<void> used = isOver() ? Result<void>() : m_use(first + i, pictures[i]); !used)
                    fail(used.error());
            });
        }
    }

    void draw(Renderer &renderer, Microseconds time, FloatPicture &canvas)
    {
        RenderRequest request = m_request;
        request.time = time;
        const Result<RenderStats> stats = renderer.render(request, canvas, m_cancel);
        if (!stats)
            return fail(stats.error());
        const std::lock_guard lock(m_mutex);
        m_stats.tiles += stats->tiles;
        m_stats.tilesEvaluated += stats->tilesEvaluated;
    }

    void fail(const QString &error)
    {
        const std::lock_guard lock(m_mutex);
        if (!m_failed)
            m_error = error;
        m_failed = true;
    }

    const RenderRequest &m_request;
    const std::vector<Microseconds> &m_moments;
    const Use &m_use;
    const std::atomic<bool> *m_cancel;
    std::mutex m_mutex;
    std::atomic<bool> m_failed{false};
    QString m_error;
    SequenceStats m_stats;
};

} // namespace

Result<std::vector<std::unique_ptr<Renderer>>> makeRenderers(const RendererOptions &options)
{
    std::vector<std::unique_ptr<Renderer>> renderers;
    RendererOptions one = options;
    one.devices = 1;
    for (int i = 0; i < options.devices || options.devices == allDevices; ++i) {
        one.firstDevice = i;
        if (i > 0)
            one.backend = Backend::Cuda; // where there is no other GPU, this fails and all are found
        Result<std::unique_ptr<Renderer>> renderer = makeRenderer(one);
        if (!renderer && i == 0)
            return Error{renderer.error()};
        if (!renderer)
            break;
        renderers.push_back(std::move(*renderer));
        if (options.backend == Backend::Cpu || options.backend == Backend::Reference)
            break;
    }
    return renderers;
}

Result<SequenceStats> renderSequence(const std::vector<std::unique_ptr<Renderer>> &renderers,
                                     const RenderRequest &request, const std::vector<Microseconds> &moments,
                                     int threads, const Use &use, const std::atomic<bool> *cancel)
{
    threads = threads > 0 ? threads : hardwareThreads();
    const std::size_t shares = std::min(renderers.size(), std::max<std::size_t>(moments.size(), 1));
    const int threadsEach = std::max(1, threads / int(shares));
    Work work(request, moments, use, cancel);
    const auto share = [&](std::size_t k) {
        work.run(*renderers[k], moments.size() * k / shares, moments.size() * (k + 1) / shares, threadsEach);
    };
    {
        std::vector<std::jthread> others;
        for (std::size_t k = 1; k < shares; ++k)
            others.emplace_back(share, k);
        share(0);
    }
    return work.result();
}

} // namespace suffuse
