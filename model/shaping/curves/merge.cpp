#include "model/shaping/curves/merge.h"

#include "model/brush/stroke_fit.h"
#include "model/shaping/curves/curve_fit.h"
#include "model/shaping/curves/split.h"

namespace suffuse {

namespace {

/// The cubic whose parts below and above p are `a` and `b`, if they are such parts.
Cubic unsplit(const Cubic &a, const Cubic &b, double p)
{
    const Point start = (1 / p) * (a.p[1] - a.p[0]), end = (1 / (1 - p)) * (b.p[2] - b.p[3]);
    return {{a.p[0], a.p[0] + start, b.p[3] + end, b.p[3]}};
}

/// How far the parts of that cubic are from `a` and `b` in their middles, squared.
double mismatch(const Cubic &a, const Cubic &b, double p)
{
    const auto parts = unsplit(a, b, p).split(p);
    const Point before = parts[0].p[2] - a.p[2], at = parts[0].p[3] - a.p[3], after = parts[1].p[1] - b.p[1];
    return dot(before, before) + dot(at, at) + dot(after, after);
}

/// The parameter at which a cubic would have been split into `a` and `b`.
double splitBetween(const Cubic &a, const Cubic &b)
{
    constexpr int steps = 64;
    double best = 0.5;
    for (int i = 1; i < steps; ++i)
        if (mismatch(a, b, double(i) / steps) < mismatch(a, b, best))
            best = double(i) / steps;
    // At a node between parts of one cubic, the lengths of the handles are in proportion to the parts of the parameter.
    const double before = length(a.p[3] - a.p[2]), after = length(b.p[1] - b.p[0]);
    if (const double share = before / (before + after); share > 0 && share < 1)
        if (mismatch(a, b, share) < mismatch(a, b, best))
            best = share;
    // The step to the neighbours is halved each time, whether one of them was better or not.
    for (double step = 0.5 / steps; step > 1e-9; step *= 0.5)
        for (double other : {best - step, best + step})
            if (other > 0 && other < 1 && mismatch(a, b, other) < mismatch(a, b, best)) {
                best = other;
                break;
            }
    return best;
}

Cubic fitted(const std::vector<Cubic> &curves)
{
    CurveFit fit(curves);
    return fittedCubic(fit, startDirection(curves.front()), endDirection(curves.back()));
}

/// The cubic of which the curves, one after the other, are parts. No value if they are no such parts, as far as float32
/// can tell.
std::optional<Cubic> wholeOf(const std::vector<Cubic> &curves)
{
    Cubic whole = curves.front();
    std::vector<double> ends{1}; // the parameters of the whole at which the parts end, from the last one
    double polygon = polygonLength(whole);
    for (std::size_t i = 1; i < curves.size(); ++i) {
        const double p = splitBetween(whole, curves[i]);
        whole = unsplit(whole, curves[i], p);
        for (double &end : ends)
            end *= p;
        ends.push_back(1);
        polygon = std::max(polygon, polygonLength(curves[i]));
    }
    const double near = std::max(4 * resolutionAt(whole), 1e-5 * polygon);
    double from = 0;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        for (double p : {0.25, 0.5, 0.75, 1.0})
            if (!(length(whole.at(from + p * (ends[i] - from)) - curves[i].at(p)) <= near))
                return std::nullopt;
        from = ends[i];
    }
    return whole;
}

} // namespace

Segment withValuesOf(const std::vector<Segment> &run)
{
    std::vector<const Segment *> all;
    const Segment *longest = nullptr;
    double most = -1;
    for (const Segment &s : run) {
        all.push_back(&s);
        if (const double l = arcLength(offsetsOf(s)); l > most) {
            most = l;
            longest = &s;
        }
    }
    Segment result = *longest;
    result.node = run.front().node;
    result.start = run.front().start;
    setMeanValues(result, all);
    return result;
}

Segment merged(const std::vector<Segment> &run)
{
    if (run.size() == 1)
        return run.front();
    std::vector<Cubic> curves;
    for (const Segment &s : run)
        curves.push_back(offsetsOf(s));
    const std::optional<Cubic> whole = wholeOf(curves);
    Segment result = withValuesOf(run);
    result.bezier = toOffsets(whole ? *whole : fitted(curves));
    result.bezier[0] = run.front().bezier[0];
    result.bezier[3] = run.back().bezier[3];
    return result;
}

} // namespace suffuse
