// Finds small texts under the pointer by their lines, since nobody hits letters of a few pixels.
#pragma once

#include "model/painting/painting.h"
#include "model/painting/selection.h"
#include "render/view.h"
#include "undo/lettering/text_layout.h"

#include <optional>

namespace suffuse {

/// The topmost text whose letters look smaller than `mostEm` device pixels and in one of whose lines, or within
/// `tolerance` canvas units of it, the point lies: its letter that is nearest to the point. Only letters that can be
/// selected at T count.
std::optional<SegmentRef> pickSmallText(const Painting &painting, Microseconds T, const View &view, double mostEm,
                                        Point point, double tolerance, TextLayout &layout);

} // namespace suffuse
