// Random scenes of plain numbers, and losses on their pictures.
#pragma once

#include "render/gradient/scene_gradient.h"

#include <cmath>
#include <numbers>
#include <random>

namespace suffuse::test {

using namespace gradient;

/// What random strokes are like.
struct SceneKind {
    StyleKind style = StyleKind::Uniform;
    bool pigment = false;  ///< mixed by (23)
    bool oneColour = true; ///< along each stroke
    bool paper = false;
    bool lifts = false; ///< whether the last segment of each stroke takes paint away,
    bool fades = false; ///< and the last one of the others makes it paler
    bool turnedView = false;
    bool filled = false;              ///< whether each stroke goes round an area
    int segments = 3;                 ///< of a stroke
    double least = 1.5, greatest = 6; ///< spreads, px
    double length = 14;               ///< of a segment, px
};

inline void setXi(FlatStroke &stroke, double a, double b, double c)
{
    switch (stroke.kind) {
    case StyleKind::Uniform:
        stroke.xi[0] = 0.3 + 0.4 * a, stroke.xi[1] = 0.03 + 0.1 * b;
        return;
    case StyleKind::Feathering:
        stroke.xi[0] = 0.6 + a, stroke.xi[1] = 0.6 + 2 * b;
        return;
    case StyleKind::Edge:
        stroke.xi[0] = 0.3 + 0.2 * a, stroke.xi[1] = stroke.xi[0] * (0.7 + 0.4 * b), stroke.xi[2] = 0.3 + 0.6 * c;
    }
}

/// A view of scale 1.25, turned and mirrored, or one of scale 1.
inline View viewOf(int width, int height, bool turned)
{
    View view = View::ofArea(Rect::of(0, 0, width, height), width, height);
    if (turned)
        view.scale = 1.25, view.rotation = 0.7, view.mirrored = true;
    return view;
}

/// Makes the segments of a stroke go round a point, at some distance. Every other one is nothing but an outline, and a
/// straight line is left to close it.
inline void surround(FlatStroke &stroke, FlatScene &scene, Point centre, double distance)
{
    stroke.filled = true;
    const double part = 1.9 * std::numbers::pi / stroke.count;
    for (std::uint32_t k = 0; k < stroke.count; ++k) {
        SegmentNumbers &s = scene.segments[stroke.first + k];
        if (scene.marks[stroke.first + k].fade) { // It goes through the middle.
            const double byX = centre.x - s.x[0], byY = centre.y - s.y[0];
            for (int j = 0; j < 4; ++j)
                s.x[j] += byX, s.y[j] += byY;
            continue;
        }
        for (int j = 0; j < 4; ++j) {
            const double angle = part * (k + j / 3.0), radius = distance * (1 + 0.2 * std::sin(3 * angle));
            s.x[j] = centre.x + radius * std::cos(angle), s.y[j] = centre.y + radius * std::sin(angle);
        }
        if (k % 2 == 0)
            s.density = 0;
    }
}

inline FlatScene randomScene(std::uint64_t seed, int strokes, int width, int height, const SceneKind &kind)
{
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> u(0, 1);
    FlatScene scene;
    scene.view = viewOf(width, height, kind.turnedView);
    for (double &c : scene.background)
        c = 0.1 + 0.2 * u(random);
    if (kind.paper) {
        auto paper = std::make_shared<std::vector<float>>(std::size_t(width) * std::size_t(height));
        for (float &eta : *paper)
            eta = float(0.3 + 0.7 * u(random));
        scene.paper = std::move(paper);
    }
    for (int i = 0; i < strokes; ++i) {
        FlatStroke stroke;
        stroke.first = std::uint32_t(scene.segments.size()), stroke.count = std::uint32_t(kind.segments);
        stroke.kind = kind.style, stroke.keep = kind.pigment ? u(random) : 1, stroke.oneColour = kind.oneColour;
        const double a = u(random), b = u(random);
        setXi(stroke, a, b, u(random));
        double x = width * u(random), y = height * u(random), angle = 2 * std::numbers::pi * u(random);
        const double spread = kind.least * std::pow(kind.greatest / kind.least, u(random));
        for (int k = 0; k < kind.segments; ++k) {
            SegmentNumbers s;
            for (int j = 0; j < 4; ++j) {
                s.x[j] = x, s.y[j] = y;
                angle += 0.5 * (u(random) - 0.5);
                const double step = j < 3 ? kind.length / 3 * (0.5 + u(random)) : 0;
                x += step * std::cos(angle), y += step * std::sin(angle);
            }
            s.spread = spread * (1 + 0.2 * u(random));
            s.density = 1.2 * std::sqrt(std::numbers::pi) * s.spread * (0.8 + 0.4 * u(random));
            for (double &c : s.colour)
                c = 0.05 + 0.9 * u(random);
            s.opacity = 0.3 + 0.65 * u(random);
            s.granulation = kind.paper ? u(random) : 1;
            const bool lifts = kind.lifts && k == kind.segments - 1;
            const bool fades = kind.fades && k == kind.segments - (kind.lifts ? 2 : 1);
            if (lifts || fades) // across the ones before
                for (int j = 0; j < 4; ++j)
                    s.x[j] = scene.segments.back().x[j] + 0.4 * spread, s.density *= 0.9;
            scene.segments.push_back(s);
            scene.marks.push_back({k == 0 || lifts || fades, lifts, fades});
        }
        if (kind.filled) { // one value after the other: compilers evaluate arguments in orders of their own
            const double distance = 2 * kind.length * (0.5 + u(random));
            const Point centre{width * u(random), height * u(random)};
            surround(stroke, scene, centre, distance);
            stroke.fill = {
                0.8 + 0.4 * u(random), 1.3 * spread, {u(random), 0.5, u(random)}, 0.3 + 0.6 * u(random), u(random)};
        }
        scene.strokes.push_back(stroke);
    }
    return scene;
}

/// Random derivatives of a loss that is linear in the picture.
template <class Number>
std::vector<Number> randomLoss(std::uint64_t seed, int width, int height)
{
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> u(-1, 1);
    std::vector<Number> by(std::size_t(width) * std::size_t(height) * 3);
    for (Number &value : by)
        value = Number(float(u(random)));
    return by;
}

/// Calls use(number, derivative, scale) for all numbers of a scene and the derivatives by them. A change by `scale` is
/// one that shows.
template <class Use>
void forEachNumber(FlatScene &scene, const FlatGradient &by, Use use)
{
    for (std::size_t i = 0; i < scene.strokes.size(); ++i) {
        FlatStroke &stroke = scene.strokes[i];
        for (std::size_t k = stroke.first; k < stroke.first + stroke.count; ++k) {
            SegmentNumbers &s = scene.segments[k];
            const SegmentNumbers &d = by.segments[k];
            const double spread = s.spread, density = s.density;
            for (int j = 0; j < 4; ++j)
                use(s.x[j], d.x[j], spread), use(s.y[j], d.y[j], spread);
            if (density > 0 || !stroke.filled) {
                use(s.density, d.density, density);
                use(s.spread, d.spread, spread);
            }
            if (stroke.oneColour && (k > stroke.first || stroke.filled))
                continue;
            for (int c = 0; c < 3; ++c)
                use(s.colour[c], d.colour[c], 1.0);
            use(s.opacity, d.opacity, 1.0);
            use(s.granulation, d.granulation, 1.0);
        }
        FillNumbers &fill = stroke.fill;
        const FillNumbers &d = by.strokes[i].fill;
        if (stroke.filled) {
            const double spread = fill.spread;
            use(fill.density, d.density, 1.0), use(fill.spread, d.spread, spread);
            for (int c = 0; c < 3; ++c)
                use(fill.colour[c], d.colour[c], 1.0);
            use(fill.opacity, d.opacity, 1.0), use(fill.granulation, d.granulation, 1.0);
        }
        for (int j = 0; j < (stroke.kind == StyleKind::Edge ? 3 : 2); ++j)
            use(stroke.xi[j], by.strokes[i].xi[j], stroke.xi[j]);
    }
}

} // namespace suffuse::test
