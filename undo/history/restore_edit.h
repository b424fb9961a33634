// Replaces a painting by another one as a whole.
#pragma once

#include "model/document/document.h"

namespace suffuse {

/// Makes `state` the document's painting; it may be an earlier one, or any other. Strokes and parts that are equal stay
/// as they are. If all are equal, the edit is empty.
Edit restorePainting(const Document &document, const Painting &state);

} // namespace suffuse
