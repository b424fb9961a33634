#include "undo/time_edits.h"

#include "model/area/outline.h"
#include "model/brush/stroke_fit.h"
#include "model/painting/editable.h"
#include "model/painting/validate.h"
#include "undo/history/order_tree.h"
#include "undo/layers/layer_edits.h"

#include <limits>
#include <numbers>

namespace suffuse {

namespace {

constexpr Microseconds latest = std::numeric_limits<Microseconds>::max() / 4;

/// Knows which segments of a stroke a selection means (all of them, or those that are selected), and which of these
/// draw it. What erases softly is no part of the drawing: it was done at a time of its own, which may be long after.
/// Only where nothing but erasures is meant are they what is drawn.
class Selected {
public:
    Selected(const Selection &selection, const Stroke &stroke)
        : m_selection(selection), m_stroke(stroke), m_there(selection.strokes.contains(stroke.id))
    {
        const auto first = selection.segments.lower_bound({stroke.id, 0});
        m_all = first == selection.segments.end() || first->stroke != stroke.id;
        for (std::size_t k = 0; k < stroke.segments.size() && !m_drawsPaint; ++k)
            m_drawsPaint = !stroke.segments[k].takesPaint() && contains(k);
    }
    bool any() const { return m_there; }
    /// Whether it means the stroke itself, its fill included, and not some of its segments.
    bool whole() const { return m_there && m_all; }
    bool contains(std::size_t segment) const
    {
        return m_there && (m_all || m_selection.segments.contains({m_stroke.id, int(segment)}));
    }
    /// Whether the segment is of the kind that is drawn, selected or not.
    bool isOfDrawing(std::size_t segment) const { return m_stroke.segments[segment].takesPaint() != m_drawsPaint; }
    bool draws(std::size_t segment) const { return isOfDrawing(segment) && contains(segment); }

private:
    const Selection &m_selection;
    const Stroke &m_stroke;
    bool m_there;
    bool m_all;
    bool m_drawsPaint = false;
};

/// Segments of one stroke that are drawn one after the other, by their indices in ascending order.
using Run = std::vector<std::size_t>;

/// The births of all segments for which `which` is true in strokes that are selected and not locked; the end comes
/// before the begin if there are none.
TimeSpan birthsOf(const Painting &painting, const Selection &selection, bool (Selected::*which)(std::size_t) const)
{
    TimeSpan span{latest, -latest};
    const Locks isLocked(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        if (!selection.strokes.contains(stroke->id) || isLocked(*stroke))
            continue;
        const Selected selected(selection, *stroke);
        for (std::size_t k = 0; k < stroke->segments.size(); ++k)
            if ((selected.*which)(k)) {
                span.begin = std::min(span.begin, stroke->segments[k].born);
                span.end = std::max(span.end, stroke->segments[k].born);
            }
    }
    return span;
}

/// Maps document time T to from + (T − from)·factor + by. The factor must not be negative.
struct TimeMap {
    Microseconds from = 0;
    double factor = 1;
    Microseconds by = 0;

