#include "render/drawing/drawn_paint.h"

#include "model/area/outline.h"
#include "model/painting/ryb.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr double unseenStep = 0.5 / 255;
constexpr int gradientParts = 8;
constexpr std::size_t mostSamples = 400;

DrawnColour shown(const std::array<double, 4> &ryb)
{
    const std::array<double, 3> rgb = srgbFromRyb(std::array<double, 3>{ryb[0], ryb[1], ryb[2]});
    return {rgb[0], rgb[1], rgb[2], 1};
}

DrawnColour between(const DrawnColour &a, const DrawnColour &b, double t)
{
    DrawnColour out;
    for (std::size_t c = 0; c < 4; ++c)
        out[c] = std::lerp(a[c], b[c], t);
    return out;
}

struct Sample {
    Point at; ///< canvas units
    DrawnColour colour;
};

/// The colour on contours and along the segments.
std::vector<Sample> samplesOf(const contours::StrokeContours &contours, const std::vector<contours::Band> &bands)
{
    const Stroke &stroke = contours.stroke();
    std::vector<Point> places;
    for (const contours::Band &band : bands)
        for (const std::vector<Cubic> &loop : band.loops)
            for (const Cubic &curve : loop)
                places.push_back(curve.p[0]);
    const std::size_t every = places.size() / mostSamples + 1;
    std::vector<Sample> out;
    const auto take = [&](Point at) {
        const std::array<double, 4> ryb = contours.field().colourAt(at - stroke.origin);
        out.push_back({at, shown(ryb)});
    };
    for (std::size_t i = 0; i < places.size(); i += every)
        take(places[i]);
    for (const Segment &segment : stroke.segments)
        if (!segment.takesPaint() && segment.density > 0)
            take(stroke.cubicOf(segment).at(0.5));
    return out;
}

/// The direction in which colours change most, of length 1, by least squares.
Point directionOf(const std::vector<Sample> &samples, Point centre)
{
    double xx = 0, xy = 0, yy = 0;
    std::array<Point, 3> along{};
    std::array<double, 3> mean{};
    for (const Sample &s : samples)
        for (std::size_t c = 0; c < 3; ++c)
            mean[c] += s.colour[c] / double(samples.size());
    for (const Sample &s : samples) {
        const Point d = s.at - centre;
        xx += d.x * d.x, xy += d.x * d.y, yy += d.y * d.y;
        for (std::size_t c = 0; c < 3; ++c)
            along[c] = along[c] + (s.colour[c] - mean[c]) * d;
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1e-9 * xx * yy)) { // They lie on a line.
        const double size = std::hypot(xx, yy);
        return size > 0 ? (1 / std::hypot(std::sqrt(xx), std::sqrt(yy))) *
                              Point{std::sqrt(xx), std::copysign(std::sqrt(yy), xy)}
                        : Point{1, 0};
    }
    // The slopes of the channels, and the direction that most of them have.
    double sxx = 0, sxy = 0, syy = 0;
    for (const Point &a : along) {
        const Point slope{(yy * a.x - xy * a.y) / determinant, (xx * a.y - xy * a.x) / determinant};
        sxx += slope.x * slope.x, sxy += slope.x * slope.y, syy += slope.y * slope.y;
    }
    const double angle = 0.5 * std::atan2(2 * sxy, sxx - syy);
    return {std::cos(angle), std::sin(angle)};
}

DrawnPaint even(const DrawnColour &colour)
{
    return {{{0, colour}}, {}, {}};
}

