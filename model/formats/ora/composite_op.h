// The names of modes in OpenRaster's stack.
#pragma once

#include "model/painting/blend.h"

#include <QString>

#include <optional>

namespace suffuse::ora {

/// The value of composite-op for a mode: "svg:multiply" and so on. Exclusion has none, and is that of Normal.
QString compositeOp(BlendMode mode);
/// The mode that a value of composite-op stands for; no value where this program has no such mode.
std::optional<BlendMode> blendModeFrom(const QString &compositeOp);

} // namespace suffuse::ora
