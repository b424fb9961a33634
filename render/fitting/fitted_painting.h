// A painting of fitted strokes, and back.
#pragma once

#include "model/painting/painting.h"
#include "render/fitting/fit_stroke.h"

namespace suffuse::fitting {

/// Strokes of a fit, and what they are drawn on.
struct FittedStrokes {
    std::vector<FitStroke> strokes;
    StyleKind style = StyleKind::Feathering;
    Colour background{0, 0, 0, 1};
    std::vector<std::size_t> births = {}; ///< when each is painted, from 0 on; empty: from the back to the front
};

/// The painting: strokes from the back to the front, one after another in time (`births`), on a canvas of the target's size. Its
/// numbers are rounded to what files hold. `paints` become linked swatches.
Painting paintingOf(const FittedStrokes &fitted, const FitTarget &target, const std::vector<Colour> &paints = {});

/// The strokes of a painting that a fit can go on with: three joined segments each, of one width, style and colour.
/// The error says which stroke is another one, and why.
Result<FittedStrokes> fittedStrokesOf(const Painting &painting, const FitTarget &target);

} // namespace suffuse::fitting
