// Fitted strokes on their way into a painting.
#pragma once

#include "app/session/fitting/fit_job.h"

namespace suffuse {

class Editor;

/// What of a painting a picture of this size is to cover: the place of the underlay, or the canvas. It lies in the
/// middle of that, as large as it fits, canvas units.
Rect areaForFit(const Painting &painting, QSizeF picture, bool onUnderlay);

/// The strokes of a fit as one group that has the picture's name, over an area of a canvas: below them lies a sheet of
/// the colour on which they were fitted. Where the area is not all of the canvas, they are clipped to the sheet, since
/// their paint would reach beyond it.
Painting layerOfFit(const FitResult &fit, const Rect &area, const Rect &canvas);

/// Puts them into the painting by `addStrokes`, in one step, with their paints as swatches. They are painted from now on,
/// one after another, after all that is there, and the painting is then seen at its end. While something has yet to dry or
/// to be painted, since a moment of the past is looked at, they were painted quickly before that moment instead, so that
/// nothing else looks otherwise. Returns what is to be said of it, or an empty string.
QString insertFit(Editor &editor, const FitResult &fit, const Rect &area);

} // namespace suffuse
