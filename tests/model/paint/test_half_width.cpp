// Half-widths in closed form against what the density says: a line integrated numerically, and plain bisection.
#include "model/paint/half_width.h"

#include <QTest>

#include <functional>
#include <numbers>
#include <random>

using namespace suffuse;

namespace {

/// Density of an infinite line at distance v (eq 13), by the trapezium rule, which is exact to rounding for Gaussians.
double lineDensity(double density, double s, double v)
{
    constexpr double step = 0.05;
    double sum = 0;
    for (int i = -200; i <= 200; ++i)
        sum += std::exp(-(i * step) * (i * step));
    return density / (std::numbers::pi * s * s) * std::exp(-v * v / (s * s)) * sum * step * s;
}

double bisect(double low, double high, const std::function<bool(double)> &isBelow)
{
    for (int i = 0; i < 200; ++i) {
        const double middle = std::sqrt(low * high);
        (isBelow(middle) ? low : high) = middle;
    }
    return std::sqrt(low * high);
}

bool close(double a, double b, double tolerance)
{
    return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

struct Case {
    double diffusion, age, cut, density;
};

/// 2,000 cases over the magnitudes that paintings have.
std::vector<Case> cases()
{
    std::mt19937 random(7);
    const auto log = [&](double low, double high) {
        return low * std::pow(high / low, std::uniform_real_distribution<double>(0, 1)(random));
    };
    std::vector<Case> result;
    for (int i = 0; i < 2000; ++i)
        result.push_back({log(1e-3, 1e6), log(1e-2, 100), log(1e-2, 4), log(1e-2, 1e5)});
    return result;
}

} // namespace

class TestStrokeWidth : public QObject {
    Q_OBJECT

private slots:
    void halfWidthIsWhereTheDensityFallsToTheCut()
    {
        int visible = 0;
        for (const Case &c : cases()) {
            const double s = std::sqrt(4 * c.diffusion * c.age);
            const double w = halfWidth(c.diffusion, c.density, c.age, c.cut);
            if (lineDensity(c.density, s, 0) <= c.cut) {
                QCOMPARE(w, 0.0);
                continue;
            }
            ++visible;
            // An error of w counts 2w²/s² times in the density.
            QVERIFY(close(lineDensity(c.density, s, w), c.cut, 1e-12 * (1 + 4 * w * w / (s * s))));
        }
        QVERIFY(visible > 500);
        QCOMPARE(halfWidth(10, 5, 0, 0.5), 0.0); // nothing is there at age 0
    }

    void densityGivesTheWidth()
    {
        std::mt19937 random(8);
        for (const Case &c : cases()) {
            const double s = std::sqrt(4 * c.diffusion * c.age);
            const double w = s * std::uniform_real_distribution<double>(0.01, 4)(random);
            const WidthValues values = valuesForHalfWidth(w, c.diffusion, c.age, c.cut);
            QVERIFY(close(halfWidth(values.diffusion, values.density, c.age, c.cut), w, 1e-10));
            if (w <= 2 * s) {
                QCOMPARE(values.diffusion, c.diffusion);
                const double searched =
                    bisect(1e-9, 1e15, [&](double phi) { return halfWidth(c.diffusion, phi, c.age, c.cut) < w; });
                if (w > 0.5 * s) // where w hardly depends on φ, φ hardly depends on w
                    QVERIFY(close(values.density, searched, 1e-12));
            } else {
                QVERIFY(close(std::sqrt(4 * values.diffusion * c.age), w / 2, 1e-14));
            }
        }
    }

    void beyondTwoSpreadsDensityGrowsWithTheSpread()
    {
        const WidthValues at = valuesForHalfWidth(20, 25, 1, 0.5); // s = 10: just at the limit
        const WidthValues twice = valuesForHalfWidth(40, 25, 1, 0.5);
        QVERIFY(close(at.diffusion, 25, 1e-15));
        QVERIFY(close(twice.diffusion, 100, 1e-15));
        QVERIFY(close(twice.density, 2 * at.density, 1e-14));
        const WidthValues none = valuesForHalfWidth(0, 25, 1, 0.5);
        QVERIFY(close(lineDensity(none.density, 10, 0), 0.5, 1e-13)); // the peak is just at the cut
    }

    void diffusionAloneGivesTheWidth()
    {
        std::mt19937 random(9);
        for (const Case &c : cases()) {
            const double most = greatestHalfWidth(c.density, c.cut);
            const double w = most * std::uniform_real_distribution<double>(0.01, 0.98)(random);
            const double D = diffusionForHalfWidth(w, c.density, c.age, c.cut);
            QVERIFY(close(halfWidth(D, c.density, c.age, c.cut), w, 1e-11));
            // On the branch where more D is wider still: t < t*/e.
            const double top = fadingAge(1, c.density, c.cut) / (std::numbers::e * c.age);
            QVERIFY(D < top);
            const double searched =
                bisect(top * 1e-12, top, [&](double trial) { return halfWidth(trial, c.density, c.age, c.cut) < w; });
            if (w < 0.9 * most)
                QVERIFY(close(D, searched, 1e-12));
        }
    }

