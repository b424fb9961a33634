// Merges several segments into one.
#pragma once

#include "model/painting/segment.h"

namespace suffuse {

/// A segment with the values of several (one or more): their means by length. It has the style, the rewetting and the
/// curve of the longest segment, the kind of node and the beginning of a chain of the first, and the earliest time of
/// birth.
Segment withValuesOf(const std::vector<Segment> &run);

/// A segment from the start of the first to the end of the last of several, with their tangents there. Parts of one
/// cubic become that cubic again (to float32). Otherwise its handles are as long as brings it nearest to the segments.
Segment merged(const std::vector<Segment> &run);

} // namespace suffuse
