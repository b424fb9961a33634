#include "render/live_scene.h"

#include "render/parallel.h"

#include <algorithm>

namespace suffuse {

namespace {

/// What culling looks at says that nothing can be left out; what is evaluated stays as it is.
void reachEverywhere(SceneStroke &stroke, const View &view)
{
    stroke.bounds = {0, 0, view.width, view.height};
    const cpu::NodeBoxSink boxes = stroke.boxes.sink();
    for (std::size_t i = 0; i < stroke.nodes.size(); ++i) {
        boxes.reachX[i] = boxes.reachY[i] = boxes.weight[i] = 1e30f;
        boxes.slowest[i] = 0;
    }
}

/// Nodes are offsets from the origin: a stroke that only moved keeps them, unless they depend on what the view shows.
bool keepsNodes(const SceneStroke &known, const Stroke &now)
{
    return known.stroke.get() == &now || (!known.source->clipped && known.stroke->style == now.style &&
                                          known.stroke->segments == now.segments);
}

} // namespace

bool LiveScene::replace(const RenderRequest &request, std::vector<Stale> &stale)
{
    const Painting &painting = *request.painting;
    if (painting.strokes.size() != m_seen.size() || painting.groups != m_groups)
        return false;
    std::vector<std::size_t> differing;
    bool inPlace = true;
    painting.strokes.forEachDifference(m_seen, [&](std::size_t i) {
        const Stroke &stroke = *painting.strokes[i];
        inPlace =
            inPlace && stroke.id == std::as_const(m_seen)[i]->id && painting.isVisible(stroke) == (m_place[i] >= 0);
        differing.push_back(i);
    });
    if (!inPlace)
        return false;
    for (const std::size_t i : differing)
        if (m_place[i] >= 0) {
            const auto place = std::size_t(m_place[i]);
            m_sources[place] = painting.strokes[i];
            m_driesAt[place] = painting.strokes[i]->driesAt();
            const SceneStroke *known = m_strokes[place].get();
            stale.push_back({place, known && sameAge(place, request.time) && keepsNodes(*known, *m_sources[place])});
        }
    return true;
}

void LiveScene::align(const Painting &painting)
{
    std::vector<StrokePtr> sources;
    m_place.clear();
    for (const StrokePtr &stroke : painting.strokes) {
        const bool visible = painting.isVisible(*stroke);
        m_place.push_back(visible ? std::int64_t(sources.size()) : -1);
        if (visible)
            sources.push_back(stroke);
    }
    std::size_t same = 0; // strokes come and go at the top most of the time
    while (same < sources.size() && same < m_sources.size() && m_sources[same]->id == sources[same]->id)
        ++same;
    std::unordered_map<StrokeId, std::size_t> old;
    for (std::size_t i = same; i < m_sources.size(); ++i)
        old[m_sources[i]->id] = i;
    std::vector<SceneStrokePtr> strokes(m_strokes.begin(), m_strokes.begin() + std::ptrdiff_t(same));
    strokes.resize(sources.size());
    for (std::size_t i = same; i < sources.size(); ++i)
        if (const auto it = old.find(sources[i]->id); it != old.end())
            strokes[i] = m_strokes[it->second];
    m_sources = std::move(sources);
    m_strokes = std::move(strokes);
    m_driesAt.resize(m_sources.size());
    m_bounds.resize(m_sources.size());
    m_nodeCount = 0;
    for (std::size_t i = 0; i < m_sources.size(); ++i) {
        m_driesAt[i] = m_sources[i]->driesAt();
        m_bounds[i] = m_strokes[i] ? m_strokes[i]->bounds : PixelRect{};
        m_nodeCount += m_strokes[i] ? m_strokes[i]->source->nodes.size() : 0;
    }
    m_groups = painting.groups;
}

std::vector<LiveScene::Stale> LiveScene::staleAfterAlign(const RenderRequest &request) const
{
    const bool sameView = m_view == request.view;
    const bool sameOctave = zoomOctave(m_view.scale) == zoomOctave(request.view.scale);
    std::vector<Stale> stale;
    for (std::size_t i = 0; i < m_strokes.size(); ++i) {
        const SceneStroke *known = m_strokes[i].get();
        const bool nodesHold = known && sameAge(i, request.time) && sameOctave &&
                               (sameView || !known->source->clipped) && keepsNodes(*known, *m_sources[i]);
        if (!nodesHold || !sameView || known->stroke != m_sources[i])
            stale.push_back({i, nodesHold});
    }
    return stale;
}

void LiveScene::addWet(Microseconds time, std::vector<Stale> &stale) const
{
    if (time == m_time)
        return;
    for (std::size_t i = 0; i < m_driesAt.size(); ++i)
        if (!sameAge(i, time))
            stale.push_back({i, false});
    const auto before = [](const Stale &a, const Stale &b) { return a.index < b.index; };
    const auto same = [](const Stale &a, const Stale &b) { return a.index == b.index; };
    std::sort(stale.begin(), stale.end(), before);
    stale.erase(std::unique(stale.begin(), stale.end(), same), stale.end());
}

void LiveScene::prepare(const std::vector<Stale> &stale, const RenderRequest &request, int threads)
{
    const int octave = zoomOctave(request.view.scale);
    const Rect visible = visibleBox(request.view);
    const auto nodesOf = [this](std::size_t i) { return m_strokes[i] ? m_strokes[i]->source->nodes.size() : 0; };
    std::vector<FrozenNodes *> frozen; // null where a stroke will not be built often
    std::unordered_map<StrokeId, FrozenNodes> wet;
    for (const Stale &s : stale) {
        m_nodeCount -= nodesOf(s.index);
        const Stroke &stroke = *m_sources[s.index];
        const auto known = m_frozen.find(stroke.id);
        const bool isWet = m_driesAt[s.index] > request.time && stroke.segments.size() > mergeBlock;
        const bool keeps = !s.nodesHold && (isWet || known != m_frozen.end());
        frozen.push_back(keeps ? &wet[stroke.id] : nullptr);
        if (keeps && known != m_frozen.end())
            *frozen.back() = std::move(known->second);
    }
    threads = threads > 0 ? threads : hardwareThreads();
    const int threadsEach = std::max(1, threads / std::max(1, int(stale.size())));
    parallelFor(stale.size(), threads, [&](std::size_t k) {
        const std::size_t i = stale[k].index;
        auto nodes = stale[k].nodesHold ? m_strokes[i]->source
                     : frozen[k] ? buildNodes(m_sources[i], request.time, octave, visible, *frozen[k], threadsEach)
                                 : buildNodes(*m_sources[i], request.time, octave, visible, threadsEach);
        auto stroke = std::make_shared<SceneStroke>(
            makeSceneStroke(m_sources[i], std::move(nodes), request.view, threadsEach, frozen[k] != nullptr));
        if (!m_cull)
            reachEverywhere(*stroke, request.view);
        m_bounds[i] = stroke->bounds;
        m_strokes[i] = std::move(stroke);
    });
    for (const Stale &s : stale)
        m_nodeCount += nodesOf(s.index);
    m_frozen = std::move(wet);
}

SceneChange LiveScene::update(const RenderRequest &request, int threads)
{
    SceneChange change;
    std::vector<Stale> stale;
    const Painting &painting = *request.painting;
    const bool sameView = m_view == request.view;
    if (sameView && replace(request, stale)) {
        addWet(request.time, stale);
        for (const Stale &s : stale)
            change.replaced.push_back({s.index, m_strokes[s.index]});
    } else {
        change.reordered = true;
        if (sameView)
            change.before = m_strokes;
        align(painting);
        stale = staleAfterAlign(request);
    }
    prepare(stale, request, threads);
    m_seen = painting.strokes;
    m_view = request.view;
    m_time = request.time;
    return change;
}

} // namespace suffuse
