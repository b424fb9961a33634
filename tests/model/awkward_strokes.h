// For tests of shapes: strokes with all that a segment can have, on curves with loops, cusps and hairpins, and what
// compares them.
#pragma once

#include "model/shaping/nodes/reshape.h"

#include <random>

namespace suffuse::test {

class AwkwardStrokes {
public:
    explicit AwkwardStrokes(unsigned seed) : m_random(seed) {}

    double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(m_random); }
    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(m_random); }
    Point point(double size) { return {real(-size, size), real(-size, size)}; }

    /// Control points of one segment from a point on, about `size` across.
    std::array<Point, 4> curve(Point start, double size)
    {
        std::array<Point, 4> c{start, start + point(size), start + point(size), start + point(size)};
        switch (below(7)) {
        case 0: // loop
            c[3] = c[0] + 0.1 * point(size);
            break;
        case 1: // cusp
            c = {start, start + Point{size, size}, start + Point{0, size}, start + Point{size, 0}};
            break;
        case 2: // both handles drawn in
            c[1] = c[0];
            c[2] = c[3];
            break;
        case 3: // back and forth on a line
            c[1] = c[0] + 1.7 * (c[3] - c[0]);
            c[2] = c[0] - 0.9 * (c[3] - c[0]);
            break;
        case 4: // straight
            c[1] = c[0] + (1.0 / 3) * (c[3] - c[0]);
            c[2] = c[0] + (2.0 / 3) * (c[3] - c[0]);
            break;
        default:
            break;
        }
        return c;
    }

    Segment values(double spread)
    {
        Segment s;
        s.diffusion = float(spread * spread / 4 * real(0.5, 2));
        s.density = float(real(0.5, 3) * spread);
        s.granulation = float(real(0, 1));
        s.maxAge = float(real(0.1, 3));
        s.born = below(5'000'000);
        s.colour = {float(real(0, 1)), float(real(0, 1)), float(real(0, 1)), float(real(0, 1))};
        if (below(4) == 0)
            s.style = Style{StyleKind::Feathering, {float(real(0.5, 2)), float(real(0.5, 4)), 0}};
        if (below(3) == 0) {
            s.anisotropyRatio = float(std::exp(real(-2, 2)));
            s.anisotropyAngle = float(real(-4, 4));
        }
        s.node = NodeKind(below(3));
        if (below(4) == 0)
            s.rewet = {{s.born + 10, 1000}, {s.born + 500, 20}};
        return s;
    }

    Stroke stroke(int segments, double size = 40, double spread = 7)
    {
        Stroke s;
        s.id = 1;
        s.name = QStringLiteral("line");
        s.brush = QStringLiteral("pencil");
        s.mix = {MixMode::Beta, 0.5f};
        s.origin = point(300);
        Offset at = toOffset(point(50), {});
        for (int k = 0; k < segments; ++k) {
            Segment g = values(spread);
            const auto c = curve(Point() + at, size);
            for (std::size_t i = 0; i < 4; ++i)
                g.bezier[i] = toOffset(c[i], {});
            g.bezier[0] = at;
            at = g.bezier[3];
            s.segments.push_back(g);
        }
        return s;
    }

    /// The same with several chains, some of whose segments take paint away.
    Stroke chains(int segments, double size = 40, double spread = 7)
    {
        Stroke s = stroke(segments, size, spread);
        for (std::size_t k = 1; k < s.segments.size(); ++k) {
            s.segments[k].start = below(3) == 0;
            s.segments[k].lift = below(4) == 0;
            if (k % 2)
                std::swap(s.segments[k].lift, s.segments[k].fade);
            if (s.segments[k].start && below(4) > 0)
                s.segments[k].bezier[0] = toOffset(point(50), {});
        }
        return s;
    }

private:
    std::mt19937_64 m_random;
};

/// Equal but for the control points.
inline bool sameValues(Segment a, const Segment &b)
{
    a.bezier = b.bezier;
    a.node = b.node;
    return a == b;
}

/// Largest distance of points of the second curve from the first stroke's.
inline double distanceFrom(const Stroke &stroke, const Stroke &other)
{
    double most = 0;
    for (const Segment &s : other.segments)
        for (double p = 0; p <= 1; p += 1.0 / 16) {
            double d = 0;
            nearestPlace(stroke, other.cubicOf(s).at(p), &d);
            most = std::max(most, d);
        }
    return most;
}

inline double largestDifference(const Stroke &a, const Stroke &b)
{
    double most = 0;
    for (std::size_t k = 0; k < a.segments.size(); ++k)
        for (std::size_t i = 0; i < 4; ++i)
            most = std::max(most, length((a.origin + a.segments[k].bezier[i]) - (b.origin + b.segments[k].bezier[i])));
    return most;
}

inline Stroke line(std::vector<Point> nodes)
{
    Stroke s;
    s.id = 1;
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
        Segment g;
        for (std::size_t i = 0; i < 4; ++i)
            g.bezier[i] = toOffset(nodes[k] + (double(i) / 3) * (nodes[k + 1] - nodes[k]), {});
        s.segments.push_back(g);
    }
    return s;
}

} // namespace suffuse::test
