// Strokes and layers as they are named on the command line.
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"

#include <unordered_set>

namespace suffuse::cli {

/// The strokes that "3,7,20-180" names (--select). The error is a usage error.
Result<std::unordered_set<StrokeId>> strokesNamed(const QString &text, const Painting &painting);
/// The group of a name (--layer), of which there must be one. The error is a usage error.
Result<GroupId> layerNamed(const QString &name, const Painting &painting);

} // namespace suffuse::cli
