// The words of CSS for how groups blend, and what they ask of a drawing's elements.
#pragma once

#include "model/formats/svg/svg_drawing.h"
#include "model/formats/svg/svg_style.h"

namespace suffuse {

/// The value of mix-blend-mode for a mode; null where CSS has none.
const char *cssOf(BlendMode mode);
/// The mode that a value of mix-blend-mode stands for.
std::optional<BlendMode> blendModeFrom(const QString &css);

/// Whether opacity or mode are about all that an element draws together, so that a group must have them. A shape has
/// its opacity itself.
bool blendsAsOne(const SvgElement &element, const SvgStyle &style);
/// Gives a group the opacity, the mode and the isolation of an element.
void setBlending(SvgGroup &group, const SvgStyle &style);
/// Whether a group does anything but hold what is in it.
bool blends(const SvgGroup &group);

} // namespace suffuse
