#include "app/tools/select/transform_snap.h"

#include "model/painting/editable.h"
#include "undo/transform_edits.h"

#include <algorithm>

namespace suffuse {

namespace {

/// So many nodes snap, those nearest to the pointer. Few strokes have no more, so all of theirs snap.
constexpr std::size_t snappingNodes = 64;

std::vector<Point> nodesNear(const Painting &painting, const std::set<StrokeId> &moved, Point point)
{
    std::vector<Point> nodes;
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        if (!moved.contains(stroke->id) || !isEditable(*stroke))
            continue;
        for (const Segment &segment : stroke->segments)
            nodes.push_back(stroke->origin + segment.bezier[0]);
        nodes.push_back(stroke->origin + stroke->segments.back().bezier[3]);
    }
    const auto count = std::min(nodes.size(), snappingNodes);
    std::partial_sort(nodes.begin(), nodes.begin() + std::ptrdiff_t(count), nodes.end(),
                      [point](Point a, Point b) { return length(a - point) < length(b - point); });
    nodes.resize(count);
    return nodes;
}

} // namespace

void TransformSnap::begin(const Painting &painting, const CanvasAids &aids, const std::vector<Guide> &guides,
                          const Selection &moved, What what, Point start)
{
    const bool centre = what == What::Centre; // The centre may lie on a node of the strokes that it turns.
    m_snapping = Snapping(painting, aids, guides,
                          [&](const Stroke &stroke, int) { return !centre && moved.strokes.contains(stroke.id); });
    m_found = {};
    m_points.clear();
    if (what != What::Strokes)
        return;
    const Rect box = selectionBox(painting, moved);
    m_points = {
        {box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}, box.centre()};
    for (const Point &node : nodesNear(painting, moved.strokes, start))
        m_points.push_back(node);
}

Point TransformSnap::move(Point by, const View &view, double dpr)
{
    Point at;
    const Snap snapped = m_snapping.snapMove(m_points, by, view, dpr, &at);
    m_found = {at, snapped.to};
    return snapped.point;
}

Point TransformSnap::point(Point to, const View &view, double dpr)
{
    m_found = m_snapping.snap(to, view, dpr);
    return m_found.point;
}

} // namespace suffuse
