#include "render/reference/fill_source.h"

#include "render/reference/quadrature.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace suffuse::reference {

namespace {

constexpr double rootPi = 1.7724538509055160273;

struct ToPixels {
    const View &view;
    Point base;

    Point operator()(Offset offset) const
    {
        Point p = base + offset;
        if (view.mirrored)
            p.x = -p.x;
        const double c = std::cos(view.rotation), s = std::sin(view.rotation);
        return {view.scale * (c * p.x - s * p.y) + 0.5 * view.width,
                view.scale * (s * p.x + c * p.y) + 0.5 * view.height};
    }
};

Cubic straight(Point a, Point b)
{
    return {{a, a + (1.0 / 3) * (b - a), a + (2.0 / 3) * (b - a), b}};
}

/// The chains of a stroke as closed curves. Segments that take paint away are left out, and straight lines bridge the
/// gaps.
std::vector<Cubic> closedChains(const Stroke &stroke, const ToPixels &toPixels)
{
    std::vector<Cubic> out;
    Point first, last;
    bool open = false;
    const auto lineTo = [&](Point to) {
        if (open && !(last == to))
            out.push_back(straight(last, to));
    };
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        if (stroke.beginsChain(k)) {
            lineTo(first);
            open = false;
        }
        const Segment &segment = stroke.segments[k];
        if (segment.takesPaint())
            continue;
        Cubic curve;
        for (std::size_t i = 0; i < 4; ++i)
            curve.p[i] = toPixels(segment.bezier[i]);
        lineTo(curve.p[0]);
        if (!open)
            first = curve.p[0];
        open = true;
        last = curve.p[3];
        out.push_back(curve);
    }
    lineTo(first);
    return out;
}

/// The parameters where v turns, in rising order.
std::vector<double> turnsOf(const Cubic &c)
{
    const double a = c.p[1].y - c.p[0].y, b = c.p[2].y - c.p[1].y, d = c.p[3].y - c.p[2].y;
    const double square = a - 2 * b + d, linear = 2 * (b - a); // square t² + linear t + a
    std::vector<double> turns;
    const auto add = [&](double t) {
        if (t > 0 && t < 1)
            turns.push_back(t);
    };
    const double discriminant = linear * linear - 4 * square * a;
    if (discriminant >= 0) {
        const double q = -0.5 * (linear + std::copysign(std::sqrt(discriminant), linear));
        if (square != 0)
            add(q / square);
        if (q != 0)
            add(a / q);
    }
    std::sort(turns.begin(), turns.end());
    return turns;
}

Cubic reversed(const Cubic &c)
{
    return {{c.p[3], c.p[2], c.p[1], c.p[0]}};
}

} // namespace

double FillSource::Arc::parameterAt(double v) const
{
    double low = 0, high = 1, t = 0.5;
    for (int i = 0; i < 200; ++i) {
        const double off = curve.at(t).y - v;
        (off > 0 ? high : low) = t;
        if (off == 0 || high - low < 1e-16)
            break;
        const double next = t - off / curve.derivative(t).y;
        // Newton's method, as long as it halves the range at least every other time.
        t = next > low && next < high && i % 3 != 2 ? next : 0.5 * (low + high);
    }
    return t;
}

