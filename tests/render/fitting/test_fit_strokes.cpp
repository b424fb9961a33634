// Strokes as 27 numbers: their derivatives, where new ones begin, what each is good for, their painting.
#include "fitted_pictures.h"

#include "render/backends.h"
#include "render/fitting/error_strokes.h"
#include "render/fitting/picture_metrics.h"
#include "render/fitting/stroke_removal.h"

#include <QtTest>

using namespace suffuse;
using namespace suffuse::fitting;

class TestFitStrokes : public QObject {
    Q_OBJECT

private slots:
    void slopesOfAllNumbers_data();
    void slopesOfAllNumbers();
    void numbersStayInTheirDomains();
    void newStrokesLieAlongRidges();
    void newStrokesTakeTheColourThere();
    void whatARemovalCosts();
    void paintingsAndBack();
    void renderersDrawWhatIsFitted_data();
    void renderersDrawWhatIsFitted();
    void othersPaintingsAreRefused();
};

namespace {

/// A stroke through the middle of 64 × 48 pixels.
FitStroke bentStroke(StyleKind style, double shift = 0)
{
    FitStroke out{};
    for (std::size_t i = 0; i < strokePoints; ++i) {
        out[2 * i] = 12 + 4.3 * double(i) + shift;
        out[2 * i + 1] = 24 + 7 * std::sin(double(i)) + shift;
    }
    out[LogSpread] = std::log(5.0);
    out[LogPeak] = std::log(1.7);
    out[LogSteepness] = std::log(style == StyleKind::Feathering ? 1.6 : style == StyleKind::Uniform ? 0.06 : 0.9);
    out[Red] = 0.7, out[Yellow] = 0.35, out[Blue] = 0.1;
    out[Opacity] = 0.8;
    return out;
}

const Colour ground{0.2f, 0.1f, 0.35f, 1};

View viewOf(int width, int height)
{
    return View::ofArea(Rect::of(0, 0, width, height), width, height);
}

template <typename Number>
double lossOf(gradient::SceneGradient<Number> &gradient, const gradient::FlatScene &scene)
{
    double sum = 0;
    std::size_t i = 0;
    for (const Number v : gradient.draw(scene))
        sum += double(v) * std::sin(0.37 * double(i++));
    return sum;
}

FitPicture drawn(const std::vector<FitStroke> &strokes, StyleKind style, int width, int height)
{
    gradient::SceneGradient<float> gradient;
    const gradient::FlatScene scene = sceneOf(strokes, style, ground, viewOf(width, height));
    gradient.choose(scene);
    FitPicture out(width, height, 3);
    const std::span<const float> values = gradient.draw(scene);
    std::copy(values.begin(), values.end(), out.values.begin());
    return out;
}

} // namespace

void TestFitStrokes::slopesOfAllNumbers_data()
{
    QTest::addColumn<int>("style");
    QTest::newRow("feathering") << int(StyleKind::Feathering);
    QTest::newRow("uniform") << int(StyleKind::Uniform);
}

void TestFitStrokes::slopesOfAllNumbers()
{
    QFETCH(int, style);
    const auto kind = StyleKind(style);
    const std::vector<FitStroke> strokes{bentStroke(kind), bentStroke(kind, 5)};
    gradient::SceneGradient<double> gradient;
    const gradient::FlatScene scene = sceneOf(strokes, kind, ground, viewOf(64, 48));
    gradient.choose(scene, {1e-9}); // else what is not seen comes and goes with the numbers
    gradient.draw(scene);
    std::vector<double> by(64 * 48 * 3);
    for (std::size_t i = 0; i < by.size(); ++i)
        by[i] = std::sin(0.37 * double(i));
    const std::vector<StrokeSlope> slopes = slopesOf(gradient.backward(by), scene, strokes);
    double greatest = 0;
    for (const double v : slopes[0])
        greatest = std::max(greatest, std::abs(v));
    for (std::size_t k = 0; k < strokeNumbers; ++k) {
        const double h = 1e-4;
        std::vector<FitStroke> up = strokes, down = strokes;
        up[0][k] += h, down[0][k] -= h;
        const double expected = (lossOf(gradient, sceneOf(up, kind, ground, scene.view)) -
                                 lossOf(gradient, sceneOf(down, kind, ground, scene.view))) /
                                (2 * h);
        QVERIFY2(std::abs(expected - slopes[0][k]) < 1e-3 * std::abs(expected) + 1e-5 * greatest,
                 qPrintable(QString("number %1: %2 %3").arg(k).arg(slopes[0][k]).arg(expected)));
    }
}

