#pragma once

#include "model/document/document.h"

#include <functional>
#include <set>

namespace suffuse {

/// Applies `change` to the pictures of those of the strokes that have one and are not locked. A picture that would
/// become invalid stays as it was.
Edit changePictures(const Document &document, const std::set<StrokeId> &strokes,
                    const std::function<void(Picture &)> &change);

/// Makes a group of the picture that lies underneath, below all strokes, and leaves no underlay. `picture` has the
/// underlay's image; `seen`: the moment from which it is there.
Edit underlayToLayer(Document &document, const Picture &picture, const QString &name, Microseconds seen);

} // namespace suffuse
