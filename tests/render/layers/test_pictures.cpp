// Pictures as the paint of strokes (docs/solver.md, "Pictures").
#include "tests/render/layers/grouped.h"
#include "tests/render/layers/pictured.h"

#include "render/probe.h"
#include "render/scene/picture.h"
#include "tests/trials.h"

using namespace suffuse;
using namespace suffuse::test;

namespace {

const View sheet = View::ofArea(Rect::of(0, 0, 96, 72), 96, 72);

/// An image of straight values that `value(x, y)` gives.
template <class Value>
Picture imageOf(int width, int height, Value value, ImageDepth depth = ImageDepth::Bits16)
{
    FloatPicture image;
    image.resize(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::array<float, 4> rgba = value(x, y);
            std::ranges::copy(rgba, image.rgba.data() + 4 * (y * width + x));
        }
    ImageOptions options;
    options.alpha = true;
    options.depth = depth;
    const Result<QByteArray> bytes = encodeImage(ImageFormat::Png, image, options, QStringLiteral("test"));
    if (!bytes)
        qFatal("%s", qPrintable(bytes.error()));
    return embeddedPicture(std::make_shared<const QByteArray>(*bytes), width, height);
}

PaintingPtr only(Stroke stroke)
{
    stroke.id = 1;
    return painting({std::move(stroke)});
}

} // namespace

class TestPictures : public QObject {
    Q_OBJECT

    std::unique_ptr<Renderer> m_cpu = make(Backend::Cpu), m_reference = make(Backend::Reference);

    PaintingPtr randomTree(std::mt19937_64 &random, int strokes, int fills)
    {
        auto all = randomStrokes(random, strokes, 96, 72);
        for (StrokeId id = 100; id < StrokeId(100 + fills); ++id)
            all.push_back(randomFill(random, id, 96, 72, id % 2 ? 4 : 0.001));
        std::ranges::shuffle(all, random);
        return grouped(pictured(painting(std::move(all), 96, 72), random), random);
    }

private slots:
    /// A picture in its own size shows its pixels as they are, and nothing outside of it.
    void pixelsAsTheyAre()
    {
        const auto value = [](int x, int y) {
            return std::array<float, 4>{float(x) / 19, float(y) / 9, float((x + y) % 3) / 2, y < 5 ? 1 : 0.4f};
        };
        const Picture picture = imageOf(20, 10, value);
        const auto p = only(pictureStroke(picture, Rect::of(7, 5, 20, 10), 0));
        const FloatPicture drawn = test::render(*m_cpu, p, sheet, 0, true);
        for (int y = 0; y < 72; ++y)
            for (int x = 0; x < 96; ++x) {
                const bool inside = x >= 7 && x < 27 && y >= 5 && y < 15;
                const auto wanted = inside ? value(x - 7, y - 5) : std::array<float, 4>{};
                for (int c = 0; c < 4; ++c)
                    QVERIFY2(std::abs(double(drawn.at(x, y)[c]) - double(wanted[std::size_t(c)])) < 4e-4,
                             qPrintable(QStringLiteral("%1, %2, %3: %4 and not %5")
                                            .arg(x)
                                            .arg(y)
                                            .arg(c)
                                            .arg(double(drawn.at(x, y)[c]))
                                            .arg(double(wanted[std::size_t(c)]))));
            }
    }

    /// Smaller than its own size it is the mean of its pixels, weighted by what can be seen of them.
    void smallerIsTheMean()
    {
        const Picture picture = imageOf(64, 64, [](int x, int y) {
            return (x + y) % 2 ? std::array<float, 4>{1, 0, 0, 1} : std::array<float, 4>{0, 1, 0, 0};
        });
        const auto p = only(pictureStroke(picture, Rect::of(8, 8, 16, 16), 0));
        const FloatPicture drawn = test::render(*m_cpu, p, sheet, 0, true);
        const float *pixel = drawn.at(15, 15);
        QVERIFY(std::abs(double(pixel[0]) - 1) < 1e-3 && pixel[1] < 1e-3f && pixel[2] < 1e-3f);
        QVERIFY(std::abs(double(pixel[3]) - 0.5) < 1e-3);
    }

