// One change of a document, as a pair of states that swap.
#pragma once

#include "model/document/order_difference.h"
#include "model/painting/painting.h"
#include "model/painting/selection.h"

#include <map>
#include <optional>

namespace suffuse {

/// The state to put in; after `Document::exchange` it holds the state that was there, so exchanging again undoes it.
/// Absent members leave that part of the document alone. Cost: in proportion to what it touches.
struct Edit {
    std::map<StrokeId, StrokePtr> strokes; ///< null: the stroke is absent
    /// The whole order wanted, bottom to top; given whenever strokes come or go.
    std::optional<std::vector<StrokeId>> order;
    /// In place of `order` in an edit that was exchanged: what makes the order that was there of the one that is.
    std::optional<OrderDifference> places;
    std::optional<Canvas> canvas;
    std::optional<std::vector<Group>> groups;
    std::optional<std::vector<Swatch>> swatches;
    std::optional<std::shared_ptr<const Underlay>> underlay;
    std::optional<Selection> selection;

    bool reorders() const { return order || places; }
    /// Whether anything but strokes is touched, the selection aside.
    bool touchesTheRest() const { return canvas || groups || swatches || underlay; }
    bool isEmpty() const { return strokes.empty() && !reorders() && !touchesTheRest() && !selection; }
};

/// The order that the edit wants where `before` is there.
std::vector<StrokeId> orderWanted(const Edit &edit, const std::vector<StrokeId> &before);

/// What an exchange altered, for views that refresh. What must be redrawn is never taken from here: renderers compare
/// snapshots.
struct Change {
    std::vector<StrokeId> strokes; ///< replaced, added or removed
    bool order = false;            ///< strokes came, went or moved
    bool canvas = false;           ///< canvas, groups, swatches or underlay
    bool selection = false;
    bool draft = false; ///< the stroke being drawn
    bool reset = false; ///< another painting altogether
};

} // namespace suffuse
