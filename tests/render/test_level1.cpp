// Merged nodes: runs of random strokes keep their density, colour and granulation within the tolerance, everywhere.
#include "render/nodes/level0.h"
#include "render/nodes/level1.h"
#include "tests/render/paintings.h"
#include "tests/trials.h"

using namespace suffuse;
using namespace suffuse::test;

namespace {

/// Shape of a random stroke, in spreads.
struct StrokeShape {
    double step;      ///< segment length
    double curvature; ///< of what its heading does at random
    double tolerance;
    bool valuesVary;
};

/// Level 0 nodes of a run of segments.
struct Span {
    std::vector<SpanNode> nodes;
    std::vector<std::size_t> segments; ///< where each begins

    MergedSpan merged() const
    {
        MergedSpan out;
        mergeSpan(nodes, segments, out);
        return out;
    }
};

/// A smooth random stroke whose density and values change along it.
Span randomSpan(std::mt19937_64 &random, const StrokeShape &shape, int segments)
{
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> u(0, 1);
    std::vector<Point> points;
    double heading = 6.28 * u(random), bend = 0;
    Point at{1000 * normal(random), 1000 * normal(random)};
    for (int i = 0; i <= segments + 2; ++i) {
        points.push_back(at);
        bend = 0.8 * bend + shape.curvature * shape.step * normal(random);
        heading += bend;
        at = at + shape.step * std::exp(0.2 * normal(random)) * Point{std::cos(heading), std::sin(heading)};
    }
    Span span;
    const double phase = 6.28 * u(random);
    std::array<double, 5> first, last;
    for (std::size_t v = 0; v < 5; ++v)
        first[v] = u(random), last[v] = shape.valuesVary ? u(random) : first[v];
    for (int k = 1; k <= segments; ++k) {
        const Point a = points[std::size_t(k)], b = points[std::size_t(k) + 1];
        const Cubic c{
            {a, a + (1.0 / 6) * (b - points[std::size_t(k) - 1]), b - (1.0 / 6) * (points[std::size_t(k) + 2] - a), b}};
        const double density = 0.6 + 0.4 * std::sin(0.9 * k + phase), along = double(k) / segments;
        const int n = panelNodes(panelCurve(c), panelCurve(c), 0.1 * shape.tolerance);
        const QuadratureRule &rule = gaussLegendre(n);
        span.segments.push_back(span.nodes.size());
        for (std::size_t i = 0; i < std::size_t(n); ++i) {
            const Point p = c.at(rule.x[i]);
            SpanNode node{p.x, p.y, 0, shape.tolerance, first};
            node.weight = density / std::sqrt(std::numbers::pi) * rule.weight[i] * length(c.derivative(rule.x[i]));
            for (std::size_t v = 0; v < 5; ++v)
                node.values[v] += along * (last[v] - first[v]);
            span.nodes.push_back(node);
        }
    }
    return span;
}

using Sums = std::array<double, 6>; // density, density times each value

Sums sumsAt(const std::vector<SpanNode> &nodes, Point x)
{
    Sums sums{};
    for (const SpanNode &n : nodes) {
        const double e = n.weight * std::exp(-(x.x - n.x) * (x.x - n.x) - (x.y - n.y) * (x.y - n.y));
        sums[0] += e;
        for (std::size_t v = 0; v < 5; ++v)
            sums[v + 1] += e * n.values[v];
    }
    return sums;
}

} // namespace

