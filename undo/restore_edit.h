// A whole painting put in another one's place.
#pragma once

#include "model/document/document.h"

namespace suffuse {

/// Makes the document's painting `state`, an earlier one of it or any other. Strokes and parts that are equal stay as
/// they are. Empty where all is.
Edit restorePainting(const Document &document, const Painting &state);

} // namespace suffuse
