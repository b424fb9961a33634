// Whole fits of small pictures, by how near they come.
#include "fitted_pictures.h"

#include "model/painting/ryb.h"
#include "render/fitting/picture_metrics.h"
#include "render/image_io/image_io.h"
#include "tests/trials.h"

#include <QtTest>

#include <algorithm>
#include <set>

using namespace suffuse;
using namespace suffuse::fitting;

class TestFitting : public QObject {
    Q_OBJECT

private slots:
    void comesNear_data();
    void comesNear();
    void isTheSameForAnyThreads();
    void goesOn();
    void stopsAndGoesOn();
    void fewPaints();
    void onlyTheMaskCounts();
    void widths();
    void asManyAsAnErrorNeeds();
    void oneColour();
    void onePixel();
    void oddSizes_data();
    void oddSizes();
    void everyStrokeDoesSomething();
    void thePaintingIsPlayedFromLargeToSmall();
};

namespace {

FitOptions optionsOf(int strokes, int steps = 200)
{
    FitOptions out;
    out.strokes = strokes;
    out.steps = steps;
    out.threads = 1;
    return out;
}

double ratioAfter(const FitTarget &target, const FitOptions &options)
{
    Fitting fit(target, options);
    runToEnd(fit);
    return peakRatio(fit.meanSquareError());
}

} // namespace

void TestFitting::comesNear_data()
{
    QTest::addColumn<int>("style");
    QTest::addColumn<double>("perceptual");
    QTest::addColumn<double>("least");
    QTest::newRow("feathering") << int(StyleKind::Feathering) << 0.0 << 30.0;
    if (!isTried(1)) // with sanitizers one is enough
        return;
    QTest::newRow("uniform") << int(StyleKind::Uniform) << 0.0 << 28.0;
    QTest::newRow("edge") << int(StyleKind::Edge) << 0.0 << 22.0;
    QTest::newRow("perceptual") << int(StyleKind::Feathering) << 1.0 << 28.0;
}

void TestFitting::comesNear()
{
    QFETCH(int, style);
    QFETCH(double, perceptual);
    QFETCH(double, least);
    FitOptions options = optionsOf(16);
    options.limits.style = StyleKind(style);
    options.perceptual = perceptual;
    const double ratio = ratioAfter(landscape(), options);
    QVERIFY2(ratio > least, qPrintable(QString::number(ratio)));
}

void TestFitting::isTheSameForAnyThreads()
{
    std::vector<FittedStrokes> all;
    for (const int threads : {1, 2, 3, 1}) {
        FitOptions options = optionsOf(12, 60);
        options.threads = threads;
        Fitting fit(landscape(), options);
        runToEnd(fit);
        all.push_back(fit.strokes());
    }
    for (const FittedStrokes &f : all)
        QVERIFY(f.strokes == all.front().strokes); // to the last bit
    FitOptions other = optionsOf(12, 60);
    other.seed = 2;
    Fitting fit(landscape(), other);
    runToEnd(fit);
    QVERIFY(fit.strokes().strokes != all.front().strokes);
}

void TestFitting::goesOn()
{
    Fitting first(landscape(), optionsOf(8, 120));
    runToEnd(first);
    const Result<FittedStrokes> strokes = fittedStrokesOf(first.painting(), first.target());
    QVERIFY(bool(strokes));
    Fitting second(landscape(), optionsOf(16, 120), *strokes);
    QVERIFY(std::abs(peakRatio(second.meanSquareError()) - peakRatio(first.meanSquareError())) < 0.05);
    runToEnd(second);
    QVERIFY(second.strokes().strokes.size() > first.strokes().strokes.size());
    QVERIFY(second.meanSquareError() < 0.9 * first.meanSquareError());
    QVERIFY(second.strokes().background == first.strokes().background);
}

