#include "render/cpu/cpu_renderer.h"

#include "render/parallel.h"

#include <QCoreApplication>
#include <QElapsedTimer>

#include <algorithm>

namespace suffuse {

namespace {

constexpr int defaultTile = 48;

double milliseconds(const QElapsedTimer &timer)
{
    return double(timer.nsecsElapsed()) * 1e-6;
}

/// As processors name it, not as Highway does.
QString instructionSet()
{
    const QString name = QString::fromLatin1(cpu::kernels().name);
    return name.startsWith(QLatin1String("AVX3")) ? QStringLiteral("AVX-512") : name;
}

} // namespace

CpuRenderer::CpuRenderer(int threads, int tileSize, bool cull)
    : m_threads(threads > 0 ? threads : hardwareThreads()),
      m_tileSize(tileSize > 0 ? (tileSize + 7) / 8 * 8 : defaultTile), m_scene(cull)
{
}

QString CpuRenderer::deviceName() const
{
    return QCoreApplication::translate("Renderer", "%n threads", nullptr, m_threads) + QStringLiteral(" · ") +
           instructionSet();
}

bool CpuRenderer::sameFrame(const RenderRequest &request, const Target &target) const
{
    return m_target == target.serial() && m_frame.view == request.view && m_frame.transparent == request.transparent &&
           m_frame.canvas.background == request.painting->canvas.background &&
           m_frame.canvas.paper == request.painting->canvas.paper;
}

void CpuRenderer::markDifferences(const SceneChange &change)
{
    const auto &scene = m_scene.strokes();
    if (!change.reordered) {
        for (const SceneChange::Replaced &r : change.replaced)
            markChanged(*r.before, *scene[r.index], m_frame.view, m_region);
        return;
    }
    std::unordered_map<StrokeId, const SceneStroke *> old, now;
    std::vector<StrokeId> orderBefore, orderAfter;
    for (const auto &s : change.before)
        old[s->stroke->id] = s.get(), orderBefore.push_back(s->stroke->id);
    for (const auto &s : scene) {
        now[s->stroke->id] = s.get(), orderAfter.push_back(s->stroke->id);
        const auto it = old.find(s->stroke->id);
        if (it == old.end())
            m_region.mark(s->bounds);
        else if (it->second != s.get())
            markChanged(*it->second, *s, m_frame.view, m_region);
        old.erase(s->stroke->id);
    }
    for (const auto &[id, stroke] : old)
        m_region.mark(stroke->bounds);
    for (StrokeId id : movedInOrder(orderBefore, orderAfter))
        m_region.mark(now[id]->bounds);
}

std::size_t CpuRenderer::firstDifference(const SceneChange &change) const
{
    if (!change.reordered)
        return change.replaced.empty() ? noEdit : change.replaced.front().index;
    // Scene strokes are shared while they stay the same: what both scenes begin with did not change.
    const auto &scene = m_scene.strokes();
    const auto [before, now] = std::mismatch(change.before.begin(), change.before.end(), scene.begin(), scene.end());
    return before == change.before.end() && now == scene.end() ? noEdit : std::size_t(now - scene.begin());
}

void CpuRenderer::updateLayers(const SceneChange &change, bool interactive)
{
    m_oneEdited = false;
    if (const std::size_t first = firstDifference(change); first != noEdit) {
        // Kept a little lower than needed while several strokes change by turns (they dry one after another).
        const std::size_t slack = interactive ? 0 : 4;
        if (m_edited == noEdit || first < m_edited || first > m_edited + slack) {
            m_layers.clear();
            m_edited = first;
        }
        m_oneEdited = first == m_edited && change.replaced.size() == 1;
        if (!m_oneEdited)
            m_layers.dropOver();
    }
    if (!interactive)
        for (int row = 0; row < m_region.rows(); ++row)
            for (int column = 0; column < m_region.columns(); ++column)
                if (std::uint8_t &approximate = m_approximate[tileIndex(column, row)]; approximate) {
                    m_region.mark(m_region.tile(column, row));
                    approximate = 0;
                }
}

void CpuRenderer::forgetLayers()
{
    m_layers.clear();
    m_edited = noEdit;
    m_oneEdited = false;
    m_approximate.assign(std::size_t(m_region.columns()) * std::size_t(m_region.rows()), 0);
}

std::vector<CpuRenderer::Job> CpuRenderer::planJobs(bool interactive)
{
    std::vector<Job> jobs;
    for (int row = 0; row < m_region.rows(); ++row)
        for (int column = 0; column < m_region.columns(); ++column) {
            if (!m_region.isDirty(column, row))
                continue;
            Job job;
            job.column = column;
            job.row = row;
            if (m_edited != noEdit) {
                cpu::TileLayers &layers = m_layers.at(tileIndex(column, row));
                const PixelRect tile = m_region.tile(column, row);
                const auto across = [](int pixels) { return std::size_t((pixels + cpu::blockSide - 1) / cpu::blockSide); };
                const std::size_t blocks = across(tile.width) * across(tile.height);
                job.plan.layers = &layers;
                job.plan.storeUnder = layers.under.empty();
                layers.under.resize(blocks);
                if (interactive && m_oneEdited) {
                    job.plan.applyOver = !layers.over.empty();
                    job.plan.storeOver = layers.over.empty();
                    layers.over.resize(blocks);
                }
            }
            jobs.push_back(job);
        }
    return jobs;
}

void CpuRenderer::binStrokes(std::vector<Job> &jobs) const
{
    struct Row {
        std::vector<Job *> jobs;
        std::vector<std::uint32_t> strokes;
    };
    std::vector<Row> rows(std::size_t(m_region.rows()));
    std::size_t from = m_scene.strokes().size(), to = 0;
    for (Job &job : jobs) {
        rows[std::size_t(job.row)].jobs.push_back(&job);
        const bool haveUnder = job.plan.layers && !job.plan.storeUnder;
        job.from = haveUnder ? m_edited : 0;
        job.to = job.plan.applyOver ? std::min(m_edited + 1, m_scene.strokes().size()) : m_scene.strokes().size();
        from = std::min(from, job.from);
        to = std::max(to, job.to);
    }
    for (std::size_t i = from; i < to; ++i) {
        const TileRange tiles = m_region.tilesOf(m_scene.bounds()[i]);
        for (int y = tiles.top; y < tiles.bottom; ++y)
            if (Row &row = rows[std::size_t(y)]; !row.jobs.empty())
                row.strokes.push_back(std::uint32_t(i));
    }
    parallelFor(rows.size(), m_threads, [&](std::size_t y) {
        std::vector<Job *> atColumn(std::size_t(m_region.columns()), nullptr);
        for (Job *job : rows[y].jobs)
            atColumn[std::size_t(job->column)] = job;
        for (const std::uint32_t i : rows[y].strokes) {
            const TileRange tiles = m_region.tilesOf(m_scene.bounds()[i]);
            for (int x = tiles.left; x < tiles.right; ++x)
                if (Job *job = atColumn[std::size_t(x)]; job && i >= job->from && i < job->to)
                    job->strokes.push_back(i);
        }
    });
}

void CpuRenderer::paint(const Job &job, Target &target)
{
    const PixelRect tile = m_region.tile(job.column, job.row);
    const auto &scene = m_scene.strokes();
    const SceneStroke *edited = m_edited < scene.size() ? scene[m_edited].get() : nullptr;
    // Blocks reach over the picture's edge; a pixel around covers supersampled samples.
    const Rect area = Rect::of(tile.x, tile.y, std::max(tile.width, cpu::blockSide), std::max(tile.height, cpu::blockSide));
    thread_local std::vector<cpu::TileStroke> selected; // keeps its memory from tile to tile
    std::size_t count = 0;
    cpu::TilePlan plan = job.plan;
    for (const std::uint32_t i : job.strokes) {
        if (count == selected.size())
            selected.emplace_back();
        if (!cpu::selectNodes(*m_frame.kernels, *scene[i], area.grown(1), selected[count]))
            continue;
        plan.below += m_edited != noEdit && i < m_edited;
        ++count;
    }
    thread_local std::vector<float> rgba;
    rgba.resize(std::size_t(tile.width) * std::size_t(tile.height) * 4);
    cpu::paintTile(m_frame, tile, {selected.data(), count}, plan, edited, rgba.data());
    target.store(tile, rgba.data(), tile.width);
}

Result<RenderStats> CpuRenderer::render(const RenderRequest &request, Target &target, const std::atomic<bool> *cancel)
{
    RenderStats stats;
    QElapsedTimer total, stage;
    total.start();
    stage.start();
    const auto cancelled = [cancel] { return cancel && cancel->load(std::memory_order_relaxed); };
    auto paper = paperTexture(request.painting->canvas.paper);
    if (!paper)
        return Error{paper.error()};

    const bool incremental = sameFrame(request, target);
    const SceneChange change = m_scene.update(request, m_threads);
    const bool resized =
        m_target != target.serial() || m_frame.view.width != request.view.width || m_frame.view.height != request.view.height;
    m_frame = {request.view, request.painting->canvas, *paper, request.transparent, &cpu::kernels()};
    if (resized)
        target.resize(request.view.width, request.view.height);
    if (incremental) {
        markDifferences(change);
        updateLayers(change, request.interactive);
    } else {
        m_region.reset(request.view.width, request.view.height, m_tileSize);
        forgetLayers();
        m_target = target.serial();
    }
    stats.nodes = m_scene.nodeCount();
    stats.nodesMs = milliseconds(stage);
    stage.restart();

    std::vector<Job> jobs = planJobs(request.interactive);
    if (!cancelled())
        binStrokes(jobs);
    stats.binningMs = milliseconds(stage);
    stage.restart();

    std::vector<std::uint8_t> done(jobs.size(), 0);
    if (!cancelled())
        parallelFor(jobs.size(), m_threads, [&](std::size_t i) {
            if (cancelled())
                return;
            paint(jobs[i], target);
            done[i] = 1;
        });
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        const std::size_t tile = tileIndex(jobs[i].column, jobs[i].row);
        if (done[i]) {
            m_region.clean(jobs[i].column, jobs[i].row);
            stats.dirty.push_back(m_region.tile(jobs[i].column, jobs[i].row));
            m_approximate[tile] = jobs[i].plan.applyOver;
            used.push_back(tile);
        } else if (jobs[i].plan.layers) {
            *jobs[i].plan.layers = {}; // not filled
        }
    }
    m_layers.keep(used);
    stats.tiles = m_region.columns() * m_region.rows();
    stats.tilesEvaluated = int(stats.dirty.size());
    stats.cancelled = stats.dirty.size() < jobs.size();
    stats.tilesMs = milliseconds(stage);
    stats.totalMs = milliseconds(total);
    return stats;
}

} // namespace suffuse
