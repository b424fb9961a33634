// Fills: the CPU renderer against the reference.
#include "tests/render/cell_corners.h"

#include "model/paint/fill_density.h"
#include "model/paint/seen_paint.h"
#include "render/probe.h"

#include "tests/trials.h"

#include <random>

using namespace suffuse;
using namespace suffuse::test;

namespace {

const Rect sheet = Rect::of(0, 0, 64, 48);

View sheetView(double scale = 1)
{
    return View::ofArea(sheet, int(64 * scale), int(48 * scale));
}

} // namespace

class TestFilled : public QObject {
    Q_OBJECT

    std::unique_ptr<Renderer> m_cpu = make(Backend::Cpu), m_reference = make(Backend::Reference);
    int m_number = 0; // of the comparison

    /// The largest difference, in 512ths.
    Worst compared(const PaintingPtr &p, const View &view, Microseconds time = -1, bool transparent = false)
    {
        Worst w = worst(test::render(*m_cpu, p, view, time, transparent),
                        test::render(*m_reference, p, view, time, transparent));
        w.difference *= 512;
        return w;
    }
    void compare(const PaintingPtr &p, const View &view, const QByteArray &what, Microseconds time = -1,
                 bool transparent = false)
    {
        ++m_number;
        if (!isTried(m_number + m_number / 5)) // not by fives alone: each fifth is of another kind
            return;
        const Worst w = compared(p, view, time, transparent);
        QVERIFY2(w.difference <= 1, qPrintable(QStringLiteral("%1: %2/512 at %3, %4")
                                                   .arg(QString::fromUtf8(what))
                                                   .arg(w.difference)
                                                   .arg(w.x)
                                                   .arg(w.y)));
    }

private slots:
    void shapesInEveryStyle()
    {
        for (const Style &style : someStyles())
            for (const double spread : {1.5, 4.0, 15.0, 100.0}) {
                Stroke disc = emptyFill(1, spread, style), box = emptyFill(2, spread, style, {0.9f, 0.1f, 0.2f, 1});
                addEllipse(disc, {28, 24}, 22, 15);
                addEllipse(disc, {30, 22}, 9, 7, true);
                addRectangle(box, Rect::of(22, 14, 30, 24));
                compare(painting({disc, box}, 64, 48), sheetView(), nameOf(style) + " s " + QByteArray::number(spread));
            }
    }

    void crispShapes()
    {
        for (const Style &style : someStyles())
            for (const double spread : {0.0, 1e-6, 0.003, 0.01}) {
                Stroke disc = emptyFill(1, spread, style), star = emptyFill(2, spread, style, {0.9f, 0.1f, 0.2f, 1});
                addEllipse(disc, {20, 20}, 15.3, 11.7);
                addEllipse(disc, {20, 20}, 5.3, 3.7, true);
                addPolygon(star, {{40.2, 5}, {45, 40.6}, {30, 18}, {55, 17.5}, {33, 41}});
                // Small: the reference looks for the edges in each pixel, and there are many of them.
                compare(painting({disc, star}, 64, 48), sheetView(0.5),
                        nameOf(style) + " s " + QByteArray::number(spread));
            }
    }

    /// What does not spread costs a sample a pixel at any zoom, and its edge is a step in the eye of the probe.
    void crispAtAnyZoom()
    {
        Stroke disc = emptyFill(1, 0, styleOf(StyleKind::Uniform));
        addEllipse(disc, {20, 20}, 15.3, 11.7);
        const auto p = painting({disc}, 64, 48);
        for (double scale = 1; scale < 2e6; scale *= 10) {
            const View v{{35.3, 20}, scale, 0, false, 40, 40};
            compare(p, v, "scale " + QByteArray::number(scale));
            int between = 0;
            const FloatPicture picture = test::render(*m_cpu, p, v, -1, true);
            for (int y = 0; y < 40; ++y)
                for (int x = 0; x < 40; ++x)
                    between += picture.at(x, y)[3] > 0.002f && picture.at(x, y)[3] < picture.at(0, 20)[3] - 0.002f;
            QVERIFY2(between <= 2 * 40, qPrintable(QString::number(between)));
        }
        QVERIFY(std::abs(fillDensityAt(disc, 1'000'000, {35.2999, 20}) - 1) < 1e-6);
        QCOMPARE(fillDensityAt(disc, 1'000'000, {35.3001, 20}), 0.0);
        for (const double x : {35.2999, 35.3001})
            QCOMPARE(probe(*p, 1'000'000, x, 20)->strokes.size(), std::size_t(x < 35.3));
    }

