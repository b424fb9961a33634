#include "model/restyling/appearance.h"

#include "model/area/outline.h"
#include "model/brush/stroke_fit.h"
#include "model/paint/style_function.h"
#include "model/painting/fields.h"
#include "model/painting/validate.h"
#include "model/restyling/value_change.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace suffuse {

namespace {

struct RatioMean {
    double Appearance::*mean;
    float Segment::*member;
};
constexpr RatioMean ratioMeans[] = {{&Appearance::diffusion, &Segment::diffusion},
                                    {&Appearance::density, &Segment::density},
                                    {&Appearance::maxAge, &Segment::maxAge}};
constexpr std::array appearanceChannels{&Colour::red, &Colour::yellow, &Colour::blue, &Colour::opacity};

/// Indices of the segments that are meant: chosen ones that lay paint down, else all chosen ones.
std::vector<std::size_t> appearanceSegments(const Stroke &stroke, const std::vector<bool> &chosen)
{
    std::vector<std::size_t> painting, all;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        if (!chosen.empty() && !chosen[k])
            continue;
        all.push_back(k);
        if (!stroke.segments[k].takesPaint())
            painting.push_back(k);
    }
    return painting.empty() ? all : painting;
}

std::vector<double> lengthWeights(const Stroke &stroke, const std::vector<std::size_t> &segments)
{
    std::vector<double> weights;
    double sum = 0;
    for (const std::size_t k : segments) {
        weights.push_back(arcLength(stroke.cubicOf(stroke.segments[k])));
        sum += weights.back();
    }
    if (!(sum > 0))
        std::ranges::fill(weights, 1.0);
    return weights;
}

/// A weighted mean of what `valueOf` gives for the segments; those for which it gives nothing do not count.
template <class ValueOf>
std::optional<double> meanOver(const std::vector<std::size_t> &segments, const std::vector<double> &weights,
                               ValueOf valueOf)
{
    double sum = 0, weight = 0;
    for (std::size_t i = 0; i < segments.size(); ++i)
        if (const std::optional<double> value = valueOf(segments[i])) {
            sum += weights[i] * *value;
            weight += weights[i];
        }
    return weight > 0 ? std::optional(sum / weight) : std::nullopt;
}

/// A value changed so that the mean of all becomes another one, or made equal to it.
float changedTo(float value, double mean, double wished, ValueChange::Kind kind, const Domain &domain,
                Variation variation)
{
    const bool isRatio = kind == ValueChange::Scale;
    if (variation == Variation::Levelled || (isRatio && !(mean > 0 && wished > 0)))
        return float(wished);
    const double amount = isRatio ? wished / mean : wished - mean;
    return float(ValueChange{kind, amount, domain.leastFloat(), domain.greatest}.applied(double(value)));
}

/// Whether what is chosen of a stroke means its fill: all of it, or nothing but what bounds it.
bool meansTheFill(const Stroke &stroke, const std::vector<bool> &chosen)
{
    const std::vector<std::size_t> segments = appearanceSegments(stroke, chosen);
    return stroke.fill && (chosen.empty() || std::ranges::all_of(segments, [&](std::size_t k) {
                               return onlyBounds(stroke, k);
                           }));
}

std::array<double, 4> channelsIn(const Colour &colour)
{
    return {double(colour.red), double(colour.yellow), double(colour.blue), double(colour.opacity)};
}

/// A place of one box in another one.
Offset placedIn(Offset place, const Rect &from, const Rect &to)
{
    const auto along = [](double x, double low, double width, double toLow, double toWidth) {
        return float(toLow + (width > 0 ? (x - low) / width : 0.5) * toWidth);
    };
    return {along(double(place.x), from.left, from.width(), to.left, to.width()),
            along(double(place.y), from.top, from.height(), to.top, to.height())};
}

/// The fill of a stroke with an appearance; when and where it is stays. `before` is the style that it had.
Fill filledLike(Fill fill, const Appearance &appearance, const Style &before, const Rect &outline)
{
    if (!appearance.fill) { // that of paint, as dense to the eye as it was
        fill.diffusion = float(appearance.diffusion);
        fill.granulation = float(appearance.granulation);
        fill.maxAge = float(appearance.maxAge);
        for (std::size_t c = 0; c < appearanceChannels.size(); ++c)
            fill.colour.*appearanceChannels[c] = float(appearance.colour[c]);
        if (const double cut = visibleCut(before); cut > 0 && visibleCut(appearance.style) > 0)
            fill.density = float(double(fill.density) * visibleCut(appearance.style) / cut);
        fill.gradient.reset();
        return fill;
    }
    const Fill like = *appearance.fill;
    fill.diffusion = like.diffusion;
    fill.density = like.density;
    fill.granulation = like.granulation;
    fill.maxAge = like.maxAge;
    fill.colour = like.colour;
    fill.anisotropyRatio = like.anisotropyRatio;
    fill.anisotropyAngle = like.anisotropyAngle;
    const std::optional<Gradient> old = std::exchange(fill.gradient, like.gradient);
    if (fill.gradient && old) { // that of the stroke keeps its place
        fill.gradient->from = old->from;
        fill.gradient->to = old->to;
    } else if (fill.gradient) {
        fill.gradient->from = placedIn(like.gradient->from, appearance.outline, outline);
        fill.gradient->to = placedIn(like.gradient->to, appearance.outline, outline);
    }
    return fill;
}

