// What is done with the underlay: each an edit, one undo step.
#pragma once

#include "undo/edit_command.h"

#include <QString>

namespace suffuse {

class Editor;

namespace underlay {

/// By its first bytes.
bool isPicture(const QString &path);
/// Puts a picture under the painting: in the middle of the canvas, as large as it goes, or where the picture is that it
/// takes the place of. Empty, or why not.
QString importFile(Editor &editor, const QString &path);

void show(Editor &editor, bool visible);
void setOpacity(Editor &editor, double opacity, EditRun run);
/// Moves or resizes it to an area of canvas units.
void setArea(Editor &editor, const Rect &area, EditRun run = 0);
/// Its picture's own proportions, in the middle of the canvas, as large as it goes.
void fitToCanvas(Editor &editor);
void remove(Editor &editor);

} // namespace underlay
} // namespace suffuse
