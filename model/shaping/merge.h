// Several segments that become one.
#pragma once

#include "model/painting/segment.h"

namespace suffuse {

/// One segment with the values of several, one or more: means by length; style and rewetting are the longest one's, the
/// node's kind the first's, and so is whether it begins a chain, the time of birth the earliest. The curve is the
/// longest one's.
Segment withValuesOf(const std::vector<Segment> &run);

/// One segment from the start of the first to the end of the last with their tangents there. Parts of one cubic become
/// that cubic (to float32); else it comes as near to them as handles of some length can.
Segment merged(const std::vector<Segment> &run);

} // namespace suffuse
