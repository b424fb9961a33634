// Gaussian nodes: the rigorous bound holds on random cubics, and node counts are as small as documented.
#include "render/nodes/level0.h"
#include "render/nodes/node_builder.h"
#include "tests/render/paintings.h"
#include "tests/trials.h"

using namespace suffuse;
using namespace suffuse::test;

namespace {

/// Density by a composite rule so fine that it is the truth here: panels of s/8 and less.
double truth(const Cubic &c, double s, double phi, Point x)
{
    const double polygon = length(c.p[1] - c.p[0]) + length(c.p[2] - c.p[1]) + length(c.p[3] - c.p[2]);
    const int panels = std::clamp(int(polygon / s * 8), 64, 4000);
    const QuadratureRule &rule = gaussLegendre(8);
    double sum = 0;
    for (int k = 0; k < panels; ++k)
        for (int i = 0; i < 8; ++i) {
            const double p = (k + rule.x[std::size_t(i)]) / panels;
            const Point d = x - c.at(p);
            sum += rule.weight[std::size_t(i)] / panels * std::exp(-dot(d, d) / (s * s)) * length(c.derivative(p));
        }
    return phi * sum / (std::numbers::pi * s * s);
}

/// As the renderer sums them: cut off at R.
double fromNodes(const StrokeNodes &nodes, Point x)
{
    double sum = 0;
    for (const Node &n : nodes.nodes) {
        const double dx = x.x - n.x, dy = x.y - n.y, cut = std::exp(-double(n.cutRadius) * double(n.cutRadius));
        const auto axis = [cut](double q) { return std::max(0.0, std::exp(-q) - cut); };
        sum += n.weight * axis(n.a * dx * dx) * axis(n.c * dy * dy);
    }
    return sum;
}

/// A random cubic: every fifth nearly cusped, every seventh nearly a loop.
Cubic randomCubic(std::mt19937_64 &random, int i)
{
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> u(0, 1);
    const double size = std::pow(10, u(random) * 2.3 - 1.3);
    Cubic c;
    for (Point &p : c.p)
        p = {size * normal(random), size * normal(random)};
    if (i % 5 == 0)
        c.p[2] = c.p[1] + 0.05 * (c.p[2] - c.p[1]);
    if (i % 7 == 0)
        c.p[3] = c.p[0] + 0.1 * (c.p[3] - c.p[0]);
    return c;
}

} // namespace

class TestNodes : public QObject {
    Q_OBJECT

private slots:
    void boundHolds()
    {
        // Long: SUFFUSE_LONG=1 runs 100,000 cubics.
        const int count = isLongRun() ? 100000 : 3000;
        std::mt19937_64 random(11);
        std::normal_distribution<double> normal;
        std::uniform_real_distribution<double> u(0, 1);
        double worstShare = 0;
        std::size_t nodes = 0;
        for (int i = 0; i < count; ++i) {
            const Cubic drawn = randomCubic(random, i);
            Stroke s;
            s.style = randomStyle(random);
            Segment g;
            for (int k = 0; k < 4; ++k)
                g.bezier[std::size_t(k)] = toOffset(drawn.p[std::size_t(k)], {});
            const double phi = 1.2 * std::sqrt(std::numbers::pi);
            g.density = float(phi);
            g.diffusion = 0.25f; // s = 1 at age 1
            s.segments = {g};
            const auto built = buildNodes(s, 1'000'000, 4, Rect::of(-1e9, -1e9, 2e9, 2e9));
            nodes += built->nodes.size();
            const Cubic c = s.cubicOf(g); // rounded to what files hold
            const double peak = double(g.density) / std::sqrt(std::numbers::pi);
            const double tolerance = std::clamp(densityTolerance(s.style, peak, 16) / peak, 0x1p-22, 0x1p-12) * peak;
            for (int k = 0; k < 8; ++k) {
                const Point on = c.at(u(random));
                const Point x =
                    k % 4 == 0 ? c.p[k == 0 ? 0 : 3] : on + Point{0.8 * normal(random), 0.8 * normal(random)};
                const double density = truth(c, 1, double(g.density), x);
                const double error = std::abs(fromNodes(*built, x) - density);
                worstShare = std::max(worstShare, error / tolerance);
            }
        }
        qInfo("%d cubics, %.2f nodes each, greatest error %.3f of the budget", count, double(nodes) / count,
              worstShare);
        QVERIFY(worstShare <= 1);
    }

    void straightEvenSegmentsTakeFewNodes()
    {
        // At 2^-14 a straight, evenly drawn segment needs n = 2 … 6 nodes up to these lengths in spreads.
        const double lengths[] = {0.525, 1.11, 1.758, 2.429, 3.107};
        for (int i = 0; i < 5; ++i) {
            const double l = lengths[i] * 0.93;
            const Cubic c{{Point{0, 0}, Point{l / 3, 0}, Point{2 * l / 3, 0}, Point{l, 0}}};
            const int n = panelNodes(panelCurve(c), panelCurve(c), 0x1p-14);
            QVERIFY2(n >= 1 && n <= 3 + i, qPrintable(QStringLiteral("%1 nodes for %2 spreads").arg(n).arg(l)));
        }
    }

    void quadratureIsExactForPolynomials()
    {
        for (int n = 1; n <= maxPanelNodes; ++n)
            for (int power = 0; power < 2 * n; ++power) {
                double sum = 0;
                for (int i = 0; i < n; ++i)
                    sum +=
                        gaussLegendre(n).weight[std::size_t(i)] * std::pow(gaussLegendre(n).x[std::size_t(i)], power);
                QVERIFY(std::abs(sum - 1.0 / (power + 1)) < 1e-14);
            }
    }

    void nodesAreAPureFunctionOfTheSegment()
    {
        std::mt19937_64 random(2);
        const auto strokes = randomStrokes(random, 20, 100, 100);
        for (const Stroke &s : strokes) {
            const Rect everywhere = Rect::of(-1e6, -1e6, 2e6, 2e6);
            const auto whole = buildNodes(s, s.driesAt() - 1, 0, everywhere);
            // The same segment in a stroke of its own gives the same nodes, unless styles of others matter.
            for (std::size_t k = 0; k < s.segments.size(); ++k) {
                Stroke alone = s;
                alone.segments = {s.segments[k]};
                bool plain = true;
                for (const Segment &g : s.segments)
                    plain &= !g.style;
                if (!plain)
                    continue;
                const auto one = buildNodes(alone, s.driesAt() - 1, 0, everywhere);
                const NodeGroup &range = whole->groups[k];
                QVERIFY(std::equal(whole->nodes.begin() + range.begin, whole->nodes.begin() + range.end,
                                   one->nodes.begin(), one->nodes.end()));
            }
        }
    }
};

QTEST_GUILESS_MAIN(TestNodes)
#include "test_nodes.moc"
