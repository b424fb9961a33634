#include "render/sequence.h"

#include "render/threads/parallel.h"

#include <QCoreApplication>
#include <QScopeGuard>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <new>
#include <optional>
#include <semaphore>
#include <thread>
#include <vector>

namespace suffuse {

namespace {

using Use = std::function<Result<void>(std::size_t, const FloatPicture &)>;

/// What the threads of one sequence share.
class Work {
public:
    Work(const RenderRequest &request, const std::vector<Microseconds> &moments, std::size_t runs, const Use &use,
         const std::atomic<bool> *cancel)
        : m_request(request), m_moments(moments), m_runs(runs), m_use(use), m_cancel(cancel)
    {}

    /// Draws runs of moments as long as there are any. Pictures are used while the next ones are drawn.
    void run(Renderer &renderer, int threads)
    {
        if (threads == 1)
            guarded(
                [&] { drawAll(renderer, [this](std::size_t i, const FloatPicture &p, const auto &) { use(i, p); }); });
        else
            drawBesideUse(renderer, threads);
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

    /// Calls `take(i, canvas, dirty)` after each picture: `dirty` is where it differs from the one before.
    template <typename Take>
    void drawAll(Renderer &renderer, Take take)
    {
        FloatPicture canvas; // It is drawn into again and again.
        for (std::size_t run = m_nextRun++; run < m_runs && !isOver(); run = m_nextRun++)
            for (std::size_t i = m_moments.size() * run / m_runs; i < m_moments.size() * (run + 1) / m_runs; ++i) {
                const std::vector<PixelRect> dirty = draw(renderer, m_moments[i], canvas);
                if (isOver())
                    return;
                take(i, canvas, dirty);
            }
    }

    /// A copy of a picture for one of the threads that use them.
    struct Place {
        FloatPicture picture;
        std::vector<PixelRect> stale;      ///< where it differs from the picture that was drawn last
        double stalePixels = 0;            ///< of these; as many as the picture has: all of it
        std::optional<std::size_t> moment; ///< no value: there are no more moments
        std::binary_semaphore isFilled{0};

        void miss(const std::vector<PixelRect> &dirty, double pixels)
        {
            for (const PixelRect &rect : dirty)
                stalePixels += double(rect.width) * rect.height;
            if (stalePixels < pixels)
                stale.insert(stale.end(), dirty.begin(), dirty.end());
            else
                stale.clear();
        }

        /// Pictures of a film hardly differ from the one before: to copy them whole takes longer than to draw them.
        void follow(const FloatPicture &canvas)
        {
            if (picture.width != canvas.width || picture.height != canvas.height ||
                stalePixels >= double(canvas.width) * canvas.height)
                picture = canvas;
            else
                for (const PixelRect &rect : stale)
                    picture.store(rect, canvas.at(rect.x, rect.y), canvas.width);
            stale.clear();
            stalePixels = 0;
        }
    };

    /// Those of the places that wait for a picture. The last to come is the first to go: it differs least.
    class FreePlaces {
    public:
        explicit FreePlaces(std::deque<Place> &places)
        {
            for (Place &place : places)
                m_places.push_back(&place);
        }
        void give(Place &place)
        {
            {
                const std::lock_guard lock(m_mutex);
                m_places.push_back(&place);
            }
            m_given.notify_one();
        }
        Place &take()
        {
            std::unique_lock lock(m_mutex);
            m_given.wait(lock, [&] { return !m_places.empty(); });
            Place *place = m_places.back();
            m_places.pop_back();
            return *place;
        }

    private:
        std::mutex m_mutex;
        std::condition_variable m_given;
        std::vector<Place *> m_places;
    };

    void drawBesideUse(Renderer &renderer, int threads)
    {
        std::deque<Place> places(std::min(std::size_t(threads), m_moments.size()));
        FreePlaces free(places);
        std::vector<std::jthread> users;
        for (Place &place : places)
            users.emplace_back([this, &place, &free] {
                for (place.isFilled.acquire(); place.moment; place.isFilled.acquire()) {
                    guarded([&] { use(*place.moment, place.picture); });
                    free.give(place);
                }
            });
        guarded([&] {
            drawAll(renderer, [&](std::size_t i, const FloatPicture &canvas, const std::vector<PixelRect> &dirty) {
                for (Place &place : places)
                    place.miss(dirty, double(canvas.width) * canvas.height);
                Place &place = free.take();
                auto giveBack = qScopeGuard([&] { free.give(place); }); // This also covers a copy that fails.
                place.follow(canvas);
                giveBack.dismiss();
                place.moment = i;
                place.isFilled.release();
            });
        });
        for (std::size_t left = places.size(); left > 0; --left) {
            Place &place = free.take();
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

    std::vector<PixelRect> draw(Renderer &renderer, Microseconds time, FloatPicture &canvas)
    {
        RenderRequest request = m_request;
        request.time = time;
        Result<RenderStats> stats = renderer.render(request, canvas, m_cancel);
        if (!stats) {
            fail(stats.error());
            return {};
        }
        const std::lock_guard lock(m_mutex);
        m_stats.tiles += stats->tiles;
        m_stats.tilesEvaluated += stats->tilesEvaluated;
        return std::move(stats->dirty);
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
    const std::size_t m_runs; ///< parts of the moments
    std::atomic<std::size_t> m_nextRun{0};
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
    const std::size_t workers = std::min(renderers.size(), std::max<std::size_t>(moments.size(), 1));
    const int threadsEach = std::max(1, threads / int(workers));
    // The end of a painting takes longer than its beginning, so that several renderers take several runs each.
    constexpr std::size_t runsEach = 6;
    Work work(request, moments, workers == 1 ? 1 : std::min(moments.size(), workers * runsEach), use, cancel);
    {
        std::vector<std::jthread> others;
        for (std::size_t k = 1; k < workers; ++k)
            others.emplace_back([&, k] { work.run(*renderers[k], threadsEach); });
        work.run(*renderers[0], threadsEach);
    }
    return work.result();
}

} // namespace suffuse
