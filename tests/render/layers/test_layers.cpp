// Layers for editing: the under layer is exact, the over map to 1e-5, and the frame after a drag exact again.
#include "tests/render/paintings.h"
#include "tests/trials.h"

using namespace suffuse;
using namespace suffuse::test;

class TestLayers : public QObject {
    Q_OBJECT

    const View m_view = View::ofArea(Rect::of(0, 0, 200, 150), 200, 150);

    static double difference(const FloatPicture &a, const FloatPicture &b)
    {
        double worst = 0;
        for (std::size_t i = 0; i < a.rgba.size(); ++i)
            worst = std::max(worst, std::abs(double(a.rgba[i]) - double(b.rgba[i])));
        return worst;
    }

private slots:
    void draggingAndLettingGo()
    {
        std::mt19937_64 random(17);
        for (const bool transparent : {false, true})
            for (int round = 0; round < 4; ++round) {
                const auto p = painting(randomStrokes(random, 24, 200, 150), 200, 150);
                const std::size_t index = 3 + random() % 18;
                const auto live = make(Backend::Cpu);
                FloatPicture picture;
                QVERIFY(live->render({p, p->end(), m_view, transparent}, picture));
                PaintingPtr q = p;
                for (int step = 1; step <= 12; ++step) {
                    q = withDensity(p, index, 1 + 0.05 * step);
                    QVERIFY(live->render({q, q->end(), m_view, transparent, true}, picture));
                    const FloatPicture exact = test::render(*make(Backend::Cpu), q, m_view, -1, transparent);
                    if (!transparent) // straight colours at no coverage are noise
                        QVERIFY2(difference(picture, exact) <= 1e-5,
                                 qPrintable(QStringLiteral("step %1: %2").arg(step).arg(difference(picture, exact))));
                    else
                        QVERIFY(worst(picture, exact).difference <= 1e-5);
                }
                QVERIFY(live->render({q, q->end(), m_view, transparent, false}, picture));
                QVERIFY(picture.rgba == test::render(*make(Backend::Cpu), q, m_view, -1, transparent).rgba);
            }
    }

    void editsOfOtherStrokesBetweenDrags()
    {
        std::mt19937_64 random(23);
        auto p = painting(randomStrokes(random, 30, 200, 150), 200, 150);
        const auto live = make(Backend::Cpu);
        FloatPicture picture;
        QVERIFY(live->render({p, p->end(), m_view}, picture));
        for (int step = 0; step < trials(150, 150); ++step) {
            const bool interactive = random() % 3 != 0;
            p = withDensity(p, random() % 5 == 0 ? random() % p->strokes.size() : std::size_t(step / 20 * 3), 0.97);
            RenderRequest request{p, p->end(), m_view, false, interactive};
            QVERIFY(live->render(request, picture));
            if (interactive)
                continue;
            QVERIFY2(picture.rgba == test::render(*make(Backend::Cpu), p, m_view).rgba,
                     qPrintable(QStringLiteral("step %1").arg(step)));
        }
    }

    void aLiveStrokeOnTop()
    {
        std::mt19937_64 random(29);
        const auto below = painting(randomStrokes(random, 20, 200, 150), 200, 150);
        Stroke growing = stroke(999, Shape::Curved, {100, 75}, 60, 5, styleOf(StyleKind::Edge));
        const std::vector<Segment> all = growing.segments;
        const auto live = make(Backend::Cpu);
        FloatPicture picture;
        for (int frame = 0; frame < 40; ++frame) {
            growing.segments.assign(all.begin(), all.begin() + 1 + std::min<std::ptrdiff_t>(2, frame / 10));
            for (std::size_t k = 0; k < growing.segments.size(); ++k)
                growing.segments[k].born = below->end() + Microseconds(k) * 160000;
            auto p = std::make_shared<Painting>(*below);
            p->strokes.push_back(std::make_shared<const Stroke>(growing));
            const Microseconds time = below->end() + frame * 16000;
            QVERIFY(live->render({p, time, m_view}, picture));
            QVERIFY2(picture.rgba == test::render(*make(Backend::Cpu), p, m_view, time).rgba,
                     qPrintable(QStringLiteral("frame %1").arg(frame)));
        }
    }

