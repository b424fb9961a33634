#include "model/shaping/curves/runs.h"

#include "model/brush/stroke_fit.h"
#include "model/shaping/curves/split.h"

namespace suffuse {

std::vector<Chain> runsOf(const Stroke &stroke, const std::vector<bool> &chosen)
{
    const auto isChosen = [&](int k) { return chosen.empty() || chosen[std::size_t(k)]; };
    std::vector<Chain> runs;
    for (const Chain &chain : chainsOf(stroke))
        for (int k = chain.first; k <= chain.last; ++k) {
            if (!isChosen(k))
                continue;
            if (k > chain.first && isChosen(k - 1))
                runs.back().last = k;
            else
                runs.push_back({k, k});
        }
    return runs;
}

std::vector<bool> meantOfWhole(const Stroke &stroke)
{
    std::vector<bool> meant;
    if (stroke.hasErasure() && stroke.laysPaint())
        for (const Segment &segment : stroke.segments)
            meant.push_back(!segment.takesPaint());
    return meant;
}

bool breaksBetween(const Segment &before, const Segment &after)
{
    return dot(endDirection(offsetsOf(before)), startDirection(offsetsOf(after))) < smoothCosine;
}

std::vector<Chain> smoothRunsOf(const Stroke &stroke, const std::vector<bool> &chosen)
{
    std::vector<Chain> parts;
    for (const Chain &run : runsOf(stroke, chosen)) {
        parts.push_back({run.first, run.first});
        for (int k = run.first + 1; k <= run.last; ++k)
            if (breaksBetween(stroke.segments[std::size_t(k - 1)], stroke.segments[std::size_t(k)]))
                parts.push_back({k, k});
            else
                parts.back().last = k;
    }
    return parts;
}

RunPath::RunPath(const Stroke &stroke, const Chain &r) : run(r)
{
    lengths.push_back(0);
    for (int k = run.first; k <= run.last; ++k) {
        curves.push_back(offsetsOf(stroke.segments[std::size_t(k)]));
        lengths.push_back(lengths.back() + arcLength(curves.back()));
    }
    joinsBefore = !stroke.beginsChain(std::size_t(run.first));
    const std::size_t next = std::size_t(run.last) + 1;
    joinsAfter = next < stroke.segments.size() && !stroke.beginsChain(next);
}

void writeCurves(Stroke &stroke, int first, const std::vector<Cubic> &curves)
{
    for (std::size_t i = 0; i < curves.size(); ++i) {
        Segment &segment = stroke.segments[std::size_t(first) + i];
        segment.bezier = toOffsets(curves[i]);
        if (i > 0)
            segment.bezier[0] = stroke.segments[std::size_t(first) + i - 1].bezier[3];
    }
}

double smoothStep(double x)
{
    x = std::clamp(x, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

double smoothStepSlope(double x)
{
    return x <= 0 || x >= 1 ? 0 : 6 * x * (1 - x);
}

} // namespace suffuse
