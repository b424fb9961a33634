// The reference against closed forms, differences and brute force: densities, panels and whole pictures.
#include "render/compare.h"
#include "render/probe.h"
#include "render/reference/panels.h"
#include "render/reference/quadrature.h"
#include "render/reference/reference.h"
#include "tests/render/paintings.h"

#include <QtTest>

#include <numbers>
#include <random>

using namespace suffuse;
using namespace suffuse::reference;

namespace {

constexpr double sqrtPi = 1.7724538509055160273;

double peakOf(double density, double s)
{
    return density / (sqrtPi * s);
}

class Random {
public:
    explicit Random(unsigned seed) : m_engine(seed) {}
    double operator()(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(m_engine); }
    Point point(double size) { return {(*this)(-size, size), (*this)(-size, size)}; }

private:
    std::mt19937_64 m_engine;
};

/// Awkward cubics, about L/s long at s = 1: anything, loops, near-cusps, cusps, tiny ones, doubled-back lines.
Cubic awkwardCubic(Random &random, int i)
{
    const double size = std::exp(random(std::log(0.05), std::log(20.0)));
    Cubic c{{random.point(size), random.point(size), random.point(size), random.point(size)}};
    switch (i % 6) {
    case 1: // loop
        c.p[3] = c.p[0] + random.point(0.1 * size);
        break;
    case 2: // near-cusp: the handles cross
        c.p[1] = c.p[0] + Point{size, size};
        c.p[3] = c.p[0] + Point{size, 0};
        c.p[2] = c.p[0] + Point{random(-1e-3, 1e-3) * size, size};
        break;
    case 3: // cusp
        c.p = {c.p[0], c.p[0] + Point{size, size}, c.p[0] + Point{0, size}, c.p[0] + Point{size, 0}};
        break;
    case 4: // both handles on the nodes
        c.p[1] = c.p[0];
        c.p[2] = c.p[3];
        break;
    case 5: // back and forth on a line
        c.p[1] = c.p[0] + 1.7 * (c.p[3] - c.p[0]);
        c.p[2] = c.p[0] - 0.9 * (c.p[3] - c.p[0]);
        break;
    default:
        break;
    }
    return c;
}

} // namespace

class TestReference : public QObject {
    Q_OBJECT

private slots:
    void quadratureRulesAreExactForPolynomials()
    {
        for (int n : {1, 2, 5, 10, 20}) {
            const GaussRule rule = reference::gaussLegendre(n);
            for (int degree = 0; degree < 2 * n; ++degree) {
                double sum = 0;
                for (std::size_t i = 0; i < rule.nodes.size(); ++i)
                    sum += rule.weights[i] * std::pow(rule.nodes[i], degree);
                QVERIFY2(std::abs(sum * (degree + 1) - 1) < 1e-13,
                         qPrintable(QString("n %1, x^%2").arg(n).arg(degree)));
            }
        }
        const KronrodRule &rule = kronrod15();
        for (int degree = 0; degree <= 22; degree += 2) {
            double kronrod = rule.weights[0] * (degree == 0), gauss = rule.gaussWeights[0] * (degree == 0);
            for (std::size_t i = 1; i < rule.nodes.size(); ++i) {
                kronrod += 2 * rule.weights[i] * std::pow(rule.nodes[i], degree);
                gauss += 2 * rule.gaussWeights[i] * std::pow(rule.nodes[i], degree);
            }
            QVERIFY(std::abs(kronrod * (degree + 1) / 2 - 1) < 1e-14);
            QVERIFY(degree > 12 || std::abs(gauss * (degree + 1) / 2 - 1) < 1e-14);
        }
    }

