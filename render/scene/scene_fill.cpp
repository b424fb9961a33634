#include "render/scene/scene_fill.h"

#include "model/area/outline.h"
#include "render/nodes/level0.h"
#include "render/nodes/node_builder.h"

#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

constexpr double finestFill = 0x1p-22, finestDeepFill = 0x1p-44, coarsestFill = 0x1p-12; // relative to ρ
constexpr double crispPixels = 1.0 / 64; // 64 × 64 samples of a pixel cannot see a smaller spread.
constexpr double crispPanel = 32;        // px
constexpr std::size_t mostPanels = std::size_t(1) << 20;

/// How many nodes a panel of a length in spreads needs. What n nodes are off by grows with the length to the power 2n.
int orderFor(double length, double epsilon)
{
    constexpr std::array<double, 9> ofOneSpread{0.047, 1.6e-3, 3.4e-5, 5.4e-7, 6.8e-9, 7e-11, 6e-13, 5e-15, 4e-17};
    double power = 1;
    for (std::size_t n = 1; n < ofOneSpread.size(); ++n) {
        power *= length * length;
        if (ofOneSpread[n - 1] * power < 0.25 * epsilon) // The rest is left for others that lie nearby.
            return int(n);
    }
    return int(ofOneSpread.size());
}

/// Null if it was stopped.
std::shared_ptr<const TurnedBoundary> turnedBoundary(const Stroke &stroke, const View &view,
                                                     const std::atomic<bool> *stop)
{
    auto turned = std::make_shared<TurnedBoundary>();
    turned->rotation = view.rotation;
    turned->mirrored = view.mirrored;
    const double c = std::cos(view.rotation), s = std::sin(view.rotation);
    auto loops = closedOutline(stroke);
    if (view.rotation != 0 || view.mirrored)
        for (auto &loop : loops)
            for (Cubic &curve : loop)
                for (Point &p : curve.p) {
                    const double x = view.mirrored ? -p.x : p.x;
                    p = {c * x - s * p.y, s * x + c * p.y};
                }
    AreaEffort effort(stop);
    turned->area = boundaryOf(loops, stroke.fill->rule, &effort);
    return effort.isSpent() ? nullptr : turned;
}

/// Makes panels of arcs.
class PanelMaker {
public:
    PanelMaker(SceneFill &fill, const Rect &near, double longest) : m_fill(fill), m_near(near), m_longest(longest) {}

    void add(const BoundaryArc &part, int depth = 0)
    {
        const Rect box = part.arc.box();
        if (!box.intersects(m_near)) {
            if (box.right < m_near.left && box.bottom >= m_near.top && box.top <= m_near.bottom)
                m_fill.lefts.push_back({box.top, box.bottom, part.enters});
            return;
        }
        if (!isShort(part.arc.curve) && depth < 60) {
            auto [before, after] = part.arc.curve.split(0.5);
            before.p[0] = part.arc.curve.p[0];
            after.p[3] = part.arc.curve.p[3];
            add({{before}, part.enters}, depth + 1);
            add({{after}, part.enters}, depth + 1);
            return;
        }
        FillPanel panel{part, box};
        panel.begin = std::uint32_t(m_fill.nodes.size());
        if (!m_fill.crisp)
            appendNodesOf(m_fill, part, m_fill.nodes);
        panel.end = std::uint32_t(m_fill.nodes.size());
        m_fill.panels.push_back(panel);
    }

