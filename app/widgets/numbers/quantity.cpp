#include "app/widgets/numbers/quantity.h"

#include "model/brush/brush.h"
#include "model/brush/brush_width.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

struct QuantityText {
    // These texts were the inspector's first.
    Q_DECLARE_TR_FUNCTIONS(suffuse::SegmentSection)
};

FieldSpec diffusionSpec()
{
    return {.name = QuantityText::tr("Diffusion D"),
            .toolTip = QuantityText::tr("How fast the paint spreads: the spread grows with the root of D times time."),
            .display = diffusionDisplay(),
            .sliderMinimum = 0.1,
            .sliderMaximum = 10000,
            .logarithmic = true};
}

FieldSpec densitySpec()
{
    return {.name = QuantityText::tr("Density φ"),
            .toolTip = QuantityText::tr("How much paint the segment gives off along its length."),
            .display = {.unit = canvasUnit()},
            .sliderMinimum = 0.1,
            .sliderMaximum = 1000,
            .logarithmic = true};
}

FieldSpec granulationSpec()
{
    // The stored number is ω, which hides the paper; people think of the grain that they see.
    return {.name = QuantityText::tr("Granulation"),
            .toolTip =
                QuantityText::tr("How much of the paper's grain shows: 0 % is smooth, 100 % shows all of it. Files and "
                                 "scripts hold ω, which is 1 where this is 0 %."),
            .display = grainDisplay(),
            .step = 0.01,
            .sliderStep = 0.01};
}

FieldSpec maxAgeSpec()
{
    return {.name = QuantityText::tr("Drying time"),
            .toolTip = QuantityText::tr("t_max: how long the paint spreads after it was laid down."),
            .display = timeDisplay(),
            .sliderMinimum = 0.01,
            .sliderMaximum = 100,
            .logarithmic = true};
}

FieldSpec anisotropySpec()
{
    return {.name = QuantityText::tr("Anisotropy"),
            .toolTip = QuantityText::tr("How many times D along the angle is D across it; 1 spreads evenly."),
            .sliderMinimum = 0.01,
            .sliderMaximum = 100,
            .logarithmic = true};
}

FieldSpec angleSpec()
{
    const Display display = angleDisplay();
    return {.name = QuantityText::tr("Angle"),
            .toolTip = QuantityText::tr("Direction of the anisotropy, clockwise from the horizontal."),
            .display = display,
            .sliderMinimum = display.toValue(-90), // after a half turn the tip is the same again
            .sliderMaximum = display.toValue(90),
            .step = display.toValue(1),
            .sliderStep = display.toValue(1)};
}

FieldSpec sizeSpec()
{
    return {.name = QuantityText::tr("Size"),
            .toolTip = QuantityText::tr("Width of a dry line at full pressure, in units; sets the diffusion."),
            .display = lengthDisplay(),
            .minimum = 1e-7,
            .maximum = 1e5,
            .sliderMinimum = 1,
            .sliderMaximum = 600,
            .logarithmic = true,
            .defaultValue = visibleWidth(Brush{})};
}

FieldSpec flowSpec()
{
    return {.name = QuantityText::tr("Flow"),
            .toolTip = QuantityText::tr("Density in the middle of the stroke at full pressure."),
            .minimum = 0.001,
            .maximum = 1e6,
            .sliderMinimum = 0.1,
            .sliderMaximum = 10,
            .logarithmic = true,
            .defaultValue = Brush{}.peak};
}

FieldSpec stringSpec()
{
    return {.name = QuantityText::tr("String"),
            .toolTip = QuantityText::tr("Its length on the screen"),
            .display = screenDisplay(),
            .maximum = 1000,
            .sliderMaximum = 200,
            .step = 5};
}

/// The limits and defaults of a segment's numbers are in model/painting/fields.h.
FieldSpec wordsOf(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Diffusion:
        return diffusionSpec();
    case Quantity::Density:
        return densitySpec();
    case Quantity::Granulation:
        return granulationSpec();
    case Quantity::MaxAge:
        return maxAgeSpec();
    case Quantity::Opacity:
        return shareSpec(QuantityText::tr("Opacity"), QuantityText::tr("How much the paint covers at full density"));
    case Quantity::Red:
        return shareSpec(QuantityText::tr("Red"), QuantityText::tr("Share of red pigment"));
    case Quantity::Yellow:
        return shareSpec(QuantityText::tr("Yellow"), QuantityText::tr("Share of yellow pigment"));
    case Quantity::Blue:
        return shareSpec(QuantityText::tr("Blue"), QuantityText::tr("Share of blue pigment"));
    case Quantity::Anisotropy:
        return anisotropySpec();
    case Quantity::Angle:
        return angleSpec();
    case Quantity::Beta:
        return shareSpec(QuantityText::tr("Pigment β"),
                         QuantityText::tr("Share of the colour below that stays: 0 % covers, 100 % adds."), 0.5);
    case Quantity::Size:
        return sizeSpec();
    case Quantity::Flow:
        return flowSpec();
    case Quantity::PaperStrength:
        return shareSpec(QuantityText::tr("Strength"), QuantityText::tr("How deep the grain goes."), Paper{}.strength);
    case Quantity::SmoothingStrength:
        return shareSpec(QuantityText::tr("Strength"), QuantityText::tr("How far the stroke lags behind"), 0);
    case Quantity::SmoothingString:
        return stringSpec();
    }
    return {};
}