void TestFitStrokes::numbersStayInTheirDomains()
{
    for (const StyleKind style : {StyleKind::Feathering, StyleKind::Uniform, StyleKind::Edge}) {
        FitStroke stroke = bentStroke(style);
        stroke[LogSpread] = 9, stroke[LogPeak] = 20, stroke[LogSteepness] = -7, stroke[Red] = 1.4, stroke[Blue] = -0.1;
        FitLimits limits;
        limits.style = style;
        limits.leastWidth = 6, limits.greatestWidth = 12;
        keepWithin(stroke, limits);
        QVERIFY(widthOf(stroke, style) <= 12 * (1 + 1e-12));
        stroke[LogSpread] = -9;
        keepWithin(stroke, limits);
        QVERIFY(widthOf(stroke, style) >= 6 * (1 - 1e-12));
        QCOMPARE(stroke[Red], 1.0);
        QCOMPARE(stroke[Blue], 0.0);
        const gradient::FlatScene scene = sceneOf({stroke}, style, ground, viewOf(8, 8));
        const double steep = scene.strokes[0].xi[1];
        QVERIFY(steep > 0 && (style != StyleKind::Feathering || steep >= 0.5));
        QVERIFY(style != StyleKind::Edge || (steep <= std::cbrt(2.0) && scene.strokes[0].xi[2] > 0));
        const FitStroke once = stroke;
        keepWithin(stroke, limits);
        for (std::size_t k = 0; k < strokeNumbers; ++k)
            QVERIFY(std::abs(stroke[k] - once[k]) < 1e-12);
        // Nobody could take hold of what lies far beyond the sheet.
        stroke[FirstPoint] = -500, stroke[FirstPoint + 1] = 7, stroke[FirstPoint + 19] = 900;
        FitStroke kept = stroke;
        keepWithin(kept, limits);
        QCOMPARE(kept[FirstPoint], -500.0);
        limits.width = 40, limits.height = 30;
        keepWithin(kept, limits);
        const double beyond = std::exp(kept[LogSpread]);
        QVERIFY(kept[FirstPoint] >= -2 * beyond && kept[FirstPoint] < 0 && kept[FirstPoint + 1] == 7);
        QVERIFY(kept[FirstPoint + 19] <= 30 + 2 * beyond && kept[FirstPoint + 19] >= 30);
    }
}

void TestFitStrokes::newStrokesLieAlongRidges()
{
    const double angle = 0.6; // of a bright bar across the middle
    const FitTarget target = targetOf(96, 96, [&](double x, double y) {
        const double u = (x - 0.5) * std::cos(angle) + (y - 0.5) * std::sin(angle),
                     v = -(x - 0.5) * std::sin(angle) + (y - 0.5) * std::cos(angle);
        const double bar = std::exp(-std::pow(v / 0.05, 2) - std::pow(u / 0.3, 8));
        return std::array<double, 3>{bar, bar, bar};
    });
    const FitPicture black(96, 96, 3);
    const std::vector<FitStroke> strokes = strokesForError({target.picture, black, {}, 1}, 1, {}, 1);
    QCOMPARE(strokes.size(), std::size_t(1));
    const FitStroke &s = strokes[0];
    const double along = std::atan2(s[19] - s[1], s[18] - s[0]);
    const double turn = std::remainder(along - angle, 3.14159265358979);
    QVERIFY2(std::abs(turn) < 0.2, qPrintable(QString::number(turn)));
    // Its middle lies on the bar.
    const double x = (s[8] + s[10]) / 2 - 48, y = (s[9] + s[11]) / 2 - 48;
    QVERIFY(std::abs(-x * std::sin(angle) + y * std::cos(angle)) < 4);
    QVERIFY(std::exp(s[LogSpread]) > 2 && std::exp(s[LogSpread]) < 12);
}

