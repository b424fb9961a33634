// The fonts of the machine, for texts that follow strokes.
#pragma once

#include "undo/lettering/laid_text.h"

#include <optional>

namespace suffuse::python {

/// Sets a text by the fonts that are installed; any thread may ask. What knows them is loaded when the first text is to
/// be set. It needs Qt's application object: that of the program, if Python runs in one of Qt's, else one without a
/// display, which stays. No value where the program's has to do without fonts, or a part of Suffuse is missing.
std::optional<LaidText> layByFonts(const Text &text);

} // namespace suffuse::python
