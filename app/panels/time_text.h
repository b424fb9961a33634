#pragma once

#include "model/segment.h"

#include <QString>

namespace suffuse {

/// A moment as clocks show it: 1:02.345
QString clockText(Microseconds time);

} // namespace suffuse