    /// Which side of a corner of a cell an outline through it takes is a matter of rounding, and shows nowhere: beside
    /// the outline all is covered, or nothing.
    void crispEdgesThroughCornersOfCells()
    {
        for (unsigned n = 0; n < 4; ++n)
            compare(painting({triangleThroughCorner(n).shape()}, 64, 48), sheetView(),
                    "triangle " + QByteArray::number(n));
        checkTrianglesThroughCorners(*m_cpu, 400);
    }

    void thinSpreads()
    {
        for (const double spread : {0.02, 0.06, 0.15, 0.4, 0.8}) {
            if ((spread == 0.06 || spread == 0.4) && !isLongRun())
                continue;
            Stroke disc = emptyFill(1, spread, styleOf(StyleKind::Uniform));
            addEllipse(disc, {7, 6}, 4.7, 3.3);
            Stroke edge = emptyFill(2, spread, styleOf(StyleKind::Edge), {0.9f, 0.1f, 0.2f, 1});
            addPolygon(edge, {{1.5, 1.5}, {12.5, 3}, {6, 10}});
            compare(painting({disc, edge}, 14, 11), View::ofArea(Rect::of(0, 0, 14, 11), 14, 11),
                    QByteArray::number(spread));
        }
    }

    void randomFills_data()
    {
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("most");
        QTest::newRow("soft") << 1.2 << 12.0;
        QTest::newRow("wide") << 12.0 << 200.0;
        QTest::newRow("crisp") << 1e-5 << 0.015;
        QTest::newRow("thin") << 0.2 << 1.0;
    }
    void randomFills()
    {
        QFETCH(double, least);
        QFETCH(double, most);
        const bool thin = most == 1.0;
        int beyond = 0, all = thin ? trials(1, 60) : trials(least < 1 ? 2 : 5, 600);
        for (int i = 0; i < all; ++i) {
            std::mt19937_64 random(i + 1);
            std::uniform_real_distribution<double> u(0, 1);
            std::vector<Stroke> strokes;
            for (int k = 0; k < 3; ++k)
                strokes.push_back(
                    randomFill(random, StrokeId(k + 1), 64, 48, least * std::pow(most / least, u(random))));
            Paper paper;
            paper.kind = i % 3 == 0 ? PaperKind::Procedural : PaperKind::None;
            const View view = i % 4 == 3 ? View{{32, 24}, 1.3, 0.4, i % 8 == 3, 48, 40}
                                         : sheetView(most < 1 ? 0.5 : 1);
            const Worst w = compared(painting(strokes, 64, 48, paper), view, 1'000'000, i % 5 == 0);
            if (w.difference > 1) {
                ++beyond;
                qInfo("%d: %g/512 at %d, %d", i, w.difference, w.x, w.y);
            }
        }
        QCOMPARE(beyond, 0);
    }

