// A trunk as a hand paints it, simplified: few segments, and nearly the same picture.
#include "model/brush/stroke_builder.h"
#include "model/shaping/curves/simplify.h"
#include "tests/render/paintings.h"

using namespace suffuse;
using namespace suffuse::test;

namespace {

/// Upwards, swaying, pressed harder in the middle.
Stroke trunk(const Brush &brush, double seconds = 1.6)
{
    std::vector<PenSample> samples;
    for (int i = 0; i <= 200; ++i) {
        const double u = i / 200.0;
        const Point at{200 + 30 * std::sin(5 * u) + 9 * std::sin(17 * u), 600 - 520 * u};
        samples.push_back({at, Microseconds(i * seconds * 5000), float(0.25 + 0.6 * std::sin(3 * u))});
    }
    return *buildStroke(brush, 1, samples);
}

/// The mean difference of a channel over the box of the painted pixels, as a share of its range.
double meanDifference(const FloatPicture &a, const FloatPicture &b)
{
    Rect box;
    double sum = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double p = double(a.at(x, y)[c]), q = double(b.at(x, y)[c]);
                sum += std::abs(p - q) / 3;
                if (std::min(p, q) < 1 - 1.0 / 255)
                    box = box.united(Rect::of(x, y, 1, 1));
            }
    return sum / std::max(box.width() * box.height(), 1.0);
}

} // namespace

class TestSimplified : public QObject {
    Q_OBJECT

private slots:
    void aTrunkOf280SegmentsNeeds40_data()
    {
        QTest::addColumn<QString>("brush");
        QTest::addColumn<double>("seconds");
        for (const char *brush : {"brush-pen", "ink-wash", "watercolour-edge", "gouache", "dry-brush", "pencil"})
            for (const double seconds : {1.6, 5.0}) // a quick hand and a slow one
                QTest::addRow("%s, %g s", brush, seconds) << brush << seconds;
    }

    void aTrunkOf280SegmentsNeeds40()
    {
        QFETCH(QString, brush);
        QFETCH(double, seconds);
        const Stroke before = trunk(*findBrush(brush), seconds);
        const Stroke after = simplified(before, {});
        const View view = View::ofArea({0, 0, 400, 700}, 400, 700);
        const auto draw = [&](const Stroke &stroke) {
            return test::render(*make(Backend::Cpu), painting({stroke}, 400, 700), view);
        };
        const double difference = meanDifference(draw(before), draw(after));
        qInfo() << before.segments.size() << "segments to" << after.segments.size() << ", mean difference" << difference
                << "= 1 /" << 1 / difference;
        QVERIFY(after.segments.size() <= 40);
        QVERIFY(difference <= 1.0 / 64);
    }

    void thatTrunkHas280Segments()
    {
        const std::size_t count = trunk(*findBrush("brush-pen")).segments.size();
        QVERIFY2(count >= 270 && count <= 400, qPrintable(QString::number(count)));
    }
};

QTEST_GUILESS_MAIN(TestSimplified)
#include "test_simplified.moc"
