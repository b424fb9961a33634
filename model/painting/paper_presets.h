#pragma once

#include "model/painting/painting.h"

#include <span>

namespace suffuse {

/// A usual paper: an untranslated name and the numbers that make it.
struct PaperPreset {
    const char *name = ""; ///< in the context "Papers"
    PaperGrain grain = PaperGrain::Tooth;
    float scale = 24;
    float strength = 0.5f;
};

/// Smooth, cold press, rough, rice, canvas.
std::span<const PaperPreset> paperPresets();

/// The paper of a preset, with a seed.
Paper paperOf(const PaperPreset &preset, std::uint32_t seed = 1);

/// The index of the preset that a paper equals, whatever its seed; −1 if it equals none.
int presetOf(const Paper &paper);

/// The preset's name in the user's language.
QString titleOf(const PaperPreset &preset);

} // namespace suffuse
