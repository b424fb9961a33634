// Edits that give paint other colours. As in edits.h: they are empty where there is nothing to do.
#pragma once

#include "model/colour/colour_uses.h"
#include "model/document/document.h"

#include <functional>

namespace suffuse {

/// What becomes of a colour.
using ColourMap = std::function<Colour(const Colour &)>;

/// Gives the segments and fills of the parts the colours that the map makes of those which they have there, whatever colours
/// stand in the document now: so a drag and a dialog can show one try after the other. Strokes that have lost or gained
/// segments since are left alone, and so are locked ones.
Edit recolour(const Document &document, const ColourParts &parts, const ColourMap &map);

/// Gives a swatch another colour. `users` are the parts that follow it, locked ones, too; each keeps its opacity. See
/// `usersOf`.
Edit changeSwatch(const Document &document, std::size_t swatch, const Colour &to, const ColourParts &users);
/// What uses a linked swatch of the painting; nothing uses one that is not linked.
ColourParts usersOf(const Painting &painting, std::size_t swatch);

} // namespace suffuse
