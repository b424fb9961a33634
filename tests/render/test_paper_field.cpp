// The paper as the CPU renderer computes it, many samples at a time, against the formula at a point in double.
#include "render/cpu/paper_tiles.h"
#include "render/math/paper.h"
#include "tests/render/paintings.h"

using namespace suffuse;
using namespace suffuse::test;

namespace {

constexpr PaperGrain grains[] = {PaperGrain::Tooth, PaperGrain::Fibres, PaperGrain::Weave};

using Samples = std::array<float, cpu::blockSize>;

Paper paperOf(PaperGrain grain, float scale)
{
    return {PaperKind::Procedural, 7, scale, 0.85f, {}, grain};
}

/// η at a block of samples, computed anew.
Samples fieldAt(const View &view, const Paper &paper, const cpu::Block &block, int level)
{
    cpu::PaperTiles tiles(9);
    tiles.begin(cpu::kernels(), PictureGrid::ofPicture(view), paper, nullptr, 0);
    alignas(64) Samples eta;
    tiles.fill(block, level, eta.data());
    return eta;
}

double greatestDifference(const View &view, const Paper &paper, const cpu::Block &block, const Samples &eta)
{
    double worst = 0;
    for (int j = 0; j < cpu::blockSide; ++j)
        for (int i = 0; i < cpu::blockSide; ++i) {
            const Point at = view.toCanvas({block.x + (i + 0.5) * block.step, block.y + (j + 0.5) * block.step});
            const double exact = math::proceduralPaper(at.x, at.y, block.step * view.px(), std::int32_t(paper.grain),
                                                       paper.seed, double(paper.scale), double(paper.strength));
            worst = std::max(worst, std::abs(double(eta[std::size_t(j * cpu::blockSide + i)]) - exact));
        }
    return worst;
}

} // namespace

class TestPaperField : public QObject {
    Q_OBJECT

private slots:
    void isTheFormula()
    {
        const View views[] = {{{512, 384}, 1, 0, false, 1024, 768},
                              {{-3e4, 1e5}, 0.4, 0.7, true, 640, 480},
                              {{512.125, 384.5}, 37, -2.5, false, 800, 600},
                              {{12, 700}, 1e6, 1.2, true, 320, 240}};
        for (const View &view : views)
            for (const PaperGrain grain : grains)
                for (const float scale : {4.0f, 24.0f, 300.0f})
                    for (const int level : {0, 1, 4}) {
                        const Paper paper = paperOf(grain, scale);
                        const cpu::Block block{104, 216, std::ldexp(1.0, -level)};
                        const double worst = greatestDifference(view, paper, block, fieldAt(view, paper, block, level));
                        // The threads of a weave have edges, beside which rounding may take the other thread.
                        QVERIFY2(worst < 2e-5, qPrintable(QStringLiteral("zoom %1, grain %2, scale %3, level %4: %5")
                                                              .arg(view.scale)
                                                              .arg(int(grain))
                                                              .arg(double(scale))
                                                              .arg(level)
                                                              .arg(worst)));
                    }
    }

    /// A sample's bits do not depend on the block in which it lies.
    void samplesDoNotDependOnTheirBlock()
    {
        const View view{{512, 384}, 1.3, 0.3, false, 1024, 768};
        for (const PaperGrain grain : grains) {
            const Paper paper = paperOf(grain, 12);
            const Samples here = fieldAt(view, paper, {32, 48, 1}, 0), there = fieldAt(view, paper, {40, 56, 1}, 0);
            for (int j = 0; j < cpu::cellSide; ++j)
                for (int i = 0; i < cpu::cellSide; ++i)
                    QCOMPARE(there[std::size_t(j * cpu::blockSide + i)],
                             here[std::size_t((j + cpu::cellSide) * cpu::blockSide + i + cpu::cellSide)]);
        }
    }

    /// What is kept is what would be computed, and goes with the view and with the paper.
    void isKeptWhileTheViewStays()
    {
        View view{{512, 384}, 1, 0, false, 96, 96};
        Paper paper = paperOf(PaperGrain::Tooth, 12);
        cpu::PaperTiles tiles(9);
        const cpu::Block block{64, 16, 1};
        const auto ask = [&] {
            tiles.begin(cpu::kernels(), PictureGrid::ofPicture(view), paper, nullptr, 4);
            return tiles.at(1, 4, block, nullptr); // Without room it must be kept.
        };
        const auto isRight = [&](const float *eta) {
            const Samples anew = fieldAt(view, paper, block, 0);
            return std::equal(anew.begin(), anew.end(), eta);
        };
        const float *first = ask();
        QVERIFY(isRight(first));
        QCOMPARE(ask(), first);
        view.centre.x += 0.25;
        QVERIFY(isRight(ask()));
        paper.seed = 8;
        QVERIFY(isRight(ask()));
        paper.strength = 0.5f;
        QVERIFY(isRight(ask()));
    }

    void aLargePictureKeepsNothing()
    {
        const View view{{512, 384}, 1, 0, false, 16384, 12288};
        cpu::PaperTiles tiles(9);
        tiles.begin(cpu::kernels(), PictureGrid::ofPicture(view), paperOf(PaperGrain::Weave, 12), nullptr, 342 * 256);
        alignas(64) Samples room;
        QCOMPARE(tiles.at(5, 3, {64, 16, 1}, room.data()), room.data());
        QVERIFY(room == fieldAt(view, paperOf(PaperGrain::Weave, 12), {64, 16, 1}, 0));
    }
};

QTEST_GUILESS_MAIN(TestPaperField)
#include "test_paper_field.moc"
