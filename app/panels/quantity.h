// The quantities of a segment that people change, by name.
#pragma once

#include "app/widgets/slider_field.h"
#include "model/painting/segment.h"

#include <array>

namespace suffuse {

enum class Quantity { Diffusion, Density, Granulation, MaxAge, Opacity, Red, Yellow, Blue };

inline constexpr std::array allQuantities{Quantity::Diffusion, Quantity::Density, Quantity::Granulation,
                                          Quantity::MaxAge,    Quantity::Opacity, Quantity::Red,
                                          Quantity::Yellow,    Quantity::Blue};

/// How panels show it: translated name, unit, domain, slider.
FieldSpec specOf(Quantity quantity);

float &valueOf(Segment &segment, Quantity quantity);
float valueOf(const Segment &segment, Quantity quantity);

} // namespace suffuse
