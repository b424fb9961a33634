// Diffusion curves whose pictures are known: harmonic functions, edges that are blurred, and curves made to harm.
#include "render/curves/curve_links.h"
#include "render/curves/laplace_solver.h"
#include "render/curves/solved_curves.h"
#include "render/curves/varying_blur.h"
#include "render/fitting/fit_picture.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace suffuse;
using namespace suffuse::curves;

namespace {

constexpr CurveColour black{0, 0, 0}, white{1, 1, 1}, orange{0.9, 0.5, 0.1}, blue{0.1, 0.2, 0.7};

DiffusionCurve curveOf(std::vector<Point> points, const CurveColour &left, const CurveColour &right, double blur = 0)
{
    DiffusionCurve curve;
    curve.points = std::move(points);
    curve.left.add(0, left);
    curve.right.add(0, right);
    curve.blur.add(0, blur);
    return curve;
}

DiffusionCurve line(Point from, Point to, const CurveColour &left, const CurveColour &right, double blur = 0)
{
    return curveOf({from, from + (1.0 / 3) * (to - from), from + (2.0 / 3) * (to - from), to}, left, right, blur);
}

/// Four cubics, so near to a circle that the greatest difference is 0.0003 radii. It runs so that its inside is at the
/// right hand of who walks along it.
DiffusionCurve circle(Point middle, double radius, const CurveColour &inside, const CurveColour &outside)
{
    const double k = 4 * (std::numbers::sqrt2 - 1) / 3;
    std::vector<Point> points;
    for (int quarter = 0; quarter < 4; ++quarter) {
        const double a = quarter * std::numbers::pi / 2;
        const Point u{std::cos(a), std::sin(a)}, v{-std::sin(a), std::cos(a)}; // clockwise, seen with y downwards
        for (const Point p : {u, u + k * v, v + k * u})
            points.push_back(middle + radius * p);
    }
    points.push_back(points.front());
    return curveOf(std::move(points), outside, inside);
}

const float *at(const SolvedCurves &picture, int x, int y)
{
    return picture.rgb.data() + 3 * (std::size_t(y) * std::size_t(picture.width) + std::size_t(x));
}

double farthest(const SolvedCurves &picture, int x, int y, const CurveColour &colour)
{
    double out = 0;
    for (std::size_t c = 0; c < 3; ++c)
        out = std::max(out, std::abs(double(at(picture, x, y)[c]) - colour[c]));
    return out;
}

} // namespace

