#include "app/widgets/colour/screen_colour_rows.h"

#include "app/session/colour_convert.h"
#include "app/widgets/numbers/bar_slider.h"
#include "app/widgets/numbers/quantity.h"
#include "model/colour/colour_shift.h"
#include "model/painting/ryb.h"

#include <QGridLayout>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr int firstOfRgb = ScreenColourRows::Red, colourRows = ScreenColourRows::Opacity;
constexpr double leastShare = 1e-6; ///< of a channel: less is none

FieldSpec screenSpec(int row)
{
    static const char *const names[] = {QT_TRANSLATE_NOOP("suffuse::ScreenColourRows", "Hue"),
                                        QT_TRANSLATE_NOOP("suffuse::ScreenColourRows", "Saturation"),
                                        QT_TRANSLATE_NOOP("suffuse::ScreenColourRows", "Value"),
                                        QT_TRANSLATE_NOOP("suffuse::ScreenColourRows", "R"),
                                        QT_TRANSLATE_NOOP("suffuse::ScreenColourRows", "G"),
                                        QT_TRANSLATE_NOOP("suffuse::ScreenColourRows", "B")};
    static const char *const tips[] = {
        QT_TRANSLATE_NOOP("suffuse::ScreenColourRows",
                          "Hue on the circle of the screen's colours: 0° red, 120° green, 240° blue"),
        QT_TRANSLATE_NOOP("suffuse::ScreenColourRows", "0 %: grey; 100 %: as colourful as a screen can be"),
        QT_TRANSLATE_NOOP("suffuse::ScreenColourRows", "0 %: black; 100 %: as bright as the colour can be"),
        QT_TRANSLATE_NOOP("suffuse::ScreenColourRows", "Red light of the screen, 0 to 255"),
        QT_TRANSLATE_NOOP("suffuse::ScreenColourRows", "Green light of the screen, 0 to 255"),
        QT_TRANSLATE_NOOP("suffuse::ScreenColourRows", "Blue light of the screen, 0 to 255")};
    FieldSpec spec{.name = ScreenColourRows::tr(names[row]), .toolTip = ScreenColourRows::tr(tips[row])};
    if (row >= firstOfRgb) {
        spec.display = {.factor = 255, .decimals = 0};
        spec.step = spec.sliderStep = 1.0 / 255;
    } else if (row == ScreenColourRows::Hue) {
        spec.display = {.unit = QStringLiteral("°"), .factor = 360, .decimals = 1};
        spec.step = spec.sliderStep = 1.0 / 360;
    } else {
        spec.display = shareDisplay();
        spec.step = spec.sliderStep = 0.01;
    }
    return spec;
}

std::array<double, 3> rgbOfHsv(double hue, double saturation, double value)
{
    const auto channel = [&](double offset) {
        const double k = std::fmod(offset + 6 * hue, 6);
        return value - value * saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0);
    };
    return {channel(5), channel(3), channel(1)};
}

Colour colourOfRgb(const std::array<double, 6> &channels)
{
    return rybFromSrgb(channels[3], channels[4], channels[5]);
}

} // namespace

ScreenColourRows::ScreenColourRows(QWidget *parent) : QWidget(parent)
{
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(1, 1);
    for (int row = 0; row <= Opacity; ++row) {
        auto *field = new SliderField(row == Opacity ? specOf(Quantity::Opacity) : screenSpec(row), *grid, row, this);
        m_rows[std::size_t(row)] = field;
        connect(field, &SliderField::refused, this, &ScreenColourRows::refused);
        connect(field, &SliderField::editedRelative, this,
                [this, row](const ValueMap &map) { changeEach(row, map, nullptr); });
        if (row == Opacity)
            connect(field, &SliderField::edited, this, &ScreenColourRows::opacityEdited);
        else
            connect(field, &SliderField::edited, this,
                    [this, row](double value, ValueEntry *entry) { change(row, value, entry); });
    }
    setModel(Model::Hsv);
    setColour({});
}

