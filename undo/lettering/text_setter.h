// Sets a text by whoever knows fonts.
#pragma once

#include "undo/lettering/laid_text.h"

#include <optional>

namespace suffuse {

/// Sets a text (text_layout.h says how). No value where no text can be set; whether its font is installed is not asked.
std::optional<LaidText> layText(const Text &text, LetterShaper &shaper);
/// By the one that files are read with (`letterShaper`).
std::optional<LaidText> layAsFilesDo(const Text &text);

} // namespace suffuse
