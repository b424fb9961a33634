// Strokes of several chains, from which paint is lifted or whose paint is made paler, for the render tests.
#pragma once

#include "model/shaping/curves/chains.h"
#include "tests/render/paintings.h"

namespace suffuse::test {

/// A lifting segment from a to b of a spread, in a stroke's offsets, whose density has the given peak.
inline Segment liftBetween(const Stroke &stroke, Point a, Point b, double spread, double peak)
{
    Segment g;
    for (int i = 0; i < 4; ++i)
        g.bezier[std::size_t(i)] = toOffset(a + (double(i) / 3) * (b - a), stroke.origin);
    g.diffusion = float(spread * spread / 4);
    g.density = float(peak * std::sqrt(std::numbers::pi) * spread);
    g.lift = true;
    return g;
}

/// Lifts along a line of several segments from a to b, as a chain of its own.
inline void liftAlong(Stroke &stroke, Point a, Point b, double spread, double peak, int segments = 4)
{
    std::vector<Segment> chain;
    for (int k = 0; k < segments; ++k) {
        chain.push_back(liftBetween(stroke, a + (double(k) / segments) * (b - a),
                                    a + (double(k + 1) / segments) * (b - a), spread, peak));
        if (k > 0)
            chain.back().bezier[0] = chain[std::size_t(k) - 1].bezier[3];
    }
    appendChain(stroke, std::move(chain));
}

/// Makes paint paler along a line, as liftAlong lifts it. `peak`: e^−peak of the opacity is left on the line.
inline void fadeAlong(Stroke &stroke, Point a, Point b, double spread, double peak, int segments = 4)
{
    const std::size_t before = stroke.segments.size();
    liftAlong(stroke, a, b, spread, peak, segments);
    for (std::size_t k = before; k < stroke.segments.size(); ++k)
        stroke.segments[k].lift = false, stroke.segments[k].fade = true;
}

/// A wash: a stroke that goes to and fro over an area, `passes` times, so that its passes run into each other.
inline Stroke wash(StrokeId id, const Rect &area, int passes, double spread, const Style &style, double peak = 0.9)
{
    Stroke s = stroke(id, Shape::Tiny, {}, 1, spread, style);
    const Segment first = s.segments.front();
    s.origin = {};
    s.segments.clear();
    Offset at = toOffset({area.left, area.top}, {});
    for (int pass = 0; pass < passes; ++pass) {
        const int each = 8;
        for (int k = 1; k <= each; ++k) {
            const double along = double(pass % 2 ? each - k : k) / each;
            const Point a = Point() + at, b{area.left + along * area.width(),
                                            area.top + (pass + double(k) / each) / passes * area.height()};
            Segment g = first;
            g.bezier = {at, toOffset(a + (1.0 / 3) * (b - a), {}), toOffset(a + (2.0 / 3) * (b - a), {}),
                        toOffset(b, {})};
            g.density = float(peak * double(style.xi[0]) * std::sqrt(std::numbers::pi) * spread);
            at = g.bezier[3];
            s.segments.push_back(g);
        }
    }
    return s;
}

/// Random strokes, most of which have more chains and lifting segments: soft and sharp ones, weak and strong ones,
/// young ones, anisotropic ones.
inline std::vector<Stroke> liftedStrokes(std::mt19937_64 &random, int count, double width, double height)
{
    std::uniform_real_distribution<double> u(0, 1);
    std::vector<Stroke> strokes = randomStrokes(random, count, width, height);
    for (Stroke &s : strokes) {
        if (random() % 3 == 0) { // another chain: the same curves elsewhere
            std::vector<Segment> chain = s.segments;
            const Point by{width * (u(random) - 0.5), height * (u(random) - 0.5)};
            for (Segment &g : chain)
                for (Offset &o : g.bezier)
                    o = toOffset(by + o, {});
            appendChain(s, std::move(chain));
        }
        for (std::uint64_t chains = random() % 3; chains > 0; --chains) {
            const Point a{width * u(random), height * u(random)}, b{width * u(random), height * u(random)};
            const std::size_t before = s.segments.size();
            liftAlong(s, a, b, 1 + 8 * u(random), 0.2 + 2 * u(random), 1 + int(random() % 5));
            const bool tensor = random() % 4 == 0, young = random() % 4 == 0;
            for (std::size_t k = before; k < s.segments.size(); ++k) {
                if (tensor)
                    s.segments[k].anisotropyRatio = 4, s.segments[k].anisotropyAngle = 0.5f;
                if (young)
                    s.segments[k].born = Microseconds(k) * 150'000;
                s.segments[k].colour = {float(u(random)), 1, 0, float(u(random))}; // counts for nothing
            }
        }
    }
    return strokes;
}

/// The same, of which some chains fade instead, and so do a few segments among those that lay paint.
inline std::vector<Stroke> fadedStrokes(std::mt19937_64 &random, int count, double width, double height)
{
    std::vector<Stroke> strokes = liftedStrokes(random, count, width, height);
    for (Stroke &s : strokes) {
        bool fades = false;
        for (std::size_t k = 0; k < s.segments.size(); ++k) {
            Segment &g = s.segments[k];
            if (s.beginsChain(k))
                fades = g.lift ? random() % 2 : random() % 8 == 0 && k > 0;
            if (fades)
                g.lift = false, g.fade = true;
        }
    }
    return strokes;
}

/// Usual and steep ones of every kind.
inline std::vector<Style> someStyles()
{
    return {styleOf(StyleKind::Uniform),
            styleOf(StyleKind::Feathering),
            styleOf(StyleKind::Edge),
            {StyleKind::Uniform, {0.5f, 0.005f, 0}},
            {StyleKind::Uniform, {0.1f, 0.05f, 0}},
            {StyleKind::Feathering, {1, 0.5f, 0}},
            {StyleKind::Feathering, {0.6f, 12, 0}},
            {StyleKind::Edge, {0.3f, 0.37f, 1}},
            {StyleKind::Edge, {0.3f, 0.1f, 0.05f}}};
}

inline QByteArray nameOf(const Style &s)
{
    return QByteArray("kind ") + QByteArray::number(int(s.kind)) + " xi " + QByteArray::number(double(s.xi[0])) + ' ' +
           QByteArray::number(double(s.xi[1])) + ' ' + QByteArray::number(double(s.xi[2]));
}

} // namespace suffuse::test
