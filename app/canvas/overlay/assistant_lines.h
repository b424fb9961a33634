// Draws assistants: faintly the lines that strokes may follow, and what they are made of more clearly.
#pragma once

#include "app/canvas/overlay/overlay.h"
#include "model/geometry/assistant.h"

#include <vector>

namespace suffuse {

/// Draws all of them.
void paintAssistants(QPainter &painter, const std::vector<Assistant> &assistants, const View &view,
                     const OverlayColours &colours, double dpr);

/// Draws the line or the ellipse that a stroke follows.
void paintTrack(QPainter &painter, const AssistantTrack &track, const View &view, const OverlayColours &colours,
                double dpr);

/// What of an assistant can be taken hold of beside its points, in device pixels: the line of a ruler between its
/// points, the sides of a perspective, the ellipse.
QPainterPath bodyOf(const Assistant &assistant, const View &view);

} // namespace suffuse
