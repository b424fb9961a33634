#include "app/session/selecting/pick.h"

#include "model/painting/influence.h"
#include "render/pixel_map.h"
#include "undo/history/order_tree.h"

#include <numbers>
#include <unordered_map>

namespace suffuse {

namespace {

/// The segment with the largest share where the stroke is seen at the point.
std::optional<SegmentRef> hitOf(const Stroke &stroke, Microseconds T, Point point)
{
    const SeenPaint seen = seenPaint(stroke, T, point);
    if (seen.opacity < visibleOpacity)
        return {};
    return SegmentRef{stroke.id, seen.segment};
}

std::array<Point, 8> ringAround(Point point, double radius)
{
    std::array<Point, 8> ring;
    for (int k = 0; k < 8; ++k) {
        const double angle = k * std::numbers::pi / 4;
        ring[std::size_t(k)] = point + radius * Point{std::cos(angle), std::sin(angle)};
    }
    return ring;
}

bool isNear(const Stroke &stroke, Microseconds T, Point point, double tolerance)
{
    const Point at = point - stroke.origin;
    if (influenceOfFill(stroke, T).grown(tolerance).contains(point))
        return true;
    return std::any_of(stroke.segments.begin(), stroke.segments.end(), [&](const Segment &segment) {
        // This computes the same as influenceOf. Most segments are far away, so their distances are compared first, and
        // no roots are taken.
        const auto &p = segment.bezier;
        const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x, p[3].x});
        const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y, p[3].y});
        const double away = std::max({left - at.x, at.x - right, top - at.y, at.y - bottom, tolerance}) - tolerance;
        const double reach = reachInSpreads * reachInSpreads * std::max(1.0f, segment.anisotropyRatio) * 4 *
                             double(segment.diffusion) * segment.age(T);
        return reach > 0 && away * away <= reach;
    });
}

/// The selectable strokes around the point, from top to bottom.
std::vector<StrokePtr> strokesNear(const Painting &painting, Microseconds T, Point point, double tolerance)
{
    std::vector<StrokePtr> near;
    const Selectable isSelectable(painting, T);
    for (auto it = painting.strokes.rbegin(); it != painting.strokes.rend(); ++it)
        if (isNear(**it, T, point, tolerance) && isSelectable(**it))
            near.push_back(*it);
    return near;
}

/// The first stroke that is seen at the point, else the first that is seen around it.
std::optional<SegmentRef> pickFrom(const std::vector<StrokePtr> &strokes, Microseconds T, Point point, double tolerance)
{
    for (const StrokePtr &stroke : strokes)
        if (const auto hit = hitOf(*stroke, T, point))
            return hit;
    for (const StrokePtr &stroke : strokes)
        for (const Point &beside : ringAround(point, tolerance))
            if (const auto hit = hitOf(*stroke, T, beside))
                return hit;
    return {};
}

/// Whether a point lies where a stroke fades away: it is faint there, and far less than along its curve.
bool isHalo(const Stroke &stroke, Microseconds T, const SeenPaint &seen)
{
    constexpr double faint = 0.2, lessThanCurve = 0.5;
    if (seen.opacity >= faint || seen.segment < 0)
        return false;
    const Point onCurve = stroke.cubicOf(stroke.segments[std::size_t(seen.segment)]).at(0.5);
    return seen.opacity < lessThanCurve * seenPaint(stroke, T, onCurve).opacity;
}

template <typename IsInside>
std::set<StrokeId> strokesWhollyIn(const Painting &painting, Microseconds T, IsInside isInside)
{
    const auto isWithin = [&](const Stroke &stroke) {
        for (const Segment &segment : stroke.segments) {
            const Cubic cubic = stroke.cubicOf(segment);
            for (int k = 0; k <= 4; ++k)
                if (!isInside(cubic.at(k / 4.0)))
                    return false;
        }
        return true;
    };
    std::set<StrokeId> ids;
    const Selectable isSelectable(painting, T);
    for (const StrokePtr &stroke : painting.strokes)
        if (isSelectable(*stroke) && isWithin(*stroke))
            ids.insert(ids.end(), stroke->id);
    return ids;
}

