#include "render/cpu/deep.h"

#include "render/math/scalar.h"
// After the numbers: templates over them.
#include "render/math/shade.h"

namespace suffuse::cpu {

namespace {

/// c0 + c1 x + c2 y + c3 x² + c4 xy + c5 y² + c6 x³ + c7 x²y + c8 xy² + c9 y³
using Cubic2 = std::array<double, 10>;

/// Adds value · e^(−q(x − node)) about the cell's centre: with g = −∇q and −½H = M, e^(g·δ − δᵀMδ) to third order.
void addGaussian(const DeepNode &n, Point centre, Cubic2 &out)
{
    const double dx = centre.x - n.x, dy = centre.y - n.y;
    const double qx = n.a * dx + n.b * dy, qy = n.b * dx + n.c * dy;
    const double e = n.weight * std::exp(-(dx * qx + dy * qy));
    const double g = -2 * qx, h = -2 * qy;             // linear part
    const double xx = -n.a, xy = -2 * n.b, yy = -n.c;  // quadratic part of the exponent
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

double valueAt(const Cubic2 &c, double x, double y)
{
    return c[0] + x * (c[1] + x * (c[3] + x * c[6]) + y * (c[4] + x * c[7])) + y * (c[2] + y * (c[5] + x * c[8] + y * c[9]));
}

Point slopeAt(const Cubic2 &c, double x, double y)
{
    return {c[1] + x * (2 * c[3] + 3 * x * c[6]) + y * (c[4] + 2 * x * c[7] + y * c[8]),
            c[2] + y * (2 * c[5] + 3 * y * c[9]) + x * (c[4] + x * c[7] + 2 * y * c[8])};
}

} // namespace

void shadeDeep(const SceneStroke &stroke, const Block &block, const Sums &sums, const float *eta, Shaded &out)
{
    std::array<Cubic2, 1 + maxChannels> polynomial;
    double channels[maxChannels];
    const auto channel = [&](int c) { return channels[c]; };
    for (int cellY = 0; cellY < blockSide; cellY += cellSide)
        for (int cellX = 0; cellX < blockSide; cellX += cellSide) {
            const Point centre{block.x + block.step * (cellX + cellSide / 2), block.y + block.step * (cellY + cellSide / 2)};
            for (int c = 0; c <= stroke.channels; ++c)
                polynomial[c].fill(0);
            for (const DeepNode &node : stroke.deep) {
                Cubic2 gaussian{};
                addGaussian(node, centre, gaussian);
                const float *value = stroke.values.data() + std::size_t(node.row) * stroke.channels;
                for (int i = 0; i < 10; ++i) {
                    polynomial[0][i] += gaussian[i];
                    for (int c = 0; c < stroke.channels; ++c)
                        polynomial[1 + c][i] += gaussian[i] * value[c];
                }
            }
            for (int j = 0; j < cellSide; ++j)
                for (int i = 0; i < cellSide; ++i) {
                    const int at = (cellY + j) * blockSide + cellX + i;
                    const double x = (i + 0.5 - cellSide / 2) * block.step, y = (j + 0.5 - cellSide / 2) * block.step;
                    const Point slope = slopeAt(polynomial[0], x, y);
                    for (int c = 0; c < stroke.channels; ++c)
                        channels[c] = double(sums.v[fixedSums + c][at]) + valueAt(polynomial[1 + c], x, y);
                    const auto paint = math::shadeSample<double>(
                        stroke.shade, double(sums.v[0][at]) + valueAt(polynomial[0], x, y),
                        double(sums.v[1][at]) + slope.x, double(sums.v[2][at]) + slope.y,
                        channel, eta ? double(eta[at]) : 1.0, 0.5 * block.step,
                        [&](double inverse, double phi, double h) {
                            return math::mixedStyles<double>(stroke.shade, channel, inverse, phi, h);
                        });
                    out.w[at] = float(paint.w);
                    out.colour[0][at] = float(paint.red);
                    out.colour[1][at] = float(paint.yellow);
                    out.colour[2][at] = float(paint.blue);
                }
        }
}

} // namespace suffuse::cpu