    /// Sizes that are odd, and images of a single pixel or line.
    void levelsOfAnySize()
    {
        for (const auto &[width, height] : {std::pair(1, 1), {1, 7}, {13, 1}, {5, 3}, {33, 17}}) {
            const Picture picture = imageOf(width, height, [](int, int) { return std::array<float, 4>{1, 1, 1, 1}; });
            const auto levels = pictureLevels(picture);
            QVERIFY(levels);
            const PictureLevel last = (*levels)->level((*levels)->count() - 1);
            QCOMPARE(last.width, 1);
            QCOMPARE(last.height, 1);
            for (std::size_t k = 0; k < (*levels)->count(); ++k)
                QCOMPARE(int((*levels)->level(k).rgba[3]), 65535);
        }
    }

    void randomTrees()
    {
        double most = 0;
        for (int i = 0; i < trials(24, 1500); ++i) {
            std::mt19937_64 random(firstSeed() + unsigned(i) + 1);
            auto p = std::make_shared<Painting>(*randomTree(random, 8, i % 8 == 0));
            p->canvas.background = {0.1f, 0.3f, 0.05f, i % 2 ? 1 : 0.6f};
            const bool transparent = i % 4 == 3;
            const View view =
                i % 3 ? sheet
                      : View{{48, 36}, std::exp2(double(random() % 9) - 4), double(random() % 7), random() % 2 == 0, 60,
                             50};
            const Worst w = worst(test::render(*m_cpu, p, view, -1, transparent),
                                  test::render(*m_reference, p, view, -1, transparent));
            most = std::max(most, w.difference);
            QVERIFY2(
                w.difference <= 1.0 / 512,
                qPrintable(
                    QStringLiteral("seed %1: %2/512 at %3, %4").arg(i + 1).arg(512 * w.difference).arg(w.x).arg(w.y)));
        }
        qInfo("at most %.3f/512", 512 * most);
    }

    void anyScaleAndDepthOfZoom()
    {
        std::mt19937_64 random(8);
        for (int i = 0; i < 16; ++i) {
            const Picture picture = randomPicture(random);
            const auto p = only(pictureStroke(picture, randomPlace(random, picture, 96, 72), 0));
            const double scale = std::exp2(2 * i - 10);
            const Point centre = p->strokes[0]->origin + Offset{0.3f, 0.2f};
            const View view{scale > 8 ? centre : Point{48, 36}, scale, 0.1 * i, i % 2 == 1, 50, 40};
            const Worst w = worst(test::render(*m_cpu, p, view), test::render(*m_reference, p, view));
            QVERIFY2(w.difference <= 1.0 / 512,
                     qPrintable(QStringLiteral("scale %1: %2/512").arg(scale).arg(512 * w.difference)));
        }
    }

    void tilingAndThreads()
    {
        std::mt19937_64 random(3);
        for (int i = 0; i < 5; ++i) {
            const auto p = randomTree(random, 12, 4);
            const FloatPicture first = test::render(*make(Backend::Cpu, 1, 16), p, sheet);
            for (const int tile : {8, 24, 64})
                for (const bool cull : {true, false}) {
                    const auto other = makeRenderer({Backend::Cpu, 3, tile, cull});
                    QVERIFY2(first.rgba == test::render(**other, p, sheet).rgba,
                             qPrintable(QStringLiteral("%1: tile %2").arg(i).arg(tile)));
                }
            View crop = sheet;
            crop.width = 40, crop.height = 30;
            crop.centre = sheet.toCanvas({31 + 20.0, 17 + 15.0});
            const FloatPicture part = test::render(*m_cpu, p, crop);
            for (int y = 0; y < 30; ++y)
                QVERIFY(std::equal(part.at(0, y), part.at(0, y) + 160, first.at(31, 17 + y)));
        }
    }

