#include "app/widgets/numbers/blend_modes.h"

#include <QComboBox>
#include <QCoreApplication>

namespace suffuse {

namespace {

struct BlendText {
    Q_DECLARE_TR_FUNCTIONS(suffuse::BlendMode)
};

} // namespace

QString nameOf(BlendMode mode)
{
    switch (mode) {
        using enum BlendMode;
    case Normal:
        return BlendText::tr("Normal");
    case Multiply:
        return BlendText::tr("Multiply");
    case Screen:
        return BlendText::tr("Screen");
    case Overlay:
        return BlendText::tr("Overlay");
    case Darken:
        return BlendText::tr("Darken");
    case Lighten:
        return BlendText::tr("Lighten");
    case ColourDodge:
        return BlendText::tr("Colour Dodge");
    case ColourBurn:
        return BlendText::tr("Colour Burn");
    case HardLight:
        return BlendText::tr("Hard Light");
    case SoftLight:
        return BlendText::tr("Soft Light");
    case Difference:
        return BlendText::tr("Difference", "blend mode");
    case Exclusion:
        return BlendText::tr("Exclusion", "blend mode");
    case Hue:
        return BlendText::tr("Hue");
    case Saturation:
        return BlendText::tr("Saturation");
    case Colour:
        return BlendText::tr("Colour");
    case Luminosity:
        return BlendText::tr("Luminosity");
    case Plus:
        return BlendText::tr("Add");
    case DestinationIn:
        return BlendText::tr("Mask Below");
    case DestinationOut:
        return BlendText::tr("Erase Below");
    case SourceAtop:
        return BlendText::tr("Clip to Below");
    }
    return {};
}

QString tipOf(BlendMode mode)
{
    switch (mode) {
        using enum BlendMode;
    case Normal:
        return BlendText::tr("The group covers what lies below.");
    case Multiply:
        return BlendText::tr("Darkens, as glazes and shadows do; white changes nothing.");
    case Screen:
        return BlendText::tr("Lightens, as lights do that fall on one place; black changes nothing.");
    case Overlay:
        return BlendText::tr("Multiplies where it is dark below, and screens where it is light there.");
    case Darken:
        return BlendText::tr("Of each channel the darker value stays.");
    case Lighten:
        return BlendText::tr("Of each channel the lighter value stays.");
    case ColourDodge:
        return BlendText::tr("Brightens what lies below, strongly where the group is light.");
    case ColourBurn:
        return BlendText::tr("Deepens what lies below, strongly where the group is dark.");
    case HardLight:
        return BlendText::tr("Multiplies where the group is dark, and screens where it is light.");
    case SoftLight:
        return BlendText::tr("Darkens or lightens gently, as a diffuse light does.");
    case Difference:
        return BlendText::tr("How far both are apart; white inverts what lies below.");
    case Exclusion:
        return BlendText::tr("As Difference, with less contrast.");
    case Hue:
        return BlendText::tr("The hue of the group, with saturation and luminosity of what lies below.");
    case Saturation:
        return BlendText::tr("The saturation of the group, with hue and luminosity of what lies below.");
    case Colour:
        return BlendText::tr("Hue and saturation of the group, with the luminosity of what lies below: for tinting.");
    case Luminosity:
        return BlendText::tr("The luminosity of the group, with hue and saturation of what lies below.");
    case Plus:
        return BlendText::tr("The sum of both, for glows (plus, linear dodge).");
    case DestinationIn:
        return BlendText::tr("The group is not seen itself: what lies below stays where the group covers, and goes "
                             "elsewhere (destination-in).");
    case DestinationOut:
        return BlendText::tr("The group is not seen itself: it takes away what lies below where it covers "
                             "(destination-out).");
    case SourceAtop:
        return BlendText::tr("The group is seen only where paint lies below it: for shading a shape without leaving it "
                             "(source-atop).");
    }
    return {};
}

void addBlendModes(QComboBox &box)
{
    using enum BlendMode;
    const std::vector<std::vector<BlendMode>> families{{Normal},
                                                       {Darken, Multiply, ColourBurn},
                                                       {Lighten, Screen, ColourDodge, Plus},
                                                       {Overlay, SoftLight, HardLight},
                                                       {Difference, Exclusion},
                                                       {Hue, Saturation, Colour, Luminosity},
                                                       {SourceAtop, DestinationIn, DestinationOut}};
    for (const std::vector<BlendMode> &family : families) {
        if (box.count() > 0)
            box.insertSeparator(box.count());
        for (const BlendMode mode : family) {
            box.addItem(nameOf(mode), int(mode));
            box.setItemData(box.count() - 1, tipOf(mode), Qt::ToolTipRole);
        }
    }
}

BlendMode modeAt(const QComboBox &box, int index)
{
    return BlendMode(box.itemData(index).toInt());
}

void chooseMode(QComboBox &box, BlendMode mode)
{
    box.setCurrentIndex(box.findData(int(mode)));
}

} // namespace suffuse
