// Ends of strokes with which a tool can go on.
#pragma once

#include "model/geometry/geometry.h"
#include "model/painting/stroke_places.h"

#include <optional>

namespace suffuse {

class CanvasWidget;
struct Painting;

/// The end of a chain of a selected stroke that is not locked, within 8 logical pixels of a place in device pixels.
std::optional<NodeRef> selectedEndAt(const CanvasWidget &canvas, const Painting &painting, Point pixel);

} // namespace suffuse
