// Edits as values, with a function for each kind. A function returns an empty Edit if there is nothing to do, and
// leaves locked strokes alone. The program does edits by `Editor::push`.
#pragma once

#include "model/document/document.h"

#include <functional>

namespace suffuse {

/// The segments that an inspector change means: the selected ones, or without any those of the selected strokes that lay
/// paint. What takes paint away keeps its values unless it is selected, or the stroke has nothing else.
std::vector<SegmentRef> targetSegments(const Document &document);

/// Applies `change` to each of the segments. If a segment becomes invalid (`problemOf`), it stays as it was.
Edit changeSegments(const Document &document, const std::vector<SegmentRef> &targets,
                    const std::function<void(Segment &)> &change);
/// The same for a change that counts from an earlier painting, as a drag does from where it began: `change` gets the
/// segment as it is and as it was in `before`. Strokes that have another number of segments now are left alone.
Edit changeSegmentsSince(const Document &document, const Painting &before, const std::vector<SegmentRef> &targets,
                         const std::function<void(Segment &now, const Segment &then)> &change);
/// Applies `change` to strokes. It may set their name, style, mix, visibility, lock, origin and segments, but not their
/// id.
Edit changeStrokes(const Document &document, const std::set<StrokeId> &targets,
                   const std::function<void(Stroke &)> &change);

/// A text that lies elsewhere, or none where there is none.
SharedText moved(const SharedText &text, Point by);
/// Adds strokes on top, and selects them if `select`. Their ids must have been taken from the document.
Edit addStrokes(const Document &document, const std::vector<StrokePtr> &strokes, bool select);
/// What becomes of a stroke when something in its middle is removed.
enum class Leaves {
    Strokes, ///< The parts are strokes of their own, which mix over each other.
    Chains   ///< The parts are chains of one stroke, so the rest of the picture stays.
};
/// Deletes the selected segments, or the selected strokes. With `Chains`, strokes of which something is left stay
/// selected.
Edit deleteSelection(Document &document, Leaves leaves = Leaves::Strokes);
/// Puts copies of the selected strokes above the topmost of them, moved by `offset`, and selects the copies. Groups
/// that are selected as a whole are copied as groups, with the tree in them and their names, but without what is hidden
/// or locked in them. Of a stroke of which segments are selected, they alone are copied, as a stroke. Where they take
/// paint away, they are doubled within their stroke, and their copies are selected.
Edit duplicateSelection(Document &document, Point offset);

enum class Arrange { Raise, Lower, Top, Bottom };
/// Moves the selected strokes in the order: one step past the next stroke whose influence they meet (as in Inkscape),
/// or to the end of the order. Groups stay together.
Edit arrangeSelection(const Document &document, Arrange how);
/// Moves strokes to the place just below `before`, or on top of all if it is 0.
Edit reorder(const Document &document, const std::set<StrokeId> &strokes, StrokeId before);

/// Sets the canvas.
Edit setCanvas(const Document &document, const Canvas &canvas);

} // namespace suffuse
