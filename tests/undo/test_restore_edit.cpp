// A whole painting in another one's place, and back.
#include "tests/model/random_paintings.h"
#include "tests/undo/steps.h"
#include "undo/history/restore_edit.h"

#include <QTest>
#include <QUndoStack>

using namespace suffuse;

class TestRestoreEdit : public QObject {
    Q_OBJECT

private slots:
    void anyPaintingTakesAnyOnesPlace()
    {
        test::RandomPaintings random(11);
        for (int trial = 0; trial < 60; ++trial) {
            const auto before = std::make_shared<const Painting>(random.painting(trial % 7, 12));
            const Painting after = random.painting((trial + 3) % 8, 12);
            Document document;
            document.reset(before);
            QUndoStack stack;
            Edit edit = restorePainting(document, after);
            QVERIFY(!edit.isEmpty());
            pushStep(stack, document, std::move(edit), QStringLiteral("Restore"));
            QVERIFY(*document.painting() == after);
            stack.undo();
            QVERIFY(*document.painting() == *before);
            stack.redo();
            QVERIFY(*document.painting() == after);
        }
    }

    /// Frames, undo steps and journals hold what differs, and no more.
    void whatIsEqualStays()
    {
        test::RandomPaintings random(12);
        Painting painting = random.painting(6, 12);
        Document document;
        document.reset(std::make_shared<const Painting>(painting));
        for (StrokePtr &stroke : painting.strokes)
            stroke = std::make_shared<const Stroke>(*stroke); // as read from a file
        QVERIFY(restorePainting(document, painting).isEmpty());
        auto renamed = std::make_shared<Stroke>(*painting.strokes[2]);
        renamed->name += QStringLiteral("'");
        painting.strokes[2] = renamed;
        const Edit edit = restorePainting(document, painting);
        QCOMPARE(edit.strokes.size(), std::size_t(1));
        QVERIFY(!edit.reorders() && !edit.touchesTheRest());
    }
};

QTEST_APPLESS_MAIN(TestRestoreEdit)
#include "test_restore_edit.moc"