    Microseconds operator()(Microseconds T) const
    {
        return from + by + (factor == 1 ? T - from : Microseconds(std::llround(double(T - from) * factor)));
    }
};

void shift(Segment &segment, const TimeMap &map)
{
    segment.born = map(segment.born);
    for (Rewet &r : segment.rewet)
        r.time = map(r.time);
}

void shiftFill(Stroke &stroke, const TimeMap &map)
{
    if (!stroke.fill)
        return;
    Fill fill = *stroke.fill;
    fill.born = map(fill.born);
    stroke.fill = fill;
}

/// The share of the time after which the pen has gone `way`, a share of the curve.
double timeAt(Pace pace, double way)
{
    switch (pace) {
    case Pace::Even:
        return way;
    case Pace::EaseIn:
        return std::sqrt(way);
    case Pace::EaseOut:
        return 1 - std::sqrt(1 - way);
    case Pace::EaseInOut:
        return std::acos(1 - 2 * way) / std::numbers::pi;
    }
    return way;
}

/// Sets the births of the segments of a run between those of the first and the last.
void paceRun(Stroke &stroke, const Run &run, Pace pace)
{
    std::vector<double> ways{0}; // from the start of the first segment to that of each
    for (std::size_t i = 0; i + 1 < run.size(); ++i)
        ways.push_back(ways.back() + arcLength(stroke.cubicOf(stroke.segments[run[i]])));
    const Microseconds begin = stroke.segments[run.front()].born, end = stroke.segments[run.back()].born;
    if (!(ways.back() > 0))
        return;
    for (std::size_t i = 1; i + 1 < run.size(); ++i) {
        const double share = timeAt(pace, std::clamp(ways[i] / ways.back(), 0.0, 1.0));
        const Microseconds born = begin + Microseconds(std::llround(double(end - begin) * share));
        shift(stroke.segments[run[i]], {.by = born - stroke.segments[run[i]].born});
    }
}

/// The share of the time that has passed after easing, for a share before it: a cubic with the ease's slopes at its
/// ends.
double eased(const Ease &ease, double share)
{
    const double left = 1 - share;
    return share * (ease.atBegin * left * left + share * (3 - 2 * share) - ease.atEnd * share * left);
}

void easeRun(Stroke &stroke, const Run &run, const Ease &ease)
{
    const auto bornOf = [&stroke](std::size_t k) { return stroke.segments[k].born; };
    const auto [first, last] = std::ranges::minmax(run, {}, bornOf);
    const Microseconds begin = bornOf(first), length = bornOf(last) - begin;
    for (const std::size_t k : run) {
        const Microseconds since = bornOf(k) - begin;
        if (since > 0 && since < length)
            shift(stroke.segments[k],
                  {.by = Microseconds(std::llround(double(length) * eased(ease, double(since) / double(length)))) -
                         since});
    }
}

/// Calls visit(run) for each run of segments that the selection draws. Erasures between them are no part of a run, and
/// do not end it.
template <typename Visit>
void forEachRun(const Stroke &stroke, const Selected &selected, Visit visit)
{
    Run run;
    const auto end = [&] {
        if (!run.empty())
            visit(std::as_const(run));
        run.clear();
    };
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        if (selected.draws(k))
            run.push_back(k);
        else if (selected.isOfDrawing(k))
            end();
    }
    end();
}

/// When the first paint of a stroke is laid; `latest` where it has none.
Microseconds paintBegins(const Stroke &stroke)
{
    Microseconds begin = latest;
    for (const Segment &segment : stroke.segments)
        if (!segment.takesPaint())
            begin = std::min(begin, segment.born);
    return begin;
}

/// Draws a stroke in another time by `apply`. Erasures keep their time, but nothing is erased before the stroke is
/// begun: those that would be come at its begin.
template <typename Apply>
void drawAnew(Stroke &stroke, Apply apply)
{
    const Microseconds before = paintBegins(stroke);
    apply(stroke);
    const Microseconds begin = paintBegins(stroke);
    for (Segment &segment : stroke.segments)
        if (segment.takesPaint() && segment.born >= before && segment.born < begin)
            shift(segment, {.by = begin - segment.born});
}

/// The selected strokes of `before`, changed. A stroke that does not change is put back as it was, so that a drag that
/// comes back leaves no trace.
template <typename Apply>
Edit changedSince(const Painting &before, const Selection &selection, Apply apply)
{
    Edit edit;
    const Locks isLocked(before.groups);
    for (const StrokePtr &stroke : before.strokes) {
        const Selected selected(selection, *stroke);
        if (!selected.any() || isLocked(*stroke))
            continue;
        auto changed = std::make_shared<Stroke>(*stroke);
        apply(*changed, selected);
        if (!problemOf(*changed).isEmpty())
            return {};
        edit.strokes.emplace(stroke->id, *changed == *stroke ? stroke : StrokePtr(std::move(changed)));
    }
    return edit;
}

void freezeSegment(Segment &segment, Microseconds T)
{
    if (T < segment.born || T >= segment.driesAt())
        return;
    // A segment that was born just now gets the smallest possible age.
    if (toSeconds(T - segment.born) < double(segment.maxAge))
        segment.maxAge = float(toSeconds(std::max<Microseconds>(T - segment.born, 1)));
    for (Rewet &r : segment.rewet)
        if (r.time <= T)
            r.extra = std::min(r.extra, T - r.time);
    std::erase_if(segment.rewet, [](const Rewet &r) { return r.extra == 0; });
}

bool takesPaint(const Painting &painting, GroupId group)
{
    Stroke member;
    member.group = group;
    return painting.isVisible(member) && !painting.isLocked(member);
}

/// Strokes that an edit adds, which stay together: one, or those of a group that it adds, as those of a text.
struct Added {
    GroupId group = 0; ///< the group, which is in no other one; 0: none
    std::vector<StrokeId> strokes;
    Microseconds born = 0; ///< when the first of them is begun
};

/// What an edit adds that does nothing else (`addedOnTop`); nothing where a stroke joins a group that there is already.
std::vector<Added> addedTogether(const Painting &painting, const Edit &edit)
{
    std::vector<Added> all;
    Painting after;
    after.groups = edit.groups ? *edit.groups : painting.groups;
    for (const StrokeId id : addedOnTop(painting, edit)) {
        const Stroke &stroke = *edit.strokes.at(id);
        const std::vector<GroupId> around = groupsAround(after, stroke.group);
        const auto isOld = [&](GroupId group) { return std::ranges::count(painting.groups, group, &Group::id) > 0; };
        if (std::ranges::any_of(around, isOld))
            return {};
        const GroupId outermost = around.empty() ? 0 : around.back();
        if (outermost && !all.empty() && all.back().group == outermost) {
            all.back().strokes.push_back(id);
            all.back().born = std::min(all.back().born, stroke.born());
        } else {
            all.push_back({outermost, {id}, stroke.born()});
        }
    }
    return all;
}

} // namespace

