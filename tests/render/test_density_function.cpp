// The reference's density functions: their edges and values by formula, their means over a pixel by brute force.
#include "render/reference/style.h"
#include "tests/render/paintings.h"

#include <QtTest>

using namespace suffuse;
using namespace suffuse::reference;

namespace {

/// Mean of f over [lo, hi] by the midpoint rule.
template <typename F>
double bruteMean(double lo, double hi, F f)
{
    const int n = 200000;
    double sum = 0;
    for (int i = 0; i < n; ++i)
        sum += f(lo + (hi - lo) * (i + 0.5) / n);
    return sum / n;
}

} // namespace

class TestDensityFunction : public QObject {
    Q_OBJECT

private slots:
    void uniformEndsAtItsCut()
    {
        for (const Xi &xi : {Xi{0.5, 0.05, 0}, Xi{0.5, 0.2, 0}, Xi{2, 0.01, 0}}) {
            const double cut = uniformCut(xi);
            QVERIFY(std::abs(cut - std::max(0.0, xi[0] - 8 * xi[1])) < 1e-15);
            QCOMPARE(reference::densityFunction(StyleKind::Uniform, xi, cut), 0.0);
            QCOMPARE(reference::densityFunction(StyleKind::Uniform, xi, 0), 0.0);
            QCOMPARE(densityFunctionMean(StyleKind::Uniform, xi, 0.5 * cut, 0.4 * cut), 0.0);
            QVERIFY(reference::densityFunction(StyleKind::Uniform, xi, cut + 0.1 * xi[1]) > 0);
            QVERIFY(reference::densityFunction(StyleKind::Uniform, xi, xi[0] + 60 * xi[1]) > 1 - 1e-12);
        }
        // Inside, it is the paper's within 1.7e-4 where ξ1/ξ2 ≥ 8.
        for (double density = 0.5; density < 1.5; density += 0.01) {
            const double paper = 1 / (1 + std::exp(-(density - 0.5) / 0.05));
            QVERIFY(std::abs(reference::densityFunction(StyleKind::Uniform, {0.5, 0.05, 0}, density) - paper) < 1.7e-4);
        }
    }

    void featheringIsAPowerUpToOne()
    {
        const Xi xi{2, 1.5, 0};
        QCOMPARE(reference::densityFunction(StyleKind::Feathering, xi, 0), 0.0);
        QVERIFY(std::abs(reference::densityFunction(StyleKind::Feathering, xi, 0.5) - 0.125) < 1e-15);
        QCOMPARE(reference::densityFunction(StyleKind::Feathering, xi, 2), 1.0);
        QCOMPARE(reference::densityFunction(StyleKind::Feathering, xi, 9), 1.0);
    }

    void edgesEndWhereTheyReachOne()
    {
        for (const Xi &xi : {Xi{0.36, 0.40, 0.5}, Xi{1, 0.2, 0.9}, Xi{0.7, 0.8, 1}, Xi{1, 1.25, 0.05}, Xi{1, 0.1, 1}}) {
            const double cut = edgeCut(xi);
            QVERIFY(std::abs(reference::densityFunction(StyleKind::Edge, xi, cut * (1 + 1e-12)) - 1) < 1e-9);
            QCOMPARE(reference::densityFunction(StyleKind::Edge, xi, cut * (1 - 1e-9)), 0.0);
            QCOMPARE(reference::densityFunction(StyleKind::Edge, xi, 0), 0.0);
            // The formula as the contract prints it.
            const double a = std::pow(xi[0], 6), b = std::pow(xi[1], 3);
            const double printed = std::pow((b + std::sqrt(b * b - 4 * a * (1 - 1 / xi[2]))) / (2 * a), -1.0 / 3);
            QVERIFY(std::abs(cut / printed - 1) < 1e-13);
            // Its least value, ξ3(1 − ξ2⁶/4ξ1⁶), lies at φ³ = 2ξ1⁶/ξ2³; far inside it tends to ξ3.
            const double least = xi[2] * (1 - b * b / (4 * a));
            const double valley = std::cbrt(2 * a / b);
            QVERIFY(std::abs(reference::densityFunction(StyleKind::Edge, xi, valley) - least) < 1e-12);
            QVERIFY(reference::densityFunction(StyleKind::Edge, xi, 0.99 * valley) > least);
            QVERIFY(reference::densityFunction(StyleKind::Edge, xi, 1.01 * valley) > least);
            QVERIFY(std::abs(reference::densityFunction(StyleKind::Edge, xi, 1e6) - xi[2]) < 1e-9);
            // The rim's inner end, φ = ξ1²/ξ2, has the value from far inside.
            QVERIFY(std::abs(reference::densityFunction(StyleKind::Edge, xi,
                                                        std::max(cut * (1 + 1e-12), xi[0] * xi[0] / xi[1])) -
                             xi[2]) < 1e-9);
        }
    }

