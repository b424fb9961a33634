#include "model/painting/painting.h"

#include <algorithm>

namespace suffuse {

namespace {

const Group *findGroup(const std::vector<Group> &groups, GroupId id)
{
    const auto it = std::find_if(groups.begin(), groups.end(), [id](const Group &g) { return g.id == id; });
    return it == groups.end() ? nullptr : &*it;
}

/// Whether a predicate is true of a group on the way from `id` to the root. The search ends on damaged chains, too.
template <typename Predicate>
bool anyGroup(const std::vector<Group> &groups, GroupId id, Predicate predicate)
{
    for (std::size_t steps = 0; id != 0 && steps <= groups.size(); ++steps) {
        const Group *group = findGroup(groups, id);
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

int Painting::indexOf(StrokeId id) const
{
    const auto it = std::find_if(strokes.begin(), strokes.end(), [id](const StrokePtr &s) { return s->id == id; });
    return it == strokes.end() ? -1 : int(it - strokes.begin());
}

bool Painting::isVisible(const Stroke &stroke) const
{
    return stroke.visible && !anyGroup(groups, stroke.group, [](const Group &g) { return !g.visible; });
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