bool isInPolygon(const std::vector<Point> &polygon, Point p)
{
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Point a = polygon[i], b = polygon[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

Rect boxOf(const std::vector<Point> &points)
{
    Rect box;
    for (const Point &p : points)
        box.include(p);
    return box;
}

/// Points along a path, at most `step` apart.
std::vector<Point> resampled(const std::vector<Point> &path, double step)
{
    constexpr double maxPieces = 4096; // pieces of the way of one report
    std::vector<Point> points;
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (i > 0) {
            const Point d = path[i] - path[i - 1];
            const int pieces = int(std::min(std::ceil(length(d) / step), maxPieces));
            for (int k = 1; k < pieces; ++k)
                points.push_back(path[i - 1] + (double(k) / pieces) * d);
        }
        points.push_back(path[i]);
    }
    return points;
}

/// Whether a stroke's visible paint may be narrower than the distance between the points of a path.
bool isHairline(const Stroke &stroke, Microseconds T, double step)
{
    return std::any_of(stroke.segments.begin(), stroke.segments.end(),
                       [&](const Segment &segment) { return segment.spread(T) < 2 * step; });
}

} // namespace

std::optional<SegmentRef> pickTopmost(const Painting &painting, Microseconds T, Point point, double tolerance)
{
    return pickFrom(strokesNear(painting, T, point, tolerance), T, point, tolerance);
}

std::optional<SegmentRef> pickSeen(const Painting &painting, Microseconds T, Point point, double tolerance)
{
    const std::vector<StrokePtr> near = strokesNear(painting, T, point, tolerance);
    std::optional<SegmentRef> halo;
    double most = 0, through = 1;
    for (const StrokePtr &stroke : near) {
        const SeenPaint seen = seenPaint(*stroke, T, point);
        if (seen.opacity < visibleOpacity)
            continue;
        const double share = through * seen.opacity;
        through -= share;
        if (share <= most)
            continue;
        const SegmentRef hit{stroke->id, seen.segment};
        if (!isHalo(*stroke, T, seen))
            return hit;
        halo = hit;
        most = share;
    }
    return halo ? halo : pickFrom(near, T, point, tolerance);
}

std::optional<SegmentRef> pickOn(const Painting &painting, StrokeId id, Microseconds T, Point point, double tolerance)
{
    const StrokePtr stroke = painting.find(id);
    if (!stroke || !Selectable(painting, T)(*stroke) || !isNear(*stroke, T, point, tolerance))
        return {};
    return pickFrom({stroke}, T, point, tolerance);
}

std::vector<SegmentRef> pickAll(const Painting &painting, Microseconds T, Point point, double tolerance)
{
    const std::vector<StrokePtr> near = strokesNear(painting, T, point, tolerance);
    std::vector<SegmentRef> hits;
    for (const StrokePtr &stroke : near)
        if (const auto hit = hitOf(*stroke, T, point))
            hits.push_back(*hit);
    if (!hits.empty())
        return hits;
    for (const StrokePtr &stroke : near)
        if (const auto hit = pickFrom({stroke}, T, point, tolerance))
            hits.push_back(*hit);
    return hits;
}

std::set<StrokeId> withGroup(const Painting &painting, StrokeId id, GroupId outer)
{
    const auto outermostWithin = [&](GroupId group) {
        if (outer == 0)
            return outermostGroup(painting, group);
        const std::vector<GroupId> around = groupsAround(painting, group);
        const auto at = std::ranges::find(around, outer);
        return at == around.begin() || at == around.end() ? 0 : *std::prev(at);
    };
    const StrokePtr stroke = painting.find(id);
    const GroupId group = stroke && stroke->group != 0 ? outermostWithin(stroke->group) : 0;
    if (group == 0)
        return {id};
    std::unordered_map<GroupId, GroupId> known; // remembered, since there are many strokes and few groups
    std::set<StrokeId> members;
    const Editable isEditable(painting.groups);
    for (const StrokePtr &s : painting.strokes) {
        // A group stays whole even where some of its strokes are not begun.
        if (s->group == 0 || !isEditable(*s))
            continue;
        const auto [it, isNew] = known.try_emplace(s->group, 0);
        if (isNew)
            it->second = outermostWithin(s->group);
        if (it->second == group)
            members.insert(s->id);
    }
    return members;
}

