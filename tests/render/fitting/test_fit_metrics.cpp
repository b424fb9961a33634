// How near pictures come to each other, and how they are averaged, blurred and compared.
#include "fitted_pictures.h"

#include "render/fitting/picture_metrics.h"

#include <QtTest>

#include <numeric>

using namespace suffuse;
using namespace suffuse::fitting;

class TestFitMetrics : public QObject {
    Q_OBJECT

private slots:
    void meansOfAreas();
    void blurOfAPoint();
    void peakRatios();
    void weightedErrors();
    void similarityOfConstants();
    void similarityByItsDefinition();
    void scalesBySize_data();
    void scalesBySize();
    void lossesAndTheirSlopes_data();
    void lossesAndTheirSlopes();
};

namespace {

FitPicture constantPicture(int width, int height, float value)
{
    FitPicture out(width, height, 3);
    std::fill(out.values.begin(), out.values.end(), value);
    return out;
}

/// Values that look random and are the same each time.
FitPicture noise(int width, int height, double seed)
{
    FitPicture out(width, height, 3);
    for (std::size_t i = 0; i < out.values.size(); ++i) {
        const double v = std::sin(double(i) * 12.9898 + seed) * 43758.5453;
        out.values[i] = float(v - std::floor(v));
    }
    return out;
}

} // namespace

void TestFitMetrics::meansOfAreas()
{
    FitPicture line(5, 1, 1);
    line.values = {1, 2, 3, 4, 5};
    const FitPicture two = averaged(line, 2, 1);
    QCOMPARE(two.width, 2);
    // Of 2½ pixels each: (1 + 2 + 3/2)/2.5 and (3/2 + 4 + 5)/2.5.
    QVERIFY(std::abs(two.values[0] - 1.8f) < 1e-6f);
    QVERIFY(std::abs(two.values[1] - 4.2f) < 1e-6f);
    const FitPicture picture = noise(37, 23, 1), small = averaged(picture, 10, 7), one = averaged(picture, 1, 1);
    const double mean =
        std::accumulate(picture.values.begin(), picture.values.end(), 0.0) / double(picture.values.size());
    QVERIFY(std::abs(std::accumulate(small.values.begin(), small.values.end(), 0.0) / 210 - mean) < 1e-5);
    QVERIFY(std::abs(std::accumulate(one.values.begin(), one.values.end(), 0.0) / 3 - mean) < 1e-5);
    QVERIFY(averaged(picture, 37, 23).values == picture.values);
}

void TestFitMetrics::blurOfAPoint()
{
    for (const double deviation : {1.5, 3.0, 6.0}) {
        FitPicture point(81, 81, 1);
        *point.at(40, 40) = 1;
        const FitPicture out = blurred(point, deviation);
        double sum = 0, square = 0;
        for (int y = 0; y < 81; ++y)
            for (int x = 0; x < 81; ++x) {
                sum += *out.at(x, y);
                square += double(*out.at(x, y)) * (x - 40) * (x - 40);
            }
        QVERIFY(std::abs(sum - 1) < 1e-4);
        QVERIFY2(std::abs(std::sqrt(square) - deviation) < 0.3, qPrintable(QString::number(std::sqrt(square))));
        QVERIFY(std::abs(*out.at(40, 45) - *out.at(35, 40)) < 1e-6f);
    }
}

void TestFitMetrics::peakRatios()
{
    const FitPicture a = constantPicture(8, 6, 0.5f), b = constantPicture(8, 6, 0.6f);
    QVERIFY(std::abs(meanSquare(a, b) - 0.01) < 1e-7);
    QVERIFY(std::abs(peakRatio(meanSquare(a, b)) - 20) < 1e-4);
    QVERIFY(std::abs(peakRatio(1) - 0) < 1e-12);
    QVERIFY(std::abs(peakRatio(meanSquare(a, a)) - 99) < 1e-9);
}

void TestFitMetrics::weightedErrors()
{
    const FitPicture a = constantPicture(2, 1, 0);
    FitPicture b = a, weight(2, 1, 1);
    b.at(0, 0)[0] = 0.3f;
    b.at(1, 0)[2] = 0.6f;
    weight.values = {1, 0.5f};
    QVERIFY(std::abs(meanSquare(a, b, weight) - (0.09 + 0.5 * 0.36) / (1.5 * 3)) < 1e-7);
}

