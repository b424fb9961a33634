#include "render/reference/compositing.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace suffuse::reference {

namespace {

/// Whether a clipped group is in an item, at any depth.
bool clipsWithin(const Item &item)
{
    return std::ranges::any_of(item.inside,
                               [](const Item &i) { return i.isGroup && (i.base != Item::nothing || clipsWithin(i)); });
}

/// A mask in which nothing is seen masks nothing.
bool isMasked(const Item &item)
{
    return std::ranges::any_of(item.inside, [](const Item &i) { return i.isMask && i.isSeen(); });
}

/// Isolates groups because of what is in them, or of what is clipped to them.
void isolate(Item &item)
{
    for (Item &i : item.inside) {
        isolate(i);
        if (i.base != Item::nothing && clipsWithin(item.inside[i.base]))
            item.inside[i.base].isIsolated = true;
    }
    item.isIsolated = item.isIsolated || isMasked(item);
}

/// One stroke with the segments of several.
StrokePtr united(const std::vector<StrokePtr> &strokes, const Wash &wash)
{
    auto all = std::make_shared<Stroke>(*strokes.front());
    all->style = wash.style, all->mix = wash.mix;
    all->picture = {};
    for (std::size_t i = 1; i < strokes.size(); ++i)
        for (std::size_t k = 0; k < strokes[i]->segments.size(); ++k) {
            Segment segment = strokes[i]->segments[k];
            segment.start = strokes[i]->beginsChain(k);
            for (Offset &p : segment.bezier)
                p = toOffset(strokes[i]->origin + p, all->origin);
            all->segments.push_back(std::move(segment));
        }
    return all;
}

/// Puts strokes into the tree of groups, one after another.
class TreeBuilder {
public:
    explicit TreeBuilder(const Painting &painting) : m_painting(painting) { m_root.isGroup = true; }

    Drawing drawing()
    {
        for (const StrokePtr &stroke : m_painting.strokes)
            add(stroke);
        for (std::size_t i = 0; i < m_washes.size(); ++i)
            m_drawing.strokes[m_washes[i].place].stroke =
                united(m_drawing.strokes[m_washes[i].place].members, m_washes[i].wash);
        isolate(m_root);
        m_drawing.items = m_root.isIsolated ? std::vector{m_root} : m_root.inside;
        return std::move(m_drawing);
    }

private:
    struct Laid {
        const Group *group;
        Wash wash;
        std::size_t place;
    };

    std::vector<const Group *> pathOf(const Stroke &stroke) const
    {
        std::vector<const Group *> path;
        for (const Group *group = m_painting.findGroup(stroke.group); group;
             group = m_painting.findGroup(group->parent))
            path.insert(path.begin(), group);
        return path;
    }

    void add(const StrokePtr &stroke)
    {
        const std::vector<const Group *> path = pathOf(*stroke);
        // A mask within a wash is no part of it.
        const auto wash = std::ranges::find_if(path, [](const Group *g) { return g->wash.has_value(); });
        const bool isMask = std::any_of(wash, path.end(), [&](const Group *g) { return g != *wash && g->mask; });
        const bool isWashed = wash != path.end() && !isMask;
        Item &in = enter(path, isWashed ? std::size_t(wash - path.begin()) + 1 : path.size());
        Item item;
        if (m_painting.isVisible(*stroke)) {
            if (isWashed && !stroke->fill && m_lastWash && m_lastWash->group == *wash) {
                m_drawing.strokes[m_lastWash->place].members.push_back(stroke);
                return;
            }
            item.stroke = m_drawing.strokes.size();
            m_drawing.strokes.push_back({stroke, {stroke}});
            if (isWashed && !stroke->fill) {
                m_washes.push_back({*wash, *(*wash)->wash, item.stroke});
                m_lastWash = m_washes.back();
            } else if (isWashed) {
                auto own = std::make_shared<Stroke>(*stroke);
                own->style = (*wash)->wash->style, own->mix = (*wash)->wash->mix;
                m_drawing.strokes.back().stroke = own;
            }
        }
        in.inside.push_back(std::move(item));
    }

    /// The item of the group that is `depth` deep on the path of a stroke.
    Item &enter(const std::vector<const Group *> &path, std::size_t depth)
    {
        std::size_t same = 0;
        while (same < m_open.size() && same < depth && m_open[same] == path[same])
            ++same;
        m_open.resize(same);
        Item *item = &m_root;
        for (std::size_t i = 0; i < same; ++i)
            item = &item->inside[m_places[i]];
        m_places.resize(same);
        for (std::size_t i = same; i < depth; ++i) {
            const Group &group = *path[i];
            Item own;
            own.isGroup = true, own.isIsolated = group.isIsolated(), own.isMask = group.mask, own.clips = group.clips;
            own.opacity = double(group.opacity), own.blend = group.blend;
            if (group.clips)
                for (std::size_t k = item->inside.size(); k-- > 0 && own.base == Item::nothing;)
                    if (!item->inside[k].isMask && !item->inside[k].clips)
                        own.base = k;
            m_open.push_back(&group);
            m_places.push_back(item->inside.size());
            item->inside.push_back(std::move(own));
            item = &item->inside.back();
        }
        return *item;
    }

    const Painting &m_painting;
    Drawing m_drawing;
    Item m_root;
    std::vector<const Group *> m_open; ///< the groups around the last stroke, the outermost first
    std::vector<std::size_t> m_places; ///< where each of them is in the one around it
    std::vector<Laid> m_washes;
    std::optional<Laid> m_lastWash;
};

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

bool Item::isSeen() const
{
    return isGroup ? std::ranges::any_of(inside, &Item::isSeen) : stroke != nothing;
}

Drawing drawingOf(const Painting &painting)
{
    return TreeBuilder(painting).drawing();
}

void put(const Item &group, double share, const Spot &source, const Rgb *canvas, Spot &below)
{
    const double as = source.coverage * group.opacity * share, ab = canvas ? 1 : below.coverage;
    const Rgb cs = straight(source), under = rgbOfRyb(below.colour), cb = canvas ? under : straight(below);
    const Rgb mixed = blend(group.blend, cb, cs);
    const double paint = below.coverage; // The canvas is no paint.
    Rgb out;
    double coverage = as + paint * (1 - as);
    for (std::size_t i = 0; i < 3; ++i) {
        const double bare = canvas ? (*canvas)[i] : 1;
        switch (group.blend) {
        case BlendMode::Plus: {
            const double alpha = std::min(1.0, as + ab);
            out[i] = std::min(1.0, as * cs[i] + under[i] - (1 - ab)) + 1 - alpha;
            coverage = std::min(1.0, as + paint);
            break;
        }
        case BlendMode::DestinationIn:
            out[i] = bare + as * (under[i] - bare);
            coverage = paint * as;
            break;
        case BlendMode::DestinationOut:
            out[i] = bare + (1 - as) * (under[i] - bare);
            coverage = paint * (1 - as);
            break;
        case BlendMode::SourceAtop: // On the canvas it shows on paint alone.
            out[i] = under[i] + as * paint * (cs[i] - cb[i]);
            coverage = paint;
            break;
        default:
            out[i] = as * ((1 - ab) * cs[i] + ab * mixed[i]) + (1 - as) * under[i];
        }
        out[i] = std::clamp(out[i], 0.0, 1.0);
    }
    below = {rybOfRgb(out), coverage};
}

} // namespace suffuse::reference
