// One picture: the same bits for any tiling, thread count, instruction order, dirty region and history.
#include "render/backends.h"
#include "tests/render/paintings.h"
#include "tests/trials.h"

#include "model/painting/influence.h"
#include "render/cpu/kernels.h"

using namespace suffuse;
using namespace suffuse::test;

class TestOnePicture : public QObject {
    Q_OBJECT

    static bool same(const FloatPicture &a, const FloatPicture &b)
    {
        return a.width == b.width && a.height == b.height && a.rgba == b.rgba;
    }

    static PaintingPtr withStroke(const PaintingPtr &p, std::size_t index, const Stroke &s)
    {
        auto q = std::make_shared<Painting>(*p);
        q->strokes[index] = std::make_shared<const Stroke>(s);
        return q;
    }

    /// A view of other pixels in the same grid: its first one is (left, top) of the old one's.
    static View moved(const View &view, int left, int top, int width, int height)
    {
        View out = view;
        out.width = width, out.height = height;
        out.centre = view.toCanvas({left + 0.5 * width, top + 0.5 * height});
        return out;
    }

    static bool isPartOf(const FloatPicture &part, const FloatPicture &whole, int left, int top)
    {
        for (int y = 0; y < part.height; ++y)
            if (!std::equal(part.at(0, y), part.at(0, y) + part.width * 4, whole.at(left, top + y)))
                return false;
        return true;
    }

    /// A picture whose rendering is given up when some tiles have been stored.
    struct GivenUp : FloatPicture {
        std::atomic<bool> cancel = false;
        std::atomic<int> tilesLeft = 0;

        void store(const PixelRect &rect, const float *pixels, int stride) override
        {
            FloatPicture::store(rect, pixels, stride);
            if (--tilesLeft == 0)
                cancel = true;
        }
    };

private slots:
    /// ctest runs this program once for each SIMD instruction set that a machine may have.
    void initTestCase()
    {
        const QByteArray wanted = qgetenv("SUFFUSE_SIMD");
        if (!wanted.isEmpty() && wanted != cpu::kernels().name)
            QSKIP("this machine does not have that instruction set");
    }

    void tilingAndThreads()
    {
        std::mt19937_64 random(3);
        auto p = painting(randomStrokes(random, 25, 130, 101), 130, 101, {PaperKind::Procedural, 1, 16, 0.7f, {}});
        for (const View &v : {View::ofArea(p->canvas.area(), 130, 101), View{{60, 50}, 0.11, 0.5, true, 70, 61},
                              View{{60, 50}, 900, 0, false, 70, 61}}) {
            auto next = std::make_shared<Painting>(*p);
            next->canvas.paper.grain = PaperGrain((int(next->canvas.paper.grain) + 1) % 3);
            p = next;
            const FloatPicture first = test::render(*make(Backend::Cpu, 1, 16), p, v);
            for (int tile : {8, 16, 24, 32, 64})
                for (int threads : {1, 2, 5, 16})
                    QVERIFY2(same(first, test::render(*make(Backend::Cpu, threads, tile), p, v)),
                             qPrintable(QStringLiteral("tile %1, %2 threads").arg(tile).arg(threads)));
        }
    }

    void cullingChangesNothing()
    {
        std::mt19937_64 random(4);
        const auto p =
            painting(randomStrokes(random, 25, 130, 101), 130, 101, {PaperKind::Procedural, 1, 16, 0.7f, {}});
        for (const View &v : {View::ofArea(p->canvas.area(), 130, 101), View{{60, 50}, 0.11, 0.5, true, 70, 61},
                              View{{60, 50}, 30, 0.2, false, 70, 61}, View{{60, 50}, 900, 0, false, 70, 61}})
            for (int tile : {8, 32}) {
                RendererOptions options{Backend::Cpu, 2, tile};
                const FloatPicture culled = test::render(**makeRenderer(options), p, v);
                options.cull = false;
                QVERIFY(same(culled, test::render(**makeRenderer(options), p, v)));
            }
    }

