#include "app/canvas/overlay/erasure_lines.h"

namespace suffuse {

namespace {

constexpr int manyPoints = 4000; ///< of a path from which on lines are quick ones

} // namespace

void ErasureLines::paint(QPainter &painter, const View &view, const PaintingPtr &painting,
                         const std::set<StrokeId> *only, const OverlayColours &colours, double dpr)
{
    const bool isKept = painting == m_painting && view == m_view && m_only.has_value() == (only != nullptr) &&
                        (!only || *only == *m_only);
    if (!isKept)
        gather(view, painting, only);
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

void ErasureLines::gather(const View &view, const PaintingPtr &painting, const std::set<StrokeId> *only)
{
    m_painting = painting;
    m_view = view;
    m_only = only ? std::optional(*only) : std::nullopt;
    m_path = {};
    for (const StrokePtr &stroke : painting->strokes) {
        if ((only && !only->contains(stroke->id)) || !stroke->hasLift() || !painting->isVisible(*stroke))
            continue;
        for (const Segment &segment : stroke->segments)
            if (segment.lift)
                addCurve(m_path, stroke->cubicOf(segment), view);
    }
}

} // namespace suffuse
