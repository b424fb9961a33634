// Commands for the underlay. Each is an edit and one undo step.
#pragma once

#include "model/geometry/geometry.h"

#include <QString>

namespace suffuse {

class Editor;
class ValueEntry;

namespace underlay {

/// Whether a file is a picture, by its first bytes.
bool isPicture(const QString &path);
/// Puts a picture under the painting: in the middle of the canvas, as large as it fits, or in the place of the underlay
/// that was there. Returns an empty string, or why it could not.
QString importFile(Editor &editor, const QString &path);

void show(Editor &editor, bool visible);
void setOpacity(Editor &editor, double opacity, ValueEntry *entry = nullptr);
/// Moves or resizes it to an area of canvas units.
void setArea(Editor &editor, const Rect &area, ValueEntry *entry = nullptr);
/// Gives the underlay its picture's own proportions and puts it into the middle of the canvas, as large as it fits.
void fitToCanvas(Editor &editor);
void remove(Editor &editor);

} // namespace underlay
} // namespace suffuse
