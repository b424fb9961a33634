// Makes one edit of the way back from several that were exchanged one after the other.
#pragma once

#include "model/document/edit.h"

namespace suffuse {

/// Whether exchanging an edit that was exchanged before would change nothing but the selection. It compares values.
bool changesNothing(const Edit &back, const Painting &painting);

/// Extends the way back. `back` led from the painting before `newer` was exchanged to an older one; afterwards it leads
/// there from `now`, the painting after. Each part keeps its oldest state.
void extendBack(Edit &back, Edit newer, const Painting &now);

} // namespace suffuse
