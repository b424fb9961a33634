// Paths as the text of SVG and of PDF.
#pragma once

#include "render/contours/contours.h"

#include <QByteArray>

#include <limits>

namespace suffuse {

/// Writes path data in whole steps of a decimal, so that roundings do not add up. `bend`: how far curves may lie from
/// straight lines, of which longer ones are cut (canvas units).
class PathText {
public:
    static constexpr double anyBend = std::numeric_limits<double>::infinity();

    explicit PathText(const Canvas &canvas);

    /// Path data of SVG: M, c and z, each point told from the one before it.
    QByteArray svg(const contours::Loops &loops, double bend = anyBend);
    /// Operators of PDF: m, c and h, in canvas units.
    QByteArray pdf(const contours::Loops &loops, double bend = anyBend);

private:
    void append(Point p, bool moves);
    void append(qint64 steps);

    int m_decimals;
    double m_steps; ///< in a canvas unit
    QByteArray m_text;
    qint64 m_x = 0, m_y = 0;
    bool m_isRelative = true;
    bool m_pending = false; ///< whether a number comes before the next one
};

} // namespace suffuse
