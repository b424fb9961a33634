// The bands of a stroke as steps of grey, for formats that see a colour through a mask.
#pragma once

#include "render/drawing/path_drawing.h"

namespace suffuse {

/// From a sheet that is as light as the most opaque band, each band takes outside of itself what it has more than the
/// one around it. So a pixel that several contours cross gets the mean of what they part.
struct BandMask {
    enum class Put : std::uint8_t {
        Outside, ///< takes the level from what lies outside of the band
        Inside,  ///< takes it from what lies inside
        Over     ///< has the level inside, whatever was there
    };
    struct Step {
        const contours::Loops *loops = nullptr; ///< of the drawing
        Put put = Put::Outside;
        int level = 0;   ///< of 255
        double bend = 0; ///< how far its curves may lie from lines, canvas units
    };
    Rect box;      ///< beyond which nothing is seen, with whole numbers; canvas units
    int sheet = 0; ///< the level of the sheet
    std::vector<Step> steps;
};

/// The mask of a stroke with several bands of a drawing that has full opacity in so many.
BandMask bandMaskOf(const DrawnStroke &drawn, int bandCount);

/// How much wider than its paths what is seen through a mask is, canvas units.
inline constexpr double paintMargin = 1;

} // namespace suffuse
