#include "app/canvas/overlay/erasure_lines.h"

#include <algorithm>
#include <limits>

namespace suffuse {

namespace {

constexpr int manyPoints = 4000; ///< of a path from which on lines are quick ones

} // namespace

void ErasureLines::paint(QPainter &painter, const View &view, const PaintingPtr &painting, Microseconds T,
                         const std::set<StrokeId> *only, const OverlayColours &colours, double dpr)
{
    const bool isKept = painting == m_painting && view == m_view && holds(T) &&
                        m_only.has_value() == (only != nullptr) && (!only || *only == *m_only);
    if (!isKept)
        gather(view, painting, T, only);
    if (m_path.isEmpty())
        return;
    painter.setBrush(Qt::NoBrush);
    if (m_path.elementCount() > manyPoints) {
        painter.setPen(QPen(colours.accent, 0, Qt::DotLine)); // one device pixel, not smoothed
        painter.drawPath(m_path);
    } else {
        painter.setRenderHint(QPainter::Antialiasing);
        strokeTwoTone(painter, m_path, colours.accent, 1.4 * dpr, Qt::DashLine);
    }
}

void ErasureLines::gather(const View &view, const PaintingPtr &painting, Microseconds T, const std::set<StrokeId> *only)
{
    m_painting = painting;
    m_view = view;
    m_only = only ? std::optional(*only) : std::nullopt;
    m_from = std::numeric_limits<Microseconds>::min();
    m_until = std::numeric_limits<Microseconds>::max();
    m_path = {};
    const Visibility isVisible(painting->groups);
    for (const StrokePtr &stroke : painting->strokes) {
        if ((only && !only->contains(stroke->id)) || !stroke->hasErasure() || !isVisible(*stroke))
            continue;
        for (const Segment &segment : stroke->segments) {
            if (!segment.takesPaint())
                continue;
            if (segment.born > T) {
                m_until = std::min(m_until, segment.born);
                continue;
            }
            m_from = std::max(m_from, segment.born);
            addCurve(m_path, stroke->cubicOf(segment), view);
        }
    }
}

} // namespace suffuse
