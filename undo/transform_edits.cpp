#include "undo/transform_edits.h"

#include "model/paint/half_width.h"
#include "model/painting/editable.h"
#include "model/painting/validate.h"
#include "undo/history/order_tree.h"
#include "undo/history/remap.h"
#include "undo/text_edits.h"

namespace suffuse {

namespace {

/// A stroke, or a group that is selected as a whole, which moves as one.
struct MovedUnit {
    std::vector<StrokePtr> strokes;
    Rect box;
};

std::vector<MovedUnit> unitsOf(const Document &document)
{
    const Painting &painting = *document.painting();
    std::unordered_map<StrokeId, StrokePtr> byId;
    for (const StrokePtr &s : painting.strokes)
        if (document.selection().strokes.contains(s->id))
            byId.emplace(s->id, s);
    const std::vector<Sibling> tree = orderTree(painting, document.selection().strokes);
    std::vector<MovedUnit> units;
    for (const Sibling *sibling : selectedUnits(tree)) {
        MovedUnit unit;
        forEachStroke(*sibling, [&](StrokeId id) {
            unit.strokes.push_back(byId.at(id));
            unit.box = unit.box.united(seenBox(*unit.strokes.back()));
        });
        units.push_back(std::move(unit));
    }
    return units;
}

void move(const MovedUnit &unit, Point by, Edit &edit)
{
    if (by == Point())
        return;
    for (const StrokePtr &stroke : unit.strokes) {
        auto moved = std::make_shared<Stroke>(*stroke);
        moved->origin = moved->origin + by;
        if (moved->origin != stroke->origin && problemOf(*moved).isEmpty())
            edit.strokes.emplace(stroke->id, std::move(moved));
    }
}

/// How far a box must move to be aligned with another one.
Point wayTo(const Rect &target, const Rect &box, Align how)
{
    switch (how) {
    case Align::Left:
        return {target.left - box.left, 0};
    case Align::Centre:
        return {target.centre().x - box.centre().x, 0};
    case Align::Right:
        return {target.right - box.right, 0};
    case Align::Top:
        return {0, target.top - box.top};
    case Align::Middle:
        return {0, target.centre().y - box.centre().y};
    case Align::Bottom:
        return {0, target.bottom - box.bottom};
    }
    return {};
}

Rect targetBox(const Document &document, const std::vector<MovedUnit> &units, AlignTo to, StrokeId anchor)
{
    const auto size = [](const MovedUnit &unit) { return std::hypot(unit.box.width(), unit.box.height()); };
    const auto smaller = [&](const MovedUnit &a, const MovedUnit &b) { return size(a) < size(b); };
    const auto hasAnchor = [anchor](const MovedUnit &unit) {
        return std::any_of(unit.strokes.begin(), unit.strokes.end(),
                           [anchor](const StrokePtr &s) { return s->id == anchor; });
    };
    switch (to) {
    case AlignTo::Canvas:
        return document.painting()->canvas.area();
    case AlignTo::Anchor: {
        const auto found = std::find_if(units.begin(), units.end(), hasAnchor);
        return (found == units.end() ? units.back() : *found).box;
    }
    case AlignTo::Biggest: // by its diagonal: a level line has no area
        return std::max_element(units.begin(), units.end(), smaller)->box;
    case AlignTo::Selection:
        break;
    }
    Rect all;
    for (const MovedUnit &unit : units)
        all = all.united(unit.box);
    return all;
}

} // namespace

Edit transformSelection(const Document &document, const Affine &map, SpreadRule rule)
{
    if (map.isIdentity())
        return {};
    return transformSelection(document, *document.painting(), document.selection(), map, rule);
}

Edit transformSelection(const Document &document, const Painting &before, const Selection &selection, const Affine &map,
                        SpreadRule rule)
{
    Edit edit;
    Selection after = selection;
    const Locks isLocked(before.groups);
    for (const StrokePtr &stroke : before.strokes) {
        if (!selection.strokes.contains(stroke->id) || isLocked(*stroke))
            continue;
        if (map.isIdentity()) {
            edit.strokes.emplace(stroke->id, stroke);
            continue;
        }
        std::vector<int> sources;
        std::optional<Stroke> result = tryTransformed(*stroke, map, rule, &sources);
        if (!result)
            return {};
        if (!selection.segments.empty() && sources.size() != stroke->segments.size())
            remap(after, stroke->id, sources);
        edit.strokes.emplace(stroke->id, std::make_shared<const Stroke>(std::move(*result)));
    }
    if (!edit.strokes.empty() && after != document.selection())
        edit.selection = std::move(after);
    edit.groups = withTextsMapped(*document.painting(),
                                  wholeTexts(before, [&edit](StrokeId id) { return edit.strokes.contains(id); }), map);
    return edit;
}

Rect selectionBox(const Painting &painting, const Selection &selection)
{
    Rect box;
    if (selection.strokes.empty())
        return box;
    const Locks isLocked(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        if (!selection.strokes.contains(stroke->id) || isLocked(*stroke))
            continue;
        const bool lays = stroke->laysPaint();
        for (const Segment &segment : stroke->segments) {
            if (segment.takesPaint() && lays)
                continue;
            const Cubic cubic = stroke->cubicOf(segment);
            const auto isWithin = [&box, control = cubic.controlBox()] {
                return box.contains({control.left, control.top}) && box.contains({control.right, control.bottom});
            };
            if (isWithin())
                continue;
            // The ends come first: a curve is solved for only if it may reach beyond the box so far.
            box.include(cubic.p[0]);
            box.include(cubic.p[3]);
            if (!isWithin())
                box = box.united(curveBox(cubic));
        }
    }
    return box;
}

int movedUnits(const Document &document)
{
    return int(unitsOf(document).size());
}

Edit align(const Document &document, Align how, AlignTo to, StrokeId anchor)
{
    const std::vector<MovedUnit> units = unitsOf(document);
    Edit edit;
    if (units.empty())
        return edit;
    const Rect target = targetBox(document, units, to, anchor);
    for (const MovedUnit &unit : units)
        move(unit, wayTo(target, unit.box, how), edit);
    return edit;
}

Edit distribute(const Document &document, Axis axis, Spacing spacing)
{
    struct Span {
        const MovedUnit *unit;
        double from, to;
        double centre() const { return 0.5 * (from + to); }
    };
    const std::vector<MovedUnit> units = unitsOf(document);
    Edit edit;
    if (units.size() < 3)
        return edit;
    std::vector<Span> spans;
    double covered = 0;
    for (const MovedUnit &unit : units) {
        const Rect &b = unit.box;
        spans.push_back(axis == Axis::Horizontal ? Span{&unit, b.left, b.right} : Span{&unit, b.top, b.bottom});
        covered += spans.back().to - spans.back().from;
    }
    std::stable_sort(spans.begin(), spans.end(), [](const Span &a, const Span &b) { return a.centre() < b.centre(); });
    const double steps = double(spans.size() - 1);
    const double gap = (spans.back().to - spans.front().from - covered) / steps;
    const double pitch = (spans.back().centre() - spans.front().centre()) / steps;
    double edge = spans.front().to + gap;
    for (std::size_t i = 1; i + 1 < spans.size(); ++i) {
        const Span &s = spans[i];
        const double by =
            spacing == Spacing::Gaps ? edge - s.from : spans.front().centre() + double(i) * pitch - s.centre();
        edge += s.to - s.from + gap;
        move(*s.unit, axis == Axis::Horizontal ? Point{by, 0} : Point{0, by}, edit);
    }
    return edit;
}

} // namespace suffuse
