#include "render/cpu/cpu_renderer.h"
#include "render/elapsed.h"

#include <QCoreApplication>

#include <algorithm>
#include <optional>

namespace suffuse {

namespace {

constexpr int defaultTile = 48, greatestTile = cpu::gridSide * cpu::blockSide;

/// The side of tiles for a size that was asked for.
int tileSide(int asked)
{
    return asked > 0 ? std::min((asked + 7) / 8 * 8, greatestTile) : defaultTile;
}

/// How many blocks a tile has.
std::size_t blocksIn(int width, int height)
{
    const auto across = [](int pixels) { return std::size_t((pixels + cpu::blockSide - 1) / cpu::blockSide); };
    return across(width) * across(height);
}

/// A rectangle of the grid, counted from the picture's corner.
PixelRect inPicture(const PixelRect &r, const PixelRect &picture)
{
    return {r.x - picture.x, r.y - picture.y, r.width, r.height};
}

/// The least rectangle around two, of which the first may be empty.
PixelRect around(const PixelRect &a, const PixelRect &b)
{
    if (a.isEmpty())
        return b;
    const int left = std::min(a.x, b.x), top = std::min(a.y, b.y);
    return {left, top, std::max(a.x + a.width, b.x + b.width) - left, std::max(a.y + a.height, b.y + b.height) - top};
}

/// The name of the instruction set as processors have it, which is not Highway's.
QString instructionSet()
{
    const QString name = QString::fromLatin1(cpu::kernels().name);
    return name.startsWith(QLatin1String("AVX3")) ? QStringLiteral("AVX-512") : name;
}

} // namespace

CpuRenderer::CpuRenderer(int threads, int tileSize, bool cull)
    : m_threads(threads), m_history(tileSide(tileSize), cull), m_paper(blocksIn(tileSide(tileSize), tileSide(tileSize)))
{}

QString CpuRenderer::deviceName() const
{
    return QCoreApplication::translate("Renderer", "%n threads", nullptr, m_threads.count()) + QStringLiteral(" · ") +
           instructionSet();
}

void CpuRenderer::followEdits(const FrameHistory::Step &step)
{
    if (!step.keepsUnder)
        m_layers.clear();
    else if (!step.keepsOver)
        m_layers.dropOver();
    if (step.raisesUnder)
        m_layers.dropPrefixes(m_history.edited());
    m_changed.clear();
    for (const SceneChange::Replaced &r : step.scene.replaced)
        m_changed.push_back(
            {std::uint32_t(r.index), cpu::steadyNodes(*r.before, *m_history.scene().strokes()[r.index])});
    if (step.scene.reordered)
        m_layers.dropPrefixes();
    else
        m_layers.dropPrefixes(m_changed);
}

bool CpuRenderer::keepsOver() const
{
    const Composition &composition = m_history.scene().composition();
    if (const int layer = m_history.layerEdited(); layer != Layer::none)
        return !composition.boundsOthers(layer);
    if (!m_history.oneEdited())
        return false;
    const std::size_t stroke = m_history.edited();
    return composition.shapeOf(stroke) == Layer::none && !composition.boundsOthers(composition.layerOf(stroke));
}

std::vector<CpuRenderer::Job> CpuRenderer::planJobs(bool interactive)
{
    std::vector<Job> jobs;
    const bool over = interactive && m_history.edited() != FrameHistory::noEdit && keepsOver();
    const DirtyRegion &region = m_history.region();
    for (int row = 0; row < region.rows(); ++row)
        for (int column = 0; column < region.columns(); ++column) {
            if (!region.isDirty(column, row))
                continue;
            Job job;
            job.column = column;
            job.row = row;
            job.plan.tile = m_history.tileIndex(column, row);
            if (m_history.edited() != FrameHistory::noEdit) {
                cpu::TileLayers &layers = m_layers.at(job.plan.tile);
                const PixelRect tile = region.tile(column, row);
                const std::size_t blocks = blocksIn(tile.width, tile.height);
                job.plan.layers = &layers;
                job.plan.haveUnder = !layers.under.empty();
                job.from = job.plan.haveUnder ? layers.below : 0;
                job.plan.storeUnder = !job.plan.haveUnder || layers.below < m_history.edited();
                const bool isFlat = m_history.scene().composition().isFlat();
                layers.under.resize(blocks);
                layers.open.resize(isFlat ? 0 : blocks);
                layers.below = m_history.edited();
                if (over) {
                    job.plan.applyOver = !layers.over.empty();
                    job.plan.storeOver = layers.over.empty();
                    job.plan.onlyMet = job.plan.applyOver && !job.plan.storeUnder && !layers.met.empty();
                    layers.over.resize(blocks);
                }
                layers.met.resize(over ? blocks : 0);
            }
            jobs.push_back(job);
        }
    return jobs;
}

void CpuRenderer::binStrokes(std::vector<Job> &jobs) const
{
    const DirtyRegion &region = m_history.region();
    const LiveScene &scene = m_history.scene();
    const std::size_t edited = m_history.edited();
    struct Row {
        std::vector<Job *> jobs;
        std::vector<std::uint32_t> strokes;
    };
    std::vector<Row> rows(std::size_t(region.rows()));
    std::size_t from = scene.strokes().size(), to = 0;
    for (Job &job : jobs) {
        rows[std::size_t(job.row)].jobs.push_back(&job);
        job.to = scene.strokes().size();
        if (job.plan.applyOver)
            job.to = std::min(edited + (m_history.oneEdited() ? 1 : 0), job.to);
        from = std::min(from, job.from);
        to = std::max(to, job.to);
    }
    for (std::size_t i = from; i < to; ++i) {
        const TileRange tiles = region.tilesOf(scene.bounds()[i]);
        for (int y = tiles.top; y < tiles.bottom; ++y)
            if (Row &row = rows[std::size_t(y)]; !row.jobs.empty())
                row.strokes.push_back(std::uint32_t(i));
    }
    parallelFor(rows.size(), m_threads, [&](std::size_t y) {
        std::vector<Job *> atColumn(std::size_t(region.columns()), nullptr);
        for (Job *job : rows[y].jobs)
            atColumn[std::size_t(job->column)] = job;
        for (const std::uint32_t i : rows[y].strokes) {
            const TileRange tiles = region.tilesOf(scene.bounds()[i]);
            for (int x = tiles.left; x < tiles.right; ++x)
                if (Job *job = atColumn[std::size_t(x)]; job && i >= job->from && i < job->to)
                    job->strokes.push_back(i);
        }
    });
}

const cpu::StrokePrefix *CpuRenderer::prefixOf(const Job &job, std::uint32_t stroke, cpu::TileStrokes &strokes) const
{
    const auto changed = std::ranges::lower_bound(m_changed, stroke, {}, &cpu::SteadyStroke::stroke);
    if (!job.plan.layers || changed == m_changed.end() || changed->stroke != stroke || changed->nodes == 0)
        return nullptr;
    cpu::StrokePrefix &prefix = job.plan.layers->prefixOf(stroke);
    strokes.settle(*m_history.scene().strokes()[stroke], changed->nodes, prefix);
    return &prefix;
}

PixelRect CpuRenderer::paint(const Job &job, Target &target)
{
    const PixelRect tile = m_history.region().tile(job.column, job.row);
    const auto &scene = m_history.scene().strokes();
    const std::size_t first = m_history.edited();
    cpu::Edited edited;
    edited.layer = m_history.layerEdited();
    if (first < scene.size() && edited.layer == Layer::none)
        edited.stroke = scene[first].get(), edited.place = first;
    thread_local cpu::TileStrokes strokes; // It keeps its memory from tile to tile.
    strokes.begin(*m_frame.kernels, tile, m_frame.grid.window);
    cpu::TilePlan plan = job.plan;
    for (const std::uint32_t i : job.strokes)
        plan.below +=
            strokes.add(*scene[i], i, prefixOf(job, i, strokes)) && first != FrameHistory::noEdit && i < first;
    thread_local std::vector<float> rgba;
    rgba.resize(std::size_t(tile.width) * std::size_t(tile.height) * 4);
    return store(tile, cpu::paintTile(m_frame, tile, strokes, plan, edited, rgba.data()), rgba.data(), target);
}

PixelRect CpuRenderer::store(const PixelRect &tile, const cpu::PaintedBlocks &painted, const float *rgba,
                             Target &target) const
{
    const DirtyRegion &region = m_history.region();
    PixelRect box;
    const auto storeBox = [&](const PixelRect &pixels) {
        const PixelRect seen = region.clipped(pixels);
        if (seen.isEmpty())
            return;
        const std::size_t skipped =
            std::size_t(seen.y - tile.y) * std::size_t(tile.width) + std::size_t(seen.x - tile.x);
        const PixelRect place = inPicture(seen, region.picture());
        target.store(place, rgba + skipped * 4, tile.width);
        box = around(box, place);
    };
    const std::size_t blocks = blocksIn(tile.width, tile.height);
    if (std::count(painted.begin(), painted.end(), true) == std::ptrdiff_t(blocks)) {
        storeBox(tile);
        return box;
    }
    std::size_t index = 0;
    for (int y = 0; y < tile.height; y += cpu::blockSide)
        for (int x = 0; x < tile.width; x += cpu::blockSide, ++index)
            if (painted[index])
                storeBox({tile.x + x, tile.y + y, std::min(cpu::blockSide, tile.width - x),
                          std::min(cpu::blockSide, tile.height - y)});
    return box;
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

    const PictureGrid whole = PictureGrid::ofDocument(request.view);
    const PictureGrid grid = request.part.isEmpty() ? whole : whole.part(request.part, request.near);
    const FrameHistory::Step step = m_history.advance(request, grid, target, m_threads, cancel);
    const DirtyRegion &region = m_history.region();
    m_paper.begin(cpu::kernels(), grid, request.painting->canvas.paper, *paper,
                  std::size_t(region.columns()) * std::size_t(region.rows()));
    m_frame = {grid,
               request.painting->canvas,
               &m_paper,
               request.transparent,
               &cpu::kernels(),
               &m_history.scene().composition()};
    followEdits(step);
    stats.nodes = m_history.scene().nodeCount();
    stats.nodesMs = milliseconds(stage);
    stage.restart();

    std::vector<Job> jobs = planJobs(request.interactive);
    if (!cancelled())
        binStrokes(jobs);
    stats.binningMs = milliseconds(stage);
    stage.restart();

    std::vector<std::optional<PixelRect>> painted(jobs.size());
    if (!cancelled())
        parallelFor(jobs.size(), m_threads, [&](std::size_t i) {
            if (cancelled())
                return;
            painted[i] = paint(jobs[i], target);
        });
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        if (painted[i]) {
            m_history.drawn(jobs[i].column, jobs[i].row, jobs[i].plan.applyOver);
            if (!painted[i]->isEmpty())
                stats.dirty.push_back(*painted[i]);
            used.push_back(m_history.tileIndex(jobs[i].column, jobs[i].row));
        } else if (jobs[i].plan.layers) {
            *jobs[i].plan.layers = {}; // The layers were not filled.
        }
    }
    m_layers.keep(used);
    stats.tiles = region.columns() * region.rows();
    stats.tilesEvaluated = int(used.size());
    stats.cancelled = used.size() < jobs.size();
    stats.pixelsEvaluated = pixelsIn(stats.dirty);
    if (step.moved)
        stats.dirty = {{0, 0, grid.picture.width, grid.picture.height}};
    stats.tilesMs = milliseconds(stage);
    stats.totalMs = milliseconds(total);
    return stats;
}

} // namespace suffuse
