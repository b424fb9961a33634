#include "model/formats/svg/svg_gradient.h"

#include "model/area/offset_curve.h"
#include "model/formats/svg/paths/svg_outlines.h"
#include "model/formats/svg/svg_shingles.h"
#include "model/painting/ryb.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

constexpr int deepestReference = 32;
constexpr std::size_t mostShades = 64;   ///< over each other
constexpr std::size_t mostApart = 1'000; ///< beside each other, or within each other

bool isGradient(const SvgElement *element)
{
    return element &&
           (element->name == QLatin1String("linearGradient") || element->name == QLatin1String("radialGradient"));
}

/// The attribute of the gradient, or of the first one that has it of those from which it takes what it lacks.
QString attributeOf(const SvgElement &gradient, const char *name, const SvgTree &tree)
{
    const SvgElement *element = &gradient;
    for (int hops = 0; isGradient(element) && hops < deepestReference; ++hops, element = tree.target(*element))
        if (const QString value = element->attribute(name); !value.isEmpty())
            return value.trimmed();
    return {};
}

SvgColour between(const SvgColour &a, const SvgColour &b, double share)
{
    SvgColour colour;
    for (std::size_t i = 0; i < 4; ++i)
        colour[i] = a[i] + share * (b[i] - a[i]);
    return colour;
}

/// How far mixed paint of two colours is from the colours between them on a screen: the most at a quarter, the half and
/// three quarters of the way. Near greys paint bends sharply, on one side only.
double bend(const SvgColour &a, const SvgColour &b)
{
    const auto ryb = [](const SvgColour &c) { return rybFromSrgb({c[0], c[1], c[2]}); };
    const std::array<double, 3> p = ryb(a), q = ryb(b);
    double most = 0;
    for (const double share : {0.25, 0.5, 0.75}) {
        const auto mix = [&](std::size_t i) { return p[i] + share * (q[i] - p[i]); };
        const std::array<double, 3> mixed = srgbFromRyb(std::array{mix(0), mix(1), mix(2)});
        const SvgColour wanted = between(a, b, share);
        for (std::size_t i = 0; i < 3; ++i)
            most = std::max(most, std::abs(mixed[i] - wanted[i]));
    }
    return most;
}

/// Adds the stops behind `a` up to `b` between which paint changes as the screen's colour does.
void addRefined(const SvgStop &a, const SvgStop &b, int halvings, std::vector<SvgStop> &fine)
{
    constexpr double most = 0.01;
    if (halvings == 0 || !(a.offset < b.offset) || bend(a.colour, b.colour) <= most) {
        fine.push_back(b);
        return;
    }
    const SvgStop middle{0.5 * (a.offset + b.offset), between(a.colour, b.colour, 0.5)};
    addRefined(a, middle, halvings - 1, fine);
    addRefined(middle, b, halvings - 1, fine);
}

std::vector<SvgStop> refined(const std::vector<SvgStop> &stops)
{
    constexpr int mostHalvings = 5;
    std::vector<SvgStop> fine{stops.front()};
    for (std::size_t i = 1; i < stops.size(); ++i)
        addRefined(stops[i - 1], stops[i], mostHalvings, fine);
    return fine;
}

/// Finds the shades of one use of a gradient.
class ShadeFinder {
public:
    ShadeFinder(const SvgGradientUse &use, SvgTree &tree) : m_use(use), m_tree(tree)
    {
        m_boxed = attribute("gradientUnits") != QLatin1String("userSpaceOnUse");
        m_units = use.units;
        m_whole = use.matrix;
        if (m_boxed) {
            m_units.width = m_units.height = 1;
            m_whole = m_whole * SvgMatrix{use.box.width(), 0, 0, use.box.height(), use.box.left, use.box.top};
        }
        m_whole = m_whole * svgTransform(attribute("gradientTransform"));
        m_stops = svgStops(&use.gradient, tree);
        for (SvgStop &stop : m_stops)
            stop.colour[3] *= use.opacity;
        m_isOpaque = std::ranges::all_of(m_stops, [](const SvgStop &stop) { return stop.colour[3] == 1; });
    }

