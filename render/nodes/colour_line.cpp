#include "render/nodes/colour_line.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse {

namespace {

using Channels = std::array<double, 4>;

Channels channelsOf(const Colour &c)
{
    return {double(c.red), double(c.yellow), double(c.blue), double(c.opacity)};
}

Channels difference(const Colour &a, const Colour &b)
{
    Channels d = channelsOf(a);
    const Channels other = channelsOf(b);
    for (std::size_t i = 0; i < d.size(); ++i)
        d[i] -= other[i];
    return d;
}

double dot(const Channels &a, const Channels &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

} // namespace

float ColourLine::placeOf(const Colour &c) const
{
    const Channels along = difference(to, from);
    return float(std::clamp(dot(difference(c, from), along) / dot(along, along), 0.0, 1.0));
}

std::optional<ColourLine> lineThrough(std::span<const NodeValues> rows)
{
    const auto farthestFrom = [&](const Colour &c) {
        const auto distance = [&](const NodeValues &v) {
            const Channels d = difference(v.colour, c);
            return dot(d, d);
        };
        const auto isNearer = [&](const NodeValues &a, const NodeValues &b) {
            return b.laysPaint() && (!a.laysPaint() || distance(a) < distance(b));
        };
        return std::max_element(rows.begin(), rows.end(), isNearer)->colour;
    };
    // On a line, the colour that is farthest from any other is one of its ends.
    ColourLine line;
    line.from = farthestFrom(firstLaying(rows)->colour);
    line.to = farthestFrom(line.from);
    if (line.from == line.to)
        return {};
    const Channels along = difference(line.to, line.from);
    for (const NodeValues &v : rows) {
        if (!v.laysPaint())
            continue;
        const Channels d = difference(v.colour, line.from);
        const double place = double(line.placeOf(v.colour));
        for (std::size_t i = 0; i < d.size(); ++i)
            if (std::abs(d[i] - place * along[i]) > 2e-6)
                return {};
    }
    return line;
}

} // namespace suffuse
