#include "app/panels/inspector/cross_section.h"

#include "model/painting/influence.h"
#include "model/stroke_width.h"
#include "render/reference/local_paint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

constexpr int deepestHalving = 12;

/// M of e^(−dᵀMd), the inverse of 4t times the diffusion tensor, and √det M.
struct Kernel {
    double xx = 0, xy = 0, yy = 0, rootOfDet = 0, largerSpread = 0;

    Kernel(const Segment &segment, double s)
    {
        const double along = 1 / (s * s * double(segment.anisotropyRatio)), across = 1 / (s * s);
        const double c = std::cos(double(segment.anisotropyAngle)), n = std::sin(double(segment.anisotropyAngle));
        xx = along * c * c + across * n * n;
        xy = (along - across) * c * n;
        yy = along * n * n + across * c * c;
        rootOfDet = std::sqrt(along * across);
        largerSpread = s * std::sqrt(std::max(1.0, double(segment.anisotropyRatio)));
    }
    double at(Point d) const { return std::exp(-(xx * d.x * d.x + 2 * xy * d.x * d.y + yy * d.y * d.y)); }
};

/// ∫ e^(−dᵀMd) |c′| dp over [from, to], Gauss-Legendre with four points.
double integral(const Cubic &cubic, const Kernel &kernel, Point point, double from, double to)
{
    static constexpr double node[] = {0.3399810435848563, 0.8611363115940526};
    static constexpr double weight[] = {0.6521451548625461, 0.3478548451374538};
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    double sum = 0;
    for (int i = 0; i < 2; ++i)
        for (const double sign : {-1.0, 1.0}) {
            const double p = middle + sign * half * node[i];
            sum += weight[i] * kernel.at(point - cubic.at(p)) * length(cubic.derivative(p));
        }
    return sum * half;
}

/// One segment's integral at one point: halves the curve down to pieces of a spread, and leaves out those out of reach.
struct CurveIntegral {
    const Cubic &cubic;
    const Kernel &kernel;
    Point point;
    double speed; ///< |c′| is nowhere more
    double piece; ///< length
    double reach;

    double over(double from, double to, int halvings = 0) const
    {
        const double longest = speed * (to - from), middle = 0.5 * (from + to);
        if (length(cubic.at(middle) - point) > reach + 0.5 * longest)
            return 0;
        if (longest <= piece || halvings == deepestHalving)
            return integral(cubic, kernel, point, from, to);
        return over(from, middle, halvings + 1) + over(middle, to, halvings + 1);
    }
};

/// Means over the segments at a point, as the solver takes them.
class Means {
public:
    Means() { m_local.granulation = 0; }

    void add(const Segment &segment, const Style &style, double density)
    {
        m_local.density += density;
        m_local.granulation += density * double(segment.granulation);
        const std::array<float, 4> colour{segment.colour.red, segment.colour.yellow, segment.colour.blue,
                                          segment.colour.opacity};
        for (std::size_t i = 0; i < 4; ++i)
            m_local.colour[i] += density * double(colour[i]);
        int n = 0;
        while (n < m_local.styleCount && m_local.styles[std::size_t(n)].kind != style.kind)
            ++n;
        if (n == m_local.styleCount)
            m_local.styles[std::size_t(m_local.styleCount++)] = {style.kind, 0, {}};
        reference::StyleShare &share = m_local.styles[std::size_t(n)];
        share.share += density;
        for (std::size_t i = 0; i < 3; ++i)
            share.xi[i] += density * double(style.xi[i]);
    }

    double density() const { return m_local.density; }

    reference::Paint paint() const
    {
        if (!(m_local.density > 0))
            return {};
        reference::LocalDensity local = m_local;
        local.granulation /= local.density;
        for (double &c : local.colour)
            c /= local.density;
        for (reference::StyleShare &style : local.styles) {
            for (double &xi : style.xi)
                xi = style.share > 0 ? xi / style.share : 0;
            style.share /= local.density;
        }
        return reference::paintOf(local, 1, 0);
    }

private:
    reference::LocalDensity m_local; ///< sums
};

} // namespace

double segmentDensityAt(const Stroke &stroke, const Segment &segment, Microseconds time, Point point)
{
    const double s = segment.spread(time);
    if (!(segment.age(time) > 0) || !(s > 0) || !(segment.density > 0))
        return 0;
    const Kernel kernel(segment, s);
    Cubic cubic; // offsets from the stroke's origin: far from the canvas' corner nothing is lost
    for (std::size_t i = 0; i < 4; ++i)
        cubic.p[i] = Point{} + segment.bezier[i];
    const Point at = point - stroke.origin;
    const double reach = reachInSpreads * kernel.largerSpread;
    if (!cubic.controlBox().grown(reach).contains(at))
        return 0;
    const double speed = 3 * std::max({length(cubic.p[1] - cubic.p[0]), length(cubic.p[2] - cubic.p[1]),
                                       length(cubic.p[3] - cubic.p[2])});
    const double sum = CurveIntegral{cubic, kernel, at, speed, s, reach}.over(0, 1);
    return double(segment.density) * kernel.rootOfDet / std::numbers::pi * sum;
}

double strokeDensityAt(const Stroke &stroke, Microseconds time, Point point)
{
    double density = 0;
    for (const Segment &segment : stroke.segments)
        density += segmentDensityAt(stroke, segment, time, point);
    return density;
}

std::vector<CrossSectionPoint> crossSectionOf(const Painting &painting, const Stroke &stroke, int segment,
                                              Microseconds time, int samples)
{
    const Segment &middle = stroke.segments[std::size_t(segment)];
    const double age = middle.age(time);
    if (!(age > 0))
        return {};
    const Cubic cubic = stroke.cubicOf(middle);
    Point tangent = cubic.derivative(0.5);
    if (!(length(tangent) > 0))
        tangent = cubic.p[3] - cubic.p[0];
    if (!(length(tangent) > 0))
        tangent = {1, 0};
    const Point normal = (1 / length(tangent)) * Point{-tangent.y, tangent.x};
    const double across = diffusionAcross(middle, tangent);
    const double w = halfWidth(across, double(middle.density), age, visibleCut(stroke.styleOf(middle)));
    const double range = std::max(1.5 * w, 2 * std::sqrt(4 * across * age));

    const Point from = cubic.at(0.5) - range * normal, to = cubic.at(0.5) + range * normal;
    Rect line;
    line.include(from);
    line.include(to);
    std::vector<const Segment *> near;
    for (const Segment &s : stroke.segments)
        if (influenceOf(stroke, s, time).intersects(line))
            near.push_back(&s);

    const reference::Spot ground = reference::bareSpot(painting.canvas.background, false);
    std::vector<CrossSectionPoint> points;
    for (int i = 0; i < samples; ++i) {
        CrossSectionPoint point;
        point.offset = range * (2.0 * i / (samples - 1) - 1);
        Means means;
        for (const Segment *s : near)
            if (const double d = segmentDensityAt(stroke, *s, time, cubic.at(0.5) + point.offset * normal); d > 0)
                means.add(*s, stroke.styleOf(*s), d);
        const reference::Paint paint = means.paint();
        reference::Spot spot = ground;
        reference::mix(spot, stroke.mix, paint);
        point.density = means.density();
        point.opacity = paint.opacity;
        point.rgb = reference::rgbOfRyb(spot.colour);
        points.push_back(point);
    }
    return points;
}

} // namespace suffuse
