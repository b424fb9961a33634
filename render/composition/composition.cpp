#include "render/composition/composition.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace suffuse {

namespace {

/// A group, and which one of its runs.
struct GroupRun {
    const Group *group = nullptr; ///< null: the painting itself
    int run = 0;

    GroupId id() const { return group ? group->id : 0; }
};

/// The groups around each group of a painting.
class GroupTree {
public:
    explicit GroupTree(const std::vector<Group> &groups)
    {
        for (const Group &group : groups)
            m_groups.emplace(group.id, &group);
    }

    /// The groups around one, and itself, the outermost first.
    const std::vector<const Group *> &path(GroupId id)
    {
        const auto known = m_paths.find(id);
        if (known != m_paths.end())
            return known->second;
        std::vector<const Group *> all;
        for (auto it = m_groups.find(id); it != m_groups.end() && all.size() <= m_groups.size();
             it = m_groups.find(it->second->parent))
            all.push_back(it->second);
        std::ranges::reverse(all);
        return m_paths.emplace(id, std::move(all)).first->second;
    }

private:
    std::unordered_map<GroupId, const Group *> m_groups;
    std::unordered_map<GroupId, std::vector<const Group *>> m_paths;
};

/// Goes from stroke to stroke through the runs of groups. `Level` is what is known of a run, and of the painting
/// itself, which is the first level.
template <class Level>
class RunWalk {
public:
    RunWalk(GroupTree &tree, Level painting) : m_tree(tree) { m_levels.push_back(std::move(painting)); }

    /// The levels around a stroke. enter(run, levels) makes the level of a run that begins, within those that it lies
    /// in.
    template <class Enter>
    std::vector<Level> &to(const Stroke &stroke, Enter enter)
    {
        const std::vector<const Group *> &path = m_tree.path(stroke.group);
        std::size_t same = 0;
        while (same < m_open.size() && same < path.size() && m_open[same] == path[same])
            ++same;
        m_open.resize(same);
        m_levels.erase(m_levels.begin() + std::ptrdiff_t(same) + 1, m_levels.end());
        for (std::size_t i = same; i < path.size(); ++i) {
            m_open.push_back(path[i]);
            Level level = enter(GroupRun{path[i], m_runs[path[i]->id]++}, m_levels);
            m_levels.push_back(std::move(level));
        }
        return m_levels;
    }

private:
    GroupTree &m_tree;
    std::vector<const Group *> m_open; ///< the groups of all levels but the first
    std::vector<Level> m_levels;
    std::unordered_map<GroupId, int> m_runs;
};

/// What groups are clipped to, and which groups are isolated because of others.
struct Bounds {
    std::map<std::pair<GroupId, int>, ClipBase> clips; ///< the bases of runs
    std::set<ClipBase> bases;
    std::unordered_set<GroupId> isolated; ///< 0: the painting itself
};

/// A clipped group is clipped to the next thing below it in the same group that is neither clipped nor a mask, be it
/// visible or not.
void findClips(const Painting &painting, GroupTree &tree, Bounds &bounds)
{
    struct Level {
        std::optional<ClipBase> base; ///< the last thing in it that something can be clipped to
    };
    RunWalk<Level> walk(tree, {});
    for (const StrokePtr &stroke : painting.strokes) {
        std::vector<Level> &levels = walk.to(*stroke, [&](const GroupRun &run, std::vector<Level> &around) {
            Level &in = around.back();
            if (run.group->clips) {
                if (in.base) {
                    bounds.clips.emplace(std::pair(run.id(), run.run), *in.base);
                    bounds.bases.insert(*in.base);
                }
            } else if (!run.group->mask) {
                in.base = ClipBase{run.id(), run.run, 0};
            }
            return Level();
        });
        levels.back().base = ClipBase{0, 0, stroke->id};
    }
    // Coverage is followed for one base at a time. A base in which something is clipped has its own picture.
    for (const auto &[clipped, base] : bounds.clips) {
        const std::vector<const Group *> &path = tree.path(clipped.first);
        for (auto around = path.begin(); around + 1 < path.end(); ++around)
            if (std::ranges::any_of(bounds.bases, [&](const ClipBase &b) { return b.group == (*around)->id; }))
                bounds.isolated.insert((*around)->id);
    }
}

Bounds boundsOf(const Painting &painting, GroupTree &tree, const Visibility &isVisible)
{
    Bounds bounds;
    for (const Group &group : painting.groups)
        if (group.isIsolated())
            bounds.isolated.insert(group.id);
    if (std::ranges::any_of(painting.groups, &Group::mask))
        for (const StrokePtr &stroke : painting.strokes)
            if (isVisible(*stroke))
                for (const Group *group : tree.path(stroke->group))
                    if (group->mask)
                        bounds.isolated.insert(group->parent);
    if (std::ranges::any_of(painting.groups, &Group::clips))
        findClips(painting, tree, bounds);
    return bounds;
}

/// Makes the composition of a painting in which something is isolated.
class Composer {
public:
    Composer(GroupTree &tree, const Bounds &bounds) : m_bounds(bounds), m_walk(tree, Level{bounds.isolated.contains(0)})
    {}

