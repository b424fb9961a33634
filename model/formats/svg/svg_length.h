// Lengths of SVG.
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

namespace suffuse {

/// What lengths count by that are relative to something.
struct SvgUnits {
    double fontSize = 16; ///< user units: 1 em, and 2 ex
    double width = 0;     ///< of the nearest viewport, user units: 100 %
    double height = 0;
};

/// Along which side of the viewport per cents count; Any: by its diagonal, as those of radii and widths of strokes do.
enum class SvgAxis { Across, Down, Any };

/// User units an inch, as CSS counts.
inline constexpr double svgUnitsOfInch = 96;
/// Whether the document says its width or its height in a unit of paper: mm, cm, in, pt or pc.
bool saysSizeOnPaper(const QByteArray &svg);

/// A length in user units: "12", "12px", "3mm". No value for relative ones and what is no length.
std::optional<double> svgLength(const QString &text);
/// The same for relative ones, too: "2em", "1.5ex", "50%".
std::optional<double> svgLength(const QString &text, const SvgUnits &units, SvgAxis axis);

} // namespace suffuse
