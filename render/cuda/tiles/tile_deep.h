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

/// Holds sums over a fill's nodes, by u and v: value, u, v, uu/2, uv, vv/2, uuu/6, uuv/2, uvv/2, vvv/6.
struct DeepTerms {
    double v[deepTerms];
};

/// Adds an entry of a deep fill's square (FillValues) at a centre. With C(u) = ½erfc(−u) and E(v) = e^(−v²) times the
/// weight a node is the function C(u)E(v), and an event is C(v).
SUFFUSE_PROGRAM void addDeepEntry(const FillValues &fill, const DeepRecord &n, double centreX, double centreY,
                                  double (&d)[deepTerms])
{
    constexpr double inverseRootPi = 0.56418958354775628695;
    const double dx = centreX - n.x, dy = centreY - n.y, v = fill.c * dy;
    if (n.row == 1) {
        const double e = inverseRootPi * n.weight * exp(-v * v);
        d[0] += 0.5 * n.weight * erfc(-v);
        d[2] += e;
        d[5] += -v * e;
        d[9] += (2 * v * v - 1) / 3 * e;
        return;
    }
    const double u = fill.a * dx + fill.b * dy;
    const double C = 0.5 * erfc(-u), E = n.weight * exp(-v * v), g = inverseRootPi * exp(-u * u);
    const double E1 = -2 * v * E, E2 = (2 * v * v - 1) * E, E3 = (2 * v - 4.0 / 3 * v * v * v) * E;
    d[0] += C * E;
    d[1] += g * E;
    d[2] += C * E1;
    d[3] += -u * g * E;
    d[4] += g * E1;
    d[5] += C * E2;
    d[6] += (2 * u * u - 1) / 3 * g * E;
    d[7] += -u * g * E1;
    d[8] += g * E2;
    d[9] += C * E3;
}

/// Makes sums by u = a·x + b·y and v = c·y a polynomial in x and y.
SUFFUSE_PROGRAM void fromDeepTerms(const FillValues &fill, const double (&d)[deepTerms], double (&out)[deepTerms])
{
    const double a = fill.a, b = fill.b, c = fill.c;
    out[0] = d[0];
    out[1] = a * d[1];
    out[2] = b * d[1] + c * d[2];
    out[3] = a * a * d[3];
    out[4] = 2 * a * b * d[3] + a * c * d[4];
    out[5] = b * b * d[3] + b * c * d[4] + c * c * d[5];
    out[6] = a * a * a * d[6];
    out[7] = 3 * a * a * b * d[6] + a * a * c * d[7];
    out[8] = 3 * a * b * b * d[6] + 2 * a * b * c * d[7] + a * c * c * d[8];
    out[9] = b * b * b * d[6] + b * b * c * d[7] + b * c * c * d[8] + c * c * c * d[9];
}

/// Finds the place between the colours of a gradient times the density, whose polynomial is given.
SUFFUSE_PROGRAM void placeDeep(const FillValues &fill, double centreX, double centreY, const double (&p)[deepTerms],
                               double (&out)[deepTerms])
{
    const double t = fill.place + fill.placeX * centreX + fill.placeY * centreY, tx = fill.placeX, ty = fill.placeY;
    const double kx = tx * fill.half[0] + ty * fill.half[1], ky = tx * fill.half[1] + ty * fill.half[2];
    const double dx[deepTerms] = {p[1], 2 * p[3], p[4], 3 * p[6], 2 * p[7], p[8], 0, 0, 0, 0};
    const double dy[deepTerms] = {p[2], p[4], 2 * p[5], p[7], 2 * p[8], 3 * p[9], 0, 0, 0, 0};
    const double byX[deepTerms] = {0, p[0], 0, p[1], p[2], 0, p[3], p[4], p[5], 0};
    const double byY[deepTerms] = {0, 0, p[0], 0, p[1], p[2], 0, p[3], p[4], p[5]};
    for (int i = 0; i < deepTerms; ++i)
        out[i] = t * p[i] + tx * byX[i] + ty * byY[i] + kx * dx[i] + ky * dy[i];
    const bool none = !(p[0] > 0) || out[0] <= 0, all = out[0] >= p[0];
    for (int i = 0; i < deepTerms; ++i)
        out[i] = none ? 0 : all ? p[i] : out[i];
}

/// Adds a deep fill to the polynomials that sumDeep has found.
template <class Warp>
SUFFUSE_CALL void addDeepFill(Warp warp, const Frame &frame, const StrokeRecord &stroke, double centreX, double centreY,
                              double (*out)[deepTerms])
{
    constexpr double side = 4096; // as SceneFill::deepSide
    const FillValues &fill = frame.fills[stroke.fillValues];
    const int column = int(floor(centreX / side)) - fill.deepColumn, row = int(floor(centreY / side)) - fill.deepRow;
    if (column < 0 || column >= fill.deepColumns || row < 0 || row >= fill.deepRows)
        return;
    const DeepRecord *heads = frame.deep + stroke.firstDeep + stroke.deep;
    const DeepRecord head = heads[row * fill.deepColumns + column];
    const DeepRecord *entries = heads + int(head.x);
    const int count = int(head.y);
    typename Warp::template Var<DeepTerms> terms;
    warp.each([&](int lane) {
        for (double &t : terms[lane].v)
            t = 0;
        for (int i = lane; i < count; i += warpLanes)
            addDeepEntry(fill, entries[i], centreX, centreY, terms[lane].v);
    });
    double sums[deepTerms], own[deepTerms], placed[deepTerms] = {};
    for (int t = 0; t < deepTerms; ++t) {
        typename Warp::template Var<double> term;
        warp.each([&](int lane) { term[lane] = terms[lane].v[t]; });
        sums[t] = warp.sum(term);
    }
    sums[0] += head.weight;
    fromDeepTerms(fill, sums, own);
    own[0] = own[0] < 0 ? 0 : own[0] > 1 ? 1 : own[0];
    for (double &t : own)
        t *= fill.density;
    if (stroke.fill & gradientFill)
        placeDeep(fill, centreX, centreY, own, placed);
    warp.each([&](int lane) {
        if (lane >= deepTerms)
            return;
        out[0][lane] += own[lane];
        for (int c = 0; c < int(stroke.channels); ++c)
            out[1 + c][lane] += own[lane] * double(fill.from[c]) + placed[lane] * double(fill.step[c]);
    });
}

/// Finds the polynomials of φ and of φ times each channel about (centreX, centreY), in pixels of the picture.
template <class Warp>
SUFFUSE_PROGRAM void sumDeep(Warp &warp, const Frame &frame, const StrokeRecord &stroke, double centreX, double centreY,
                             double (*out)[deepTerms])
{
    for (int channel = -1; channel < int(stroke.channels); ++channel) {
        typename Warp::template Var<DeepTerms> terms;
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
