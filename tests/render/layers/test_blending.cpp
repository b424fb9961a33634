// Groups that blend: the formulas of each mode, trees of groups against the reference, and one picture for all of them.
#include "tests/render/filled.h"
#include "tests/render/layers/grouped.h"

#include "render/composition/composition.h"
#include "render/math/scalar.h"
#include "render/reference/compositing.h"
#include "tests/trials.h"
// It has templates over the numbers, which must be declared before.
#include "render/math/blend.h"

using namespace suffuse;
using namespace suffuse::test;

namespace {

/// What layers begin (+) and end (−) before each stroke of a list, and at the end, by the ids of their groups.
QString walked(const Composition &composition, const std::vector<std::size_t> &strokes)
{
    QStringList out;
    LayerWalk walk(composition);
    const auto note = [&](char sign) {
        return [&out, &composition, sign](int layer) {
            out << QChar(sign) + QString::number(composition.layers[std::size_t(layer)].group);
        };
    };
    for (const std::size_t stroke : strokes) {
        walk.toStroke(stroke, note('+'), note('-'));
        out << QString::number(stroke);
    }
    walk.toEnd(note('+'), note('-'));
    return out.join(' ');
}

/// Strokes in these groups, one each; 0: in none.
PaintingPtr strokesIn(const std::vector<GroupId> &groups, const std::vector<Group> &known)
{
    auto p = std::make_shared<Painting>();
    p->groups = known;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        Stroke s = test::stroke(i + 1, Shape::Straight, {20, 20}, 10, 3, styleOf(StyleKind::Uniform));
        s.group = groups[i];
        p->strokes.push_back(std::make_shared<const Stroke>(s));
    }
    return p;
}

Group group(GroupId id, GroupId parent, float opacity, BlendMode blend = BlendMode::Normal)
{
    Group g;
    g.id = id, g.parent = parent, g.opacity = opacity, g.blend = blend;
    return g;
}

/// A fill whose style does not jump, so that what is measured comes from the groups.
Stroke evenFill(std::mt19937_64 &random, StrokeId id, double spread)
{
    Stroke fill = randomFill(random, id, 96, 72, spread);
    fill.style = styleOf(StyleKind::Uniform);
    for (Segment &segment : fill.segments)
        segment.style.reset();
    return fill;
}

const View sheet = View::ofArea(Rect::of(0, 0, 96, 72), 96, 72);

} // namespace

class TestBlending : public QObject {
    Q_OBJECT

    std::unique_ptr<Renderer> m_cpu = make(Backend::Cpu), m_reference = make(Backend::Reference);

private slots:
    void layersOfAPainting()
    {
        const std::vector<Group> groups{group(1, 0, 0.5f), group(2, 1, 1), group(3, 1, 0.5f), group(4, 0, 1)};
        const Composition c = compositionOf(*strokesIn({0, 1, 2, 3, 3, 1, 4}, groups));
        QCOMPARE(c.layers.size(), std::size_t(2)); // 2 and 4 are passed through
        QCOMPARE(c.of, (std::vector<int>{-1, 0, 0, 1, 1, 0, -1}));
        QCOMPARE(c.layers[0].first, std::size_t(1));
        QCOMPARE(c.layers[0].last, std::size_t(6));
        QCOMPARE(c.layers[1].parent, 0);
        QCOMPARE(walked(c, {0, 1, 2, 3, 4, 5, 6}), QString("0 +1 1 2 +3 3 4 -3 5 -1 6"));
        QCOMPARE(walked(c, {0, 4, 6}), QString("0 +1 +3 4 -3 -1 6"));
        QCOMPARE(walked(c, {6}), QString("6"));
        QVERIFY(compositionOf(*strokesIn({0, 2, 4}, {group(2, 0, 1), group(4, 2, 1)})).isFlat());
    }

    void whatActsEverywhereIsNeverLeftOut()
    {
        const std::vector<Group> groups{group(1, 0, 0.5f), group(2, 1, 1, BlendMode::DestinationIn)};
        const Composition c = compositionOf(*strokesIn({0, 1, 2, 0}, groups));
        QCOMPARE(walked(c, {0, 3}), QString("0 +1 +2 -2 -1 3"));
        QCOMPARE(walked(c, {1}), QString("+1 1 +2 -2 -1"));
        QCOMPARE(walked(c, {}), QString("+1 +2 -2 -1"));
    }

    /// A group whose strokes do not stand together is a layer for each run of them.
    void runsOfAGroup()
    {
        const Composition c = compositionOf(*strokesIn({1, 0, 1}, {group(1, 0, 0.5f)}));
        QCOMPARE(walked(c, {0, 1, 2}), QString("+1 0 -1 1 +1 2 -1"));
        QCOMPARE(c.layers[1].run, 1);
    }

