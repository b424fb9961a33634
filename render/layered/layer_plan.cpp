#include "render/layered/layer_plan.h"

#include "model/painting/text_title.h"

#include <QCoreApplication>

#include <algorithm>
#include <unordered_map>

namespace suffuse {

namespace {

class Planner {
public:
    explicit Planner(const Painting &painting) : m_painting(painting), m_isVisible(painting.groups)
    {
        for (const Group &group : painting.groups)
            m_groups.emplace(group.id, &group);
        m_upTo.canvas = painting.canvas;
        m_upTo.groups = painting.groups;
        add({PlannedLayer::Kind::Paint, QCoreApplication::translate("LayeredFile", "Background")});
        const std::size_t count = painting.strokes.size();
        // What masks all would be missing below it.
        bool isClipped = false;
        forEachRun(0, count, 0, [&](GroupId group, std::size_t from, std::size_t to) {
            if (group == 0 || !m_groups.at(group)->mask)
                return;
            addStrokes(from, to), m_isMasked = true;
            isClipped = isClipped || m_groups.at(group)->clips;
        });
        if (isClipped) { // It masks by what lies just below it, which only the whole painting has in place.
            m_upTo.strokes.clear();
            addPaint(QCoreApplication::translate("LayeredFile", "Strokes"), false, 0, count);
            return;
        }
        m_masking = m_upTo.strokes;
        m_upTo.strokes.clear();
        walk(0, count, 0);
    }
    std::vector<PlannedLayer> take() { return std::move(m_layers); }

private:
    /// The group directly within `around` (0: the painting itself) that holds a stroke; 0: it is in none.
    GroupId childOf(const Stroke &stroke, GroupId around) const
    {
        GroupId child = 0;
        for (GroupId group = stroke.group; group != around && group != 0; group = m_groups.at(group)->parent)
            child = group;
        return child;
    }

    /// Calls visit(group, from, to) for each run of strokes [from, to) that one group holds, or none (0).
    template <class Visit>
    void forEachRun(std::size_t from, std::size_t to, GroupId around, Visit visit) const
    {
        for (std::size_t i = from; i < to;) {
            const GroupId group = childOf(*m_painting.strokes[i], around);
            std::size_t end = i + 1;
            while (end < to && childOf(*m_painting.strokes[end], around) == group)
                ++end;
            visit(group, i, end);
            i = end;
        }
    }

    void walk(std::size_t from, std::size_t to, GroupId around)
    {
        forEachRun(from, to, around, [&](GroupId group, std::size_t first, std::size_t last) {
            if (group == 0)
                return addRun(first, last);
            addGroup(*m_groups.at(group), first, last);
        });
    }

    void addRun(std::size_t from, std::size_t to)
    {
        const bool single = to == from + 1 && !m_painting.strokes[from]->name.isEmpty();
        if (!isSeen(from, to))
            addStrokes(from, to); // What follows may be clipped to them.
        else
            addPaint(single ? m_painting.strokes[from]->name : QCoreApplication::translate("LayeredFile", "Strokes"),
                     areLocked(from, to), from, to);
    }

    void addGroup(const Group &group, std::size_t from, std::size_t to)
    {
        if (group.mask && group.parent == 0)
            return; // It is in all of them.
        if (!isSeen(from, to)) {
            addStrokes(from, to); // They show nothing, but what follows may be clipped to them.
            PlannedLayer layer = put(group);
            layer.visible = false;
            layer.alone = alone(group, from, to);
            return add(std::move(layer));
        }
        if (group.isIsolated() && !group.clips && !group.mask && !m_isMasked && isPutAlike(group.blend)) {
            addStrokes(from, to);
            PlannedLayer layer = put(group);
            layer.alone = alone(group, from, to);
            return add(std::move(layer));
        }
        if (group.isIsolated() || group.wash || group.text || !isFolder(group, from, to))
            return addPaint(nameOf(group), group.locked, from, to);
        m_layers.push_back({.kind = PlannedLayer::Kind::BeginFolder, .name = nameOf(group), .locked = group.locked});
        walk(from, to, group.id);
        m_layers.push_back({PlannedLayer::Kind::EndFolder});
    }

