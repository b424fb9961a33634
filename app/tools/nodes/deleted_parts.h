// What is remembered of nodes or segments that were deleted last.
#pragma once

#include "model/painting/painting.h"
#include "model/painting/selection.h"
#include "model/painting/stroke_places.h"

#include <map>
#include <optional>
#include <set>

namespace suffuse {

/// Where parts of strokes were deleted, what is left of the strokes stays selected, so that it is seen. But nobody has
/// chosen it to be deleted next. And nodes, of which the document knows nothing, are selected again after an undo.
class DeletedParts {
public:
    /// The nodes (none if they were segments) that were deleted between two paintings, and the selection that was left.
    DeletedParts(std::set<NodeRef> nodes, const Painting &before, const Painting &after, Selection left);

    /// Whether this selection is merely what was left.
    bool leaves(const Selection &selection) const { return !selection.isEmpty() && selection == m_left; }
    /// The nodes that are to be selected in a painting in which those strokes have changed: all of them if the strokes
    /// are again what they were, none if they are once more what was left; no value if they are something else.
    std::optional<std::set<NodeRef>> nodesIn(const Painting &painting, const std::vector<StrokeId> &changed) const;

private:
    struct States {
        StrokePtr before, after;
    };
    std::set<NodeRef> m_nodes;
    std::map<StrokeId, States> m_strokes; ///< of the nodes
    Selection m_left;
};

} // namespace suffuse
