#include "render/scene/live_scene.h"

#include "render/nodes/blocks.h"

#include <algorithm>
#include <numeric>

namespace suffuse {

namespace {

/// Changes what culling looks at so that nothing is left out. What is evaluated stays as it is.
void reachEverywhere(SceneStroke &stroke, const PixelRect &window)
{
    stroke.bounds = window;
    const NodeBoxSink boxes = stroke.boxes.sink();
    for (std::size_t i = 0; i < stroke.nodes.size(); ++i) {
        boxes.reachX[i] = boxes.reachY[i] = boxes.weight[i] = 1e30f;
        boxes.slowest[i] = 0;
    }
}

/// Whether a stroke can keep its nodes. They are offsets from the origin, so a stroke that only moved keeps them,
/// unless they depend on what the view shows.
bool keepsNodes(const SceneStroke &known, const Stroke &now)
{
    return !known.outside &&
           (known.stroke.get() == &now ||
            (!known.source->clipped && known.stroke->style == now.style && known.stroke->segments == now.segments));
}

/// A stroke that is not seen.
SceneStroke outsideStroke(StrokePtr stroke, const PictureGrid &grid)
{
    static const auto none = std::make_shared<const StrokeNodes>();
    SceneStroke out = makeSceneStroke(std::move(stroke), none, grid);
    out.outside = true;
    return out;
}

} // namespace

bool LiveScene::replace(const Painting &painting, Microseconds time, std::vector<Stale> &stale)
{
    if (painting.strokes.size() != m_seen.size() || painting.groups != m_groups)
        return false;
    std::vector<std::size_t> differing;
    bool inPlace = true;
    const Visibility isVisible(painting.groups);
    painting.strokes.forEachDifference(m_seen, [&](std::size_t i) {
        const Stroke &stroke = *painting.strokes[i];
        const Stroke &seen = *std::as_const(m_seen)[i];
        inPlace =
            inPlace && stroke.id == seen.id && stroke.group == seen.group && isVisible(stroke) == (m_place[i] >= 0);
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
            stale.push_back({place, known && sameAge(place, time) && keepsNodes(*known, *m_sources[place])});
        }
    return true;
}

bool LiveScene::isPutAnew(const Painting &painting) const
{
    if (painting.groups == m_groups || painting.strokes.size() != m_seen.size() || !m_composition.bases.empty() ||
        !differInPuts(m_groups, painting.groups))
        return false;
    bool isSame = true;
    painting.strokes.forEachDifference(m_seen, [&](std::size_t) { isSame = false; });
    return isSame;
}

/// Where strokes stand now. Most stand in the same order, so the next place is looked at first.
std::vector<std::size_t> LiveScene::placesOf(const std::vector<StrokePtr> &strokes) const
{
    constexpr std::size_t near = 8; // how many places ahead are looked at
    std::vector<std::size_t> places(strokes.size(), SceneChange::nowhere);
    std::unordered_map<StrokeId, std::size_t> all; // needed where that is not enough
    StrokeId greatest = 0;
    for (const StrokePtr &stroke : m_sources)
        greatest = std::max(greatest, stroke->id);
    std::size_t next = 0;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const StrokeId id = strokes[i]->id;
        if (id > greatest)
            continue; // The stroke is new.
        const auto from = m_sources.begin() + std::ptrdiff_t(next);
        const auto to = from + std::ptrdiff_t(std::min(near, m_sources.size() - next));
        if (const auto it = std::find_if(from, to, [id](const StrokePtr &s) { return s->id == id; }); it != to) {
            places[i] = std::size_t(it - m_sources.begin());
        } else {
            for (std::size_t k = 0; all.empty() && k < m_sources.size(); ++k)
                all.emplace(m_sources[k]->id, k);
            if (const auto known = all.find(id); known != all.end())
                places[i] = known->second;
        }
        if (places[i] != SceneChange::nowhere)
            next = places[i] + 1;
    }
    return places;
}

std::vector<std::size_t> LiveScene::align(const Painting &painting)
{
    std::vector<StrokePtr> sources;
    m_place.clear();
    const Visibility isVisible(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        const bool visible = isVisible(*stroke);
        m_place.push_back(visible ? std::int64_t(sources.size()) : -1);
        if (visible)
            sources.push_back(stroke);
    }
    std::vector<std::size_t> places = placesOf(sources);
    std::vector<SceneStrokePtr> strokes(sources.size());
    std::vector<Microseconds> driesAt(sources.size());
    std::vector<PixelRect> bounds(sources.size());
    m_nodeCount = 0;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const std::size_t place = places[i];
        const bool known = place != SceneChange::nowhere;
        driesAt[i] = known && m_sources[place] == sources[i] ? m_driesAt[place] : sources[i]->driesAt();
        if (!known || !m_strokes[place])
            continue;
        strokes[i] = m_strokes[place];
        bounds[i] = m_bounds[place];
        m_nodeCount += strokes[i]->source->nodes.size();
    }
    m_sources = std::move(sources);
    m_strokes = std::move(strokes);
    m_driesAt = std::move(driesAt);
    m_bounds = std::move(bounds);
    m_groups = painting.groups;
    return places;
}

