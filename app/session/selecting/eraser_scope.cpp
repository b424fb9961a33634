#include "app/session/selecting/eraser_scope.h"

#include "app/session/selecting/pick.h"
#include "undo/history/order_tree.h"

#include <algorithm>

namespace suffuse {

EraserReach::EraserReach(const Document &document, Microseconds T, EraserScope scope, Point point, double tolerance)
    : m_scope(scope)
{
    const Painting &painting = *document.painting();
    const std::set<StrokeId> &selected = document.selection().strokes;
    if (scope == EraserScope::Selected && selected.empty())
        m_scope = EraserScope::All;
    if (m_scope == EraserScope::Selected)
        m_selected = selected;
    if (m_scope != EraserScope::Group)
        return;
    for (const StrokePtr &stroke : painting.strokes)
        if (selected.contains(stroke->id))
            m_groups.insert(stroke->group);
    if (!m_groups.empty())
        return;
    const std::optional<SegmentRef> under = pickTopmost(painting, T, point, tolerance);
    const StrokePtr stroke = under ? painting.find(under->stroke) : nullptr;
    m_groups.insert(stroke ? stroke->group : 0);
}

Spared EraserReach::spares(const Painting &painting, const Stroke &stroke) const
{
    if (painting.isLocked(stroke))
        return Spared::Locked;
    if (m_scope == EraserScope::Selected && !m_selected.contains(stroke.id))
        return Spared::NotSelected;
    const auto isMeant = [this](GroupId group) { return m_groups.contains(group); };
    if (m_scope == EraserScope::Group && !isMeant(stroke.group) &&
        std::ranges::none_of(groupsAround(painting, stroke.group), isMeant))
        return Spared::OtherGroup;
    return Spared::Nothing;
}

std::vector<StrokePtr> EraserReach::strokesOf(const Painting &painting, Microseconds T) const
{
    std::vector<StrokePtr> strokes = visibleStrokes(painting, T);
    std::erase_if(strokes, [&](const StrokePtr &stroke) { return spares(painting, *stroke) != Spared::Nothing; });
    return strokes;
}

std::vector<StrokePtr> visibleStrokes(const Painting &painting, Microseconds T)
{
    std::vector<StrokePtr> strokes;
    for (const StrokePtr &stroke : painting.strokes)
        if (painting.isVisible(*stroke) && stroke->born() <= T)
            strokes.push_back(stroke);
    return strokes;
}

} // namespace suffuse
