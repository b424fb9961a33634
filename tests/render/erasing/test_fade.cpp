// Segments that make paint paler: the CPU renderer against the reference, and what they are meant to do.
#include "tests/render/erasing/edited_strokes.h"
#include "tests/render/erasing/lifted.h"

#include "model/paint/local_paint.h"
#include "model/paint/point_density.h"
#include "model/paint/seen_paint.h"
#include "model/painting/influence.h"
#include "render/nodes/node_builder.h"
#include "render/probe.h"
#include "render/scene/scene.h"
#include "tests/trials.h"

using namespace suffuse;
using namespace suffuse::test;

namespace {

const Rect sheet = Rect::of(0, 0, 96, 72);

PaintingPtr withStroke(const PaintingPtr &p, std::size_t index, Stroke s)
{
    auto q = std::make_shared<Painting>(*p);
    q->strokes[index] = std::make_shared<const Stroke>(std::move(s));
    return q;
}

/// The box of what fades.
Rect influenceOfFades(const Stroke &s, Microseconds time)
{
    Rect box;
    for (const Segment &g : s.segments)
        if (g.fade)
            box = box.united(influenceOf(s, g, time));
    return box;
}

} // namespace

class TestFade : public QObject {
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

private slots:
    /// What is left is e^−φ of what there was, whatever the style: also within a wash with a sharp edge.
    void leavesItsShare()
    {
        for (const Style &style : someStyles())
            for (const double peak : {-std::log(0.8), -std::log(0.6), -std::log(0.2)}) {
                const Stroke before = wash(1, Rect::of(14, 12, 68, 48), 9, 6, style);
                Stroke once = before;
                fadeAlong(once, {-40, 36}, {140, 36}, 6, peak, 12);
                Stroke twice = once;
                fadeAlong(twice, {-40, 36}, {140, 36}, 6, peak, 12);
                const View view = View::ofArea(sheet, 96, 72);
                const FloatPicture a = test::render(*m_reference, painting({before}), view, -1, true);
                const FloatPicture b = test::render(*m_reference, painting({once}), view, -1, true);
                const FloatPicture c = test::render(*m_reference, painting({twice}), view, -1, true);
                // The pixel's centre lies half a pixel beside the line.
                const double left = std::exp(-peak * std::exp(-0.25 / 36));
                for (int x = 30; x < 66; x += 7) {
                    const double was = double(a.at(x, 36)[3]);
                    QVERIFY(std::abs(double(b.at(x, 36)[3]) - left * was) < 1e-4);
                    QVERIFY(std::abs(double(c.at(x, 36)[3]) - left * left * was) < 1e-4);
                }
            }
    }