void TestFitMetrics::similarityOfConstants()
{
    // Without contrast only the luminance of the last scale differs.
    const double u = 0.3, v = 0.5, luminance = (2 * u * v + 1e-4) / (u * u + v * v + 1e-4);
    const SimilarityAtScales s =
        multiScaleSimilarity(constantPicture(200, 180, float(u)), constantPicture(200, 180, float(v)));
    QCOMPARE(s.scales, 5);
    QVERIFY(std::abs(s.value - std::pow(luminance, 0.1333 / 1.0001)) < 1e-5);
    const FitPicture picture = noise(200, 180, 2);
    QVERIFY(std::abs(multiScaleSimilarity(picture, picture).value - 1) < 1e-12);
}

/// A picture of 11 × 11 pixels has one window and one scale: SSIM by its definition, as one sum over the window.
void TestFitMetrics::similarityByItsDefinition()
{
    const FitPicture a = noise(11, 11, 3);
    FitPicture b = noise(11, 11, 4); // not all unlike: a negative similarity counts as 0
    for (std::size_t i = 0; i < b.values.size(); ++i)
        b.values[i] = 0.4f * b.values[i] + 0.5f * a.values[i];
    double expected = 0, weights = 0;
    const auto weight = [](int x, int y) { return std::exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / 4.5); };
    for (int y = 0; y < 11; ++y)
        for (int x = 0; x < 11; ++x)
            weights += weight(x, y);
    for (int c = 0; c < 3; ++c) {
        double mu = 0, mv = 0, uu = 0, vv = 0, uv = 0;
        for (int y = 0; y < 11; ++y)
            for (int x = 0; x < 11; ++x) {
                const double w = weight(x, y) / weights, u = double(a.at(x, y)[c]), v = double(b.at(x, y)[c]);
                mu += w * u, mv += w * v, uu += w * u * u, vv += w * v * v, uv += w * u * v;
            }
        expected += (2 * mu * mv + 1e-4) * (2 * (uv - mu * mv) + 9e-4) /
                    ((mu * mu + mv * mv + 1e-4) * (uu - mu * mu + vv - mv * mv + 9e-4)) / 3;
    }
    const SimilarityAtScales s = multiScaleSimilarity(a, b);
    QCOMPARE(s.scales, 1);
    QVERIFY2(std::abs(s.value - expected) < 1e-9, qPrintable(QString("%1 %2").arg(s.value).arg(expected)));
}

void TestFitMetrics::scalesBySize_data()
{
    QTest::addColumn<int>("side");
    QTest::addColumn<int>("scales");
    QTest::newRow("large") << 400 << 5;
    QTest::newRow("just five") << 176 << 5;
    QTest::newRow("just not") << 175 << 4;
    QTest::newRow("one") << 11 << 1;
    QTest::newRow("smaller than the window") << 10 << 0;
}

void TestFitMetrics::scalesBySize()
{
    QFETCH(int, side);
    QFETCH(int, scales);
    const FitPicture picture = noise(side, side + 3, 5);
    QCOMPARE(multiScaleSimilarity(picture, picture).scales, scales);
    QVERIFY(std::abs(multiScaleSimilarity(picture, picture).value - 1) < 1e-9);
}

void TestFitMetrics::lossesAndTheirSlopes_data()
{
    QTest::addColumn<double>("perceptual");
    QTest::newRow("encoded values") << 0.0;
    QTest::newRow("as people see it") << 1.0;
    QTest::newRow("both") << 0.4;
}

void TestFitMetrics::lossesAndTheirSlopes()
{
    QFETCH(double, perceptual);
    FitPicture weight(6, 4, 1);
    for (std::size_t p = 0; p < weight.pixels(); ++p)
        weight.values[p] = float(p % 3) / 2;
    const FitPicture drawn = noise(6, 4, 7);
    const FitLoss loss(noise(6, 4, 6), weight, perceptual);
    for (std::size_t p = 0; p < 24; ++p) {
        std::array<float, 3> rgb{}, by{};
        for (std::size_t c = 0; c < 3; ++c)
            rgb[c] = 0.1f + 0.8f * drawn.values[3 * p + c];
        loss.differentiate(p, 1, rgb.data(), by.data());
        for (std::size_t c = 0; c < 3; ++c) {
            const float h = 1e-2f;
            std::array<float, 3> up = rgb, down = rgb;
            up[c] += h, down[c] -= h;
            const double expected = (loss.at(p, up.data()) - loss.at(p, down.data())) / double(up[c] - down[c]);
            QVERIFY2(std::abs(expected - double(by[c])) < 0.02 * (std::abs(expected) + 0.1),
                     qPrintable(QString("pixel %1: %2 %3").arg(p).arg(by[c]).arg(expected)));
        }
    }
}

QTEST_GUILESS_MAIN(TestFitMetrics)
#include "test_fit_metrics.moc"
