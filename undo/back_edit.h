// The way back from several edits that were exchanged one after the other, as one edit.
#pragma once

#include "model/document/edit.h"

namespace suffuse {

/// Whether exchanging an edit that was exchanged before would change nothing but the selection. Compares values.
bool changesNothing(const Edit &back, const Painting &painting);

/// `back` led from the painting before `newer` was exchanged to an older one; now it leads there from `now`, the
/// painting after. Each part keeps its oldest state.
void extendBack(Edit &back, Edit newer, const Painting &now);

} // namespace suffuse