void ScreenColourRows::setModel(Model model)
{
    for (int row = 0; row < colourRows; ++row)
        m_rows[std::size_t(row)]->setVisible((row >= firstOfRgb) == (model == Model::Rgb));
}

void ScreenColourRows::setColour(const Colour &colour)
{
    if (!samePaint(colour, m_colour)) // else the rows have it more exactly than it can be computed back
        m_channels = channelsOf(colour, m_channels);
    m_colour = colour;
    showChannels();
}

void ScreenColourRows::setOneOfSeveral(bool paint, bool opacity)
{
    m_isOneOfSeveral = paint;
    for (int row = 0; row <= Opacity; ++row)
        m_rows[std::size_t(row)]->setOneOfSeveral(row == Opacity ? opacity : paint);
}

/// A grey has the hue from before, and black the saturation, too.
ScreenColourRows::Channels ScreenColourRows::channelsOf(const Colour &colour, Channels before)
{
    const std::array<double, 3> rgb = srgbFromRyb(colour);
    for (std::size_t i = 0; i < 3; ++i)
        before[std::size_t(firstOfRgb) + i] = std::clamp(rgb[i], 0.0, 1.0);
    const auto [low, high] = std::ranges::minmax(rgb);
    before[Value] = high;
    if (high > leastShare)
        before[Saturation] = (high - low) / high;
    if (high - low > leastShare) {
        const double chroma = high - low;
        const double sixths = high == rgb[0]   ? (rgb[1] - rgb[2]) / chroma
                              : high == rgb[1] ? 2 + (rgb[2] - rgb[0]) / chroma
                                               : 4 + (rgb[0] - rgb[1]) / chroma;
        before[Hue] = sixths / 6 - std::floor(sixths / 6);
    }
    return before;
}

void ScreenColourRows::changeEach(int row, const ValueMap &map, ValueEntry *entry)
{
    const auto mapped = [row, map](const Colour &each) {
        if (row == Opacity)
            return withOpacity(each, float(map(each.opacity).value_or(each.opacity)));
        const Channels channels = channelsOf(each, {});
        const std::optional<double> value = map(channels[std::size_t(row)]);
        return value ? withOpacity(colourOfRgb(with(channels, row, *value)), each.opacity) : each;
    };
    emit eachEdited(mapped, entry);
}

ScreenColourRows::Channels ScreenColourRows::with(Channels channels, int row, double value)
{
    channels[std::size_t(row)] = value;
    if (row < firstOfRgb) {
        const std::array<double, 3> rgb = rgbOfHsv(channels[Hue], channels[Saturation], channels[Value]);
        std::ranges::copy(rgb, channels.begin() + firstOfRgb);
    }
    return channels;
}

void ScreenColourRows::change(int row, double value, ValueEntry *entry)
{
    if (m_isOneOfSeveral)
        return changeEach(
            row, [value](double) { return std::optional(value); }, entry);
    const Channels next = with(m_channels, row, value);
    const Colour colour = withOpacity(colourOfRgb(next), m_colour.opacity);
    if (row < firstOfRgb) { // what was set by hue, saturation and value is not computed back from red, green and blue
        m_channels = next;
        m_colour = colour;
        showChannels();
    }
    emit paintEdited(colour, entry);
}

void ScreenColourRows::showChannels()
{
    for (int row = 0; row < colourRows; ++row) {
        SliderField *field = m_rows[std::size_t(row)];
        field->setValue(m_channels[std::size_t(row)]);
        field->slider()->setGradient(
            [channels = m_channels, row](double at) { return toOpaqueScreen(colourOfRgb(with(channels, row, at))); });
    }
    m_rows[Opacity]->setValue(m_colour.opacity);
    m_rows[Opacity]->slider()->setGradient(
        [colour = m_colour](double at) { return toScreen(withOpacity(colour, float(at))); });
}

} // namespace suffuse