void TestFitting::stopsAndGoesOn()
{
    std::atomic<bool> stop = false;
    Fitting fit(landscape(), optionsOf(8, 60)), other(landscape(), optionsOf(8, 60));
    fit.stopWith(&stop);
    for (int i = 0; i < 10; ++i)
        QVERIFY(fit.step());
    stop = true;
    const std::vector<FitStroke> strokes = fit.strokes().strokes;
    QVERIFY(!strokes.empty());
    for (int i = 0; i < 5; ++i)
        QVERIFY(fit.step());
    QVERIFY(fit.strokes().strokes == strokes);
    QVERIFY(fit.progress() > 0 && fit.progress() < 1);
    QCOMPARE(fit.painting().strokes.size(), strokes.size());
    stop = false;
    runToEnd(fit);
    runToEnd(other);
    QVERIFY(fit.isDone() && !fit.step());
    QCOMPARE(fit.progress(), 1.0);
    QVERIFY(fit.strokes().strokes == other.strokes().strokes); // the pause has left no trace
}

void TestFitting::fewPaints()
{
    FitOptions options = optionsOf(16);
    options.paints = 3;
    Fitting fit(landscape(), options);
    runToEnd(fit);
    const Painting painting = fit.painting();
    std::set<std::array<float, 3>> colours;
    for (const StrokePtr &stroke : painting.strokes)
        for (const Segment &s : stroke->segments)
            colours.insert({s.colour.red, s.colour.yellow, s.colour.blue});
    QVERIFY(colours.size() <= 3 && colours.size() > 1);
    QCOMPARE(painting.swatches.size(), colours.size());
    for (const Swatch &swatch : painting.swatches)
        QVERIFY(swatch.linked && colours.count({swatch.colour.red, swatch.colour.yellow, swatch.colour.blue}) == 1);
    QVERIFY2(peakRatio(fit.meanSquareError()) > 20, qPrintable(QString::number(peakRatio(fit.meanSquareError()))));
}

void TestFitting::onlyTheMaskCounts()
{
    FitTarget masked = landscape();
    masked.weight = FitPicture(64, 48, 1);
    for (int y = 0; y < 48; ++y)
        for (int x = 32; x < 64; ++x)
            *masked.weight.at(x, y) = 1;
    Fitting fit(masked, optionsOf(8)), whole(landscape(), optionsOf(8));
    runToEnd(fit);
    runToEnd(whole);
    const FitPicture &target = masked.picture;
    QVERIFY(meanSquare(fit.picture(), target, masked.weight) < meanSquare(whole.picture(), target, masked.weight));
    QVERIFY(meanSquare(fit.picture(), target) > meanSquare(whole.picture(), target));
}

void TestFitting::widths()
{
    FitOptions options = optionsOf(10, 100);
    options.limits.leastWidth = 5;
    options.limits.greatestWidth = 9;
    Fitting fit(landscape(), options);
    runToEnd(fit);
    for (const FitStroke &stroke : fit.strokes().strokes) {
        const double width = widthOf(stroke, StyleKind::Feathering);
        QVERIFY2(width > 5 - 1e-9 && width < 9 + 1e-9, qPrintable(QString::number(width)));
    }
}

void TestFitting::asManyAsAnErrorNeeds()
{
    if (!isTried(1))
        QSKIP("Sanitizers take ten times as long: SUFFUSE_LONG=1 runs it.");
    FitOptions options = optionsOf(200, 300);
    options.error = 12.0 / 255;
    Fitting coarse(landscape(), options);
    runToEnd(coarse);
    QVERIFY(std::sqrt(coarse.meanSquareError()) <= options.error);
    options.error = 6.0 / 255;
    Fitting fine(landscape(), options);
    runToEnd(fine);
    QVERIFY(std::sqrt(fine.meanSquareError()) <= options.error);
    QVERIFY(coarse.strokes().strokes.size() <= fine.strokes().strokes.size());
    QVERIFY(fine.strokes().strokes.size() < 120);
}

void TestFitting::oneColour()
{
    Fitting fit(targetOf(40, 30, [](double, double) { return std::array<double, 3>{0.2, 0.5, 0.7}; }), optionsOf(8));
    runToEnd(fit);
    QVERIFY(fit.isDone());
    QVERIFY(fit.strokes().strokes.empty()); // the canvas has the colour
    QVERIFY(peakRatio(fit.meanSquareError()) > 60);
}

