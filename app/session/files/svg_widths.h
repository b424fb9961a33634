#pragma once

#include "model/painting/painting.h"

#include <vector>

namespace suffuse {

/// A segment as the straight line that stands for it in other programs.
struct SvgLine {
    Point from, to;   ///< its ends, canvas units
    double half = 0;  ///< half of the width that is seen where it lies alone
    double reach = 0; ///< half of the width that is seen where an equal line lies beside it
};

/// Half of the width of each line. Paint adds up: the rows of a hatching are seen as one area, though no row is as wide
/// alone. So a line grows to the middle between itself and a line beside it, where the paint of both together is seen.
std::vector<double> joinedHalfWidths(const std::vector<SvgLine> &lines);

} // namespace suffuse
