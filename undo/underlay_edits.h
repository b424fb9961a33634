#pragma once

#include "model/document/document.h"

#include <functional>

namespace suffuse {

/// Puts a picture under the painting, in place of the one that is there; nothing: takes that away.
Edit setUnderlay(const Document &document, std::optional<Underlay> underlay);
/// Applies `change` to the underlay that is there. One that would be none (`problemOf`) is left as it is.
Edit changeUnderlay(const Document &document, const std::function<void(Underlay &)> &change);

/// The largest area of `width` to `height` that lies in `around`, in its middle.
Rect fitted(double width, double height, const Rect &around);

} // namespace suffuse
