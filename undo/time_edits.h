// Edits that change when things happen: retiming, freezing, re-wetting, painting in the past. A function returns an
// empty Edit if there is nothing to do, and leaves locked strokes alone. The selection means its segments or, without
// any, its whole strokes.
#pragma once

#include "model/document/timelapse.h"
#include "undo/edits.h"

#include <functional>
#include <optional>

namespace suffuse {

/// Moves the births of the selection by a time, and the times at which it is wetted again: what erases it goes along.
/// For drags, it makes the strokes from those in `before` and the selection of then, whatever the document has now; so
/// 0 brings them back. If something would be painted before time 0, it begins at 0, and all of it is later by the same
/// time.
Edit retime(const Painting &before, const Selection &selection, Microseconds by);

/// What the selection draws: its segments that lay paint. A stroke of which only erasures are selected is drawn by
/// these. All else that is called the drawing here means that; what was erased softly keeps its time where the drawing
/// is changed, but never comes before the stroke is begun.
///
/// When the first and the last segment of the drawing are born; empty (its end before its begin) where nothing can be
/// retimed.
TimeSpan drawnSpan(const Painting &painting, const Selection &selection);
/// Shifts the births of each selected stroke, or of its selected segments, by one time, so that its drawing begins at
/// the time to which the map takes its begin. Erasures go along, and times of wetting are shifted, too. Nothing changes
/// if the map has no value for one of them.
using BeginMap = std::function<std::optional<Microseconds>(Microseconds)>;
Edit beginAt(const Painting &before, const Selection &selection, const BeginMap &map);
/// Makes the selection be drawn during `span`. Segments that all appeared at once are then drawn at an even pace, each
/// stroke in the whole time. It is meant for drags, as `retime` is.
Edit stretch(const Painting &before, const Selection &selection, TimeSpan span);

/// How fast the pen goes along a stroke.
enum class Pace { Even, EaseIn, EaseOut, EaseInOut };
/// Sets the births along each selected stroke, or run of its segments, between its first and last birth.
Edit setPace(const Document &document, Pace pace);

/// How much slower than before the pen is at the ends of what it draws: 1 leaves it as it is, 2 makes it half as fast
/// there.
struct Ease {
    /// The pen is at most so many times slower or faster; beyond that it would have to go back.
    static constexpr double most = 2.8;
    double atBegin = 1;
    double atEnd = 1;
};
/// Eases the births of each selected stroke, or run of its segments, between its first and last birth. It is meant for
/// drags, as `retime` is.
Edit ease(const Painting &before, const Selection &selection, const Ease &ease);

/// Stops the spreading of all that is wet at T, selected or not: t_max becomes the age. What is painted or wetted later
/// is left alone.
Edit freeze(const Document &document, Microseconds T);

/// Wets again, at T and for the time `extra`, the selected segments that are there at T.
Edit rewet(const Document &document, Microseconds T, Microseconds extra);
/// Removes all wetting again from the selection.
Edit removeRewetting(const Document &document);
/// Whether that would change something.
bool canRemoveRewetting(const Document &document);
/// Removes one time of wetting again from the selection.
Edit removeRewetting(const Document &document, const Rewet &one);

/// The place of a stroke that is painted at a moment of the past.
struct PlaceInTime {
    std::size_t index = 0; ///< The stroke comes below the one that has this index now.
    GroupId group = 0;     ///< the group that it joins
};
/// The place below all strokes that were begun after `born`. Between members of a group it joins the group; if that is
/// hidden or locked, it goes below it.
PlaceInTime placeInTime(const Painting &painting, Microseconds born);
/// The edit with the strokes that it adds on top put to their places in time instead. Those of a group that it adds, as
/// of a text, stay together.
Edit placedInTime(const Document &document, Edit edit);

} // namespace suffuse
