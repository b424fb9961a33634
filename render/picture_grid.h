// The grid of pixels in which a picture lies, so that pictures that overlap pixel by pixel agree to the bit.
#pragma once

#include "render/view.h"

namespace suffuse {

/// Where a picture lies in a grid of pixels. Everything that is computed for a pixel is computed in coordinates of the
/// grid, so a pixel has the same bits in every picture that lies in the same grid: in a crop of a picture, or when the
/// canvas has been moved by whole pixels.
struct PictureGrid {
    View view;         ///< maps canvas units to pixels of the grid, by toPixels; its size is no one's
    PixelRect picture; ///< the pixels of the picture
    /// The pixels for which strokes are prepared. Its borders are multiples of windowStep, and so it is the same for
    /// many pictures that lie near each other.
    PixelRect window;

    static constexpr int windowStep = 256;

    /// The grid of the document: all views of one scale, rotation and mirroring share it if they lie apart by whole
    /// pixels. It is moved by a multiple of 2^-20 pixels from the canvas' origin. Where the view lies so far from the
    /// origin that doubles have fewer digits than that, the picture has a grid of its own.
    static PictureGrid ofDocument(const View &view);
    /// A grid for this picture alone, whose first pixel is (0, 0).
    static PictureGrid ofPicture(const View &view);

    /// The same grid with a part of the picture in it. Strokes are prepared for `near`, which lies around the part. All
    /// in pixels of the picture.
    PictureGrid part(const PixelRect &pixels, const PixelRect &near) const;

    bool sameGrid(const PictureGrid &other) const { return view == other.view; }
    /// Whether strokes that were prepared for the other one are prepared for this one.
    bool samePlace(const PictureGrid &other) const { return view == other.view && window == other.window; }
};

} // namespace suffuse
