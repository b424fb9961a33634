#include "app/tools/pick.h"

#include "model/influence.h"
#include "render/probe.h"

#include <numbers>

namespace suffuse {

namespace {

bool isSelectable(const Painting &painting, const Stroke &stroke)
{
    return painting.isVisible(stroke) && !painting.isLocked(stroke);
}

/// The segment with the largest share where the stroke is seen at the point.
std::optional<SegmentRef> hitOf(const Painting &alone, Microseconds T, Point point)
{
    const Result<Probe> found = probe(alone, T, point.x, point.y);
    if (!found || found->strokes.empty() || found->strokes.front().opacity < visibleOpacity)
        return {};
    const ProbeStroke &stroke = found->strokes.front();
    const auto most = std::max_element(stroke.shares.begin(), stroke.shares.end(),
                                       [](const ProbeShare &a, const ProbeShare &b) { return a.share < b.share; });
    if (most == stroke.shares.end())
        return {};
    return SegmentRef{stroke.id, most->segment};
}

/// A painting of one stroke on smooth paper: the gaps between a chalk's grains belong to the stroke, too.
Painting alone(const Painting &painting, const StrokePtr &stroke)
{
    Painting one;
    one.canvas = painting.canvas;
    one.canvas.paper = {};
    one.groups = painting.groups;
    one.strokes = {stroke};
    return one;
}

std::vector<Point> ringAround(Point point, double radius)
{
    std::vector<Point> ring;
    for (int k = 0; k < 8; ++k) {
        const double angle = k * std::numbers::pi / 4;
        ring.push_back(point + radius * Point{std::cos(angle), std::sin(angle)});
    }
    return ring;
}

bool isNear(const Painting &painting, const Stroke &stroke, Microseconds T, Point point, double tolerance)
{
    return isSelectable(painting, stroke) && influenceOf(stroke, T).grown(tolerance).contains(point);
}

/// The first that is seen at the point, else the first that is seen around it.
std::optional<SegmentRef> pickFrom(const Painting &painting, const std::vector<StrokePtr> &strokes, Microseconds T,
                                   Point point, double tolerance)
{
    for (const StrokePtr &stroke : strokes)
        if (const auto hit = hitOf(alone(painting, stroke), T, point))
            return hit;
    for (const StrokePtr &stroke : strokes)
        for (const Point &beside : ringAround(point, tolerance))
            if (const auto hit = hitOf(alone(painting, stroke), T, beside))
                return hit;
    return {};
}

} // namespace

std::optional<SegmentRef> pickTopmost(const Painting &painting, Microseconds T, Point point, double tolerance)
{
    std::vector<StrokePtr> near; // from top to bottom
    for (auto it = painting.strokes.rbegin(); it != painting.strokes.rend(); ++it)
        if (isNear(painting, **it, T, point, tolerance))
            near.push_back(*it);
    return pickFrom(painting, near, T, point, tolerance);
}

std::optional<SegmentRef> pickOn(const Painting &painting, StrokeId id, Microseconds T, Point point, double tolerance)
{
    const StrokePtr stroke = painting.find(id);
    if (!stroke || !isNear(painting, *stroke, T, point, tolerance))
        return {};
    return pickFrom(painting, {stroke}, T, point, tolerance);
}

std::set<StrokeId> strokesWithin(const Painting &painting, const View &view, const Rect &pixels)
{
    const auto isWithin = [&](const Stroke &stroke) {
        for (const Segment &segment : stroke.segments) {
            const Cubic cubic = stroke.cubicOf(segment);
            for (int k = 0; k <= 4; ++k)
                if (!pixels.contains(view.toPixels(cubic.at(k / 4.0))))
                    return false;
        }
        return true;
    };
    std::set<StrokeId> ids;
    for (const StrokePtr &stroke : painting.strokes)
        if (isSelectable(painting, *stroke) && isWithin(*stroke))
            ids.insert(stroke->id);
    return ids;
}

std::set<SegmentRef> segmentsWithin(const Painting &painting, const View &view, const Rect &pixels)
{
    std::set<SegmentRef> found;
    for (const StrokePtr &stroke : painting.strokes) {
        if (!isSelectable(painting, *stroke))
            continue;
        for (int k = 0; k < int(stroke->segments.size()); ++k)
            if (pixels.contains(view.toPixels(stroke->cubicOf(stroke->segments[k]).at(0.5))))
                found.insert({stroke->id, k});
    }
    return found;
}

std::set<StrokeId> selectableStrokes(const Painting &painting)
{
    std::set<StrokeId> ids;
    for (const StrokePtr &stroke : painting.strokes)
        if (isSelectable(painting, *stroke))
            ids.insert(stroke->id);
    return ids;
}

} // namespace suffuse
