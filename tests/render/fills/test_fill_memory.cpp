// What drawing takes where an outline crosses itself tens of thousands of times: memory for each crossing once, not
// for each block of each tile again.
#include "tests/render/filled.h"

#include <sys/resource.h>

using namespace suffuse;
using namespace suffuse::test;

namespace {

/// Greatest memory of this process so far, bytes.
qint64 peakMemory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return qint64(usage.ru_maxrss) * 1024;
}

} // namespace

class TestFillMemory : public QObject {
    Q_OBJECT

private slots:
    void scribbles()
    {
#ifdef SUFFUSE_SANITIZED
        QSKIP("Sanitizers keep what is freed.");
#endif
        constexpr int lines = 500; // which cross each other about 58,000 times
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> u(0, 1000);
        std::vector<Point> corners;
        for (int i = 0; i < lines; ++i) {
            const double x = u(random);
            corners.push_back({x, u(random)});
        }
        Stroke stroke = emptyFill(1, 2'000, {StyleKind::Feathering, {1, 1, 0}}); // Each crossing counts everywhere.
        addPolygon(stroke, corners);
        changeFill(stroke, [](Fill &f) { f.rule = FillRule::EvenOdd; });
        const PaintingPtr p = painting({stroke}, 1000, 1000);
        const std::unique_ptr<Renderer> cpu = make(Backend::Cpu, 4, 64);
        const qint64 before = peakMemory();
        const FloatPicture picture = test::render(*cpu, p, View::ofArea(p->canvas.area(), 128, 128), -1, true);
        const qint64 taken = peakMemory() - before;
        QVERIFY2(taken < qint64(120) << 20, qPrintable(QStringLiteral("%1 MiB").arg(taken >> 20)));
        // About half of the square lies inside, and spreads over a disc of 2,000 units.
        const double most = 0.9 * 0.5e6 / (3.14159265358979 * 4e6), opacity = double(picture.at(64, 64)[3]);
        QVERIFY2(opacity < most && opacity > 0.75 * most, qPrintable(QString::number(opacity / most)));
    }
};

QTEST_GUILESS_MAIN(TestFillMemory)
#include "test_fill_memory.moc"
