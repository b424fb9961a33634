#pragma once

#include "model/document/document.h"

#include <functional>

namespace suffuse {

/// Puts a picture under the painting in place of the present one. Without a value it removes that.
Edit setUnderlay(const Document &document, std::optional<Underlay> underlay);
/// Applies `change` to the present underlay. If it would become invalid (`problemOf`), it stays as it was.
Edit changeUnderlay(const Document &document, const std::function<void(Underlay &)> &change);

/// The largest area with the proportions of `width` to `height` in `around`, in its middle.
Rect fitted(double width, double height, const Rect &around);

} // namespace suffuse