    /// What is painted dries from the bottom up: the layer below rises, a few strokes at a time, tile by tile.
    void strokesThatDryOneAfterAnother()
    {
        std::mt19937_64 random(37);
        const auto below = painting(randomStrokes(random, 20, 200, 150), 200, 150);
        std::vector<StrokePtr> drawn;
        for (int k = 0; k < 40; ++k) {
            Stroke s = stroke(StrokeId(900 + k), Shape::Curved, {20.0 + random() % 160, 20.0 + random() % 110},
                              20 + double(random() % 40), 4, styleOf(k % 2 ? StyleKind::Edge : StyleKind::Uniform));
            for (Segment &segment : s.segments)
                segment.born = below->end() + k * 100'000, segment.maxAge = 0.9f;
            drawn.push_back(std::make_shared<const Stroke>(s));
        }
        const auto live = make(Backend::Cpu);
        FloatPicture picture;
        for (int frame = 0; frame <= 110; ++frame) {
            auto p = std::make_shared<Painting>(*below);
            for (int k = 0; k < int(drawn.size()) && k <= frame / 2; ++k)
                if (frame < 100 || k != 12) // at last one of those that had dried goes
                    p->strokes.push_back(drawn[std::size_t(k)]);
            const Microseconds time = below->end() + frame * 50'000;
            const bool interactive = frame % 30 > 24;
            QVERIFY(live->render({p, time, m_view, false, interactive}, picture));
            if (!interactive)
                QVERIFY2(picture.rgba == test::render(*make(Backend::Cpu), p, m_view, time).rgba,
                         qPrintable(QStringLiteral("frame %1").arg(frame)));
        }
    }

    void aLongLiveStroke_data()
    {
        QTest::addColumn<bool>("varied");
        QTest::addColumn<bool>("oblique");
        QTest::addColumn<bool>("two");
        QTest::newRow("of one colour") << false << false << false;
        QTest::newRow("colour, granulation vary") << true << false << false;
        QTest::newRow("partly anisotropic") << false << true << false;
        QTest::newRow("another one dries below") << true << false << true;
    }

    /// Blocks of it dry while it grows and keep their nodes and sums: the picture is that of a stroke that was loaded.
    void aLongLiveStroke()
    {
        QFETCH(bool, varied);
        QFETCH(bool, oblique);
        QFETCH(bool, two);
        std::mt19937_64 random(31);
        const auto below = painting(randomStrokes(random, 6, 200, 150), 200, 150);
        const auto begun = [](StrokeId id, StyleKind kind) {
            Stroke s;
            s.id = id;
            s.style = styleOf(kind);
            return s;
        };
        Stroke lower = begun(998, StyleKind::Feathering), growing = begun(999, StyleKind::Uniform);
        const auto at = [](int k) {
            return Offset{float(100 + 80 * std::cos(0.05 * k)), float(75 + 60 * std::sin(0.11 * k))};
        };
        const auto segmentAt = [&](int frame) {
            Segment g;
            for (int i = 0; i < 4; ++i)
                g.bezier[std::size_t(i)] = {at(frame).x + float(i) / 3 * (at(frame + 1).x - at(frame).x),
                                            at(frame).y + float(i) / 3 * (at(frame + 1).y - at(frame).y)};
            g.diffusion = 6;
            g.density = 8;
            g.maxAge = 0.4f;
            g.born = below->end() + frame * 16000;
            if (varied) {
                g.colour = {0.5f + 0.4f * std::sin(0.1f * float(frame)), 0.3f,
                            0.5f + 0.4f * std::cos(0.07f * float(frame)), 0.9f};
                g.granulation = 0.5f + 0.4f * std::sin(0.2f * float(frame));
            }
            if (oblique && frame % 50 > 20)
                g.anisotropyRatio = 2, g.anisotropyAngle = 0.5f;
            return g;
        };
        const auto live = make(Backend::Cpu);
        FloatPicture picture;
        for (int frame = 1; frame <= 240; ++frame) {
            const Segment g = segmentAt(frame);
            growing.segments.push_back(g);
            if (two && frame < 120) {
                Segment other = segmentAt(frame + 300);
                other.born = g.born;
                lower.segments.push_back(other);
            }
            if (frame == 170) // it is edited where it is dry
                growing.segments[40].density = 3;
            if (frame == 190)
                growing.origin = {3, 1};
            if (frame == 210)
                growing.segments[100].style = styleOf(StyleKind::Edge);
            auto p = std::make_shared<Painting>(*below);
            if (two)
                p->strokes.push_back(std::make_shared<const Stroke>(lower));
            p->strokes.push_back(std::make_shared<const Stroke>(growing));
            const Microseconds time = g.born + (frame < 230 ? 20000 : frame * 16000); // at last all is dry
            const auto stats = live->render({p, time, m_view}, picture);
            QVERIFY(stats);
            if (frame > 100 && frame < 160 && !two)
                QVERIFY(stats->tilesEvaluated < stats->tiles);
            if (frame % 7 == 0 || frame > 165)
                QVERIFY2(picture.rgba == test::render(*make(Backend::Cpu), p, m_view, time).rgba,
                         qPrintable(QStringLiteral("frame %1").arg(frame)));
        }
    }
};

QTEST_GUILESS_MAIN(TestLayers)
#include "test_layers.moc"