    void straightSegmentsMatchTheClosedForm()
    {
        Random random(1);
        double worst = 0;
        for (int i = 0; i < 2000; ++i) {
            const double s = std::exp(random(-4, 5)), length = s * std::exp(random(-4, 4)), density = random(0.1, 50);
            const double angle = random(-4, 4);
            const Point start = random.point(100), along{std::cos(angle), std::sin(angle)};
            const Cubic line{
                {start, start + (length / 3) * along, start + (2 * length / 3) * along, start + length * along}};
            const double u = random(-4 * s, length + 4 * s), v = random(-4, 4) * s;
            const Point x = start + u * along + v * Point{-along.y, along.x};
            const double expected = straightDensity(length, s, density, u, v);
            worst = std::max(worst, std::abs(segmentDensity(line, s, density, x) - expected) / peakOf(density, s));
        }
        QVERIFY2(worst < 1e-11, qPrintable(QString::number(worst)));
    }

    void aRampIsTheSumOfItsPieces()
    {
        // φ0 + gℓ by many short pieces of even density, against the closed form: second order in their length.
        const double length = 7, s = 1.5, density = 2, slope = 0.8, u = 3.1, v = 0.7;
        const int n = 20000;
        double sum = 0;
        for (int i = 0; i < n; ++i) {
            const double from = length * i / n, step = length / n;
            sum += straightDensity(step, s, density + slope * (from + 0.5 * step), u - from, v);
        }
        const double closed = rampDensity(length, s, density, slope, u, v);
        QVERIFY2(std::abs(sum - closed) < 1e-9, qPrintable(QString::number(sum - closed)));
        QVERIFY(std::abs(rampDensity(length, s, density, 0, u, v) - straightDensity(length, s, density, u, v)) < 1e-15);
    }

    void anisotropicLinesMatchTheClosedForm()
    {
        Random random(2);
        double worst = 0;
        for (int i = 0; i < 1000; ++i) {
            const double s = random(0.5, 5), ratio = std::exp(random(-3, 3)), density = random(0.1, 50);
            const Kernel kernel = anisotropicKernel(s, ratio, random(-4, 4));
            const Point a = random.point(10), b = random.point(10), x = random.point(12);
            const Cubic line{{a, a + (1.0 / 3) * (b - a), a + (2.0 / 3) * (b - a), b}};
            const double peak = peakOf(density, kernel.smallerSpread);
            worst = std::max(worst, std::abs(segmentDensity(line, kernel, density, x).density -
                                             straightDensity(a, b, kernel, density, x)) /
                                        peak);
        }
        QVERIFY2(worst < 1e-11, qPrintable(QString::number(worst)));
        // A tensor of ratio 1 is the plain spread.
        const Cubic c{{Point{0, 0}, {3, 9}, {8, -7}, {10, 2}}};
        QVERIFY(std::abs(segmentDensity(c, anisotropicKernel(2, 1, 0.7), 3, {4, 2}).density -
                         segmentDensity(c, 2, 3, {4, 2})) < 1e-13);
    }

    void gradientsMatchDifferences()
    {
        Random random(3);
        for (int i = 0; i < 600; ++i) {
            const Cubic c = awkwardCubic(random, i);
            const Point x = c.at(random(0, 1)) + random.point(1.5);
            const Kernel kernel = i % 2 ? isotropicKernel(1) : anisotropicKernel(1, 2.5, 0.4);
            const double h = 1e-4;
            const auto f = [&](double dx, double dy) {
                return segmentDensity(c, kernel, 3, x + Point{dx, dy}).density;
            };
            const Point g = segmentDensity(c, kernel, 3, x).gradient;
            const Point d{(f(h, 0) - f(-h, 0)) / (2 * h), (f(0, h) - f(0, -h)) / (2 * h)};
            const double scale = std::max(1.0, length(g));
            QVERIFY2(length(g - d) < 2e-7 * scale, qPrintable(QString("%1: %2").arg(i).arg(length(g - d))));
        }
        const Cubic c{{Point{0, 0}, {3, 9}, {8, -7}, {10, 2}}};
        const Point g = segmentDensityGradient(c, 2, 3, {4, 2});
        QCOMPARE(g, segmentDensity(c, isotropicKernel(2), 3, {4, 2}).gradient);
    }