    std::optional<std::vector<SvgShade>> find()
    {
        // Shares of a box without width or height mean nothing.
        const bool isFlat = m_boxed && !(m_use.box.width() > 0 && m_use.box.height() > 0);
        if (m_stops.empty() || isFlat || isCircular())
            return std::vector<SvgShade>();
        const bool isRadial = m_use.gradient.name == QLatin1String("radialGradient");
        const double determinant = m_whole.a * m_whole.d - m_whole.b * m_whole.c;
        if (determinant == 0 || !std::isfinite(determinant))
            return std::vector{evenly(m_stops.back().colour)};
        if (!(isRadial ? radial() : linear()) || !std::ranges::all_of(m_shades, isDrawable))
            return {};
        return std::move(m_shades);
    }

private:
    QString attribute(const char *name) const { return attributeOf(m_use.gradient, name, m_tree); }
    std::optional<double> length(const char *name, SvgAxis axis) const
    {
        return svgLength(attribute(name), m_units, axis);
    }
    /// A coordinate; where there is none, a share of the whole.
    double at(const char *name, SvgAxis axis, double share) const
    {
        return length(name, axis).value_or(*svgLength(QString::number(100 * share) + QLatin1Char('%'), m_units, axis));
    }

    bool isCircular() const
    {
        const SvgElement *element = &m_use.gradient;
        for (int hops = 0; isGradient(element); ++hops, element = m_tree.target(*element))
            if (hops > deepestReference)
                return true;
        return false;
    }

    static bool isDrawable(const SvgShade &shade)
    {
        bool isFine = isReckonable(shade.from) && isReckonable(shade.to);
        for (const std::vector<Cubic> &loop : shade.within)
            for (const Cubic &curve : loop)
                isFine = isFine && std::ranges::all_of(curve.p, isReckonable);
        return isFine;
    }

    SvgShade evenly(const SvgColour &colour) const { return {{}, {1, 0}, colour, colour, {}}; }

    /// The points of the document's plane where a gradient would be 0 at `origin` and rise by 1 along `slope`.
    bool linear()
    {
        const Point a{at("x1", SvgAxis::Across, 0), at("y1", SvgAxis::Down, 0)};
        const Point b{at("x2", SvgAxis::Across, 1), at("y2", SvgAxis::Down, 0)};
        const Point along = b - a;
        const double squared = dot(along, along), determinant = m_whole.a * m_whole.d - m_whole.b * m_whole.c;
        if (!(squared > 0)) { // It is painted with the last colour.
            m_shades = {evenly(m_stops.back().colour)};
            return true;
        }
        // Lines of one colour are mapped as lines, so the way between the points is turned by the inverse transposed
        // matrix.
        const Point slope = (1 / squared) * along;
        const Point turned{(m_whole.d * slope.x - m_whole.b * slope.y) / determinant,
                           (m_whole.a * slope.y - m_whole.c * slope.x) / determinant};
        m_from = m_whole.map(a), m_way = (1 / dot(turned, turned)) * turned;
        double low = 0, high = 1;
        for (const Point corner : {Point{m_use.seen.left, m_use.seen.top},
                                   {m_use.seen.right, m_use.seen.top},
                                   {m_use.seen.left, m_use.seen.bottom},
                                   {m_use.seen.right, m_use.seen.bottom}}) {
            const double offset = dot(corner - m_from, turned);
            low = std::min(low, offset), high = std::max(high, offset);
        }
        if (!repeatStops(low, high))
            return false;
        const SvgColour &last = m_stops.back().colour;
        const bool evenlyOpaque =
            std::ranges::all_of(m_stops, [&](const SvgStop &stop) { return stop.colour[3] == last[3]; });
        const std::vector<SvgStop> fine = evenlyOpaque ? refined(m_stops) : m_stops;
        if (fine.size() == 1)
            m_shades = {evenly(last)};
        else if (fine.size() == 2 || (m_isOpaque && !m_use.isApart && fine.size() <= mostShades))
            addOver(fine);
        else if (fine.size() <= mostApart)
            addStrips(fine, low - 1, high + 1);
        return !m_shades.empty();
    }
    Point place(double offset) const { return m_from + offset * m_way; }

    /// Shades over each other: a new colour comes up from nothing over what is there, which mixes the two evenly.
    void addOver(const std::vector<SvgStop> &fine)
    {
        constexpr double jump = 1e-4; // where two stops stand at one place, a share of the way
        for (std::size_t i = 1; i < fine.size(); ++i) {
            const double begin = fine[i - 1].offset, end = std::max(fine[i].offset, begin + jump);
            SvgColour before = fine[i - 1].colour;
            if (i > 1) {
                before = fine[i].colour;
                before[3] = 0;
            }
            m_shades.push_back({place(begin), place(end), before, fine[i].colour, {}});
        }
    }