FieldSpec within(FieldSpec spec, const FieldTraits &traits, float usual)
{
    spec.minimum = traits.domain.leastFloat();
    spec.maximum = traits.domain.greatest;
    spec.defaultValue = double(usual);
    return spec;
}

Display displayOf(Unit unit)
{
    switch (unit) {
    case Unit::None:
        break;
    case Unit::Length:
        return {.unit = canvasUnit()};
    case Unit::Diffusion:
        return diffusionDisplay();
    case Unit::Seconds:
        return timeDisplay();
    case Unit::Share:
        return shareDisplay();
    case Unit::Radians:
        return angleDisplay();
    }
    return {};
}

} // namespace

FieldSpec shareSpec(const QString &name, const QString &toolTip, double defaultValue)
{
    return {.name = name,
            .toolTip = toolTip,
            .display = shareDisplay(),
            .step = 0.01,
            .sliderStep = 0.01,
            .defaultValue = defaultValue};
}

const Number<Segment> &numberOf(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Diffusion:
        return numberOf(&Segment::diffusion);
    case Quantity::Density:
        return numberOf(&Segment::density);
    case Quantity::Granulation:
        return numberOf(&Segment::granulation);
    case Quantity::MaxAge:
        return numberOf(&Segment::maxAge);
    case Quantity::Opacity:
        return numberOf(&Colour::opacity);
    case Quantity::Red:
        return numberOf(&Colour::red);
    case Quantity::Yellow:
        return numberOf(&Colour::yellow);
    case Quantity::Anisotropy:
        return numberOf(&Segment::anisotropyRatio);
    case Quantity::Angle:
        return numberOf(&Segment::anisotropyAngle);
    default:
        return numberOf(&Colour::blue); // the other quantities are no numbers of a segment
    }
}

FieldSpec specOf(Quantity quantity)
{
    const FieldSpec words = wordsOf(quantity);
    if (std::ranges::find(segmentQuantities, quantity) == segmentQuantities.end())
        return words;
    const Number<Segment> &number = numberOf(quantity);
    return within(words, number.traits, number.usual());
}

FieldSpec specOf(const Number<Segment> &number)
{
    for (const Quantity quantity : segmentQuantities)
        if (&numberOf(quantity) == &number)
            return specOf(quantity);
    return plainSpec(number.name, number.traits, number.usual());
}

FieldSpec plainSpec(const char *name, const FieldTraits &traits, float usual)
{
    FieldSpec spec{
        .name = QString::fromLatin1(name), .toolTip = QString::fromLatin1(name), .display = displayOf(traits.unit)};
    if (spec.display.factor != 1)
        spec.step = spec.display.toValue(1); // one of the shown unit: a per cent, a degree
    spec = within(spec, traits, usual);
    const double most = 2 * std::max(std::abs(double(usual)), 0.5);
    spec.sliderMinimum = std::max(spec.minimum, spec.minimum < 0 ? -most : 0.0);
    spec.sliderMaximum = std::min(spec.maximum, most);
    return spec;
}

FieldSpec xiSpec(StyleKind kind, int index)
{
    const QString unused = QuantityText::tr("Parameter of the style");
    const std::array<std::array<QString, 3>, 3> names{
        {{QuantityText::tr("Threshold ξ1"), QuantityText::tr("Softness ξ2"), QStringLiteral("ξ3")},
         {QuantityText::tr("Full at ξ1"), QuantityText::tr("Steepness ξ2"), QStringLiteral("ξ3")},
         {QuantityText::tr("Edge ξ1"), QuantityText::tr("Lightening ξ2"), QuantityText::tr("Strength ξ3")}}};
    const std::array<std::array<QString, 3>, 3> tips{
        {{QuantityText::tr("Density at which the stroke covers by half."),
          QuantityText::tr("How gently the edge fades."), unused},
         {QuantityText::tr("Density from which the stroke covers fully."),
          QuantityText::tr("How steeply coverage grows with density."), unused},
         {QuantityText::tr("Density at which the dark rim stands."),
          QuantityText::tr("How much the inside is lighter than the rim; at most 1.26·ξ1."),
          QuantityText::tr("Coverage far inside the stroke.")}}};
    const Domain domain = index < xiCount(kind) ? domainOfXi(kind, index) : positive;
    return {.name = names[std::size_t(kind)][std::size_t(index)],
            .toolTip = tips[std::size_t(kind)][std::size_t(index)],
            .minimum = domain.leastFloat(),
            .maximum = domain.greatest,
            .sliderMinimum = 0.01,
            .sliderMaximum = 4,
            .logarithmic = true,
            .defaultValue = double(Style{}.xi[std::size_t(index)])};
}

QStringList styleNames()
{
    return {QuantityText::tr("Uniform"), QuantityText::tr("Feathering"), QuantityText::tr("Dark edges")};
}

QStringList mixingNames()
{
    return {QuantityText::tr("Covering (alpha)"), QuantityText::tr("Pigment (β)")};
}

QStringList smoothingNames()
{
    return {QuantityText::tr("Off"), QuantityText::tr("Weighted"), QuantityText::tr("Pulled string")};
}

float &valueOf(Segment &segment, Quantity quantity)
{
    return numberOf(quantity).of(segment);
}

float valueOf(const Segment &segment, Quantity quantity)
{
    return numberOf(quantity).of(segment);
}

} // namespace suffuse
