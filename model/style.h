// How a stroke's density becomes opacity (eq 17-19), and how it mixes with what lies below (eq 22, 23).
#pragma once

#include <array>
#include <cstdint>

namespace suffuse {

/// RYB colour and opacity, each in [0, 1]; white is (0, 0, 0), black (1, 1, 1).
struct Colour {
    float red = 0;
    float yellow = 0;
    float blue = 0;
    float opacity = 1;
    friend bool operator==(const Colour &, const Colour &) = default;
};

enum class StyleKind : std::uint8_t { Uniform, Feathering, Edge };

/// Density modification: its kind and ξ1, ξ2, ξ3 (only edge darkening has ξ3; the others keep 0 there).
struct Style {
    StyleKind kind = StyleKind::Uniform;
    std::array<float, 3> xi{0.5f, 0.05f, 0};
    friend bool operator==(const Style &, const Style &) = default;
};

enum class MixMode : std::uint8_t { Alpha, Beta };

/// Mixing with the backdrop: alpha (eq 22) or pigment (eq 23) with β in [0, 1] (0 while the mode is alpha).
struct Mix {
    MixMode mode = MixMode::Alpha;
    float beta = 0;
    friend bool operator==(const Mix &, const Mix &) = default;
};

} // namespace suffuse
