#include "render/cpu/cpu_renderer.h"

#include "render/parallel.h"

#include <QCoreApplication>
#include <QElapsedTimer>

#include <algorithm>

namespace suffuse {

namespace {

constexpr int defaultTile = 32;

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

CpuRenderer::CpuRenderer(int threads, int tileSize)
    : m_threads(threads > 0 ? threads : hardwareThreads()),
      m_tileSize(tileSize > 0 ? (tileSize + 7) / 8 * 8 : defaultTile)
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

void CpuRenderer::alignEntries(const Painting &painting)
{
    std::vector<StrokePtr> strokes;
    strokes.reserve(painting.strokes.size());
    for (const StrokePtr &s : painting.strokes)
        if (painting.isVisible(*s))
            strokes.push_back(s);
    // Most edits leave the order as it is.
    std::size_t same = 0;
    while (same < strokes.size() && same < m_entries.size() && m_entries[same].stroke->id == strokes[same]->id)
        ++same;
    if (same < strokes.size() || same < m_entries.size()) {
        std::unordered_map<StrokeId, std::size_t> old;
        for (std::size_t i = same; i < m_entries.size(); ++i)
            old[m_entries[i].stroke->id] = i;
        std::vector<Entry> rest(strokes.size() - same);
        for (std::size_t i = same; i < strokes.size(); ++i)
            if (const auto it = old.find(strokes[i]->id); it != old.end())
                rest[i - same] = std::move(m_entries[it->second]);
        m_entries.resize(same);
        std::move(rest.begin(), rest.end(), std::back_inserter(m_entries));
    }
    for (std::size_t i = 0; i < strokes.size(); ++i)
        if (Entry &entry = m_entries[i]; entry.stroke != strokes[i]) {
            entry.stroke = strokes[i];
            entry.driesAt = strokes[i]->driesAt();
        }
}

void CpuRenderer::updateScene(const RenderRequest &request)
{
    const View &view = request.view;
    const int octave = zoomOctave(view.scale);
    const Rect visible = visibleBox(view);
    const bool sameView = m_frame.view == view;
    const bool sameOctave = zoomOctave(m_frame.view.scale) == octave;
    alignEntries(*request.painting);

    std::vector<std::pair<std::size_t, bool>> stale; // entry; whether its nodes are still good
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        Entry &entry = m_entries[i];
        const bool sameStroke = entry.scene && entry.scene->stroke == entry.stroke;
        const bool sameAge =
            entry.time == request.time || (entry.driesAt <= entry.time && entry.driesAt <= request.time);
        const bool nodes = sameStroke && sameAge && sameOctave && (sameView || !entry.scene->source->clipped);
        if (!nodes || !sameView)
            stale.emplace_back(i, nodes);
        entry.time = request.time;
    }
    parallelFor(stale.size(), m_threads, [&](std::size_t i) {
        Entry &entry = m_entries[stale[i].first];
        auto nodes = stale[i].second ? entry.scene->source : buildNodes(*entry.stroke, request.time, octave, visible);
        entry.scene = std::make_shared<const SceneStroke>(makeSceneStroke(entry.stroke, std::move(nodes), view));
    });
    m_scene.resize(m_entries.size());
    for (std::size_t i = 0; i < m_entries.size(); ++i)
        if (m_scene[i] != m_entries[i].scene)
            m_scene[i] = m_entries[i].scene;
}

void CpuRenderer::markDifferences(const std::vector<std::shared_ptr<const SceneStroke>> &before)
{
    const auto sameIds = [](const auto &a, const auto &b) { return a->stroke->id == b->stroke->id; };
    if (std::equal(before.begin(), before.end(), m_scene.begin(), m_scene.end(), sameIds)) {
        for (std::size_t i = 0; i < m_scene.size(); ++i)
            if (before[i] != m_scene[i])
                markChanged(*before[i], *m_scene[i], m_frame.view, m_region);
        return;
    }
    std::unordered_map<StrokeId, const SceneStroke *> old, now;
    std::vector<StrokeId> orderBefore, orderAfter;
    for (const auto &s : before)
        old[s->stroke->id] = s.get(), orderBefore.push_back(s->stroke->id);
    for (const auto &s : m_scene) {
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

void CpuRenderer::updateLayers(const std::vector<std::shared_ptr<const SceneStroke>> &before, bool incremental,
                               bool interactive)
{
    if (!incremental) {
        m_layers.clear();
        m_edited = noEdit;
        m_oneEdited = false;
        m_approximate.assign(std::size_t(m_region.columns()) * std::size_t(m_region.rows()), 0);
        return;
    }
    // Scene strokes are shared while they stay the same: what both scenes begin with did not change.
    const std::size_t common = std::min(before.size(), m_scene.size());
    std::size_t first = 0;
    while (first < common && before[first] == m_scene[first])
        ++first;
    m_oneEdited = false;
    if (first < before.size() || first < m_scene.size()) {
        // Kept a little lower than needed while several strokes change by turns (they dry one after another).
        constexpr std::size_t slack = 4;
        if (m_edited == noEdit || first < m_edited || first > m_edited + slack) {
            m_layers.clear();
            m_edited = first;
        }
        m_oneEdited = first == m_edited && before.size() == m_scene.size() &&
                      std::equal(before.begin() + std::ptrdiff_t(first) + 1, before.end(),
                                 m_scene.begin() + std::ptrdiff_t(first) + 1);
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

std::vector<CpuRenderer::Job> CpuRenderer::planJobs(bool interactive)
{
    std::vector<Job> jobs;
    for (int row = 0; row < m_region.rows(); ++row)
        for (int column = 0; column < m_region.columns(); ++column) {
            if (!m_region.isDirty(column, row))
                continue;
            Job job{column, row, {}};
            if (m_edited != noEdit && m_edited > 0) {
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

CpuRenderer::Row CpuRenderer::rowStrokes(int row, bool fromEdited) const
{
    Row result;
    const PixelRect first = m_region.tile(0, row);
    const Rect band = Rect::of(0, first.y, m_frame.view.width, first.height);
    std::vector<const cpu::ViewNode *> all;
    cpu::TileStroke selected;
    for (std::size_t i = fromEdited ? m_edited : 0; i < m_scene.size(); ++i) {
        const SceneStroke &s = *m_scene[i];
        const PixelRect &b = s.bounds;
        if (b.isEmpty() || b.y >= first.y + first.height || b.y + b.height <= first.y)
            continue;
        all.clear();
        for (const cpu::ViewNode &n : s.nodes)
            all.push_back(&n);
        if (!cpu::selectNodes(*m_frame.kernels, s, all, band.grown(1), selected))
            continue;
        result.strokes.push_back(selected);
        result.below += m_edited != noEdit && i < m_edited;
    }
    return result;
}

void CpuRenderer::paint(const Job &job, const Row &row, Target &target)
{
    const PixelRect tile = m_region.tile(job.column, job.row);
    const SceneStroke *edited = m_edited < m_scene.size() ? m_scene[m_edited].get() : nullptr;
    // Blocks reach over the picture's edge; a pixel around covers supersampled samples.
    const Rect area = Rect::of(tile.x, tile.y, std::max(tile.width, cpu::blockSide), std::max(tile.height, cpu::blockSide));
    const bool haveUnder = job.plan.layers && !job.plan.storeUnder;
    std::vector<cpu::TileStroke> selected;
    cpu::TilePlan plan = job.plan;
    cpu::TileStroke one;
    for (std::size_t i = haveUnder ? row.below : 0; i < row.strokes.size(); ++i) {
        const cpu::TileStroke &s = row.strokes[i];
        if (plan.applyOver && s.stroke != edited)
            continue;
        const PixelRect &b = s.stroke->bounds;
        if (b.x >= tile.x + tile.width || b.x + b.width <= tile.x)
            continue;
        if (!cpu::selectNodes(*m_frame.kernels, *s.stroke, s.nodes, area.grown(1), one))
            continue;
        plan.below += i < row.below;
        selected.push_back(std::move(one));
        one = {};
    }
    std::vector<float> rgba(std::size_t(tile.width) * std::size_t(tile.height) * 4);
    cpu::paintTile(m_frame, tile, selected, plan, edited, rgba.data());
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
    const auto before = m_scene;
    updateScene(request);
    const bool resized =
        m_target != target.serial() || m_frame.view.width != request.view.width || m_frame.view.height != request.view.height;
    m_frame = {request.view, request.painting->canvas, *paper, request.transparent, &cpu::kernels()};
    if (resized)
        target.resize(request.view.width, request.view.height);
    if (incremental) {
        markDifferences(before);
    } else {
        m_region.reset(request.view.width, request.view.height, m_tileSize);
        m_target = target.serial();
    }
    for (const auto &s : m_scene)
        stats.nodes += s->source->nodes.size();
    stats.nodesMs = milliseconds(stage);
    stage.restart();

    updateLayers(before, incremental, request.interactive);
    const std::vector<Job> jobs = planJobs(request.interactive);
    std::vector<std::uint8_t> needed(std::size_t(m_region.rows()), 0); // 1: from the edited stroke on, 2: all
    for (const Job &job : jobs) {
        const bool haveUnder = job.plan.layers && !job.plan.storeUnder;
        needed[std::size_t(job.row)] = std::max<std::uint8_t>(needed[std::size_t(job.row)], haveUnder ? 1 : 2);
    }
    std::vector<Row> rows(needed.size());
    parallelFor(rows.size(), m_threads, [&](std::size_t row) {
        if (needed[row] && !cancelled())
            rows[row] = rowStrokes(int(row), needed[row] == 1);
    });
    stats.binningMs = milliseconds(stage);
    stage.restart();

    std::vector<std::uint8_t> done(jobs.size(), 0);
    if (!cancelled())
        parallelFor(jobs.size(), m_threads, [&](std::size_t i) {
            if (cancelled())
                return;
            paint(jobs[i], rows[std::size_t(jobs[i].row)], target);
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
