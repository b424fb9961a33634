#include "app/session/selecting/eraser_scope.h"

#include "app/session/current_layer.h"
#include "app/session/selecting/pick.h"
#include "undo/history/order_tree.h"

#include <algorithm>

namespace suffuse {

EraserReach::EraserReach(const Document &document, const CurrentLayer &layer, Microseconds T, EraserScope scope,
                         Point point, double tolerance)
    : m_scope(scope), m_isLocked(document.painting()->groups), m_isOnly(layer.reachedGroup() != 0)
{
    const Painting &painting = *document.painting();
    const std::set<StrokeId> &selected = document.selection().strokes;
    if (m_isOnly)
        m_layer = withGroupsWithin(painting.groups, {layer.reachedGroup()});
    if (scope == EraserScope::Selected && selected.empty())
        m_scope = EraserScope::All;
    if (m_scope == EraserScope::Selected)
        m_selected = selected;
    if (m_scope != EraserScope::Group)
        return;
    std::set<GroupId> groups;
    for (const StrokePtr &stroke : painting.strokes)
        if (selected.contains(stroke->id))
            groups.insert(stroke->group);
    if (groups.empty() && layer.group() != 0)
        groups.insert(layer.group());
    if (groups.empty()) {
        const std::optional<SegmentRef> under = pickTopmost(*layer.reached(), T, point, tolerance);
        const StrokePtr stroke = under ? painting.find(under->stroke) : nullptr;
        groups.insert(stroke ? stroke->group : 0);
    }
    m_groups = withGroupsWithin(painting.groups, groups);
}

Spared EraserReach::spares(const Stroke &stroke) const
{
    if (m_isOnly && !m_layer.contains(stroke.group))
        return Spared::OtherLayer;
    if (m_isLocked(stroke))
        return Spared::Locked;
    if (m_scope == EraserScope::Selected && !m_selected.contains(stroke.id))
        return Spared::NotSelected;
    if (m_scope == EraserScope::Group && !m_groups.contains(stroke.group))
        return Spared::OtherGroup;
    return Spared::Nothing;
}

std::vector<StrokePtr> EraserReach::strokesOf(const Painting &painting, Microseconds T) const
{
    std::vector<StrokePtr> strokes = visibleStrokes(painting, T);
    std::erase_if(strokes, [&](const StrokePtr &stroke) { return spares(*stroke) != Spared::Nothing; });
    return strokes;
}

std::vector<StrokePtr> visibleStrokes(const Painting &painting, Microseconds T)
{
    std::vector<StrokePtr> strokes;
    const Visibility isVisible(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (isVisible(*stroke) && stroke->born() <= T)
            strokes.push_back(stroke);
    return strokes;
}

} // namespace suffuse
