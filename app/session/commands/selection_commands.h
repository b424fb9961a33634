// What menus and keys do to the selection. Each command is one undo step.
#pragma once

#include "app/session/editor.h"
#include "undo/layers/group_edits.h"
#include "undo/layers/group_roles.h"
#include "undo/transform_edits.h"

namespace suffuse::commands {

/// Whether something is selected, or the layer has no stroke.
bool canDelete(const Editor &editor);
/// Deletes what is selected, or else the layer if it has no stroke. Where the layer is deleted as a whole, the one
/// beside it is the layer. Returns what to say of it; an empty text if nothing could be deleted.
QString deleteSelected(Editor &editor);
/// What to say where something is to be deleted that nobody sees to be selected.
QString unseenSelection(const Editor &editor);
/// Copies the selected strokes, or the selected segments of them, in place, above them; erasures are doubled within
/// their stroke. Then the copies are selected. Returns what to say of erasures, which are seen to take more and
/// not to be two.
QString duplicateSelected(Editor &editor);
/// Raises or lowers the selected strokes. Returns what to say: the keys are single ones, and a painting tool shows no
/// selection.
QString arrangeSelected(Editor &editor, Arrange how);
void selectAll(Editor &editor);
/// Selects all strokes that can be selected and are not.
void invertSelection(Editor &editor);
void selectSameAs(Editor &editor, Same what);
/// Deselects the segments; where none are selected, the strokes.
void deselect(Editor &editor);
/// Moves the strokes by canvas units. Moves of one run are one step.
void moveStrokes(Editor &editor, const std::set<StrokeId> &strokes, Point by, ValueEntry *entry);
/// Mirrors the selection about its middle. Returns what to say, as above.
QString flipSelected(Editor &editor, Axis axis, SpreadRule rule);
/// Turns the selection about its middle, clockwise, by so many quarters of a turn.
void quarterTurnSelected(Editor &editor, int quarters, SpreadRule rule);
/// Both return an empty string, or why there is nothing to be done.
QString alignSelected(Editor &editor, Align how, AlignTo to, StrokeId anchor);
QString distributeSelected(Editor &editor, Axis axis, Spacing spacing);

void groupSelected(Editor &editor);
void ungroupSelected(Editor &editor);
/// Gives a role to the groups that are selected as a whole and can have it. Where all of those have it, it takes it
/// from them.
void toggleSelectedRole(Editor &editor, GroupRole role);
/// Returns why nothing was done, or nothing.
QString combineSelected(Editor &editor);
/// Returns what has become of the strokes.
QString breakSelectedApart(Editor &editor);
/// Of the selected segments, or of the selected strokes without any.
void removeSelectedErasures(Editor &editor);
/// Both deselect the strokes that they lock or hide.
void lockSelected(Editor &editor);
void hideSelected(Editor &editor);
/// What has been hidden by itself is not moved or deleted unseen.
void deselectHidden(Editor &editor);
void unlockAllStrokes(Editor &editor);
void showAllStrokes(Editor &editor);
/// Names the group that is selected as a whole, or else each selected stroke.
void renameSelected(Editor &editor, const QString &name);

} // namespace suffuse::commands
