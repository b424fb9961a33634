// One change of a document, as a pair of states that swap.
#pragma once

#include "model/document/order_difference.h"
#include "model/painting/painting.h"
#include "model/painting/selection.h"

#include <map>
#include <optional>

namespace suffuse {

/// An edit holds the state to put in. After `Document::exchange` it holds the state that was there before, so that
/// exchanging it again undoes it. Members that are absent leave their part of the document alone. Its cost is in
/// proportion to what it touches.
struct Edit {
    std::map<StrokeId, StrokePtr> strokes; ///< null: the stroke does not exist in this state
    /// The whole order that is wanted, from bottom to top. It must be given whenever strokes are added or removed.
    std::optional<std::vector<StrokeId>> order;
    /// In an edit that was exchanged, this stands in place of `order`. It turns the present order into the one before.
    std::optional<OrderDifference> places;
    std::optional<Canvas> canvas;
    std::optional<std::vector<Group>> groups;
    std::optional<std::vector<Swatch>> swatches;
    std::optional<std::shared_ptr<const Underlay>> underlay;
    std::optional<Selection> selection;

    bool reorders() const { return order || places; }
    /// Whether anything but strokes and selection is touched.
    bool touchesTheRest() const { return canvas || groups || swatches || underlay; }
    bool isEmpty() const { return strokes.empty() && !reorders() && !touchesTheRest() && !selection; }
};

/// The order that the edit wants where the present order is `before`.
std::vector<StrokeId> orderWanted(const Edit &edit, const std::vector<StrokeId> &before);

/// What an exchange has altered, for views that refresh. What must be redrawn is never told by it: renderers compare
/// snapshots.
struct Change {
    std::vector<StrokeId> strokes; ///< replaced, added or removed
    bool order = false;            ///< whether strokes were added, removed or moved
    bool canvas = false;           ///< whether canvas, groups, swatches or underlay changed, more than `texts` tells
    bool texts = false;            ///< whether groups that are texts are other texts, as at each key that is typed
    bool selection = false;
    bool draft = false; ///< whether the stroke that is being drawn changed
    bool reset = false; ///< whether it is another painting altogether
};

} // namespace suffuse
