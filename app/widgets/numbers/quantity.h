// The quantities that people change: the name, unit, sense and range in which each is shown, wherever it stands.
#pragma once

#include "app/widgets/numbers/slider_field.h"
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
/// The quantities that can be set along a stroke.
inline constexpr std::array curveQuantities{Quantity::Diffusion, Quantity::Density, Quantity::Granulation,
                                            Quantity::MaxAge,    Quantity::Opacity, Quantity::Red,
                                            Quantity::Yellow,    Quantity::Blue};

/// The segment's number that a quantity stands for.
const Number<Segment> &numberOf(Quantity quantity);
/// How a quantity is shown: translated name, unit, sense, domain, slider.
FieldSpec specOf(Quantity quantity);
/// The same for any number of a segment. One without words of its own gets the name that it has in files.
FieldSpec specOf(const Number<Segment> &number);
/// How a number without words of its own is shown: by the name that it has in files.
FieldSpec plainSpec(const char *name, const FieldTraits &traits, float usual);
/// How a share in [0, 1] is shown: in per cent.
FieldSpec shareSpec(const QString &name, const QString &toolTip, double defaultValue = 0);
/// How ξ1 … ξ3 (`index` 0 … 2) of a kind of style is shown.
FieldSpec xiSpec(StyleKind kind, int index);

/// Translated names, in the order of StyleKind and MixMode.
QStringList styleNames();
QStringList mixingNames();
/// Those of the ways in which a brush steadies the hand, in the order of Stabiliser::Kind.
QStringList smoothingNames();

/// The members of a type that are numbers by themselves, without those that are `shown` already.
template <class Owner>
std::vector<Number<Owner>> otherNumbers(const std::vector<float Owner::*> &shown)
{
    std::vector<Number<Owner>> others;
    for (const Number<Owner> &number : numbersOf<Owner>)
        if (number.member && std::find(shown.begin(), shown.end(), number.member) == shown.end())
            others.push_back(number);
    return others;
}

/// This is for a segment's quantities only.
float &valueOf(Segment &segment, Quantity quantity);
float valueOf(const Segment &segment, Quantity quantity);

} // namespace suffuse