    /// Curves as a hand's lasso has them: their speed changes along them, and so does what their nodes are off by. A jump of
    /// coverage shows most of it.
    void unevenCurves()
    {
        int beyond = 0;
        const int all = trials(12, 300);
        for (int i = 0; i < all; ++i) {
            std::mt19937_64 random(1000 + i);
            std::uniform_real_distribution<double> u(0, 1);
            Stroke lasso = emptyFill(1, 8 + 24 * u(random), styleOf(StyleKind::Edge));
            changeFill(lasso, [](Fill &f) { f.density = 0.8f; });
            std::vector<Point> corners;
            for (int k = 0; k < 5; ++k) {
                const double angle = (k + 0.5 * u(random)) * 2 * std::numbers::pi / 5, radius = 18 + 25 * u(random);
                corners.push_back({32 + radius * std::cos(angle), 24 + radius * std::sin(angle)});
            }
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const Point a = corners[k], d = corners[(k + 1) % corners.size()], along = d - a;
                const auto aside = [&](double length) {
                    return length * (0.3 + u(random)) * along + (u(random) - 0.5) * Point{-along.y, along.x};
                };
                Segment g = bound({a, a + aside(0.8), d - aside(0.2), d});
                if (k > 0)
                    g.bezier[0] = lasso.segments.back().bezier[3];
                lasso.segments.push_back(g);
            }
            const Worst w = compared(painting({lasso}, 64, 48), sheetView());
            if (w.difference > 1) {
                ++beyond;
                qInfo("%d: %g/512 at %d, %d", i, w.difference, w.x, w.y);
            }
        }
        QCOMPARE(beyond, 0);
    }

    /// Segments that only bound a fill would be small in a small picture; they do not decide how the fill is sampled.
    void outlinesWithoutPaintAskForNoSamples()
    {
        for (const StyleKind kind : {StyleKind::Feathering, StyleKind::Edge}) {
            Stroke disc = emptyFill(1, 9, styleOf(kind));
            addEllipse(disc, {32, 24}, 20, 14);
            changeFill(disc, [](Fill &f) { f.granulation = 0.3f; });
            for (Segment &segment : disc.segments)
                segment.density = 0, segment.diffusion = 1;
            const Paper paper{PaperKind::Procedural, 5, 9, 0.5f, {}};
            for (const double scale : {0.3, 0.45})
                compare(painting({disc}, 64, 48, paper), sheetView(scale), "scale " + QByteArray::number(scale));
        }
    }

    void ages()
    {
        Stroke s = emptyFill(1, 6, styleOf(StyleKind::Uniform));
        addEllipse(s, {30, 24}, 20, 14);
        changeFill(s, [](Fill &f) { f.born = 500'000; });
        const auto p = painting({s}, 64, 48);
        for (const Microseconds T : {400'000, 500'000, 500'001, 520'000, 900'000, 1'500'000})
            compare(p, sheetView(), QByteArray::number(double(T)), T);
    }

    void gradients()
    {
        for (const double spread : {1e-4, 3.0, 30.0})
            for (const bool painted : {false, true}) {
                Stroke s = emptyFill(1, spread, styleOf(StyleKind::Feathering), {0, 0.9f, 0.1f, 1});
                addRectangle(s, Rect::of(8, 6, 44, 34));
                changeFill(s, [](Fill &f) { f.gradient = {{20, 10}, {45, 30}, {0.9f, 0.1f, 0.8f, 0.5f}}; });
                for (Segment &g : s.segments)
                    g.density = painted ? 3 : 0, g.colour = {0.2f, 0, 0, 1};
                compare(painting({s}, 64, 48), sheetView(), QByteArray::number(spread));
            }
    }

    void tensors()
    {
        for (const double ratio : {0.05, 0.3, 7.0})
            for (const double angle : {0.0, 0.7, 1.5707963267948966}) {
                Stroke s = emptyFill(1, 5, styleOf(StyleKind::Uniform));
                addEllipse(s, {30, 24}, 18, 14);
                changeFill(s, [&](Fill &f) { f.anisotropyRatio = float(ratio), f.anisotropyAngle = float(angle); });
                const auto p = painting({s}, 64, 48);
                compare(p, sheetView(), "ratio " + QByteArray::number(ratio));
                compare(p, View{{32, 24}, 1.5, 0.3, true, 64, 48}, "turned, ratio " + QByteArray::number(ratio));
            }
    }

    /// The figures at a point: the probe's are the reference's, and those for tools are near them.
    void numbersAtAPoint()
    {
        std::mt19937_64 random(21);
        std::uniform_real_distribution<double> u(0, 1);
        for (int i = 0; i < 60; ++i) {
            const double spread = i % 10 == 0 ? 0 : i % 5 == 0 ? 1e-3 : 1 + 15 * u(random);
            const Stroke s = randomFill(random, 1, 64, 48, spread);
            const auto p = painting({s}, 64, 48);
            const Point x{64 * u(random), 48 * u(random)};
            const auto probed = probe(*p, 1'000'000, x.x, x.y);
            QVERIFY(probed);
            const double exact = probed->strokes.empty() ? 0 : probed->strokes[0].fillDensity;
            const double quick = fillDensityAt(s, 1'000'000, x), rho = double(s.fill->density);
            QVERIFY2(std::abs(quick - exact) < 2e-3 * rho,
                     qPrintable(QStringLiteral("%1: %2 %3").arg(i).arg(quick).arg(exact)));
            if (probed->strokes.empty())
                continue;
            const ProbeStroke &there = probed->strokes[0];
            if (there.density > 0)
                QVERIFY(std::abs(there.fillShare * (there.density + there.lifted) - exact) < 1e-9 * rho);
            const SeenPaint seen = seenPaint(s, 1'000'000, x);
            if (exact > 0.1 * rho) {
                QVERIFY(seen.segment >= 0);
                QVERIFY(std::abs(PaintSight(s, 1'000'000).at(x).opacity - seen.opacity) < 1e-9);
            }
            // A picture of it from very near shows the same colour.
            const FloatPicture near =
                test::render(*m_reference, p, View{x, std::min(1e7 / spread, 1e9), 0, false, 1, 1}, 1'000'000);
            if (there.lifted == 0)
                for (int c = 0; c < 3; ++c)
                    QVERIFY(std::abs(double(near.at(0, 0)[c]) - there.rgbAfter[std::size_t(c)]) < 2e-3);
        }
    }

    /// Nothing is where there is no area; slivers, points, lines.
    void nothingToFill()
    {
        Stroke s = emptyFill(1, 3, styleOf(StyleKind::Feathering));
        addPolygon(s, {{10, 10}, {50, 30}});
        addPolygon(s, {{30, 30}, {30, 30}});
        addPolygon(s, {{5, 40}, {60, 40}, {30, 40}});
        const FloatPicture picture = test::render(*m_cpu, painting({s}, 64, 48), sheetView(), -1, true);
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x)
                QVERIFY(picture.at(x, y)[3] < 1e-3f);
        Stroke sliver = emptyFill(2, 3, {StyleKind::Feathering, {0.01f, 1, 0}});
        addPolygon(sliver, {{5, 5}, {60, 40}, {58, 40.01}});
        compare(painting({sliver}, 64, 48), sheetView(), "sliver");
    }

    void largerThanTheView()
    {
        for (const double spread : {1e-3, 4.0, 60.0}) {
            Stroke s = emptyFill(1, spread, styleOf(StyleKind::Uniform));
            addEllipse(s, {300, 24}, 280, 4000);
            Stroke whole = emptyFill(2, spread, styleOf(StyleKind::Edge), {0.5f, 0.5f, 0, 0.3f});
            addRectangle(whole, Rect::of(-1e5, -1e5, 3e5, 3e5));
            compare(painting({s, whole}, 64, 48), sheetView(), QByteArray::number(spread));
        }
    }

    void deepZoom()
    {
        for (const Style &style : {styleOf(StyleKind::Uniform), styleOf(StyleKind::Edge)}) {
            Stroke s = emptyFill(1, 9, style);
            s.origin = {10'000, -9'000};
            addEllipse(s, {30, 24}, 20, 14);
            changeFill(s, [](Fill &f) { f.gradient = {{20, 10}, {45, 30}, {0.9f, 0.1f, 0.8f, 0.5f}}; });
            const auto p = painting({s});
            Point centre = s.origin + Point{50, 24};
            for (double scale = 1; scale < 2e9; scale *= 8) {
                const View v{centre, std::min(scale, 1e9), 0, false, 40, 40};
                compare(p, v, "scale " + QByteArray::number(scale));
                if (QTest::currentTestFailed())
                    return;
                const FloatPicture picture = test::render(*m_reference, p, v);
                double steepest = -1;
                for (int y = 4; y < 36; ++y)
                    for (int x = 4; x < 36; ++x)
                        if (const double d = std::abs(double(picture.at(x, y)[0]) - double(picture.at(x + 1, y)[0]));
                            d > steepest)
                            steepest = d, centre = v.toCanvas({x + 1.0, y + 0.5});
            }
        }
    }
};

QTEST_GUILESS_MAIN(TestFilled)
#include "test_filled.moc"