class TestLevel1 : public QObject {
    Q_OBJECT

private slots:
    void sumsStayWithinTheTolerance_data()
    {
        QTest::addColumn<double>("step");
        QTest::addColumn<double>("curvature");
        QTest::addColumn<double>("tolerance");
        QTest::addColumn<bool>("valuesVary");
        QTest::newRow("nearly straight") << 0.6 << 0.02 << 1e-4 << false;
        QTest::newRow("pen") << 0.6 << 0.2 << 1e-4 << false;
        QTest::newRow("pen, changing colour") << 0.6 << 0.2 << 1e-4 << true;
        QTest::newRow("winding, changing colour") << 0.4 << 1.0 << 1e-4 << true;
        QTest::newRow("long segments") << 2.0 << 0.1 << 1e-4 << true;
        QTest::newRow("short segments") << 0.1 << 0.3 << 2e-4 << true;
        QTest::newRow("a sharp rim") << 0.5 << 0.1 << 1e-5 << true;
    }
    void sumsStayWithinTheTolerance()
    {
        QFETCH(double, step);
        QFETCH(double, curvature);
        QFETCH(double, tolerance);
        QFETCH(bool, valuesVary);
        const int strokes = isLongRun() ? 300 : 15;
        std::mt19937_64 random(5);
        std::size_t before = 0, after = 0;
        double worst = 0, worstValue = 0;
        for (int i = 0; i < strokes; ++i) {
            const Span span = randomSpan(random, {step, curvature, tolerance, valuesVary}, 3 + i % 30);
            const auto &fine = span.nodes;
            const auto merged = span.merged().nodes;
            before += fine.size();
            after += merged.size();
            Rect box;
            for (const SpanNode &n : fine)
                box.include({n.x, n.y});
            box = box.grown(2.5);
            for (double y = box.top; y < box.bottom; y += 0.31)
                for (double x = box.left; x < box.right; x += 0.31) {
                    const Sums a = sumsAt(fine, {x, y}), b = sumsAt(merged, {x, y});
                    worst = std::max(worst, std::abs(a[0] - b[0]) / tolerance);
                    for (std::size_t v = 1; v < 6; ++v)
                        worstValue = std::max(worstValue, std::abs(a[v] - b[v]) / tolerance);
                }
        }
        qInfo("%zu nodes become %zu; greatest error %.2f of the tolerance, of values %.2f", before, after, worst,
              worstValue);
        QVERIFY(worst <= 1);
        QVERIFY(worstValue <= 2);
        QVERIFY(2 * after <= before);
    }

    void windowsCoverTheSpanInOrder()
    {
        std::mt19937_64 random(6);
        for (int segments = 1; segments <= 40; segments += 3) {
            const Span span = randomSpan(random, {0.7, 0.3, 1e-4, true}, segments);
            const MergedSpan merged = span.merged();
            std::size_t at = 0, node = 0;
            for (const SpanWindow &w : merged.windows) {
                QCOMPARE(w.begin, at);
                QCOMPARE(w.nodes, node);
                QVERIFY(w.end > w.begin && w.nodesEnd > w.nodes && w.nodesEnd - w.nodes <= w.end - w.begin);
                at = w.end, node = w.nodesEnd;
            }
            QCOMPARE(at, span.nodes.size());
            QCOMPARE(node, merged.nodes.size());
        }
    }

    /// What dragging a node does: two segments become others, of other lengths and with as many nodes or not.
    void aChangeStaysInItsWindow()
    {
        std::mt19937_64 random(9);
        std::size_t all = 0, kept = 0;
        for (int i = 0; i < 40; ++i) {
            const int count = 32;
            const Span before = randomSpan(random, {0.72, 0.2, 1e-4, true}, count);
            const std::size_t changed = 1 + random() % (count - 3), from = before.segments[changed],
                              to = before.segments[changed + 2];
            Span after = before;
            for (std::size_t k = from; k < to; ++k)
                after.nodes[k].x += 0.2, after.nodes[k].weight *= 1.1;
            after.nodes.insert(after.nodes.begin() + std::ptrdiff_t(to), after.nodes[to - 1]);
            for (std::size_t k = changed + 2; k < after.segments.size(); ++k)
                ++after.segments[k];
            const MergedSpan a = before.merged(), b = after.merged();
            for (const SpanWindow &w : a.windows) {
                const bool isApart = w.end <= from || w.begin >= to;
                const std::size_t begin = w.begin + (w.begin >= to ? 1 : 0);
                const auto same = std::ranges::find_if(b.windows, [&](const SpanWindow &v) {
                    return v.begin == begin && v.end - v.begin == w.end - w.begin;
                });
                all += isApart;
                kept +=
                    isApart && same != b.windows.end() &&
                    std::equal(a.nodes.begin() + std::ptrdiff_t(w.nodes), a.nodes.begin() + std::ptrdiff_t(w.nodesEnd),
                               b.nodes.begin() + std::ptrdiff_t(same->nodes),
                               b.nodes.begin() + std::ptrdiff_t(same->nodesEnd));
            }
        }
        qInfo("%zu of %zu windows without a changed segment stay", kept, all);
        QVERIFY(kept >= all - all / 20); // one that becomes long enough to be halved, or short enough not to be
    }

