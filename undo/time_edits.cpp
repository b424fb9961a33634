#include "undo/time_edits.h"

#include "model/brush/stroke_fit.h"
#include "model/painting/validate.h"
#include "undo/order_tree.h"

#include <limits>
#include <numbers>
#include <span>

namespace suffuse {

namespace {

constexpr Microseconds latest = std::numeric_limits<Microseconds>::max() / 4;

/// Knows which segments of a stroke a selection means: all, or those in [first, last).
class Selected {
public:
    Selected(const Selection &selection, StrokeId stroke)
        : m_selection(selection), m_stroke(stroke), m_there(selection.strokes.contains(stroke))
    {
        const auto first = selection.segments.lower_bound({stroke, 0});
        m_all = first == selection.segments.end() || first->stroke != stroke;
    }
    bool any() const { return m_there; }
    bool contains(std::size_t segment) const
    {
        return m_there && (m_all || m_selection.segments.contains({m_stroke, int(segment)}));
    }

private:
    const Selection &m_selection;
    StrokeId m_stroke;
    bool m_there;
    bool m_all;
};

/// Calls visit(segment) for each segment that is selected and not locked.
template <typename Visit>
void forEachSelected(const Painting &painting, const Selection &selection, Visit visit)
{
    for (const StrokePtr &stroke : painting.strokes) {
        const Selected selected(selection, stroke->id);
        if (!selected.any() || painting.isLocked(*stroke))
            continue;
        for (std::size_t k = 0; k < stroke->segments.size(); ++k)
            if (selected.contains(k))
                visit(stroke->segments[k]);
    }
}

void shift(Segment &segment, const TimeMap &map)
{
    segment.born = map(segment.born);
    for (Rewet &r : segment.rewet)
        r.time = map(r.time);
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

/// Sets the births of the segments from … to (inclusive) between those of the first and the last.
void paceRun(Stroke &stroke, std::size_t from, std::size_t to, Pace pace)
{
    std::vector<double> ways{0}; // from the start of the first segment to that of each
    for (std::size_t k = from; k < to; ++k)
        ways.push_back(ways.back() + arcLength(stroke.cubicOf(stroke.segments[k])));
    const Microseconds begin = stroke.segments[from].born, end = stroke.segments[to].born;
    if (!(ways.back() > 0))
        return;
    for (std::size_t k = from + 1; k < to; ++k) {
        const double share = timeAt(pace, std::clamp(ways[k - from] / ways.back(), 0.0, 1.0));
        const Microseconds born = begin + Microseconds(std::llround(double(end - begin) * share));
        shift(stroke.segments[k], {.by = born - stroke.segments[k].born});
    }
}

/// The share of the time that has passed after easing, for a share before it: a cubic with the ease's slopes at its
/// ends.
double eased(const Ease &ease, double share)
{
    const double left = 1 - share;
    return share * (ease.atBegin * left * left + share * (3 - 2 * share) - ease.atEnd * share * left);
}

void easeRun(Stroke &stroke, std::size_t from, std::size_t to, const Ease &ease)
{
    const std::span<Segment> run(stroke.segments.begin() + std::ptrdiff_t(from), to - from + 1);
    const auto [first, last] = std::ranges::minmax(run, {}, &Segment::born);
    const Microseconds begin = first.born, length = last.born - begin;
    for (Segment &segment : run) {
        const Microseconds since = segment.born - begin;
        if (since > 0 && since < length)
            shift(segment,
                  {.by = Microseconds(std::llround(double(length) * eased(ease, double(since) / double(length)))) -
                         since});
    }
}

/// Calls visit(first, last) for each run of selected segments.
template <typename Visit>
void forEachRun(const Stroke &stroke, const Selected &selected, Visit visit)
{
    const std::size_t count = stroke.segments.size();
    for (std::size_t from = 0; from < count;) {
        std::size_t behind = from;
        while (behind < count && selected.contains(behind))
            ++behind;
        if (behind > from)
            visit(from, behind - 1);
        from = behind + 1;
    }
}

/// The selected strokes of `before`, changed. A stroke that does not change is put back as it was, so that a drag that
/// comes back leaves no trace.
template <typename Apply>
Edit changedSince(const Painting &before, const Selection &selection, Apply apply)
{
    Edit edit;
    for (const StrokePtr &stroke : before.strokes) {
        const Selected selected(selection, stroke->id);
        if (!selected.any() || before.isLocked(*stroke))
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

/// If an edit does nothing but add strokes on top of all others, the strokes that it adds; otherwise none. The parts of
/// strokes that are cut stay where the strokes are.
std::vector<StrokeId> addedOnTop(const Painting &painting, const Edit &edit)
{
    if (!edit.order || edit.order->size() <= painting.strokes.size() ||
        edit.order->size() - painting.strokes.size() != edit.strokes.size())
        return {};
    for (std::size_t i = 0; i < painting.strokes.size(); ++i)
        if ((*edit.order)[i] != painting.strokes[i]->id)
            return {};
    return {edit.order->begin() + std::ptrdiff_t(painting.strokes.size()), edit.order->end()};
}

} // namespace

TimeSpan drawnSpan(const Painting &painting, const Selection &selection)
{
    TimeSpan span{latest, -latest};
    forEachSelected(painting, selection, [&span](const Segment &s) {
        span.begin = std::min(span.begin, s.born);
        span.end = std::max(span.end, s.born);
    });
    return span;
}

Edit retime(const Painting &before, const Selection &selection, const TimeMap &map)
{
    const TimeSpan span = drawnSpan(before, selection);
    if (span.end < span.begin)
        return {};
    TimeMap kept = map; // Nothing begins before time 0 that did not do so before.
    kept.by += std::max<Microseconds>(0, std::min<Microseconds>(0, span.begin) - map(span.begin));
    return changedSince(before, selection, [&kept](Stroke &stroke, const Selected &selected) {
        for (std::size_t k = 0; k < stroke.segments.size(); ++k)
            if (selected.contains(k))
                shift(stroke.segments[k], kept);
    });
}

Edit beginAt(const Painting &before, const Selection &selection, const BeginMap &map)
{
    bool possible = true;
    Edit edit = changedSince(before, selection, [&](Stroke &stroke, const Selected &selected) {
        Microseconds first = latest;
        for (std::size_t k = 0; k < stroke.segments.size(); ++k)
            if (selected.contains(k))
                first = std::min(first, stroke.segments[k].born);
        const std::optional<Microseconds> begin = map(first);
        possible = possible && begin;
        for (std::size_t k = 0; k < stroke.segments.size() && begin; ++k)
            if (selected.contains(k))
                shift(stroke.segments[k], {.by = *begin - first});
    });
    return possible ? edit : Edit();
}

Edit stretch(const Painting &before, const Selection &selection, TimeSpan span)
{
    const TimeSpan drawn = drawnSpan(before, selection);
    span.begin = std::max(span.begin, std::min<Microseconds>(0, drawn.begin));
    span.end = std::max(span.end, span.begin);
    if (drawn.begin < drawn.end) {
        const double factor = double(span.end - span.begin) / double(drawn.end - drawn.begin);
        return retime(before, selection, {drawn.begin, factor, span.begin - drawn.begin});
    }
    return changedSince(before, selection, [&](Stroke &stroke, const Selected &selected) {
        forEachRun(stroke, selected, [&](std::size_t from, std::size_t to) {
            shift(stroke.segments[from], {.by = span.begin - stroke.segments[from].born});
            if (to > from) {
                shift(stroke.segments[to], {.by = span.end - stroke.segments[to].born});
                paceRun(stroke, from, to, Pace::Even);
            }
        });
    });
}

Edit setPace(const Document &document, Pace pace)
{
    const Selection &selection = document.selection();
    return changeStrokes(document, selection.strokes, [&](Stroke &stroke) {
        forEachRun(stroke, Selected(selection, stroke.id),
                   [&](std::size_t from, std::size_t to) { paceRun(stroke, from, to, pace); });
    });
}

Edit ease(const Painting &before, const Selection &selection, const Ease &ease)
{
    const auto allowed = [](double slower) { return std::clamp(slower, 1 / Ease::most, Ease::most); };
    const Ease kept{allowed(ease.atBegin), allowed(ease.atEnd)};
    return changedSince(before, selection, [&kept](Stroke &stroke, const Selected &selected) {
        if (kept.atBegin != 1 || kept.atEnd != 1)
            forEachRun(stroke, selected, [&](std::size_t from, std::size_t to) { easeRun(stroke, from, to, kept); });
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
    });
}

Edit rewet(const Document &document, Microseconds T, Microseconds extra)
{
    if (extra <= 0)
        return {};
    return changeSegments(document, targetSegments(document), [&](Segment &segment) {
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
    return !selection.strokes.empty() && std::ranges::any_of(painting.strokes, [&](const StrokePtr &s) {
        if (!selection.strokes.contains(s->id) || painting.isLocked(*s))
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
    const std::vector<StrokeId> added = addedOnTop(painting, edit);
    if (added.empty() || edit.groups)
        return edit;
    edit.order->resize(painting.strokes.size());
    // The last one comes first, so that the places of those before it stay right.
    std::vector<std::pair<PlaceInTime, StrokeId>> places;
    for (const StrokeId id : added) {
        const PlaceInTime place = placeInTime(painting, edit.strokes.at(id)->born());
        places.emplace_back(place, id);
        if (place.index < painting.strokes.size()) {
            auto moved = std::make_shared<Stroke>(*edit.strokes.at(id));
            moved->group = place.group;
            edit.strokes[id] = std::move(moved);
        }
    }
    std::ranges::stable_sort(places, {}, [](const auto &p) { return p.first.index; });
    for (auto it = places.rbegin(); it != places.rend(); ++it)
        edit.order->insert(edit.order->begin() + std::ptrdiff_t(it->first.index), it->second);
    return edit;
}

} // namespace suffuse