    static void appendNodesOf(const SceneFill &fill, const BoundaryArc &part, std::vector<FillNode> &out)
    {
        const int order = orderFor(fastestOf(fill, part.arc.curve), fill.epsilon);
        const QuadratureRule &rule = gaussLegendre(order);
        const double gain = part.enters * fill.c / std::sqrt(std::numbers::pi);
        for (std::size_t i = 0; i < std::size_t(order); ++i) {
            const Point p = part.arc.curve.at(rule.x[i]);
            out.push_back({p.x, p.y, gain * rule.weight[i] * part.arc.curve.derivative(rule.x[i]).y});
        }
    }

private:
    static Point whitened(const SceneFill &fill, Point d)
    {
        return fill.crisp ? d : Point{fill.a * d.x + fill.b * d.y, fill.c * d.y};
    }
    /// That of the control polygon, in spreads; of a crisp fill in pixels.
    static double lengthOf(const SceneFill &fill, const Cubic &c)
    {
        const Point a = whitened(fill, c.p[1] - c.p[0]), b = whitened(fill, c.p[2] - c.p[1]);
        const Point d = whitened(fill, c.p[3] - c.p[2]);
        return std::sqrt(dot(a, a)) + std::sqrt(dot(b, b)) + std::sqrt(dot(d, d));
    }
    /// Its greatest speed, in spreads for the whole of it: nodes are as far apart there as on an even panel of this
    /// length.
    static double fastestOf(const SceneFill &fill, const Cubic &c)
    {
        double fastest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Point leg = whitened(fill, c.p[i + 1] - c.p[i]);
            fastest = std::max(fastest, dot(leg, leg));
        }
        return 3 * std::sqrt(fastest);
    }
    bool isShort(const Cubic &c) const
    {
        const Point a = whitened(m_fill, c.p[1] - c.p[0]), b = whitened(m_fill, c.p[2] - c.p[1]);
        const Point d = whitened(m_fill, c.p[3] - c.p[2]);
        const double length = lengthOf(m_fill, c);
        if (length > m_longest)
            return false;
        if (m_fill.crisp)
            return true;
        // An uneven speed takes more nodes; of what is very short nothing matters but its ends.
        const Point first = b - a, second = d - b;
        return length < 0.02 || std::max(dot(first, first), dot(second, second)) < 0.01 * length * length ||
               length < 0.35 * m_longest;
    }

    SceneFill &m_fill;
    Rect m_near;
    double m_longest;
};

template <class Item, class BoxOf>
std::vector<Rect> boxesOfRuns(const std::vector<Item> &items, BoxOf boxOf)
{
    std::vector<Rect> runs((items.size() + fillRun - 1) / fillRun);
    for (std::size_t i = 0; i < items.size(); ++i)
        runs[i / fillRun] = runs[i / fillRun].united(boxOf(items[i]));
    return runs;
}

/// The spread in pixels, and what follows from it.
void setSpread(SceneFill &out, const Fill &fill, const Stroke &stroke, Microseconds T, const View &view)
{
    const double across = fill.spread(T) * view.scale, along = across * std::sqrt(double(fill.anisotropyRatio));
    const double smaller = std::min(across, along), larger = std::max(across, along);
    out.density = fill.density;
    out.narrowest = smaller;
    out.crisp = smaller < crispPixels;
    out.deep = larger > deepSpread;
    out.nearby = 4 * larger;
    while (!out.crisp && out.level < 6 && std::ldexp(smaller, out.level) < 1)
        ++out.level;
    out.steepest = out.density / (std::sqrt(std::numbers::pi) * smaller);
    if (out.crisp)
        return;
    const double angle = fill.anisotropyAngle;
    const double turned = (view.mirrored ? std::numbers::pi - angle : angle) + view.rotation;
    const double c = std::cos(turned), s = std::sin(turned);
    double xx = 1 / (across * across), xy = 0, yy = xx;
    out.half = {0.5 * across * across, 0, 0.5 * across * across};
    if (!fill.isIsotropic()) {
        const double l = 1 / (along * along), n = 1 / (across * across);
        xx = l * c * c + n * s * s, xy = (l - n) * c * s, yy = l * s * s + n * c * c;
        const double k = 0.5 * along * along, m = 0.5 * across * across;
        out.half = {k * c * c + m * s * s, (k - m) * c * s, k * s * s + m * c * c};
        if (std::abs(xy) < 1e-9 * std::min(xx, yy))
            xy = 0;
    }
    out.a = std::sqrt(xx);
    out.b = xy / out.a;
    out.c = std::sqrt(yy - out.b * out.b);
    std::vector<Style> styles = contextOf(stroke, T, 0, {}).styles;
    styles.push_back(stroke.style);
    double tolerance = 1e300;
    for (const Style &style : styles) {
        tolerance = std::min(tolerance, 0.5 * densityTolerance(style, out.density, smaller));
        if (style.kind == StyleKind::Feathering && style.xi[1] < 1) // Its slope is greatest where there is nothing.
            tolerance = std::min(tolerance, double(style.xi[0]) * std::pow(5e-4, 1 / double(style.xi[1])));
    }
    out.epsilon = std::clamp(tolerance / out.density, out.deep ? finestDeepFill : finestFill, coarsestFill);
    double radius = std::sqrt(std::log(20 / out.epsilon));
    if (out.level > 0)
        radius = std::max(radius, 4.0);
    const double det = xx * yy - xy * xy;
    out.reach = {radius * std::sqrt(yy / det), radius * std::sqrt(xx / det)};
}

