// Texts that follow the curve of a stroke, whatever becomes of it.
#pragma once

#include "model/document/document.h"
#include "undo/lettering/laid_text.h"

#include <functional>
#include <optional>
#include <span>
#include <unordered_map>

namespace suffuse {

/// Whether a text that is not among some follows one of these strokes, so that it changes with them.
bool leadsOtherTexts(const Painting &painting, const std::map<GroupId, Text> &texts,
                     const std::function<bool(StrokeId)> &isAmong);

/// Sets a text; no value where there are no fonts.
using LayText = std::function<std::optional<LaidText>(const Text &)>;

/// Completes an edit by what becomes of texts, before it is done; whoever does edits calls this for each. Texts follow
/// their letters (`followTexts`). Texts whose strokes it moves or reshapes are set along them anew, and texts whose
/// strokes it removes follow none. A text that it maps itself stays where it is then, and follows its stroke from
/// there. Locked texts (`isTextLocked`), and those that cannot be set, stay, and letters of texts lead none. `before`
/// is the painting that the edit is meant for.
void completeTexts(const Painting &before, Edit &edit, const LayText &lay);
/// The same for another program's work on a painting: what it makes of `before` is `after`.
Painting withTextsCompleted(const Painting &before, const Painting &after, const LayText &lay);

/// Makes texts that are copies follow the copies of the strokes that their originals follow, which were moved with
/// them, or none where those were not copied.
void linkCopies(std::span<Group> groups, const std::unordered_map<StrokeId, StrokeId> &copies, Point by = {});

/// Lets the texts of which something is selected follow no stroke any more. They keep their curves.
Edit releaseTexts(const Document &document);
/// Whether it would do something.
bool canReleaseTexts(const Document &document);

/// Makes plain groups of the texts of which something is selected: their letters cannot be typed in any more.
Edit textsToStrokes(const Document &document);
/// Whether it would do something.
bool canTurnTexts(const Document &document);

} // namespace suffuse
