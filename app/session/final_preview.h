#pragma once

#include "model/painting/painting.h"

#include <unordered_map>

namespace suffuse {

/// The painting as it will look when what is wet has dried.
class FinalPreview {
public:
    /// A painting that at T shows all that is painted by then at its full age. Strokes that are dry at T are shared.
    PaintingPtr of(const PaintingPtr &painting, Microseconds T);

private:
    std::unordered_map<StrokePtr, StrokePtr> m_dried; ///< of strokes that are wet but painted to the end
};

} // namespace suffuse
