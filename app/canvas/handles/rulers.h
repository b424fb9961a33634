// Rulers along the upper and the left edge of the canvas.
#pragma once

#include "app/session/selecting/snapping.h"
#include "render/view.h"

#include <QString>

class QPainter;

namespace suffuse {

struct OverlayColours;

/// How a ruler counts: canvas units by a factor.
struct RulerUnit {
    QString name;     ///< short, as "mm"
    double units = 1; ///< canvas units in one of it
};

/// What rulers count by a choice of the user, where an inch has so many canvas units.
RulerUnit unitOf(RulerUnits units, double resolution);

/// How wide a ruler is, logical pixels.
inline constexpr double rulerWidth = 18;

/// Whether a pixel of the view (device pixels, as `dpr` to a logical one) lies on one of them, where they are shown.
inline bool isOnRuler(Point pixel, double dpr)
{
    return std::min(pixel.x, pixel.y) < rulerWidth * dpr;
}

/// What a ruler along an edge of the view counts: that of the two axes of the canvas which lies nearer to the edge's
/// direction.
struct RulerScale {
    bool countsX = true; ///< x, or y
    double first = 0;    ///< canvas units at the edge's first pixel
    double perPixel = 1; ///< canvas units; negative where it counts backwards
    double step = 1;     ///< canvas units from label to label
    double tick = 1;     ///< canvas units from tick to tick
    int decimals = 0;    ///< of the labels
};

/// The scale along the upper edge or, `down`, the left one, in steps of 1, 2 or 5 times a power of ten of the unit. At
/// least `least` device pixels are between two labels.
RulerScale rulerScale(const View &view, bool down, const RulerUnit &unit, double least);

/// Draws both, in device pixels, with colours that stand out from the pasteboard's.
void paintRulers(QPainter &painter, const View &view, const RulerUnit &unit, const OverlayColours &colours, double dpr);

} // namespace suffuse
