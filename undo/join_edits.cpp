#include "undo/node_edits.h"
#include "undo/remap.h"

namespace suffuse {

namespace {

/// The gap between the two nearest ends of two strokes.
struct Gap {
    double distance = std::numeric_limits<double>::infinity();
    bool firstAtEnd = true, secondAtEnd = false;
};

Gap nearestEnds(const Stroke &a, const Stroke &b)
{
    Gap best;
    for (bool aAtEnd : {true, false})
        for (bool bAtEnd : {false, true}) {
            const Point p = nodePosition(a, aAtEnd ? int(a.segments.size()) : 0);
            const Point q = nodePosition(b, bAtEnd ? int(b.segments.size()) : 0);
            if (const double d = length(p - q); d < best.distance)
                best = {d, aAtEnd, bAtEnd};
        }
    return best;
}

/// Puts `whole` in the place of the stroke with its id, and removes others.
Edit mergedInto(const Document &document, Stroke whole, const std::set<StrokeId> &gone)
{
    Edit edit;
    Selection selection = document.selection();
    std::vector<StrokeId> order;
    for (const StrokePtr &s : document.painting()->strokes)
        if (!gone.contains(s->id))
            order.push_back(s->id);
    std::set<StrokeId> concerned = gone;
    concerned.insert(whole.id);
    for (StrokeId id : concerned) {
        remap(selection, id, {});
        if (selection.strokes.contains(id))
            selection.strokes.insert(whole.id);
    }
    for (StrokeId id : gone) {
        edit.strokes.emplace(id, nullptr);
        selection.strokes.erase(id);
    }
    edit.strokes.emplace(whole.id, std::make_shared<const Stroke>(std::move(whole)));
    edit.order = std::move(order);
    if (selection != document.selection())
        edit.selection = std::move(selection);
    return edit;
}

} // namespace

Edit joinNodes(const Document &document, NodeRef a, NodeRef b)
{
    const Painting &painting = *document.painting();
    StrokePtr upper = painting.find(a.stroke), lower = painting.find(b.stroke);
    if (!upper || !lower || painting.isLocked(*upper) || painting.isLocked(*lower) || a == b)
        return {};
    if (upper == lower) {
        std::optional<Stroke> whole = joinedWithin(*upper, a.node, b.node);
        return whole ? mergedInto(document, std::move(*whole), {}) : Edit();
    }
    if (painting.indexOf(a.stroke) < painting.indexOf(b.stroke)) {
        std::swap(upper, lower);
        std::swap(a, b);
    }
    std::optional<Stroke> whole = joinedAt(*upper, a.node, *lower, b.node);
    return whole ? mergedInto(document, std::move(*whole), {lower->id}) : Edit();
}

Edit joinSelection(const Document &document)
{
    const Painting &painting = *document.painting();
    std::vector<StrokePtr> rest;
    for (const StrokePtr &s : painting.strokes)
        if (document.selection().strokes.contains(s->id) && !painting.isLocked(*s))
            rest.push_back(s);
    if (rest.size() < 2)
        return {};
    Stroke whole = *rest.back();
    rest.pop_back();
    std::set<StrokeId> gone;
    while (!rest.empty()) {
        Gap best;
        auto next = rest.begin();
        for (auto it = rest.begin(); it != rest.end(); ++it)
            if (const Gap gap = nearestEnds(whole, **it); gap.distance < best.distance) {
                best = gap;
                next = it;
            }
        if (join(whole, best.firstAtEnd, **next, best.secondAtEnd))
            gone.insert((*next)->id);
        rest.erase(next);
    }
    return gone.empty() ? Edit() : mergedInto(document, std::move(whole), gone);
}

} // namespace suffuse
