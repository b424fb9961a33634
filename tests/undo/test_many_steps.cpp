// A long day: ten thousand steps, all the way back and forth again. Time and memory are printed, never judged.
#include "tests/undo/random_shape_edits.h"
#include "tests/undo/steps.h"

#include <QElapsedTimer>
#include <QFile>

using namespace suffuse;
using namespace suffuse::test;

namespace {

constexpr int wanted = 10'000;

/// Resident memory of this program, MiB; 0 where that is not told.
double residentMiB()
{
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly))
        return 0;
    const QList<QByteArray> pages = file.readAll().split(' ');
    return pages.size() > 1 ? pages[1].toDouble() * 4096 / (1 << 20) : 0;
}

} // namespace

class TestManySteps : public QObject {
    Q_OBJECT

private slots:
    void tenThousandSteps()
    {
        Document d;
        AwkwardStrokes random(7);
        d.reset(awkwardPainting(random, 200));
        const QByteArray first = hashOf(*d.painting());
        QUndoStack stack;
        const double before = residentMiB();
        QElapsedTimer clock;
        clock.start();
        std::vector<QByteArray> hashes; // of some of the moments
        while (stack.count() < wanted) {
            const PaintingPtr painting = d.painting();
            const StrokePtr stroke = painting->strokes[std::size_t(random.below(int(painting->strokes.size())))];
            select(d, {stroke->id});
            switch (random.below(4)) {
            case 0:
                push(stack, d, arrangeSelection(d, Arrange(random.below(4))));
                break;
            case 1:
                push(stack, d,
                     transformSelection(d, Affine::rotation(stroke->origin, random.real(-1, 1)), SpreadRule::Scales));
                break;
            case 2:
                push(stack, d, moveNodes(d, {{stroke->id, random.below(nodeCount(*stroke))}}, random.point(5)));
                break;
            default:
                push(stack, d,
                     changeSegments(d, targetSegments(d), [&](Segment &s) { s.density = float(random.real(1, 20)); }));
            }
            if (stack.count() % 1000 == 0 && int(hashes.size()) < stack.count() / 1000)
                hashes.push_back(hashOf(*d.painting()));
        }
        qInfo("%d steps pushed in %lld ms, %.2f KiB a step", stack.count(), clock.restart(),
              (residentMiB() - before) * 1024 / stack.count());
        stack.setIndex(0);
        qInfo("undone in %lld ms", clock.restart());
        QCOMPARE(hashOf(*d.painting()), first);
        for (int k = 0; k < int(hashes.size()); ++k) {
            stack.setIndex(1000 * (k + 1));
            QCOMPARE(hashOf(*d.painting()), hashes[std::size_t(k)]);
        }
        QCOMPARE(stack.index(), wanted);
        QVERIFY(d.selection().strokes.size() <= 1);
    }

private:
    static void push(QUndoStack &stack, Document &d, Edit edit)
    {
        if (!edit.isEmpty())
            pushStep(stack, d, std::move(edit));
    }
};

QTEST_GUILESS_MAIN(TestManySteps)
#include "test_many_steps.moc"
