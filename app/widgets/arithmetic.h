#pragma once

#include <QString>

#include <optional>

namespace suffuse {

/// Value of what was typed into a number field: numbers with + − * / and parentheses ("12*1.5"), a decimal comma or
/// point. A leading + * or / works on `current` where there is one ("+2", "*1.5"); a leading − is a sign, "−=2" takes 2
/// away. `unit` or one that converts to it (ms to s, rad to °) may stand at the end, as the interface writes it or as
/// here. Nothing if it cannot be read or is not finite.
std::optional<double> evaluateArithmetic(const QString &text, std::optional<double> current, const QString &unit = {});

/// Whether the text works on the current value: "+2", "*1.5", "/2", "−=2".
bool isRelative(const QString &text);

/// Letters at the end of the text that are no unit which `evaluateArithmetic` knows; empty if there are none.
QString foreignUnit(const QString &text, const QString &unit);

} // namespace suffuse
