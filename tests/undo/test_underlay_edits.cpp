// Edits of the underlay: what changes nothing, or would be none, is no edit.
#include "tests/undo/steps.h"
#include "undo/underlay_edits.h"

#include <QTest>
#include <QUndoStack>

using namespace suffuse;

class TestUnderlayEdits : public QObject {
    Q_OBJECT

private slots:
    void putChangedAndTaken()
    {
        Document document;
        QUndoStack stack;
        const auto push = [&](Edit edit, StepRun *run = nullptr) {
            QVERIFY(!edit.isEmpty());
            pushStep(stack, document, std::move(edit), "underlay", run);
        };
        const auto opacity = [](float value) { return [value](Underlay &u) { u.opacity = value; }; };
        QVERIFY(changeUnderlay(document, opacity(1)).isEmpty());
        QVERIFY(setUnderlay(document, {}).isEmpty());
        const Underlay first{std::make_shared<const QByteArray>("picture"), Rect::of(0, 0, 30, 20)};
        push(setUnderlay(document, first));
        QVERIFY(setUnderlay(document, first).isEmpty());
        StepRun run;
        for (const float value : {0.6f, 0.7f, 0.8f})
            push(changeUnderlay(document, opacity(value)), &run);
        QCOMPARE(stack.count(), 2);
        QCOMPARE(document.painting()->underlay->opacity, 0.8f);
        QCOMPARE(document.painting()->underlay->image, first.image); // shared, not copied
        push(setUnderlay(document, {}));
        QVERIFY(!document.painting()->underlay);
        stack.undo();
        QCOMPARE(document.painting()->underlay->opacity, 0.8f);
        stack.undo();
        QCOMPARE(*document.painting()->underlay, first);
    }

    void impossibleOnesAreRefused()
    {
        Document document;
        Underlay underlay{std::make_shared<const QByteArray>("picture"), Rect::of(0, 0, 30, 20)};
        underlay.opacity = 1.5f;
        QVERIFY(setUnderlay(document, underlay).isEmpty());
        underlay.opacity = 1;
        underlay.area.right = 1e13;
        QVERIFY(setUnderlay(document, underlay).isEmpty());
        underlay.area.right = 1e12;
        QVERIFY(!setUnderlay(document, underlay).isEmpty());
    }

    void fittedIsWholeAndInTheMiddle()
    {
        QCOMPARE(fitted(200, 100, Rect::of(0, 0, 1000, 800)), Rect::of(0, 150, 1000, 500));
        QCOMPARE(fitted(100, 200, Rect::of(10, 20, 1000, 800)), Rect::of(310, 20, 400, 800));
    }
};

QTEST_APPLESS_MAIN(TestUnderlayEdits)
#include "test_underlay_edits.moc"