Microseconds closedAt(const Stroke &stroke)
{
    Microseconds last = stroke.born();
    for (const Segment &segment : stroke.segments)
        if (!segment.takesPaint())
            last = std::max(last, segment.born);
    return last;
}

} // namespace

Appearance appearanceOf(const Stroke &stroke, const std::vector<bool> &chosen)
{
    const std::vector<std::size_t> segments = appearanceSegments(stroke, chosen);
    const std::vector<double> weights = lengthWeights(stroke, segments);
    Appearance result;
    result.style = segments.empty() ? stroke.style : stroke.styleOf(stroke.segments[segments.front()]);
    result.mix = stroke.mix;
    for (const RatioMean &ratio : ratioMeans) {
        const auto logarithm = [&](std::size_t k) -> std::optional<double> {
            const double value = double(stroke.segments[k].*ratio.member);
            return value > 0 ? std::optional(std::log(value)) : std::nullopt;
        };
        const std::optional<double> mean = meanOver(segments, weights, logarithm);
        result.*ratio.mean = mean ? std::exp(*mean) : 0;
    }
    result.granulation = meanOver(segments, weights, [&](std::size_t k) {
                             return std::optional(double(stroke.segments[k].granulation));
                         }).value_or(0);
    for (std::size_t c = 0; c < appearanceChannels.size(); ++c)
        result.colour[c] = meanOver(segments, weights, [&](std::size_t k) {
                               return std::optional(double(stroke.segments[k].colour.*appearanceChannels[c]));
                           }).value_or(0);
    if (!meansTheFill(stroke, chosen))
        return result;
    result.fill = stroke.fill;
    result.outline = outlineBox(stroke);
    result.isFillAlone = std::ranges::all_of(segments, [&](std::size_t k) { return onlyBounds(stroke, k); });
    if (result.isFillAlone) {
        result.style = stroke.style;
        result.diffusion = double(stroke.fill->diffusion);
        result.density = 0;
        result.granulation = double(stroke.fill->granulation);
        result.maxAge = double(stroke.fill->maxAge);
        result.colour = channelsIn(stroke.fill->colour);
    }
    return result;
}

Stroke withAppearance(const Stroke &stroke, const Appearance &appearance, Variation variation,
                      const std::vector<bool> &chosen)
{
    const Appearance before = appearanceOf(stroke, chosen);
    Stroke result = stroke;
    for (const std::size_t k : appearanceSegments(stroke, chosen)) {
        Segment segment = stroke.segments[k];
        for (const RatioMean &ratio : ratioMeans) {
            // Of a fill alone there is no density of a line, and it gives none; a crisp one has no D.
            const bool isDensity = ratio.mean == &Appearance::density;
            if (isDensity ? appearance.isFillAlone || onlyBounds(stroke, k) : !(appearance.*ratio.mean > 0))
                continue;
            segment.*ratio.member = changedTo(segment.*ratio.member, before.*ratio.mean, appearance.*ratio.mean,
                                              ValueChange::Scale, numberOf(ratio.member).traits.domain, variation);
        }
        segment.granulation = changedTo(segment.granulation, before.granulation, appearance.granulation,
                                        ValueChange::Shift, share, variation);
        for (std::size_t c = 0; c < appearanceChannels.size(); ++c) {
            float &channel = segment.colour.*appearanceChannels[c];
            channel = changedTo(channel, before.colour[c], appearance.colour[c], ValueChange::Shift, share, variation);
        }
        if (chosen.empty())
            segment.style.reset();
        else
            segment.style = appearance.style;
        if (problemOf(segment).isEmpty())
            result.segments[k] = std::move(segment);
    }
    if (before.fill) {
        result.fill = filledLike(*stroke.fill, appearance, stroke.style, outlineBox(stroke));
    } else if (chosen.empty() && appearance.fill && !appearance.isFillAlone) {
        Fill fill = *appearance.fill;
        fill.born = closedAt(stroke);
        fill.gradient.reset();
        result.fill = filledLike(fill, appearance, appearance.style, outlineBox(stroke));
    }
    if (chosen.empty()) {
        result.style = appearance.style;
        result.mix = appearance.mix;
    }
    return problemOf(result).isEmpty() ? result : stroke;
}

} // namespace suffuse
