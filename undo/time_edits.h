// Changing when things happen: retiming, freezing, re-wetting, painting in the past. As in edits.h: an empty Edit where
// there is nothing to do, locked strokes left alone. What is selected are segments, or whole strokes without any.
#pragma once

#include "model/document/timelapse.h"
#include "undo/edits.h"

#include <functional>
#include <optional>

namespace suffuse {

/// Document time T to from + (T − from)·factor + by. The factor is not negative.
struct TimeMap {
    Microseconds from = 0;
    double factor = 1;
    Microseconds by = 0;

    Microseconds operator()(Microseconds T) const
    {
        return from + by + (factor == 1 ? T - from : Microseconds(std::llround(double(T - from) * factor)));
    }
};

/// Moves the births of what is selected, and when it is wetted again. For a drag: gives the strokes as they were in
/// `before` with the selection of then, whatever stands in the document now; the identity brings them back. What would
/// be painted before time 0 begins at 0, all of it later by the same.
Edit retime(const Painting &before, const Selection &selection, const TimeMap &map);

/// When the first and the last selected segment are born; empty (end before begin) where nothing can be retimed.
TimeSpan drawnSpan(const Painting &painting, const Selection &selection);
/// Births of each selected stroke, or of its segments that are selected, shifted as one so that the first of them comes
/// when `map` says of its time; so is when it is wetted again. Nothing where `map` gives none for one of them.
using BeginMap = std::function<std::optional<Microseconds>(Microseconds)>;
Edit beginAt(const Painting &before, const Selection &selection, const BeginMap &map);
/// As `retime`, so that what is selected is drawn from `begin` to `end`. What was there all at once is drawn at an even
/// pace then, each stroke over the whole time.
Edit stretch(const Painting &before, const Selection &selection, TimeSpan span);

/// How fast the pen goes along a stroke.
enum class Pace { Even, EaseIn, EaseOut, EaseInOut };
/// Births after the way along the curve, for each selected stroke, or run of its segments, between its first and last.
Edit setPace(const Document &document, Pace pace);

/// How much slower the pen is at the ends of what it draws than it was: 1 leaves it as it is, 2 is half as fast there.
struct Ease {
    static constexpr double most = 2.8; ///< times slower or faster; beyond it the pen would go back
    double atBegin = 1;
    double atEnd = 1;
};
/// Births of each selected stroke, or run of its segments, between its first and its last. For a drag, as `retime`.
Edit ease(const Painting &before, const Selection &selection, const Ease &ease);

/// All that is wet at T stops spreading then, selected or not: t_max becomes the age. What is painted or wetted later
/// is left alone.
Edit freeze(const Document &document, Microseconds T);

/// What is selected, and there at T, spreads on from T for another `extra`.
Edit rewet(const Document &document, Microseconds T, Microseconds extra);
/// What is selected is never wetted again.
Edit removeRewetting(const Document &document);
/// Whether that changes something.
bool canRemoveRewetting(const Document &document);
/// What is selected is not wetted then.
Edit removeRewetting(const Document &document, const Rewet &one);

/// Where a stroke stands that is painted at a moment of the past.
struct PlaceInTime {
    std::size_t index = 0; ///< below the stroke that is there now
    GroupId group = 0;     ///< the one that it comes to lie in
};
/// Below all strokes that were begun after `born`. Within a group it joins the group; below one that is hidden or
/// locked.
PlaceInTime placeInTime(const Painting &painting, Microseconds born);
/// The edit with the strokes that it adds on top put to their places in time instead.
Edit placedInTime(const Document &document, Edit edit);

} // namespace suffuse