    /// Any history of edits of pictures, strokes and groups leads to the picture that is drawn at once.
    void dirtyRedrawIsFullRedraw()
    {
        std::mt19937_64 random(5);
        for (const bool transparent : {false, true}) {
            auto p = randomTree(random, 12, 3);
            const auto live = make(Backend::Cpu, 0, 16);
            FloatPicture picture;
            bool partial = false;
            for (int step = 0; step < trials(120, 2000); ++step) {
                p = random() % 2   ? repictured(p, random)
                    : random() % 2 ? regrouped(p, random)
                                   : randomlyEdited(p, random);
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

    /// What is missing, or is no image, is not seen, and hurts nothing.
    void whatIsMissing()
    {
        const Picture picture = imageOf(4, 4, [](int, int) { return std::array<float, 4>{0, 0, 0, 1}; });
        Picture lost = picture, broken = picture;
        lost.image = {};
        broken.image = std::make_shared<const QByteArray>("\x89PNG\r\n\x1a\nand no more");
        broken.sha256 = sha256Of(*broken.image);
        const FloatPicture bare = test::render(*m_cpu, painting({}), sheet, 0);
        for (const Picture &bad : {lost, broken}) {
            const auto p = only(pictureStroke(bad, Rect::of(0, 0, 96, 72), 0));
            QVERIFY(test::render(*m_cpu, p, sheet, 0).rgba == bare.rgba);
            QVERIFY(test::render(*m_reference, p, sheet, 0).rgba ==
                    test::render(*m_reference, painting({}), sheet, 0).rgba);
            QVERIFY(!pictureLevels(bad));
            const auto seen = probe(*p, 0, 40, 30);
            QVERIFY(seen);
            QCOMPARE(seen->canvasShare, 1.0);
        }
    }

    void theProbeSeesThePicture()
    {
        std::mt19937_64 random(6);
        int covered = 0;
        for (int i = 0; i < 40; ++i) {
            const auto p = randomTree(random, 6, 1);
            const Point at{8 + double(random() % 80), 8 + double(random() % 56)};
            View near{at, 4096, 0, false, 1, 1};
            const FloatPicture pixel = test::render(*m_reference, p, near);
            const auto seen = probe(*p, p->end(), at.x, at.y);
            QVERIFY(seen);
            for (std::size_t c = 0; c < 3; ++c)
                QVERIFY2(
                    std::abs(seen->rgbAfter[c] - double(pixel.at(0, 0)[c])) < 4e-3,
                    qPrintable(
                        QStringLiteral("%1: %2 and %3").arg(i).arg(seen->rgbAfter[c]).arg(double(pixel.at(0, 0)[c]))));
            covered += seen->canvasShare < 0.5;
        }
        QVERIFY(covered > 0);
    }

    /// In a wash all paint is one, and none of it is a picture; what is filled is drawn by itself, and shows its own.
    void inAWash()
    {
        std::mt19937_64 random(9);
        auto p = std::make_shared<Painting>(*painting(randomStrokes(random, 3, 96, 72)));
        Group wash;
        wash.id = 1, wash.wash = Wash{};
        p->groups = {wash};
        auto q = std::make_shared<Painting>(*p);
        for (std::size_t i = 0; i < 3; ++i) {
            Stroke s = *p->strokes[i];
            s.group = 1;
            p->strokes[i] = std::make_shared<const Stroke>(s);
            paintWith(s, randomPicture(random), random, 96, 72);
            q->strokes[i] = std::make_shared<const Stroke>(s);
        }
        QVERIFY(test::render(*m_cpu, p, sheet).rgba == test::render(*m_cpu, q, sheet).rgba);
        Stroke alone = pictureStroke(imageOf(1, 1,
                                             [](int, int) {
                                                 return std::array<float, 4>{1, 0, 0, 1};
                                             }),
                                     Rect::of(0, 0, 96, 72), 0);
        alone.id = 9, alone.group = 1;
        q->strokes.push_back(std::make_shared<const Stroke>(alone));
        QVERIFY(std::abs(double(test::render(*m_cpu, q, sheet).at(50, 40)[0]) - 1) < 1e-3);
        QVERIFY(worst(test::render(*m_cpu, q, sheet), test::render(*m_reference, q, sheet)).difference <= 1.0 / 512);
    }

    /// Decoded images that nothing shows any more are let go, the oldest ones first.
    void decodedPicturesAreBounded()
    {
        std::vector<PictureLevelsPtr> held;
        const auto big = [](int number) {
            return imageOf(
                2048, 2048,
                [=](int x, int y) {
                    return std::array<float, 4>{float((x + number) % 7) / 6, float(y % 5) / 4, float(number) / 40, 1};
                },
                ImageDepth::Bits8);
        };
        constexpr std::size_t each = std::size_t(2048) * 2048 * 8 * 4 / 3;
        for (int i = 0; i < 9; ++i) {
            const auto levels = pictureLevels(big(i));
            QVERIFY(levels);
            if (i == 0)
                held.push_back(*levels);
        }
        QVERIFY2(pictureBytes() <= mostIdlePictures + 3 * each, qPrintable(QString::number(pictureBytes())));
        QVERIFY(*pictureLevels(big(0)) == held.front()); // what is shown is never decoded twice
    }
};

QTEST_GUILESS_MAIN(TestPictures)
#include "test_pictures.moc"
