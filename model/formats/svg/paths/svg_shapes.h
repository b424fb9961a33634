// Converts SVG's basic shapes to path data.
#pragma once

#include "model/formats/svg/svg_length.h"

#include <QString>
#include <QXmlStreamAttributes>

namespace suffuse {

/// What a <path>, <rect>, <circle>, <ellipse>, <line>, <polyline> or <polygon> draws, as the "d" of a <path>. Empty for
/// other elements and for shapes without size.
QString svgPathData(QStringView element, const QXmlStreamAttributes &attributes, const SvgUnits &units = {});

} // namespace suffuse
