// Regions of pixels and their outlines.
#include "model/area/area_sets.h"
#include "model/area/mask.h"
#include "tests/model/area/windings.h"
#include "tests/trials.h"

#include <QTest>

#include <random>

using namespace suffuse;
using namespace suffuse::test;

namespace {

Mask drawn(const std::vector<std::string> &rows)
{
    Mask mask(int(rows.front().size()), int(rows.size()));
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x)
            mask.pixels[mask.index(x, y)] = rows[std::size_t(y)][std::size_t(x)] == '#';
    return mask;
}

Mask random(std::mt19937 &generator, int width, int height, unsigned oneIn)
{
    Mask mask(width, height);
    for (std::uint8_t &pixel : mask.pixels)
        pixel = generator() % oneIn == 0;
    return mask;
}

Mask disc(int side, double radius, double hole = 0)
{
    Mask mask(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double d = std::hypot(x + 0.5 - 0.5 * side, y + 0.5 - 0.5 * side);
            mask.pixels[mask.index(x, y)] = d < radius && d >= hole;
        }
    return mask;
}

} // namespace

class TestMask : public QObject {
    Q_OBJECT

private slots:
    void distancesAreThoseOfTheNearest()
    {
        std::mt19937 generator(1);
        for (int trial = 0; trial < trials(40, 4000); ++trial) {
            const int width = 1 + int(generator() % 14), height = 1 + int(generator() % 14);
            const Mask mask = random(generator, width, height, 1 + generator() % 40);
            const std::vector<double> found = squaredDistances(mask);
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    double nearest = std::numeric_limits<double>::infinity();
                    for (int v = 0; v < height; ++v)
                        for (int u = 0; u < width; ++u)
                            if (mask.at(u, v))
                                nearest = std::min(nearest, double((u - x) * (u - x) + (v - y) * (v - y)));
                    QCOMPARE(found[mask.index(x, y)], nearest);
                }
        }
    }

    void regionsHangTogetherBySides()
    {
        const Mask mask = drawn({"##.#", "##.#", "..##", "#.##"});
        QCOMPARE(regionAround(mask, 0, 0).count(), std::size_t(4));
        QCOMPARE(regionAround(mask, 3, 0).count(), std::size_t(6)); // not across the corner
        QCOMPARE(regionAround(mask, 2, 0).count(), std::size_t(0));
        QCOMPARE(regionAround(mask, 9, 9).count(), std::size_t(0));
    }

    void narrowOpeningsAreClosed()
    {
        // Two rooms with a door of three pixels.
        Mask rooms(60, 30);
        for (int y = 1; y < 29; ++y)
            for (int x = 1; x < 59; ++x)
                rooms.pixels[rooms.index(x, y)] = x != 30 || (y >= 14 && y < 17);
        QVERIFY(regionAround(rooms, 10, 15).at(50, 15));
        const Mask left = regionAround(rooms, 10, 15, 5);
        QVERIFY(left.at(10, 15) && left.at(28, 8) && !left.at(50, 15));
        QVERIFY(regionAround(rooms, 10, 15, 3).at(28, 8));
        QVERIFY(regionAround(rooms, 10, 15, 2).at(50, 15)); // The door is wider.
        QVERIFY(regionAround(rooms, 30, 15, 5).at(30, 15)); // in the door itself
    }

    void growingAndShrinking()
    {
        const Mask mask = disc(80, 20);
        for (const double by : {4.0, -4.0}) {
            const double wanted = std::numbers::pi * (20 + by) * (20 + by);
            QVERIFY(std::abs(double(grown(mask, by).count()) - wanted) < 0.06 * wanted);
        }
        QVERIFY(grown(mask, 0).pixels == mask.pixels);
        QCOMPARE(grown(mask, -30).count(), std::size_t(0));
    }

    void outlinesOfDiscsAreSmooth()
    {
        const auto loops = outlinesOf(disc(200, 80, 30));
        QCOMPARE(loops.size(), std::size_t(2));
        const double wanted = std::numbers::pi * (80 * 80 - 30 * 30);
        QVERIFY2(std::abs(sizeOf({loops}) - wanted) < 0.01 * wanted, qPrintable(QString::number(sizeOf({loops}))));
        for (const auto &loop : loops) {
            QVERIFY2(loop.size() <= 12, qPrintable(QString::number(loop.size())));
            QVERIFY(loop.front().p[0] == loop.back().p[3]);
        }
        QCOMPARE(std::abs(windingAt(loops, {100, 45})), 1);
        QCOMPARE(windingAt(loops, {100, 100}), 0);
    }

    void cornersStayCorners()
    {
        Mask mask(100, 80);
        for (int y = 10; y < 60; ++y)
            for (int x = 20; x < 90; ++x)
                mask.pixels[mask.index(x, y)] = 1;
        const auto loops = outlinesOf(mask);
        QCOMPARE(loops.size(), std::size_t(1));
        QCOMPARE(loops[0].size(), std::size_t(4));
        QVERIFY(std::abs(sizeOf({loops}) - 3500) < 5);
    }

    /// Each pixel that is far from the edge is inside exactly if it is 1.
    void outlinesOfAnything()
    {
        std::mt19937 generator(5);
        for (int trial = 0; trial < trials(20, 2000); ++trial) {
            const Mask mask = grown(random(generator, 60, 60, 150), 5);
            const auto loops = outlinesOf(mask, 0);
            const std::vector<double> toOnes = squaredDistances(mask);
            Mask rest = mask;
            for (std::uint8_t &pixel : rest.pixels)
                pixel = !pixel;
            const std::vector<double> toZeros = squaredDistances(rest);
            for (int y = 3; y < 57; ++y) // The border is an edge, too.
                for (int x = 3; x < 57; ++x)
                    if (toOnes[mask.index(x, y)] > 6 || toZeros[mask.index(x, y)] > 6)
                        QCOMPARE(windingAt(loops, {x + 0.5, y + 0.5}, 20), int(mask.at(x, y)));
        }
    }

    void specklesAreLeftOut()
    {
        const Mask mask = drawn({"......", ".#....", "...###", "...###", "...###"});
        QCOMPARE(outlinesOf(mask, 0).size(), std::size_t(2));
        QCOMPARE(outlinesOf(mask, 4).size(), std::size_t(1));
        QCOMPARE(outlinesOf(Mask(5, 5)).size(), std::size_t(0));
        QCOMPARE(outlinesOf(Mask()).size(), std::size_t(0));
    }
};

QTEST_APPLESS_MAIN(TestMask)
#include "test_mask.moc"
