#include "app/widgets/colour/colour_rows.h"

#include "app/session/colour_convert.h"
#include "app/widgets/numbers/bar_slider.h"
#include "app/widgets/numbers/quantity.h"

#include <QGridLayout>

#include <algorithm>

namespace suffuse {

ColourRows::ColourRows(bool withOpacity, QWidget *parent) : QWidget(parent)
{
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(1, 1);
    constexpr std::array quantities{Quantity::Red, Quantity::Yellow, Quantity::Blue, Quantity::Opacity};
    for (int channel = 0; channel < (withOpacity ? 4 : 3); ++channel) {
        auto *row = new SliderField(specOf(quantities[std::size_t(channel)]), *grid, channel, this);
        m_rows[std::size_t(channel)] = row;
        connect(row, &SliderField::edited, this,
                [this, channel](double value, ValueEntry *entry) { emit edited(channel, value, entry); });
        connect(row, &SliderField::editedRelative, this,
                [this, channel](const ValueMap &map) { emit editedRelative(channel, map); });
        connect(row, &SliderField::changed, this, [this, channel](const ValueChange &change, ValueEntry *entry) {
            emit changed(channel, change, entry);
        });
        connect(row, &SliderField::refused, this, &ColourRows::refused);
    }
}

void ColourRows::setColour(const std::array<std::optional<double>, 4> &channels, const Colour &shown)
{
    for (int channel = 0; channel < 4; ++channel) {
        SliderField *row = m_rows[std::size_t(channel)];
        if (!row)
            continue;
        row->setValue(channels[std::size_t(channel)]);
        // The middle of a bar that changes mixed values stands for the colour as it was.
        const std::optional<ValueChange> change = row->change();
        const double from = double(channelOf(shown, channel)) - (change ? change->amount : 0) - 0.5;
        row->slider()->setGradient([shown, channel, from, mixed = row->slider()->isMixed()](double at) {
            Colour colour = shown;
            channelOf(colour, channel) = float(mixed ? std::clamp(from + at, 0.0, 1.0) : at);
            return channel == Opacity ? toScreen(colour) : toOpaqueScreen(colour);
        });
    }
}

void ColourRows::setColour(const Colour &colour)
{
    setColour({colour.red, colour.yellow, colour.blue, colour.opacity}, colour);
}

void ColourRows::setOneOfSeveral(const std::array<bool, 4> &channels)
{
    for (std::size_t channel = 0; channel < channels.size(); ++channel)
        if (m_rows[channel])
            m_rows[channel]->setOneOfSeveral(channels[channel]);
}

float &ColourRows::channelOf(Colour &colour, int channel)
{
    switch (channel) {
    case Red:
        return colour.red;
    case Yellow:
        return colour.yellow;
    case Blue:
        return colour.blue;
    default:
        return colour.opacity;
    }
}

float ColourRows::channelOf(const Colour &colour, int channel)
{
    Colour copy = colour;
    return channelOf(copy, channel);
}

} // namespace suffuse
