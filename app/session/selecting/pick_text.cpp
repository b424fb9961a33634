#include "app/session/selecting/pick_text.h"

#include "app/session/selecting/pick.h"
#include "undo/text_edits.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace suffuse {

namespace {

using Corners = std::array<Point, 4>;

/// 0 within a convex quadrilateral.
double distanceTo(const Corners &corners, Point p)
{
    double least = std::numeric_limits<double>::infinity();
    int left = 0, right = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point from = corners[i], way = corners[(i + 1) % corners.size()] - from;
        const double side = cross(way, p - from), square = dot(way, way);
        left += side >= 0;
        right += side <= 0;
        const double t = square > 0 ? std::clamp(dot(p - from, way) / square, 0.0, 1.0) : 0;
        least = std::min(least, length(p - (from + t * way)));
    }
    return left == 4 || right == 4 ? 0 : least;
}

/// What the lines of a text take up on the canvas; on a curve what its letters do.
std::vector<Corners> areasOf(const LaidText &laid, const Text &text)
{
    std::vector<Corners> areas;
    if (text.curve.empty())
        for (const LaidLine &line : laid.lines)
            areas.push_back({line.start[0], line.end[0], line.end[1], line.start[1]});
    else
        for (const LaidCluster &cluster : laid.clusters)
            areas.push_back(cluster.corners());
    for (Corners &corners : areas)
        for (Point &corner : corners)
            corner = text.place(corner);
    return areas;
}

/// The letter that is nearest to a point; 0 if there is none that can be selected.
StrokeId letterAt(const Painting &painting, Microseconds T, GroupId group, const LaidText &laid, const Text &text,
                  Point point)
{
    const std::vector<StrokeId> letters = lettersOf(painting, group, laid);
    StrokeId nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    std::size_t k = 0;
    const Selectable isSelectable(painting, T);
    for (const LaidCluster &cluster : laid.clusters) {
        if (!cluster.hasInk())
            continue;
        const StrokePtr letter = k < letters.size() && letters[k] ? painting.find(letters[k]) : nullptr;
        ++k;
        if (!letter || !isSelectable(*letter))
            continue;
        Corners corners = cluster.corners();
        for (Point &corner : corners)
            corner = text.place(corner);
        if (const double d = distanceTo(corners, point); d < least) {
            least = d;
            nearest = letter->id;
        }
    }
    return nearest;
}

/// The em of a text, canvas units.
double emOf(const Text &text)
{
    return text.size * std::sqrt(std::abs(text.place.determinant()));
}

struct Candidate {
    GroupId group = 0;
    SharedText text;
    Rect curves; ///< of its letters
};

/// The small texts of which a letter can be selected, from top to bottom.
std::vector<Candidate> smallTexts(const Painting &painting, Microseconds T, double mostEm)
{
    std::vector<Candidate> found;
    if (std::ranges::none_of(painting.groups, [](const Group &group) { return bool(group.text); }))
        return found;
    std::unordered_map<GroupId, GroupId> texts; // around each group
    std::unordered_map<GroupId, std::size_t> places;
    const Selectable isSelectable(painting, T);
    for (auto at = painting.strokes.rbegin(); at != painting.strokes.rend(); ++at) {
        const Stroke &stroke = **at;
        if (stroke.group == 0 || !isSelectable(stroke))
            continue;
        const auto [around, isNew] = texts.try_emplace(stroke.group, 0);
        if (isNew)
            around->second = textAround(painting, stroke);
        const GroupId group = around->second;
        if (group == 0)
            continue;
        const auto [place, isFirst] = places.try_emplace(group, found.size());
        if (isFirst)
            found.push_back({group, textOf(painting, group), {}});
        Candidate &candidate = found[place->second];
        if (emOf(*candidate.text) >= mostEm)
            continue;
        for (const Segment &segment : stroke.segments)
            candidate.curves = candidate.curves.united(stroke.cubicOf(segment).controlBox());
    }
    std::erase_if(found, [mostEm](const Candidate &candidate) { return emOf(*candidate.text) >= mostEm; });
    return found;
}

} // namespace

std::optional<SegmentRef> pickSmallText(const Painting &painting, Microseconds T, const View &view, double mostEm,
                                        Point point, double tolerance, TextLayout &layout)
{
    for (const Candidate &candidate : smallTexts(painting, T, mostEm / view.scale)) {
        const Text &text = *candidate.text;
        if (!candidate.curves.grown(tolerance + 2 * emOf(text)).contains(point))
            continue;
        const LaidText laid = layout.lay(text);
        const std::vector<Corners> areas = areasOf(laid, text);
        if (std::ranges::none_of(areas, [&](const Corners &area) { return distanceTo(area, point) <= tolerance; }))
            continue;
        if (const StrokeId letter = letterAt(painting, T, candidate.group, laid, text, point))
            return SegmentRef{letter, 0};
    }
    return {};
}

} // namespace suffuse
