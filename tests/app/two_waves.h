// Two strokes of one colour, for tests that change colours.
#pragma once

#include "app/panels/colour/colour_panel.h"
#include "app/widgets/colour/colour_wheel.h"
#include "app/widgets/numbers/bar_slider.h"
#include "tests/app/shapes.h"
#include "undo/swatch_edits.h"

#include <algorithm>

namespace suffuse {

inline constexpr Colour waveColour{0.9f, 0.1f, 0.7f, 1}, green{0, 1, 1, 1}, red{1, 0, 0, 1};

/// By how much they differ in the pigment in which they differ most.
inline double farthest(const Colour &a, const Colour &b)
{
    return std::max({std::abs(a.red - b.red), std::abs(a.yellow - b.yellow), std::abs(a.blue - b.blue)});
}

/// Two waves, one below the other; nothing is selected, and the Select tool is in use.
struct TwoWaves : WaveSession {
    StrokeId second = 0;
    ColourPanel &panel = *window.findChild<ColourPanel *>();
    PaintingPtr before;

    TwoWaves()
    {
        window.resize(1366, 768);
        second = addWave(200, 420, false);
        use(Command::Select);
        select({});
        before = editor().document().painting();
    }
    void select(std::set<StrokeId> strokes, std::set<SegmentRef> segments = {})
    {
        editor().document().setSelection({std::move(strokes), std::move(segments)});
        editor().laterChanges().flush();
    }
    Colour colour(StrokeId which, std::size_t segment = 0) { return stroke(which).segments[segment].colour; }
    bool isAsBefore() { return painting() == *before; }
    QPoint ring(double hue) { return panel.wheel()->ringPoint(hue).toPoint(); }
    void addSwatches(const std::vector<Swatch> &swatches)
    {
        editor().push(setSwatches(editor().document(), swatches), "swatches");
        before = editor().document().painting();
    }
};

/// Where a press sets `share` of the whole.
inline QPoint along(const BarSlider &slider, double share)
{
    return {int(8 + share * (slider.width() - 16)), slider.height() / 2};
}

} // namespace suffuse