    void densityAddsUpOverExactSplits()
    {
        Random random(4);
        for (int i = 0; i < 600; ++i) {
            const Cubic c = awkwardCubic(random, i);
            const auto parts = c.split(random(0.01, 0.99));
            const Point x = c.at(random(0, 1)) + random.point(1);
            const double whole = segmentDensity(c, 1, 1, x);
            const double sum = segmentDensity(parts[0], 1, 1, x) + segmentDensity(parts[1], 1, 1, x);
            QVERIFY2(std::abs(whole - sum) < 1e-11 * peakOf(1, 1),
                     qPrintable(QString("%1: %2").arg(i).arg(whole - sum)));
        }
    }

    void cuspsAreFoundAndIntegrated()
    {
        const Cubic cusp{{Point{0, 0}, {1, 1}, {0, 1}, {1, 0}}}; // c′(½) = 0
        const auto marks = speedExtrema(cusp);
        QVERIFY(std::any_of(marks.begin(), marks.end(), [](double p) { return std::abs(p - 0.5) < 1e-9; }));
        // Against a brute sum over 400,000 chords.
        const Point x{0.5, 0.7};
        for (double s : {0.05, 0.4, 3.0}) {
            double sum = 0;
            const int n = 400000;
            for (int i = 0; i < n; ++i) {
                const double p = (i + 0.5) / n;
                const Point d = x - cusp.at(p);
                sum += std::exp(-dot(d, d) / (s * s)) * length(cusp.derivative(p)) / n;
            }
            sum /= std::numbers::pi * s * s;
            QVERIFY(std::abs(segmentDensity(cusp, s, 1, x) - sum) < 1e-9 * peakOf(1, s));
        }
    }

    void aTinySpreadIsFound()
    {
        // A millionth of the length: only the closest parameters count, and it looks like an endless line there.
        const Cubic c{{Point{0, 0}, {300, 500}, {700, -400}, {1000, 100}}};
        const double s = 1e-3;
        const Point at = c.at(0.37), t = c.derivative(0.37);
        const Point normal = (1 / length(t)) * Point{-t.y, t.x};
        for (double v : {0.0, 0.4, 1.3}) {
            const double ratio = segmentDensity(c, s, 1, at + (v * s) * normal) / peakOf(1, s);
            QVERIFY2(std::abs(ratio - std::exp(-v * v)) < 1e-5, qPrintable(QString::number(ratio)));
        }
        QCOMPARE(segmentDensity(c, s, 1, at + (20 * s) * normal), 0.0);
        const Cubic dot{{Point{5, 5}, {5, 5}, {5, 5}, {5, 5}}};
        QCOMPARE(segmentDensity(dot, 1, 1, {5, 5}), 0.0);
    }

    void panelsSumToTheIntegral()
    {
        Random random(5);
        double worst = 0, worstSlope = 0;
        for (int i = 0; i < 3000; ++i) {
            const Cubic c = awkwardCubic(random, i);
            const Kernel kernel =
                i % 5 ? isotropicKernel(1) : anisotropicKernel(1, std::exp(random(-2, 2)), random(0, 3));
            std::vector<Panel> panels;
            appendPanels(c, kernel, nullptr, panels);
            const double peak = peakOf(1, kernel.smallerSpread);
            for (int n = 0; n < 3; ++n) {
                const Point x = c.at(random(0, 1)) + random.point(n);
                const DensityAndGradient sum = panelDensity(panels, kernel, 1, x);
                const DensityAndGradient truth = segmentDensity(c, kernel, 1, x);
                worst = std::max(worst, std::abs(sum.density - truth.density) / peak);
                worstSlope = std::max(worstSlope, length(sum.gradient - truth.gradient) * kernel.smallerSpread / peak);
            }
        }
        QVERIFY2(worst < 1e-11, qPrintable(QString::number(worst)));
        QVERIFY2(worstSlope < 1e-10, qPrintable(QString::number(worstSlope)));
    }

