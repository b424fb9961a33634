// Splits, cuts and maps against the reference's density, and on screen.
#include "model/shaping/curves/split.h"
#include "model/shaping/erasing/erase.h"
#include "model/shaping/transform.h"
#include "render/reference/density.h"
#include "tests/model/awkward_strokes.h"
#include "tests/render/paintings.h"

#include <QtTest>

using namespace suffuse;
using namespace suffuse::test;
using namespace suffuse::reference;

namespace {

Kernel kernelOf(const Segment &s)
{
    const double spread = s.spread(s.driesAt());
    return s.isIsotropic() ? isotropicKernel(spread) : anisotropicKernel(spread, s.anisotropyRatio, s.anisotropyAngle);
}

double densityOf(const Segment &s, const Cubic &curve, Point x)
{
    return segmentDensity(curve, kernelOf(s), s.density, x).density;
}

double densityOf(const Stroke &stroke, Point x)
{
    double sum = 0;
    for (const Segment &s : stroke.segments)
        sum += densityOf(s, stroke.cubicOf(s), x);
    return sum;
}

double peakOf(const Segment &s)
{
    return s.density / (std::sqrt(std::numbers::pi) * kernelOf(s).smallerSpread);
}

/// Largest difference of two pictures in levels of 8 bits.
int levelsApart(const FloatPicture &a, const FloatPicture &b)
{
    int most = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
        most = std::max(most, std::abs(int(std::lround(255 * a.rgba[i])) - int(std::lround(255 * b.rgba[i]))));
    return most;
}

} // namespace

class TestSplit : public QObject {
    Q_OBJECT

private slots:
    void aSplitKeepsTheDensity()
    {
        AwkwardStrokes random(1);
        double worst = 0;
        for (int i = 0; i < 500; ++i) {
            const Segment s = random.values(7);
            const Cubic whole{random.curve({}, std::exp(random.real(0, 5)))};
            std::vector<double> at{random.real(0, 1), random.real(0, 1), random.real(0, 1)};
            std::sort(at.begin(), at.end());
            at.insert(at.begin(), 0);
            at.push_back(1);
            const Point x = whole.at(random.real(0, 1)) + random.point(10);
            double sum = 0;
            for (std::size_t k = 1; k < at.size(); ++k)
                sum += densityOf(s, partOf(whole, at[k - 1], at[k]), x);
            worst = std::max(worst, std::abs(sum - densityOf(s, whole, x)) / peakOf(s));
        }
        QVERIFY2(worst < 1e-12, qPrintable(QString::number(worst)));
    }

    void roundingToFloatShiftsNext()
    {
        AwkwardStrokes random(2);
        for (int i = 0; i < 200; ++i) {
            const Stroke s = random.stroke(2);
            const Stroke t = withNodes(s, {{0, random.real(0, 1)}, {1, random.real(0, 1)}, {1, random.real(0, 1)}});
            const Point x = s.cubicOf(s.segments[0]).at(random.real(0, 1)) + random.point(10);
            const double peak = peakOf(s.segments[0]) + peakOf(s.segments[1]);
            QVERIFY(std::abs(densityOf(s, x) - densityOf(t, x)) < 3e-5 * peak);
        }
    }

    void erasingCutsWhereTheCircleIs()
    {
        // What is left and what was taken add up to what there was.
        AwkwardStrokes random(3);
        for (int i = 0; i < 200; ++i) {
            const Stroke s = random.stroke(2);
            const Point centre = s.cubicOf(s.segments[0]).at(random.real(0, 1));
            const double radius = random.real(2, 20);
            std::vector<int> sources;
            double left = 0;
            const Point x = centre + random.point(15);
            for (const Stroke &run : erased(s, {centre}, radius, &sources))
                left += densityOf(run, x);
            double expected = 0;
            for (const Segment &g : s.segments) {
                // Brute force: the midpoint rule on what lies outside.
                const Cubic c = s.cubicOf(g);
                const Kernel kernel = kernelOf(g);
                constexpr int n = 20000;
                for (int k = 0; k < n; ++k) {
                    const double p = (k + 0.5) / n;
                    const Point w = kernel.whiten(x - c.at(p));
                    if (length(c.at(p) - centre) > radius)
                        expected += g.density * kernel.norm * std::exp(-dot(w, w)) * length(c.derivative(p)) / n;
                }
            }
            const double peak = peakOf(s.segments[0]) + peakOf(s.segments[1]);
            QVERIFY2(std::abs(left - expected) < 1e-3 * peak, qPrintable(QString::number((left - expected) / peak)));
        }
    }

    void mapsThatScaleSpreadMapTheDensity()
    {
        // φ has no unit: at a mapped point it is what it was. Uneven maps: within their 1 %.
        AwkwardStrokes random(4);
        for (int i = 0; i < 100; ++i) {
            const Stroke s = random.stroke(2);
            const Point fixed = random.point(50), x = s.cubicOf(s.segments[0]).at(random.real(0, 1)) + random.point(10);
            const double angle = random.real(-3, 3), k = std::exp(random.real(-2, 2));
            const Affine even = Affine::scaling(fixed, k, i % 2 ? k : -k) * Affine::rotation(fixed, angle);
            const double before = densityOf(s, x), peak = peakOf(s.segments[0]) + peakOf(s.segments[1]);
            const double after = densityOf(transformed(s, even, SpreadRule::Scales), even(x));
            QVERIFY2(std::abs(after - before) < 2e-5 * peak, qPrintable(QString::number((after - before) / peak)));
            const Affine uneven = Affine::scaling(fixed, random.real(0.4, 2), random.real(0.4, 2)) *
                                  Affine::skew(fixed, random.real(-0.5, 0.5), 0) * Affine::rotation(fixed, angle);
            const double stretched = densityOf(transformed(s, uneven, SpreadRule::Scales), uneven(x));
            QVERIFY2(std::abs(stretched - before) < 0.006 * before + 1e-4 * peak,
                     qPrintable(QStringLiteral("%1: %2 %3").arg(i).arg(before).arg(stretched)));
        }
    }

    void onScreenNothingChanges()
    {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> u(0, 1);
        for (int i = 0; i < 12; ++i) {
            const auto before = painting(randomStrokes(random, 12, 160, 120), 160, 120);
            auto after = std::make_shared<Painting>(*before);
            for (std::size_t j = 0; j < before->strokes.size(); ++j) {
                const Stroke &s = *before->strokes[j];
                std::vector<CurvePlace> places;
                for (int k = 0; k < int(s.segments.size()); ++k)
                    places.push_back({k, u(random)});
                after->strokes[j] = std::make_shared<const Stroke>(withNodes(s, places));
            }
            for (const View &view :
                 {View::ofArea(before->canvas.area(), 160, 120), View{{80, 60}, 12, 0.3, i % 2 == 0, 120, 90}}) {
                const auto renderer = make(Backend::Cpu);
                const int levels =
                    levelsApart(test::render(*renderer, before, view), test::render(*renderer, after, view));
                QVERIFY2(levels <= 1, qPrintable(QStringLiteral("%1: %2 levels").arg(i).arg(levels)));
            }
        }
    }
};

QTEST_APPLESS_MAIN(TestSplit)
#include "test_split.moc"
