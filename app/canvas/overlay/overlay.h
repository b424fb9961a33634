// Crisp lines over the picture. Painters here work in device pixels; `dpr` is the device pixel ratio.
#pragma once

#include "model/painting/painting.h"
#include "model/painting/selection.h"
#include "render/view.h"

#include <QColor>
#include <QPainter>
#include <QPainterPath>

namespace suffuse {

/// Colours of the overlay that follow the theme.
struct OverlayColours {
    QColor pasteboard; ///< over what lies outside of the canvas
    QColor border;     ///< of the canvas
    QColor accent;     ///< selection: so dark that it stands out from white beside it, and one of both from any paint
};

/// The visible part of a cubic as a polyline within a third of a pixel, appended to `path`.
void addCurve(QPainterPath &path, const Cubic &cubic, const View &view);

/// Covers what lies outside of the canvas, with a soft shadow and a hairline along its border.
void paintPasteboard(QPainter &painter, const View &view, const Rect &canvas, const OverlayColours &colours, double dpr);

/// Lines through multiples of `step` over the canvas; where they would stand too close, every fifth or tenth of them.
void paintGrid(QPainter &painter, const View &view, const Rect &area, double step, double dpr);

/// Where a dragged point snaps.
void paintSnapMark(QPainter &painter, Point pixel, const OverlayColours &colours, double dpr);

/// A dot at a node.
void paintNode(QPainter &painter, Point pixel, const OverlayColours &colours, double dpr);

/// "12.5°" for an angle in radians, from −180° to 180°.
QString angleText(double angle);

/// A short text on a dark plate, outside of a circle of `radius` pixels around `pixel` and within the view.
void paintBadge(QPainter &painter, const QString &text, Point pixel, double radius, const View &view, double dpr);

/// A two-tone line that shows on any picture.
void strokeTwoTone(QPainter &painter, const QPainterPath &path, const QColor &colour, double width,
                   Qt::PenStyle style = Qt::SolidLine);

} // namespace suffuse