    void massAndCentreAreKeptAndWeightsArePositive()
    {
        std::mt19937_64 random(7);
        for (int i = 0; i < 20; ++i) {
            const Span span = randomSpan(random, {0.5, 0.3, 1e-4, true}, 20);
            const auto moments = [](const std::vector<SpanNode> &nodes) {
                std::array<double, 3> sums{};
                for (const SpanNode &n : nodes)
                    sums[0] += n.weight, sums[1] += n.weight * n.x, sums[2] += n.weight * n.y;
                return sums;
            };
            const auto merged = span.merged().nodes;
            const auto a = moments(span.nodes), b = moments(merged);
            for (std::size_t k = 0; k < 3; ++k)
                QVERIFY(std::abs(a[k] - b[k]) <= 1e-9 * std::abs(a[k]));
            QVERIFY(std::ranges::all_of(merged, [](const SpanNode &n) { return n.weight > 0; }));
        }
    }

    /// Rounding must not make the nodes of a stroke differ in what all of its segments agree in.
    void valuesThatDoNotVaryStayToTheBit()
    {
        std::mt19937_64 random(9);
        for (int i = 0; i < 20; ++i) {
            Span span = randomSpan(random, {0.5, 0.3, 1e-5, true}, 20);
            for (SpanNode &n : span.nodes)
                n.values[2] = double(0.7f), n.values[4] = double(0.3f);
            for (const SpanNode &n : span.merged().nodes) {
                QCOMPARE(n.values[2], double(0.7f));
                QCOMPARE(n.values[4], double(0.3f));
            }
        }
    }

    void theRuleIsExactForItsPolynomials()
    {
        std::mt19937_64 random(8);
        const auto fine = randomSpan(random, {0.6, 0.0, 1e-4, true}, 8).nodes; // a straight line
        std::vector<double> arc{0};
        for (std::size_t i = 1; i < fine.size(); ++i)
            arc.push_back(arc.back() + std::hypot(fine[i].x - fine[i - 1].x, fine[i].y - fine[i - 1].y));
        SpanRule rule;
        rule.start(fine.data(), arc.data(), int(fine.size()), VaryingValues(fine),
                   massOf(fine.data(), int(fine.size())));
        const double half = 0.5 * arc.back();
        for (int n = 1; n <= SpanRule::maxNodes; ++n) {
            std::array<SpanNode, SpanRule::maxNodes> nodes;
            rule.nodes(n, nodes.data());
            double mass = 0, wanted = 0;
            for (int i = 0; i < n; ++i)
                mass += nodes[std::size_t(i)].weight;
            for (const SpanNode &f : fine)
                wanted += f.weight;
            QVERIFY(std::abs(mass - wanted) < 1e-10 * wanted);
            if (n < 6)
                continue; // the position of a node follows from sin(aℓ) only where n suffices for its inverse
            double sum = 0, exact = 0;
            for (std::size_t i = 0; i < fine.size(); ++i)
                exact += fine[i].weight * std::pow(std::sin(rule.bend() * (arc[i] - half) / half), 2);
            for (int i = 0; i < n; ++i) {
                const SpanNode &node = nodes[std::size_t(i)];
                const double at = std::hypot(node.x - fine[0].x, node.y - fine[0].y);
                sum += node.weight * std::pow(std::sin(rule.bend() * (at - half) / half), 2);
            }
            QVERIFY(std::abs(sum - exact) < 1e-3 * exact);
        }
    }
};

QTEST_GUILESS_MAIN(TestLevel1)
#include "test_level1.moc"
