#include "app/panels/strokes/rows/row_look.h"

#include "undo/history/order_tree.h"

#include <algorithm>

namespace suffuse {

const QPalette &WeakPalette::of(const QPalette &palette) const
{
    if (m_madeOf == palette.cacheKey())
        return m_weak;
    m_madeOf = palette.cacheKey();
    m_weak = palette;
    const auto mixed = [](const QColor &a, const QColor &b) {
        const auto channel = [](int x, int y) { return (3 * x + 7 * y) / 10; };
        return QColor(channel(a.red(), b.red()), channel(a.green(), b.green()), channel(a.blue(), b.blue()));
    };
    for (const auto group : {QPalette::Active, QPalette::Inactive}) {
        m_weak.setColor(group, QPalette::Highlight,
                        mixed(palette.color(group, QPalette::Highlight), palette.color(group, QPalette::Base)));
        m_weak.setColor(group, QPalette::HighlightedText, palette.color(group, QPalette::Text));
    }
    return m_weak;
}

bool isStronglySelected(const QStyleOptionViewItem &option)
{
    const QPalette &palette = option.palette;
    return (option.state & QStyle::State_Selected) &&
           palette.color(QPalette::HighlightedText) != palette.color(QPalette::Text);
}

bool isHiddenByOthers(const Painting &painting, const Stroke *stroke, const Group *group)
{
    if (std::ranges::none_of(painting.groups, &Group::solo))
        return false;
    const std::vector<GroupId> around = groupsAround(painting, stroke ? stroke->group : group->id);
    if (std::ranges::any_of(around, [&](GroupId id) { return painting.findGroup(id)->solo; }))
        return false;
    return stroke || std::ranges::none_of(painting.groups, [&](const Group &other) {
               const std::vector<GroupId> outer = groupsAround(painting, other.id);
               return other.solo && std::ranges::find(outer, group->id) != outer.end();
           });
}

} // namespace suffuse