FillSource::FillSource(const Stroke &stroke, Microseconds T, const View &view, double reach) : m_reach(reach)
{
    const Fill &fill = *stroke.fill;
    m_density = fill.density;
    m_rule = fill.rule;
    const double s = fill.spread(T) * view.scale;
    const double angle = fill.anisotropyAngle;
    const double turned = (view.mirrored ? std::numbers::pi - angle : angle) + view.rotation;
    const Kernel kernel = fill.isIsotropic() ? isotropicKernel(s) : anisotropicKernel(s, fill.anisotropyRatio, turned);
    m_largerSpread = kernel.largerSpread;
    m_crisp = std::ldexp(kernel.smallerSpread, 6) < 1;
    while (!m_crisp && m_level < 6 && std::ldexp(kernel.smallerSpread, m_level) < 1)
        ++m_level;
    if (!m_crisp) {
        const double xx = kernel.a11 * kernel.a11 + kernel.a21 * kernel.a21;
        const double xy = kernel.a11 * kernel.a12 + kernel.a21 * kernel.a22;
        const double det = kernel.a11 * kernel.a22 - kernel.a12 * kernel.a21;
        m_a = std::sqrt(xx);
        m_b = xy / m_a;
        m_c = std::abs(det) / m_a;
    }
    const ToPixels toPixels{view, stroke.origin - view.centre};
    m_outline = closedChains(stroke, toPixels);
    for (const Cubic &curve : m_outline)
        m_box = m_box.united(curve.controlBox());
    m_box = m_box.grown(m_crisp ? 1 : reach * m_largerSpread);
    if (fill.gradient) {
        // Pixels are even in the canvas, so the place is even in pixels, and in the plane.
        m_hasGradient = true;
        const Point from = toPixels(fill.gradient->from), along = toPixels(fill.gradient->to) - from;
        const double square = dot(along, along);
        const double px = along.x / square, py = along.y / square;
        m_place = {-(px * from.x + py * from.y), px / m_a, (py - px * m_b / m_a) / m_c};
        const Colour &c = fill.gradient->colour;
        m_colourEnd = {c.red, c.yellow, c.blue, c.opacity};
    }
    makeArcs(m_outline);
    if (m_level > 0) {
        m_pixels = std::make_shared<FillSource>(*this);
        m_pixels->m_a = m_pixels->m_c = 1, m_pixels->m_b = 0;
        m_pixels->m_arcs.clear();
        m_pixels->m_ends.clear();
        m_pixels->makeArcs(m_outline);
    }
    if (m_crisp || m_arcs.empty())
        return;
    m_left = std::min(0.0, m_b * view.height) - reach;
    m_right = m_a * view.width + std::max(0.0, m_b * view.height) + reach;
    double low = m_ends.front(), high = m_ends.back();
    low = std::max(low, -reach), high = std::min(high, m_c * view.height + reach);
    double from = low;
    for (const double end : m_ends) {
        if (end <= from)
            continue;
        addPanels(from, std::min(end, high), 0);
        from = end;
        if (from >= high)
            break;
    }
}

void FillSource::makeArcs(const std::vector<Cubic> &outline)
{
    for (const Cubic &pixels : outline) {
        Cubic rest{{toPlane(pixels.p[0]), toPlane(pixels.p[1]), toPlane(pixels.p[2]), toPlane(pixels.p[3])}};
        const std::vector<double> turns = turnsOf(rest);
        double done = 0;
        const auto add = [this](Cubic curve) {
            if (curve.p[0].y == curve.p[3].y)
                return;
            Arc arc;
            arc.sign = curve.p[0].y < curve.p[3].y ? 1 : -1;
            arc.curve = arc.sign > 0 ? curve : reversed(curve);
            arc.box = arc.curve.controlBox();
            arc.box.top = arc.curve.p[0].y, arc.box.bottom = arc.curve.p[3].y;
            m_ends.push_back(arc.box.top);
            m_ends.push_back(arc.box.bottom);
            m_arcs.push_back(arc);
        };
        for (const double turn : turns) {
            const auto [before, after] = rest.split((turn - done) / (1 - done));
            add(before);
            rest = after;
            done = turn;
        }
        add(rest);
    }
    std::sort(m_ends.begin(), m_ends.end());
}

