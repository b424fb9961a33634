// Cut, copy and paste. Between paintings they are exact; other programs give and get pictures, curves and colours.
#pragma once

#include "app/session/files/import_strokes.h"
#include "model/painting/painting.h"
#include "model/painting/selection.h"

#include <QMimeData>

namespace suffuse {

class Editor;

namespace clipboard {

/// Type of the selected strokes (or runs of selected segments), as a painting in the text form.
inline constexpr char strokesMime[] = "application/x-suffuse-strokes+json";

/// Type of how many canvas units an inch of their painting's paper has, in digits, where it says it.
inline constexpr char resolutionMime[] = "application/x-suffuse-resolution";

/// The selection as a painting of its own, with the groups of which it has several members, or all. It has no strokes
/// if nothing is selected.
Painting asPainting(const Painting &painting, const Selection &selection);

/// Offers strokes in every form that other programs understand. PNG (transparent, 1 pixel a unit, at most 4,096 a
/// side), SVG and PDF are made only when somebody asks for them. `time` is the moment of the picture. Further formats
/// can be set on the result. `resolution`: canvas units an inch of its paper; 0: it is not said.
QMimeData *mimeOf(Painting painting, Microseconds time, double resolution = 0);

/// Whether `paste` may find something in the data, judged by their formats alone: asking for contents could make the
/// window wait.
bool canPaste(const QMimeData *data);

/// All return an empty string, or what other programs do not get, or why nothing is copied. Nothing is cut that could
/// not be pasted.
QString copy(Editor &editor);
QString copy(Editor &editor, const Selection &selection);
QString cut(Editor &editor);
/// Strokes and SVG paths become new strokes on top, selected (`addStrokes`), and a picture an image layer. A colour
/// becomes the current colour. Strokes of a painting that says how large it is on paper are as large on that of another
/// one that says it (`atRealSize`).
/// Returns an empty string, or what could not be pasted and why, which includes the parts of an SVG drawing that
/// strokes cannot show.
QString paste(Editor &editor, const QMimeData &data, const Landing &landing);

} // namespace clipboard

} // namespace suffuse
