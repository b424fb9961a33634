// Colours as CSS writes them. Qt's own parser lives in Qt Gui, which the model does not link.
#pragma once

#include <QString>

#include <array>
#include <optional>

namespace suffuse {

/// The sRGB-encoded red, green, blue and alpha in [0, 1] of "#rgb", "#rgba", "#rrggbb", "#rrggbbaa", "rgb(1, 2, 3)",
/// "rgba(10%, 20%, 30%, 0.5)", "rgb(1 2 3 / 50%)", "hsl(20, 50%, 40%)", "transparent" or a CSS colour name; no value
/// for other texts.
std::optional<std::array<double, 4>> cssColour(const QString &text);

} // namespace suffuse
