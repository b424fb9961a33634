// The maps that make copies of what is painted in a symmetry.
#include "model/geometry/symmetry.h"

#include <QTest>

#include <algorithm>
#include <numbers>

using namespace suffuse;

namespace {

Symmetry symmetryOf(SymmetryKind kind, int arms = 6)
{
    return {true, kind, {100, 50}, 0, arms};
}

std::vector<Point> imagesOf(const Symmetry &symmetry, Point point)
{
    std::vector<Point> images{point};
    for (const Affine &map : symmetry.copies())
        images.push_back(map(point));
    return images;
}

bool holds(const std::vector<Point> &points, Point wanted)
{
    return std::ranges::any_of(points, [&](Point p) { return length(p - wanted) < 1e-9; });
}

} // namespace

class TestSymmetry : public QObject {
    Q_OBJECT

private slots:
    /// To the last digit, where axes are upright and level.
    void mirrorsKeepNumbers()
    {
        const Point p{137.3, 20.1};
        const auto across = imagesOf(symmetryOf(SymmetryKind::Across), p);
        QCOMPARE(across.size(), std::size_t(2));
        QCOMPARE(across[1].y, 20.1);
        QCOMPARE(across[1].x, 200 - 137.3);
        const auto down = imagesOf(symmetryOf(SymmetryKind::Down), p);
        QCOMPARE(down.size(), std::size_t(2));
        QCOMPARE(down[1].x, 137.3);
        QCOMPARE(down[1].y, 100 - 20.1);
        const auto both = imagesOf(symmetryOf(SymmetryKind::Both), p);
        QCOMPARE(both.size(), std::size_t(4));
        for (const Point corner : {Point{62.7, 20.1}, Point{137.3, 79.9}, Point{62.7, 79.9}})
            QVERIFY(holds(both, corner));
    }

    /// The copies of a copy are the same copies, whichever of them was painted.
    void copiesAreAGroup_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("arms");
        QTest::addColumn<int>("count");
        QTest::newRow("across") << int(SymmetryKind::Across) << 6 << 2;
        QTest::newRow("down") << int(SymmetryKind::Down) << 6 << 2;
        QTest::newRow("both") << int(SymmetryKind::Both) << 6 << 4;
        QTest::newRow("two arms") << int(SymmetryKind::Turns) << 2 << 2;
        QTest::newRow("24 arms") << int(SymmetryKind::Turns) << 24 << 24;
        QTest::newRow("kaleidoscope of 5") << int(SymmetryKind::Kaleidoscope) << 5 << 10;
        QTest::newRow("kaleidoscope of 24") << int(SymmetryKind::Kaleidoscope) << 24 << 48;
    }
    void copiesAreAGroup()
    {
        QFETCH(int, kind);
        QFETCH(int, arms);
        QFETCH(int, count);
        Symmetry symmetry = symmetryOf(SymmetryKind(kind), arms);
        symmetry.angle = 0.3;
        const Point p{131, 17};
        const auto images = imagesOf(symmetry, p);
        QCOMPARE(int(images.size()), count);
        for (const Affine &map : symmetry.copies()) {
            QVERIFY(map.isSimilarity());
            QVERIFY(std::abs(std::abs(map.determinant()) - 1) < 1e-12);
            QVERIFY(length(map(symmetry.centre) - symmetry.centre) < 1e-12);
            for (const Point image : imagesOf(symmetry, map(p)))
                QVERIFY(holds(images, image));
        }
        // Mirrors leave their axes alone: what lies on the first spoke stays there for one of them.
        if (symmetry.kind != SymmetryKind::Turns) {
            const Point onAxis = symmetry.centre + 40 * symmetry.spokes().front();
            const auto copies = symmetry.copies();
            QVERIFY(std::ranges::any_of(copies, [&](const Affine &m) { return length(m(onAxis) - onAxis) < 1e-9; }));
        }
    }

    void theAngleTurnsTheAxis()
    {
        Symmetry symmetry = symmetryOf(SymmetryKind::Across);
        symmetry.angle = std::numbers::pi / 4; // The axis goes from the lower left to the upper right.
        QVERIFY(length(symmetry.direction() - std::sqrt(0.5) * Point{1, -1}) < 1e-12);
        QVERIFY(holds(imagesOf(symmetry, {120, 50}), {100, 30}));
    }

    void offHasNoCopies()
    {
        Symmetry symmetry = symmetryOf(SymmetryKind::Kaleidoscope);
        symmetry.isOn = false;
        QVERIFY(symmetry.copies().empty());
    }
};

QTEST_GUILESS_MAIN(TestSymmetry)
#include "test_symmetry.moc"