    void hiddenGroupsAreNoLayers()
    {
        Group hidden = group(1, 0, 0.5f);
        hidden.visible = false;
        QVERIFY(compositionOf(*strokesIn({0, 1}, {hidden})).isFlat());
    }

    /// Each mode by float32 against the text of the recommendation in double precision.
    void modes_data()
    {
        QTest::addColumn<int>("mode");
        for (int i = 0; i < blendModes; ++i)
            QTest::addRow("mode %d", i) << i;
    }
    void modes()
    {
        QFETCH(int, mode);
        std::mt19937_64 random(unsigned(mode) + 1);
        std::uniform_real_distribution<double> u(0, 1);
        const auto spot = [&](bool opaque) {
            // What paint leaves: it lies over white as far as it covers.
            const double a = random() % 8 == 0 ? double(random() % 2) : u(random), shade = opaque ? 1 : a;
            reference::Spot out{{}, a};
            for (double &c : out.colour)
                c = double(float(shade * (random() % 6 == 0 ? double(random() % 2) : u(random))));
            out.coverage = double(float(a));
            return out;
        };
        const auto pixelOf = [](const reference::Spot &s) {
            return math::Pixel<float>{float(s.colour[0]), float(s.colour[1]), float(s.colour[2]), float(s.coverage)};
        };
        double worst = 0;
        for (int i = 0; i < 20'000; ++i) {
            const bool opaque = i % 2;
            const reference::Spot source = spot(false), below = spot(opaque);
            const reference::Rgb canvas{1, double(float(u(random))), 0.25};
            reference::Item item;
            item.blend = BlendMode(mode), item.opacity = double(i % 3 ? float(u(random)) : 1.0f);
            LayerPut how{item.blend, float(item.opacity), opaque, {1, 1, 1}};
            for (std::size_t c = 0; c < 3 && opaque; ++c)
                how.bare[c] = float(canvas[c]);
            reference::Spot expected = below;
            reference::put(item, 1, source, opaque ? &canvas : nullptr, expected);
            const math::Pixel<float> out = math::put(how, how.opacity, pixelOf(source), pixelOf(below));
            const reference::Rgb wanted = reference::rgbOfRyb(expected.colour);
            const reference::Rgb found = reference::rgbOfRyb({double(out.red), double(out.yellow), double(out.blue)});
            // Float32 leaves 2⁻²⁴ of each argument uncertain; a quotient makes as much more of that as it is steep.
            for (std::size_t c = 0; c < 3; ++c)
                worst = std::max(worst, std::abs(wanted[c] - found[c]));
            worst = std::max(worst, std::abs(expected.coverage - double(out.coverage)));
        }
        QVERIFY2(worst <= 1.0 / 4096, qPrintable(QString::number(worst * 4096)));
    }

    void nothingAboveKeepsTheBits()
    {
        std::mt19937_64 random(4);
        std::uniform_real_distribution<float> u(0, 1);
        for (int mode = 0; mode < blendModes; ++mode) {
            if (BlendMode(mode) == BlendMode::DestinationIn)
                continue;
            for (int i = 0; i < 100; ++i) {
                const math::Pixel<float> below{u(random), u(random), u(random), u(random)};
                const auto out = math::put(LayerPut{BlendMode(mode), 0.7f, i % 2 == 0, {1, 1, 1}}, 0.7f,
                                           math::Pixel<float>{0, 0, 0, 0}, below);
                QVERIFY(out.red == below.red && out.yellow == below.yellow && out.blue == below.blue &&
                        out.coverage == below.coverage);
            }
        }
    }

    void randomTrees()
    {
        const int all = trials(40, 2000);
        double most = 0;
        for (int i = 0; i < all; ++i) {
            std::mt19937_64 random(firstSeed() + unsigned(i) + 1);
            auto strokes = randomStrokes(random, 9, 96, 72);
            for (StrokeId id = 10; id < (i % 10 == 0 ? 13u : 10u); ++id) // The reference takes long for fills.
                strokes.push_back(evenFill(random, id, id == 12 ? 0.001 : 4));
            std::ranges::shuffle(strokes, random);
            auto flat = painting(std::move(strokes), 96, 72,
                                 {i % 3 ? PaperKind::None : PaperKind::Procedural, 1, 16, 0.7f, {}});
            auto p = std::make_shared<Painting>(*grouped(flat, random));
            p->canvas.background = {0.1f, 0.3f, 0.05f, i % 2 ? 1 : 0.6f};
            const bool transparent = i % 4 == 3;
            const Worst w = worst(test::render(*m_cpu, p, sheet, -1, transparent),
                                  test::render(*m_reference, p, sheet, -1, transparent));
            most = std::max(most, w.difference);
            QVERIFY2(
                w.difference <= 1.0 / 512,
                qPrintable(
                    QStringLiteral("seed %1: %2/512 at %3, %4").arg(i + 1).arg(512 * w.difference).arg(w.x).arg(w.y)));
        }
        qInfo("%d trees, at most %.3f/512", all, 512 * most);
    }

