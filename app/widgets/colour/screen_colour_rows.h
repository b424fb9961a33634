#pragma once

#include "app/widgets/numbers/slider_field.h"
#include "model/painting/style.h"

#include <array>
#include <functional>

namespace suffuse {

/// What becomes of a colour.
using ColourMap = std::function<Colour(const Colour &)>;

/// Sliders for a colour as screens have it: hue, saturation and value, or red, green and blue, and the opacity below.
/// Each gradient shows the colours that its row would give.
class ScreenColourRows : public QWidget {
    Q_OBJECT

public:
    enum class Model { Hsv, Rgb };
    enum Row { Hue, Saturation, Value, Red, Green, Blue, Opacity };

    explicit ScreenColourRows(QWidget *parent = nullptr);

    void setModel(Model model);
    /// Emits nothing. Greys keep the hue that is shown, and black the saturation, too.
    void setColour(const Colour &colour);
    /// The colour is one of several that differ, or its opacity is (SliderField::setOneOfSeveral).
    void setOneOfSeveral(bool paint, bool opacity);
    SliderField *row(Row row) const { return m_rows[std::size_t(row)]; }

signals:
    /// Red, yellow and blue are to be these.
    void paintEdited(const suffuse::Colour &colour, suffuse::ValueEntry *entry);
    void opacityEdited(double opacity, suffuse::ValueEntry *entry);
    /// Of several colours each is to be what the map makes of it.
    void eachEdited(const suffuse::ColourMap &map, suffuse::ValueEntry *entry);
    void refused(const QString &hint);

private:
    using Channels = std::array<double, 6>; ///< in the order of Row, each in [0, 1]
    static Channels channelsOf(const Colour &colour, Channels before);
    void changeEach(int row, const ValueMap &map, ValueEntry *entry);
    static Channels with(Channels channels, int row, double value);
    void change(int row, double value, ValueEntry *entry);
    void showChannels();

    Channels m_channels{};
    bool m_isOneOfSeveral = false;
    Colour m_colour; ///< that the channels are of
    std::array<SliderField *, 7> m_rows{};
};

} // namespace suffuse