void FillSource::insideAt(double v, std::vector<Interval> &out) const
{
    std::vector<std::pair<double, int>> crossings;
    for (const Arc &arc : m_arcs)
        if (arc.box.top <= v && v < arc.box.bottom)
            crossings.emplace_back(arc.uAt(v), arc.sign);
    std::sort(crossings.begin(), crossings.end());
    int winding = 0;
    const auto isInside = [&] { return m_rule == FillRule::NonZero ? winding != 0 : winding % 2 != 0; };
    for (const auto &[u, sign] : crossings) {
        const bool before = isInside();
        winding += sign;
        if (!before && isInside())
            out.push_back({u, u});
        else if (before)
            out.back()[1] = u; // It may go on: then the next crossing says where it ends.
    }
}

/// Two numbers that tell whether a rule integrates what lies inside: its area, and how far to the right it lies.
std::array<double, 2> FillSource::measure(double from, double to, int order) const
{
    const GaussRule &rule = order == 10 ? gauss10() : gauss20();
    std::array<double, 2> sum{};
    std::vector<Interval> inside;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double angle = std::numbers::pi * rule.nodes[i];
        const double v = from + 0.5 * (to - from) * (1 - std::cos(angle));
        const double weight = 0.5 * (to - from) * std::numbers::pi * std::sin(angle) * rule.weights[i];
        inside.clear();
        insideAt(v, inside);
        for (const auto &[a, b] : inside) {
            const auto bent = [](double u) { return std::atan(0.5 * u); };
            sum[0] += weight * (b - a);
            sum[1] += weight * (bent(b) - bent(a));
        }
    }
    return sum;
}

/// Whether an arc goes so far aside between two heights that a point beside it sees a step there: a rule that
/// integrates what lies inside knows nothing of that.
bool FillSource::runsFar(double from, double to) const
{
    constexpr double far = 1, least = 1e-13; // spreads; what is lower than the latter adds nothing
    if (to - from < least)
        return false;
    for (const Arc &arc : m_arcs) {
        if (arc.box.bottom <= from || arc.box.top >= to || arc.box.right - arc.box.left <= far)
            continue;
        double left = HUGE_VAL, right = -HUGE_VAL;
        for (const double v : {from, 0.5 * (from + to), to}) {
            const double u = std::clamp(arc.uAt(std::clamp(v, arc.box.top, arc.box.bottom)), m_left, m_right);
            left = std::min(left, u), right = std::max(right, u);
        }
        if (right - left > far)
            return true;
    }
    return false;
}

void FillSource::addPanels(double from, double to, int depth)
{
    constexpr double longest = 0.3;
    // Where a spread has so many pixels, edges are looked at that closely, too.
    const double exact = m_largerSpread > 4096 ? 1e-14 : 1e-12;
    const double middle = 0.5 * (from + to);
    if (to - from > longest) {
        const int parts = int(std::min(1e6, std::ceil((to - from) / longest)));
        for (int k = 0; k < parts; ++k)
            addPanels(from + (to - from) * k / parts, from + (to - from) * (k + 1) / parts, 0);
        return;
    }
    const auto coarse = measure(from, to, 10), fine = measure(from, to, 20);
    // Far to the right and left the area itself has few digits left.
    const bool good = std::abs(coarse[0] - fine[0]) <= exact * (1 + std::abs(fine[0])) &&
                      std::abs(coarse[1] - fine[1]) <= exact && !runsFar(from, to);
    if (good || depth == 22 || middle <= from || middle >= to)
        return addLines(from, to);
    addPanels(from, middle, depth + 1);
    addPanels(middle, to, depth + 1);
}

void FillSource::addLines(double from, double to)
{
    // Where an outline turns, its u goes like the root of v: with v as a cosine it is smooth.
    const GaussRule &rule = gauss10();
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double angle = std::numbers::pi * rule.nodes[i];
        ScanLine line;
        line.v = from + 0.5 * (to - from) * (1 - std::cos(angle));
        line.weight = 0.5 * (to - from) * std::numbers::pi * std::sin(angle) * rule.weights[i];
        line.from = m_intervals.size();
        insideAt(line.v, m_intervals);
        line.to = m_intervals.size();
        if (line.to > line.from)
            m_lines.push_back(line);
    }
}

