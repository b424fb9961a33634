// Colours as people say them.
#pragma once

#include "model/painting/style.h"

#include <QString>

namespace suffuse {

/// A colour by its name, "dark green" for example, translated. It is one of about forty names, by hue and lightness;
/// opacity plays no part in it.
QString wordOf(const Colour &colour);

} // namespace suffuse