    void samplePicturesMatchTheProbe();
    void thinStrokesAreSampledFinely();
    void picturesDoNotDependOnThreads();
    void rotatedAndMirroredViewsShowTheSame();
    void cancelledPicturesSaySo();
    void comparisonFindsTheLargestDifference();

private:
    static FloatPicture draw(const PaintingPtr &painting, const View &view, int threads = 2, bool transparent = false)
    {
        FloatPicture picture;
        const auto stats =
            makeReferenceRenderer(threads)->render({painting, painting->end(), view, transparent}, picture);
        if (!stats)
            qFatal("%s", qPrintable(stats.error()));
        return picture;
    }
    static PaintingPtr someStrokes(double spread = 4)
    {
        auto painting = std::make_shared<Painting>();
        painting->canvas.width = 48;
        painting->canvas.height = 40;
        StrokeId id = 1;
        for (StyleKind kind : {StyleKind::Uniform, StyleKind::Feathering, StyleKind::Edge}) {
            Stroke s = test::stroke(id, test::Shape::Curved, {24, 12.0 + 6 * double(id)}, 18, spread,
                                    test::styleOf(kind), id % 2 ? Mix{} : Mix{MixMode::Beta, 0.6f});
            s.segments[1].colour = {0.9f, 0.2f, 0.1f, 0.8f};
            ++id;
            painting->strokes.push_back(std::make_shared<const Stroke>(std::move(s)));
        }
        // The top one mixes styles, and spreads farther along than across.
        Stroke top = *painting->strokes.back();
        top.segments[1].style = test::styleOf(StyleKind::Feathering);
        top.segments[2].anisotropyRatio = 2.5f;
        top.segments[2].anisotropyAngle = 0.6f;
        painting->strokes.back() = std::make_shared<const Stroke>(std::move(top));
        return painting;
    }
};

/// Far zoomed in, a pixel is a point: the picture must be what the probe says, computed by another road.
void TestReference::samplePicturesMatchTheProbe()
{
    const PaintingPtr painting = someStrokes();
    for (Point centre : {Point{20.3, 17.1}, Point{9.7, 21.9}, Point{30.2, 30.8}, Point{40.1, 27.3}}) {
        const View view{centre, 1e6, 0, false, 3, 3};
        const FloatPicture picture = draw(painting, view);
        const auto truth = probe(*painting, painting->end(), centre.x, centre.y);
        QVERIFY(bool(truth));
        QVERIFY(!truth->strokes.empty());
        for (std::size_t c = 0; c < 3; ++c)
            QVERIFY(std::abs(picture.at(1, 1)[c] - truth->strokes.back().rgbAfter[c]) < 1e-5);
    }
}

/// A line much thinner than a pixel keeps its share of the pixels it crosses.
void TestReference::thinStrokesAreSampledFinely()
{
    auto painting = std::make_shared<Painting>();
    painting->canvas.width = painting->canvas.height = 64;
    Stroke stroke = test::stroke(1, test::Shape::Straight, {32, 32}, 1, 0.5, {StyleKind::Uniform, {0.5f, 0.05f, 0}}, {},
                                 {1, 1, 1, 1});
    stroke.segments.resize(1);
    stroke.origin = {0, 0};
    stroke.segments[0].bezier = {{{-200, 32}, {0, 32}, {100, 32}, {300, 32}}};
    painting->strokes = {std::make_shared<const Stroke>(stroke)};
    // Painted width: where F = ½, w = s√ln(φˢ/(ξ1√π s)) on both sides.
    const double s = stroke.segments[0].spread(painting->end());
    const double width = 2 * s * std::sqrt(std::log(stroke.segments[0].density / (0.5 * sqrtPi * s)));
    for (int size : {16, 8, 4}) {
        const FloatPicture picture = draw(painting, View::ofArea(painting->canvas.area(), size, size));
        double dark = 0;
        for (int y = 0; y < size; ++y)
            dark += 1 - picture.at(size / 2, y)[0];
        const double painted = dark * 64 / size;
        QVERIFY2(std::abs(painted - width) < 0.06 * width, qPrintable(QString("%1, not %2").arg(painted).arg(width)));
    }
}