TimeSpan drawnSpan(const Painting &painting, const Selection &selection)
{
    return birthsOf(painting, selection, &Selected::draws);
}

Edit retime(const Painting &before, const Selection &selection, Microseconds by)
{
    const TimeSpan span = birthsOf(before, selection, &Selected::contains);
    if (span.end < span.begin)
        return {};
    // Nothing begins before time 0 that did not do so before.
    by += std::max<Microseconds>(0, std::min<Microseconds>(0, span.begin) - (span.begin + by));
    return changedSince(before, selection, [by](Stroke &stroke, const Selected &selected) {
        for (std::size_t k = 0; k < stroke.segments.size(); ++k)
            if (selected.contains(k))
                shift(stroke.segments[k], {.by = by});
        if (selected.whole())
            shiftFill(stroke, {.by = by});
    });
}

Edit beginAt(const Painting &before, const Selection &selection, const BeginMap &map)
{
    bool possible = true;
    Edit edit = changedSince(before, selection, [&](Stroke &stroke, const Selected &selected) {
        Microseconds first = latest;
        for (std::size_t k = 0; k < stroke.segments.size(); ++k)
            if (selected.draws(k))
                first = std::min(first, stroke.segments[k].born);
        const std::optional<Microseconds> begin = map(first);
        possible = possible && begin;
        for (std::size_t k = 0; k < stroke.segments.size() && begin; ++k)
            if (selected.contains(k))
                shift(stroke.segments[k], {.by = *begin - first});
        if (begin && selected.whole())
            shiftFill(stroke, {.by = *begin - first});
    });
    return possible ? edit : Edit();
}

