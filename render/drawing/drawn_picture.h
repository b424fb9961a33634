// The pictures that strokes of a drawing are painted with.
#pragma once

#include "render/drawing/drawn_paint.h"
#include "render/image_io/image_io.h"
#include "render/scene/picture.h"

namespace suffuse {

/// An image's file as programs read it that know but PNG and JPEG, upright and without what its pixels do not need.
struct DrawnImage {
    QByteArray bytes;
    const char *type = "image/png"; ///< its MIME type
};
/// The image of a picture that can be read. It fails if there is not enough memory, or if it was cancelled.
Result<DrawnImage> drawnImage(const Picture &picture, const std::atomic<bool> *cancel = nullptr);

/// What a picture has at the middle of a pixel. Images of drawings end at their edges.
DrawnColour colourAt(const ScenePicture &picture, int x, int y);

} // namespace suffuse
