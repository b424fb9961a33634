#include "app/canvas/stroke_boxes.h"

namespace suffuse {

namespace {

Rect controlBox(const Stroke &stroke)
{
    Rect box;
    for (const Segment &segment : stroke.segments)
        for (const Offset &offset : segment.bezier)
            box.include(stroke.origin + offset);
    return box;
}

} // namespace

bool StrokeBoxes::follow(const StrokeList &strokes)
{
    bool same = strokes.size() == m_strokes.size();
    if (same) {
        strokes.forEachDifference(m_strokes, [&](std::size_t i) {
            same = same && strokes[i]->id == std::as_const(m_strokes)[i]->id;
            m_boxes[i] = controlBox(*strokes[i]);
        });
    } else {
        replace(strokes);
    }
    m_strokes = strokes;
    return same;
}

void StrokeBoxes::replace(const StrokeList &strokes)
{
    // What comes or goes leaves most of those below and above as they are.
    const StrokeList &before = m_strokes;
    const std::size_t n = strokes.size(), old = before.size(), least = std::min(n, old);
    std::size_t below = 0, above = 0;
    while (below < least && strokes[below] == before[below])
        ++below;
    while (above < least - below && strokes[n - 1 - above] == before[old - 1 - above])
        ++above;
    std::vector<Rect> boxes(m_boxes.begin(), m_boxes.begin() + std::ptrdiff_t(below));
    boxes.reserve(n);
    for (std::size_t i = below; i < n - above; ++i)
        boxes.push_back(controlBox(*strokes[i]));
    boxes.insert(boxes.end(), m_boxes.end() - std::ptrdiff_t(above), m_boxes.end());
    m_boxes = std::move(boxes);
}

} // namespace suffuse