Edit stretch(const Painting &before, const Selection &selection, TimeSpan span)
{
    const TimeSpan drawn = drawnSpan(before, selection);
    if (drawn.end < drawn.begin)
        return {};
    span.begin = std::max(span.begin, std::min<Microseconds>(0, drawn.begin));
    span.end = std::max(span.end, span.begin);
    const bool atOnce = drawn.begin == drawn.end;
    const double factor = atOnce ? 1 : double(span.end - span.begin) / double(drawn.end - drawn.begin);
    const TimeMap map{drawn.begin, factor, span.begin - drawn.begin};
    const auto slowed = [&](Stroke &stroke, const Selected &selected) {
        for (std::size_t k = 0; k < stroke.segments.size(); ++k)
            if (selected.draws(k))
                shift(stroke.segments[k], map);
    };
    const auto drawnEvenly = [&](Stroke &stroke, const Selected &selected) {
        forEachRun(stroke, selected, [&](const Run &run) {
            shift(stroke.segments[run.front()], {.by = span.begin - stroke.segments[run.front()].born});
            if (run.size() > 1) {
                shift(stroke.segments[run.back()], {.by = span.end - stroke.segments[run.back()].born});
                paceRun(stroke, run, Pace::Even);
            }
        });
    };
    return changedSince(before, selection, [&](Stroke &stroke, const Selected &selected) {
        drawAnew(stroke, [&](Stroke &anew) { atOnce ? drawnEvenly(anew, selected) : slowed(anew, selected); });
        if (selected.whole())
            shiftFill(stroke, map);
    });
}

Edit setPace(const Document &document, Pace pace)
{
    const Selection &selection = document.selection();
    return changeStrokes(document, selection.strokes, [&](Stroke &stroke) {
        drawAnew(stroke, [&](Stroke &anew) {
            forEachRun(anew, Selected(selection, anew), [&](const Run &run) { paceRun(anew, run, pace); });
        });
    });
}

Edit ease(const Painting &before, const Selection &selection, const Ease &ease)
{
    const auto allowed = [](double slower) { return std::clamp(slower, 1 / Ease::most, Ease::most); };
    const Ease kept{allowed(ease.atBegin), allowed(ease.atEnd)};
    return changedSince(before, selection, [&kept](Stroke &stroke, const Selected &selected) {
        if (kept.atBegin != 1 || kept.atEnd != 1)
            drawAnew(stroke, [&](Stroke &anew) {
                forEachRun(anew, selected, [&](const Run &run) { easeRun(anew, run, kept); });
            });
    });
}

Edit freeze(const Document &document, Microseconds T)
{
    std::set<StrokeId> wet;
    for (const StrokePtr &stroke : document.painting()->strokes)
        if (stroke->born() <= T && stroke->driesAt() > T)
            wet.insert(stroke->id);
    return changeStrokes(document, wet, [T](Stroke &stroke) {
        for (Segment &segment : stroke.segments)
            freezeSegment(segment, T);
        if (stroke.fill && T >= stroke.fill->born && T < stroke.fill->driesAt()) {
            Fill fill = *stroke.fill;
            fill.maxAge = float(toSeconds(std::max<Microseconds>(T - fill.born, 1)));
            stroke.fill = fill;
        }
    });
}

Edit rewet(const Document &document, Microseconds T, Microseconds extra)
{
    if (extra <= 0)
        return {};
    const Painting &painting = *document.painting();
    std::vector<SegmentRef> targets = targetSegments(document);
    std::map<StrokeId, StrokePtr> strokes;
    for (const SegmentRef &ref : targets)
        if (StrokePtr &stroke = strokes[ref.stroke]; !stroke)
            stroke = painting.find(ref.stroke);
    std::erase_if(targets, [&](const SegmentRef &ref) { // Without paint there is nothing to wet.
        const StrokePtr &stroke = strokes[ref.stroke];
        return stroke && std::size_t(ref.segment) < stroke->segments.size() &&
               onlyBounds(*stroke, std::size_t(ref.segment));
    });
    return changeSegments(document, targets, [&](Segment &segment) {
        if (segment.born > T)
            return;
        const auto later = std::ranges::upper_bound(segment.rewet, T, {}, &Rewet::time);
        segment.rewet.insert(later, {T, extra});
    });
}

