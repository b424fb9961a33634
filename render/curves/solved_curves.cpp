#include "render/curves/solved_curves.h"

#include "render/curves/curve_links.h"
#include "render/curves/laplace_solver.h"
#include "render/curves/varying_blur.h"
#include "render/threads/parallel.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace suffuse::curves {

namespace {

constexpr double mostSolved = 4e6; ///< pixels: so many are solved in seconds

/// One value of all pixels that diffuses; `unit` is what counts as 1.
std::vector<float> diffused(const LaplaceSolver &solver, const CurveLinks &links, std::size_t value, double unit,
                            const std::atomic<bool> *cancel)
{
    std::vector<float> sources = links.sources[value];
    for (float &v : sources)
        v /= float(unit);
    std::vector<float> out(links.pixels(), float(links.mean[value] / unit));
    solver.solve(sources, out, cancel);
    for (float &v : out)
        v *= float(unit);
    return out;
}

double widestBlur(const CurveLinks &links)
{
    double widest = 0;
    for (std::size_t p = 0; p < links.pixels(); ++p)
        if (links.anchors[p] > 0)
            widest = std::max(widest, double(links.sources[3][p] / links.anchors[p]));
    return widest;
}

SolvedCurves halved(const SolvedCurves &from)
{
    SolvedCurves out{from.width / 2, from.height / 2, {}};
    out.rgb.resize(3 * std::size_t(out.width) * std::size_t(out.height));
    const auto at = [&from](int x, int y) {
        return from.rgb.data() + 3 * (std::size_t(y) * std::size_t(from.width) + std::size_t(x));
    };
    float *to = out.rgb.data();
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            for (int c = 0; c < 3; ++c)
                *to++ = 0.25f * (at(2 * x, 2 * y)[c] + at(2 * x + 1, 2 * y)[c] + at(2 * x, 2 * y + 1)[c] +
                                 at(2 * x + 1, 2 * y + 1)[c]);
    return out;
}

} // namespace

QString problemOf(const CurveSet &set)
{
    if (!(set.width >= 1) || !(set.height >= 1))
        return QCoreApplication::translate("curves", "its picture has %1 × %2 pixels; image_width and image_height "
                                                     "must be 1 at least")
            .arg(set.width)
            .arg(set.height);
    if (set.curves.empty())
        return QCoreApplication::translate("curves", "holds no curves; there is nothing to solve");
    return {};
}

SolvedCurves solvedCurves(const CurveSet &set, int width, int height, int threads, const std::atomic<bool> *cancel)
{
    const bool isFine = 4.0 * width * height <= mostSolved;
    SolvedCurves out{width * (isFine ? 2 : 1), height * (isFine ? 2 : 1), {}};
    const CurveLinks links = linksOf(set, out.width, out.height, cancel);
    std::vector<float> values[curveValues];
    if (links.isCut) {
        const LaplaceSolver solver(out.width, out.height, links.right, links.down, links.anchors);
        const double blur = widestBlur(links);
        parallelFor(curveValues, Threads(threads), [&](std::size_t v) {
            if (v < 3 || blur > 0)
                values[v] = diffused(solver, links, v, v < 3 ? 1 : blur, cancel);
        });
    } else {
        for (std::size_t v = 0; v < 3; ++v)
            values[v].assign(links.pixels(), float(links.mean[v]));
    }
    out.rgb.resize(3 * links.pixels());
    for (std::size_t p = 0; p < links.pixels(); ++p)
        for (std::size_t c = 0; c < 3; ++c)
            out.rgb[3 * p + c] = std::clamp(values[c][p], 0.0f, 1.0f);
    if (!values[3].empty())
        out.rgb = blurredBy(out.rgb, values[3], out.width, out.height, threads, cancel);
    if (cancel && *cancel)
        return {};
    return isFine ? halved(out) : out;
}

} // namespace suffuse::curves
