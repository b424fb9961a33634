#include "render/reference/panels.h"

#include "render/reference/quadrature.h"

#include <cmath>

namespace suffuse::reference {

namespace {

constexpr double tolerance = 1e-13 * 1.7724538509055160273;
constexpr int deepest = 60;

/// The piece's own integral as seen from a probe, in units of the spread.
struct Probe {
    double density = 0;
    Point moment;
};

Probe integrateWith(const GaussRule &rule, const Cubic &plain, const Cubic &white, Point probe)
{
    Probe sum;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const Point q = probe - white.at(rule.nodes[i]);
        const double f = rule.weights[i] * length(plain.derivative(rule.nodes[i])) * std::exp(-dot(q, q));
        sum.density += f;
        sum.moment = sum.moment + f * q;
    }
    return sum;
}

/// Whether 10 points are enough for the piece, as seen from its middle and ends, and from half a spread and a spread
/// beside them.
bool isExact(const Cubic &plain, const Cubic &white, double spread)
{
    const Point probes[] = {white.at(0.5),
                            white.p[0],
                            white.p[3],
                            white.at(0.5) + Point{0.5, 0.3},
                            white.at(0.5) + Point{-0.3, 0.5},
                            white.p[0] + Point{0.7, -0.7},
                            white.p[3] + Point{-0.7, -0.7}};
    for (Point probe : probes) {
        const Probe few = integrateWith(gauss10(), plain, white, probe);
        const Probe many = integrateWith(gauss20(), plain, white, probe);
        if (std::abs(few.density - many.density) + length(few.moment - many.moment) > tolerance * spread)
            return false;
    }
    return true;
}

void refine(const Cubic &piece, const Kernel &kernel, const PanelFilter &skip, int depth, std::vector<Panel> &panels)
{
    const Rect box = piece.controlBox();
    if (skip && skip(box))
        return;
    // Relative to its start no digits are lost far from the origin.
    const Point start = piece.p[0];
    const Cubic plain{{Point{}, piece.p[1] - start, piece.p[2] - start, piece.p[3] - start}};
    const Cubic white = kernel.whiten(plain);
    const double size = polygonLength(white);
    if (size == 0)
        return;
    if (depth >= deepest || (size <= 1 && isExact(plain, white, kernel.smallerSpread))) {
        panels.push_back({piece, box});
        return;
    }
    const auto halves = piece.split(0.5);
    refine(halves[0], kernel, skip, depth + 1, panels);
    refine(halves[1], kernel, skip, depth + 1, panels);
}

} // namespace

void appendPanels(const Cubic &cubic, const Kernel &kernel, const PanelFilter &skip, std::vector<Panel> &panels)
{
    if (skip && skip(cubic.controlBox()))
        return;
    for (const Cubic &piece : piecesBetweenSpeedExtrema(cubic))
        refine(piece, kernel, skip, 0, panels);
}

std::array<Node, 10> nodesOf(const Panel &panel)
{
    std::array<Node, 10> nodes;
    const GaussRule &rule = gauss10();
    for (std::size_t i = 0; i < nodes.size(); ++i)
        nodes[i] = {panel.piece.at(rule.nodes[i]), rule.weights[i] * length(panel.piece.derivative(rule.nodes[i]))};
    return nodes;
}

DensityAndGradient panelDensity(const std::vector<Panel> &panels, const Kernel &kernel, double density, Point x)
{
    double sum = 0;
    Point moment;
    for (const Panel &panel : panels) {
        for (const Node &node : nodesOf(panel)) {
            const Point q = kernel.whiten(x - node.at);
            const double f = node.weight * std::exp(-dot(q, q));
            sum += f;
            moment = moment + f * q;
        }
    }
    const double factor = density * kernel.norm;
    return {factor * sum,
            -2 * factor *
                Point{kernel.a11 * moment.x + kernel.a21 * moment.y, kernel.a12 * moment.x + kernel.a22 * moment.y}};
}

} // namespace suffuse::reference
