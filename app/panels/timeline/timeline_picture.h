// How the Timeline looks.
#pragma once

#include "app/panels/timeline/timeline_axes.h"
#include "app/panels/timeline/timeline_bars.h"

#include <QCoreApplication>
#include <QPalette>

#include <set>

class QPainter;
class QWidget;

namespace suffuse {

class Document;
class PaintingClock;

/// Paints ruler, bars and playhead into the Timeline's viewport. It is made anew for each painting of it.
class TimelinePicture {
    Q_DECLARE_TR_FUNCTIONS(TimelinePicture)

public:
    TimelinePicture(const QWidget &viewport, const Document &document, const PaintingClock &clock,
                    const TimelineBars &bars, const TimelineAxes &axes);

    /// `dragged` are the strokes that are being retimed. They are shown where they are now, in the lanes from before
    /// the drag; null if there are none.
    void paint(QPainter &painter, const QRect &area, const std::set<StrokeId> *dragged,
               const std::optional<QRectF> &band) const;

    /// The left edge of a label of this width. The label stands to the right of its tick. Where it would leave the view
    /// or lie under the playhead's head, it stands to the left of the tick or beside the playhead. Logical pixels.
    static double labelLeft(double tick, double width, double head, double view);
    /// Where labels of the ruler make room for a playhead, in a view of this width.
    static QRect headArea(const TimelineAxes &axes, Microseconds time, int width);

private:
    QRectF lanesRect() const;
    void paintRuler(QPainter &painter, const QRect &area) const;
    void paintLanes(QPainter &painter, const QRect &area, const std::set<StrokeId> *dragged) const;
    void paintBar(QPainter &painter, const TimelineBar &bar, const Stroke &stroke, bool isVisible) const;
    void paintErasures(QPainter &painter, const QRect &area, const std::set<StrokeId> *dragged) const;
    void paintSelectedRuns(QPainter &painter, const Stroke &stroke, const QRectF &rect) const;
    void paintPlayhead(QPainter &painter) const;

    const QWidget &m_viewport;
    const Document &m_document;
    const PaintingClock &m_clock;
    const TimelineBars &m_bars;
    TimelineAxes m_axes;
    QPalette m_palette;
};

} // namespace suffuse