void TestFitStrokes::newStrokesTakeTheColourThere()
{
    const FitTarget target = landscape();
    FitPicture drawnSky = target.picture, weight(64, 48, 1);
    std::fill(weight.values.begin(), weight.values.end(), 1.0f);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            for (int c = 0; c < 3; ++c)
                drawnSky.at(x, y)[c] = landscape().picture.at(2, y)[c];
    const ErrorView view{target.picture, drawnSky, weight, 1};
    const std::vector<FitStroke> strokes = strokesForError(view, 6, {}, 3);
    QCOMPARE(strokes.size(), std::size_t(6));
    for (std::size_t i = 1; i < strokes.size(); ++i)
        QVERIFY(strokes[i][LogSpread] <= strokes[i - 1][LogSpread]);
    const bool anyRed = std::any_of(strokes.begin(), strokes.end(), [](const FitStroke &s) {
        return std::hypot(s[8] - 0.7 * 64, s[9] - 0.3 * 48) < 8 && s[Red] > s[Blue] + 0.2;
    });
    QVERIFY(anyRed);
    QVERIFY(strokes == strokesForError(view, 6, {}, 3));
    // What does not count gets no stroke.
    std::fill(weight.values.begin(), weight.values.end(), 0.0f);
    QVERIFY(strokesForError(view, 6, {}, 3).empty());
    QVERIFY(strokesForError({target.picture, target.picture, {}, 1}, 6, {}, 3).empty());
}

void TestFitStrokes::whatARemovalCosts()
{
    const StyleKind style = StyleKind::Feathering;
    std::vector<FitStroke> strokes{bentStroke(style), bentStroke(style, 6), bentStroke(style, -9),
                                   bentStroke(style, 300)};
    strokes[1][Blue] = 0.9;
    const FitTarget target = landscape();
    const FitPicture none;
    const View view = viewOf(64, 48);
    const std::vector<double> costs =
        errorsWithout(strokes, {0, 1, 2, 3}, style, ground, {target.picture, none, view}, Threads(2));
    const auto gradient = gradient::makeCpuDifferentiator(Threads(1));
    const gradient::FlatScene scene = sceneOf(strokes, style, ground, viewOf(64, 48));
    gradient->choose(scene);
    const std::vector<double> rough = roughErrorsWithout(*gradient, scene, {target.picture, none, view}, 1);
    const double with = meanSquare(drawn(strokes, style, 64, 48), target.picture) * 64 * 48 * 3;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        std::vector<FitStroke> others = strokes;
        others.erase(others.begin() + std::ptrdiff_t(i));
        const double without = meanSquare(drawn(others, style, 64, 48), target.picture) * 64 * 48 * 3;
        QVERIFY2(std::abs(without - with - costs[i]) < 1e-3 * (1 + std::abs(costs[i])),
                 qPrintable(QString("stroke %1: %2 %3").arg(i).arg(costs[i]).arg(without - with)));
        QVERIFY2(std::abs(rough[i] - costs[i]) < 0.5 * std::abs(costs[i]) + 0.1 * with,
                 qPrintable(QString("stroke %1: %2 %3").arg(i).arg(rough[i]).arg(costs[i])));
    }
    QCOMPARE(costs[3], 0.0); // it lies outside
}

