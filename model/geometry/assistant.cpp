#include "model/geometry/assistant.h"

#include <numbers>

namespace suffuse {

namespace {

constexpr double farthestAssistant = 1e12; ///< canvas units
constexpr int mostNewtonSteps = 200;
constexpr double mostDeviation = std::numbers::pi / 6; ///< between a stroke and what it follows

bool isFinitePoint(Point p)
{
    return std::isfinite(p.x) && std::isfinite(p.y);
}

Point turnedRight(Point p)
{
    return {-p.y, p.x};
}

/// The direction; no value for what has none.
std::optional<Point> directionOf(Point way)
{
    const double size = length(way);
    if (!(size > 0) || !std::isfinite(size))
        return std::nullopt;
    return Point{way.x / size, way.y / size};
}

std::optional<AssistantTrack> lineFrom(Point origin, Point way)
{
    const std::optional<Point> along = directionOf(way);
    return along && isFinitePoint(origin) ? std::optional(AssistantTrack{origin, *along}) : std::nullopt;
}

/// The nearest point of an ellipse with half axes a ≥ b > 0 along the coordinate axes, of a point with x, y ≥ 0. It is
/// (a² x / (s + c), b² y / s) with c = a² − b² for the largest root s of F(s) = (a x / (s + c))² + (b y / s)² − 1.
/// Right of the pole F is convex and falls, so that Newton's method comes to the root from its left side without
/// passing it.
Point nearestInQuadrant(double a, double b, double x, double y)
{
    const double aa = a * a, bb = b * b, c = (a - b) * (a + b);
    if (y == 0 && a * x < c) { // The pole is gone, and with it the root.
        const double across = aa * x / c, share = across / a;
        return {across, b * std::sqrt(std::max(0.0, 1 - share * share))};
    }
    double s = std::max(b * y, a * x - c); // F ≥ 0 there
    for (int i = 0; i < mostNewtonSteps; ++i) {
        const double p = a * x / (s + c), q = b * y / s;
        const double next = s + (p * p + q * q - 1) / (2 * (p * p / (s + c) + q * q / s));
        if (!(next > s))
            break;
        s = next;
    }
    const Point at{aa * x / (s + c), bb * y / s};
    const double off = std::hypot(at.x / a, at.y / b); // 1, but for rounding
    return off > 0 && std::isfinite(off) ? (1 / off) * at : Point{0, b};
}

Point nearestOfEllipse(double a, double b, Point p)
{
    const double x = std::abs(p.x), y = std::abs(p.y), size = std::max(a, b);
    Point at; // In units of the larger half axis squares keep their digits.
    if (a >= b) {
        at = nearestInQuadrant(1, b / size, x / size, y / size);
    } else {
        const Point swapped = nearestInQuadrant(1, a / size, y / size, x / size);
        at = {swapped.y, swapped.x};
    }
    return {std::copysign(size * at.x, p.x), std::copysign(size * at.y, p.y)};
}

/// A line as n·p + c = 0; of two that meet, the point as homogeneous coordinates is their cross product.
struct Homogeneous {
    double x = 0, y = 0, w = 0;
};

Homogeneous lineThrough(Point p, Point q)
{
    return {p.y - q.y, q.x - p.x, cross(p, q)};
}

Homogeneous meeting(const Homogeneous &l, const Homogeneous &m)
{
    return {l.y * m.w - l.w * m.y, l.w * m.x - l.x * m.w, l.x * m.y - l.y * m.x};
}

/// Where opposite sides of a perspective meet, seen from a point: coordinates are relative to it.
std::vector<Homogeneous> meetingsFrom(const Assistant &assistant, Point origin)
{
    std::vector<Point> p = assistant.points;
    for (Point &point : p)
        point = point - origin;
    return {meeting(lineThrough(p[0], p[1]), lineThrough(p[3], p[2])),
            meeting(lineThrough(p[0], p[3]), lineThrough(p[1], p[2]))};
}

/// A point that is this far away, in sizes of the quadrilateral, is at infinity.
constexpr double atInfinity = 1e9;

double spanOf(const std::vector<Point> &points)
{
    Rect box;
    for (const Point &point : points)
        box.include(point);
    return std::max(box.width(), box.height());
}

/// The lines to one vanishing point, which lies at `way` from the start. A stroke that begins at it may go anywhere.
std::optional<AssistantTrack> lineToward(Point start, Point way, Point now, double reach)
{
    return length(way) <= reach ? lineFrom(start + way, now - start) : lineFrom(start, way);
}

bool isWithin(const AssistantTrack &track, Point start, double reach)
{
    return length(track.nearest(start) - start) <= reach;
}

std::vector<AssistantTrack> perspectiveTracks(const Assistant &assistant, Point start, Point now, double reach)
{
    std::vector<AssistantTrack> tracks;
    const double size = spanOf(assistant.points);
    for (const Homogeneous &at : meetingsFrom(assistant, start)) {
        const Point way{at.x, at.y};
        const bool isFar = length(way) >= atInfinity * size * std::abs(at.w);
        if (const auto track = isFar ? lineFrom(start, way) : lineToward(start, {at.x / at.w, at.y / at.w}, now, reach))
            tracks.push_back(*track);
    }
    return tracks;
}

/// The ellipse of the same form and centre that goes through a point.
std::optional<AssistantTrack> concentricThrough(const Assistant &assistant, Point start)
{
    std::optional<AssistantTrack> track = assistant.ownTrack();
    if (!track)
        return std::nullopt;
    const Point p = start - track->origin;
    const double k = std::hypot(dot(track->along, p) / track->first, cross(track->along, p) / track->second);
    track->first *= k;
    track->second *= k;
    const bool isOne = track->first > 0 && track->second > 0 && std::isfinite(track->first + track->second);
    return isOne ? track : std::nullopt;
}

/// Those of an assistant that a stroke may follow which begins at `start`.
std::vector<AssistantTrack> tracksFrom(const Assistant &assistant, Point start, Point now, double reach)
{
    std::optional<AssistantTrack> track;
    switch (assistant.kind) {
    case AssistantKind::Ruler:
    case AssistantKind::Ellipse:
        track = assistant.ownTrack();
        if (track && !isWithin(*track, start, reach))
            track.reset();
        break;
    case AssistantKind::Parallel:
        track = lineFrom(start, assistant.points[1] - assistant.points[0]);
        break;
    case AssistantKind::VanishingPoint:
        track = lineToward(start, assistant.points[0] - start, now, reach);
        break;
    case AssistantKind::Perspective:
        return perspectiveTracks(assistant, start, now, reach);
    case AssistantKind::Concentric:
        track = concentricThrough(assistant, start);
        break;
    }
    return track ? std::vector{*track} : std::vector<AssistantTrack>();
}

/// The angle between the way of a stroke and that of its image on a track; π where it has none there.
double deviationOf(const AssistantTrack &track, Point start, Point now)
{
    const auto way = directionOf(now - start), image = directionOf(track.nearest(now) - track.nearest(start));
    return way && image ? std::acos(std::clamp(dot(*way, *image), -1.0, 1.0)) : std::numbers::pi;
}

} // namespace

Point AssistantTrack::nearest(Point point) const
{
    const Point from = point - origin, across = turnedRight(along);
    if (!isFinitePoint(from))
        return point;
    const Point own{dot(along, from), dot(across, from)};
    if (isLine())
        return origin + own.x * along;
    const Point at = nearestOfEllipse(first, second, own);
    return origin + at.x * along + at.y * across;
}

std::size_t Assistant::pointsOf(AssistantKind kind)
{
    switch (kind) {
    case AssistantKind::VanishingPoint:
        return 1;
    case AssistantKind::Ruler:
    case AssistantKind::Parallel:
        break;
    case AssistantKind::Ellipse:
    case AssistantKind::Concentric:
        return 3;
    case AssistantKind::Perspective:
        return 4;
    }
    return 2;
}

bool Assistant::isSound() const
{
    return points.size() == pointsOf(kind) && std::ranges::all_of(points, [](Point p) {
               return std::abs(p.x) <= farthestAssistant && std::abs(p.y) <= farthestAssistant;
           });
}

Assistant Assistant::between(AssistantKind kind, Point from, Point to)
{
    const Point middle = 0.5 * (from + to);
    switch (kind) {
    case AssistantKind::VanishingPoint:
        return {kind, {to}};
    case AssistantKind::Ruler:
    case AssistantKind::Parallel:
        break;
    case AssistantKind::Ellipse:
    case AssistantKind::Concentric:
        return {kind, {middle, {std::max(from.x, to.x), middle.y}, {middle.x, std::max(from.y, to.y)}}};
    case AssistantKind::Perspective:
        return {kind, {from, {to.x, from.y}, to, {from.x, to.y}}};
    }
    return {kind, {from, to}};
}

Assistant::Form Assistant::form() const
{
    const Point way = points[1] - points[0];
    const Point along = directionOf(way).value_or(Point{1, 0});
    return {length(way), std::abs(cross(along, points[2] - points[0])), std::atan2(along.y, along.x)};
}

Assistant Assistant::withForm(const Form &form) const
{
    Assistant formed = *this;
    const Point along{std::cos(form.angle), std::sin(form.angle)};
    formed.points[1] = points[0] + form.first * along;
    formed.points[2] = points[0] + form.second * turnedRight(along);
    return formed;
}

Assistant Assistant::withPoint(std::size_t number, Point to) const
{
    Assistant dragged = *this;
    if (!isRound()) {
        dragged.points[number] = to;
        return dragged;
    }
    if (number == 0)
        return movedBy(to - points[0]);
    // The half axes stay at a right angle, and the second one on its side.
    const Point along = directionOf((number == 1 ? to : points[1]) - points[0]).value_or(Point{1, 0});
    const double side = std::copysign(1.0, cross(points[1] - points[0], points[2] - points[0]));
    const double second = number == 1 ? side * form().second : cross(along, to - points[0]);
    if (number == 1)
        dragged.points[1] = to;
    dragged.points[2] = points[0] + second * turnedRight(along);
    return dragged;
}

Assistant Assistant::movedBy(Point by) const
{
    Assistant moved = *this;
    for (Point &point : moved.points)
        point = point + by;
    return moved;
}

std::optional<AssistantTrack> Assistant::ownTrack() const
{
    if (kind == AssistantKind::Ruler || kind == AssistantKind::Parallel)
        return lineFrom(points[0], points[1] - points[0]);
    if (!isRound())
        return std::nullopt;
    const Form axes = form();
    std::optional<AssistantTrack> track = lineFrom(points[0], points[1] - points[0]);
    if (!track || !(axes.second > 0) || !std::isfinite(axes.second))
        return std::nullopt;
    track->first = axes.first;
    track->second = axes.second;
    return track;
}

std::vector<Point> Assistant::vanishingPoints() const
{
    if (kind == AssistantKind::VanishingPoint)
        return points;
    std::vector<Point> found;
    if (kind != AssistantKind::Perspective)
        return found;
    const double size = spanOf(points);
    for (const Homogeneous &at : meetingsFrom(*this, points[0]))
        if (std::hypot(at.x, at.y) < atInfinity * size * std::abs(at.w))
            found.push_back(points[0] + Point{at.x / at.w, at.y / at.w});
    return found;
}

std::optional<AssistantTrack> trackOf(const std::vector<Assistant> &assistants, Point start, Point now, double reach)
{
    std::optional<AssistantTrack> best;
    double least = std::numeric_limits<double>::infinity();
    for (const Assistant &assistant : assistants) {
        if (!assistant.isSound())
            continue;
        const bool isPlace = assistant.kind == AssistantKind::Ruler || assistant.kind == AssistantKind::Ellipse;
        for (const AssistantTrack &track : tracksFrom(assistant, start, now, reach)) {
            const double deviation = deviationOf(track, start, now);
            const double counted = isPlace ? 0.5 * deviation : deviation;
            if (deviation <= mostDeviation && counted < least) {
                least = counted;
                best = track;
            }
        }
    }
    return best;
}

} // namespace suffuse
