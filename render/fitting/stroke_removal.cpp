#include "render/fitting/stroke_removal.h"

#include "model/brush/random_values.h"

#include <algorithm>
#include <cmath>

namespace suffuse::fitting {

namespace {

constexpr double reach = 5; ///< in spreads: beyond, a stroke is not seen
constexpr int samples = 16; ///< of random signs
constexpr int tile = 16;    ///< Boxes begin at whole tiles, so that they hold the same bits as the picture.

} // namespace

PixelRect boxOf(const FitStroke &stroke, const View &view)
{
    const double s = reach * std::exp(stroke[LogSpread]);
    double left = stroke[0], right = left, top = stroke[1], bottom = top;
    for (std::size_t i = 1; i < strokePoints; ++i) {
        left = std::min(left, stroke[2 * i]), right = std::max(right, stroke[2 * i]);
        top = std::min(top, stroke[2 * i + 1]), bottom = std::max(bottom, stroke[2 * i + 1]);
    }
    const Point from = view.toPixels({left - s, top - s}), to = view.toPixels({right + s, bottom + s});
    const auto bound = [](double v, int most) { return int(std::clamp(v, 0.0, double(most))); };
    const int x = bound(std::floor(from.x), view.width) / tile * tile,
              y = bound(std::floor(from.y), view.height) / tile * tile;
    const int endX = std::min(view.width, (bound(std::ceil(to.x), view.width) + tile - 1) / tile * tile),
              endY = std::min(view.height, (bound(std::ceil(to.y), view.height) + tile - 1) / tile * tile);
    return {x, y, endX - x, endY - y};
}

bool meet(const PixelRect &a, const PixelRect &b)
{
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

View partOf(const View &view, const PixelRect &box)
{
    const Point from = view.toCanvas(Point{double(box.x), double(box.y)}),
                to = view.toCanvas(Point{double(box.x + box.width), double(box.y + box.height)});
    View out = view;
    out.centre = {0.5 * (from.x + to.x), 0.5 * (from.y + to.y)};
    out.width = box.width, out.height = box.height;
    return out;
}

std::shared_ptr<const std::vector<float>> groundIn(const std::vector<float> *ground, int width, const PixelRect &box)
{
    if (!ground)
        return {};
    auto out = std::make_shared<std::vector<float>>();
    out->reserve(3 * std::size_t(box.width) * std::size_t(box.height));
    for (int y = box.y; y < box.y + box.height; ++y) {
        const auto from = ground->begin() + 3 * (std::ptrdiff_t(y) * width + box.x);
        out->insert(out->end(), from, from + 3 * std::ptrdiff_t(box.width));
    }
    return out;
}

double errorIn(const std::vector<FitStroke> &strokes, StyleKind style, const Colour &background,
               const RemovalView &seen, const PixelRect &box)
{
    gradient::SceneGradient<float> gradient{Threads(1)};
    gradient::FlatScene scene = sceneOf(strokes, style, background, partOf(seen.view, box));
    scene.ground = groundIn(seen.ground, seen.view.width, box);
    gradient.choose(scene);
    const std::span<const float> drawn = gradient.draw(scene);
    double sum = 0;
    for (int y = 0; y < box.height; ++y)
        for (int x = 0; x < box.width; ++x) {
            const float *const is = drawn.data() + (std::size_t(y) * std::size_t(box.width) + std::size_t(x)) * 3,
                               *const wanted = seen.target.at(box.x + x, box.y + y);
            double here = 0;
            for (int c = 0; c < 3; ++c)
                here += double(is[c] - wanted[c]) * double(is[c] - wanted[c]);
            sum += here * (seen.weight.isEmpty() ? 1 : double(*seen.weight.at(box.x + x, box.y + y)));
        }
    return sum;
}

std::vector<double> errorsWithout(const std::vector<FitStroke> &strokes, const std::vector<std::size_t> &which,
                                  StyleKind style, const Colour &background, const RemovalView &seen,
                                  const Threads &threads, const std::atomic<bool> *cancel)
{
    std::vector<PixelRect> boxes;
    boxes.reserve(strokes.size());
    for (const FitStroke &stroke : strokes)
        boxes.push_back(boxOf(stroke, seen.view));
    std::vector<double> out(which.size());
    parallelFor(which.size(), threads, [&](std::size_t k) {
        const PixelRect &box = boxes[which[k]];
        if (box.isEmpty() || (cancel && *cancel))
            return;
        std::vector<FitStroke> with, without;
        for (std::size_t i = 0; i < strokes.size(); ++i)
            if (meet(box, boxes[i])) {
                with.push_back(strokes[i]);
                if (i != which[k])
                    without.push_back(strokes[i]);
            }
        out[k] = errorIn(without, style, background, seen, box) - errorIn(with, style, background, seen, box);
    });
    if (cancel && *cancel)
        return {};
    return out;
}

std::vector<double> roughErrorsWithout(gradient::Differentiator &gradient, const gradient::FlatScene &scene,
                                       const RemovalView &seen, std::uint64_t seed, const std::atomic<bool> *cancel)
{
    const std::span<const float> drawn = gradient.draw(scene);
    std::vector<float> by(drawn.size());
    const auto weightAt = [&seen](std::size_t i) { return seen.weight.isEmpty() ? 1.0f : seen.weight.values[i / 3]; };
    const auto slopeOf = [&](const gradient::FlatGradient &of, std::size_t stroke) {
        return of.segments[scene.strokes[stroke].first].opacity * scene.segments[scene.strokes[stroke].first].opacity;
    };
    for (std::size_t i = 0; i < by.size(); ++i)
        by[i] = 2 * weightAt(i) * (drawn[i] - seen.target.values[i]);
    std::vector<double> out(scene.strokes.size());
    const gradient::FlatGradient &slopes = gradient.backward(by);
    for (std::size_t k = 0; k < out.size(); ++k)
        out[k] = -slopeOf(slopes, k);
    for (int sample = 0; sample < samples; ++sample) {
        if (cancel && *cancel)
            return {};
        for (std::size_t i = 0; i < by.size(); ++i)
            by[i] = std::copysign(std::sqrt(weightAt(i)), float(randomAt(seed, sample, std::int64_t(i)) - 0.5));
        const gradient::FlatGradient &bySigns = gradient.backward(by);
        for (std::size_t k = 0; k < out.size(); ++k)
            out[k] += slopeOf(bySigns, k) * slopeOf(bySigns, k) / samples;
    }
    return out;
}

} // namespace suffuse::fitting