    /// Strips beside each other, across the way. Where colours are opaque each goes on below those behind it, so that
    /// nothing shows between them.
    void addStrips(const std::vector<SvgStop> &fine, double low, double high)
    {
        const Point middle = m_use.seen.centre(), aside = turned(m_way);
        const double offset = dot(middle - m_from, m_way) / dot(m_way, m_way);
        const double reach = (m_use.seen.width() + m_use.seen.height()) / suffuse::length(aside);
        const Point centre = middle - offset * m_way; // where offsets are 0, as near as possible
        const auto add = [&](double begin, double end, const SvgColour &first, const SvgColour &last) {
            if (!(end > begin))
                return;
            const double until = m_isOpaque && !m_use.isApart ? high : end;
            const Point corners[] = {centre + begin * m_way - reach * aside, centre + until * m_way - reach * aside,
                                     centre + until * m_way + reach * aside, centre + begin * m_way + reach * aside};
            SvgShade shade{place(begin), place(end), first, last, {{}}};
            for (std::size_t k = 0; k < 4; ++k)
                shade.within[0].push_back(straightCubic(corners[k], corners[(k + 1) % 4]));
            m_shades.push_back(std::move(shade));
        };
        add(low, fine.front().offset, fine.front().colour, fine.front().colour);
        for (std::size_t i = 1; i < fine.size(); ++i)
            add(fine[i - 1].offset, fine[i].offset, fine[i - 1].colour, fine[i].colour);
        add(fine.back().offset, high, fine.back().colour, fine.back().colour);
    }

    /// Circles around each other, from a focus outwards, as discs over each other or as rings beside each other.
    bool radial()
    {
        const Point centre{at("cx", SvgAxis::Across, 0.5), at("cy", SvgAxis::Down, 0.5)};
        const double radius = at("r", SvgAxis::Any, 0.5);
        Point focus{length("fx", SvgAxis::Across).value_or(centre.x), length("fy", SvgAxis::Down).value_or(centre.y)};
        const double inner = std::clamp(length("fr", SvgAxis::Any).value_or(0), 0.0, std::max(0.0, radius));
        if (!(radius > 0)) {
            if (radius == 0)
                m_shades = {evenly(m_stops.back().colour)};
            return radius == 0;
        }
        const Point off = focus - centre;
        if (const double most = 0.99 * (radius - inner); suffuse::length(off) > most)
            focus = centre + (most / suffuse::length(off)) * off;
        // How often the circle must be repeated to reach everything.
        const SvgMatrix &m = m_whole;
        const double determinant = m.a * m.d - m.b * m.c;
        double farthest = 1;
        for (const Point corner : {Point{m_use.seen.left, m_use.seen.top},
                                   {m_use.seen.right, m_use.seen.top},
                                   {m_use.seen.left, m_use.seen.bottom},
                                   {m_use.seen.right, m_use.seen.bottom}}) {
            const Point p = corner - Point{m.e, m.f};
            const Point own{(m.d * p.x - m.c * p.y) / determinant, (m.a * p.y - m.b * p.x) / determinant};
            farthest =
                std::max(farthest, 1 + suffuse::length(own - focus) / (radius - suffuse::length(focus - centre)));
        }
        if (!repeatStops(0, farthest))
            return false;
        const auto circle = [&](double offset) {
            const Point middle = focus + offset * (centre - focus);
            const double size = inner + offset * (radius - inner);
            std::vector<Cubic> loop = arcAround(middle, middle + Point{size, 0}, 2 * std::numbers::pi);
            for (Cubic &curve : loop)
                for (Point &p : curve.p)
                    p = m_whole.map(p);
            loop.back().p[3] = loop.front().p[0];
            return loop;
        };
        const auto isCircle = [&](double offset) { return inner + offset * (radius - inner) > 0; };
        return m_isOpaque || m_use.isApart || m_use.finest == 0 ? addRings(circle, isCircle)
                                                                : addShingles(circle, isCircle);
    }

    /// A rectangle around all that is seen.
    std::vector<Cubic> everywhere() const
    {
        const Rect around = m_use.seen.grown(1 + m_use.seen.width() + m_use.seen.height());
        const Point corners[] = {{around.left, around.top},
                                 {around.right, around.top},
                                 {around.right, around.bottom},
                                 {around.left, around.bottom}};
        std::vector<Cubic> loop;
        for (std::size_t k = 0; k < 4; ++k)
            loop.push_back(straightCubic(corners[k], corners[(k + 1) % 4]));
        return loop;
    }