void TestFitStrokes::paintingsAndBack()
{
    FitTarget target = landscape();
    target.canvasWidth = 128, target.canvasHeight = 96; // two units a pixel
    const FittedStrokes fitted{
        {bentStroke(StyleKind::Uniform), bentStroke(StyleKind::Uniform, 3)}, StyleKind::Uniform, ground};
    const Painting painting = paintingOf(fitted, target, {ground});
    QCOMPARE(painting.strokes.size(), std::size_t(2));
    QCOMPARE(painting.canvas.width, 128.0);
    QCOMPARE(painting.swatches.size(), std::size_t(1));
    QVERIFY(painting.strokes[0]->born() < painting.strokes[1]->born());
    const Result<FittedStrokes> back = fittedStrokesOf(painting, target);
    QVERIFY2(bool(back), qPrintable(back ? QString() : back.error()));
    QCOMPARE(back->style, StyleKind::Uniform);
    QVERIFY(back->background == ground);
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t k = 0; k < strokeNumbers; ++k)
            QVERIFY2(std::abs(back->strokes[i][k] - fitted.strokes[i][k]) < 1e-5,
                     qPrintable(QString("number %1: %2").arg(k).arg(back->strokes[i][k])));
}

void TestFitStrokes::renderersDrawWhatIsFitted_data()
{
    QTest::addColumn<int>("style");
    QTest::newRow("feathering") << int(StyleKind::Feathering);
    QTest::newRow("uniform") << int(StyleKind::Uniform);
    QTest::newRow("edge") << int(StyleKind::Edge);
}

void TestFitStrokes::renderersDrawWhatIsFitted()
{
    QFETCH(int, style);
    const FitTarget target = landscape();
    std::vector<FitStroke> strokes;
    for (int i = 0; i < 6; ++i) {
        strokes.push_back(bentStroke(StyleKind(style), 7.0 * i - 21));
        strokes.back()[Blue] = 0.15 * i;
        strokes.back()[LogPeak] = 0.1 + 0.3 * i;
    }
    RenderRequest request;
    request.painting = std::make_shared<const Painting>(paintingOf({strokes, StyleKind(style), ground}, target));
    request.time = request.painting->end();
    request.view = viewOf(64, 48);
    FloatPicture picture;
    const auto renderer = makeRenderer({Backend::Cpu});
    QVERIFY(bool(renderer) && bool((*renderer)->render(request, picture)));
    const FitPicture fitted = drawn(strokes, StyleKind(style), 64, 48);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            for (int c = 0; c < 3; ++c)
                QVERIFY2(std::abs(picture.at(x, y)[c] - fitted.at(x, y)[c]) < 1.0f / 256,
                         qPrintable(
                             QString("%1, %2: %3 %4").arg(x).arg(y).arg(picture.at(x, y)[c]).arg(fitted.at(x, y)[c])));
}

void TestFitStrokes::othersPaintingsAreRefused()
{
    const FitTarget target = landscape();
    const Painting painting = paintingOf({{bentStroke(StyleKind::Feathering)}, StyleKind::Feathering, ground}, target);
    const auto refused = [&](auto change) {
        Painting other = painting;
        auto stroke = std::make_shared<Stroke>(*painting.strokes[0]);
        change(*stroke, other);
        other.strokes = StrokeList{stroke};
        return !fittedStrokesOf(other, target);
    };
    QVERIFY(!refused([](Stroke &, Painting &) {}));
    QVERIFY(refused([](Stroke &s, Painting &) { s.segments.pop_back(); }));
    QVERIFY(refused([](Stroke &s, Painting &) { s.segments[1].colour.red += 0.1f; }));
    QVERIFY(refused([](Stroke &s, Painting &) { s.segments[2].diffusion *= 2; }));
    QVERIFY(refused([](Stroke &s, Painting &) { s.mix = {MixMode::Beta, 0.5f}; }));
    QVERIFY(refused([](Stroke &, Painting &p) { p.canvas.width = 65; }));
}

QTEST_GUILESS_MAIN(TestFitStrokes)
#include "test_fit_strokes.moc"
