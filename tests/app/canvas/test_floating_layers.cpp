// Frames that are composed of two pictures, without a window.
#include "app/session/frames/floating_layers.h"
#include "render/backends.h"
#include "tests/app/selecting.h"
#include "tests/app/worker_frames.h"

using namespace suffuse;

class TestFloatingLayers : public QObject {
    Q_OBJECT

private slots:
    void framesAreComposed_data()
    {
        QTest::addColumn<Affine>("map");
        QTest::newRow("moved") << Affine::translation({24, -13});
        QTest::newRow("turned") << Affine::rotation({150, 100}, 0.4);
        QTest::newRow("scaled") << Affine::scaling({150, 100}, 1.3, 0.8);
        QTest::newRow("mirrored") << Affine::scaling({150, 100}, -1, 1);
        QTest::newRow("out of the view") << Affine::translation({900, 0});
    }

    /// A frame is the same whatever was shown before it, and looks like the exact one.
    void framesAreComposed()
    {
        QFETCH(Affine, map);
        for (const int factor : {1, 4})
            for (const double rotation : {0.0, 0.7}) {
                RenderRequest r = request(20);
                r.view.rotation = rotation;
                r.view.mirrored = rotation > 0;
                auto rest = std::make_shared<Painting>(*r.painting), all = std::make_shared<Painting>(*r.painting);
                auto lifted = std::make_shared<Painting>(*r.painting);
                const StrokePtr moves = line(2, {60, 40}, {220, 150});
                lifted->strokes = {moves};
                all->strokes.push_back(std::make_shared<const Stroke>(transformed(*moves, map, SpreadRule::Scales)));
                const auto lift = std::make_shared<const Lift>(r.painting, rest, lifted, r.time, r.view);
                FloatingLayers layers(std::move(*makeRenderer({.backend = Backend::Cpu})));
                Picture8 picture;
                QVERIFY(bool((*makeRenderer({.backend = Backend::Cpu}))->render(r, picture)));
                layers.setRest(lift, picture, true);
                QVERIFY(!layers.isOf(lift));
                QVERIFY(*layers.draw(lift, factor));
                QVERIFY(layers.isOf(lift));
                Picture8 fresh = picture;
                (void)layers.compose(map, true, fresh, 2);
                (void)layers.compose(Affine::rotation({100, 30}, 1), true, picture, 2);
                const std::vector<PixelRect> written = layers.compose(map, false, picture, 2);
                // Qt weighs neighbours in sixteenths, and parts begin elsewhere.
                const int greatest = greatestDifference(picture.argb, fresh.argb);
                QVERIFY2(greatest <= (map.isTranslation() && factor == 1 ? 0 : 16),
                         qPrintable(QString::number(greatest)));
                double area = 0;
                for (const PixelRect &rect : written)
                    area += double(rect.width) * rect.height;
                QVERIFY(area <= double(width) * height);

                r.painting = all;
                const Pixels<std::uint32_t> wanted = pixelsOf(r);
                const QImage shown(reinterpret_cast<const uchar *>(fresh.argb.data()), width, height, 4 * width,
                                   QImage::Format_RGB32);
                const double mean = meanDifference(argbOf(shown), wanted);
                QVERIFY2(mean < 1.5, qPrintable(QString::number(mean)));
            }
    }

    /// A picture of strokes over paper is taken apart and comes together again, wherever it is put.
    void aPictureIsTaken()
    {
        const RenderRequest r = request(20);
        const auto lift = std::make_shared<const Lift>(r.painting, r.painting, r.painting, r.time, r.view);
        FloatingLayers layers(std::move(*makeRenderer({.backend = Backend::Cpu})));
        Picture8 picture, paper;
        QVERIFY(bool((*makeRenderer({.backend = Backend::Cpu}))->render(r, picture)));
        paper.resize(width, height);
        const std::uint32_t blank = picture.argb.front();
        std::fill(paper.argb.begin(), paper.argb.end(), blank);
        layers.setRest(lift, paper, true);
        for (const bool fine : {false, true}) {
            layers.take(lift, picture, blank, fine);
            QVERIFY(layers.isOf(lift));
            QCOMPARE(layers.areFine(), fine);
        }
        Picture8 shown = paper;
        (void)layers.compose({}, true, shown, 2);
        QVERIFY(shown.argb == picture.argb);
        (void)layers.compose(Affine::translation({17, -9}), false, shown, 2);
        const auto at = [&](const Picture8 &p, int x, int y) { return p.argb[std::size_t(y) * width + std::size_t(x)]; };
        const int dx = int(std::lround(17 * r.view.scale)), dy = int(std::lround(-9 * r.view.scale));
        QVERIFY(dx != 0 && dy != 0);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const bool inside = x >= dx && y - dy < height;
                QCOMPARE(at(shown, x, y), inside ? at(picture, x - dx, y - dy) : blank);
            }
    }
};

QTEST_MAIN(TestFloatingLayers)
#include "test_floating_layers.moc"