    void add(const Stroke &stroke, bool isVisible)
    {
        std::vector<Level> &levels = m_walk.to(stroke, [this](const GroupRun &run, const std::vector<Level> &around) {
            Level level{m_bounds.isolated.contains(run.id()), run};
            const std::optional<int> own = numberOf({run.id(), run.run, 0});
            level.isBase = own.has_value();
            level.shape = own.value_or(around.back().inner());
            return level;
        });
        if (!isVisible)
            return;
        int layer = Layer::none;
        for (Level &level : levels)
            if (level.isIsolated) {
                if (level.layer == Layer::none)
                    level.layer = begin(level, layer);
                layer = level.layer;
            }
        m_out.of.push_back(layer);
        if (!m_bounds.bases.empty())
            m_out.shapes.push_back(numberOf({0, 0, stroke.id}).value_or(levels.back().inner()));
        for (; layer != Layer::none; layer = m_out.layers[std::size_t(layer)].parent)
            m_out.layers[std::size_t(layer)].last = m_out.of.size();
    }

    Composition composition() &&
    {
        if (m_out.layers.empty()) // All that is isolated is hidden.
            return {};
        return std::move(m_out);
    }

private:
    struct Level {
        bool isIsolated = false;
        GroupRun run{};
        int layer = Layer::none; ///< once it has begun
        int shape = Layer::none; ///< the base of which it is a part
        bool isBase = false;     ///< whether it is that base
        /// The base of which that is a part which lies in it.
        int inner() const { return isIsolated ? Layer::none : shape; }
    };

    int begin(const Level &level, int parent)
    {
        const int index = int(m_out.layers.size());
        Layer layer;
        layer.group = level.run.id(), layer.run = level.run.run;
        layer.parent = parent;
        layer.first = m_out.of.size();
        layer.shape = level.shape;
        if (parent != Layer::none)
            layer.depth = m_out.layers[std::size_t(parent)].depth + 1;
        if (const Group *group = level.run.group) {
            layer.opacity = group->opacity, layer.blend = group->blend, layer.isMask = group->mask;
            layer.shapeMode = level.isBase ? BlendMode::Normal : group->blend;
            if (const auto clip = m_bounds.clips.find({layer.group, layer.run}); clip != m_bounds.clips.end())
                layer.clippedTo = numberOf(clip->second).value();
        }
        if (layer.isMask)
            ++m_out.layers[std::size_t(parent)].masks;
        m_out.isBounded = m_out.isBounded || layer.isMask || layer.clippedTo != Layer::none;
        if (layer.actsEverywhere())
            m_out.everywhere.push_back(index);
        m_out.layers.push_back(layer);
        return index;
    }

    /// The place of a base among the composition's, if anything is clipped to it.
    std::optional<int> numberOf(const ClipBase &base)
    {
        if (!m_bounds.bases.contains(base))
            return {};
        const auto [known, isNew] = m_numbers.emplace(base, int(m_out.bases.size()));
        if (isNew)
            m_out.bases.push_back(base);
        return known->second;
    }

    const Bounds &m_bounds;
    RunWalk<Level> m_walk;
    std::map<ClipBase, int> m_numbers;
    Composition m_out;
};

bool areSame(const ClipBase *a, const ClipBase *b)
{
    return a && b ? *a == *b : a == b;
}

} // namespace

