#pragma once

#include <QString>

#include <optional>

namespace suffuse {

/// The value of the text in a number field: numbers with + − * / and parentheses ("12*1.5"), with a decimal comma or
/// point. Groups of thousands are read as the language writes them: "1,536" is 1536 in English and 1.536 in German.
/// What is grouped in another way ("1,53,600") is not read at all. A leading + * or / works on `current`, if there is
/// one ("+2", "*1.5"). A leading − is a sign, and "−=2" takes 2 away. `unit`, or one that converts to it (ms to s, rad
/// to °), may stand at the end, as the interface or as this comment writes it. Where the unit is a length, "50%" is
/// half of `current` and "+10%" a tenth more, as in Inkscape; mm, cm, in and pt convert to each other, and to px and
/// canvas units where `resolution` says how many of these an inch has (0: it does not). A number in the middle may have
/// a unit of length of its own ("1in + 2mm"). Returns nothing if the text cannot be read or its value is not finite.
std::optional<double> evaluateArithmetic(const QString &text, std::optional<double> current, const QString &unit = {},
                                         double resolution = 0);

/// Whether the text works on the current value: "+2", "*1.5", "/2", "−=2", of lengths also "50%".
bool isRelative(const QString &text, const QString &unit = {});

/// The letters at the end of the text if they are no unit that `evaluateArithmetic` knows; else empty.
QString foreignUnit(const QString &text, const QString &unit, double resolution = 0);

} // namespace suffuse
