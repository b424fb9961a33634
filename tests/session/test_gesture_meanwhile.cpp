// What is done during a gesture: whoever saves, undoes, pushes, or begins another one finds and leaves a true state.
#include "tests/session/gesture_desk.h"

#include <random>

using namespace suffuse;

class TestGestureMeanwhile : public QObject {
    Q_OBJECT

private slots:
    void savedMeanwhile_data() { kinds(); }
    void savedMeanwhile();
    void undoneMeanwhile_data() { kinds(); }
    void undoneMeanwhile();
    void redoneMeanwhile_data() { kinds(); }
    void redoneMeanwhile();
    void stepsOfTheStackMeanwhile_data() { kinds(); }
    void stepsOfTheStackMeanwhile();
    void pushedMeanwhile_data() { kinds(); }
    void pushedMeanwhile();
    void anotherGesture_data() { kinds(); }
    void anotherGesture();
    void aStrokeGoesMeanwhile_data() { kinds(); }
    void aStrokeGoesMeanwhile();
    void anotherPainting_data() { kinds(); }
    void anotherPainting();
    void anythingInBetween_data();
    void anythingInBetween();
};

void TestGestureMeanwhile::savedMeanwhile()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    for (int k = 1; k <= steps; ++k) {
        showStep(desk.editor, gesture, kind, k);
        desk.save();
        QCOMPARE(desk.saved(), expected(desk.start, kind, k));
        QVERIFY(!desk.editor.isModified());
    }
    showStep(desk.editor, gesture, kind, steps + 1);
    gesture.giveUp(); // what was saved was done
    QCOMPARE(desk.painting(), expected(desk.start, kind, steps));
    QVERIFY(!desk.editor.isModified());
    QCOMPARE(desk.stack().count(), 2 + steps);
    desk.checkWalk();
}

void TestGestureMeanwhile::undoneMeanwhile()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    for (int k = 1; k <= steps; ++k) {
        showStep(desk.editor, gesture, kind, k);
        desk.editor.undo();
        QCOMPARE(desk.painting(), expected(desk.start, kind, k - 1));
        QCOMPARE(desk.editor.isModified(), k > 1);
        desk.editor.redo();
        QCOMPARE(desk.painting(), expected(desk.start, kind, k));
    }
    gesture.commit();
    QCOMPARE(desk.stack().count(), 2 + steps);
    desk.checkWalk();
}

void TestGestureMeanwhile::redoneMeanwhile()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    for (int k = 1; k <= steps; ++k) {
        showStep(desk.editor, gesture, kind, k);
        desk.editor.redo(); // there is nothing
        QCOMPARE(desk.painting(), expected(desk.start, kind, k));
    }
    gesture.commit();
    QCOMPARE(desk.stack().count(), 2 + steps);
    desk.checkWalk();
}

/// The list of steps, and whoever has the stack, does them without the editor.
void TestGestureMeanwhile::stepsOfTheStackMeanwhile()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    for (int k = 1; k <= steps; ++k) {
        showStep(desk.editor, gesture, kind, k);
        desk.stack().redo();
        desk.stack().redo();
        QCOMPARE(desk.painting(), desk.last);
        showStep(desk.editor, gesture, kind, k);
        desk.stack().setIndex(2);
        QCOMPARE(desk.painting(), desk.start);
        showStep(desk.editor, gesture, kind, k);
        desk.stack().undo();
        QCOMPARE(desk.stack().index(), 1);
        desk.stack().redo();
        QCOMPARE(desk.painting(), desk.start);
    }
    gesture.commit();
    desk.checkUntouched();
}

void TestGestureMeanwhile::pushedMeanwhile()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    for (int k = 1; k <= steps; ++k) {
        showStep(desk.editor, gesture, kind, k);
        desk.rename(3, QString("while %1").arg(k));
        Painting wanted = expected(desk.start, kind, k);
        Stroke named = *wanted.strokes.at(2);
        named.name = QString("while %1").arg(k);
        wanted.strokes[2] = std::make_shared<const Stroke>(named);
        QCOMPARE(desk.painting(), wanted);
        QCOMPARE(desk.stack().count(), 2 + 2 * k);
    }
    gesture.giveUp();
    QCOMPARE(desk.stack().count(), 2 + 2 * steps);
    desk.checkWalk();
}

