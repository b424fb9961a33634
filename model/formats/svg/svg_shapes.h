// Converts SVG's basic shapes to path data.
#pragma once

#include <QString>
#include <QXmlStreamAttributes>

#include <optional>

namespace suffuse {

/// A length in user units: "12", "12px", "3mm". No value for per cents and what is no length.
std::optional<double> svgLength(const QString &text);

/// What a <path>, <rect>, <circle>, <ellipse>, <line>, <polyline> or <polygon> draws, as the "d" of a <path>. Empty for
/// other elements and for shapes without size.
QString svgPathData(QStringView element, const QXmlStreamAttributes &attributes);

} // namespace suffuse