    void widthsAreClampedToTheGreatest()
    {
        const double most = greatestHalfWidth(30, 0.5);
        const double D = diffusionForHalfWidth(2 * most, 30, 2, 0.5);
        QVERIFY(close(D, fadingAge(1, 30, 0.5) / (std::numbers::e * 2), 1e-7));
        QVERIFY(close(halfWidth(D, 30, 2, 0.5), most, 1e-12));
        for (const double k : {0.5, 0.9, 1.1, 2.0})
            QVERIFY(halfWidth(k * D, 30, 2, 0.5) < most);
        // It has faded at t*, and not just before.
        const double age = fadingAge(7, 30, 0.5);
        QCOMPARE(halfWidth(7, 30, age * 1.0001, 0.5), 0.0);
        QVERIFY(halfWidth(7, 30, age * 0.9999, 0.5) > 0);
    }

    void lambert()
    {
        for (double y = -1.001; y > -600; y *= 1.01) {
            const double x = y * std::exp(y);
            QVERIFY(close(lowerLambertW(x), y, 1e-11));
        }
        QCOMPARE(lowerLambertW(-1 / std::numbers::e), -1.0);
    }

    void acrossAnAnisotropicLine()
    {
        Segment segment;
        segment.diffusion = 10;
        QCOMPARE(diffusionAcross(segment, {3, 4}), 10.0);
        segment.anisotropyRatio = 4;
        QVERIFY(close(diffusionAcross(segment, {2, 0}), 10, 1e-12)); // along the angle: D across it
        QVERIFY(close(diffusionAcross(segment, {0, 5}), 40, 1e-12));
        segment.anisotropyAngle = float(std::numbers::pi / 2);
        QVERIFY(close(diffusionAcross(segment, {2, 0}), 40, 1e-6));
        segment.anisotropyAngle = float(std::numbers::pi / 4);
        QVERIFY(close(diffusionAcross(segment, {1, 0}), 25, 1e-6));
    }

    /// Short and long lines, across their middle and beyond their ends, against the density summed over the line.
    void boxOfWhatIsSeen()
    {
        for (const double length : {4.0, 20.0, 60.0, 400.0}) {
            Stroke stroke;
            stroke.origin = {1000, 500};
            stroke.style = {StyleKind::Uniform, {0.2f, 0.1f, 0}};
            Segment segment;
            const auto x = float(length / 3);
            segment.bezier = {Offset{0, 0}, Offset{x, 0}, Offset{2 * x, 0}, Offset{float(length), 0}};
            segment.diffusion = 100; // s = 20
            segment.density = 80;
            stroke.segments = {segment};
            const auto densityAt = [&](double beyond, double beside) {
                constexpr int steps = 4000;
                double sum = 0;
                for (int k = 0; k < steps; ++k) {
                    const double along = beyond + (k + 0.5) / steps * length;
                    sum += std::exp(-(along * along + beside * beside) / 400);
                }
                return 80 / (std::numbers::pi * 400) * sum * length / steps;
            };
            const auto edge = [&](auto density) {
                return bisect(1e-6, 200, [&](double d) { return density(d) > double(0.2f); });
            };
            const double beside = edge([&](double d) { return densityAt(-length / 2, d); });
            const double beyond = edge([&](double d) { return densityAt(d, 0); });
            const Rect box = seenBox(stroke);
            QVERIFY(close(box.bottom - 500, beside, 1e-3) && close(500 - box.top, beside, 1e-3));
            QVERIFY(close(1000 - box.left, beyond, 1e-3));
            QVERIFY(close(box.right - 1000 - length, beyond, 1e-3));
        }
    }

    void cutsOfTheStyles()
    {
        QCOMPARE(visibleCut({StyleKind::Uniform, {0.5f, 0.1f, 0}}), 0.5);
        QVERIFY(close(visibleCut({StyleKind::Feathering, {2, 2, 0}}), std::sqrt(2.0), 1e-12));
        const Style edge{StyleKind::Edge, {0.5f, 0.5f, 0.4f}};
        const double start = visibleCut(edge);
        const auto f = [](double phi) { return double(0.4f) * (std::pow(0.5 / phi, 6) - std::pow(0.5 / phi, 3) + 1); };
        QVERIFY(close(f(start), 1, 1e-12));
        QVERIFY(f(start * 1.001) < 1);
    }
};

QTEST_GUILESS_MAIN(TestStrokeWidth)
#include "test_half_width.moc"
