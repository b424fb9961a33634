// What menus and keys do to the selection: one undo step each.
#pragma once

#include "app/editor.h"
#include "undo/edits.h"

namespace suffuse::commands {

void deleteSelected(Editor &editor);
/// Copies in place, above; the copies are selected.
void duplicateSelected(Editor &editor);
void arrangeSelected(Editor &editor, Arrange how);
void selectAll(Editor &editor);
/// First the segments, then the strokes.
void deselect(Editor &editor);
/// Moves the selected strokes by canvas units. Moves of one run are one step.
void moveSelected(Editor &editor, Point by, EditRun run);

} // namespace suffuse::commands