Edit removeRewetting(const Document &document, const Rewet &one)
{
    return changeSegments(document, targetSegments(document),
                          [&one](Segment &segment) { std::erase(segment.rewet, one); });
}

Edit removeRewetting(const Document &document)
{
    return changeSegments(document, targetSegments(document), [](Segment &segment) { segment.rewet.clear(); });
}

bool canRemoveRewetting(const Document &document)
{
    const Painting &painting = *document.painting();
    const Selection &selection = document.selection();
    const auto isRewetted = [](const Segment &segment) { return !segment.rewet.empty(); };
    const Locks isLocked(painting.groups);
    return !selection.strokes.empty() && std::ranges::any_of(painting.strokes, [&](const StrokePtr &s) {
        if (!selection.strokes.contains(s->id) || isLocked(*s))
            return false;
        auto part = selection.segments.lower_bound({s->id, 0});
        const bool inPart = part != selection.segments.end() && part->stroke == s->id;
        for (; part != selection.segments.end() && part->stroke == s->id; ++part)
            if (isRewetted(s->segments[std::size_t(part->segment)]))
                return true;
        return !inPart && std::ranges::any_of(s->segments, isRewetted);
    });
}

PlaceInTime placeInTime(const Painting &painting, Microseconds born)
{
    const StrokeList &strokes = painting.strokes;
    PlaceInTime place;
    while (place.index < strokes.size() && strokes[place.index]->born() <= born)
        ++place.index;
    if (place.index == 0 || place.index == strokes.size())
        return place;
    // Between members of groups the stroke goes into the innermost group that both neighbours are in.
    const std::vector<GroupId> below = groupsAround(painting, strokes[place.index - 1]->group);
    for (const GroupId group : groupsAround(painting, strokes[place.index]->group)) {
        if (std::ranges::find(below, group) == below.end())
            continue;
        if (takesPaint(painting, group)) {
            place.group = group;
            return place;
        }
        const auto isMember = [&](const StrokePtr &s) {
            return std::ranges::count(groupsAround(painting, s->group), group) > 0;
        };
        while (place.index > 0 && isMember(strokes[place.index - 1]))
            --place.index;
    }
    return place;
}

Edit placedInTime(const Document &document, Edit edit)
{
    const Painting &painting = *document.painting();
    const std::vector<Added> all = addedTogether(painting, edit);
    if (all.empty())
        return edit;
    edit.order->resize(painting.strokes.size());
    std::vector<std::pair<PlaceInTime, const Added *>> places;
    for (const Added &added : all) {
        const PlaceInTime place = placeInTime(painting, added.born);
        places.emplace_back(place, &added);
        if (place.index == painting.strokes.size())
            continue;
        if (added.group) {
            std::ranges::find(*edit.groups, added.group, &Group::id)->parent = place.group;
            continue;
        }
        const StrokeId id = added.strokes.front();
        auto moved = std::make_shared<Stroke>(*edit.strokes.at(id));
        moved->group = place.group;
        edit.strokes[id] = std::move(moved);
    }
    // The last ones come first, so that the places of those before them stay right.
    std::ranges::stable_sort(places, {}, [](const auto &p) { return p.first.index; });
    for (auto it = places.rbegin(); it != places.rend(); ++it)
        edit.order->insert(edit.order->begin() + std::ptrdiff_t(it->first.index), it->second->strokes.begin(),
                           it->second->strokes.end());
    return edit;
}

} // namespace suffuse
