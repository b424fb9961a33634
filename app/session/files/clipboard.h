// Cut, copy and paste: between paintings exactly, to and from others as pictures, curves and colours.
#pragma once

#include "model/painting/painting.h"
#include "model/painting/selection.h"

#include <QMimeData>

#include <optional>

namespace suffuse {

class Editor;

namespace clipboard {

/// The selected strokes (or runs of selected segments) as a painting in the text form.
inline constexpr char strokesMime[] = "application/x-suffuse-strokes+json";

/// What is selected, as a painting of its own, with the groups that its strokes are in; no strokes if nothing is.
Painting asPainting(const Painting &painting, const Selection &selection);

/// Strokes in every form that others understand; PNG (transparent, 1 pixel a unit, at most 4,096 a side) and SVG are
/// made when somebody asks for them. `time`: the moment of the picture.
/// Further formats can be set on it.
QMimeData *mimeOf(Painting painting, Microseconds time);

/// Whether `paste` may find something in it, by its formats alone: asking for contents could make the window wait.
bool canPaste(const QMimeData *data);

void copy(Editor &editor);
void cut(Editor &editor);
/// Strokes and SVG paths become new strokes on top, selected (`addStrokes`). A colour becomes the current colour. Empty,
/// or what could not be pasted and why: of SVG also what strokes cannot show.
QString paste(Editor &editor, const QMimeData &data, std::optional<Point> centre);

} // namespace clipboard

} // namespace suffuse
