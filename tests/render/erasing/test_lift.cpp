// Chains, and segments that take paint away: the CPU renderer against the reference, and the figures at a point.
#include "tests/render/erasing/lifted.h"

#include "model/paint/local_paint.h"
#include "model/paint/point_density.h"
#include "model/paint/seen_paint.h"
#include "render/nodes/blocks.h"
#include "render/nodes/node_builder.h"
#include "render/probe.h"
#include "render/reference/style.h"
#include "render/scene/scene.h"
#include "tests/trials.h"

using namespace suffuse;
using namespace suffuse::test;

namespace {

const Rect sheet = Rect::of(0, 0, 96, 72);

} // namespace

class TestLift : public QObject {
    Q_OBJECT

    std::unique_ptr<Renderer> m_cpu = make(Backend::Cpu), m_reference = make(Backend::Reference);

    void compare(const PaintingPtr &p, const View &view, const QByteArray &what, Microseconds time = -1,
                 bool transparent = false)
    {
        const Worst w = worst(test::render(*m_cpu, p, view, time, transparent),
                              test::render(*m_reference, p, view, time, transparent));
        QVERIFY2(w.difference <= 1.0 / 512, qPrintable(QStringLiteral("%1: %2/512 at %3, %4")
                                                           .arg(QString::fromUtf8(what))
                                                           .arg(w.difference * 512)
                                                           .arg(w.x)
                                                           .arg(w.y)));
    }

    /// A path through a wash, its spread as given, across its upper edge and a part of it that is left whole.
    static Stroke liftedWash(const Style &style, double spread, double peak)
    {
        Stroke s = wash(2, Rect::of(14, 12, 68, 48), 9, 6, style);
        liftAlong(s, {20, 4}, {60, 44}, spread, peak * double(style.xi[0]));
        return s;
    }

private slots:
    void washesOfEveryStyle()
    {
        int number = 0;
        for (const Style &style : someStyles())
            for (const double spread : {1.5, 4.0, 9.0})
                for (const double peak : {0.8, 3.0, 30.0}) {
                    if (!isTried(++number))
                        continue;
                    const Mix mix = spread > 4 ? Mix{MixMode::Beta, 0.8f} : Mix{};
                    Stroke s = liftedWash(style, spread, peak);
                    s.mix = mix;
                    const auto p = painting({stroke(1, Shape::Curved, {50, 30}, 30, 9, styleOf(StyleKind::Uniform), {},
                                                    {0.9f, 0.2f, 0.1f, 1}),
                                             s});
                    compare(p, View::ofArea(sheet, 96, 72),
                            nameOf(style) + ", spread " + QByteArray::number(spread) + ", peak " +
                                QByteArray::number(peak));
                    if (QTest::currentTestFailed())
                        return;
                }
    }

    /// Erasures of s = 2 to 4 px on calm paint: the four samples of most pixels are told from the centre.
    void calmPaint()
    {
        std::mt19937_64 random(31);
        std::uniform_real_distribution<double> u(0, 1);
        int number = 0;
        for (const Style &style : someStyles())
            for (const double spread : {2.02, 2.9, 3.97})
                for (const double peak : {0.3, 1.0, 30.0}) {
                    Stroke s = wash(2, Rect::of(14, 12, 68, 48), 6, 6 + 3 * u(random), style);
                    liftAlong(s, {20, 4}, {60 + 10 * u(random), 44}, spread, peak * double(style.xi[0]));
                    liftAlong(s, {30 + 10 * u(random), 60}, {70, 14}, spread, peak * double(style.xi[0]));
                    const int kind = ++number % 4; // colours anywhere, on a line, granulated, plain
                    for (std::size_t k = 0; k < s.segments.size(); ++k) {
                        Segment &g = s.segments[k];
                        if (kind == 1)
                            g.colour = {float(u(random)), float(u(random)), float(u(random)), float(u(random))};
                        if (kind == 2)
                            g.colour = {0.1f, k % 2 ? 1.0f : 0.0f, 0.9f, k % 2 ? 1.0f : 0.5f};
                        if (kind == 3)
                            g.granulation = 0.4f;
                    }
                    const View straight = View::ofArea(sheet, 96, 72), turned{{48, 36}, 1, 0.6, true, 96, 72};
                    const auto scene =
                        makeSceneStroke(std::make_shared<const Stroke>(s), buildNodes(s, 10'000'000, 0, sheet),
                                        PictureGrid::ofPicture(straight));
                    QVERIFY(scene.calm && !scene.small.empty());
                    const Paper paper = number % 3 ? Paper{} : Paper{PaperKind::Procedural, 5, 20, 0.8f, {}};
                    if (!isTried(number + number / 5)) // not by fives alone: each fifth is turned
                        continue;
                    compare(painting({s}, 96, 72, paper), number % 5 ? straight : turned,
                            nameOf(style) + ", spread " + QByteArray::number(spread) + ", peak " +
                                QByteArray::number(peak) + ", number " + QByteArray::number(number));
                    if (QTest::currentTestFailed())
                        return;
                }
    }

