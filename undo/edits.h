// Edits as values, one function per kind. Each returns an empty Edit where there is nothing to do; locked strokes are
// left alone. The program does them by `Editor::push`.
#pragma once

#include "model/document/document.h"

#include <functional>

namespace suffuse {

/// The segments that an inspector change means: the selected ones, or all of the selected strokes without any.
std::vector<SegmentRef> targetSegments(const Document &document);

/// Applies `change` to each of the segments. A change that makes a segment invalid (`problemOf`) is dropped for it.
Edit changeSegments(const Document &document, const std::vector<SegmentRef> &targets,
                    const std::function<void(Segment &)> &change);
/// Applies `change` to strokes (name, style, mix, visible, locked, origin, segments); not their id.
Edit changeStrokes(const Document &document, const std::set<StrokeId> &targets,
                   const std::function<void(Stroke &)> &change);

/// Appends strokes on top (ids taken from the document beforehand); selects them if `select`.
Edit addStrokes(const Document &document, const std::vector<StrokePtr> &strokes, bool select);
/// What a stroke becomes of which something in the middle is taken.
enum class Leaves {
    Strokes, ///< strokes of their own, which mix over each other
    Chains   ///< one stroke of several chains: the picture stays but for what was taken
};
/// Deletes the selected segments, or the selected strokes.
Edit deleteSelection(Document &document, Leaves leaves = Leaves::Strokes);
/// Copies of the selected strokes above the topmost of them, moved by `offset`, and selects the copies. Groups selected
/// as a whole are copied as groups, with their tree and their names; what is hidden or locked in them stays out.
Edit duplicateSelection(Document &document, Point offset);

enum class Arrange { Raise, Lower, Top, Bottom };
/// Moves the selected strokes in the order: one step over the next stroke whose influence they meet (as Inkscape), or
/// to the end of it. Groups stay together.
Edit arrangeSelection(const Document &document, Arrange how);
/// Moves strokes so that they stand just below `before` (0: on top).
Edit reorder(const Document &document, const std::set<StrokeId> &strokes, StrokeId before);

Edit setCanvas(const Document &document, const Canvas &canvas);

} // namespace suffuse
