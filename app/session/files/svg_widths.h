#pragma once

#include "model/painting/painting.h"

#include <vector>

namespace suffuse {

/// A segment as the line that stands for it in other programs.
struct SvgLine {
    Point from, to;   ///< its ends, canvas units
    double half = 0;  ///< half of the width at which it is seen alone
    double reach = 0; ///< half of the width at which it is seen where as much again is beside it
};

/// Half of the width of each line. Paint adds up: rows of a hatching are seen as one area though none is as wide alone.
/// So a line grows to the middle between itself and a line beside it, where the paint of both is seen there.
std::vector<double> joinedHalfWidths(const std::vector<SvgLine> &lines);

} // namespace suffuse
