#include "render/composition/composition.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace suffuse {

namespace {

/// The isolated groups around each group, and itself if it is one, the outermost first.
class Isolated {
public:
    explicit Isolated(const std::vector<Group> &groups)
    {
        for (const Group &group : groups)
            m_groups.emplace(group.id, &group);
    }

    const std::vector<const Group *> &around(GroupId id)
    {
        const auto known = m_around.find(id);
        if (known != m_around.end())
            return known->second;
        std::vector<const Group *> all;
        for (auto it = m_groups.find(id); it != m_groups.end(); it = m_groups.find(it->second->parent))
            if (it->second->isIsolated())
                all.push_back(it->second);
        std::ranges::reverse(all);
        return m_around.emplace(id, std::move(all)).first->second;
    }

private:
    std::unordered_map<GroupId, const Group *> m_groups;
    std::unordered_map<GroupId, std::vector<const Group *>> m_around;
};

} // namespace

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
    Composition out;
    if (std::ranges::none_of(painting.groups, &Group::isIsolated))
        return out;
    Isolated isolated(painting.groups);
    std::unordered_map<GroupId, int> runs;
    std::vector<int> open; // the layers that the last stroke is in, the outermost first
    for (const StrokePtr &stroke : painting.strokes) {
        if (!painting.isVisible(*stroke))
            continue;
        const std::vector<const Group *> &around = isolated.around(stroke->group);
        std::size_t same = 0;
        while (same < open.size() && same < around.size() &&
               out.layers[std::size_t(open[same])].group == around[same]->id)
            ++same;
        open.resize(same);
        for (std::size_t i = same; i < around.size(); ++i) {
            const Group &group = *around[i];
            Layer layer;
            layer.group = group.id;
            layer.run = runs[group.id]++;
            layer.opacity = group.opacity, layer.blend = group.blend;
            layer.parent = open.empty() ? Layer::none : open.back();
            layer.depth = int(i) + 1;
            layer.first = out.of.size();
            open.push_back(int(out.layers.size()));
            if (layer.actsEverywhere())
                out.everywhere.push_back(open.back());
            out.layers.push_back(layer);
        }
        out.of.push_back(open.empty() ? Layer::none : open.back());
        for (const int layer : open)
            out.layers[std::size_t(layer)].last = out.of.size();
    }
    if (out.layers.empty()) // All that is isolated is hidden.
        out.of.clear();
    return out;
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
        if (isAround && layer.isPutAs(was))
            m_same[i] = it->second;
    }
}

bool LayerChanges::concerns(std::size_t before, std::size_t now) const
{
    const int was = m_before.layerOf(before), is = m_now.layerOf(now);
    return is == Layer::none ? was != Layer::none
                             : m_same[std::size_t(is)] == Layer::none || m_same[std::size_t(is)] != was;
}

} // namespace suffuse
