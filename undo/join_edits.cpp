#include "model/area/area_sets.h"
#include "model/area/outline.h"
#include "model/painting/editable.h"
#include "undo/history/remap.h"
#include "undo/node_edits.h"

namespace suffuse {

namespace {

/// An end of one of a stroke's chains.
struct StrokeEnd {
    int node = 0;
    Point at;
};

std::vector<StrokeEnd> endsOf(const Stroke &stroke)
{
    std::vector<StrokeEnd> ends;
    for (const int node : endNodesOf(stroke))
        ends.push_back({node, nodePosition(stroke, node)});
    return ends;
}

/// The gap between the two nearest ends of two strokes.
struct Gap {
    double distance = std::numeric_limits<double>::infinity();
    int first = 0, second = 0; ///< nodes
};

/// Of gaps that are alike, the one behind the last end counts.
Gap nearestEnds(const std::vector<StrokeEnd> &a, const std::vector<StrokeEnd> &b)
{
    Gap best;
    for (auto end = a.rbegin(); end != a.rend(); ++end)
        for (const StrokeEnd &other : b)
            if (const double d = length(end->at - other.at); d < best.distance)
                best = {d, end->node, other.node};
    return best;
}

/// From bottom to top.
std::vector<StrokePtr> unlockedSelected(const Document &document)
{
    const Painting &painting = *document.painting();
    std::vector<StrokePtr> strokes;
    const Locks isLocked(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (document.selection().strokes.contains(stroke->id) && !isLocked(*stroke))
            strokes.push_back(stroke);
    return strokes;
}

/// Whether two outlines have nothing in common, so that one fill can lie in both.
bool areApart(const Stroke &a, const Stroke &b)
{
    const auto areaIn = [&](const Stroke &stroke) {
        const Point shift = stroke.origin - a.origin;
        std::vector<std::vector<Cubic>> loops = closedOutline(stroke);
        for (std::vector<Cubic> &loop : loops)
            for (Cubic &curve : loop)
                for (Point &p : curve.p)
                    p = p + shift;
        return areaOf(loops, stroke.fill->rule);
    };
    const Area one = areaIn(a), other = areaIn(b), both = intersection(one, other);
    constexpr double rounding = 1e-5; // of what is smaller
    return both.isEmpty() || sizeOf(both) <= rounding * std::min(sizeOf(one), sizeOf(other));
}

/// The fill that one stroke has in the place of two, if it shows what theirs show.
std::optional<SharedFill> oneFill(const Stroke &upper, const Stroke &lower)
{
    if (!upper.fill && !lower.fill)
        return SharedFill();
    if (!upper.fill || !lower.fill || upper.style != lower.style)
        return std::nullopt; // The outline of one would be filled, or lose its fill, or look like the other.
    Fill fill = *upper.fill, like = *lower.fill;
    if (like.gradient) { // its place is an offset from another origin
        const Point shift = lower.origin - upper.origin;
        like.gradient->from = toOffset(shift + like.gradient->from, {});
        like.gradient->to = toOffset(shift + like.gradient->to, {});
    }
    like.born = fill.born = std::max(fill.born, like.born);
    if (fill != like || !areApart(upper, lower))
        return std::nullopt;
    return fill;
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
    struct Joinable {
        StrokePtr stroke;
        std::vector<StrokeEnd> ends;
    };
    std::vector<Joinable> rest;
    for (const StrokePtr &s : unlockedSelected(document))
        rest.push_back({s, endsOf(*s)});
    if (rest.size() < 2)
        return {};
    Stroke whole = *rest.back().stroke;
    rest.pop_back();
    std::set<StrokeId> gone;
    while (!rest.empty()) {
        Gap best;
        auto next = rest.begin();
        const std::vector<StrokeEnd> ends = endsOf(whole);
        for (auto it = rest.begin(); it != rest.end(); ++it)
            if (const Gap gap = nearestEnds(ends, it->ends); gap.distance < best.distance) {
                best = gap;
                next = it;
            }
        if (std::optional<Stroke> longer = joinedAt(whole, best.first, *next->stroke, best.second)) {
            whole = std::move(*longer);
            gone.insert(next->stroke->id);
        }
        rest.erase(next);
    }
    return gone.empty() ? Edit() : mergedInto(document, std::move(whole), gone);
}

Edit combineSelection(const Document &document, bool *keepsFills)
{
    std::vector<StrokePtr> strokes = unlockedSelected(document);
    if (keepsFills)
        *keepsFills = true;
    if (strokes.size() < 2)
        return {};
    Stroke whole = *strokes.back();
    strokes.pop_back();
    std::set<StrokeId> gone;
    for (const StrokePtr &stroke : strokes) {
        const std::optional<SharedFill> fill = oneFill(whole, *stroke);
        if (!fill) {
            if (keepsFills)
                *keepsFills = false;
            return {};
        }
        if (std::optional<Stroke> more = combined(whole, *stroke)) {
            whole = std::move(*more);
            whole.fill = *fill;
            gone.insert(stroke->id);
        }
    }
    return gone.empty() ? Edit() : mergedInto(document, std::move(whole), gone);
}

} // namespace suffuse
