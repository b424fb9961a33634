#include "render/sequence.h"

#include "render/threads/parallel.h"

#include <QCoreApplication>
#include <QScopeGuard>

#include <algorithm>
#include <deque>
#include <mutex>
#include <new>
#include <optional>
#include <semaphore>
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

    /// Draws the moments [from, to). Pictures are used while the next ones are drawn.
    void run(Renderer &renderer, std::size_t from, std::size_t to, int threads)
    {
        if (threads == 1)
            guarded([&] { drawAll(renderer, from, to, [this](std::size_t i, const FloatPicture &p) { use(i, p); }); });
        else
            drawBesideUse(renderer, from, to, threads);
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

    /// Calls a function that may run on a thread of its own, and keeps its failure.
    template <typename Function>
    void guarded(Function work)
    {
        try {
            work();
        } catch (const std::bad_alloc &) {
            fail(QCoreApplication::translate("Renderer",
                                             "there is not enough memory for %1 × %2 pixels. Choose a smaller size.")
                     .arg(m_request.view.width)
                     .arg(m_request.view.height));
        }
    }

    template <typename Take>
    void drawAll(Renderer &renderer, std::size_t from, std::size_t to, Take take)
    {
        FloatPicture canvas; // It is drawn into again and again.
        for (std::size_t i = from; i < to && !isOver(); ++i) {
            draw(renderer, m_moments[i], canvas);
            if (!isOver())
                take(i, canvas);
        }
    }

    /// A place for a picture that waits for a thread, or is used by one.
    struct Place {
        FloatPicture picture;
        std::optional<std::size_t> moment; ///< no value: there are no more moments
        std::binary_semaphore isFree{1}, isFilled{0};
    };

    void drawBesideUse(Renderer &renderer, std::size_t from, std::size_t to, int threads)
    {
        std::deque<Place> places(std::min(std::size_t(threads), to - from));
        std::vector<std::jthread> users;
        for (Place &place : places)
            users.emplace_back([this, &place] {
                for (place.isFilled.acquire(); place.moment; place.isFilled.acquire()) {
                    guarded([&] { use(*place.moment, place.picture); });
                    place.isFree.release();
                }
            });
        guarded([&] {
            drawAll(renderer, from, to, [&](std::size_t i, const FloatPicture &canvas) {
                Place &place = places[(i - from) % places.size()];
                place.isFree.acquire();
                auto giveBack = qScopeGuard([&] { place.isFree.release(); }); // This also covers a copy that fails.
                place.picture = canvas;
                giveBack.dismiss();
                place.moment = i;
                place.isFilled.release();
            });
        });
        for (Place &place : places) {
            place.isFree.acquire();
            place.moment.reset();
            place.isFilled.release();
        }
    }

    void use(std::size_t i, const FloatPicture &picture)
    {
        if (isOver())
            return;
        if (const Result<void> used = m_use(i, picture); !used)
            fail(used.error());
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