double FillSource::channelAt(std::size_t channel, double place) const
{
    constexpr std::size_t firstColour = 1, colours = 4; // The granulation stands before them.
    const double from = m_channels[channel];
    if (!m_hasGradient || channel < firstColour || channel >= firstColour + colours)
        return from;
    return from + place * (m_colourEnd[channel - firstColour] - from);
}

bool FillSource::isNear(const Rect &square) const
{
    constexpr double touches = 1e-9; // What only touches it, but for rounding, does not lie in it.
    return (m_pixels ? *m_pixels : *this).endsIn(square.grown(4 * m_largerSpread - touches));
}

/// Parts of an arc between the places where it turns, or enters or leaves a rectangle: in each it is inside or outside.
std::vector<double> FillSource::cutsOf(const Arc &arc, const Rect &square)
{
    std::vector<double> cuts{arc.parameterAt(std::max(square.top, arc.box.top)),
                             arc.parameterAt(std::min(square.bottom, arc.box.bottom))};
    Cubic turned = arc.curve; // Where u turns is where v does with both exchanged.
    for (Point &p : turned.p)
        std::swap(p.x, p.y);
    for (const double turn : turnsOf(turned))
        if (turn > cuts[0] && turn < cuts[1])
            cuts.push_back(turn);
    std::sort(cuts.begin(), cuts.end());
    const std::vector<double> ends = cuts;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
        for (const double side : {square.left, square.right}) {
            double low = ends[k], high = ends[k + 1];
            const bool isLeft = arc.curve.at(low).x < side;
            if (isLeft == (arc.curve.at(high).x < side))
                continue;
            for (int i = 0; i < 60; ++i) {
                const double middle = 0.5 * (low + high);
                ((arc.curve.at(middle).x < side) == isLeft ? low : high) = middle;
            }
            cuts.push_back(0.5 * (low + high));
        }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

/// Whether the area ends somewhere inside a square of the plane. Outlines that bound nothing do not count.
bool FillSource::endsIn(const Rect &square) const
{
    std::vector<Interval> inside;
    for (const Arc &arc : m_arcs) {
        if (!(arc.box.left < square.right && arc.box.right > square.left && arc.box.top < square.bottom &&
              arc.box.bottom > square.top))
            continue;
        const std::vector<double> cuts = cutsOf(arc, square);
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
            for (const double share : {0.03, 0.25, 0.5, 0.75, 0.97}) {
                const Point at = arc.curve.at(cuts[k] + share * (cuts[k + 1] - cuts[k]));
                if (!(at.x > square.left && at.x < square.right && at.y > square.top && at.y < square.bottom))
                    continue;
                inside.clear();
                insideAt(at.y, inside);
                for (const auto &[from, to] : inside)
                    for (const double end : {from, to})
                        if (to > from && end > square.left && end < square.right)
                            return true;
            }
    }
    // No arc bounds it here, so it can end at level parts only: there it is inside on one side.
    const auto isInside = [&](double v) { return 2 * clippedAt(v, square) > square.width(); };
    double from = square.top;
    std::optional<bool> above;
    const auto differs = [&](double to) {
        const bool now = isInside(0.5 * (from + to));
        from = to;
        return now != std::exchange(above, now).value_or(now);
    };
    const auto first = std::upper_bound(m_ends.begin(), m_ends.end(), square.top);
    for (auto end = first; end != m_ends.end() && *end < square.bottom; ++end)
        if (*end > from && differs(*end))
            return true;
    return first != m_ends.end() && *first < square.bottom && differs(square.bottom);
}

FillSample FillSource::at(Point x) const
{
    FillSample sample;
    if (!m_box.contains(x))
        return sample;
    const Point p = toPlane(x);
    const auto below = [](const ScanLine &line, double v) { return line.v < v; };
    const auto first = std::lower_bound(m_lines.begin(), m_lines.end(), p.y - m_reach, below);
    double density = 0, du = 0, dv = 0, u = 0, v = 0;
    for (auto line = first; line != m_lines.end() && line->v <= p.y + m_reach; ++line) {
        const double off = p.y - line->v, g = line->weight * std::exp(-off * off) / rootPi;
        double along = 0, slope = 0;
        for (std::size_t i = line->from; i < line->to; ++i) {
            const double a = m_intervals[i][0] - p.x, b = m_intervals[i][1] - p.x;
            if (a > m_reach || b < -m_reach)
                continue;
            along += 0.5 * erfDifference(b, a);
            slope += (std::exp(-a * a) - std::exp(-b * b)) / rootPi;
        }
        density += g * along;
        du += g * slope;
        dv += g * -2 * off * along;
        u += g * (p.x * along + 0.5 * slope);
        v += g * line->v * along;
    }
    sample.density = m_density * density;
    sample.gradient = m_density * Point{m_a * du, m_b * du + m_c * dv};
    if (m_hasGradient && density > 0)
        sample.place = std::clamp(m_place[0] + (m_place[1] * u + m_place[2] * v) / density, 0.0, 1.0);
    return sample;
}

FillSample FillSource::inside(Point x) const
{
    const Point p = toPlane(x);
    return {m_density, {}, std::clamp(m_place[0] + m_place[1] * p.x + m_place[2] * p.y, 0.0, 1.0)};
}

double FillSource::clippedAt(double v, const Rect &cell) const
{
    std::vector<Interval> inside;
    insideAt(v, inside);
    double length = 0;
    for (const auto &[a, b] : inside)
        length += std::max(0.0, std::min(b, cell.right) - std::max(a, cell.left));
    return length;
}

double FillSource::coveredBetween(double from, double to, const Rect &cell, int depth) const
{
    const double middle = 0.5 * (from + to);
    const auto rule = [&](double a, double b) {
        double sum = 0;
        for (std::size_t i = 0; i < gauss10().nodes.size(); ++i)
            sum += gauss10().weights[i] * clippedAt(a + (b - a) * gauss10().nodes[i], cell);
        return (b - a) * sum;
    };
    const double whole = rule(from, to), left = rule(from, middle), right = rule(middle, to);
    const bool good = depth > 1 && std::abs(whole - left - right) <= 3e-7 * cell.width() * cell.width();
    if (good || depth == 16)
        return left + right;
    return coveredBetween(from, middle, cell, depth + 1) + coveredBetween(middle, to, cell, depth + 1);
}

double FillSource::covered(Point centre, double side) const
{
    return coveredShare(Rect{centre.x, centre.y, centre.x, centre.y}.grown(0.5 * side));
}

double FillSource::coveredShare(const Rect &square) const
{
    // Of a plane that is not that of the pixels the square is a parallelogram there. Its own pixels are taken instead.
    if (m_pixels)
        return m_pixels->coveredShare(square);
    const Rect &cell = square;
    const double side = cell.width();
    // A level part of the outline is no arc, but arcs end where it lies.
    const auto end = std::upper_bound(m_ends.begin(), m_ends.end(), cell.top);
    bool crossed = end != m_ends.end() && *end < cell.bottom;
    for (const Arc &arc : m_arcs)
        crossed = crossed || arc.box.intersects(cell);
    if (!crossed)
        return clippedAt(0.5 * (cell.top + cell.bottom), cell) / side;
    double from = cell.top, sum = 0;
    const auto until = [&](double to) {
        if (to > from)
            sum += coveredBetween(from, to, cell, 0);
        from = std::max(from, to);
    };
    const auto first = std::upper_bound(m_ends.begin(), m_ends.end(), cell.top);
    for (auto end = first; end != m_ends.end() && *end < cell.bottom; ++end)
        until(*end);
    until(cell.bottom);
    return std::clamp(sum / (side * side), 0.0, 1.0);
}

} // namespace suffuse::reference
