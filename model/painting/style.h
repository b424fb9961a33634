// How a stroke's density becomes opacity (eq 17-19), and how it mixes with what lies below it (eq 22, 23).
#pragma once

#include <array>
#include <cstdint>

// Compilers for devices read this as C++17, and compare nothing.
#if __cplusplus >= 202002L
#define SUFFUSE_COMPARES_VALUES(T) friend bool operator==(const T &, const T &) = default;
#else
#define SUFFUSE_COMPARES_VALUES(T)
#endif

namespace suffuse {

/// RYB colour and opacity, each in [0, 1]; white is (0, 0, 0), black (1, 1, 1).
struct Colour {
    float red = 0;
    float yellow = 0;
    float blue = 0;
    float opacity = 1;
    SUFFUSE_COMPARES_VALUES(Colour)
};

enum class StyleKind : std::uint8_t { Uniform, Feathering, Edge };

/// How density becomes coverage: a kind and ξ1, ξ2, ξ3. Only edge darkening has ξ3; it is 0 for the others.
struct Style {
    StyleKind kind = StyleKind::Uniform;
    std::array<float, 3> xi{0.5f, 0.05f, 0};
    SUFFUSE_COMPARES_VALUES(Style)
};

enum class MixMode : std::uint8_t { Alpha, Beta };

/// How a stroke mixes with the backdrop: alpha (eq 22), or pigment (eq 23) with β in [0, 1]. β is 0 while the mode is
/// alpha.
struct Mix {
    MixMode mode = MixMode::Alpha;
    float beta = 0;
    SUFFUSE_COMPARES_VALUES(Mix)
};

#undef SUFFUSE_COMPARES_VALUES

} // namespace suffuse
