#pragma once

#include "model/document/document.h"

namespace suffuse {

/// Replaces the painting's swatches; an empty Edit where they are these.
Edit setSwatches(const Document &document, const std::vector<Swatch> &swatches);

} // namespace suffuse
