// Edits of the areas that fills cover. As in edits.h: they are empty where there is nothing to do. What is locked,
// hidden or not filled is left alone.
#pragma once

#include "model/document/document.h"
#include "model/shaping/area_strokes.h"

namespace suffuse {

/// Why an edit of areas came to nothing.
enum class AreaProblem {
    None,
    TooFew,   ///< too few areas, or no lines, are selected
    Empty,    ///< nothing would be left that can be stored
    TooMuch,  ///< the outlines meet so often that it would take minutes
    Uncertain ///< the outlines lie on each other in such a way that no result can be trusted
};

/// The selected strokes that are filled and can be changed, from bottom to top.
std::vector<StrokePtr> selectedAreas(const Document &document);
/// Whether there are at least so many of them.
bool hasSelectedAreas(const Document &document, int least);

/// The set of the areas of the selected strokes, counted from the lowest one, takes the place of the lowest one with
/// its fill, and is selected; the others go. Pieces of outlines keep their values. The lowest one keeps what takes
/// paint away from it; where the areas of others come to it, so does what takes paint away from them. Parts of a
/// division that do not touch are strokes of their own. Where there is a problem, the edit is empty.
Edit combineAreas(Document &document, AreaSet how, AreaProblem *problem = nullptr);

/// Moves the outlines of the selected areas outwards by a distance in canvas units, or inwards where it is negative.
/// Corners stay corners, but for sharp ones.
Edit offsetAreas(const Document &document, double by, AreaProblem *problem = nullptr);

/// Makes filled strokes of what is seen of the lines of the selected strokes when they are dry, in their places. A
/// filled stroke keeps its fill, and the area of its line becomes a stroke above it.
Edit linesToAreas(Document &document, AreaProblem *problem = nullptr);

} // namespace suffuse
