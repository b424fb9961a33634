#include "render/cuda/tile_worker.h"

#include "render/math/scalar.h"
// It has templates over the numbers, which must be declared before.
#include "render/math/colour.h"

#include <bit>
#include <numbers>
#include <utility>

namespace suffuse::cuda {

namespace {

constexpr std::size_t mostBandTiles = 65535; // They are counted by 16 bits.
/// So many tiles of float pixels take 32 MiB.
constexpr std::size_t mostFloatTiles = 8192;
constexpr std::size_t fewestBandTiles = 64;
/// Slots for strokes that are evaluated apart take 4 kB each: 1 to 128 MiB.
constexpr std::size_t fewestApart = 256, mostApart = 32768;
/// Where there are fewer costly strokes than one in so many tiles, the next call has none evaluated apart, since the
/// kernel that cannot do so is the faster one. In the general kernel strokes cost more.
constexpr std::size_t fewApart = 2, fewApartInGeneral = 4;
/// Where there are more tiles than these, all multiprocessors have enough to do without cheap fills being apart.
constexpr std::size_t manyTiles = 8192;
constexpr std::uint32_t costlyFill = 1000;
/// Planes of the paper take 1 kB each, at most 64 MiB.
constexpr std::size_t mostEtaPlanes = 65536, manyEtaPlanes = 5;
/// All lists of a band have at most so many entries. Macro-tiles are counted by 16 bits.
constexpr std::size_t mostListed = std::size_t(1) << 23, mostMacros = 65535;

ToCanvas toCanvasOf(const View &v)
{
    const Point origin = v.toCanvas({0, 0});
    const double c = std::cos(v.rotation) / v.scale, s = std::sin(v.rotation) / v.scale, flip = v.mirrored ? -1 : 1;
    // As on the CPU, a pixel that is turned against the canvas' axes may reach half its diagonal.
    const double quarter = v.rotation / (0.5 * std::numbers::pi);
    const bool upright = std::abs(quarter - std::round(quarter)) < 1e-12;
    return {origin.x, origin.y, flip * c, flip * s, -s, c, v.px(), v.px() * (upright ? 0.5 : std::numbers::sqrt2 / 2)};
}

} // namespace

TileWorker::TileWorker(std::shared_ptr<Device> device, bool cull, Threads threads, const ApartLimits &apart)
    : m_device(std::move(device)), m_threads(threads), m_scene(*m_device), m_layers(*m_device),
      m_composition(*m_device), m_layerPixels(*m_device), m_boundPixels(*m_device), m_paper(*m_device),
      m_tileJobs(*m_device), m_macroJobs(*m_device), m_hostStatus(*m_device), m_deviceTileJobs(*m_device),
      m_deviceMacroJobs(*m_device), m_status(*m_device), m_listCounts(*m_device), m_order(*m_device),
      m_lists(*m_device), m_apart(*m_device), m_apartJobs(*m_device), m_apartSamples(*m_device), m_apartDone(*m_device),
      m_eta(*m_device), m_etaKnown(*m_device), m_buffers{TileBuffer(*m_device), TileBuffer(*m_device)},
      m_bandTiles(mostBandTiles)
{
    m_frame.cull = cull;
    m_apartLimits = apart;
}

void TileWorker::releaseBuffers()
{
    m_lists.release();
    m_apart.release(), m_apartJobs.release(), m_apartSamples.release(), m_apartDone.release();
    m_apartRoom = 0;
    m_layerPixels.release();
    m_boundPixels.release();
    for (TileBuffer &buffer : m_buffers)
        buffer.onDevice.release(), buffer.onHost.release();
}

bool TileWorker::releaseSpare()
{
    const bool any = m_layers.hasMemory() || m_lists.data();
    m_layers.refuse();
    releaseBuffers();
    return any;
}

Fault TileWorker::updatePaper(const Paper &paper, const std::shared_ptr<const PaperTexture> &texture)
{
    m_frame.paper = {};
    if (paper.strength <= 0 || (paper.kind == PaperKind::Image && !texture))
        return {};
    m_frame.paper.kind = std::int32_t(paper.kind);
    m_frame.paper.grain = std::int32_t(paper.grain);
    m_frame.paper.seed = paper.seed;
    m_frame.paper.scale = paper.scale;
    m_frame.paper.strength = paper.strength;
    if (paper.kind != PaperKind::Image)
        return {};
    if (texture != m_paperTexture) {
        m_paperTexture = nullptr;
        if (Fault fault = m_paper.reserve(texture->grey.size()))
            return fault;
        if (Fault fault = m_device->upload(m_paper.data(), texture->grey.data(), texture->grey.size() * sizeof(float)))
            return fault;
        m_paperTexture = texture;
    }
    m_frame.paper.width = texture->width, m_frame.paper.height = texture->height;
    m_frame.paper.grey = m_paper.data();
    return {};
}

Fault TileWorker::prepare(const FrameHistory &history, const FrameHistory::Step &step, const RenderRequest &request,
                          const std::shared_ptr<const PaperTexture> &paper)
{
    if (step.whole) {
        m_layers.allow();
        m_apartRefused = m_etaRefused = false;
        m_bandTiles = mostBandTiles;
    }
    if (!step.keepsUnder || step.raisesUnder)
        m_layers.clear();
    else if (!step.keepsOver)
        m_layers.dropOver();
    const Canvas &canvas = request.painting->canvas;
    const auto update = [&] {
        Fault fault = updatePaper(canvas.paper, paper);
        return fault ? fault
                     : m_scene.update(history.scene().strokes(), step.scene, request.view.width, request.view.height,
                                      m_threads);
    };
    Fault fault = update();
    if (fault.kind == Fault::OutOfMemory && releaseSpare()) {
        m_scene.forget();
        fault = update();
    }
    // What lies below and above is kept of pictures without layers alone.
    const bool edits = m_usesLayers =
        history.edited() != FrameHistory::noEdit && history.scene().composition().isFlat();
    if (!fault && edits)
        fault = m_layers.beginFrame(std::size_t(history.region().columns()) * std::size_t(history.region().rows()));
    const Colour &ground = canvas.background; // If it is not opaque it lies on white, RYB (0, 0, 0).
    if (!fault) {
        const math::Triple<float> rgb =
            math::rgbFromRyb(ground.red * ground.opacity, ground.yellow * ground.opacity, ground.blue * ground.opacity);
        const float opaque[3] = {rgb.x, rgb.y, rgb.z};
        fault = m_composition.update(history.scene().composition(), m_scene, request.transparent ? nullptr : opaque);
    }
    if (fault)
        return fault;
    m_scene.fill(m_frame);
    m_composition.fill(m_frame);
    m_frame.editedFrom = edits ? m_scene.firstChunk(history.edited()) : 0xffffffff;
    m_frame.editedTo = edits ? m_scene.firstChunk(history.edited() + 1) : 0xffffffff;
    m_frame.width = request.view.width, m_frame.height = request.view.height;
    const float opacity = request.transparent ? 0 : ground.opacity;
    m_frame.background[0] = ground.red * opacity;
    m_frame.background[1] = ground.yellow * opacity;
    m_frame.background[2] = ground.blue * opacity;
    m_frame.transparent = request.transparent;
    m_frame.toCanvas = toCanvasOf(request.view);
    return keepEta();
}

Fault TileWorker::keepEta()
{
    const auto tiles = [&](int pixels) { return std::size_t(pixels + tileSide - 1) / tileSide; };
    const std::size_t all = tiles(m_frame.width) * tiles(m_frame.height);
    const PaperParams &p = m_frame.paper;
    const ToCanvas &c = m_frame.toCanvas;
    const EtaOf now{{double(p.kind), double(p.grain), double(p.seed), p.scale, double(p.strength), double(p.width),
                     double(p.height), c.x0, c.y0, c.xx, c.xy, c.yx, c.yy, double(m_frame.width),
                     double(m_frame.height)},
                    m_paperTexture.get()};
    m_frame.etaPlanes = 0;
    if (m_frame.paper.kind == 0 || m_etaRefused || all > mostEtaPlanes)
        return {};
    m_frame.etaPlanes = all * manyEtaPlanes > mostEtaPlanes ? 1 : manyEtaPlanes;
    const std::size_t planes = all * m_frame.etaPlanes;
    bool grown = false;
    Fault fault = m_eta.reserve(planes * tileSize);
    if (!fault)
        fault = m_etaKnown.reserve(planes, &grown);
    if (fault) {
        m_eta.release(), m_etaKnown.release();
        m_etaRefused = true;
        m_frame.etaPlanes = 0;
        return fault.kind == Fault::Lost ? fault : Fault{};
    }
    m_frame.eta = m_eta.data();
    m_frame.etaKnown = m_etaKnown.data();
    if (grown) {
        m_frame.etaStamp = 0;
        if (Fault cleared = m_device->clear(m_etaKnown.data(), planes * sizeof(std::uint32_t)))
            return cleared;
    }
    if (grown || now != m_etaOf)
        ++m_frame.etaStamp;
    m_etaOf = now;
    return {};
}

Fault TileWorker::reserveApart(std::size_t tiles, std::size_t listed)
{
    m_frame.apartRoom = 0;
    if (m_apartRefused || !m_apartWorthIt)
        return {};
    const std::size_t wanted = std::clamp(std::max(2 * tiles, m_apartWanted), fewestApart, mostApart);
    bool grown = false;
    Fault fault = m_apart.reserve(listed);
    if (!fault && wanted > m_apartRoom) {
        const std::size_t room = std::bit_ceil(wanted);
        for (const Fault &f : {m_apartSamples.reserve(room * tileSize * 4), m_apartJobs.reserve(room * apartClasses),
                               m_apartDone.reserve(room * apartParts, &grown)})
            if (!fault)
                fault = f;
        m_apartRoom = fault ? 0 : room;
    }
    if (!fault && grown)
        fault = m_device->clear(m_apartDone.data(), m_apartRoom * apartParts * sizeof(std::uint32_t));
    if (fault.kind == Fault::OutOfMemory) {
        m_apart.release(), m_apartJobs.release(), m_apartSamples.release(), m_apartDone.release();
        m_apartRoom = 0, m_apartRefused = true;
        return {};
    }
    m_frame.apart = m_apart.data();
    m_frame.apartJobs = m_apartJobs.data();
    m_frame.apartSamples = m_apartSamples.data();
    m_frame.apartDone = m_apartDone.data();
    m_frame.apartRoom = std::uint32_t(m_apartRoom);
    m_frame.apartLimits = m_apartLimits;
    if (tiles > manyTiles)
        m_frame.apartLimits.ofFill = std::max(m_apartLimits.ofFill, costlyFill);
    ++m_frame.apartStamp;
    return fault;
}

Fault TileWorker::reserveJobs(std::size_t tiles)
{
    for (const Fault &fault : {m_tileJobs.reserve(tiles), m_macroJobs.reserve(tiles), m_hostStatus.reserve(statusWords),
                               m_deviceTileJobs.reserve(tiles), m_deviceMacroJobs.reserve(tiles)})
        if (fault)
            return fault;
    return {};
}

TileWorker::Band TileWorker::plan(const FrameHistory &history, bool interactive, std::span<const TileTask> tasks)
{
    constexpr std::size_t none = SIZE_MAX;
    const std::size_t macroLimit = std::clamp<std::size_t>(mostListed / (m_listRoom * listParts), 1, mostMacros);
    const bool edits = m_usesLayers, useOver = interactive && history.oneEdited();
    const bool opaque = !m_frame.transparent;
    const std::uint32_t editedFrom = m_frame.editedFrom, editedTo = m_frame.editedTo, chunks = m_scene.chunkCount();
    MacroJob *const macroJobs = m_macroJobs.data();
    std::size_t macros = 0;
    TileJob *job = m_tileJobs.data();
    std::array<std::size_t, 4> lists{}; // the lists of the present macro-tile, by which chunks are left out
    std::size_t list = none;            // the list of the last tile
    int column = -macroTiles, row = -macroTiles, last = 0;
    int any = 0, all = plainTile;
    for (const TileTask &task : tasks) {
        std::uint32_t slot = 0;
        int flags = 0;
        if (const TileLayer *layer = edits ? m_layers.at(task.index) : nullptr) {
            slot = layer->slot;
            flags = layer->under ? haveUnder : storeUnder;
            if (useOver)
                flags |= layer->over ? applyOver : storeOver;
        }
        if (opaque && !(flags & storeOver) && m_scene.isPlain(task.index))
            flags |= plainTile;
        const bool nextMacro = unsigned((task.column ^ column) | (task.row ^ row)) >= unsigned(macroTiles);
        if (nextMacro || flags != last) {
            if (nextMacro)
                lists.fill(none);
            column = task.column, row = task.row, last = flags;
            std::size_t &known = lists[std::size_t((flags & haveUnder ? 1 : 0) + (flags & applyOver ? 2 : 0))];
            if (known == none) {
                if (macros == macroLimit)
                    break;
                macroJobs[macros] = {column / macroTiles,
                                     row / macroTiles,
                                     flags & haveUnder ? editedFrom : 0,
                                     flags & applyOver ? editedTo : chunks,
                                     std::uint32_t(job - m_tileJobs.data()),
                                     {},
                                     {}};
                known = macros++;
            }
            list = known;
            any |= flags, all &= flags;
        }
        const int half = task.row % macroTiles / (macroTiles / 2);
        const std::uint32_t bit = 1u << (task.row % (macroTiles / 2) * macroTiles + task.column % macroTiles);
        macroJobs[list].painted[half] |= bit;
        macroJobs[list].general[half] |= flags & plainTile ? 0 : bit;
        *job++ = {task.column, task.row, std::uint16_t(list), std::uint16_t(flags), slot, 0};
    }
    return {std::size_t(job - m_tileJobs.data()), macros, any, !(all & plainTile)};
}

Fault TileWorker::run(const Band &band)
{
    const std::size_t lists = band.macros * listParts;
    const std::size_t words = statusWords + weightClasses + band.macros * macroTiles * macroTiles;
    for (const Fault &fault : {m_lists.reserve(lists * m_listRoom), m_listCounts.reserve(lists),
                               m_status.reserve(words), m_order.reserve(band.tiles * weightClasses)})
        if (fault)
            return fault;
    if (Fault fault = m_layerPixels.reserve(band.tiles * m_frame.layerPlanes * tileSize))
        return fault;
    m_frame.layerPixels = m_layerPixels.data();
    const bool isBounded = m_composition.isBounded();
    if (Fault fault = m_boundPixels.reserve(isBounded ? band.tiles * m_frame.layerPlanes * tileSize : 0))
        return fault;
    m_frame.boundPixels = isBounded ? m_boundPixels.data() : nullptr;
    if (Fault fault = reserveApart(band.tiles, lists * m_listRoom))
        return fault;
    m_frame.macros = m_deviceMacroJobs.data();
    m_frame.macroCount = std::uint32_t(band.macros);
    m_frame.tiles = m_deviceTileJobs.data();
    m_frame.tileCount = std::uint32_t(band.tiles);
    m_frame.lists = m_lists.data();
    m_frame.listCounts = m_listCounts.data();
    m_frame.listRoom = m_listRoom;
    m_frame.under = m_layers.under();
    m_frame.over = m_layers.over();
    m_frame.status = m_status.data();
    m_frame.classCounts = m_status.data() + statusWords;
    m_frame.weights = m_frame.classCounts + weightClasses;
    m_frame.order = m_order.data();
    if (Fault fault = m_device->clear(m_status.data(), words * sizeof(std::uint32_t)))
        return fault;
    if (Fault fault = m_device->upload(m_deviceTileJobs.data(), m_tileJobs.data(), band.tiles * sizeof(TileJob)))
        return fault;
    if (Fault fault = m_device->upload(m_deviceMacroJobs.data(), m_macroJobs.data(), band.macros * sizeof(MacroJob)))
        return fault;
    if (Fault fault =
            m_device->run(m_frame, {(band.flags & plainTile) != 0 || m_frame.apartRoom != 0, band.anyGeneral}))
        return fault;
    return m_device->download(m_hostStatus.data(), m_status.data(), statusWords * sizeof(std::uint32_t));
}

Fault TileWorker::start(const Band &band, Output output, std::uint32_t *picture, TileBuffer &buffer)
{
    const std::size_t words = output == Output::Picture ? 0 : band.tiles * tileSize * (output == Output::Rgba ? 4 : 1);
    for (const Fault &fault : {buffer.onDevice.reserve(words), buffer.onHost.reserve(words)})
        if (fault)
            return fault;
    m_frame.picture = picture;
    m_frame.tilesArgb = output == Output::Argb ? buffer.onDevice.data() : nullptr;
    m_frame.tilesRgba = output == Output::Rgba ? reinterpret_cast<float *>(buffer.onDevice.data()) : nullptr;
    const Fault fault = run(band);
    if (fault || words == 0)
        return fault;
    return m_device->download(buffer.onHost.data(), buffer.onDevice.data(), words * sizeof(std::uint32_t));
}

void TileWorker::store(const FrameHistory &history, Output output, const TileBuffer &buffer, std::span<TileTask> tasks,
                       Target &target, const std::atomic<bool> *cancel)
{
    if (output == Output::Picture)
        return;
    constexpr std::size_t together = 64;
    const std::uint32_t *argb = buffer.onHost.data();
    const auto *rgba = reinterpret_cast<const float *>(argb);
    parallelFor((tasks.size() + together - 1) / together, m_threads, [&](std::size_t group) {
        if (cancel && cancel->load(std::memory_order_relaxed))
            return;
        for (std::size_t i = group * together; i < std::min(tasks.size(), (group + 1) * together); ++i) {
            const PixelRect rect = history.region().tile(tasks[i].column, tasks[i].row);
            if (output == Output::Argb)
                target.storeArgb(rect, argb + i * tileSize, tileSide);
            else if (output == Output::Rgba)
                target.store(rect, rgba + i * 4 * tileSize, tileSide);
            tasks[i].drawn = true;
        }
    });
}

void TileWorker::keepLayers(const Band &band, std::span<TileTask> tasks)
{
    if (!(band.flags & (storeUnder | storeOver | applyOver)))
        return;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        const int flags = m_tileJobs.data()[i].flags;
        tasks[i].approximate = (flags & applyOver) != 0;
        if ((flags & (storeUnder | storeOver)) == 0)
            continue;
        TileLayer *layer = m_layers.at(tasks[i].index);
        layer->under |= (flags & storeUnder) != 0;
        layer->over |= (flags & storeOver) != 0;
    }
}