std::set<StrokeId> strokesWithin(const Painting &painting, Microseconds T, const View &view, const Rect &pixels)
{
    const PixelMap pixelOf(view, view.centre);
    return strokesWhollyIn(painting, T, [&](Point p) { return pixels.contains(pixelOf(p - view.centre)); });
}

std::set<StrokeId> strokesWithin(const Painting &painting, Microseconds T, const std::vector<Point> &polygon)
{
    if (polygon.size() < 3)
        return {};
    const Rect box = boxOf(polygon);
    return strokesWhollyIn(painting, T, [&](Point p) { return box.contains(p) && isInPolygon(polygon, p); });
}

PathTouch::PathTouch(PaintingPtr painting, Microseconds T, double tolerance, Point start)
    : m_painting(std::move(painting)), m_time(T), m_tolerance(tolerance), m_last(start)
{
    const Selectable isSelectable(*m_painting, T);
    for (const StrokePtr &stroke : m_painting->strokes) {
        if (!isSelectable(*stroke))
            continue;
        // A hairline may run between the points, but not between the rings around them.
        const bool hairline = isHairline(*stroke, T, tolerance);
        const Rect reach = influenceOf(*stroke, T);
        m_left.push_back({stroke, hairline ? reach.grown(tolerance) : reach, hairline});
    }
    touchAt({start});
}

void PathTouch::goOn(Point to)
{
    std::vector<Point> points = resampled({m_last, to}, m_tolerance);
    points.erase(points.begin());
    m_last = to;
    touchAt(points);
}

void PathTouch::touchAt(const std::vector<Point> &points)
{
    const Rect box = boxOf(points).grown(m_tolerance);
    std::erase_if(m_left, [&](const Candidate &candidate) {
        if (!candidate.around.intersects(box))
            return false;
        const bool touched = std::any_of(points.begin(), points.end(), [&](Point p) { return touches(candidate, p); });
        if (touched)
            m_touched.insert(candidate.stroke->id);
        return touched;
    });
}

bool PathTouch::touches(const Candidate &candidate, Point p) const
{
    const Stroke &stroke = *candidate.stroke;
    if (!candidate.around.contains(p))
        return false;
    if (candidate.hairline)
        return isNear(stroke, m_time, p, m_tolerance) &&
               pickFrom({candidate.stroke}, m_time, p, m_tolerance).has_value();
    return hitOf(stroke, m_time, p).has_value();
}

std::set<SegmentRef> segmentsWithin(const Painting &painting, Microseconds T, const View &view, const Rect &pixels)
{
    std::set<SegmentRef> found;
    const Selectable isSelectable(painting, T);
    for (const StrokePtr &stroke : painting.strokes) {
        if (!isSelectable(*stroke))
            continue;
        for (int k = 0; k < int(stroke->segments.size()); ++k)
            if (pixels.contains(view.toPixels(stroke->cubicOf(stroke->segments[k]).at(0.5))))
                found.insert({stroke->id, k});
    }
    return found;
}

std::set<StrokeId> selectableStrokes(const Painting &painting, Microseconds T)
{
    std::set<StrokeId> ids;
    const Selectable isSelectable(painting, T);
    for (const StrokePtr &stroke : painting.strokes)
        if (isSelectable(*stroke))
            ids.insert(ids.end(), stroke->id); // the hint fits most often, since the order is mostly that of the ids
    return ids;
}

} // namespace suffuse