    void randomPaintings()
    {
        std::mt19937_64 random(7);
        for (int i = 0; i < 12; ++i) {
            const Paper paper = i % 2 ? Paper{PaperKind::Procedural, 5, 20, 0.8f, {}, PaperGrain(i / 2 % 3)} : Paper{};
            const auto p = painting(liftedStrokes(random, 10, 96, 72), 96, 72, paper);
            compare(p, View::ofArea(sheet, 96, 72), "dry", -1, i % 3 == 2);
            compare(p, View::ofArea(sheet, 96, 72), "still spreading", 600'000);
            if (QTest::currentTestFailed())
                return;
        }
    }

    void zoomedTurnedAndMirrored()
    {
        std::mt19937_64 random(11);
        const auto p = painting(liftedStrokes(random, 8, 96, 72), 96, 72, {PaperKind::Procedural, 3, 12, 1, {}});
        for (double scale : {0.02, 0.1, 0.4, 3.0, 40.0, 900.0, 20000.0})
            for (double rotation : {0.0, 0.7})
                compare(p, View{{40.2, 33.1}, scale, rotation, rotation > 0, 48, 40},
                        QByteArray("scale ") + QByteArray::number(scale));
    }

    /// Follows the steepest pixel from 1:1 to 1e9×, where it begins on what was lifted.
    void deepZoom()
    {
        for (const Style &style :
             {styleOf(StyleKind::Uniform), styleOf(StyleKind::Feathering), styleOf(StyleKind::Edge)}) {
            Stroke s = stroke(1, Shape::Straight, {10053, -9947}, 40, 9, style);
            s.segments[1].colour = {0.9f, 0.4f, 0.2f, 1};
            liftAlong(s, s.origin + Point{-8, -30}, s.origin + Point{-2, 30}, 5, 2);
            const auto p = painting({s});
            Point centre = s.origin + Point{1, 0};
            for (double scale = 8; scale < 2e9; scale *= 8) {
                const View v{centre, std::min(scale, 1e9), 0, false, 32, 32};
                compare(p, v, nameOf(style) + " at " + QByteArray::number(scale));
                if (QTest::currentTestFailed())
                    return;
                const FloatPicture picture = test::render(*m_reference, p, v);
                double steepest = -1;
                for (int y = 4; y < 28; ++y)
                    for (int x = 4; x < 28; ++x)
                        if (const double d = std::abs(double(picture.at(x, y)[0]) - double(picture.at(x + 1, y)[0]));
                            d > steepest)
                            steepest = d, centre = v.toCanvas({x + 1.0, y + 0.5});
            }
        }
    }

    /// Paint may only be taken away: where nothing was laid nothing shows, and elsewhere no more than without the
    /// lifting segments, but for what finer samples make of a pixel.
    void nothingComesOutOfNothing()
    {
        for (const Style &style : someStyles())
            for (const double spread : {0.3, 1.0, 3.0}) {
                const Stroke before = stroke(1, Shape::Straight, {48, 20}, 30, 5, style);
                Stroke after = before;
                liftAlong(after, {10, 24}, {80, 60}, spread, 40);
                const View view = View::ofArea(sheet, 96, 72);
                const FloatPicture a = test::render(*m_cpu, painting({before}), view, -1, true);
                const FloatPicture b = test::render(*m_cpu, painting({after}), view, -1, true);
                for (int y = 0; y < 72; ++y)
                    for (int x = 0; x < 96; ++x) {
                        float most = 0; // of the pixel and its neighbours
                        for (int v = std::max(0, y - 1); v <= std::min(71, y + 1); ++v)
                            for (int u = std::max(0, x - 1); u <= std::min(95, x + 1); ++u)
                                most = std::max(most, a.at(u, v)[3]);
                        if (style.kind == StyleKind::Edge && most > 0) // less paint is darker at its rim
                            continue;
                        QVERIFY2(b.at(x, y)[3] <= most + 1e-3f,
                                 qPrintable(QStringLiteral("%1, spread %2: %3 of %4 at %5, %6")
                                                .arg(QString::fromLatin1(nameOf(style)))
                                                .arg(spread)
                                                .arg(double(b.at(x, y)[3]))
                                                .arg(double(a.at(x, y)[3]))
                                                .arg(x)
                                                .arg(y)));
                    }
            }
    }

    /// Beside the paint of a stroke whose ξ vary there is no ξ̄, and a lift shows nothing there.
    void liftsBesidePaintWhoseStylesVary()
    {
        Stroke s = stroke(1, Shape::Straight, {60, 30}, 20, 3, styleOf(StyleKind::Uniform));
        s.segments[1].style = Style{StyleKind::Uniform, {0.7f, 0.1f, 0}};
        liftAlong(s, {14, 50}, {30, 50}, 3.1, 2.2, 2);
        for (Segment &g : s.segments)
            if (g.lift)
                g.anisotropyRatio = 4, g.anisotropyAngle = 0.5f;
        const View view = View::ofArea(sheet, 96, 72);
        compare(painting({s}), view, "lift beside paint");
        QCOMPARE(test::render(*m_cpu, painting({s}), view, -1, true).at(22, 57)[3], 0.0f);
    }

    void onePicture()
    {
        std::mt19937_64 random(3);
        const auto p =
            painting(liftedStrokes(random, 20, 130, 101), 130, 101, {PaperKind::Procedural, 1, 16, 0.7f, {}});
        for (const View &v : {View::ofArea(p->canvas.area(), 130, 101), View{{60, 50}, 0.11, 0.5, true, 70, 61},
                              View{{60, 50}, 0.6, 0, false, 78, 61}, View{{60, 50}, 900, 0, false, 70, 61}}) {
            const FloatPicture first = test::render(*make(Backend::Cpu, 1, 16), p, v);
            for (int tile : {8, 24, 64})
                QVERIFY(first.rgba == test::render(*make(Backend::Cpu, 2, tile), p, v).rgba);
            RendererOptions whole{Backend::Cpu, 2, 32};
            whole.cull = false;
            QVERIFY(first.rgba == test::render(**makeRenderer(whole), p, v).rgba);
        }
    }

    /// Lifting and laying segments are merged separately, and merged nodes keep the sign of what they stand for.
    void mergedNodesKeepTheirKind()
    {
        Stroke s = wash(1, Rect::of(10, 10, 80, 50), 8, 5, styleOf(StyleKind::Uniform));
        liftAlong(s, {12, 12}, {70, 50}, 5, 1, 40);
        const auto nodes = buildNodes(s, 10'000'000, 0, sheet);
        double laid = 0, lifted = 0;
        std::size_t merged = 0;
        for (const NodeGroup &g : nodes->groups) {
            for (std::uint32_t i = g.begin; i < g.end; ++i) {
                const bool lift = nodes->rows[g.row + (g.rowPerNode ? i - g.begin : 0)].lift;
                QCOMPARE(nodes->nodes[i].weight < 0, lift);
                (lift ? lifted : laid) += nodes->nodes[i].weight;
            }
            merged += g.reachEnd - g.reachBegin > 1;
        }
        QVERIFY(merged > 2 && laid > 0 && lifted < 0);
        const std::vector<std::size_t> borders = blocksOf(s).borders;
        QVERIFY(std::ranges::binary_search(borders, std::size_t(64)) && borders.back() == 104);
    }

    void theMeanOfLiftedRimsIsTheIntegral()
    {
        const reference::Xi xi{0.36, 0.40, 0.5};
        for (const double density : {-0.6, 0.05, 0.25, 0.3, 0.9})
            for (const double h : {0.01, 0.3, 2.0}) {
                const int n = 200'000;
                double sum = 0;
                for (int i = 0; i < n; ++i)
                    sum += reference::densityFunction(StyleKind::Edge, xi, density + h * (2 * (i + 0.5) / n - 1)) / n;
                QVERIFY(std::abs(reference::densityFunctionMean(StyleKind::Edge, xi, density, h, 1) - sum) < 2e-5);
            }
    }

    void probesTellWhatIsLifted()
    {
        Stroke s = stroke(1, Shape::Straight, {48, 36}, 30, 5, styleOf(StyleKind::Uniform));
        liftAlong(s, {40, 30}, {56, 40}, 4, 0.6, 2);
        const auto p = painting({s});
        const Point at{48, 36};
        const auto found = probe(*p, p->end(), at.x, at.y);
        QVERIFY(found && found->strokes.size() == 1);
        const ProbeStroke &here = found->strokes[0];
        double laid = 0, lifted = 0;
        for (const ProbeShare &share : here.shares) {
            QCOMPARE(share.lifts, s.segments[std::size_t(share.segment)].lift);
            (share.lifts ? lifted : laid) += share.density;
        }
        QVERIFY(lifted > 0);
        QVERIFY(std::abs(here.density - (laid - lifted)) < 1e-12 && std::abs(here.lifted - lifted) < 1e-12);
        for (const ProbeShare &share : here.shares)
            QVERIFY(std::abs(share.share - share.density / laid) < 1e-12);
        QVERIFY(std::abs(strokeDensityAt(s, p->end(), at) - here.density) < 2e-3);
        QVERIFY(std::abs(seenPaint(s, p->end(), at).opacity - here.opacity) < 0.03);
        LocalPaint paint;
        paint.add(s.segments[0], s.style, 0.5);
        paint.add(s.segments[4], s.style, 0.8);
        QCOMPARE(paint.density(), 0.0);
        QCOMPARE(paint.colour()[1], double(s.segments[0].colour.yellow));
        QCOMPARE(paint.opacity(1), 0.0);
    }
};

QTEST_GUILESS_MAIN(TestLift)
#include "test_lift.moc"
