// How the next text will be set.
#pragma once

#include "model/painting/text.h"

namespace suffuse {

/// The values that were chosen last, from the settings; without place, curve and characters.
Text storedTextStyle();
void storeTextStyle(const Text &text);

} // namespace suffuse
