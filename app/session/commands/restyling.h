// Commands that give the selected strokes another look: that of a brush, of another stroke, or one that strays.
#pragma once

#include "app/session/editor.h"
#include "undo/restyle_edits.h"

namespace suffuse::commands {

/// Puts the brush in hand, or a part of it, on the selection, as one step. Returns why nothing was done, or nothing.
QString applyBrushInHand(Editor &editor, BrushPart part);

/// Copies the appearance of a stroke, or of its selected segments. It is kept while the program runs, for all
/// paintings.
void copyAppearance(Editor &editor, StrokeId stroke);
/// The appearance that was copied last, if any.
const std::optional<Appearance> &copiedAppearance();
/// Puts it on the selection, as one step. Returns why nothing was done, or nothing.
QString pasteAppearance(Editor &editor, Variation variation);

/// The amounts of variation that were used last.
VaryAmounts storedVariation();
void storeVariation(const VaryAmounts &amounts);

} // namespace suffuse::commands
