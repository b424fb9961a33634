#include "render/fitting/adam_steps.h"

#include <algorithm>
#include <cmath>

namespace suffuse::fitting {

namespace {

constexpr double meanMemory = 0.9, squareMemory = 0.95;

/// The step of each number of a stroke.
StrokeSlope stepsOf(const FitStroke &stroke, const StepSizes &sizes)
{
    StrokeSlope out;
    std::fill(out.begin(), out.begin() + LogSpread, sizes.points * std::exp(stroke[LogSpread]));
    out[LogSpread] = sizes.spread;
    out[LogPeak] = sizes.peak;
    out[LogSteepness] = sizes.steepness;
    out[Red] = out[Yellow] = out[Blue] = sizes.colour;
    out[Opacity] = sizes.opacity;
    return out;
}

} // namespace

void AdamSteps::keep(const std::vector<std::size_t> &kept)
{
    std::vector<State> states;
    states.reserve(kept.size());
    for (const std::size_t i : kept)
        states.push_back(m_states[i]);
    m_states = std::move(states);
}

void AdamSteps::move(std::vector<FitStroke> &strokes, const std::vector<StrokeSlope> &slopes, const StepSizes &sizes,
                     double rate)
{
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        State &state = m_states[i];
        ++state.steps;
        const double meanShare = 1 - std::pow(meanMemory, state.steps),
                     squareShare = 1 - std::pow(squareMemory, state.steps);
        const StrokeSlope sizesHere = stepsOf(strokes[i], sizes);
        for (std::size_t k = 0; k < strokeNumbers; ++k) {
            const double slope = slopes[i][k];
            state.mean[k] += (1 - meanMemory) * (slope - state.mean[k]);
            state.square[k] += (1 - squareMemory) * (slope * slope - state.square[k]);
            strokes[i][k] -=
                rate * sizesHere[k] * (state.mean[k] / meanShare) / (std::sqrt(state.square[k] / squareShare) + 1e-12);
        }
    }
}

} // namespace suffuse::fitting
