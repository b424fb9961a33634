// The menu at a point of the canvas.
#pragma once

#include "model/geometry/geometry.h"
#include "model/painting/selection.h"

#include <vector>

class QMenu;

namespace suffuse {

struct Workplace;

/// The strokes that paint at a point, from the top down, at most so many canvas units beside hairlines.
std::vector<SegmentRef> strokesAt(const Workplace &place, Point point);

/// Fills a menu: the strokes that were found, of which each can be selected, and what can be done with the selection by
/// the tool in use, or, where nothing is selected, with the canvas. Only what can be used now is in it.
void fillCanvasMenu(QMenu &menu, const Workplace &place, const std::vector<SegmentRef> &found, Point point);

/// Fills a menu with what can be done with rulers: what they count, and their guides.
void fillRulerMenu(QMenu &menu, const Workplace &place);

} // namespace suffuse
