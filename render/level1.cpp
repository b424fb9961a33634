#include "render/level1.h"

#include <Eigen/Dense>

#include <bit>
#include <cmath>

namespace suffuse {

namespace {

constexpr int ruleNodes = 5;
constexpr int maxWindow = 64; // Level 0 nodes; more are halved first

// On the stack: windows are small, and there are thousands.
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, maxWindow, 1>;
using Basis = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, maxWindow, ruleNodes>;

/// Arc length between a run's nodes, from the first.
std::vector<double> arcLengths(const std::vector<SpanNode> &nodes)
{
    std::vector<double> arc(nodes.size(), 0.0);
    for (std::size_t i = 1; i < nodes.size(); ++i)
        arc[i] = arc[i - 1] + std::hypot(nodes[i].x - nodes[i - 1].x, nodes[i].y - nodes[i - 1].y);
    return arc;
}

/// n nodes whose weighted sums of polynomials of the arc length up to degree 2n − 1 equal those of nodes [first, last).
void gaussRule(const SpanNode *nodes, const double *arc, int count, int n, bool valuesVary, std::vector<SpanNode> &out)
{
    const double middle = 0.5 * (arc[0] + arc[count - 1]), half = std::max(1e-9, 0.5 * (arc[count - 1] - arc[0]));
    Vector weight(count), at(count);
    for (int i = 0; i < count; ++i)
        weight[i] = nodes[i].weight, at[i] = (arc[i] - middle) / half;
    const double mass = weight.sum();
    // Lanczos: orthonormal polynomials on the nodes, with full reorthogonalisation.
    Basis basis(count, n);
    Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(n, n);
    Vector p = Vector::Constant(count, 1 / std::sqrt(mass)), before = Vector::Zero(count);
    double beta = 0;
    for (int k = 0; k < n; ++k) {
        basis.col(k) = p;
        jacobi(k, k) = (weight.array() * p.array().square() * at.array()).sum();
        if (k + 1 == n)
            break;
        Vector q = (at.array() - jacobi(k, k)) * p.array() - beta * before.array();
        for (int j = 0; j <= k; ++j)
            q -= basis.col(j) * (weight.array() * q.array() * basis.col(j).array()).sum();
        beta = std::sqrt((weight.array() * q.array().square()).sum());
        jacobi(k, k + 1) = jacobi(k + 1, k) = beta;
        before = p;
        p = q / beta;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(jacobi);
    const auto &vectors = solver.eigenvectors();
    for (int j = 0; j < n; ++j) {
        const double e0 = vectors(0, j);
        // Polynomial that is 1 at this node and 0 at the others, as weights on the fine nodes.
        const Vector share = (weight.array() * (basis * vectors.col(j)).array()) / (e0 * std::sqrt(mass));
        SpanNode node;
        node.weight = mass * e0 * e0;
        for (int i = 0; i < count; ++i) {
            node.x += share[i] * nodes[i].x;
            node.y += share[i] * nodes[i].y;
            if (valuesVary)
                for (std::size_t v = 0; v < node.values.size(); ++v)
                    node.values[v] += share[i] * nodes[i].values[v];
        }
        if (!valuesVary)
            node.values = nodes[0].values;
        for (double &v : node.values)
            v = std::min(1.0, std::max(0.0, v));
        node.tolerance = nodes[0].tolerance;
        out.push_back(node);
    }
}

/// 2^x for x in [−60, 0] to 2e-7, in a form that compilers vectorise.
inline float exp2Fast(float x)
{
    const int whole = int(x - 0.5f);
    const float f = x - float(whole);
    float p = 1.32647425e-3f;
    p = p * f + 9.671518e-3f;
    p = p * f + 5.55073376e-2f;
    p = p * f + 2.4022242e-1f;
    p = p * f + 6.93146978e-1f;
    p = p * f + 1.0f;
    return p * std::bit_cast<float>((whole + 127) << 23);
}

/// Fine nodes with their own sign and merged ones with the other: their sum is the error of merging.
struct Signed {
    int count = 0;
    float x[maxWindow + ruleNodes], y[maxWindow + ruleNodes], weight[maxWindow + ruleNodes];
    float values[5][maxWindow + ruleNodes];

    void add(const SpanNode &n, double sign)
    {
        x[count] = float(n.x), y[count] = float(n.y), weight[count] = float(sign * n.weight);
        for (std::size_t v = 0; v < n.values.size(); ++v)
            values[v][count] = float(sign * n.weight * n.values[v]);
        ++count;
    }
    /// Greatest of |error of the density| and half of |error of density times a value| at a point.
    float errorAt(float px, float py, bool valuesVary) const
    {
        float gaussian[maxWindow + ruleNodes], density = 0;
        for (int i = 0; i < count; ++i) {
            const float dx = px - x[i], dy = py - y[i];
            gaussian[i] = exp2Fast(std::max(-1.44269504f * (dx * dx + dy * dy), -60.0f));
        }
        for (int i = 0; i < count; ++i)
            density += gaussian[i] * weight[i];
        float worst = std::abs(density);
        for (int v = 0; valuesVary && v < 5; ++v) {
            float sum = 0;
            for (int i = 0; i < count; ++i)
                sum += gaussian[i] * values[v][i];
            worst = std::max(worst, 0.5f * std::abs(sum));
        }
        return worst;
    }
};

/// Whether merging shows: at points between the merged nodes, where a sum of Gaussians ripples most, and beside them.
bool differs(const SpanNode *fine, int count, const SpanNode *merged, int mergedCount, double tolerance, bool valuesVary)
{
    Signed all;
    // From the first node: floats keep their digits.
    const double x0 = fine[0].x, y0 = fine[0].y;
    const auto moved = [&](SpanNode n) {
        n.x -= x0, n.y -= y0;
        return n;
    };
    for (int i = 0; i < count; ++i)
        all.add(moved(fine[i]), 1);
    for (int i = 0; i < mergedCount; ++i)
        all.add(moved(merged[i]), -1);
    for (int i = 0; i < mergedCount; ++i) {
        const SpanNode here = moved(merged[i]), next = moved(merged[std::min(i + 1, mergedCount - 1)]),
                       back = moved(merged[std::max(i - 1, 0)]);
        const double tx = next.x - back.x, ty = next.y - back.y, length = std::hypot(tx, ty);
        const double nx = length > 0 ? -ty / length : 0, ny = length > 0 ? tx / length : 1;
        const double mx = 0.5 * (here.x + next.x), my = 0.5 * (here.y + next.y);
        for (const double across : {0.0, 0.9, -0.9})
            if (double(all.errorAt(float(mx + across * nx), float(my + across * ny), valuesVary)) > tolerance)
                return true;
        if (double(all.errorAt(float(here.x), float(here.y), valuesVary)) > tolerance)
            return true;
        for (const double across : {1.6, -1.6})
            if (double(all.errorAt(float(here.x + across * nx), float(here.y + across * ny), valuesVary)) > tolerance)
                return true;
    }
    return false;
}

struct Merger {
    const std::vector<SpanNode> &fine;
    const std::vector<double> arc;
    std::vector<SpanWindow> out;

    /// Fine nodes [begin, end) by at most n.
    void merge(std::size_t begin, std::size_t end, int n)
    {
        const int count = int(end - begin);
        const SpanNode *nodes = &fine[begin];
        if (count <= n) {
            out.push_back({begin, end, {nodes, nodes + count}});
            return;
        }
        if (count <= maxWindow) {
            double tolerance = nodes[0].tolerance;
            bool vary = false;
            for (int i = 1; i < count; ++i) {
                tolerance = std::min(tolerance, nodes[i].tolerance);
                vary |= nodes[i].values != nodes[0].values;
            }
            SpanWindow window{begin, end, {}};
            gaussRule(nodes, &arc[begin], count, n, vary, window.nodes);
            if (!differs(nodes, count, window.nodes.data(), n, 0.5 * tolerance, vary)) {
                out.push_back(std::move(window));
                return;
            }
        }
        const int half = count / 2, fewer = std::min(n, (half + 1) / 2 + 2);
        merge(begin, begin + std::size_t(half), fewer);
        merge(begin + std::size_t(half), end, fewer);
    }
};

/// Window length in spreads at which the rule on a straight even line just meets the tolerance: 2.429 at 2⁻¹⁴, and the
/// error grows with the 11th power.
double windowLength(double epsilon)
{
    const double rounded = std::exp2(std::floor(std::log2(epsilon)));
    return 0.97 * 2.429 * std::pow(0.5 * rounded * 0x1p14, 1.0 / (2 * ruleNodes + 1));
}

} // namespace

std::vector<SpanWindow> mergeSpan(const std::vector<SpanNode> &fine, double epsilon)
{
    Merger merger{fine, arcLengths(fine), {}};
    const double length = merger.arc.back();
    const int windows = std::max(1, int(std::ceil(length / windowLength(epsilon))));
    std::size_t begin = 0;
    for (int w = 0; w < windows && begin < fine.size(); ++w) {
        std::size_t end = begin;
        while (end < fine.size() && (w + 1 == windows || merger.arc[end] <= length * (w + 1) / windows))
            ++end;
        if (end > begin)
            merger.merge(begin, end, ruleNodes);
        begin = end;
    }
    return std::move(merger.out);
}

} // namespace suffuse