class TestCurvePictures : public QObject {
    Q_OBJECT

private slots:
    /// Above and below a line from border to border nothing but its colours solves the equation.
    void lineAcross()
    {
        const SolvedCurves picture = solvedCurves({60, 40, {line({-5, 17.3}, {65, 21.9}, orange, blue)}}, 60, 40);
        QCOMPARE(picture.width, 60);
        QCOMPARE(picture.height, 40);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 60; ++x) {
                const double below = y + 0.5 - (17.3 + (x + 5.5) * (21.9 - 17.3) / 70);
                if (std::abs(below) > 1)
                    QVERIFY2(farthest(picture, x, y, below < 0 ? orange : blue) < 1e-3,
                             qPrintable(QStringLiteral("%1 %2").arg(x).arg(y)));
            }
    }

    void oneColourEverywhere()
    {
        CurveSet set{50, 50, {circle({20, 22}, 11, orange, orange), line({3, 45}, {47, 30}, orange, orange)}};
        const SolvedCurves picture = solvedCurves(set, 50, 50);
        for (int y = 0; y < 50; ++y)
            for (int x = 0; x < 50; ++x)
                QVERIFY(farthest(picture, x, y, orange) < 1e-3);
    }

    /// Between two circles the harmonic function is that of the logarithm of the radius; inside of the inner one and
    /// outside of the outer one it is constant.
    void betweenCircles()
    {
        constexpr int size = 120;
        const Point middle{60.2, 59.7};
        const double inner = 15, outer = 50;
        const SolvedCurves picture = solvedCurves(
            {size, size, {circle(middle, inner, orange, white), circle(middle, outer, black, blue)}}, size, size);
        double worst = 0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const double r = length(Point{x + 0.5, y + 0.5} - middle);
                const double value = 1 - std::log(r / inner) / std::log(outer / inner);
                if (r < inner - 1)
                    worst = std::max(worst, farthest(picture, x, y, orange));
                else if (r > outer + 1)
                    worst = std::max(worst, farthest(picture, x, y, blue));
                else if (r > inner + 1 && r < outer - 1)
                    worst = std::max(worst, farthest(picture, x, y, {value, value, value}));
            }
        QVERIFY2(worst < 2e-3, qPrintable(QString::number(worst)));
    }

    /// Colours that change along a closed curve: r cos α is harmonic, so inside it comes from its own values.
    void coloursAlongTheCurve()
    {
        constexpr int size = 80;
        DiffusionCurve curve = circle({40, 40}, 30, black, black);
        curve.right = {};
        for (int k = 0; k <= 64; ++k) {
            const double v = 0.5 + 0.4 * std::cos(k * std::numbers::pi / 32);
            curve.right.add(k * 4 * curveStopsPerCubic / 64, {v, 1 - v, 0.5});
        }
        const SolvedCurves picture = solvedCurves({size, size, {curve}}, size, size);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                if (const Point p{x + 0.5 - 40, y + 0.5 - 40}; length(p) < 28) {
                    const double v = 0.5 + 0.4 * p.x / 30;
                    // The cubics' parameter is not quite the angle.
                    QVERIFY2(farthest(picture, x, y, {v, 1 - v, 0.5}) < 4e-3,
                             qPrintable(QStringLiteral("%1 %2").arg(x).arg(y)));
                }
    }

    /// Around an open curve colours meet halfway.
    void openCurve()
    {
        const SolvedCurves picture = solvedCurves({60, 60, {line({20, 30}, {40, 30}, white, black)}}, 60, 60);
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 60; ++x) {
                const double v = double(at(picture, x, y)[0]);
                QVERIFY(v >= 0 && v <= 1);
                QVERIFY2(std::abs(v + double(at(picture, x, 59 - y)[0]) - 1) < 2e-3, "the mirror image");
            }
        QVERIFY(at(picture, 30, 28)[0] > 0.9f && at(picture, 30, 31)[0] < 0.1f);
        QVERIFY(at(picture, 2, 2)[0] > 0.5f && at(picture, 2, 2)[0] < 0.75f);
    }

    void blur_data()
    {
        QTest::addColumn<double>("deviation");
        QTest::newRow("narrow") << 1.5;
        QTest::newRow("of a smaller picture") << 9.0;
    }
    /// An edge that is blurred by a Gaussian is its integral.
    void blur()
    {
        QFETCH(const double, deviation);
        const SolvedCurves picture =
            solvedCurves({100, 20, {line({50, -9}, {50, 29}, black, white, deviation)}}, 100, 20);
        double worst = 0;
        for (int x = int(50 - 3 * deviation); x < int(50 + 3 * deviation); ++x) {
            const double value = 0.5 * std::erfc((x + 0.5 - 50) / (deviation * std::numbers::sqrt2));
            worst = std::max(worst, farthest(picture, x, 10, {value, value, value}));
        }
        QVERIFY2(worst < 6e-3, qPrintable(QString::number(worst)));
    }

    /// Where one curve is sharp and another one soft, the blur goes over from one to the other.
    void blurDiffuses()
    {
        const CurveSet set{
            90, 20, {line({20, -9}, {20, 29}, white, black, 0), line({70, -9}, {70, 29}, white, black, 6)}};
        const SolvedCurves picture = solvedCurves(set, 90, 20);
        QVERIFY(farthest(picture, 18, 10, black) < 0.01 && farthest(picture, 21, 10, white) < 0.1);
        QVERIFY(at(picture, 68, 10)[0] > 0.3f && at(picture, 72, 10)[0] < 0.7f);
    }

    void pictureOfOneValueStaysWhatItIs()
    {
        const std::vector<float> grey(3 * 33 * 17, 0.25f), deviation(33 * 17, 50.0f);
        for (const float v : blurredBy(grey, deviation, 33, 17))
            QVERIFY(std::abs(v - 0.25f) < 1e-5f);
    }

    void stepsHardlyGrowWithThePicture()
    {
        for (const int size : {64, 512}) {
            const CurveLinks links = linksOf({1, 1, {circle({0.3, 0.4}, 0.1, white, black)}}, size, size);
            const LaplaceSolver solver(size, size, links.right, links.down, links.anchors);
            std::vector<float> u(links.pixels());
            const int steps = solver.solve(links.sources[0], u);
            QVERIFY2(steps <= 25, qPrintable(QStringLiteral("%1: %2").arg(size).arg(steps)));
        }
    }

    void theSameBitsForAnyThreads()
    {
        const CurveSet set{40, 30, {circle({18, 14}, 9, orange, blue), line({2, 3}, {37, 25}, white, black, 2)}};
        QVERIFY(solvedCurves(set, 40, 30, 1).rgb == solvedCurves(set, 40, 30, 3).rgb);
    }

    void hostileNumbers_data()
    {
        QTest::addColumn<std::vector<Point>>("points");
        const auto row = [](const char *name, std::vector<Point> points) { QTest::newRow(name) << points; };
        row("a point", {{5, 5}, {5, 5}, {5, 5}, {5, 5}});
        row("between pixels", {{5.55, 5.55}, {5.6, 5.55}, {5.6, 5.6}, {5.6, 5.65}});
        row("far away", {{900, 5}, {920, 5}, {940, 5}, {960, 9}});
        row("from end to end of the world", {{-1e6, -1e6}, {1e6, -1e6}, {-1e6, 1e6}, {1e6, 1e6}});
        row("on centres of pixels", {{2.5, 2.5}, {4.5, 2.5}, {6.5, 2.5}, {8.5, 2.5}});
        row("along the border", {{0, 0}, {0, 4}, {0, 7}, {0, 10}});
        row("there and back", {{1, 5}, {9, 5}, {9, 5}, {1, 5}});
    }
    void hostileNumbers()
    {
        QFETCH(const std::vector<Point>, points);
        for (const double blur : {0.0, 1e6}) {
            const SolvedCurves picture = solvedCurves({10, 10, {curveOf(points, orange, blue, blur)}}, 10, 10);
            QCOMPARE(picture.rgb.size(), std::size_t(300));
            for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
                const double least = std::min(orange[i % 3], blue[i % 3]), most = std::max(orange[i % 3], blue[i % 3]);
                QVERIFY(double(picture.rgb[i]) > least - 2e-3 && double(picture.rgb[i]) < most + 2e-3);
            }
        }
    }

    void picturesWithoutSizeOrCurves()
    {
        QVERIFY(problemOf(CurveSet{0, 10, {line({0, 0}, {1, 1}, black, white)}}).contains("0 × 10"));
        QVERIFY(problemOf(CurveSet{-3, 10, {line({0, 0}, {1, 1}, black, white)}}).contains("must be 1"));
        QVERIFY(problemOf(CurveSet{10, 10, {}}).contains("no curves"));
        QVERIFY(problemOf(CurveSet{1, 1, {line({0, 0}, {1, 1}, black, white)}}).isEmpty());
        QVERIFY(farthest(solvedCurves({1, 1, {line({0, 9}, {1, 9}, orange, orange)}}, 1, 1), 0, 0, orange) < 1e-6);
    }

    /// A file is found by what it holds, whatever its name, and is solved no larger than asked for.
    void filesArePicturesOfFits()
    {
        const QByteArray file =
            "<!DOCTYPE CurveSetXML><curve_set image_width=\"1000000\" image_height=\"500000\" nb_curves=\"1\"><curve>"
            "<control_points_set><control_point x=\"250000\" y=\"-1\"/><control_point x=\"250000\" y=\"300000\"/>"
            "<control_point x=\"250000\" y=\"600000\"/><control_point x=\"250000\" y=\"1000000\"/></control_points_set>"
            "<left_colors_set><left_color R=\"0\" G=\"0\" B=\"255\" globalID=\"0\"/></left_colors_set>"
            "<right_colors_set><right_color R=\"255\" G=\"0\" B=\"0\" globalID=\"0\"/></right_colors_set>"
            "</curve></curve_set>";
        const Result<fitting::FitTarget> target = fitting::readFitTarget(file, QStringLiteral("a.png"), 5000);
        QVERIFY2(target, target ? "" : qPrintable(target.error()));
        QCOMPARE(target->canvasWidth, 1e6);
        QCOMPARE(target->picture.width, 100);
        QCOMPARE(target->picture.height, 50);
        // Called blue, it is red; it lies above, which is left of a line that goes to the right.
        QVERIFY(target->picture.at(50, 3)[0] > 0.99f && target->picture.at(50, 3)[2] < 0.01f);
        QVERIFY(target->picture.at(50, 46)[0] < 0.01f && target->picture.at(50, 46)[2] > 0.99f);
        const Result<fitting::FitTarget> broken = fitting::readFitTarget(QByteArray(file).chopped(30), "b.xml");
        QVERIFY(!broken && broken.error().startsWith("b.xml: line 1"));
        const std::atomic<bool> cancel = true;
        QVERIFY(!fitting::readFitTarget(file, "a.xml", 5000, &cancel));
    }
};

QTEST_GUILESS_MAIN(TestCurvePictures)

#include "test_curve_pictures.moc"
