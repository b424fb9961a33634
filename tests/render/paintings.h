// Paintings for the render tests: small, but of every kind.
#pragma once

#include "model/painting/painting.h"
#include "render/backends.h"

#include <QtTest>

#include <numbers>
#include <random>

namespace suffuse::test {

enum class Shape { Straight, Curved, Looping, Cusped, Tiny, Huge };
inline constexpr Shape allShapes[] = {Shape::Straight, Shape::Curved, Shape::Looping,
                                      Shape::Cusped,   Shape::Tiny,   Shape::Huge};

/// Control points of three joined segments around `centre`, about `size` across.
inline std::vector<std::array<Point, 4>> curves(Shape shape, Point centre, double size)
{
    const auto at = [&](double x, double y) { return centre + size * Point{x, y}; };
    switch (shape) {
    case Shape::Straight:
        return {{at(-1, -.3), at(-.8, -.25), at(-.6, -.2), at(-.4, -.15)},
                {at(-.4, -.15), at(-.1, -.075), at(.2, 0), at(.5, .075)},
                {at(.5, .075), at(.6, .1), at(.8, .15), at(1, .2)}};
    case Shape::Curved:
        return {{at(-1, 0), at(-.8, -.9), at(-.5, -.9), at(-.2, -.2)},
                {at(-.2, -.2), at(.0, .3), at(.3, .6), at(.5, .1)},
                {at(.5, .1), at(.6, -.2), at(.9, -.4), at(1, .4)}};
    case Shape::Looping:
        return {{at(-.6, .2), at(1.2, -1), at(-1.2, -1), at(.6, .2)},
                {at(.6, .2), at(1.1, .6), at(-.9, 1.2), at(-.3, -.1)},
                {at(-.3, -.1), at(0, -.9), at(.3, .9), at(.1, .3)}};
    case Shape::Cusped:
        return {{at(-.8, .3), at(.8, -.6), at(-.8, -.6), at(.8, .3)},
                {at(.8, .3), at(.8, .3), at(.1, .9), at(-.2, .5)},
                {at(-.2, .5), at(.6, .1), at(-.6, .1), at(-.2, .5)}};
    case Shape::Tiny:
        return {{at(0, 0), at(.01, 0), at(.02, .01), at(.03, .01)},
                {at(.03, .01), at(.04, .01), at(.04, .02), at(.05, .03)},
                {at(.05, .03), at(.05, .04), at(.04, .05), at(.03, .06)}};
    case Shape::Huge:
        break;
    }
    return {{at(-30, -9), at(-12, -4), at(-9, 3), at(-1, .2)},
            {at(-1, .2), at(-.4, 0), at(.4, -.6), at(1, -.2)},
            {at(1, -.2), at(8, 3), at(20, -14), at(40, 9)}};
}

inline Style styleOf(StyleKind kind)
{
    switch (kind) {
    case StyleKind::Uniform:
        return {kind, {0.5f, 0.05f, 0}};
    case StyleKind::Feathering:
        return {kind, {1.1f, 1.5f, 0}};
    case StyleKind::Edge:
        break;
    }
    return {StyleKind::Edge, {0.36f, 0.40f, 0.5f}};
}

/// A stroke of peak density 1.2 and spread s at full age.
inline Stroke stroke(StrokeId id, Shape shape, Point centre, double size, double spread, Style style, Mix mix = {},
                     Colour colour = {0.1f, 0.7f, 0.9f, 0.9f})
{
    Stroke s;
    s.id = id;
    s.style = style;
    s.mix = mix;
    s.origin = {std::round(centre.x), std::round(centre.y)};
    for (const auto &c : curves(shape, centre, size)) {
        Segment g;
        for (int i = 0; i < 4; ++i)
            g.bezier[std::size_t(i)] = toOffset(c[std::size_t(i)], s.origin);
        g.diffusion = float(spread * spread / 4);
        g.density = float(1.2 * std::sqrt(std::numbers::pi) * spread);
        if (shape == Shape::Tiny) // too short to reach its peak: stronger
            g.density *= float(spread / (size * 0.05));
        g.colour = colour;
        s.segments.push_back(g);
    }
    return s;
}

inline PaintingPtr painting(std::vector<Stroke> strokes, double width = 96, double height = 72, Paper paper = {})
{
    auto p = std::make_shared<Painting>();
    p->canvas.width = width;
    p->canvas.height = height;
    p->canvas.paper = paper;
    for (Stroke &s : strokes)
        p->strokes.push_back(std::make_shared<const Stroke>(std::move(s)));
    return p;
}

inline Style randomStyle(std::mt19937_64 &random)
{
    std::uniform_real_distribution<double> u(0, 1);
    Style s = styleOf(StyleKind(random() % 3));
    if (s.kind == StyleKind::Uniform)
        s.xi = {float(0.2 + 0.6 * u(random)), float(0.01 * std::pow(20, u(random))), 0};
    else if (s.kind == StyleKind::Feathering)
        s.xi = {float(0.5 + u(random)), float(0.5 * std::pow(16, u(random))), 0};
    else
        s.xi[0] = float(0.3 + 0.2 * u(random)), s.xi[1] = s.xi[0] * float(0.6 + 0.6 * u(random)),
        s.xi[2] = float(0.2 + 0.8 * u(random));
    return s;
}

/// Strokes of all shapes, styles and mixings; some with colours, granulation and styles that vary along them.
inline std::vector<Stroke> randomStrokes(std::mt19937_64 &random, int count, double width, double height)
{
    std::uniform_real_distribution<double> u(0, 1);
    const auto channel = [&] { return float(u(random)); };
    std::vector<Stroke> strokes;
    for (int j = 0; j < count; ++j) {
        const Mix mix = random() % 2 ? Mix{MixMode::Beta, channel()} : Mix{};
        Stroke s = stroke(StrokeId(j + 1), allShapes[random() % 6], {width * u(random), height * u(random)},
                          5 + 30 * u(random), 2 + 8 * u(random), randomStyle(random), mix,
                          {channel(), channel(), channel(), channel()});
        const bool colours = random() % 3 == 0, grains = random() % 3 == 0, styles = random() % 4 == 0;
        for (Segment &g : s.segments) {
            g.granulation = grains ? channel() : 1;
            if (colours)
                g.colour = {channel(), channel(), channel(), channel()};
            if (styles && random() % 2)
                g.style = randomStyle(random);
        }
        strokes.push_back(std::move(s));
    }
    return strokes;
}

/// The painting with one stroke stronger or weaker.
inline PaintingPtr withDensity(const PaintingPtr &p, std::size_t index, double factor)
{
    auto q = std::make_shared<Painting>(*p);
    Stroke s = *p->strokes[index];
    for (Segment &g : s.segments)
        g.density *= float(factor);
    q->strokes[index] = std::make_shared<const Stroke>(s);
    return q;
}

/// One random edit of a painting: of a stroke's attributes, of the order, or of what is there.
inline PaintingPtr randomlyEdited(const PaintingPtr &p, std::mt19937_64 &random)
{
    std::uniform_real_distribution<double> u(0, 1);
    const std::size_t j = random() % p->strokes.size();
    Stroke s = *p->strokes[j];
    Segment &g = s.segments[random() % s.segments.size()];
    auto q = std::make_shared<Painting>(*p);
    switch (random() % 9) {
    case 0: g.diffusion *= float(0.5 + u(random)); break;
    case 1: g.density *= float(0.5 + u(random)); break;
    case 2: g.colour = {float(u(random)), 0.5f, float(u(random)), 1}; break;
    case 3: g.style = randomStyle(random); break;
    case 4: s.style = randomStyle(random); break;
    case 5: s.mix = {MixMode::Beta, float(u(random))}; break;
    case 6: s.visible = !s.visible; break;
    case 7: g.granulation = float(u(random)); break;
    case 8: s.segments.front().born += 100000; break;
    }
    q->strokes[j] = std::make_shared<const Stroke>(s);
    if (random() % 5 == 0)
        std::swap(q->strokes[random() % q->strokes.size()], q->strokes[random() % q->strokes.size()]);
    if (random() % 7 == 0 && q->strokes.size() > 3)
        q->strokes.erase(q->strokes.begin() + std::ptrdiff_t(random() % q->strokes.size()));
    return q;
}

inline FloatPicture render(Renderer &renderer, const PaintingPtr &painting, const View &view, Microseconds time = -1,
                           bool transparent = false)
{
    FloatPicture picture;
    RenderRequest request{painting, time < 0 ? painting->end() : time, view, transparent};
    renderer.invalidate();
    const auto stats = renderer.render(request, picture);
    if (!stats)
        qFatal("%s", qPrintable(stats.error()));
    return picture;
}

inline std::unique_ptr<Renderer> make(Backend backend, int threads = 0, int tileSize = 0)
{
    auto renderer = makeRenderer({backend, threads, tileSize});
    if (!renderer)
        qFatal("%s", qPrintable(renderer.error()));
    return std::move(*renderer);
}

/// Greatest difference of any channel, and where. Colour counts as far as it is covered: an uncovered pixel's straight
/// colour is a quotient of two zeros.
struct Worst {
    double difference = 0;
    int x = 0, y = 0;
};
inline Worst worst(const FloatPicture &a, const FloatPicture &b)
{
    Worst w;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < 4; ++c) {
                const double u = c < 3 ? double(a.at(x, y)[3]) : 1, v = c < 3 ? double(b.at(x, y)[3]) : 1;
                const double d = std::abs(u * double(a.at(x, y)[c]) - v * double(b.at(x, y)[c]));
                if (!(d <= w.difference))
                    w = {d, x, y};
            }
    return w;
}

} // namespace suffuse::test
