#include "model/colour/colour_uses.h"

#include "model/area/area_sets.h"
#include "model/area/outline.h"
#include "model/colour/colour_shift.h"
#include "model/colour/one_colour.h"
#include "model/colour/perceived.h"
#include "model/paint/derived_figures.h"
#include "model/paint/style_function.h"
#include "model/painting/editable.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <tuple>

namespace suffuse {

namespace {

constexpr double firstReach = 0.02; ///< about what is seen as another colour, side by side
constexpr double reachGrowth = 1.5;

/// Orders colours, so that each is found once. Nothing else is meant by the order.
struct ByChannels {
    bool operator()(const Colour &a, const Colour &b) const
    {
        return std::tie(a.red, a.yellow, a.blue, a.opacity) < std::tie(b.red, b.yellow, b.blue, b.opacity);
    }
};

/// One colour exactly, and where it is.
struct ExactUse {
    Colour colour;
    Perceived perceived;
    std::size_t segments = 0;
    std::set<StrokeId> strokes;
    double paint = 0;
};

/// What is covered by a fill of opaque colour, square units: its area, as densely as it is seen deep within it.
double coveredByFill(const Stroke &stroke)
{
    const Fill &fill = *stroke.fill;
    return densityFunction(stroke.style, double(fill.density)) * sizeOf(areaOf(closedOutline(stroke), fill.rule));
}

/// The same of a segment, by its length and the width at which it is seen. One without an edge is as wide as it has
/// spread, and as faint as its middle. More density than covers everything counts no more.
double coveredBySegment(const Stroke &stroke, const Segment &segment)
{
    const Style &style = stroke.styleOf(segment);
    const DerivedFigures figures = derivedFigures(segment, style);
    const bool hasEdge = figures.halfWidth > 0;
    const double width = hasEdge ? 2 * figures.halfWidth : figures.spread;
    const double area = width * polygonLength(stroke.cubicOf(segment));
    return hasEdge ? area : area * densityFunction(style, figures.peak);
}

void addFill(std::map<Colour, ExactUse, ByChannels> &found, const ColourPart &part)
{
    const Fill &fill = *part.stroke->fill;
    const double paint = (fill.gradient ? 0.5 : 1.0) * coveredByFill(*part.stroke);
    const auto add = [&](const Colour &colour) {
        ExactUse &use = found[withOpacity(colour, 1)];
        use.strokes.insert(part.stroke->id);
        use.paint += paint * double(colour.opacity);
    };
    if (part.fill)
        add(fill.colour);
    if (part.gradient)
        add(fill.gradient->colour);
}

std::vector<ExactUse> exactUses(const ColourParts &parts)
{
    std::map<Colour, ExactUse, ByChannels> found;
    for (const ColourPart &part : parts) {
        const Stroke &stroke = *part.stroke;
        if (part.fill || part.gradient)
            addFill(found, part);
        for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
            const Segment &segment = stroke.segments[k];
            if (!part.has(k) || segment.takesPaint() || onlyBounds(stroke, k))
                continue;
            ExactUse &use = found[withOpacity(segment.colour, 1)];
            ++use.segments;
            use.strokes.insert(stroke.id);
            use.paint += coveredBySegment(stroke, segment) * double(segment.colour.opacity);
        }
    }
    std::vector<ExactUse> uses;
    for (auto &[colour, use] : found) {
        use.colour = colour;
        use.perceived = perceivedOf(colour);
        uses.push_back(std::move(use));
    }
    std::ranges::stable_sort(uses, std::greater(), &ExactUse::paint);
    return uses;
}

/// Each colour goes to the first one before it that it looks like, and begins a group where there is none. Returns for
/// each the index of the colour that its group begins with. Nothing where there would be more than `most` groups.
std::vector<std::size_t> grouped(const std::vector<ExactUse> &uses, double reach, std::size_t most)
{
    std::vector<std::size_t> leaders, leaderOf;
    for (std::size_t i = 0; i < uses.size(); ++i) {
        const auto near = std::ranges::find_if(leaders, [&](std::size_t leader) {
            return distanceOf(uses[i].perceived, uses[leader].perceived) <= reach;
        });
        if (near == leaders.end() && leaders.size() == most)
            return {};
        leaderOf.push_back(near == leaders.end() ? i : *near);
        if (near == leaders.end())
            leaders.push_back(i);
    }
    return leaderOf;
}

std::vector<std::size_t> groupedInto(const std::vector<ExactUse> &uses, std::size_t most)
{
    std::vector<std::size_t> leaderOf = grouped(uses, 0, most);
    for (double reach = firstReach; leaderOf.size() < uses.size(); reach *= reachGrowth)
        leaderOf = grouped(uses, reach, most);
    return leaderOf;
}

/// What takes paint away has no colour that could be seen.
void leaveErasuresOut(ColourPart &part)
{
    const std::vector<Segment> &segments = part.stroke->segments;
    if (!part.stroke->hasErasure())
        return;
    if (part.chosen.empty())
        part.chosen.assign(segments.size(), true);
    for (std::size_t k = 0; k < segments.size(); ++k)
        part.chosen[k] = part.chosen[k] && !segments[k].takesPaint();
}

/// Whether what is chosen of a stroke means its fill, too: all of it, or nothing that lays paint.
bool meansFill(const ColourPart &part)
{
    const Stroke &stroke = *part.stroke;
    if (!stroke.fill)
        return false;
    bool all = true, lays = false;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        all = all && (part.has(k) || stroke.segments[k].takesPaint());
        lays = lays || (part.has(k) && !onlyBounds(stroke, k));
    }
    return all || !lays;
}

} // namespace

