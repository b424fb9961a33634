#pragma once

#include "model/painting/segment.h"

#include <QString>

#include <optional>

namespace suffuse {

/// A moment as clocks show it, to the nearest millisecond: 1:02.345
QString clockText(Microseconds time);
/// A moment as it is typed: 1:02.345, 62.345 or, with hours, 0:01:02.345; a decimal comma or point.
std::optional<Microseconds> timeOfClock(const QString &text);

} // namespace suffuse