    static QString nameOf(const Group &group)
    {
        const QString name = group.name.isEmpty() && group.text ? titleOf(*group.text) : group.name;
        return name.isEmpty() ? QCoreApplication::translate("LayeredFile", "Group %1").arg(group.id) : name;
    }
    /// A group that is put as a whole.
    static PlannedLayer put(const Group &group)
    {
        return {.kind = PlannedLayer::Kind::Group,
                .name = nameOf(group),
                .locked = group.locked,
                .opacity = group.opacity,
                .blend = group.blend};
    }
    bool areLocked(std::size_t from, std::size_t to) const
    {
        return std::all_of(m_painting.strokes.begin() + std::ptrdiff_t(from),
                           m_painting.strokes.begin() + std::ptrdiff_t(to),
                           [](const StrokePtr &stroke) { return stroke->locked; });
    }

    /// Whether a group has others within it, of which none masks it.
    bool isFolder(const Group &group, std::size_t from, std::size_t to) const
    {
        bool holdsGroups = false, hasMask = false;
        forEachRun(from, to, group.id, [&](GroupId child, std::size_t, std::size_t) {
            holdsGroups = holdsGroups || child != 0;
            hasMask = hasMask || (child != 0 && m_groups.at(child)->mask);
        });
        return holdsGroups && !hasMask;
    }

    bool isSeen(std::size_t from, std::size_t to) const
    {
        for (std::size_t i = from; i < to; ++i)
            if (m_isVisible(*m_painting.strokes[i]))
                return true;
        return false;
    }

    /// The group and nothing else, put as it is and shown.
    PaintingPtr alone(const Group &group, std::size_t from, std::size_t to) const
    {
        auto out = std::make_shared<Painting>();
        out->canvas = m_painting.canvas;
        out->groups = m_painting.groups;
        for (Group &g : out->groups) {
            g.solo = false;
            if (g.id == group.id)
                g.opacity = 1, g.blend = BlendMode::Normal, g.isolated = true, g.clips = g.mask = false;
        }
        for (GroupId around = group.id; around != 0; around = m_groups.at(around)->parent)
            for (Group &g : out->groups)
                if (g.id == around)
                    g.visible = true;
        for (std::size_t i = from; i < to; ++i)
            out->strokes.push_back(m_painting.strokes[i]);
        return out;
    }

    void addPaint(const QString &name, bool locked, std::size_t from, std::size_t to)
    {
        addStrokes(from, to);
        add({.kind = PlannedLayer::Kind::Paint, .name = name, .locked = locked});
    }
    void addStrokes(std::size_t from, std::size_t to)
    {
        for (std::size_t i = from; i < to; ++i)
            m_upTo.strokes.push_back(m_painting.strokes[i]);
    }

    void add(PlannedLayer layer)
    {
        if (layer.visible) {
            auto upTo = std::make_shared<Painting>(m_upTo);
            for (const StrokePtr &stroke : m_masking)
                upTo->strokes.push_back(stroke);
            layer.upTo = std::move(upTo);
        }
        m_layers.push_back(std::move(layer));
    }

    const Painting &m_painting;
    const Visibility m_isVisible;
    std::unordered_map<GroupId, const Group *> m_groups;
    Painting m_upTo;      ///< the painting up to the layer in hand, without what masks all
    StrokeList m_masking; ///< what does
    bool m_isMasked = false;
    std::vector<PlannedLayer> m_layers;
};

} // namespace

bool isPutAlike(BlendMode mode)
{
    switch (mode) {
    case BlendMode::Normal:
    case BlendMode::Multiply:
    case BlendMode::Screen:
    case BlendMode::Overlay:
    case BlendMode::Darken:
    case BlendMode::Lighten:
    case BlendMode::HardLight:
    case BlendMode::Difference:
        return true;
    default:
        return false;
    }
}

std::vector<PlannedLayer> planLayers(const Painting &painting)
{
    return Planner(painting).take();
}

} // namespace suffuse
