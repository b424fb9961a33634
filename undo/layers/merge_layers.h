// Two layers become one, and the picture stays.
#pragma once

#include "model/document/document.h"

namespace suffuse {

/// Why a group is not merged with the one below it: nothing or no group is there, one of them is hidden or locked, or
/// the picture would change, since one is a mask, the lower one is clipped, or others are clipped to the upper one.
enum class NotMerged { Merged, NothingBelow, NoGroupBelow, Hidden, Locked, Mask, Clipped, ClippedTo };

struct MergedDown {
    Edit edit;
    GroupId below = 0; ///< the group that there is then
    NotMerged why = NotMerged::Merged;
    bool keepsGroup = false; ///< the upper one is a group within it, since its strokes alone would look different
};

/// Puts a group into the group just below it. Where neither does anything to the picture, what is in it is put there;
/// else it stays a group. Where the lower one does something, a group within it does that from then on.
MergedDown mergeDown(Document &document, GroupId group);

} // namespace suffuse
