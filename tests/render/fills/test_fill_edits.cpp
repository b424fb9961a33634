// One picture of fills: the same bits for any tiling, thread count, part, dirty region and history; and edits redraw no
// more than they change.
#include "tests/render/filled.h"

#include "model/area/outline.h"
#include "model/shaping/erasing/fill_cut.h"
#include "tests/trials.h"

using namespace suffuse;
using namespace suffuse::test;

namespace {

bool same(const FloatPicture &a, const FloatPicture &b)
{
    return a.width == b.width && a.height == b.height && a.rgba == b.rgba;
}

QString whereDifferent(const FloatPicture &a, const FloatPicture &b)
{
    const Worst w = worst(a, b);
    return QStringLiteral("%1 at %2, %3").arg(w.difference).arg(w.x).arg(w.y);
}

} // namespace

class TestFillEdits : public QObject {
    Q_OBJECT

private slots:
    void tilingAndThreads()
    {
        std::mt19937_64 random(3);
        const auto p = mixedFills(random, 6, 130, 101, PaperKind::Procedural);
        for (const View &v : {View::ofArea(p->canvas.area(), 130, 101), View{{60, 50}, 0.3, 0.5, true, 40, 31},
                              View{{60, 50}, 5000, 0, false, 70, 61}}) {
            const FloatPicture first = test::render(*make(Backend::Cpu, 1, 16), p, v);
            for (const int tile : {8, 24, 32, 64}) {
                const FloatPicture other = test::render(*make(Backend::Cpu, tile % 3 + 1, tile), p, v);
                QVERIFY2(same(first, other), qPrintable(QStringLiteral("tile %1, zoom %2: %3")
                                                            .arg(tile)
                                                            .arg(v.scale)
                                                            .arg(whereDifferent(first, other))));
            }
        }
    }

    void cullingChangesNothing()
    {
        std::mt19937_64 random(4);
        const auto p = mixedFills(random, 6, 130, 101, PaperKind::Procedural);
        for (const View &v : {View::ofArea(p->canvas.area(), 130, 101), View{{60, 50}, 30, 0.2, false, 70, 61},
                              View{{60, 50}, 900, 0, false, 70, 61}})
            for (const int tile : {8, 32}) {
                RendererOptions options{Backend::Cpu, 2, tile};
                const FloatPicture culled = test::render(**makeRenderer(options), p, v);
                options.cull = false;
                QVERIFY(same(culled, test::render(**makeRenderer(options), p, v)));
            }
    }

    void aCropIsAPartOfTheWhole()
    {
        std::mt19937_64 random(12);
        const auto p = mixedFills(random, 6, 130, 101, PaperKind::Procedural);
        for (const View &whole : {View::ofArea(p->canvas.area(), 390, 303), View{{60, 50}, 0.3, 0.5, true, 100, 91},
                                  View{{60, 50}, 900, 0, false, 170, 161}, View{{60, 50}, 3e6, 1, true, 96, 64}}) {
            const FloatPicture all = test::render(*make(Backend::Cpu, 2), p, whole);
            for (int k = 0; k < 4; ++k) {
                const int left = int(random() % 40), top = int(random() % 30);
                View part = whole;
                part.width -= left + int(random() % 20), part.height -= top + int(random() % 10);
                part.centre = whole.toCanvas({left + 0.5 * part.width, top + 0.5 * part.height});
                const FloatPicture cut = test::render(*make(Backend::Cpu, 1), p, part);
                for (int y = 0; y < cut.height; ++y)
                    QVERIFY2(std::equal(cut.at(0, y), cut.at(0, y) + cut.width * 4, all.at(left, top + y)),
                             qPrintable(QStringLiteral("zoom %1, row %2").arg(whole.scale).arg(y)));
            }
        }
    }