void TestGestureMeanwhile::anotherGesture()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture one = desk.begin("one");
    showStep(desk.editor, one, kind, 2);
    Gesture two = desk.begin("two");
    QCOMPARE(desk.stack().undoText(), QString("one"));
    QCOMPARE(desk.painting(), expected(desk.start, kind, 2));
    const Painting between = desk.painting();
    two.show(changeStrokes(desk.editor.document(), {3}, [](Stroke &s) { s.origin.x += 7; }));
    showStep(desk.editor, one, kind, 3); // and on
    QCOMPARE(desk.stack().undoText(), QString("two"));
    two.giveUp(); // it is a step already
    one.giveUp();
    QCOMPARE(desk.stack().count(), 4);
    desk.editor.undo();
    QCOMPARE(desk.painting(), between);
    desk.checkWalk();
}

void TestGestureMeanwhile::aStrokeGoesMeanwhile()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    showStep(desk.editor, gesture, kind, 1);
    desk.editor.document().setSelection({{2}, {}});
    desk.editor.push(deleteSelection(desk.editor.document()), "delete");
    QVERIFY(!desk.painting().find(2));
    showStep(desk.editor, gesture, kind, 2);
    QCOMPARE(*desk.painting().find(1), *expected(desk.start, kind, 2).find(1));
    QVERIFY(!desk.painting().find(2));
    gesture.commit();
    QCOMPARE(desk.stack().count(), 5);
    desk.checkWalk();
}

void TestGestureMeanwhile::anotherPainting()
{
    QFETCH(Kind, kind);
    for (const bool byFile : {false, true}) {
        Desk desk(kind);
        Gesture gesture = desk.begin();
        showStep(desk.editor, gesture, kind, 1);
        if (byFile)
            desk.editor.newPainting({});
        else
            desk.editor.document().reset(std::make_shared<const Painting>());
        QVERIFY(!desk.editor.isDragging() && !desk.editor.undecided());
        if (kind != Kind::Edits)
            showStep(desk.editor, gesture, kind, 2);
        gesture.giveUp();
        QVERIFY(desk.painting().strokes.empty());
    }
}

void TestGestureMeanwhile::anythingInBetween_data()
{
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 40; ++seed)
        QTest::newRow(qPrintable(QString::number(seed))) << seed;
}

/// Two hands, and all else at random: undoing all gives the first painting back, and redoing all the last one.
void TestGestureMeanwhile::anythingInBetween()
{
    QFETCH(unsigned, seed);
    std::mt19937 random(seed);
    const auto below = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
    Desk desk(Kind::Floats);
    Gesture hands[2];
    ValueEntry entry;
    for (int i = 0; i < 300; ++i) {
        Gesture &hand = hands[below(2)];
        switch (below(14)) {
        case 0:
            hand = desk.begin();
            break;
        case 1:
            hand.commit();
            break;
        case 2:
            hand.giveUp();
            break;
        case 3:
            desk.editor.undo();
            break;
        case 4:
            desk.editor.redo();
            break;
        case 5:
            below(2) ? desk.stack().undo() : desk.stack().redo();
            break;
        case 6:
            desk.rename(StrokeId(1 + below(3)), QString::number(i));
            break;
        case 7:
            desk.editor.push(reorder(desk.editor.document(), {StrokeId(1 + below(3))}, below(3)), "order", &entry);
            break;
        case 8:
            desk.editor.rest();
            break;
        case 9:
            desk.pictures->lift({1, 2});
            break;
        default:
            showStep(desk.editor, hand, Kind(below(4)), below(5));
        }
        QVERIFY(desk.editor.unsettled().painting()->strokes.size() == 3);
    }
    hands[0].commit();
    hands[1].giveUp();
    while (desk.editor.canRedo())
        desk.editor.redo();
    desk.checkWalk();
}

QTEST_GUILESS_MAIN(TestGestureMeanwhile)
#include "test_gesture_meanwhile.moc"
