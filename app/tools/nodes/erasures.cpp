#include "app/tools/nodes/erasures.h"

#include "model/painting/editable.h"
#include "model/shaping/curves/chains.h"
#include "model/shaping/nodes/reshape.h"

#include <algorithm>
#include <array>
#include <span>
#include <tuple>

namespace suffuse {

namespace {

/// What takes paint away in one chain.
struct ErasurePart {
    StrokePtr stroke;
    std::vector<int> segments;
    std::vector<Microseconds> births; ///< in ascending order
    Point from, to;
    Point start, end; ///< the directions at its ends
    double length = 0;
    int copy = 0; ///< how many copies of it were there before, as in pasted strokes

    /// How fast the hand went, in units a microsecond; 0 where the births do not tell.
    double speed() const
    {
        return births.back() > births.front() ? length / double(births.back() - births.front()) : 0;
    }
};

/// Whether the hand may have gone from one part to a later one in one go, over ground without paint: straight on, as
/// fast as before or behind.
bool goesStraightOn(const ErasurePart &before, const ErasurePart &after)
{
    constexpr Microseconds longest = 3'000'000;
    constexpr double within = 0.7; // the cosine of 45°
    constexpr double factor = 4;
    const Point way = after.from - before.to;
    const double far = length(way);
    const Microseconds time = after.births.front() - before.births.back();
    const auto leads = [&](Point direction) {
        return direction.x * way.x + direction.y * way.y > within * far * length(direction);
    };
    if (!(far > 0) || time <= 0 || time > longest || !leads(before.end) || !leads(after.start))
        return false;
    const double speed = far / double(time);
    return std::ranges::all_of(std::array{before.speed(), after.speed()}, [speed](double known) {
        return known == 0 || (speed < factor * known && speed > known / factor);
    });
}

constexpr double touching = 0.01; // canvas units; strokes round places in different ways

/// Whether two parts lie at the same place. Births that are all the same do not tell which end came first.
bool lieAtOnePlace(const ErasurePart &a, const ErasurePart &b)
{
    const auto meet = [](Point p, Point q) { return length(p - q) < touching; };
    return (meet(a.from, b.from) && meet(a.to, b.to)) || (meet(a.from, b.to) && meet(a.to, b.from));
}

/// Whether one stroke is the other once more: where its paint was laid stroke by stroke of the hand, by its births, and
/// else by its curves, where these lie.
bool isPaintCopied(const Stroke &a, const Stroke &b)
{
    const auto paintOf = [](const Stroke &stroke) {
        std::vector<const Segment *> paint;
        for (const Segment &segment : stroke.segments)
            if (!segment.takesPaint())
                paint.push_back(&segment);
        return paint;
    };
    const std::vector<const Segment *> first = paintOf(a), second = paintOf(b);
    const auto born = [](const Segment *segment) { return segment->born; };
    if (!std::ranges::equal(first, second, {}, born, born))
        return false;
    const bool tellBirths =
        std::ranges::any_of(first, [&](const Segment *segment) { return segment->born != first.front()->born; });
    return tellBirths || (a.origin == b.origin && std::ranges::equal(first, second, [](const auto *x, const auto *y) {
                              return x->bezier == y->bezier;
                          }));
}

/// Whether a part is that of another stroke once more. One path of the hand has the same births in several strokes only
/// at the same place; but what has a single birth may be from farther along the line that the hand drew in that moment.
/// At one place it is a copy where the stroke is.
bool isCopy(const ErasurePart &a, const ErasurePart &b)
{
    if (a.stroke->id == b.stroke->id || a.births != b.births)
        return false;
    if (lieAtOnePlace(a, b))
        return isPaintCopied(*a.stroke, *b.stroke);
    constexpr double within = 0.95; // the cosine of 18°
    const Point way = b.from - a.from;
    const double along = std::abs(a.start.x * way.x + a.start.y * way.y);
    return a.births.front() != a.births.back() || !(along > within * length(way) * length(a.start));
}

/// Counts copies by the age of their strokes, so that those of strokes that were copied together have the same count.
/// The parts are in the order of their births.
void countCopies(std::span<ErasurePart> parts)
{
    std::vector<ErasurePart *> byAge;
    for (std::size_t begin = 0, end = 0; begin < parts.size(); begin = end) {
        byAge.clear();
        for (; end < parts.size() && parts[end].births.front() == parts[begin].births.front(); ++end)
            byAge.push_back(&parts[end]);
        std::ranges::stable_sort(byAge, {}, [](const ErasurePart *part) { return part->stroke->id; });
        for (std::size_t i = 1; i < byAge.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (isCopy(*byAge[j], *byAge[i]))
                    byAge[i]->copy = std::max(byAge[i]->copy, byAge[j]->copy + 1);
    }
}

/// The parts in visible, unlocked strokes with the same size and softness as a segment, in the order of their births.
std::vector<ErasurePart> partsLike(const Painting &painting, const Segment &sample)
{
    std::vector<ErasurePart> parts;
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        if (!stroke->hasErasure() || !isEditable(*stroke))
            continue;
        for (const Chain &chain : chainsOf(*stroke)) {
            ErasurePart part;
            part.stroke = stroke;
            for (int k = chain.first; k <= chain.last; ++k) {
                const Segment &segment = stroke->segments[std::size_t(k)];
                if (!segment.takesPaint() || segment.fade != sample.fade || segment.diffusion != sample.diffusion ||
                    segment.maxAge != sample.maxAge)
                    continue;
                const Cubic curve = stroke->cubicOf(segment);
                const Point way = curve.p[3] - curve.p[0];
                if (part.segments.empty()) {
                    part.from = curve.p[0];
                    part.start = way;
                }
                part.to = curve.p[3];
                part.end = way;
                part.length += length(way);
                part.segments.push_back(k);
                part.births.push_back(segment.born);
            }
            if (part.segments.empty())
                continue;
            if (part.births.front() > part.births.back()) { // The stroke was reversed, and the hand went the other way.
                std::swap(part.from, part.to);
                part.start = Point() - std::exchange(part.end, Point() - part.start);
            }
            std::ranges::sort(part.births);
            parts.push_back(std::move(part));
        }
    }
    std::ranges::stable_sort(parts, {}, [](const ErasurePart &part) { return part.births.front(); });
    countCopies(parts);
    return parts;
}

/// Whether one of the parts is a copy of another one.
bool areDoubled(std::span<const ErasurePart> parts)
{
    std::set<std::tuple<StrokeId, std::size_t, std::vector<Microseconds>>> seen;
    return std::ranges::any_of(parts, [&seen](const ErasurePart &part) {
        return !seen.emplace(part.stroke->id, part.segments.size(), part.births).second;
    });
}

} // namespace

std::set<SegmentRef> wholeErasureOf(const Painting &painting, const SegmentRef &segment)
{
    const std::set<SegmentRef> own = erasureOf(painting, segment);
    if (own.empty())
        return own;
    const Segment &sample = painting.find(segment.stroke)->segments[std::size_t(segment.segment)];
    const auto hasSegment = [&segment](const ErasurePart &part) {
        return part.stroke->id == segment.stroke && std::ranges::binary_search(part.segments, segment.segment);
    };
    std::vector<ErasurePart> parts = partsLike(painting, sample);
    const auto found = std::ranges::find_if(parts, hasSegment);
    if (found == parts.end())
        return own;
    std::erase_if(parts, [copy = found->copy](const ErasurePart &part) { return part.copy != copy; });
    std::size_t begin = 0, end = 0;
    bool isFound = false;
    Microseconds latest = 0;
    for (; end < parts.size(); ++end) {
        const ErasurePart &part = parts[end];
        const bool goesOn =
            end > begin && (part.births.front() < latest + toMicroseconds(double(sample.maxAge)) ||
                            length(part.from - parts[end - 1].to) < touching || goesStraightOn(parts[end - 1], part));
        if (!goesOn) {
            if (isFound)
                break;
            begin = end;
            latest = part.births.front();
        }
        latest = std::max(latest, part.births.back());
        isFound = isFound || hasSegment(part);
    }
    const std::span<const ErasurePart> whole = std::span(parts).subspan(begin, end - begin);
    if (areDoubled(whole))
        return own;
    std::set<SegmentRef> segments = own;
    for (const ErasurePart &part : whole)
        for (const int k : part.segments)
            segments.insert({part.stroke->id, k});
    return segments;
}

std::set<SegmentRef> erasureOf(const Painting &painting, const SegmentRef &segment)
{
    std::set<SegmentRef> segments;
    const StrokePtr stroke = painting.find(segment.stroke);
    if (!stroke || segment.segment >= int(stroke->segments.size()) ||
        !stroke->segments[std::size_t(segment.segment)].takesPaint())
        return segments;
    const Chain chain = chainAt(*stroke, segment.segment);
    for (int k = chain.first; k <= chain.last; ++k)
        if (stroke->segments[std::size_t(k)].takesPaint())
            segments.insert(segments.end(), SegmentRef{stroke->id, k});
    return segments;
}

bool isWholeErasure(const Painting &painting, const std::set<SegmentRef> &selected, const SegmentRef &segment)
{
    return selected == wholeErasureOf(painting, segment) && selected != erasureOf(painting, segment);
}

std::optional<Selection> withErasure(const Painting &painting, const Selection &selected, const SegmentRef &hit,
                                     bool add)
{
    std::set<SegmentRef> erasure = wholeErasureOf(painting, hit);
    if (!add && selected.segments == erasure && !erasure.empty())
        erasure = erasureOf(painting, hit);
    const bool isChosen = selected.segments == erasure;
    if (erasure.empty() || (!add && isChosen))
        return std::nullopt;
    Selection chosen = add ? selected : Selection();
    for (const SegmentRef &ref : erasure)
        chosen.strokes.insert(ref.stroke);
    chosen.segments.merge(erasure);
    return chosen;
}

std::optional<ErasurePlace> erasureAt(const Painting &painting, Point point, double reach,
                                      const std::set<StrokeId> *only)
{
    std::optional<ErasurePlace> found;
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        if (!stroke->hasErasure() || (only && !only->contains(stroke->id)) || !isEditable(*stroke))
            continue;
        for (std::size_t k = 0; k < stroke->segments.size(); ++k) {
            const Segment &segment = stroke->segments[k];
            if (!segment.takesPaint() || !stroke->cubicOf(segment).controlBox().grown(reach).contains(point))
                continue;
            Stroke one;
            one.origin = stroke->origin;
            one.segments = {segment};
            double distance = 0;
            const CurvePlace place = nearestPlace(one, point, &distance);
            if (distance > reach)
                continue;
            reach = distance;
            found = {stroke->id, int(k), place.p};
        }
    }
    return found;
}

std::set<NodeRef> nodesOfErasureAt(const Painting &painting, const NodeRef &node)
{
    const StrokePtr stroke = painting.find(node.stroke);
    if (!stroke)
        return {};
    const NodeSides sides = sidesOf(*stroke, node.node);
    const int segment = std::max(sides.after, sides.before);
    return segment < 0 ? std::set<NodeRef>() : nodesOfErasures(painting, erasureOf(painting, {node.stroke, segment}));
}

std::set<NodeRef> nodesOfErasures(const Painting &painting, const std::set<SegmentRef> &segments)
{
    std::set<NodeRef> nodes;
    StrokePtr stroke;
    for (const SegmentRef &ref : segments) {
        if (!stroke || stroke->id != ref.stroke)
            stroke = painting.find(ref.stroke);
        if (!stroke || ref.segment >= int(stroke->segments.size()) ||
            !stroke->segments[std::size_t(ref.segment)].takesPaint())
            continue;
        nodes.insert({ref.stroke, ref.segment});
        nodes.insert({ref.stroke, endNode(*stroke, ref.segment)});
    }
    return nodes;
}

} // namespace suffuse
