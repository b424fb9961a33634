// What bench_editing measures.
#pragma once

#include "tests/bench/editing/editing_report.h"

#include <set>

namespace suffuse {

/// The segment whose middle lies nearest to the middle of the canvas, of a stroke with some on either side.
SegmentRef middleSegment(const Painting &painting);
std::set<StrokeId> firstStrokes(const Painting &painting, std::size_t count);

// Of the rows that may be many, only those whose names have `wanted` in them.
Report measureDrags(EditingSession &session, int events, const QString &wanted);
Report measureViews(EditingSession &session, int events);
Report measureSelecting(EditingSession &session, int events, const QString &wanted);
/// Knife, push and eraser, a node of one of all strokes, which are selected, and a push of one stroke of 10,000
/// segments.
Report measureTools(EditingSession &session, int events, const QString &wanted);
/// The eraser on one stroke of 600 segments, and whole frames of it with and without lifting segments.
Report measureErasing(EditingSession &session, int events, const QString &wanted);
/// A letter that comes and goes in a text of 2,000, and such a text taken into the hand.
Report measureTyping(EditingSession &session, int events, const QString &wanted);
/// By kind of edit: in the call of the undo stack, and until the frame is on the screen.
Report measureUndo(EditingSession &session, int times, const QString &wanted);
/// Bytes that a step of the undo stack keeps; the window's own caches left out.
Report measureMemory(const Painting &painting, int steps);

} // namespace suffuse