DrawnPaint fitted(const std::vector<Sample> &samples)
{
    if (samples.empty())
        return even({0, 0, 0, 1});
    Point centre;
    DrawnColour low = samples.front().colour, high = low;
    for (const Sample &s : samples) {
        centre = centre + (1.0 / double(samples.size())) * s.at;
        for (std::size_t c = 0; c < 4; ++c)
            low[c] = std::min(low[c], s.colour[c]), high[c] = std::max(high[c], s.colour[c]);
    }
    const auto isSame = [&] {
        for (std::size_t c = 0; c < 3; ++c)
            if (high[c] - low[c] > unseenStep)
                return false;
        return true;
    };
    if (isSame())
        return even(between(low, high, 0.5));
    const Point direction = directionOf(samples, centre);
    double begin = std::numeric_limits<double>::infinity(), end = -begin;
    for (const Sample &s : samples) {
        begin = std::min(begin, dot(s.at - centre, direction));
        end = std::max(end, dot(s.at - centre, direction));
    }
    if (!(end > begin))
        return even(between(low, high, 0.5));
    // Each stop is the mean of what lies around it, the nearer the more.
    std::array<DrawnColour, gradientParts + 1> sums{};
    std::array<double, gradientParts + 1> weights{};
    for (const Sample &s : samples) {
        const double place = (dot(s.at - centre, direction) - begin) / (end - begin) * gradientParts;
        const std::size_t k = std::min(std::size_t(place), std::size_t(gradientParts - 1));
        const double share = place - double(k);
        for (const auto &[at, weight] : {std::pair(k, 1 - share), std::pair(k + 1, share)}) {
            weights[at] += weight;
            for (std::size_t c = 0; c < 4; ++c)
                sums[at][c] += weight * s.colour[c];
        }
    }
    DrawnPaint paint{{}, centre + begin * direction, centre + end * direction};
    for (std::size_t k = 0; k <= gradientParts; ++k)
        if (weights[k] > 1e-6) {
            for (double &channel : sums[k])
                channel /= weights[k];
            paint.stops.push_back({double(k) / gradientParts, sums[k]});
        }
    return paint;
}

/// The gradient of a fill, with more stops where paint takes another way between two colours than a screen.
DrawnPaint ofFill(const Stroke &stroke)
{
    const Fill &fill = *stroke.fill;
    const Colour &a = fill.colour, &b = fill.gradient->colour;
    const double most = std::max(double(a.opacity), double(b.opacity));
    DrawnPaint paint{{}, stroke.origin + fill.gradient->from, stroke.origin + fill.gradient->to};
    for (int k = 0; k <= gradientParts; ++k) {
        const double t = double(k) / gradientParts;
        const auto mix = [t](float x, float y) { return std::lerp(double(x), double(y), t); };
        DrawnColour colour = shown({mix(a.red, b.red), mix(a.yellow, b.yellow), mix(a.blue, b.blue), 1});
        colour[3] = most > 0 ? mix(a.opacity, b.opacity) / most : 0;
        paint.stops.push_back({t, colour});
    }
    return paint;
}

} // namespace

DrawnColour DrawnPaint::at(Point canvas) const
{
    if (!isGradient())
        return stops.empty() ? DrawnColour{} : stops.front().colour;
    const Point way = to - from;
    const double place = dot(canvas - from, way) / dot(way, way);
    if (place <= stops.front().place)
        return stops.front().colour;
    for (std::size_t k = 1; k < stops.size(); ++k)
        if (place < stops[k].place)
            return between(stops[k - 1].colour, stops[k].colour,
                           (place - stops[k - 1].place) / (stops[k].place - stops[k - 1].place));
    return stops.back().colour;
}

DrawnPaint paintOf(const contours::StrokeContours &contours, const std::vector<contours::Band> &bands)
{
    const Stroke &stroke = contours.stroke();
    if (const std::optional<Colour> colour = contours.field().evenColour())
        return even(shown({double(colour->red), double(colour->yellow), double(colour->blue), 1}));
    if (isFillAlone(stroke) && stroke.fill->gradient) {
        DrawnPaint paint = ofFill(stroke);
        if (!contours.isCrisp()) // Bands have the opacity.
            for (DrawnPaint::Stop &stop : paint.stops)
                stop.colour[3] = 1;
        return paint;
    }
    return fitted(samplesOf(contours, bands));
}

} // namespace suffuse