void setGradient(SceneFill &out, const Stroke &stroke, const View &view)
{
    out.hasGradient = stroke.fill->gradient.has_value();
    if (!out.hasGradient)
        return;
    const Gradient &g = *stroke.fill->gradient;
    const Point from = view.toPixels(stroke.origin + g.from), to = view.toPixels(stroke.origin + g.to);
    const Point along = to - from;
    out.placeSlope = 1 / dot(along, along) * along;
    out.place = -dot(out.placeSlope, from);
}

/// The boundary in pixels, as far as it matters for the window. Returns the box of all of it at the window's heights.
Rect placeArcs(SceneFill &out, const Stroke &stroke, const View &view, const Rect &near)
{
    const double c = std::cos(view.rotation), s = std::sin(view.rotation);
    Point d = stroke.origin - view.centre;
    if (view.mirrored)
        d.x = -d.x;
    // Subtracting in double before scaling keeps the digits of a painting far from 0 at deep zoom.
    const Point base{c * d.x - s * d.y, s * d.x + c * d.y};
    const auto place = [&](Point p) {
        return Point{view.scale * (base.x + p.x) + 0.5 * view.width, view.scale * (base.y + p.y) + 0.5 * view.height};
    };
    Rect box;
    out.arcs.reserve(out.boundary->area.arcs.size());
    for (const BoundaryArc &part : out.boundary->area.arcs) {
        const Point top = place(part.arc.curve.p[0]), bottom = place(part.arc.curve.p[3]);
        if (bottom.y < near.top || top.y > near.bottom)
            continue;
        box.include(top);
        box.include(bottom);
        if (std::min(top.x, bottom.x) > near.right)
            continue;
        BoundaryArc &placed = out.arcs.emplace_back(part);
        for (Point &p : placed.arc.curve.p)
            p = place(p);
    }
    for (const BoundaryFlat &flat : out.boundary->area.flats) {
        const Point a = place({flat.left, flat.y}), b = place({flat.right, flat.y});
        if (a.y >= near.top && a.y <= near.bottom && a.x <= near.right && b.x >= near.left)
            out.flats.push_back({a.y, a.x, b.x, flat.jump});
    }
    return box;
}

PixelRect boundsOf(const SceneFill &fill, Rect box, const Rect &window)
{
    if (box.isEmpty())
        return {};
    const double more = fill.crisp ? 1 : 1 + std::max(0.0, fill.nearby);
    box = {box.left - std::max(fill.reach.x, more), box.top - std::max(fill.reach.y, more),
           box.right + std::max(fill.reach.x, more), box.bottom + std::max(fill.reach.y, more)};
    const double left = std::max(window.left, std::floor(box.left)), top = std::max(window.top, std::floor(box.top));
    const double right = std::min(window.right, std::ceil(box.right));
    const double bottom = std::min(window.bottom, std::ceil(box.bottom));
    if (!(right > left && bottom > top))
        return {};
    return {int(left), int(top), int(right - left), int(bottom - top)};
}

void makeDeepSquares(SceneFill &fill, const PixelRect &window)
{
    const auto square = [](int pixel) { return int(std::floor(double(pixel) / SceneFill::deepSide)); };
    fill.deepColumn = square(window.x), fill.deepRow = square(window.y);
    fill.deepColumns = square(window.x + window.width - 1) - fill.deepColumn + 1;
    const int rows = square(window.y + window.height - 1) - fill.deepRow + 1;
    fill.deepSquares.resize(std::size_t(rows) * std::size_t(fill.deepColumns));
    for (std::size_t i = 0; i < fill.deepSquares.size(); ++i) {
        DeepFillSquare &out = fill.deepSquares[i];
        const double x = double(fill.deepColumn + int(i) % fill.deepColumns) * SceneFill::deepSide;
        const double y = double(fill.deepRow + int(i) / fill.deepColumns) * SceneFill::deepSide;
        const Rect counted{x - fill.reach.x, y - fill.reach.y, x + SceneFill::deepSide + fill.reach.x,
                           y + SceneFill::deepSide + fill.reach.y};
        std::vector<const FillPanel *> panels;
        for (const FillPanel &panel : fill.panels)
            if (panel.box.intersects(counted))
                panels.push_back(&panel);
        out.entered = enteredAt(fill.arcs.data(), fill.arcs.size(), {counted.left, counted.top});
        collectFill(fill, panels.data(), panels.size(), counted.left, counted.top, counted.bottom, out.events,
                    out.nodes);
        for (const BoundaryFlat &flat : fill.flats)
            if (flat.y > counted.top && flat.y <= counted.bottom && flat.left < counted.left &&
                counted.left <= flat.right)
                out.events.push_back({flat.y, flat.jump});
    }
}

} // namespace