    void dirtyRedrawIsFullRedraw_data()
    {
        QTest::addColumn<double>("scale");
        QTest::newRow("1") << 1.0;
        QTest::newRow("3") << 3.0;
    }
    void dirtyRedrawIsFullRedraw()
    {
        QFETCH(double, scale);
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> u(0, 1);
        PaintingPtr p = mixedFills(random, 5, 96, 72, PaperKind::None);
        const auto live = make(Backend::Cpu, 0, 16);
        FloatPicture picture;
        Microseconds time = p->end();
        const View view{{48, 36}, scale, 0, false, 96, 72};
        QVERIFY(live->render({p, time, view, false}, picture));
        int partial = 0;
        for (int step = 0; step < 150; ++step) {
            p = random() % 5 == 0 ? randomlyEdited(p, random) : withEditedFill(p, random);
            if (random() % 8 == 0)
                time = Microseconds(u(random) * double(p->end()));
            const bool drags = random() % 6 == 0;
            const auto stats = live->render({p, time, view, false, drags}, picture);
            QVERIFY(stats);
            partial += stats->tilesEvaluated > 0 && stats->tilesEvaluated < stats->tiles;
            if (drags)
                QVERIFY(live->render({p, time, view, false}, picture));
            const FloatPicture whole = test::render(*make(Backend::Cpu), p, view, time);
            QVERIFY2(same(picture, whole),
                     qPrintable(QStringLiteral("step %1: %2").arg(step).arg(whereDifferent(picture, whole))));
        }
        QVERIFY2(partial > 20, qPrintable(QString::number(partial)));
    }

    /// Level edges are no arcs. Where nothing but them has moved, for example when a rectangle grows, that is drawn again.
    void levelEdgesAreDrawnAgain()
    {
        std::mt19937_64 random(8);
        std::uniform_real_distribution<double> u(0, 1);
        for (const double spread : {0.0, 0.4, 3.0}) {
            Rect box = Rect::of(20, 20, 200, 90);
            const auto shown = [&] {
                Stroke s = emptyFill(1, spread, styleOf(StyleKind::Uniform));
                addRectangle(s, box);
                return painting({s}, 240, 130);
            };
            const auto live = make(Backend::Cpu, 0, 16);
            const View view = View::ofArea(Rect::of(0, 0, 240, 130), 240, 130);
            FloatPicture picture;
            for (int step = 0; step < 25; ++step) {
                const auto p = shown();
                QVERIFY(live->render({p, p->end(), view, false}, picture));
                const FloatPicture whole = test::render(*make(Backend::Cpu), p, view);
                QVERIFY2(same(picture, whole),
                         qPrintable(QStringLiteral("step %1: %2").arg(step).arg(whereDifferent(picture, whole))));
                const double by = std::round(12 * u(random) - 6) + (step % 2 ? 0.3 : 0);
                if (step % 3 != 0)
                    box.top += by;
                if (step % 3 != 1)
                    box.bottom += by;
                if (step % 5 == 4)
                    box.right += by;
            }
        }
    }

    /// A node of a large area is moved: what is far from it is not drawn again, neither on the outline nor within.
    void onlyWhatChangedIsEvaluated()
    {
        Stroke s = emptyFill(1, 4, styleOf(StyleKind::Uniform));
        addPolygon(s, {{50, 50}, {200, 50}, {350, 50}, {350, 250}, {50, 250}});
        const auto p = painting({s}, 400, 300);
        const auto renderer = make(Backend::Cpu, 0, 16);
        FloatPicture picture;
        const View view = View::ofArea(p->canvas.area(), 400, 300);
        QVERIFY(renderer->render({p, p->end(), view, false}, picture));
        s.segments[0].bezier[3] = s.segments[1].bezier[0] = {200, 40};
        const auto q = withStroke(p, 0, s);
        const auto stats = renderer->render({q, q->end(), view, false}, picture);
        QVERIFY(stats && stats->tilesEvaluated > 0);
        for (const PixelRect &r : stats->dirty)
            QVERIFY2(r.y + r.height <= 50 + 32 + 16, qPrintable(QStringLiteral("%1, %2").arg(r.x).arg(r.y)));
        QVERIFY(same(picture, test::render(*make(Backend::Cpu), q, view)));
        // A corner that swings far: what comes inside is drawn, though no outline is near.
        s.segments[1].bezier[3] = s.segments[2].bezier[0] = {390, 10};
        const auto r = withStroke(q, 0, s);
        QVERIFY(renderer->render({r, r->end(), view, false}, picture));
        QVERIFY(same(picture, test::render(*make(Backend::Cpu), r, view)));
        // Another colour changes all of it, and nothing beyond.
        changeFill(s, [](Fill &f) { f.colour = {1, 0, 0, 1}; });
        const auto last = withStroke(r, 0, s);
        QVERIFY(renderer->render({last, last->end(), view, false}, picture));
        QVERIFY(same(picture, test::render(*make(Backend::Cpu), last, view)));
    }

