// How a group that is a layer is put on what lies below it.
#pragma once

#include <cstdint>

namespace suffuse {

/// The blend modes of W3C Compositing and Blending Level 1, in its order, and four of its operators, which stand for
/// source-over. docs/solver.md, "Groups that blend", has the formulas.
enum class BlendMode : std::uint8_t {
    Normal,
    Multiply,
    Screen,
    Overlay,
    Darken,
    Lighten,
    ColourDodge,
    ColourBurn,
    HardLight,
    SoftLight,
    Difference,
    Exclusion,
    Hue,
    Saturation,
    Colour,
    Luminosity,
    Plus,           ///< the sum of both
    DestinationIn,  ///< keeps what lies below where the layer is
    DestinationOut, ///< takes it away there
    SourceAtop      ///< shows the layer only where paint lies below it
};
inline constexpr int blendModes = int(BlendMode::SourceAtop) + 1;

} // namespace suffuse