bool TileWorker::makeRoom(std::size_t triedTiles)
{
    releaseBuffers();
    if (m_layers.hasMemory()) {
        m_layers.refuse();
        return true;
    }
    if (triedTiles <= fewestBandTiles)
        return false;
    m_bandTiles = triedTiles / 2;
    return true;
}

Fault TileWorker::paint(const FrameHistory &history, bool interactive, std::span<TileTask> tasks,
                        std::uint32_t *picture, Target &target, const std::atomic<bool> *cancel,
                        std::function<void()> meanwhile)
{
    const Output output = picture ? Output::Picture : target.keepsArgb() ? Output::Argb : Output::Rgba;
    std::size_t current = 0;      // the buffer that the device writes to
    std::span<TileTask> finished; // the tasks in the other one, which are not stored yet
    const auto storeFinished = [&] {
        store(history, output, m_buffers[1 - current], std::exchange(finished, {}), target, cancel);
    };
    const std::span<TileTask> all = tasks;
    bool approximate = false;
    m_drewAll = false;
    m_deviceMs = 0;
    while (!tasks.empty() && !(cancel && cancel->load(std::memory_order_relaxed))) {
        const std::size_t most = std::min(m_bandTiles, output == Output::Rgba ? mostFloatTiles : mostBandTiles);
        const auto tried = tasks.first(std::min(tasks.size(), most));
        Band band;
        Fault fault = reserveJobs(tried.size());
        if (!fault) {
            band = plan(history, interactive, tried);
            fault = start(band, output, picture, m_buffers[current]);
        }
        storeFinished();
        if (meanwhile)
            std::exchange(meanwhile, nullptr)();
        m_scene.freeDropped(m_threads);
        // This always waits, since what was asked for reads and writes host memory.
        double milliseconds = 0;
        const Fault waited = m_device->finish(&milliseconds);
        if (!fault)
            fault = waited;
        if (fault.kind == Fault::OutOfMemory && makeRoom(tried.size()))
            continue;
        if (fault)
            return fault;
        m_deviceMs += milliseconds;
        m_apartWanted = m_hostStatus.data()[slotsTaken];
        m_apartWorthIt = m_apartWanted > band.tiles / (band.anyGeneral ? fewApartInGeneral : fewApart);
        if (const std::uint32_t longest = m_hostStatus.data()[longestList]; longest > m_listRoom) {
            m_listRoom = std::bit_ceil(longest); // Lists were cut off, so the band is run again.
            continue;
        }
        finished = tasks.first(band.tiles);
        keepLayers(band, finished);
        approximate |= (band.flags & applyOver) != 0;
        current = 1 - current;
        tasks = tasks.subspan(band.tiles);
    }
    storeFinished();
    m_drewAll = tasks.empty() && !approximate && (picture || std::ranges::all_of(all, &TileTask::drawn));
    if (picture && !m_drewAll)
        for (TileTask &task : all.first(all.size() - tasks.size()))
            task.drawn = true;
    return {};
}

} // namespace suffuse::cuda
