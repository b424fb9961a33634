// The quantities that people change: how each is called, in which unit, sense and range it is shown, wherever it
// stands.
#pragma once

#include "app/widgets/slider_field.h"
#include "model/painting/fields.h"

#include <QStringList>

#include <algorithm>
#include <array>
#include <vector>

namespace suffuse {

enum class Quantity {
    // Of segments
    Diffusion,
    Density,
    Granulation,
    MaxAge,
    Opacity,
    Red,
    Yellow,
    Blue,
    Anisotropy,
    Angle,
    // Of strokes, brushes and paper
    Beta,
    Size,
    Flow,
    PaperStrength,
    SmoothingStrength,
    SmoothingString
};

inline constexpr std::array segmentQuantities{
    Quantity::Diffusion, Quantity::Density, Quantity::Granulation, Quantity::MaxAge,     Quantity::Opacity,
    Quantity::Red,       Quantity::Yellow,  Quantity::Blue,        Quantity::Anisotropy, Quantity::Angle};
/// What can be set along a stroke.
inline constexpr std::array curveQuantities{Quantity::Diffusion, Quantity::Density, Quantity::Granulation,
                                            Quantity::MaxAge,    Quantity::Opacity, Quantity::Red,
                                            Quantity::Yellow,    Quantity::Blue};

/// The number that one of a segment's quantities is.
const Number<Segment> &numberOf(Quantity quantity);
/// How it is shown: translated name, unit, sense, domain, slider.
FieldSpec specOf(Quantity quantity);
/// The same for any number of a segment, by what it is called in files where it has no words.
FieldSpec specOf(const Number<Segment> &number);
/// How a number is shown that has no words of its own: as files name it.
FieldSpec plainSpec(const char *name, const FieldTraits &traits, float usual);
/// A share in [0, 1], shown in per cent.
FieldSpec shareSpec(const QString &name, const QString &toolTip, double defaultValue = 0);
/// ξ1 … ξ3 (`index` 0 … 2) of a kind of style.
FieldSpec xiSpec(StyleKind kind, int index);

/// Translated, in the order of StyleKind and MixMode.
QStringList styleNames();
QStringList mixingNames();

/// The members of a type that are numbers by themselves, but for those that are `shown` already.
template <class Owner>
std::vector<Number<Owner>> otherNumbers(const std::vector<float Owner::*> &shown)
{
    std::vector<Number<Owner>> others;
    for (const Number<Owner> &number : numbersOf<Owner>)
        if (number.member && std::find(shown.begin(), shown.end(), number.member) == shown.end())
            others.push_back(number);
    return others;
}

/// Of a segment's quantities only.
float &valueOf(Segment &segment, Quantity quantity);
float valueOf(const Segment &segment, Quantity quantity);

} // namespace suffuse
