#include "app/tools/nodes/deleted_parts.h"

#include <algorithm>

namespace suffuse {

DeletedParts::DeletedParts(std::set<NodeRef> nodes, const Painting &before, const Painting &after, Selection left)
    : m_nodes(std::move(nodes)), m_left(std::move(left))
{
    for (const NodeRef &node : m_nodes)
        if (!m_strokes.contains(node.stroke))
            m_strokes[node.stroke] = {before.find(node.stroke), after.find(node.stroke)};
}

std::optional<std::set<NodeRef>> DeletedParts::nodesIn(const Painting &painting,
                                                       const std::vector<StrokeId> &changed) const
{
    if (std::ranges::none_of(
            m_strokes, [&](const auto &entry) { return std::ranges::find(changed, entry.first) != changed.end(); }))
        return {};
    const auto areAll = [&](StrokePtr States::*state) {
        return std::ranges::all_of(
            m_strokes, [&](const auto &entry) { return painting.find(entry.first) == entry.second.*state; });
    };
    if (areAll(&States::before))
        return m_nodes;
    return areAll(&States::after) ? std::optional(std::set<NodeRef>()) : std::nullopt;
}

} // namespace suffuse
