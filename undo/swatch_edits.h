#pragma once

#include "model/document/document.h"

namespace suffuse {

/// Replaces the painting's swatches. The edit is empty if they are equal.
Edit setSwatches(const Document &document, const std::vector<Swatch> &swatches);

} // namespace suffuse
