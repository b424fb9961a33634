// Draws crisp lines over the picture. Painters here work in device pixels; `dpr` is the device pixel ratio.
#pragma once

#include "model/painting/painting.h"
#include "model/painting/selection.h"
#include "render/view.h"

#include <QColor>
#include <QPainter>
#include <QPainterPath>

namespace suffuse {

/// The colours of the overlay, which follow the theme.
struct OverlayColours {
    QColor pasteboard; ///< covers what lies outside of the canvas
    QColor border;     ///< for the line around the canvas
    /// The colour of the selection. It is so dark that it stands out from white beside it, and one of the two stands
    /// out from any paint.
    QColor accent;
    QColor guide;     ///< as dark, and another one
    QColor assistant; ///< the same of assistants
};

/// Appends the visible part of a cubic to `path`, as a polyline that is exact to a third of a pixel.
void addCurve(QPainterPath &path, const Cubic &cubic, const View &view);

/// Covers what lies outside of the canvas, with a soft shadow and a hairline along its border.
void paintPasteboard(QPainter &painter, const View &view, const Rect &canvas, const OverlayColours &colours,
                     double dpr);

/// Draws lines through the multiples of `step` (canvas units) over the canvas. Where they would stand too close, only
/// every fifth or tenth of them is drawn.
void paintGrid(QPainter &painter, const View &view, const Rect &area, double step, double dpr);

/// Draws a mark where a dragged point snaps.
void paintSnapMark(QPainter &painter, Point pixel, const OverlayColours &colours, double dpr);

/// Draws a dot at a node.
void paintNode(QPainter &painter, Point pixel, const OverlayColours &colours, double dpr);

/// The text for an angle in radians, as "12.5°", from −180° to 180°.
QString angleText(double angle);

/// Draws a short text on a dark plate, outside of a circle of `radius` device pixels around `pixel` and within the
/// view.
void paintBadge(QPainter &painter, const QString &text, Point pixel, double radius, const View &view, double dpr);

/// Draws a line of text on such a plate, below `top` in the middle. It is cut short where it is wider than `widest`
/// device pixels.
void paintPlate(QPainter &painter, const QString &text, Point top, double widest, double dpr);

/// Draws a line in two tones, which is seen on any picture. `weight` is a factor of its opacity; the rim fades faster,
/// since it is wider.
void strokeTwoTone(QPainter &painter, const QPainterPath &path, const QColor &colour, double width,
                   Qt::PenStyle style = Qt::SolidLine, double weight = 1);
/// Draws straight lines so, where they cross each other one over the other.
void strokeTwoTone(QPainter &painter, const QList<QLineF> &lines, const QColor &colour, double width, double weight);

} // namespace suffuse