    void dirtyRedrawIsFullRedraw()
    {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> u(0, 1);
        auto p = painting(randomStrokes(random, 20, 96, 72), 96, 72);
        const auto live = make(Backend::Cpu, 0, 16); // 30 tiles, of which an edit reaches some
        FloatPicture picture;
        Microseconds time = p->end();
        const View view = View::ofArea(p->canvas.area(), 96, 72);
        QVERIFY(live->render({p, time, view, false}, picture));
        bool partial = false;
        for (int step = 0; step < 120; ++step) {
            const PaintingPtr q = randomlyEdited(p, random);
            if (random() % 6 == 0)
                time = Microseconds(u(random) * double(q->end()));
            p = q;
            const auto stats = live->render({p, time, view, false}, picture);
            QVERIFY(stats);
            partial |= stats->tilesEvaluated > 0 && stats->tilesEvaluated < stats->tiles;
            QVERIFY2(same(picture, test::render(*make(Backend::Cpu), p, view, time)),
                     qPrintable(QStringLiteral("step %1").arg(step)));
        }
        QVERIFY(partial);
    }

    /// A picture of a part has the bits of that part of the whole picture, wherever its tiles begin.
    void aCropIsAPartOfTheWhole()
    {
        std::mt19937_64 random(12);
        for (const PaperGrain grain : {PaperGrain::Tooth, PaperGrain::Weave}) {
            const auto p = painting(randomStrokes(random, 25, 130, 101), 130, 101,
                                    {PaperKind::Procedural, 1, 16, 0.7f, {}, grain});
            for (const View &whole :
                 {View::ofArea(p->canvas.area(), 390, 303), View{{60, 50}, 0.11, 0.5, true, 170, 161},
                  View{{60.1, 50.7}, 7.3, 0.2, false, 211, 120}, View{{60, 50}, 900, 0, false, 170, 161},
                  View{{60, 50}, 3e6, 1, true, 96, 64}}) {
                const FloatPicture all = test::render(*make(Backend::Cpu, 2), p, whole);
                for (int k = 0; k < 6; ++k) {
                    const int left = int(random() % 60), top = int(random() % 40);
                    const View part = moved(whole, left, top, whole.width - left - int(random() % 30),
                                            whole.height - top - int(random() % 20));
                    QVERIFY2(
                        isPartOf(test::render(*make(Backend::Cpu, 1 + int(random() % 2)), p, part), all, left, top),
                        qPrintable(QStringLiteral("zoom %1, from %2, %3").arg(whole.scale).arg(left).arg(top)));
                }
            }
        }
    }

    /// A renderer whose picture is moved by whole pixels draws what comes into view alone, and has the bits of a new
    /// one, whatever is edited between.
    void movingByWholePixelsIsFullRedraw()
    {
        std::mt19937_64 random(13);
        auto p = painting(randomStrokes(random, 20, 400, 300), 400, 300, {PaperKind::Procedural, 1, 16, 0.7f, {}});
        for (const View &start :
             {View::ofArea(p->canvas.area(), 400, 300), View{{200, 150}, 1.7, 0.4, true, 301, 233}}) {
            const auto live = make(Backend::Cpu, 2, 16);
            GivenUp picture;
            View view = start;
            Microseconds time = p->end();
            QVERIFY(live->render({p, time, view, false}, picture));
            int partial = 0;
            for (int step = 0; step < 60; ++step) {
                const bool edits = random() % 5 == 0;
                if (edits)
                    p = randomlyEdited(p, random);
                if (random() % 8 == 0)
                    time = Microseconds(double(random() % 1000) * 1e-3 * double(p->end()));
                if (random() % 6 == 0) {
                    picture.cancel = false;
                    picture.tilesLeft = 5;
                    QVERIFY(live->render({p, time, view, false}, picture, &picture.cancel));
                }
                view = moved(view, int(random() % 41) - 20, int(random() % 41) - 20, view.width, view.height);
                const auto stats = live->render({p, time, view, false, step % 7 == 0}, picture);
                QVERIFY(stats);
                partial += stats->tilesEvaluated < stats->tiles;
                if (step % 7 == 0) // A gesture may use maps that are not exact to the bit.
                    QVERIFY(live->render({p, time, view, false}, picture));
                QVERIFY2(same(picture, test::render(*make(Backend::Cpu), p, view, time)),
                         qPrintable(QStringLiteral("step %1").arg(step)));
            }
            QVERIFY2(partial > 30, qPrintable(QString::number(partial)));
        }
    }