std::vector<LiveScene::Stale> LiveScene::staleAfterAlign(Microseconds time, const PictureGrid &grid) const
{
    const bool samePlace = m_grid.samePlace(grid);
    const bool sameOctave = zoomOctave(m_grid.view.scale) == zoomOctave(grid.view.scale);
    std::vector<Stale> stale;
    for (std::size_t i = 0; i < m_strokes.size(); ++i) {
        const SceneStroke *known = m_strokes[i].get();
        const bool hasAge = known && sameAge(i, time);
        if (hasAge && samePlace && known->stroke == m_sources[i])
            continue;
        const bool nodesHold =
            hasAge && sameOctave && (samePlace || !known->source->clipped) && keepsNodes(*known, *m_sources[i]);
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

SceneStrokePtr LiveScene::dryOf(std::size_t i, const PictureGrid &grid) const
{
    const SceneStrokePtr &known = m_strokes[i];
    if (!known || known->stroke != m_sources[i] || !m_grid.samePlace(grid))
        return nullptr;
    return m_driesAt[i] <= m_time ? known : known->dry;
}

std::vector<std::shared_ptr<const StrokeNodes>> LiveScene::buildBulk(const std::vector<Stale> &stale,
                                                                     const std::vector<FrozenNodes *> &frozen,
                                                                     const std::vector<char> &outside,
                                                                     Microseconds time, const PictureGrid &grid,
                                                                     Threads threads) const
{
    std::vector<std::shared_ptr<const StrokeNodes>> nodes(stale.size());
    if (!m_bulk)
        return nodes;
    std::vector<StrokePtr> strokes;
    std::vector<std::size_t> places; // where they are among the stale ones
    std::size_t segments = 0;
    for (std::size_t k = 0; k < stale.size(); ++k) {
        const std::size_t i = stale[k].index;
        if (stale[k].nodesHold || frozen[k] || outside[k] || (m_driesAt[i] <= time && dryOf(i, grid)))
            continue;
        strokes.push_back(m_sources[i]);
        places.push_back(k);
        segments += m_sources[i]->segments.size();
    }
    if (segments / std::size_t(threads.count()) < m_bulk->worthwhile())
        return nodes;
    auto built = m_bulk->build(strokes, time, zoomOctave(grid.view.scale), visibleBox(grid), threads);
    for (std::size_t k = 0; k < places.size(); ++k)
        nodes[places[k]] = std::move(built[k]);
    return nodes;
}

bool LiveScene::prepare(const std::vector<Stale> &stale, Microseconds time, const PictureGrid &grid, Threads threads,
                        const std::atomic<bool> *stop)
{
    const int octave = zoomOctave(grid.view.scale);
    const Rect visible = visibleBox(grid), near = visible.grown(2 * grid.view.px());
    const auto nodesOf = [this](std::size_t i) { return m_strokes[i] ? m_strokes[i]->source->nodes.size() : 0; };
    std::vector<FrozenNodes *> frozen; // null for a stroke that will not be built often
    std::unordered_map<StrokeId, FrozenNodes> wet;
    for (const Stale &s : stale) {
        m_nodeCount -= nodesOf(s.index);
        const Stroke &stroke = *m_sources[s.index];
        const auto known = m_frozen.find(stroke.id);
        const bool isWet = m_driesAt[s.index] > time && stroke.segments.size() > 2 * blockReach;
        const bool keeps = !s.nodesHold && (isWet || known != m_frozen.end());
        frozen.push_back(keeps ? &wet[stroke.id] : nullptr);
        if (keeps && known != m_frozen.end())
            *frozen.back() = std::move(known->second);
    }
    std::vector<char> outside(stale.size(), 0);
    parallelFor(stale.size(), threads, [&](std::size_t k) {
        outside[k] = m_cull && !greatestReach(*m_sources[stale[k].index], time).intersects(near);
    });
    const auto bulk = buildBulk(stale, frozen, outside, time, grid, threads);
    const Threads threadsEach = threads.within(stale.size());
    std::atomic<bool> isWhole = true;
    parallelFor(stale.size(), threads, [&](std::size_t k) {
        const std::size_t i = stale[k].index;
        const bool dries = m_driesAt[i] <= time;
        SceneStrokePtr dry = dryOf(i, grid);
        if (dry && dries && !frozen[k]) {
            m_bounds[i] = dry->bounds;
            m_strokes[i] = std::move(dry);
            return;
        }
        if (outside[k]) {
            auto stroke = std::make_shared<SceneStroke>(outsideStroke(m_sources[i], grid));
            if (!dries)
                stroke->dry = std::move(dry);
            m_bounds[i] = stroke->bounds;
            m_strokes[i] = std::move(stroke);
            return;
        }
        auto nodes = stale[k].nodesHold ? m_strokes[i]->source
                     : bulk[k]          ? bulk[k]
                     : frozen[k]        ? buildNodes(m_sources[i], time, octave, visible, *frozen[k], threadsEach)
                                        : buildNodes(*m_sources[i], time, octave, visible, threadsEach);
        const SceneStroke *before = m_strokes[i].get();
        auto fill = makeSceneFill(*m_sources[i], time, grid, before ? before->stroke.get() : nullptr,
                                  before ? before->fill.get() : nullptr, stop);
        if (!fill && m_sources[i]->fill && stop && stop->load(std::memory_order_relaxed)) {
            // It is another stroke than that of the painting, so the next update finds a difference.
            m_sources[i] = std::make_shared<const Stroke>(*m_sources[i]);
            m_strokes[i] = std::make_shared<const SceneStroke>(outsideStroke(m_sources[i], grid));
            m_bounds[i] = m_strokes[i]->bounds;
            isWhole = false;
            return;
        }
        auto stroke = std::make_shared<SceneStroke>(
            makeSceneStroke(m_sources[i], std::move(nodes), grid, threadsEach, frozen[k] != nullptr, std::move(fill)));
        if (!m_cull)
            reachEverywhere(*stroke, grid.window);
        if (!dries)
            stroke->dry = std::move(dry);
        m_bounds[i] = stroke->bounds;
        m_strokes[i] = std::move(stroke);
    });
    for (const Stale &s : stale)
        m_nodeCount += nodesOf(s.index);
    m_frozen = std::move(wet);
    return isWhole;
}

SceneChange LiveScene::update(const RenderRequest &request, const PictureGrid &grid, Threads threads,
                              const std::atomic<bool> *stop)
{
    SceneChange change;
    std::vector<Stale> stale;
    const PaintingPtr drawn = m_washes.drawn(request.painting);
    const Painting &painting = *drawn;
    const bool samePlace = m_grid.samePlace(grid);
    if (samePlace && isPutAnew(painting)) {
        change.reordered = true;
        change.before = m_strokes;
        change.places.resize(m_strokes.size());
        std::iota(change.places.begin(), change.places.end(), std::size_t(0));
        change.composed = m_composition;
        putAnew(m_composition, painting.groups);
        m_groups = painting.groups;
        addWet(request.time, stale);
    } else if (samePlace && replace(painting, request.time, stale)) {
        addWet(request.time, stale);
        for (const Stale &s : stale)
            change.replaced.push_back({s.index, m_strokes[s.index]});
    } else {
        change.reordered = true;
        if (samePlace)
            change.before = m_strokes;
        change.composed = std::move(m_composition);
        m_composition = compositionOf(painting);
        change.places = align(painting);
        stale = staleAfterAlign(request.time, grid);
    }
    const bool isWhole = prepare(stale, request.time, grid, threads, stop);
    m_seen = painting.strokes;
    for (std::size_t i = 0; !isWhole && i < m_place.size(); ++i)
        if (m_place[i] >= 0 && std::as_const(m_seen)[i] != m_sources[std::size_t(m_place[i])])
            m_seen[i] = m_sources[std::size_t(m_place[i])];
    m_grid = grid;
    m_time = request.time;
    return change;
}

} // namespace suffuse
