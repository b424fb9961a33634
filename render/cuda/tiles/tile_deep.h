// Some strokes are so wide on screen that a float sum would lose their edge. Here one warp finds a cubic Taylor
// polynomial of their sums for a block of samples, in double (docs/solver.md, "Deep zoom").
#pragma once

#include "render/cuda/tiles/records.h"
#include "render/cuda/warp.h"

#include <cmath>

namespace suffuse::cuda {

/// A polynomial is c0 + c1 x + c2 y + c3 x² + c4 xy + c5 y² + c6 x³ + c7 x²y + c8 xy² + c9 y³.
inline constexpr int deepTerms = 10;

/// Holds φ and −½ of its slopes, per pixel.
struct DeepSample {
    double density = 0, slopeX = 0, slopeY = 0;
};

SUFFUSE_PROGRAM double deepValue(const double *c, double x, double y)
{
    return c[0] + x * (c[1] + x * (c[3] + x * c[6])) +
           y * (c[2] + x * (c[4] + x * c[7]) + y * (c[5] + x * c[8] + y * c[9]));
}

SUFFUSE_PROGRAM DeepSample deepSample(const double *c, double x, double y)
{
    const double dx = c[1] + y * (c[4] + y * c[8]) + x * (2 * (c[3] + y * c[7]) + 3 * x * c[6]);
    const double dy = c[2] + x * (c[4] + x * c[7]) + y * (2 * (c[5] + x * c[8]) + 3 * y * c[9]);
    return {deepValue(c, x, y), -0.5 * dx, -0.5 * dy};
}

/// Adds value · weight · e^(−q) of a node as a polynomial about a centre. With δ from the centre, g = −∇q there and the
/// node's metric M this is e^(g·δ − δᵀMδ), taken to third order.
SUFFUSE_PROGRAM void addDeepNode(const DeepRecord &n, double value, double centreX, double centreY,
                                 double (&out)[deepTerms])
{
    const double dx = centreX - n.x, dy = centreY - n.y;
    const double qx = n.a * dx + n.b * dy, qy = n.b * dx + n.c * dy;
    const double e = n.weight * value * exp(-(dx * qx + dy * qy));
    const double g = -2 * qx, h = -2 * qy, xx = -n.a, xy = -2 * n.b, yy = -n.c;
    out[0] += e;
    out[1] += e * g;
    out[2] += e * h;
    out[3] += e * (0.5 * g * g + xx);
    out[4] += e * (g * h + xy);
    out[5] += e * (0.5 * h * h + yy);
    out[6] += e * (g * g * g / 6 + g * xx);
    out[7] += e * (0.5 * g * g * h + g * xy + h * xx);
    out[8] += e * (0.5 * g * h * h + h * xy + g * yy);
    out[9] += e * (h * h * h / 6 + h * yy);
}

/// Finds the polynomials of φ and of φ times each channel about (centreX, centreY), in pixels of the picture.
template <class Warp>
SUFFUSE_PROGRAM void sumDeep(Warp &warp, const Frame &frame, const StrokeRecord &stroke, double centreX, double centreY,
                             double (*out)[deepTerms])
{
    struct Terms {
        double v[deepTerms];
    };
    for (int channel = -1; channel < int(stroke.channels); ++channel) {
        typename Warp::template Var<Terms> terms;
        warp.each([&](int lane) {
            for (double &t : terms[lane].v)
                t = 0;
            for (std::uint32_t i = std::uint32_t(lane); i < stroke.deep; i += warpLanes) {
                const DeepRecord &node = frame.deep[stroke.firstDeep + i];
                const double value =
                    channel < 0 ? 1.0
                                : double(frame.values[stroke.firstValue + std::size_t(node.row) * stroke.channels +
                                                      std::size_t(channel)]);
                addDeepNode(node, value, centreX, centreY, terms[lane].v);
            }
        });
        for (int t = 0; t < deepTerms; ++t) {
            typename Warp::template Var<double> term;
            warp.each([&](int lane) { term[lane] = terms[lane].v[t]; });
            const double sum = warp.sum(term);
            warp.each([&](int lane) {
                if (lane == 0)
                    out[1 + channel][t] = sum;
            });
        }
    }
}

} // namespace suffuse::cuda
