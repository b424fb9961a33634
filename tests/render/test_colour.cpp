// RYB, mixing and straight alpha of the reference.
#include "render/reference/colour.h"

#include <QtTest>

#include <random>

using namespace suffuse;
using namespace suffuse::reference;

namespace {

double distance(const std::array<double, 3> &a, const std::array<double, 3> &b)
{
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

} // namespace

class TestColour : public QObject {
    Q_OBJECT

private slots:
    void rgbRoundTripIsExact()
    {
        double worst = 0;
        for (int r = 0; r <= 40; ++r)
            for (int g = 0; g <= 40; ++g)
                for (int b = 0; b <= 40; ++b) {
                    const Rgb rgb{r / 40.0, g / 40.0, b / 40.0};
                    worst = std::max(worst, distance(rgbOfRyb(rybOfRgb(rgb)), rgb));
                }
        QVERIFY2(worst <= 1e-12, qPrintable(QString::number(worst)));
    }

    void rybRoundTripIsExact()
    {
        double worst = 0;
        for (int r = 0; r <= 40; ++r)
            for (int y = 0; y <= 40; ++y)
                for (int b = 0; b <= 40; ++b) {
                    const Ryb ryb{r / 40.0, y / 40.0, b / 40.0};
                    const Rgb rgb = rgbOfRyb(ryb);
                    QVERIFY(*std::min_element(rgb.begin(), rgb.end()) >= -1e-15);
                    QVERIFY(*std::max_element(rgb.begin(), rgb.end()) <= 1 + 1e-15);
                    worst = std::max(worst, distance(rybOfRgb(rgb), ryb));
                }
        QVERIFY2(worst <= 1e-12, qPrintable(QString::number(worst)));
    }

    void corners_data()
    {
        QTest::addColumn<QList<double>>("rgb");
        QTest::addColumn<QList<double>>("ryb");
        QTest::newRow("white") << QList<double>{1, 1, 1} << QList<double>{0, 0, 0};
        QTest::newRow("black") << QList<double>{0, 0, 0} << QList<double>{1, 1, 1};
        QTest::newRow("red") << QList<double>{1, 0, 0} << QList<double>{1, 0, 0};
        QTest::newRow("yellow") << QList<double>{1, 1, 0} << QList<double>{0, 1, 0};
        QTest::newRow("green") << QList<double>{0, 1, 0} << QList<double>{0, 1, 1};
        QTest::newRow("blue") << QList<double>{0, 0, 1} << QList<double>{0, 0, 1};
        QTest::newRow("cyan") << QList<double>{0, 1, 1} << QList<double>{0, 0.5, 1};
        QTest::newRow("magenta") << QList<double>{1, 0, 1} << QList<double>{1, 0, 0.5};
        QTest::newRow("orange") << QList<double>{1, 0.5, 0} << QList<double>{1, 1, 0};
        QTest::newRow("grey") << QList<double>{0.25, 0.25, 0.25} << QList<double>{0.75, 0.75, 0.75};
    }

    void corners()
    {
        QFETCH(QList<double>, rgb);
        QFETCH(QList<double>, ryb);
        const Rgb fromRgb{rgb[0], rgb[1], rgb[2]};
        const Ryb fromRyb{ryb[0], ryb[1], ryb[2]};
        QVERIFY(distance(rybOfRgb(fromRgb), fromRyb) < 1e-15);
        QVERIFY(distance(rgbOfRyb(fromRyb), fromRgb) < 1e-15);
    }

    /// With g′ = y + 2m, as public copies print it, cyan's pre-image would not come back.
    void thePrintedFormulaIsNotTheInverse()
    {
        const Ryb cyan = rybOfRgb({0, 1, 1});
        const double m = std::min(cyan[1], cyan[2]);
        const double wrong = (cyan[1] + 2 * m) / (std::max(cyan[1] + 2 * m, 2 * (cyan[2] - m)));
        const double wrongBlue = 2 * (cyan[2] - m) / std::max(cyan[1] + 2 * m, 2 * (cyan[2] - m));
        QVERIFY(std::abs(wrong - 1) + std::abs(wrongBlue - 1) > 0.3);
    }