    /// All modes on colours between the extremes, where the slope of each is bounded.
    void everyMode()
    {
        for (int mode = 0; mode < blendModes; ++mode)
            for (const bool transparent : {false, true}) {
                if (!isTried(2 * mode + transparent))
                    continue;
                auto p = std::make_shared<Painting>();
                p->canvas.width = 96, p->canvas.height = 72;
                p->canvas.background = {0.1f, 0.25f, 0.2f, 1};
                p->groups = {group(1, 0, 0.8f, BlendMode(mode))};
                const Colour colours[] = {
                    {0.2f, 0.5f, 0.35f, 0.8f}, {0.6f, 0.3f, 0.45f, 0.7f}, {0.3f, 0.4f, 0.6f, 0.9f}};
                for (std::size_t i = 0; i < 3; ++i) {
                    Stroke s = test::stroke(i + 1, Shape::Curved, {30 + 14.0 * double(i), 36}, 26, 6,
                                            styleOf(StyleKind(i)), {}, colours[i]);
                    s.group = i > 0;
                    p->strokes.push_back(std::make_shared<const Stroke>(s));
                }
                const Worst w = worst(test::render(*m_cpu, p, sheet, -1, transparent),
                                      test::render(*m_reference, p, sheet, -1, transparent));
                QVERIFY2(w.difference <= 1.0 / 512,
                         qPrintable(QStringLiteral("%1: %2/512").arg(mode).arg(512 * w.difference)));
            }
    }

    void groupsThatPassThroughChangeNothing()
    {
        std::mt19937_64 random(11);
        for (int i = 0; i < 10; ++i) {
            const auto flat = painting(randomStrokes(random, 20, 96, 72), 96, 72);
            auto p = std::make_shared<Painting>(*grouped(flat, random));
            for (Group &g : p->groups)
                g = Group{g.id, g.name, g.parent};
            QVERIFY(test::render(*m_cpu, p, sheet).rgba == test::render(*m_cpu, flat, sheet).rgba);
        }
    }

    void tilingAndThreads()
    {
        std::mt19937_64 random(3);
        for (int i = 0; i < 6; ++i) {
            const auto p = grouped(painting(randomStrokes(random, 20, 130, 101), 130, 101), random);
            const View view = View::ofArea(p->canvas.area(), 130, 101);
            const FloatPicture first = test::render(*make(Backend::Cpu, 1, 16), p, view);
            for (const int tile : {8, 24, 32, 64})
                for (const bool cull : {true, false}) {
                    const auto other = makeRenderer({Backend::Cpu, 2, tile, cull});
                    QVERIFY2(first.rgba == test::render(**other, p, view).rgba,
                             qPrintable(QStringLiteral("%1: tile %2").arg(i).arg(tile)));
                }
        }
    }

    /// Any history of edits of strokes and groups leads to the picture that is drawn at once.
    void dirtyRedrawIsFullRedraw()
    {
        std::mt19937_64 random(5);
        for (const bool transparent : {false, true}) {
            auto p = grouped(painting(randomStrokes(random, 18, 96, 72), 96, 72), random);
            const auto live = make(Backend::Cpu, 0, 16);
            FloatPicture picture;
            bool partial = false;
            for (int step = 0; step < trials(150, 2000); ++step) {
                p = random() % 2 ? regrouped(p, random) : randomlyEdited(p, random);
                const bool drags = random() % 4 == 0;
                const auto stats = live->render({p, p->end(), sheet, transparent, drags}, picture);
                QVERIFY(stats);
                partial |= stats->tilesEvaluated > 0 && stats->tilesEvaluated < stats->tiles;
                if (drags)
                    QVERIFY(live->render({p, p->end(), sheet, transparent}, picture));
                QVERIFY2(picture.rgba == test::render(*m_cpu, p, sheet, -1, transparent).rgba,
                         qPrintable(QStringLiteral("step %1").arg(step)));
            }
            QVERIFY(partial);
        }
    }

