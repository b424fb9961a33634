// The transforms of SVG.
#pragma once

#include "model/geometry/affine.h"

#include <QString>
#include <QXmlStreamAttributes>

#include <cmath>

namespace suffuse {

/// x′ = a x + c y + e, y′ = b x + d y + f, with the letters of SVG.
struct SvgMatrix {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

    Point map(Point p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
    SvgMatrix operator*(const SvgMatrix &o) const
    {
        return {a * o.a + c * o.b, b * o.a + d * o.b,     a * o.c + c * o.d,
                b * o.c + d * o.d, a * o.e + c * o.f + e, b * o.e + d * o.f + f};
    }
    explicit operator Affine() const { return {a, c, b, d, {e, f}}; }
    double scale() const { return std::sqrt(std::abs(a * d - b * c)); }
};

/// The transform of an attribute such as "translate(10 20) rotate(45)", or of a style sheet with its units (px, deg).
/// What is not understood changes nothing.
SvgMatrix svgTransform(const QString &text);

/// The four numbers of "viewBox" as a rectangle. It is empty if there are none that enclose an area.
Rect svgViewBox(const QXmlStreamAttributes &attributes);

/// Maps a view box into `port` as "preserveAspectRatio" says.
SvgMatrix svgViewport(const Rect &viewBox, const Rect &port, const QString &preserveAspectRatio);

} // namespace suffuse
