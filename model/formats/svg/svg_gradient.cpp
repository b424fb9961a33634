#include "model/formats/svg/svg_gradient.h"

#include "model/formats/svg/svg_shapes.h"
#include "model/painting/ryb.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr int deepestReference = 32;
constexpr int mostShades = 64;

/// The attribute of the gradient, or of the first one that has it of those from which it takes what it lacks.
QString attributeOf(const SvgElement &gradient, const char *name, const SvgTree &tree)
{
    const SvgElement *element = &gradient;
    for (int hops = 0; element && hops < deepestReference; ++hops, element = tree.target(*element))
        if (const QString value = element->attribute(name); !value.isEmpty())
            return value.trimmed();
    return {};
}

/// A coordinate: of the box as a share of it, else in units, where per cents count by `whole`.
double coordinateOf(const QString &text, bool boxed, double whole, double usualShare)
{
    if (text.isEmpty())
        return boxed ? usualShare : usualShare * whole;
    if (text.endsWith(u'%')) {
        bool ok = false;
        const double share = text.chopped(1).toDouble(&ok) / 100;
        return ok ? (boxed ? share : share * whole) : 0;
    }
    return svgLength(text).value_or(0);
}

SvgColour between(const SvgColour &a, const SvgColour &b, double share)
{
    SvgColour colour;
    for (std::size_t i = 0; i < 4; ++i)
        colour[i] = a[i] + share * (b[i] - a[i]);
    return colour;
}

/// How far the paint of two colours, mixed half and half, is from the colour halfway between them on a screen.
double bend(const SvgColour &a, const SvgColour &b)
{
    const auto ryb = [](const SvgColour &c) { return rybFromSrgb({c[0], c[1], c[2]}); };
    const std::array<double, 3> p = ryb(a), q = ryb(b);
    const std::array<double, 3> mixed =
        srgbFromRyb(std::array{0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2])});
    const SvgColour wanted = between(a, b, 0.5);
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i)
        most = std::max(most, std::abs(mixed[i] - wanted[i]));
    return most;
}

/// Stops between which paint changes as the screen's colour does.
std::vector<SvgStop> refined(const std::vector<SvgStop> &stops)
{
    std::vector<SvgStop> fine{stops.front()};
    for (std::size_t i = 1; i < stops.size(); ++i) {
        const SvgStop &a = stops[i - 1], &b = stops[i];
        const int parts =
            a.offset < b.offset ? std::clamp(int(std::ceil(std::sqrt(bend(a.colour, b.colour) / 0.01))), 1, 8) : 1;
        for (int k = 1; k <= parts; ++k) {
            const double share = double(k) / parts;
            fine.push_back({a.offset + share * (b.offset - a.offset), between(a.colour, b.colour, share)});
        }
    }
    return fine;
}

} // namespace

std::vector<SvgShade> svgShades(const SvgElement &gradient, const Rect &box, const SvgMatrix &matrix,
                                const Rect &viewport, double opacity, const SvgColour &current, SvgTree &tree)
{
    if (gradient.name != QLatin1String("linearGradient"))
        return {};
    std::vector<SvgStop> stops = svgStops(&gradient, current, tree);
    const QString spread = attributeOf(gradient, "spreadMethod", tree);
    if (stops.empty() || (!spread.isEmpty() && spread != QLatin1String("pad")))
        return {};
    for (SvgStop &stop : stops)
        stop.colour[3] *= opacity;
    const bool boxed = attributeOf(gradient, "gradientUnits", tree) != QLatin1String("userSpaceOnUse");
    const auto at = [&](const char *name, double whole, double usual) {
        return coordinateOf(attributeOf(gradient, name, tree), boxed, whole, usual);
    };
    const Point a{at("x1", viewport.width(), 0), at("y1", viewport.height(), 0)};
    const Point b{at("x2", viewport.width(), 1), at("y2", viewport.height(), 0)};
    SvgMatrix whole = matrix;
    if (boxed)
        whole = whole * SvgMatrix{box.width(), 0, 0, box.height(), box.left, box.top};
    whole = whole * svgTransform(attributeOf(gradient, "gradientTransform", tree));
    // Lines of one colour are mapped as lines, so the way between the points is turned by the inverse transposed
    // matrix.
    const Point along = b - a;
    const double squared = along.x * along.x + along.y * along.y, determinant = whole.a * whole.d - whole.b * whole.c;
    const SvgStop &last = stops.back();
    if (!(squared > 0) || determinant == 0 || !std::isfinite(determinant)) // it is painted with the last colour
        return {{whole.map(a), whole.map(a) + Point{1, 0}, last.colour, last.colour}};
    const Point slope = (1 / squared) * along;
    const Point turned{(whole.d * slope.x - whole.b * slope.y) / determinant,
                       (whole.a * slope.y - whole.c * slope.x) / determinant};
    const Point from = whole.map(a), way = (1 / (turned.x * turned.x + turned.y * turned.y)) * turned;
    const auto place = [&](double offset) { return from + offset * way; };
    const bool evenlyOpaque =
        std::ranges::all_of(stops, [&](const SvgStop &stop) { return stop.colour[3] == last.colour[3]; });
    const std::vector<SvgStop> fine = evenlyOpaque ? refined(stops) : stops;
    if (fine.size() == 1)
        return {{place(0), place(1), last.colour, last.colour}};
    // Of shades over each other the upper ones must not let the lower through once they have begun.
    const bool oneIsEnough = fine.size() == 2;
    if (!oneIsEnough && (!evenlyOpaque || last.colour[3] < 1 || fine.size() > mostShades))
        return {};
    constexpr double jump = 1e-4; // where two stops stand at one place, a share of the way
    std::vector<SvgShade> shades;
    for (std::size_t i = 1; i < fine.size(); ++i) {
        const double begin = fine[i - 1].offset, end = std::max(fine[i].offset, begin + jump);
        SvgColour before = fine[i - 1].colour;
        if (i > 1) { // Over what is there the new colour comes up from nothing, which mixes the two evenly.
            before = fine[i].colour;
            before[3] = 0;
        }
        shades.push_back({place(begin), place(end), before, fine[i].colour});
    }
    return shades;
}

} // namespace suffuse
