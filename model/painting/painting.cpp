#include "model/painting/painting.h"

#include <algorithm>
#include <unordered_map>

namespace suffuse {

namespace {

const Group *findIn(const std::vector<Group> &groups, GroupId id)
{
    const auto it = std::ranges::find(groups, id, &Group::id);
    return it == groups.end() ? nullptr : &*it;
}

/// Whether a predicate is true of a group on the way from `id` to the root. The search ends on damaged chains, too.
template <typename Predicate>
bool anyGroup(const std::vector<Group> &groups, GroupId id, Predicate predicate)
{
    for (std::size_t steps = 0; id != 0 && steps <= groups.size(); ++steps) {
        const Group *group = findIn(groups, id);
        if (!group)
            return false;
        if (predicate(*group))
            return true;
        id = group->parent;
    }
    return false;
}

} // namespace

StrokePtr Painting::find(StrokeId id) const
{
    const int index = indexOf(id);
    return index < 0 ? nullptr : strokes[std::size_t(index)];
}

const Group *Painting::findGroup(GroupId id) const
{
    return findIn(groups, id);
}

int Painting::indexOf(StrokeId id) const
{
    const auto it = std::find_if(strokes.begin(), strokes.end(), [id](const StrokePtr &s) { return s->id == id; });
    return it == strokes.end() ? -1 : int(it - strokes.begin());
}

bool Painting::isVisible(const Stroke &stroke) const
{
    const auto isSolo = [](const Group &g) { return g.solo; };
    return stroke.visible && !anyGroup(groups, stroke.group, [](const Group &g) { return !g.visible; }) &&
           (std::ranges::none_of(groups, isSolo) || anyGroup(groups, stroke.group, isSolo));
}

bool Painting::isLocked(const Stroke &stroke) const
{
    return stroke.locked || anyGroup(groups, stroke.group, [](const Group &g) { return g.locked; });
}

std::size_t Painting::segmentCount() const
{
    std::size_t n = 0;
    for (const StrokePtr &s : strokes)
        n += s->segments.size();
    return n;
}

Microseconds Painting::end() const
{
    if (strokes.empty())
        return 0;
    Microseconds t = strokes.front()->driesAt();
    for (const StrokePtr &s : strokes)
        t = std::max(t, s->driesAt());
    return t;
}

StrokeId Painting::nextStrokeId() const
{
    StrokeId id = 0;
    for (const StrokePtr &s : strokes)
        id = std::max(id, s->id);
    return id + 1;
}

Visibility::Visibility(const std::vector<Group> &groups) : m_anySolo(std::ranges::any_of(groups, &Group::solo))
{
    const auto isHidden = [](const Group &g) { return !g.visible; };
    if (!m_anySolo && std::ranges::none_of(groups, isHidden))
        return;
    std::unordered_map<GroupId, const Group *> known;
    for (const Group &group : groups)
        known.emplace(group.id, &group);
    for (const Group &group : groups) {
        bool isSolo = false, hidden = false;
        const Group *around = &group;
        for (std::size_t steps = 0; around && steps <= groups.size(); ++steps) {
            isSolo = isSolo || around->solo, hidden = hidden || !around->visible;
            const auto parent = known.find(around->parent);
            around = parent == known.end() ? nullptr : parent->second;
        }
        if (hidden || (m_anySolo && !isSolo))
            m_hidden.insert(group.id);
    }
}

void forgetLostCurves(Painting &painting)
{
    for (Group &group : painting.groups)
        if (group.text && group.text->follows != 0 && !painting.find(group.text->follows)) {
            Text text = *group.text;
            text.follows = 0;
            text.followMap = {};
            group.text = std::move(text);
        }
}

PaintingPtr withoutDrafts(PaintingPtr painting)
{
    if (std::ranges::none_of(painting->groups, &Group::draft))
        return painting;
    auto exported = std::make_shared<Painting>(*painting);
    for (Group &group : exported->groups)
        if (group.draft)
            group.visible = group.solo = false;
    return exported;
}

std::vector<StrokeId> orderOf(const Painting &painting)
{
    std::vector<StrokeId> order;
    order.reserve(painting.strokes.size() + 1);
    for (const StrokePtr &s : painting.strokes)
        order.push_back(s->id);
    return order;
}

bool operator==(const Painting &a, const Painting &b)
{
    const auto equalStrokes = [](const StrokePtr &x, const StrokePtr &y) { return x == y || (x && y && *x == *y); };
    const bool equalUnderlays = a.underlay == b.underlay || (a.underlay && b.underlay && *a.underlay == *b.underlay);
    return a.canvas == b.canvas && a.groups == b.groups && a.swatches == b.swatches && equalUnderlays &&
           std::equal(a.strokes.begin(), a.strokes.end(), b.strokes.begin(), b.strokes.end(), equalStrokes);
}

} // namespace suffuse