    /// While one stroke is dragged, or the opacity of a group, what lies above it is not drawn again. Such frames
    /// differ from the picture by rounding, and the frame after them does not differ.
    void dragsKeepWhatLiesAbove()
    {
        int strokesAbove = 0, withLayers = 0, keptWithBounds = 0;
        for (int i = 0; i < trials(48, 400); ++i) {
            std::mt19937_64 random(firstSeed() + unsigned(i) + 70);
            auto p = std::make_shared<Painting>(*grouped(painting(randomStrokes(random, 16, 96, 72), 96, 72), random));
            if (i % 2) // Else something may be clipped or masked.
                for (Group &g : p->groups)
                    g.clips = g.mask = false;
            const bool transparent = random() % 2, ofGroup = random() % 2 && !p->groups.empty();
            const std::size_t stroke = random() % p->strokes.size();
            const std::size_t group = ofGroup ? random() % p->groups.size() : 0;
            withLayers += !compositionOf(*p).isFlat() && !compositionOf(*p).isBounded;
            const auto live = make(Backend::Cpu, 0, 16);
            FloatPicture picture;
            QVERIFY(live->render({p, p->end(), sheet, transparent}, picture));
            for (int frame = 0; frame < 5; ++frame) {
                auto q = std::make_shared<Painting>(*p);
                if (ofGroup)
                    q->groups[group].opacity = float(1 + random() % 8) / 9;
                else
                    q = std::make_shared<Painting>(*withDensity(q, stroke, 0.5 + double(random() % 8) / 8));
                p = q;
                QVERIFY(live->render({p, p->end(), sheet, transparent, true}, picture));
                const FloatPicture exact = test::render(*m_cpu, p, sheet, -1, transparent);
                const Worst w = worst(picture, exact);
                keptWithBounds += compositionOf(*p).isBounded && picture.rgba != exact.rgba;
                QVERIFY2(w.difference < 1.0 / 1024, qPrintable(QStringLiteral("%1, frame %2: %3/1024 at %4, %5")
                                                                   .arg(i)
                                                                   .arg(frame)
                                                                   .arg(1024 * w.difference)
                                                                   .arg(w.x)
                                                                   .arg(w.y)));
            }
            QVERIFY(live->render({p, p->end(), sheet, transparent}, picture));
            QVERIFY(picture.rgba == test::render(*m_cpu, p, sheet, -1, transparent).rgba);
            strokesAbove += stroke + 1 < p->strokes.size();
        }
        QVERIFY(strokesAbove > 0 && withLayers > 0 && keptWithBounds > 0);
    }

    /// A stroke is dragged to and fro, with and without layers. Blocks that it meets neither before nor now are not
    /// painted again, and whatever differs lies in what a frame says was painted.
    void aDragPaintsWhatTheStrokeMeets()
    {
        const View view = View::ofArea(Rect::of(0, 0, 192, 144), 192, 144);
        for (const bool inLayers : {false, true}) {
            std::mt19937_64 random(41);
            auto p = std::make_shared<Painting>(*painting(randomStrokes(random, 16, 192, 144), 192, 144));
            if (inLayers)
                p = std::make_shared<Painting>(*grouped(p, random));
            for (Group &g : p->groups)
                g.clips = g.mask = false;
            Stroke thin = stroke(999, Shape::Straight, {96, 72}, 60, 2, styleOf(StyleKind::Uniform));
            thin.group = p->strokes[8]->group;
            p->strokes[8] = std::make_shared<const Stroke>(thin);
            const auto live = make(Backend::Cpu, 0, 48);
            FloatPicture picture;
            QVERIFY(live->render({p, p->end(), view}, picture));
            int spared = 0;
            for (int frame = 0; frame < 16; ++frame) {
                const bool drags = frame % 7 != 6; // Else it lies still for a frame.
                const FloatPicture before = picture;
                auto moved = std::make_shared<Stroke>(thin);
                moved->origin.y += 40 * std::sin(0.9 * frame);
                p = std::make_shared<Painting>(*p);
                p->strokes[8] = std::move(moved);
                const auto stats = live->render({p, p->end(), view, false, drags}, picture);
                QVERIFY(stats);
                spared += drags && stats->pixelsEvaluated < 48 * 48 * stats->tilesEvaluated;
                const FloatPicture exact = test::render(*m_cpu, p, view);
                QVERIFY(drags ? worst(picture, exact).difference < 1.0 / 1024 : picture.rgba == exact.rgba);
                for (int y = 0; y < view.height; ++y)
                    for (int x = 0; x < view.width; ++x)
                        if (!std::equal(before.at(x, y), before.at(x, y) + 4, picture.at(x, y)))
                            QVERIFY(std::ranges::any_of(stats->dirty, [&](const PixelRect &r) {
                                return r.x <= x && x < r.x + r.width && r.y <= y && y < r.y + r.height;
                            }));
            }
            QVERIFY(spared >= 8);
        }
    }
};

QTEST_GUILESS_MAIN(TestBlending)
#include "test_blending.moc"
