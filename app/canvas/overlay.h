// Crisp lines over the picture. Painters here work in device pixels; `dpr` is the device pixel ratio.
#pragma once

#include "model/painting.h"
#include "model/selection.h"
#include "render/view.h"

#include <QColor>
#include <QPainter>
#include <QPainterPath>

namespace suffuse {

/// Colours of the overlay that follow the theme.
struct OverlayColours {
    QColor pasteboard; ///< tint over what lies outside of the canvas, semi-opaque
    QColor border;     ///< of the canvas
    QColor accent;     ///< selection
};

/// The visible part of a cubic as a polyline within a third of a pixel, appended to `path`.
void addCurve(QPainterPath &path, const Cubic &cubic, const View &view);

/// Tints what lies outside of the canvas, with a soft shadow and a hairline along its border.
void paintPasteboard(QPainter &painter, const View &view, const Rect &canvas, const OverlayColours &colours, double dpr);

/// Thin two-tone lines through the selected strokes; selected segments stand out, with dots at their nodes.
void paintSelection(QPainter &painter, const View &view, const Painting &painting, const Selection &selection,
                    const OverlayColours &colours, double dpr);

/// A two-tone line that shows on any picture.
void strokeTwoTone(QPainter &painter, const QPainterPath &path, const QColor &colour, double width,
                   Qt::PenStyle style = Qt::SolidLine);

} // namespace suffuse
