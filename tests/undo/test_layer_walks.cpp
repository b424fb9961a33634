// Long walks of edits to layers, back and forth.
#include "model/painting/validate.h"
#include "tests/trials.h"
#include "tests/undo/random_layer_edits.h"
#include "undo/history/edit_command.h"

#include <QTest>

using namespace suffuse;

class TestLayerWalks : public QObject {
    Q_OBJECT

private slots:
    /// Whatever is done to layers, the painting stays valid, undo all gives the start and redo all the end.
    void walks()
    {
        const quint32 walks = quint32(trials(200, 2'000));
        const int length = isLongRun() ? 10'000 : 2'000;
        qint64 steps = 0, nested = 0;
        std::set<BlendMode> modes;
        int roles = 0;
        for (quint32 walk = 1; walk <= walks; ++walk) {
            Document d;
            d.reset(makePainting(6));
            QUndoStack stack;
            test::LayerEdits edits(d, walk);
            const QByteArray first = hashOf(*d.painting());
            for (int i = 0; i < length; ++i) {
                if (edits.below(10) == 0) {
                    for (int k = edits.below(5); k > 0; --k)
                        stack.undo();
                    for (int k = edits.below(3); k > 0; --k)
                        stack.redo();
                }
                if (Edit edit = edits.next(); !edit.isEmpty())
                    pushStep(stack, d, std::move(edit), QStringLiteral("edit"));
                if (i % 10 != 0)
                    continue;
                QCOMPARE(problemOf(*d.painting()), QString());
                for (const Group &group : d.painting()->groups) {
                    nested += group.parent != 0;
                    modes.insert(group.blend);
                    roles |=
                        int(group.clips) | int(group.mask) << 1 | int(bool(group.wash)) << 2 | int(group.draft) << 3;
                }
            }
            QVERIFY(stack.index() > length / 10);
            steps += stack.index();
            checkUndoAllAndRedo(stack, d, first);
            if (QTest::currentTestFailed())
                return;
        }
        QVERIFY(nested > 100);
        QVERIFY(modes.size() > 10);
        QCOMPARE(roles, 15); // clipped, masks, washes and drafts were there
        qInfo("%u walks, %lld steps on the way back and forth", walks, static_cast<long long>(steps));
    }
};

QTEST_GUILESS_MAIN(TestLayerWalks)
#include "test_layer_walks.moc"
