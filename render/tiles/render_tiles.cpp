#include "render/tiles/render_tiles.h"

#include "render/elapsed.h"
#include "render/threads/parallel.h"

#include <QCoreApplication>

#include <condition_variable>
#include <deque>
#include <mutex>
#include <new>
#include <thread>

namespace suffuse {

namespace {

/// A sheet on its way from a renderer to the store.
struct SheetJob {
    SheetPicture picture;
    qint64 number = 0;
    TileSheet sheet;
    std::vector<QByteArray> tiles;
    std::size_t next = 0, done = 0; ///< tiles that were taken, and that are encoded
};

/// What the threads share. Pictures are few, and are used again and again.
class TileWork {
public:
    TileWork(const TilesRequest &request, const TiledPicture &picture, TileStore &store, std::size_t pictures)
        : m_request(request), m_picture(picture), m_store(store), m_jobs(pictures)
    {
        for (SheetJob &job : m_jobs) {
            job.picture.isDeep = picture.encoding.bits() > 8;
            m_free.push_back(&job);
        }
    }

    void draw(Renderer &renderer)
    {
        guarded([&] {
            const Backend backend = renderer.backend();
            const QString device = renderer.deviceName();
            for (qint64 i = m_next++; i < m_request.count && !isOver(); i = m_next++) {
                const qint64 number = m_request.sheet(i);
                if (m_store.has(number)) {
                    const std::lock_guard lock(m_mutex);
                    ++m_stats.kept;
                    tell();
                    continue;
                }
                SheetJob *job = takeFree();
                if (!job)
                    return;
                if (!drawSheet(renderer, number, *job))
                    return;
                if (renderer.backend() != backend || renderer.deviceName() != device)
                    return fail(QCoreApplication::translate(
                                    "Tiles", "%1 What another backend draws has other bits, and is not mixed in. Start "
                                             "again to go on.")
                                    .arg(renderer.notice()));
                const std::lock_guard lock(m_mutex);
                m_drawn.push_back(job);
                m_changed.notify_all();
            }
        });
    }

    void encode()
    {
        guarded([&] {
            for (SheetJob *job = nullptr;;) {
                std::size_t tile = 0;
                {
                    std::unique_lock lock(m_mutex);
                    m_changed.wait(lock, [&] { return isOver() || !m_drawn.empty() || m_allDrawn; });
                    if (isOver() || m_drawn.empty())
                        return;
                    job = m_drawn.front();
                    tile = job->next++;
                    if (job->next == job->tiles.size())
                        m_drawn.pop_front();
                }
                encodeTileOf(*job, tile);
            }
        });
    }

    void allDrawn()
    {
        const std::lock_guard lock(m_mutex);
        m_allDrawn = true;
        m_changed.notify_all();
    }

    Result<TilesStats> result() const
    {
        if (m_failed)
            return Error{m_error};
        if (m_request.cancel && *m_request.cancel)
            return Error{};
        return m_stats;
    }

private:
    bool isOver() const { return m_failed || (m_request.cancel && m_request.cancel->load(std::memory_order_relaxed)); }

    template <typename Function>
    void guarded(Function work)
    {
        try {
            work();
        } catch (const std::bad_alloc &) {
            fail(QCoreApplication::translate("Tiles",
                                             "there is not enough memory for the sheets that are drawn at once"));
        }
        const std::lock_guard lock(m_mutex); // Others may wait for what does not come any more.
        m_changed.notify_all();
    }

    void fail(const QString &error)
    {
        const std::lock_guard lock(m_mutex);
        if (!m_failed)
            m_error = error;
        m_failed = true;
        m_changed.notify_all();
    }

    SheetJob *takeFree()
    {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [&] { return isOver() || !m_free.empty(); });
        if (isOver())
            return nullptr;
        SheetJob *job = m_free.back();
        m_free.pop_back();
        return job;
    }

    bool drawSheet(Renderer &renderer, qint64 number, SheetJob &job)
    {
        job.number = number;
        job.sheet = m_picture.plan.sheet(number);
        job.tiles.assign(std::size_t(job.sheet.columns) * std::size_t(job.sheet.rows), {});
        job.next = job.done = 0;
        RenderRequest request = m_request.picture;
        request.view = m_picture.plan.levels()[std::size_t(job.sheet.level)].view;
        request.part = job.sheet.pixels;
        request.near = job.sheet.near;
        QElapsedTimer clock;
        clock.start();
        renderer.invalidate(); // Another renderer may have drawn into the picture since.
        const Result<RenderStats> stats = renderer.render(request, job.picture.target(), m_request.cancel);
        if (!stats)
            fail(stats.error());
        const std::lock_guard lock(m_mutex);
        m_stats.drawMs += milliseconds(clock);
        return stats && !stats->cancelled;
    }

    void encodeTileOf(SheetJob &job, std::size_t i)
    {
        const TileSheet &sheet = job.sheet;
        const int column = sheet.column + int(i) % sheet.columns, row = sheet.row + int(i) / sheet.columns;
        PixelRect at = m_picture.plan.tile(sheet.level, column, row);
        at.x -= sheet.pixels.x, at.y -= sheet.pixels.y;
        Result<QByteArray> bytes = encodeTile(job.picture, at, m_picture.encoding);
        if (!bytes)
            return fail(bytes.error());
        if (const Result<void> put = m_store.putTile(sheet, i, *bytes); !put)
            return fail(put.error());
        {
            const std::lock_guard lock(m_mutex);
            m_stats.bytes += bytes->size();
            job.tiles[i] = std::move(*bytes);
            if (++job.done < job.tiles.size())
                return;
        }
        if (const Result<void> put = m_store.put(sheet, job.number, job.tiles); !put)
            return fail(put.error());
        const std::lock_guard lock(m_mutex);
        ++m_stats.sheets;
        m_stats.pixels += double(sheet.pixels.width) * sheet.pixels.height;
        m_free.push_back(&job);
        m_changed.notify_all();
        tell();
    }

    void tell() const
    {
        if (m_request.progress)
            m_request.progress(m_stats.sheets + m_stats.kept, m_request.count);
    }

    const TilesRequest &m_request;
    const TiledPicture &m_picture;
    TileStore &m_store;
    std::deque<SheetJob> m_jobs;
    std::vector<SheetJob *> m_free;
    std::deque<SheetJob *> m_drawn; ///< tiles of the first one are taken first
    std::atomic<qint64> m_next{0};
    bool m_allDrawn = false;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::atomic<bool> m_failed{false};
    QString m_error;
    TilesStats m_stats;
};

} // namespace

Result<TilesStats> renderTiles(const std::vector<std::unique_ptr<Renderer>> &renderers, const TilesRequest &request,
                               const TiledPicture &picture, TileStore &store)
{
    TileWork work(request, picture, store, 2 * renderers.size() + 1);
    const int threads = request.threads > 0 ? request.threads : hardwareThreads();
    std::vector<std::jthread> encoders, others;
    for (int i = 0; i < threads; ++i)
        encoders.emplace_back([&] { work.encode(); });
    for (std::size_t i = 1; i < renderers.size(); ++i)
        others.emplace_back([&, i] { work.draw(*renderers[i]); });
    work.draw(*renderers.front());
    others.clear();
    work.allDrawn();
    encoders.clear();
    return work.result();
}

} // namespace suffuse
