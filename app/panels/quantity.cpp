#include "app/panels/quantity.h"

#include <QCoreApplication>

namespace suffuse {

namespace {

struct Text {
    // These texts were the inspector's first.
    Q_DECLARE_TR_FUNCTIONS(suffuse::SegmentSection)
};

constexpr double smallestPositive = 1e-9;

FieldSpec diffusionSpec()
{
    return {.name = Text::tr("Diffusion D"),
            .toolTip = Text::tr("How fast the paint spreads: the spread grows with the root of D times time."),
            .unit = NumberField::diffusionUnit(),
            .minimum = smallestPositive,
            .maximum = 1e12,
            .sliderMinimum = 0.1,
            .sliderMaximum = 10000,
            .logarithmic = true,
            .defaultValue = Segment{}.diffusion};
}

FieldSpec densitySpec()
{
    return {.name = Text::tr("Density φ"),
            .toolTip = Text::tr("How much paint the segment gives off along its length."),
            .unit = NumberField::canvasUnit(),
            .minimum = 0,
            .maximum = 1e12,
            .sliderMinimum = 0.1,
            .sliderMaximum = 1000,
            .logarithmic = true,
            .defaultValue = Segment{}.density};
}

FieldSpec granulationSpec()
{
    return {.name = Text::tr("Granulation ω"),
            .toolTip = Text::tr("100 % hides the paper's texture, 0 % shows it fully."),
            .unit = QStringLiteral(" %"),
            .factor = 100,
            .step = 0.01,
            .defaultValue = Segment{}.granulation};
}

FieldSpec maxAgeSpec()
{
    return {.name = Text::tr("Drying time"),
            .toolTip = Text::tr("t_max: how long the paint spreads after it was laid down."),
            .unit = NumberField::secondsUnit(),
            .minimum = smallestPositive,
            .maximum = 1e6,
            .sliderMinimum = 0.01,
            .sliderMaximum = 100,
            .logarithmic = true,
            .defaultValue = Segment{}.maxAge};
}

FieldSpec shareSpec(const QString &name, const QString &toolTip, double defaultValue)
{
    return {.name = name,
            .toolTip = toolTip,
            .unit = QStringLiteral(" %"),
            .factor = 100,
            .step = 0.01,
            .defaultValue = defaultValue};
}

} // namespace

FieldSpec specOf(Quantity quantity)
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
        return shareSpec(Text::tr("Opacity"), Text::tr("How much the paint covers at full density"), 1);
    case Quantity::Red:
        return shareSpec(Text::tr("Red"), Text::tr("Share of red pigment"), 0);
    case Quantity::Yellow:
        return shareSpec(Text::tr("Yellow"), Text::tr("Share of yellow pigment"), 0);
    case Quantity::Blue:
        return shareSpec(Text::tr("Blue"), Text::tr("Share of blue pigment"), 0);
    }
    return {};
}

float &valueOf(Segment &segment, Quantity quantity)
{
    switch (quantity) {
    case Quantity::Diffusion:
        return segment.diffusion;
    case Quantity::Density:
        return segment.density;
    case Quantity::Granulation:
        return segment.granulation;
    case Quantity::MaxAge:
        return segment.maxAge;
    case Quantity::Opacity:
        return segment.colour.opacity;
    case Quantity::Red:
        return segment.colour.red;
    case Quantity::Yellow:
        return segment.colour.yellow;
    case Quantity::Blue:
        break;
    }
    return segment.colour.blue;
}

float valueOf(const Segment &segment, Quantity quantity)
{
    Segment copy = segment;
    return valueOf(copy, quantity);
}

} // namespace suffuse
