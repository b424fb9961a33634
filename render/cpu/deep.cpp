#include "render/cpu/deep.h"

#include "render/math/scalar.h"
// It has templates over the numbers, which must be declared before.
#include "render/math/shade.h"

#include <cstring>

namespace suffuse::cpu {

namespace {

/// The polynomial c0 + c1 x + c2 y + c3 x² + c4 xy + c5 y² + c6 x³ + c7 x²y + c8 xy² + c9 y³.
using Cubic2 = std::array<double, 10>;

/// Adds value · e^(−q(x − node)) as a polynomial about the cell's centre. With g = −∇q and −½H = M it is e^(g·δ − δᵀMδ)
/// to third order.
void addGaussian(const DeepNode &n, Point centre, Cubic2 &out)
{
    const double dx = centre.x - n.x, dy = centre.y - n.y;
    const double qx = n.a * dx + n.b * dy, qy = n.b * dx + n.c * dy;
    const double e = n.weight * std::exp(-(dx * qx + dy * qy));
    const double g = -2 * qx, h = -2 * qy;            // linear part
    const double xx = -n.a, xy = -2 * n.b, yy = -n.c; // quadratic part of the exponent
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

/// The polynomial in one row: c0 + c1 x + c2 x² + c3 x³.
struct Row {
    double c0, c1, c2, c3;

    double at(double x) const { return c0 + x * (c1 + x * (c2 + x * c3)); }
};

Row valueRow(const Cubic2 &c, double y)
{
    return {c[0] + y * (c[2] + y * (c[5] + y * c[9])), c[1] + y * (c[4] + y * c[8]), c[3] + y * c[7], c[6]};
}

/// −½ of the derivative along x, as in Sums.
Row slopeXRow(const Cubic2 &c, double y)
{
    return {-0.5 * (c[1] + y * (c[4] + y * c[8])), -(c[3] + y * c[7]), -1.5 * c[6], 0};
}

Row slopeYRow(const Cubic2 &c, double y)
{
    return {-0.5 * (c[2] + y * (2 * c[5] + 3 * y * c[9])), -(0.5 * c[4] + y * c[8]), -0.5 * c[7], 0};
}

/// The side of the cells in pixels. It doubles when the width of the narrowest deep node doubles, so that a cell always
/// covers the same small part of it (the fourth-order term stays below 1e-12 of the peak).
double cellSideFor(const SceneStroke &stroke)
{
    double steepest = 0;
    for (const DeepNode &n : stroke.deep)
        steepest = std::max(steepest, 0.5 * (n.a + n.c) + std::hypot(0.5 * (n.a - n.c), n.b));
    double spread = 1 / std::sqrt(steepest);
    if (stroke.fill && stroke.fill->deep) {
        const SceneFill &f = *stroke.fill;
        const double own = 1 / std::sqrt(f.a * f.a + f.b * f.b + f.c * f.c);
        spread = stroke.deep.empty() ? own : std::min(spread, own);
    }
    return std::exp2(std::clamp(std::floor(std::log2(spread / deepSpread)), 0.0, 3.0)) * cellSide;
}

/// Adds the fill of density 1 as a polynomial about the cell's centre. Beyond the value all terms are made of the
/// Gaussian's derivatives: with C(u) = ½erfc(−u) and E(v) = e^(−v²) the function is C(u)E(v), summed over the nodes.
void addFill(const SceneFill &fill, Point centre, Cubic2 &out)
{
    constexpr double inverseRootPi = 0.56418958354775628695;
    const auto squareOf = [](double x) { return int(std::floor(x / SceneFill::deepSide)); };
    const int column = squareOf(centre.x) - fill.deepColumn, row = squareOf(centre.y) - fill.deepRow;
    if (column < 0 || column >= fill.deepColumns || row < 0 ||
        std::size_t(row) * std::size_t(fill.deepColumns) >= fill.deepSquares.size())
        return;
    const DeepFillSquare &square = fill.deepSquares[std::size_t(row) * std::size_t(fill.deepColumns) + std::size_t(column)];
    std::array<double, 10> d{}; // by u and v: value, u, v, uu/2, uv, vv/2, uuu/6, uuv/2, uvv/2, vvv/6
    d[0] = square.entered;
    for (const FillEvent &event : square.events) {
        const double v = fill.c * (centre.y - event.y), e = inverseRootPi * event.jump * std::exp(-v * v);
        d[0] += 0.5 * event.jump * std::erfc(-v);
        d[2] += e;
        d[5] += -v * e;
        d[9] += (2 * v * v - 1) / 3 * e;
    }
    for (const FillNode &node : square.nodes) {
        const double dx = centre.x - node.x, dy = centre.y - node.y;
        const double u = fill.a * dx + fill.b * dy, v = fill.c * dy;
        const double C = 0.5 * std::erfc(-u), E = node.weight * std::exp(-v * v), g = inverseRootPi * std::exp(-u * u);
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
    // u = a x + b y, v = c y.
    const double a = fill.a, b = fill.b, c = fill.c;
    out[0] += d[0];
    out[1] += a * d[1];
    out[2] += b * d[1] + c * d[2];
    out[3] += a * a * d[3];
    out[4] += 2 * a * b * d[3] + a * c * d[4];
    out[5] += b * b * d[3] + b * c * d[4] + c * c * d[5];
    out[6] += a * a * a * d[6];
    out[7] += 3 * a * a * b * d[6] + a * a * c * d[7];
    out[8] += 3 * a * b * b * d[6] + 2 * a * b * c * d[7] + a * c * c * d[8];
    out[9] += b * b * b * d[6] + b * b * c * d[7] + b * c * c * d[8] + c * c * c * d[9];
}

/// The place between the colours of a gradient times the density, as a polynomial: place is linear in x and y, and the
/// pull of the slope is linear in the derivatives.
Cubic2 placedPolynomial(const SceneFill &fill, Point centre, const Cubic2 &p)
{
    const double t = fill.placeAt(centre.x, centre.y), tx = fill.placeSlope.x, ty = fill.placeSlope.y;
    const auto &h = fill.half;
    const double kx = tx * h[0] + ty * h[1], ky = tx * h[1] + ty * h[2];
    Cubic2 out{};
    const Cubic2 dx{p[1], 2 * p[3], p[4], 3 * p[6], 2 * p[7], p[8], 0, 0, 0, 0};
    const Cubic2 dy{p[2], p[4], 2 * p[5], p[7], 2 * p[8], 3 * p[9], 0, 0, 0, 0};
    const Cubic2 byX{0, p[0], 0, p[1], p[2], 0, p[3], p[4], p[5], 0};
    const Cubic2 byY{0, 0, p[0], 0, p[1], p[2], 0, p[3], p[4], p[5]};
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = t * p[i] + tx * byX[i] + ty * byY[i] + kx * dx[i] + ky * dy[i];
    return out;
}

/// The part of a block that lies in one cell.
struct Piece {
    int x0, y0, x1, y1; // samples of the block
    double left, top;   // the first sample, relative to the centre of the cell
};

/// The polynomials of one cell: the density, then the density times each channel.
class Cell {
public:
    Cell(const SceneStroke &stroke, Point centre) : m_stroke(stroke)
    {
        for (int c = 0; c <= stroke.channels; ++c)
            m_polynomial[std::size_t(c)].fill(0);
        for (const DeepNode &node : stroke.deep) {
            Cubic2 gaussian{};
            addGaussian(node, centre, gaussian);
            const float *value = stroke.values.data() + std::size_t(node.row) * std::size_t(stroke.channels);
            for (std::size_t i = 0; i < gaussian.size(); ++i)
                m_polynomial[0][i] += gaussian[i];
            for (int c = 0; c < stroke.channels; ++c)
                for (std::size_t i = 0; i < gaussian.size(); ++i)
                    m_polynomial[std::size_t(1 + c)][i] += gaussian[i] * double(value[c]);
        }
        if (stroke.fill && stroke.fill->deep)
            addFillOf(*stroke.fill, centre);
    }

    void addTo(Sums &sums, const Piece &p, double step) const
    {
        for (int j = p.y0; j < p.y1; ++j) {
            const double y = p.top + (j - p.y0) * step;
            const auto add = [&](float *out, const Row &row) {
                for (int i = p.x0; i < p.x1; ++i)
                    out[j * blockSide + i] = float(double(out[j * blockSide + i]) + row.at(p.left + (i - p.x0) * step));
            };
            add(sums.v[0], valueRow(m_polynomial[0], y));
            add(sums.v[1], slopeXRow(m_polynomial[0], y));
            add(sums.v[2], slopeYRow(m_polynomial[0], y));
            for (int c = 0; c < m_stroke.channels; ++c)
                add(sums.v[fixedSums + c], valueRow(m_polynomial[std::size_t(1 + c)], y));
        }
    }

    /// Computes in double from the sum to the opacity. `other` has what nodes that are not deep add.
    void shadeSharply(const Sums &other, const Piece &p, double step, const float *eta, Shaded &out) const
    {
        double channels[maxChannels];
        const auto channel = [&](int c) { return channels[c]; };
        for (int j = p.y0; j < p.y1; ++j)
            for (int i = p.x0; i < p.x1; ++i) {
                const int at = j * blockSide + i;
                const double x = p.left + (i - p.x0) * step, y = p.top + (j - p.y0) * step;
                for (int c = 0; c < m_stroke.channels; ++c)
                    channels[c] =
                        double(other.v[fixedSums + c][at]) + valueRow(m_polynomial[std::size_t(1 + c)], y).at(x);
                const double density = double(other.v[0][at]) + valueRow(m_polynomial[0], y).at(x);
                const auto m = math::modulate(m_stroke.shade, density,
                                              double(other.v[1][at]) + slopeXRow(m_polynomial[0], y).at(x),
                                              double(other.v[2][at]) + slopeYRow(m_polynomial[0], y).at(x), channel,
                                              eta ? double(eta[at]) : 1.0, step);
                const double f = math::mixedStyles<double>(m_stroke.shade, channel, m);
                const auto paint = math::paintOf(m_stroke.shade, m.inverse, channel, f);
                out.w[at] = float(paint.w);
                out.colour[0][at] = float(paint.red);
                out.colour[1][at] = float(paint.yellow);
                out.colour[2][at] = float(paint.blue);
            }
    }

private:
    void addFillOf(const SceneFill &fill, Point centre)
    {
        Cubic2 own{};
        addFill(fill, centre, own);
        own[0] = std::clamp(own[0], 0.0, 1.0);
        for (double &coefficient : own)
            coefficient *= fill.density;
        Cubic2 placed{};
        if (fill.hasGradient) {
            placed = placedPolynomial(fill, centre, own);
            if (!(own[0] > 0) || placed[0] <= 0)
                placed = {};
            else if (placed[0] >= own[0])
                placed = own;
        }
        for (std::size_t i = 0; i < own.size(); ++i) {
            m_polynomial[0][i] += own[i];
            for (int c = 0; c < m_stroke.channels; ++c)
                m_polynomial[std::size_t(1 + c)][i] += own[i] * double(fill.from[std::size_t(c)]) +
                                                       placed[i] * double(fill.step[std::size_t(c)]);
        }
    }

    const SceneStroke &m_stroke;
    std::array<Cubic2, 1 + maxChannels> m_polynomial;
};

/// Whether the precision of floats could be seen in the style at densities of [low, high]: where it jumps or is steeper
/// than 1000/φ.
bool isSharp(const ShadeParams &shade, double low, double high)
{
    for (int k = 0; k < shade.kinds; ++k) {
        const KindParams &kind = shade.kind[k];
        const double xi1 = double(kind.xi[0]), xi2 = double(kind.xi[1]);
        if (kind.xiChannel >= 0)
            return true;
        if (kind.kind == StyleKind::Edge) {
            const double edge = math::Edge<double>(xi1, xi2, double(kind.xi[2])).phiE;
            if (low < 1.001 * edge && high > 0.999 * edge)
                return true;
        }
        if (kind.kind == StyleKind::Uniform && xi2 < 1e-3 * xi1 && low < xi1 + 20 * xi2 && high > xi1 - 20 * xi2)
            return true;
    }
    return false;
}

/// Cuts a block at the borders of the cells of the picture's grid.
template <class Use>
void forEachPiece(const Block &block, double side, Use use)
{
    const auto cellOf = [&](double at) { return std::floor(at / side); };
    const auto border = [&](double origin, int from) { // the first sample of the next cell
        const double next = (cellOf(origin + (from + 0.5) * block.step) + 1) * side;
        return std::min(blockSide, int(std::ceil((next - origin) / block.step - 0.5)));
    };
    for (int y0 = 0, y1 = 0; y0 < blockSide; y0 = y1) {
        y1 = border(block.y, y0);
        for (int x0 = 0, x1 = 0; x0 < blockSide; x0 = x1) {
            x1 = border(block.x, x0);
            const double x = block.x + (x0 + 0.5) * block.step, y = block.y + (y0 + 0.5) * block.step;
            const Point centre{(cellOf(x) + 0.5) * side, (cellOf(y) + 0.5) * side};
            use(Piece{x0, y0, x1, y1, x - centre.x, y - centre.y}, centre);
        }
    }
}

} // namespace

void shadeDeep(const Kernels &kernels, const SceneStroke &stroke, const Block &block, Sums &sums, const float *eta,
               Shaded &out)
{
    const double side = cellSideFor(stroke);
    thread_local const auto other = std::make_unique<Sums>();
    std::memcpy(other->v, sums.v, sizeof(sums.v[0]) * std::size_t(fixedSums + stroke.channels));
    std::vector<std::pair<Cell, Piece>> sharp;
    forEachPiece(block, side, [&](const Piece &piece, Point centre) {
        const Cell cell(stroke, centre);
        cell.addTo(sums, piece, block.step);
        float low = 1e38f, high = 0;
        for (int j = piece.y0; j < piece.y1; ++j)
            for (int i = piece.x0; i < piece.x1; ++i) {
                low = std::min(low, sums.v[0][j * blockSide + i]);
                high = std::max(high, sums.v[0][j * blockSide + i]);
            }
        if (stroke.granulated && eta)
            low = 0; // The paper takes some of it away.
        if (isSharp(stroke.shade, double(low), double(high)))
            sharp.emplace_back(cell, piece);
    });
    kernels.shade(stroke.shade, sums, eta, float(block.step), out);
    for (const auto &[cell, piece] : sharp)
        cell.shadeSharply(*other, piece, block.step, eta, out);
}

} // namespace suffuse::cpu
