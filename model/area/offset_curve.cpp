#include "model/area/offset_curve.h"

#include "model/shaping/curves/split.h"

#include <numbers>

namespace suffuse {

namespace {

Point secondDerivative(const Cubic &c, double t)
{
    return (6 * (1 - t)) * (c.p[2] - 2 * c.p[1] + c.p[0]) + (6 * t) * (c.p[3] - 2 * c.p[2] + c.p[1]);
}

/// The point at a distance from the curve, and the derivative there.
struct Beside {
    Point at, derivative;
};
Beside beside(const Cubic &curve, double t, double distance)
{
    const Point d = curve.derivative(t), along = unit(d);
    const double speed = length(d), curvature = cross(d, secondDerivative(curve, t)) / (speed * speed * speed);
    return {curve.at(t) + distance * turned(along), (1 - distance * curvature) * d};
}

void fit(const Cubic &curve, double from, double to, double distance, double tolerance, int depth,
         std::vector<Cubic> &out)
{
    const Beside a = beside(curve, from, distance), b = beside(curve, to, distance);
    const double third = (to - from) / 3;
    const Cubic guess{{a.at, a.at + third * a.derivative, b.at - third * b.derivative, b.at}};
    // Along the curve the two may be farther apart than across it, where it shows.
    constexpr double alongAcross = 30;
    bool isNear = true;
    for (const double share : {0.25, 0.5, 0.75}) {
        const Beside wanted = beside(curve, from + share * (to - from), distance);
        const Point off = guess.at(share) - wanted.at, along = unit(wanted.derivative);
        isNear =
            isNear && std::abs(cross(off, along)) <= tolerance && std::abs(dot(off, along)) <= alongAcross * tolerance;
    }
    if (isNear || depth == 0) {
        out.push_back(guess);
        return;
    }
    const double middle = 0.5 * (from + to);
    fit(curve, from, middle, distance, tolerance, depth - 1, out);
    fit(curve, middle, to, distance, tolerance, depth - 1, out);
}

} // namespace

Cubic straightCubic(Point a, Point b)
{
    return {{a, a + (1.0 / 3) * (b - a), b - (1.0 / 3) * (b - a), b}};
}

std::vector<Cubic> arcAround(Point centre, Point from, double angle)
{
    const int parts = std::max(1, int(std::ceil(std::abs(angle) / (std::numbers::pi / 2) - 1e-9)));
    const double step = angle / parts, handle = 4.0 / 3 * std::tan(step / 4), c = std::cos(step), s = std::sin(step);
    std::vector<Cubic> arcs;
    for (Point arm = from - centre; int(arcs.size()) < parts;) {
        const Point next{c * arm.x - s * arm.y, s * arm.x + c * arm.y};
        arcs.push_back({{centre + arm, centre + arm + handle * turned(arm), centre + next - handle * turned(next),
                         centre + next}});
        arm = next;
    }
    return arcs;
}

bool isGentle(const Cubic &curve, double distance)
{
    const Point legs[] = {curve.p[1] - curve.p[0], curve.p[2] - curve.p[1], curve.p[3] - curve.p[2]};
    for (const Point &a : legs)
        for (const Point &b : legs)
            if (!(dot(a, b) > 0.5 * length(a) * length(b)))
                return false;
    constexpr int places = 8;
    for (int i = 0; i <= places; ++i) {
        const double t = double(i) / places;
        const Point d = curve.derivative(t);
        const double speed = length(d);
        if (!(std::abs(cross(d, secondDerivative(curve, t))) * distance < 0.95 * speed * speed * speed))
            return false;
    }
    return true;
}

void appendOffset(const Cubic &curve, double distance, double tolerance, std::vector<Cubic> &out)
{
    fit(curve, 0, 1, distance, tolerance, 10, out);
}

} // namespace suffuse
