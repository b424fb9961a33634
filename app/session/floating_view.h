// Who shows strokes afloat while a gesture maps them as a whole: the canvas, of which the session knows no more.
#pragma once

#include "model/painting/segment.h"
#include "model/shaping/transform.h"

#include <set>

namespace suffuse {

/// Pictures of some strokes and of the rest of the painting, made ready when the strokes are lifted. Frames of a
/// gesture can then be composed of the two, and the document need not have what they show.
class FloatingView {
public:
    virtual ~FloatingView() = default;

    /// Strokes that a gesture is about to map: where its frames would be slow, they are lifted off the painting as it
    /// is now.
    virtual void lift(const std::set<StrokeId> &strokes) = 0;
    virtual void endLift() = 0;
    /// Whether what was lifted is still what is there: the same painting, moment and view.
    virtual bool isLifted() const = 0;
    /// Shows what is lifted as it lies under a map, in canvas units, which the document has not heard of.
    virtual void showFloating(const Affine &map) = 0;
    /// The document has now what floats: the exact picture follows.
    virtual void settleFloating() = 0;
    /// Whether under the map all shows that could: what lay far outside of the view is in no picture.
    virtual bool coversFloating(const Affine &map) const = 0;
};

} // namespace suffuse