bool Composition::boundsOthers(int layer) const
{
    for (; layer != Layer::none; layer = layers[std::size_t(layer)].parent)
        if (const Layer &l = layers[std::size_t(layer)]; l.isMask || l.shape != Layer::none)
            return true;
    return false;
}

bool Composition::isWithin(int layer, int around) const
{
    if (around == Layer::none)
        return true;
    const int depth = layers[std::size_t(around)].depth;
    while (layer != Layer::none && layers[std::size_t(layer)].depth > depth)
        layer = layers[std::size_t(layer)].parent;
    return layer == around;
}

Composition compositionOf(const Painting &painting)
{
    if (std::ranges::none_of(painting.groups, &Group::isIsolated))
        return {};
    GroupTree tree(painting.groups);
    const Visibility isVisible(painting.groups);
    const Bounds bounds = boundsOf(painting, tree, isVisible);
    Composer composer(tree, bounds);
    for (const StrokePtr &stroke : painting.strokes)
        composer.add(*stroke, isVisible(*stroke));
    return std::move(composer).composition();
}

bool differInPuts(const std::vector<Group> &before, const std::vector<Group> &now)
{
    const auto alike = [](const Group &a, const Group &b) {
        constexpr BlendMode everywhere = BlendMode::DestinationIn;
        Group like = a;
        like.opacity = b.opacity, like.blend = b.blend;
        return like == b && a.isIsolated() == b.isIsolated() && (a.blend == everywhere) == (b.blend == everywhere);
    };
    return std::ranges::equal(before, now, alike);
}

void putAnew(Composition &composition, const std::vector<Group> &groups)
{
    std::unordered_map<GroupId, const Group *> known;
    for (const Group &group : groups)
        known.emplace(group.id, &group);
    for (Layer &layer : composition.layers)
        if (const auto it = known.find(layer.group); it != known.end())
            layer.opacity = it->second->opacity, layer.blend = layer.shapeMode = it->second->blend;
}

int layerPutAnew(const Composition &before, const Composition &now)
{
    if (before.layers.size() != now.layers.size())
        return Layer::none;
    const auto [was, is] = std::ranges::mismatch(before.layers, now.layers);
    if (is == now.layers.end())
        return Layer::none;
    Composition like = before;
    Layer &layer = like.layers[std::size_t(is - now.layers.begin())];
    layer.opacity = is->opacity, layer.blend = is->blend, layer.shapeMode = is->shapeMode;
    return like == now ? int(is - now.layers.begin()) : Layer::none;
}

bool mixesInOrder(const Painting &painting)
{
    return compositionOf(painting).isFlat() &&
           std::ranges::none_of(painting.groups, [](const Group &group) { return group.wash.has_value(); });
}

LayerChanges::LayerChanges(const Composition &before, const Composition &now)
    : m_before(before), m_now(now), m_same(now.layers.size(), Layer::none)
{
    m_everywhere = !(before.everywhere.empty() && now.everywhere.empty()) && before != now;
    std::map<std::pair<GroupId, int>, int> known;
    for (std::size_t i = 0; i < before.layers.size(); ++i)
        known.emplace(std::pair(before.layers[i].group, before.layers[i].run), int(i));
    for (std::size_t i = 0; i < now.layers.size(); ++i) {
        const Layer &layer = now.layers[i];
        const auto it = known.find({layer.group, layer.run});
        if (it == known.end())
            continue;
        const Layer &was = before.layers[std::size_t(it->second)];
        const int around = layer.parent == Layer::none ? Layer::none : m_same[std::size_t(layer.parent)];
        const bool isAround = was.parent == around && (around == Layer::none) == (layer.parent == Layer::none);
        if (isAround && layer.isPutAs(was) && areSame(before.baseAt(was.clippedTo), now.baseAt(layer.clippedTo)))
            m_same[i] = it->second;
    }
}

bool LayerChanges::concerns(std::size_t before, std::size_t now) const
{
    if (!areSame(m_before.baseAt(m_before.shapeOf(before)), m_now.baseAt(m_now.shapeOf(now))))
        return true;
    const int was = m_before.layerOf(before), is = m_now.layerOf(now);
    return is == Layer::none ? was != Layer::none
                             : m_same[std::size_t(is)] == Layer::none || m_same[std::size_t(is)] != was;
}

} // namespace suffuse