    void alphaMixesLinearly()
    {
        Spot spot{{0.2, 0.4, 0.6}, 0.5};
        mix(spot, {MixMode::Alpha, 0}, {0.25, {1, 0, 0.6}});
        QVERIFY(distance(spot.colour, {0.4, 0.3, 0.6}) < 1e-15);
        QVERIFY(std::abs(spot.coverage - 0.625) < 1e-15);
    }

    void betaKeepsWhatLiesBelow()
    {
        Spot spot{{0.2, 0.4, 0.6}, 1};
        mix(spot, {MixMode::Beta, 1}, {0.5, {1, 0, 0.6}}); // β = 1: pigment only adds
        QVERIFY(distance(spot.colour, {0.7, 0.4, 0.9}) < 1e-15);
        mix(spot, {MixMode::Beta, 1}, {1, {1, 0, 0.6}});
        QVERIFY(distance(spot.colour, {1, 0.4, 1}) < 1e-15); // no darker than black
        Spot alpha{{0.2, 0.4, 0.6}, 1}, beta = alpha;
        mix(alpha, {MixMode::Alpha, 0}, {0.3, {0.1, 0.9, 0.5}});
        mix(beta, {MixMode::Beta, 0}, {0.3, {0.1, 0.9, 0.5}}); // β = 0: the same as alpha
        QVERIFY(distance(alpha.colour, beta.colour) < 1e-15);
    }

    void noPaintChangesNothing()
    {
        for (const Mix &how : {Mix{}, Mix{MixMode::Beta, 0.7f}}) {
            Spot spot{{0.2, 0.4, 0.6}, 0.5};
            mix(spot, how, {0, {1, 1, 1}});
            QCOMPARE(spot.colour, (Ryb{0.2, 0.4, 0.6}));
            QCOMPARE(spot.coverage, 0.5);
        }
    }

    void backgroundLiesOverWhite()
    {
        const Spot half = bareSpot({1, 0.5f, 0, 0.5f}, false);
        QVERIFY(distance(half.colour, {0.5, 0.25, 0}) < 1e-15);
        const auto stored = storedColour(half, false);
        QCOMPARE(stored[3], 1.0);
        const Spot bare = bareSpot({1, 0.5f, 0, 1}, true);
        QCOMPARE(bare.colour, (Ryb{0, 0, 0}));
        QCOMPARE(storedColour(bare, true), (std::array<double, 4>{0, 0, 0, 0}));
    }

    /// Laid over white, a transparent picture is the opaque one, and one stroke alone keeps its full colour.
    void transparentPicturesLieOverWhite()
    {
        std::mt19937 engine(7);
        std::uniform_real_distribution<double> any(0, 1);
        for (int i = 0; i < 20000; ++i) {
            Spot spot = bareSpot({}, true);
            for (int n = 0; n < 1 + i % 4; ++n)
                mix(spot, {}, {any(engine), {any(engine), any(engine), any(engine)}});
            const auto stored = storedColour(spot, true);
            const Rgb opaque = rgbOfRyb(spot.colour);
            for (std::size_t c = 0; c < 3; ++c) {
                const double over = stored[c] * stored[3] + (1 - stored[3]);
                QVERIFY(stored[c] >= 0 && stored[c] <= 1);
                // Equal but where straight colour had to be clamped: RYB to RGB is not linear.
                if (stored[c] > 0 && stored[c] < 1)
                    QVERIFY(std::abs(over - opaque[c]) < 1e-12);
            }
        }
        Spot spot = bareSpot({}, true);
        mix(spot, {}, {0.25, {0, 0, 1}});
        const auto stored = storedColour(spot, true);
        QVERIFY(distance({stored[0], stored[1], stored[2]}, {0, 0, 1}) < 1e-12);
        QVERIFY(std::abs(stored[3] - 0.25) < 1e-15);
    }
};

QTEST_GUILESS_MAIN(TestColour)
#include "test_colour.moc"
