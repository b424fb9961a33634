#pragma once

#include "model/painting/segment.h"

#include <QString>

#include <optional>

namespace suffuse {

/// Writes a moment as clocks show it, to the nearest millisecond: 1:02.345.
QString clockText(Microseconds time);
/// Reads a typed moment: 1:02.345, 62.345 or, with hours, 0:01:02.345, with a decimal comma or point.
std::optional<Microseconds> timeOfClock(const QString &text);

} // namespace suffuse