void TestFitting::onePixel()
{
    Fitting fit(targetOf(1, 1, [](double, double) { return std::array<double, 3>{1, 0, 0}; }), optionsOf(4));
    runToEnd(fit);
    QVERIFY(peakRatio(fit.meanSquareError()) > 60);
    QCOMPARE(fit.painting().canvas.width, 1.0);
}

void TestFitting::oddSizes_data()
{
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::newRow("a line") << 90 << 1;
    QTest::newRow("a column") << 1 << 70;
    QTest::newRow("odd") << 33 << 17;
    QTest::newRow("halved twice") << 301 << 167;
}

void TestFitting::oddSizes()
{
    QFETCH(int, width);
    QFETCH(int, height);
    const FitTarget target = landscape(width, height);
    Fitting begun(target, optionsOf(6, 60));
    const double before = begun.meanSquareError();
    runToEnd(begun);
    QVERIFY(begun.meanSquareError() < 0.5 * before);
}

void TestFitting::everyStrokeDoesSomething()
{
    // Far more strokes than two colours need.
    const FitTarget target = targetOf(32, 24, [](double x, double) {
        return x < 0.5 ? std::array<double, 3>{0.2, 0.3, 0.4} : std::array<double, 3>{0.8, 0.7, 0.3};
    });
    Fitting fit(target, optionsOf(20, 100));
    runToEnd(fit);
    const double error = fit.meanSquareError();
    const FittedStrokes all = fit.strokes();
    int idle = 0;
    for (std::size_t i = 0; i < all.strokes.size(); ++i) {
        FittedStrokes others = all;
        others.strokes.erase(others.strokes.begin() + std::ptrdiff_t(i));
        Fitting without(target, optionsOf(1), others);
        idle += std::abs(without.meanSquareError() - error) < 1e-6 * error ? 1 : 0;
    }
    QVERIFY(idle * 20 <= int(all.strokes.size()));
}

void TestFitting::thePaintingIsPlayedFromLargeToSmall()
{
    if (!isTried(1))
        QSKIP("Sanitizers take ten times as long: SUFFUSE_LONG=1 runs it.");
    const FitTarget target = landscape(96, 64);
    Fitting fit(target, optionsOf(40));
    runToEnd(fit);
    const std::vector<FitStroke> &strokes = fit.strokes().strokes;
    const std::size_t quarter = strokes.size() / 4;
    double early = 0, late = 0;
    for (std::size_t i = 0; i < quarter; ++i) {
        early += strokes[i][LogSpread];
        late += strokes[strokes.size() - 1 - i][LogSpread];
    }
    QVERIFY(early > late);
    // While it is played, it comes nearer and nearer.
    double before = 1;
    int worse = 0;
    const std::vector<std::size_t> &births = fit.strokes().births;
    QCOMPARE(births.size(), strokes.size());
    QCOMPARE(std::set<std::size_t>(births.begin(), births.end()).size(), strokes.size());
    for (std::size_t moment = 1; moment <= 10; ++moment) {
        FittedStrokes some{{}, fit.strokes().style, fit.strokes().background, {}};
        for (std::size_t i = 0; i < strokes.size(); ++i)
            if (births[i] < strokes.size() * moment / 10)
                some.strokes.push_back(strokes[i]);
        Fitting part(target, optionsOf(1), some);
        const double error = part.meanSquareError();
        worse += error > before ? 1 : 0;
        before = error;
    }
    QCOMPARE(worse, 0);
    // Strokes of the painting are born in that order, and lie in their own.
    const Painting painting = fit.painting();
    for (std::size_t i = 0; i < strokes.size(); ++i)
        QCOMPARE(painting.strokes[i]->segments.front().born, Microseconds(births[i]) * 90'000);
    // Another number of threads finds the same order.
    FitOptions alone = optionsOf(40);
    alone.threads = 1;
    Fitting again(target, alone);
    runToEnd(again);
    QCOMPARE(again.strokes().births, births);
}

QTEST_GUILESS_MAIN(TestFitting)
#include "test_fitting.moc"
