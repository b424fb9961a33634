#pragma once

#include "app/widgets/numbers/slider_field.h"
#include "model/painting/style.h"

#include <array>

namespace suffuse {

/// Four rows of sliders, for R, Y, B and opacity. Each gradient shows the colours that the row would give.
class ColourRows : public QWidget {
    Q_OBJECT

public:
    enum Channel { Red, Yellow, Blue, Opacity };

    /// Without opacity there are three rows.
    explicit ColourRows(bool withOpacity, QWidget *parent = nullptr);

    /// Mixed channels are nullopt. `shown` is the colour from which the gradients start.
    void setColour(const std::array<std::optional<double>, 4> &channels, const Colour &shown);
    void setColour(const Colour &colour);
    /// In these channels the colour is one of several that differ (SliderField::setOneOfSeveral).
    void setOneOfSeveral(const std::array<bool, 4> &channels);

    static float &channelOf(Colour &colour, int channel);
    static float channelOf(const Colour &colour, int channel);
    SliderField *row(int channel) const { return m_rows[std::size_t(channel)]; }

signals:
    void edited(int channel, double value, suffuse::ValueEntry *entry);
    void editedRelative(int channel, const suffuse::ValueMap &map);
    void changed(int channel, const suffuse::ValueChange &change, suffuse::ValueEntry *entry);
    void refused(const QString &hint);

private:
    std::array<SliderField *, 4> m_rows{};
};

} // namespace suffuse
