// What an imported picture becomes.
#pragma once

#include "model/geometry/affine.h"
#include "model/painting/stroke.h"

namespace suffuse {

/// A stroke that shows all of a picture and nothing else: a rectangle that is filled with it up to a crisp edge, and is
/// there at once. `place` maps the picture's pixels, (0, 0) at its top left corner, to the canvas; the picture has its
/// size and its image. At `seen` it is dry. The stroke has no id and no group.
Stroke pictureStroke(Picture picture, const Affine &place, Microseconds seen);

/// The same in an area of the canvas with sides along its axes.
Stroke pictureStroke(Picture picture, const Rect &area, Microseconds seen);

/// A picture of an image that the painting is to have, with the size that it has upright.
Picture embeddedPicture(EncodedImage image, int width, int height);

/// The picture over the same place as before, with another image of another size: its top left corner, its direction
/// and its width stay, and it gets the proportions of its pixels. With its own image that undoes what distorted it.
Picture inProportion(Picture picture);

} // namespace suffuse