    /// The Knife cuts fills into pieces whose picture is that of the whole: both are within 1/512 of the truth, which is
    /// the same. Plain paint shows what of the area is missing; grains and steep styles can show the last bits of an
    /// outline.
    void cutsThroughFillsDoNotShow()
    {
        for (int seed = 0; seed < trials(20, 500); ++seed) {
            std::mt19937_64 random(std::uint64_t(seed) + 21);
            std::uniform_real_distribution<double> u(0, 130);
            const auto p = mixedFills(random, 6, 130, 101, PaperKind::Procedural);
            StrokeList whole, cut;
            std::size_t chains = 0, before = 0;
            for (const StrokePtr &stroke : p->strokes) {
                Stroke plain = *stroke;
                plain.style = styleOf(StyleKind::Uniform);
                if (plain.fill)
                    changeFill(plain, [](Fill &f) { f.granulation = 1; });
                whole.push_back(std::make_shared<const Stroke>(plain));
                Stroke pieces = plain;
                for (int i = 0; i < 3 && pieces.fill; ++i) {
                    const double from = u(random), to = u(random);
                    pieces = filledCut(pieces, {-30, from}, {160, to});
                }
                before += chainsOf(*stroke).size();
                chains += chainsOf(pieces).size();
                cut.push_back(std::make_shared<const Stroke>(pieces));
            }
            QVERIFY(chains > before);
            const auto of = [&](const StrokeList &strokes) {
                Painting q = *p;
                q.strokes = strokes;
                return std::make_shared<const Painting>(q);
            };
            for (const View &v : {View::ofArea(p->canvas.area(), 130, 101), View{{60, 50}, 9, 0.2, false, 120, 90}}) {
                const Worst w = worst(test::render(*make(Backend::Cpu), of(whole), v),
                                      test::render(*make(Backend::Cpu), of(cut), v));
                QVERIFY2(w.difference < 2.0 / 512,
                         qPrintable(QString("seed %1: %2 at %3, %4").arg(seed).arg(w.difference).arg(w.x).arg(w.y)));
            }
        }
    }

    void extremeValuesGiveNoNaN()
    {
        std::mt19937_64 random(13);
        std::uniform_real_distribution<double> u(0, 1);
        const auto renderer = make(Backend::Cpu);
        for (int i = 0; i < 100; ++i) {
            std::vector<Stroke> strokes;
            for (int k = 0; k < 3; ++k) {
                Stroke s = randomFill(random, StrokeId(k + 1), 64, 48, 3);
                changeFill(s, [&](Fill &f) {
                    f.diffusion = float(std::pow(10, -38 + 50 * u(random)));
                    f.density = float(std::pow(10, -20 + 32 * u(random)));
                    f.maxAge = float(std::pow(10, -6 + 12 * u(random)));
                    f.anisotropyRatio = float(std::pow(10, -6 + 12 * u(random)));
                });
                if (random() % 3 == 0)
                    for (Segment &g : s.segments)
                        for (Offset &o : g.bezier)
                            o = {o.x * 1e9f, o.y * 1e-9f};
                strokes.push_back(s);
            }
            const auto p = painting(strokes, 64, 48);
            const FloatPicture picture =
                test::render(*renderer, p, View{{32, 24}, std::pow(10, -2 + 4 * u(random)), 0, false, 16, 12});
            for (const float v : picture.rgba)
                QVERIFY(v >= 0 && v <= 1);
        }
    }
};

QTEST_GUILESS_MAIN(TestFillEdits)
#include "test_fill_edits.moc"