Colour shownColourOf(const Stroke &stroke)
{
    if (!isFillAlone(stroke)) {
        std::vector<const Segment *> paint;
        for (const Segment &segment : stroke.segments)
            if (!segment.takesPaint())
                paint.push_back(&segment);
        return paint.empty() ? stroke.segments.front().colour : paint[paint.size() / 2]->colour;
    }
    const Fill &fill = *stroke.fill;
    return fill.gradient && fill.gradient->colour.opacity > fill.colour.opacity ? fill.gradient->colour : fill.colour;
}

std::size_t ColourPart::count() const
{
    return chosen.empty() ? stroke->segments.size() : std::size_t(std::ranges::count(chosen, true));
}

ColourParts partsToColour(const Painting &painting, const Selection &selection)
{
    ColourParts parts;
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        const bool meant = selection.isEmpty() || selection.strokes.contains(stroke->id);
        if (!meant || !isEditable(*stroke))
            continue;
        ColourPart part{stroke, {}};
        const auto first = selection.segments.lower_bound({stroke->id, 0});
        for (auto at = first; at != selection.segments.end() && at->stroke == stroke->id; ++at) {
            part.chosen.resize(stroke->segments.size());
            if (std::size_t(at->segment) < part.chosen.size())
                part.chosen[std::size_t(at->segment)] = true;
        }
        leaveErasuresOut(part);
        if (part.count() == 0)
            continue;
        part.fill = meansFill(part);
        part.gradient = part.fill && stroke->fill->gradient;
        parts.push_back(std::move(part));
    }
    return parts;
}

ColourParts partsOfColour(const Painting &painting, const Colour &colour)
{
    ColourParts parts;
    for (const StrokePtr &stroke : painting.strokes) {
        ColourPart part{stroke, std::vector<bool>(stroke->segments.size())};
        bool isSeen = false; // What only bounds a fill goes along with others.
        for (std::size_t k = 0; k < part.chosen.size(); ++k) {
            part.chosen[k] = !stroke->segments[k].takesPaint() && samePaint(stroke->segments[k].colour, colour);
            isSeen = isSeen || (part.chosen[k] && !onlyBounds(*stroke, k));
        }
        if (const SharedFill &fill = stroke->fill) {
            part.fill = samePaint(fill->colour, colour);
            part.gradient = fill->gradient && samePaint(fill->gradient->colour, colour);
        }
        if (isSeen || part.fill || part.gradient)
            parts.push_back(std::move(part));
    }
    return parts;
}