void TestReference::picturesDoNotDependOnThreads()
{
    const PaintingPtr painting = someStrokes(0.9);
    const View view = View::ofArea(painting->canvas.area(), 40, 33);
    const FloatPicture one = draw(painting, view, 1), three = draw(painting, view, 3);
    QVERIFY(std::all_of(one.rgba.begin(), one.rgba.end(), [](float v) { return v >= 0 && v <= 1; }));
    QVERIFY(one.rgba == three.rgba);
}

/// Turned by a right angle, every pixel's square is the same square: the same colours to the last digits.
void TestReference::rotatedAndMirroredViewsShowTheSame()
{
    for (double spread : {4.0, 0.7}) {
        const PaintingPtr painting = someStrokes(spread);
        const View plain{{24, 20}, 1, 0, false, 40, 40};
        View turned = plain, mirrored = plain;
        turned.rotation = std::numbers::pi / 2;
        mirrored.mirrored = true;
        const FloatPicture a = draw(painting, plain), b = draw(painting, turned), c = draw(painting, mirrored);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x)
                for (int k = 0; k < 3; ++k) {
                    QVERIFY(std::abs(a.at(x, y)[k] - b.at(39 - y, x)[k]) < 1e-6f);
                    QVERIFY(std::abs(a.at(x, y)[k] - c.at(39 - x, y)[k]) < 1e-6f);
                }
    }
}

void TestReference::cancelledPicturesSaySo()
{
    const PaintingPtr painting = someStrokes();
    std::atomic<bool> cancel = true;
    FloatPicture picture;
    const auto renderer = makeReferenceRenderer(2);
    const View view = View::ofArea(painting->canvas.area(), 48, 40);
    const auto stopped = renderer->render({painting, painting->end(), view, false}, picture, &cancel);
    QVERIFY(bool(stopped) && stopped->cancelled && stopped->dirty.empty());
    const auto whole = renderer->render({painting, painting->end(), view, false}, picture);
    QVERIFY(bool(whole) && !whole->cancelled);
    QCOMPARE(whole->dirty, (std::vector<PixelRect>{{0, 0, 48, 40}}));
    QCOMPARE(renderer->backend(), Backend::Reference);
}

void TestReference::comparisonFindsTheLargestDifference()
{
    FloatPicture a, b;
    a.resize(4, 3);
    std::fill(a.rgba.begin(), a.rgba.end(), 1.0f);
    b = a;
    auto same = compare(a, b);
    QVERIFY(bool(same) && same->largest() == 0 && same->isWithinTolerance());
    b.rgba[(2 * 4 + 1) * 4 + 1] = 0.75f; // green at (1, 2)
    b.rgba[0] = 0.999f;
    auto other = compare(a, b);
    QVERIFY(bool(other));
    QCOMPARE(other->maximum[1], 0.25);
    QCOMPARE(other->x, 1);
    QCOMPARE(other->y, 2);
    QCOMPARE(other->over, std::size_t(1));
    b.rgba[4] = std::numeric_limits<float>::quiet_NaN();
    QCOMPARE(compare(a, b)->notFinite, std::size_t(1));
    // Straight colour means nothing where nothing is covered.
    a.resize(1, 1);
    b.resize(1, 1);
    b.rgba = {1, 1, 1, 0};
    QVERIFY(compare(a, b)->isWithinTolerance());
    b.resize(2, 1);
    QVERIFY(!compare(a, b));
}

QTEST_GUILESS_MAIN(TestReference)
#include "test_reference.moc"
