#pragma once

#include "model/painting/painting.h"

#include <unordered_map>

namespace suffuse {

/// Shows the painting as it will look when all wet paint has dried.
class FinalPreview {
public:
    /// Returns a painting that shows at T everything painted by then at its full age. It shares the strokes that are
    /// dry at T.
    PaintingPtr of(const PaintingPtr &painting, Microseconds T);

private:
    /// The dried forms of strokes that are wet and finished.
    std::unordered_map<StrokePtr, StrokePtr> m_dried;
};

} // namespace suffuse
