// What the inspector's first line says.
#pragma once

#include "app/panels/inspector/inspected.h"

#include <QString>

namespace suffuse {

/// How many strokes and segments are inspected, and how many of these take paint away. `inPart`: segments are selected.
QString selectionSummary(const Inspected &inspected, bool inPart);

} // namespace suffuse
