// What shapes of SVG cover as areas.
#pragma once

#include "model/area/area_sets.h"
#include "model/formats/svg/svg_style.h"

#include <optional>
#include <vector>

namespace suffuse {

using SvgLoops = std::vector<std::vector<Cubic>>;

/// The subpaths of path data as lines for a pen: as parsePathData reads them, with those that are points, and with
/// which of them were closed.
std::vector<PenLine> svgLines(const QString &data);
/// Whether one can reckon with a point: it is finite, and squares of its coordinates are far from overflowing.
bool isReckonable(Point p);

/// The subpaths under a matrix, without those that have no extent or cannot be reckoned with.
SvgLoops svgLoops(const std::vector<PenLine> &lines, const SvgMatrix &matrix);
/// The lines under a matrix, without those that cannot be reckoned with.
std::vector<PenLine> svgMapped(std::vector<PenLine> lines, const SvgMatrix &matrix);

/// The same loops, each closed by a straight line.
SvgLoops svgClosed(SvgLoops loops);
/// The box of lines.
Rect svgBox(const std::vector<PenLine> &lines);
/// The line around a rectangle, from its left top corner clockwise.
std::vector<PenLine> svgLinesOf(const Rect &box);
/// Goes back to where the line began.
void closeLine(PenLine &line);

/// Whether a stroke of the style along these lines, in user units, can be a stroke of a painting: that is round
/// wherever the line begins, ends or turns, equally wide in all directions, and has no dashes.
bool isRoundStroke(const std::vector<PenLine> &lines, const SvgStyle &style);

/// The area that the pen of the style covers along lines in user units, in units of the document, within a tolerance of
/// these. No value if the effort is spent, or one cannot reckon with them.
std::optional<Area> svgPenArea(const std::vector<PenLine> &lines, const SvgStyle &style, double tolerance,
                               AreaEffort &effort);

} // namespace suffuse