std::vector<ColourUse> coloursOf(const ColourParts &parts, std::size_t most)
{
    const std::vector<ExactUse> exact = exactUses(parts);
    const std::vector<std::size_t> leaderOf = groupedInto(exact, std::max<std::size_t>(most, 1));
    double all = 0;
    std::vector<ColourUse> uses;
    std::map<std::size_t, std::size_t> placeOf; // of a leader's group
    std::vector<std::set<StrokeId>> strokes;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const auto [place, isNew] = placeOf.emplace(leaderOf[i], uses.size());
        if (isNew) {
            uses.push_back({.colour = exact[i].colour, .members = {}});
            strokes.emplace_back();
        }
        ColourUse &use = uses[place->second];
        use.members.push_back(exact[i].colour);
        use.segments += exact[i].segments;
        use.paint += exact[i].paint;
        all += exact[i].paint;
        strokes[place->second].insert(exact[i].strokes.begin(), exact[i].strokes.end());
    }
    for (std::size_t i = 0; i < uses.size(); ++i) {
        uses[i].strokes = strokes[i].size();
        uses[i].paint = all > 0 ? uses[i].paint / all : 0;
    }
    std::ranges::stable_sort(uses, std::greater(), &ColourUse::paint);
    return uses;
}

ColourSummary summaryOf(const ColourParts &parts, bool coloured)
{
    struct Count {
        Colour colour;
        std::size_t segments = 0, first = 0;
    };
    std::vector<Count> counts;
    ColourSummary summary;
    std::size_t seen = 0, bounding = 0;
    const auto add = [&](const Colour &colour, std::size_t times) {
        if (counts.empty() || counts.back().colour != colour) // Neighbours mostly have one colour.
            counts.push_back({colour, 0, seen});
        counts.back().segments += times;
        seen += times;
    };
    for (const ColourPart &part : parts) {
        const std::vector<Segment> &segments = part.stroke->segments;
        for (std::size_t k = 0; k < segments.size(); ++k) {
            if (!part.has(k))
                continue;
            if (onlyBounds(*part.stroke, k)) {
                ++bounding;
                continue;
            }
            add(segments[k].colour, 1);
            ++summary.segments;
        }
        if (part.fill)
            add(part.stroke->fill->colour, segments.size());
        if (part.gradient)
            add(part.stroke->fill->gradient->colour, segments.size());
    }
    summary.onlyFills = summary.segments == 0;
    if (summary.onlyFills)
        summary.segments = bounding;
    // Those of one colour become one: a table of many colours would take longer.
    std::ranges::stable_sort(counts, ByChannels(), &Count::colour);
    std::size_t kept = 0;
    for (const Count &count : counts) {
        if (kept > 0 && counts[kept - 1].colour == count.colour)
            counts[kept - 1].segments += count.segments;
        else
            counts[kept++] = count;
    }
    counts.resize(kept);
    const auto rank = [coloured](const Count &count) {
        return std::tuple(!(coloured && isGrey(count.colour)), count.segments, std::size_t(-1) - count.first);
    };
    summary.strokes = parts.size();
    const Colour usual = summary.usual = std::ranges::max_element(counts, {}, rank)->colour;
    std::size_t most = 0;
    for (const auto &[colour, segments, first] : counts) {
        const std::array<bool, 4> differ{colour.red != usual.red, colour.yellow != usual.yellow,
                                         colour.blue != usual.blue, colour.opacity != usual.opacity};
        for (std::size_t i = 0; i < differ.size(); ++i)
            summary.differ[i] = summary.differ[i] || differ[i];
        if (samePaint(colour, usual) || segments <= most)
            continue;
        most = segments;
        summary.other = colour;
    }
    summary.several = !looksLikeOne(parts, usual);
    if (!summary.several)
        summary.other.reset();
    return summary;
}

} // namespace suffuse
