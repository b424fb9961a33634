// Takes curves from SVG: paths and basic shapes with their colours, under transforms.
#pragma once

#include "model/formats/svg/svg_drawing.h"
#include "model/result.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace suffuse {

/// The subpaths of path data ("M 0 0 C …"). All commands of SVG are read, and lines and arcs become cubics. What
/// follows a mistake is left out, as browsers do, and so are curves that are points or not finite.
std::vector<std::vector<Cubic>> parsePathData(const QString &data);

/// All paths and basic shapes of a document in their order, in the units of the document after transforms, styled by
/// attributes and style sheets. What a <use> refers to counts where it is used. Elements that are only defined and not
/// drawn (<defs>, <clipPath>, …), and invisible ones, are left out. Errors name the line.
Result<SvgDrawing> readSvgDrawing(const QByteArray &bytes);
/// The paths of a document alone, without groups.
Result<std::vector<SvgPath>> readSvgPaths(const QByteArray &bytes);

} // namespace suffuse