    void washesOfEveryStyle()
    {
        int number = 0;
        for (const Style &style : someStyles())
            for (const double spread : {0.6, 2.5, 9.0})
                for (const double peak : {0.3, 1.5, 9.0}) {
                    if (!isTried(++number))
                        continue;
                    Stroke s = wash(2, Rect::of(14, 12, 68, 48), 9, 6, style);
                    s.mix = spread > 4 ? Mix{MixMode::Beta, 0.8f} : Mix{};
                    fadeAlong(s, {20, 4}, {60, 44}, spread, peak);
                    if (number % 2)
                        liftAlong(s, {30, 64}, {70, 14}, spread, 2 * double(style.xi[0]));
                    for (std::size_t k = 0; number % 3 == 0 && k < s.segments.size(); ++k)
                        s.segments[k].colour = {float(k % 5) / 5, 0.2f, 0.9f, float(k % 3 + 1) / 3};
                    const Paper paper = number % 4 ? Paper{} : Paper{PaperKind::Procedural, 5, 20, 0.8f, {}};
                    for (Segment &g : s.segments)
                        g.granulation = number % 4 ? 1 : 0.4f;
                    const auto p = painting({stroke(1, Shape::Curved, {50, 30}, 30, 9, styleOf(StyleKind::Uniform), {},
                                                    {0.9f, 0.2f, 0.1f, 1}),
                                             s},
                                            96, 72, paper);
                    const View straight = View::ofArea(sheet, 96, 72), turned{{48, 36}, 1, 0.6, true, 96, 72};
                    compare(p, number % 5 ? straight : turned,
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
            if (!isTried(i))
                continue;
            const Paper paper = i % 2 ? Paper{PaperKind::Procedural, 5, 20, 0.8f, {}, PaperGrain(i / 2 % 3)} : Paper{};
            const auto p = painting(fadedStrokes(random, 10, 96, 72), 96, 72, paper);
            compare(p, View::ofArea(sheet, 96, 72), "dry", -1, i % 3 == 2);
            compare(p, View::ofArea(sheet, 96, 72), "still spreading", 600'000);
            if (QTest::currentTestFailed())
                return;
        }
    }

    void zoomedTurnedAndMirrored()
    {
        std::mt19937_64 random(11);
        const auto p = painting(fadedStrokes(random, 8, 96, 72), 96, 72, {PaperKind::Procedural, 3, 12, 1, {}});
        int number = 0;
        for (double scale : {0.02, 0.1, 0.4, 3.0, 40.0, 900.0, 20000.0, 1e7})
            for (double rotation : {0.0, 0.7})
                if (isTried(number++))
                    compare(p, View{{40.2, 33.1}, scale, rotation, rotation > 0, 48, 40},
                            QByteArray("scale ") + QByteArray::number(scale));
    }

    /// A group's wash is one stroke, whichever member brings what fades.
    void washesOfGroups()
    {
        for (const Style &style : someStyles()) {
            Stroke below = wash(1, Rect::of(10, 10, 40, 40), 7, 6, styleOf(StyleKind::Uniform));
            Stroke above = wash(2, Rect::of(40, 24, 44, 36), 7, 6, styleOf(StyleKind::Feathering));
            fadeAlong(above, {10, 36}, {90, 40}, 5, 1);
            below.group = above.group = 1;
            auto p = std::make_shared<Painting>(*painting({below, above}));
            Group group;
            group.id = 1;
            group.wash = Wash{style, {}};
            p->groups.push_back(group);
            compare(p, View::ofArea(sheet, 96, 72), "wash of " + nameOf(style));
            const PaintingPtr with = p;
            Stroke unfaded = above;
            std::erase_if(unfaded.segments, [](const Segment &g) { return g.fade; });
            const View view = View::ofArea(sheet, 96, 72);
            const FloatPicture a = test::render(*m_cpu, with, view),
                               b = test::render(*m_cpu, withStroke(with, 1, unfaded), view);
            QVERIFY(a.at(24, 36)[0] > b.at(24, 36)[0] + 0.02f); // of the other stroke's paint
        }
    }

    /// Outside the influence of what fades every pixel keeps its bits, whatever varies along the stroke, and also where
    /// the samples of lifted paint are told from its pixels.
    void fadingChangesNothingElse()
    {
        int number = 0;
        for (const Style &style : someStyles())
            for (const int what : {0, 1, 2, 3, 4}) {
                if (!isTried(++number))
                    continue;
                Stroke s = wash(2, Rect::of(14, 12, 100, 60), 12, what == 4 ? 6 : 4, style);
                for (std::size_t k = 0; k < s.segments.size(); ++k) {
                    if (what == 1)
                        s.segments[k].colour = {float(k % 7) / 7, 0.3f, 0.9f, 0.8f};
                    if (what == 2)
                        s.segments[k].granulation = float(k % 5) / 5;
                    if (what == 3 && k % 9 == 4)
                        s.segments[k].style = styleOf(StyleKind(k % 3));
                }
                if (what == 4)
                    liftAlong(s, {20, 20}, {100, 64}, 3, double(style.xi[0]), 12);
                const auto p = painting({stroke(1, Shape::Curved, {60, 40}, 40, 9, styleOf(StyleKind::Uniform)), s},
                                        128, 96, {PaperKind::Procedural, 1, 16, 0.7f, {}});
                Stroke faded = s;
                fadeAlong(faded, {40, 30}, {60, 44}, 3, 0.7);
                for (const Microseconds time : {p->end(), Microseconds(400'000)}) {
                    const Rect influence = influenceOfFades(faded, time);
                    for (const View &view :
                         {View::ofArea(Rect::of(0, 0, 128, 96), 128, 96), View{{64, 48}, 0.7, 0.4, true, 90, 70},
                          View{{70, 44}, 5, 0, false, 128, 96}}) {
                        const FloatPicture a = test::render(*m_cpu, p, view, time);
                        const FloatPicture b = test::render(*m_cpu, withStroke(p, 1, faded), view, time);
                        QVERIFY2(a.rgba != b.rgba, nameOf(style).constData());
                        const Rect met = influence.grown(view.px() * std::numbers::sqrt2 / 2);
                        for (int y = 0; y < a.height; ++y)
                            for (int x = 0; x < a.width; ++x)
                                if (!met.contains(view.toCanvas({x + 0.5, y + 0.5})))
                                    QVERIFY2(std::equal(a.at(x, y), a.at(x, y) + 4, b.at(x, y)),
                                             qPrintable(QStringLiteral("%1, what %2, time %3, scale %4: %5, %6")
                                                            .arg(QString::fromLatin1(nameOf(style)))
                                                            .arg(what)
                                                            .arg(time)
                                                            .arg(view.scale)
                                                            .arg(x)
                                                            .arg(y)));
                    }
                }
            }
    }

    void onePicture()
    {
        std::mt19937_64 random(3);
        const auto p = painting(fadedStrokes(random, 20, 130, 101), 130, 101, {PaperKind::Procedural, 1, 16, 0.7f, {}});
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

    /// Whatever was edited, an edit's redraw is the full redraw: also where what fades comes, goes or turns into paint.
    void dirtyRedrawIsFullRedraw()
    {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> u(0, 1);
        auto p = painting(fadedStrokes(random, 16, 160, 120), 160, 120);
        const auto live = make(Backend::Cpu);
        FloatPicture picture;
        const View view = View::ofArea(p->canvas.area(), 160, 120);
        Microseconds time = p->end();
        QVERIFY(live->render({p, time, view, false}, picture));
        for (int step = 0; step < 80; ++step) {
            p = randomlyEdited(p, random);
            const std::size_t j = random() % p->strokes.size();
            Stroke s = *p->strokes[j];
            Segment &g = s.segments[random() % s.segments.size()];
            if (step % 3 == 0)
                g.fade = !g.fade, g.lift = !g.fade && random() % 2;
            else if (step % 3 == 1)
                fadeAlong(s, {160 * u(random), 120 * u(random)}, {160 * u(random), 120 * u(random)}, 4, 1, 2);
            p = withStroke(p, j, s);
            if (random() % 6 == 0)
                time = Microseconds(u(random) * double(p->end()));
            QVERIFY(live->render({p, time, view, false}, picture));
            QVERIFY2(picture.rgba == test::render(*make(Backend::Cpu), p, view, time).rgba,
                     qPrintable(QStringLiteral("step %1").arg(step)));
        }
    }

    /// A segment that fades is dragged: layers below and above give the picture to 1e-5, and exactly once it rests.
    void layersHoldWhileAFadeIsDragged()
    {
        std::mt19937_64 random(17);
        const View view = View::ofArea(Rect::of(0, 0, 100, 75), 100, 75);
        for (const bool transparent : {false, true}) {
            auto p = painting(fadedStrokes(random, 14, 100, 75), 100, 75);
            Stroke s = *p->strokes[6];
            fadeAlong(s, {20, 20}, {80, 50}, 4, 1);
            p = withStroke(p, 6, s);
            const auto live = make(Backend::Cpu);
            FloatPicture picture;
            QVERIFY(live->render({p, p->end(), view, transparent}, picture));
            for (int step = 0; step < 6; ++step) {
                for (Offset &o : s.segments.back().bezier)
                    o.y += 1;
                s.segments.back().start = true; // it came off the one before
                p = withStroke(p, 6, s);
                QVERIFY(live->render({p, p->end(), view, transparent, true}, picture));
                QVERIFY(worst(picture, test::render(*make(Backend::Cpu), p, view, -1, transparent)).difference <= 1e-5);
            }
            QVERIFY(live->render({p, p->end(), view, transparent, false}, picture));
            QVERIFY(picture.rgba == test::render(*make(Backend::Cpu), p, view, -1, transparent).rgba);
        }
    }

    /// A stroke that pales while it dries, by a chain that grows: sums of what has dried are kept.
    void aGrowingFade()
    {
        Stroke s = wash(1, Rect::of(10, 10, 100, 70), 12, 5, styleOf(StyleKind::Edge));
        const auto live = make(Backend::Cpu);
        FloatPicture picture;
        const View view = View::ofArea(Rect::of(0, 0, 128, 96), 128, 96);
        for (int frame = 0; frame < 50; ++frame) {
            const auto at = [](int k) { return Point{15.0 + 1.8 * k, 45 + 20 * std::sin(0.3 * k)}; };
            fadeAlong(s, at(frame), at(frame + 1), 4, 1, 1);
            Segment &g = s.segments.back();
            g.born = 600'000 + frame * 40'000;
            g.start = frame == 0;
            if (frame > 0)
                g.bezier[0] = s.segments[s.segments.size() - 2].bezier[3];
            const auto p = painting({s}, 128, 96);
            const Microseconds time = 620'000 + frame * 40'000;
            QVERIFY(live->render({p, time, view, false}, picture));
            if (frame % 5 == 0)
                QVERIFY2(picture.rgba == test::render(*make(Backend::Cpu), p, view, time).rgba,
                         qPrintable(QStringLiteral("frame %1").arg(frame)));
        }
    }

    void probesTellWhatFades()
    {
        Stroke s = stroke(1, Shape::Straight, {48, 36}, 30, 5, styleOf(StyleKind::Uniform));
        const Stroke before = s;
        fadeAlong(s, {40, 30}, {56, 40}, 4, 0.6, 2);
        const auto p = painting({s});
        const Point at{48, 36};
        const auto found = probe(*p, p->end(), at.x, at.y), was = probe(*painting({before}), p->end(), at.x, at.y);
        QVERIFY(found && found->strokes.size() == 1 && was && was->strokes.size() == 1);
        const ProbeStroke &here = found->strokes[0], &earlier = was->strokes[0];
        double faded = 0;
        for (const ProbeShare &share : here.shares) {
            QCOMPARE(share.fades, s.segments[std::size_t(share.segment)].fade);
            faded += share.fades ? share.density : 0;
        }
        QVERIFY(faded > 0.3 && std::abs(here.faded - faded) < 1e-12);
        QCOMPARE(here.density, earlier.density);
        QVERIFY(std::abs(here.opacity - std::exp(-faded) * earlier.opacity) < 1e-12);
        QVERIFY(std::abs(strokeDensityAt(s, p->end(), at) - here.density) < 2e-3);
        QVERIFY(std::abs(seenPaint(s, p->end(), at).opacity - here.opacity) < 0.03);
        QVERIFY(seenPaint(s, p->end(), at).segment < int(before.segments.size()));
    }
};

QTEST_GUILESS_MAIN(TestFade)
#include "test_fade.moc"