    /// Rings that let through, over each other.
    template <class Circle, class IsCircle>
    bool addShingles(const Circle &circle, const IsCircle &isCircle)
    {
        std::vector<SvgShingle> rings;
        for (const int finest : {m_use.finest, m_use.finest / 2, 24}) {
            rings = svgShingles(m_stops, finest);
            if (rings.size() <= mostApart)
                break;
        }
        if (rings.size() > mostApart)
            return false;
        for (const SvgShingle &ring : rings) {
            if (!isCircle(ring.to) || !(ring.to > ring.from))
                continue;
            SvgShade shade = evenly(ring.colour);
            shade.within.push_back(std::isfinite(ring.to) ? circle(ring.to) : everywhere());
            if (std::isfinite(ring.from) && isCircle(ring.from))
                shade.within.push_back(circle(ring.from));
            m_shades.push_back(std::move(shade));
        }
        return true;
    }

    /// Discs of opaque colours over each other, or rings beside each other.
    template <class Circle, class IsCircle>
    bool addRings(const Circle &circle, const IsCircle &isCircle)
    {
        struct Ring {
            double end;
            SvgColour colour;
        };
        std::vector<Ring> rings{{m_stops.front().offset, m_stops.front().colour}};
        for (std::size_t i = 1; i < m_stops.size(); ++i) {
            const SvgStop &a = m_stops[i - 1], &b = m_stops[i];
            double change = 0;
            for (std::size_t c = 0; c < 4; ++c)
                change = std::max(change, std::abs(b.colour[c] - a.colour[c]));
            const int parts = b.offset > a.offset ? std::clamp(int(std::ceil(32 * change)), 1, 32) : 0;
            for (int k = 0; k < parts; ++k)
                rings.push_back({a.offset + (k + 1.0) / parts * (b.offset - a.offset),
                                 between(a.colour, b.colour, (k + 0.5) / parts)});
        }
        if (rings.size() > mostApart)
            return false;
        const bool isStack = m_isOpaque && !m_use.isApart;
        m_shades.push_back(evenly(m_stops.back().colour));
        if (!isStack) { // What lies beyond the last circle.
            m_shades.back().within = {everywhere(), circle(rings.back().end)};
        }
        for (std::size_t i = rings.size(); i-- > 0;) {
            if (!isCircle(rings[i].end))
                continue;
            SvgShade ring = evenly(rings[i].colour);
            ring.within.push_back(circle(rings[i].end));
            if (!isStack && i > 0 && isCircle(rings[i - 1].end))
                ring.within.push_back(circle(rings[i - 1].end));
            m_shades.push_back(std::move(ring));
        }
        return true;
    }

    /// Repeats the stops as spreadMethod says, so that they reach from `low` to `high`.
    bool repeatStops(double low, double high)
    {
        const QString spread = attribute("spreadMethod");
        const bool isReflected = spread == QLatin1String("reflect");
        if (!isReflected && spread != QLatin1String("repeat"))
            return true;
        const double first = std::floor(low), last = std::ceil(high);
        if (!((last - first) * double(m_stops.size()) <= double(mostApart)))
            return false;
        std::vector<SvgStop> all;
        for (double turn = first; turn < last; ++turn) {
            std::vector<SvgStop> stops = m_stops;
            const bool isBack = isReflected && std::fmod(turn, 2) != 0;
            if (isBack)
                std::ranges::reverse(stops);
            const auto add = [&](double offset, const SvgColour &colour) { all.push_back({turn + offset, colour}); };
            add(0, stops.front().colour);
            for (const SvgStop &stop : stops)
                add(isBack ? 1 - stop.offset : stop.offset, stop.colour);
            add(1, stops.back().colour);
        }
        m_stops = std::move(all);
        return true;
    }

    const SvgGradientUse &m_use;
    SvgTree &m_tree;
    bool m_boxed = false, m_isOpaque = false;
    SvgUnits m_units;
    SvgMatrix m_whole;   ///< from the gradient's units to those of the document
    Point m_from, m_way; ///< of a linear one: where it begins, and from there to its end
    std::vector<SvgStop> m_stops;
    std::vector<SvgShade> m_shades;
};

} // namespace

std::optional<std::vector<SvgShade>> svgShades(const SvgGradientUse &use, SvgTree &tree)
{
    return ShadeFinder(use, tree).find();
}

} // namespace suffuse
