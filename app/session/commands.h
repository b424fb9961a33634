// What menus and keys do to the selection: one undo step each.
#pragma once

#include "app/session/editor.h"
#include "undo/group_edits.h"
#include "undo/transform_edits.h"

namespace suffuse::commands {

void deleteSelected(Editor &editor);
/// Copies in place, above; the copies are selected.
void duplicateSelected(Editor &editor);
void arrangeSelected(Editor &editor, Arrange how);
void selectAll(Editor &editor);
/// All that can be selected and is not.
void invertSelection(Editor &editor);
void selectSameAs(Editor &editor, Same what);
/// First the segments, then the strokes.
void deselect(Editor &editor);
/// Moves the strokes by canvas units. Moves of one run are one step.
void moveStrokes(Editor &editor, const std::set<StrokeId> &strokes, Point by, EditRun run);
/// About the middle of the selection.
void flipSelected(Editor &editor, Axis axis, SpreadRule rule);
/// Quarters of a turn, clockwise, about the middle of the selection.
void quarterTurnSelected(Editor &editor, int quarters, SpreadRule rule);
void alignSelected(Editor &editor, Align how, AlignTo to, StrokeId anchor);
void distributeSelected(Editor &editor, Axis axis, Spacing spacing);

void groupSelected(Editor &editor);
void ungroupSelected(Editor &editor);
/// What is locked or hidden is not selected any more.
void lockSelected(Editor &editor);
void hideSelected(Editor &editor);
void unlockAllStrokes(Editor &editor);
void showAllStrokes(Editor &editor);
/// The group that is selected as a whole, or else each selected stroke.
void renameSelected(Editor &editor, const QString &name);

} // namespace suffuse::commands
