#include "render/reference/compositing.h"

#include <algorithm>
#include <cmath>

namespace suffuse::reference {

namespace {

struct Visible {
    std::size_t place;
    std::vector<const Group *> around; ///< the isolated groups, the outermost first
};

std::vector<Item> itemsOf(const std::vector<Visible> &strokes, std::size_t from, std::size_t to, std::size_t depth)
{
    const auto groupOf = [&](std::size_t i) {
        return strokes[i].around.size() > depth ? strokes[i].around[depth] : nullptr;
    };
    std::vector<Item> items;
    for (std::size_t i = from; i < to;) {
        Item item;
        const Group *group = groupOf(i);
        if (!group) {
            item.stroke = strokes[i++].place;
        } else {
            std::size_t end = i;
            while (end < to && groupOf(end) == group)
                ++end;
            item.isGroup = true, item.opacity = double(group->opacity), item.blend = group->blend;
            item.inside = itemsOf(strokes, i, end, depth + 1);
            i = end;
        }
        items.push_back(std::move(item));
    }
    return items;
}

double lum(const Rgb &c)
{
    return 0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2];
}

double sat(const Rgb &c)
{
    return std::max({c[0], c[1], c[2]}) - std::min({c[0], c[1], c[2]});
}

Rgb clipColor(Rgb c)
{
    const double l = lum(c), n = std::min({c[0], c[1], c[2]}), x = std::max({c[0], c[1], c[2]});
    for (double &v : c) {
        if (n < 0)
            v = l + (v - l) * l / (l - n);
        if (x > 1)
            v = l + (v - l) * (1 - l) / (x - l);
    }
    return c;
}

Rgb setLum(const Rgb &c, double l)
{
    const double d = l - lum(c);
    return clipColor({c[0] + d, c[1] + d, c[2] + d});
}

Rgb setSat(const Rgb &c, double s)
{
    std::array<std::size_t, 3> order{0, 1, 2};
    std::ranges::sort(order, {}, [&](std::size_t i) { return c[i]; });
    Rgb out{};
    const auto [least, middle, most] = order;
    if (c[most] > c[least]) {
        out[middle] = (c[middle] - c[least]) * s / (c[most] - c[least]);
        out[most] = s;
    }
    return out;
}

/// As docs/solver.md has it: the recommendation's jumps are ramps half a level of 8 bits wide.
constexpr double leastDivisor = 1.0 / 512;

double hardLight(double cb, double cs)
{
    return cs <= 0.5 ? cb * 2 * cs : cb + (2 * cs - 1) - cb * (2 * cs - 1);
}

double separable(BlendMode mode, double cb, double cs)
{
    switch (mode) {
    case BlendMode::Multiply:
        return cb * cs;
    case BlendMode::Screen:
        return cb + cs - cb * cs;
    case BlendMode::Overlay:
        return hardLight(cs, cb);
    case BlendMode::Darken:
        return std::min(cb, cs);
    case BlendMode::Lighten:
        return std::max(cb, cs);
    case BlendMode::ColourDodge:
        return std::min(1.0, cb / std::max(1 - cs, leastDivisor));
    case BlendMode::ColourBurn:
        return 1 - std::min(1.0, (1 - cb) / std::max(cs, leastDivisor));
    case BlendMode::HardLight:
        return hardLight(cb, cs);
    case BlendMode::SoftLight: {
        if (cs <= 0.5)
            return cb - (1 - 2 * cs) * cb * (1 - cb);
        const double d = cb <= 0.25 ? ((16 * cb - 12) * cb + 4) * cb : std::sqrt(cb);
        return cb + (2 * cs - 1) * (d - cb);
    }
    case BlendMode::Difference:
        return std::abs(cb - cs);
    case BlendMode::Exclusion:
        return cb + cs - 2 * cb * cs;
    default:
        return cs;
    }
}

Rgb blend(BlendMode mode, const Rgb &cb, const Rgb &cs)
{
    switch (mode) {
    case BlendMode::Hue:
        return setLum(setSat(cs, sat(cb)), lum(cb));
    case BlendMode::Saturation:
        return setLum(setSat(cb, sat(cs)), lum(cb));
    case BlendMode::Colour:
        return setLum(cs, lum(cb));
    case BlendMode::Luminosity:
        return setLum(cb, lum(cs));
    default:
        return {separable(mode, cb[0], cs[0]), separable(mode, cb[1], cs[1]), separable(mode, cb[2], cs[2])};
    }
}

/// The colour of what covers a share of a spot that is white otherwise.
Rgb straight(const Spot &spot)
{
    Rgb rgb = rgbOfRyb(spot.colour);
    for (double &v : rgb)
        v = spot.coverage > 0 ? std::clamp((v - (1 - spot.coverage)) / spot.coverage, 0.0, 1.0) : 0;
    return rgb;
}

} // namespace

std::vector<Item> itemsOf(const Painting &painting)
{
    std::vector<Visible> strokes;
    for (const StrokePtr &stroke : painting.strokes) {
        if (!painting.isVisible(*stroke))
            continue;
        Visible visible{strokes.size(), {}};
        for (GroupId id = stroke->group; id != 0;) {
            const auto group = std::ranges::find(painting.groups, id, &Group::id);
            if (group == painting.groups.end())
                break;
            if (group->isIsolated())
                visible.around.insert(visible.around.begin(), &*group);
            id = group->parent;
        }
        strokes.push_back(std::move(visible));
    }
    return itemsOf(strokes, 0, strokes.size(), 0);
}

void put(const Item &group, const Spot &source, const Rgb *canvas, Spot &below)
{
    const double as = source.coverage * group.opacity, ab = canvas ? 1 : below.coverage;
    const Rgb cs = straight(source), under = rgbOfRyb(below.colour), cb = canvas ? under : straight(below);
    const Rgb mixed = blend(group.blend, cb, cs);
    const double paint = below.coverage; // The canvas is no paint.
    Rgb out;
    double coverage = as + paint * (1 - as);
    for (std::size_t i = 0; i < 3; ++i) {
        const double bare = canvas ? (*canvas)[i] : 1;
        double premultiplied = 0, alpha = as + ab * (1 - as);
        switch (group.blend) {
        case BlendMode::Plus:
            alpha = std::min(1.0, as + ab), premultiplied = std::min(1.0, as * cs[i] + ab * cb[i]);
            coverage = std::min(1.0, as + paint);
            break;
        case BlendMode::DestinationIn:
            out[i] = bare + as * (under[i] - bare);
            coverage = paint * as;
            continue;
        case BlendMode::DestinationOut:
            out[i] = bare + (1 - as) * (under[i] - bare);
            coverage = paint * (1 - as);
            continue;
        case BlendMode::SourceAtop:
            // On a transparent ground this is as·ab·Cs + (1 − as)·ab·Cb. On the canvas it shows on paint alone.
            alpha = ab, premultiplied = as * paint * cs[i] + (ab - as * paint) * cb[i];
            coverage = paint;
            break;
        default: {
            const double source = (1 - ab) * cs[i] + ab * mixed[i];
            premultiplied = as * source + (1 - as) * ab * cb[i];
        }
        }
        out[i] = std::clamp(premultiplied + (1 - alpha), 0.0, 1.0);
    }
    below = {rybOfRgb(out), coverage};
}

} // namespace suffuse::reference
