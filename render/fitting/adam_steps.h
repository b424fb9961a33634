// Steps by the method of Adam (Kingma and Ba 2015) with a size for each kind of number.
#pragma once

#include "render/fitting/fit_stroke.h"

namespace suffuse::fitting {

/// How far the numbers go in a step at first.
struct StepSizes {
    double points = 0.8;     ///< of the stroke's spread
    double spread = 0.06;    ///< ln s
    double peak = 0.09;      ///< ln of the peak
    double steepness = 0.06; ///< ln ξ2
    double colour = 0.01;    ///< of [0, 1]
    double opacity = 0.05;   ///< of its logistic
};

/// The moments of the slopes of strokes, which come and go.
class AdamSteps {
public:
    /// Appends strokes that have not moved yet.
    void grow(std::size_t strokes) { m_states.resize(strokes); }
    /// Forgets those that are gone: `kept[i]` is the former place of stroke i.
    void keep(const std::vector<std::size_t> &kept);
    /// Moves all strokes against their slopes, `rate` times as far as `sizes` say.
    void move(std::vector<FitStroke> &strokes, const std::vector<StrokeSlope> &slopes, const StepSizes &sizes,
              double rate);

private:
    struct State {
        StrokeSlope mean{}, square{};
        int steps = 0;
    };
    std::vector<State> m_states;
};

} // namespace suffuse::fitting
