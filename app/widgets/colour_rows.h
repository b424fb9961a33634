#pragma once

#include "app/widgets/slider_field.h"
#include "model/painting/style.h"

#include <array>

namespace suffuse {

/// Four slider rows for R, Y, B and opacity with gradients of what each would give.
class ColourRows : public QWidget {
    Q_OBJECT

public:
    enum Channel { Red, Yellow, Blue, Opacity };

    /// Without opacity: three rows.
    explicit ColourRows(bool withOpacity, QWidget *parent = nullptr);

    /// Channels that are mixed are nullopt; `shown` is what the gradients start from.
    void setColour(const std::array<std::optional<double>, 4> &channels, const Colour &shown);
    void setColour(const Colour &colour);

    static float &channelOf(Colour &colour, int channel);
    static float channelOf(const Colour &colour, int channel);
    SliderField *row(int channel) const { return m_rows[std::size_t(channel)]; }

signals:
    void edited(int channel, double value, suffuse::EditRun run);
    void editedRelative(int channel, const suffuse::ValueMap &map);
    void refused(const QString &hint);

private:
    std::array<SliderField *, 4> m_rows{};
};

} // namespace suffuse