    void coverageIsTheMeanOverThePixel()
    {
        struct Case {
            StyleKind kind;
            Xi xi;
        };
        const Case cases[] = {{StyleKind::Uniform, {0.5, 0.05, 0}},   {StyleKind::Uniform, {0.5, 0.3, 0}},
                              {StyleKind::Uniform, {0.5, 0.002, 0}},  {StyleKind::Feathering, {1.1, 1.5, 0}},
                              {StyleKind::Feathering, {1.1, 0.5, 0}}, {StyleKind::Feathering, {0.8, 20, 0}},
                              {StyleKind::Edge, {0.36, 0.40, 0.5}},   {StyleKind::Edge, {1, 0.2, 0.9}}};
        for (const Case &c : cases) {
            for (double density : {0.01, 0.2, 0.3, 0.5, 0.7, 1.0, 1.4}) {
                for (double h : {1e-4, 1e-3, 0.02, 0.1, 0.6, 3.0}) {
                    const auto f = [&](double phi) { return reference::densityFunction(c.kind, c.xi, phi); };
                    const double q = std::min(h / density, 2.0);
                    const double brute = c.kind == StyleKind::Edge
                                             ? bruteMean(std::log(density) - q, std::log(density) + q,
                                                         [&](double u) { return f(std::exp(u)); })
                                             : bruteMean(density - h, density + h, f);
                    const double mean = densityFunctionMean(c.kind, c.xi, density, h);
                    // The midpoint rule is off by a step at a jump, by less at a kink.
                    QVERIFY2(std::abs(mean - brute) < 6e-6, qPrintable(QString("ξ %1 %2, φ %3, h %4: %5, not %6")
                                                                           .arg(c.xi[0])
                                                                           .arg(c.xi[1])
                                                                           .arg(density)
                                                                           .arg(h)
                                                                           .arg(mean, 0, 'g', 12)
                                                                           .arg(brute, 0, 'g', 12)));
                }
            }
        }
    }

    void coverageOfAlmostNothingIsANumber()
    {
        for (StyleKind kind : {StyleKind::Uniform, StyleKind::Feathering, StyleKind::Edge}) {
            const Style style = test::styleOf(kind);
            for (double density : {0.0, 5e-324, 1e-300, 1e-60, 1e-9})
                for (double h : {0.0, 1e-300, 1e-12, 1e-9})
                    QVERIFY(densityFunctionMean(kind, {style.xi[0], style.xi[1], style.xi[2]}, density, h) < 1e-9);
        }
    }

    void coverageIsContinuousWhereItsFormChanges()
    {
        for (StyleKind kind : {StyleKind::Uniform, StyleKind::Feathering, StyleKind::Edge}) {
            const Style style = test::styleOf(kind);
            const Xi xi{style.xi[0], style.xi[1], style.xi[2]};
            for (double density : {0.31, 0.45, 0.9}) {
                double previous = reference::densityFunction(kind, xi, density);
                for (double h = 1e-17; h < 1; h *= 1.01) {
                    const double mean = densityFunctionMean(kind, xi, density, h);
                    QVERIFY(std::abs(mean - previous) < 1e-12 + 0.02 * std::min(1.0, h / 0.02));
                    previous = mean;
                }
            }
        }
    }
};

QTEST_GUILESS_MAIN(TestDensityFunction)
#include "test_density_function.moc"
