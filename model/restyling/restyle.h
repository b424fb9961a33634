// A brush is put on a stroke that was painted with another one.
#pragma once

#include "model/restyling/pen_memory.h"

namespace suffuse {

/// What of the brush a stroke takes: all of it; how wide it is and how it runs (spread, density, tapering, tip); its
/// colour with its opacity; or how the paint looks (style, mixing, grain, drying time).
enum class BrushPart { Whole, Form, Colour, Texture };

struct Restyle {
    Brush brush;
    BrushPart part = BrushPart::Whole;
    const Brush *painted = nullptr; ///< the brush that painted the stroke; null if it is not known
    StrongestPaint strongest;       ///< of the strokes that are restyled together
};

/// The stroke as if it had been painted with the brush by the pen that it remembers (`penOf`). Curves and times stay.
/// Segments that are longer than what the brush lays down varies in are split. `chosen`: for each segment whether it is
/// meant; empty: all are, and then the stroke takes style, mixing and the brush's name as a whole. What takes paint
/// away stays as it is. A fill takes what the brush lays at full pressure, as far as a fill has such values, where all of
/// the stroke is meant, or nothing but what bounds the fill; that goes on laying no paint. `sources` gets, for each segment of the result, the index of the one that it came from.
Stroke restyled(const Stroke &stroke, const Restyle &how, const std::vector<bool> &chosen, std::vector<int> *sources);

} // namespace suffuse