    void onlyWhatChangedIsEvaluated()
    {
        const auto p = painting({stroke(1, Shape::Straight, {60, 40}, 30, 4, styleOf(StyleKind::Uniform)),
                                 stroke(2, Shape::Curved, {300, 200}, 60, 6, styleOf(StyleKind::Edge))},
                                400, 300);
        const auto renderer = make(Backend::Cpu);
        FloatPicture picture;
        const View view = View::ofArea(p->canvas.area(), 400, 300);
        QVERIFY(renderer->render({p, p->end(), view, false}, picture));
        const auto idle = renderer->render({p, p->end() + 5'000'000, view, false}, picture);
        QVERIFY(idle);
        QCOMPARE(idle->tilesEvaluated, 0);

        Stroke s = *p->strokes[1];
        s.segments[2].density *= 1.1f;
        const auto q = withStroke(p, 1, s);
        const auto stats = renderer->render({q, q->end(), view, false}, picture);
        QVERIFY(stats);
        QVERIFY(stats->tilesEvaluated > 0);
        // The segment's influence, old = new here, and the rest of the windows it shares, rounded to tiles.
        const Rect touched = influenceOf(s, s.segments[2], q->end()).grown(2.5 * 6 + 34);
        for (const PixelRect &r : stats->dirty) {
            QVERIFY(touched.contains({double(r.x), double(r.y)}));
            QVERIFY(touched.contains({double(r.x + r.width), double(r.y + r.height)}));
        }
    }

    void reorderingRedrawsTheMovedStrokesOnly()
    {
        std::vector<Stroke> strokes;
        for (int i = 0; i < 6; ++i)
            strokes.push_back(
                stroke(StrokeId(i + 1), Shape::Straight, {60.0 + 90 * i, 60}, 25, 4, styleOf(StyleKind::Uniform)));
        const auto p = painting(strokes, 600, 120);
        const auto renderer = make(Backend::Cpu);
        FloatPicture picture;
        const View view = View::ofArea(p->canvas.area(), 600, 120);
        QVERIFY(renderer->render({p, p->end(), view, false}, picture));
        auto q = std::make_shared<Painting>(*p);
        std::rotate(q->strokes.begin(), q->strokes.begin() + 1, q->strokes.end());
        const auto stats = renderer->render({q, q->end(), view, false}, picture);
        QVERIFY(stats);
        for (const PixelRect &r : stats->dirty)
            QVERIFY(r.x < 140); // stroke 1 alone
        QVERIFY(stats->tilesEvaluated > 0);
    }

    void cancelledWorkIsDoneLater()
    {
        std::mt19937_64 random(9);
        const auto p = painting(randomStrokes(random, 10, 200, 150), 200, 150);
        const View view = View::ofArea(p->canvas.area(), 200, 150);
        const auto renderer = make(Backend::Cpu);
        FloatPicture picture;
        std::atomic<bool> cancel{true};
        const auto first = renderer->render({p, p->end(), view, false}, picture, &cancel);
        QVERIFY(first && first->cancelled);
        const auto second = renderer->render({p, p->end(), view, false}, picture);
        QVERIFY(second && !second->cancelled);
        QVERIFY(same(picture, test::render(*make(Backend::Cpu), p, view)));
    }

    void extremeValuesGiveNoNaN()
    {
        std::mt19937_64 random(13);
        std::uniform_real_distribution<double> u(0, 1);
        const auto renderer = make(Backend::Cpu);
        for (int i = 0, all = trials(30, 300); i < all; ++i) {
            auto strokes = randomStrokes(random, 4, 64, 48);
            for (Stroke &s : strokes)
                for (Segment &g : s.segments) {
                    g.diffusion = float(std::pow(10, -12 + 24 * u(random)));
                    g.density = float(std::pow(10, -20 + 32 * u(random)));
                    g.maxAge = float(std::pow(10, -6 + 12 * u(random)));
                }
            const auto p = painting(strokes, 64, 48);
            const FloatPicture picture =
                test::render(*renderer, p, View{{32, 24}, std::pow(10, -2 + 4 * u(random)), 0, false, 16, 12});
            for (float v : picture.rgba)
                QVERIFY(v >= 0 && v <= 1);
        }
    }
};

QTEST_GUILESS_MAIN(TestOnePicture)
#include "test_one_picture.moc"