int enteredAt(const BoundaryArc *arcs, std::size_t count, Point at)
{
    int entered = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const RisingArc &arc = arcs[i].arc;
        if (!(arc.top() <= at.y && at.y < arc.bottom()) || arc.left() >= at.x)
            continue;
        if (arc.right() < at.x || arc.xAt(at.y) < at.x)
            entered += arcs[i].enters;
    }
    return std::clamp(entered, 0, 1);
}

void collectFill(const SceneFill &fill, const FillPanel *const *panels, std::size_t count, double left, double top,
                 double bottom, std::vector<FillEvent> &events, std::vector<FillNode> &nodes)
{
    for (std::size_t i = 0; i < count; ++i) {
        const FillPanel &panel = *panels[i];
        if (panel.box.left >= left) {
            nodes.insert(nodes.end(), fill.nodes.begin() + panel.begin, fill.nodes.begin() + panel.end);
            continue;
        }
        const RisingArc &arc = panel.part.arc;
        const double from = std::max(arc.top(), top), to = std::min(arc.bottom(), bottom);
        if (from < to) {
            const bool leftBefore = arc.xAt(from) < left, leftAfter = arc.xAt(to) < left;
            if (leftBefore != leftAfter)
                events.push_back({std::clamp(arc.curve.at(arc.parameterAtX(left)).y, from, to),
                                  leftBefore ? -panel.part.enters : panel.part.enters});
        }
        if (panel.box.right <= left)
            continue;
        const double at = arc.parameterAtX(left);
        const bool goesRight = arc.curve.p[0].x < arc.curve.p[3].x;
        const Cubic part = goesRight ? between(arc.curve, at, 1) : between(arc.curve, 0, at);
        PanelMaker::appendNodesOf(fill, {{part}, panel.part.enters}, nodes);
    }
}

std::shared_ptr<SceneFill> makeSceneFill(const Stroke &stroke, Microseconds T, const PictureGrid &grid,
                                         const Stroke *strokeBefore, const SceneFill *before,
                                         const std::atomic<bool> *stop)
{
    if (!stroke.fill || !(stroke.fill->age(T) > 0) || !(stroke.fill->density > 0))
        return nullptr;
    const View &view = grid.view;
    auto out = std::make_shared<SceneFill>();
    const bool known = strokeBefore && before && before->boundary->rotation == view.rotation &&
                       before->boundary->mirrored == view.mirrored && strokeBefore->fill &&
                       strokeBefore->fill->rule == stroke.fill->rule && sameOutline(*strokeBefore, stroke);
    out->boundary = known ? before->boundary : turnedBoundary(stroke, view, stop);
    if (!out->boundary)
        return nullptr;
    setSpread(*out, *stroke.fill, stroke, T, view);
    setGradient(*out, stroke, view);
    const Rect window = Rect::of(grid.window.x, grid.window.y, grid.window.width, grid.window.height);
    const double side = out->deep ? SceneFill::deepSide : 16;
    const double farX = std::max(out->reach.x, out->nearby) + side, farY = std::max(out->reach.y, out->nearby) + side;
    const Rect near{window.left - farX, window.top - farY, window.right + farX, window.bottom + farY};
    const Rect box = placeArcs(*out, stroke, view, near);
    double length = 0; // of what is near, in spreads or pixels
    for (const BoundaryArc &part : out->arcs)
        if (const Rect box = part.arc.box(); box.intersects(near))
            length += std::min(box.right, near.right) - std::max(box.left, near.left) +
                      std::min(box.bottom, near.bottom) - std::max(box.top, near.top);
    const double longest = out->crisp  ? crispPanel
                           : out->deep ? 0.5
                                       : 2,
                 scale = out->crisp ? 1 : std::max(out->a, out->c);
    PanelMaker maker(*out, near, std::max(longest, length * scale / double(mostPanels)));
    out->panels.reserve(out->arcs.size());
    out->nodes.reserve(out->crisp ? 0 : out->arcs.size());
    for (const BoundaryArc &part : out->arcs)
        maker.add(part);
    out->arcRuns = boxesOfRuns(out->arcs, [](const BoundaryArc &part) { return part.arc.box(); });
    out->panelRuns = boxesOfRuns(out->panels, [](const FillPanel &panel) { return panel.box; });
    out->bounds = boundsOf(*out, box, window);
    if (out->deep)
        makeDeepSquares(*out, grid.window);
    return out;
}

} // namespace suffuse
