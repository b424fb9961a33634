// A gesture without a window: whoever reads or draws at any step of it finds a true state, and so does who gives it up.
#include "render/backends.h"
#include "tests/session/gesture_desk.h"

#include <QSignalSpy>

using namespace suffuse;

namespace {

Pixels<std::uint32_t> pictureOf(PaintingPtr painting)
{
    RenderRequest request;
    request.painting = std::move(painting);
    request.time = request.painting->end();
    request.view = View::ofArea(Rect::of(0, -60, 300, 120), 150, 60);
    auto renderer = makeRenderer({.backend = Backend::Cpu, .threads = 1});
    Picture8 picture;
    if (!renderer || !(*renderer)->render(request, picture))
        return {};
    return picture.argb;
}

} // namespace

class TestGesture : public QObject {
    Q_OBJECT

private slots:
    void readAtEachStep_data() { kinds(); }
    void readAtEachStep();
    void committed_data() { kinds(); }
    void committed();
    void givenUp_data() { kinds(); }
    void givenUp();
    void destroyed_data() { kinds(); }
    void destroyed();
    void backAtItsStart_data() { kinds(); }
    void backAtItsStart();
    void whoeverKeepsAJournalHears_data() { kinds(); }
    void whoeverKeepsAJournalHears();
    void theSelectionComesBack();
    void whatFloatsIsSettledByReading();
    void strokesAreLiftedAnew();
    void aHandleMoves();
    void theEditorGoesFirst();
    void dragsOfFields();
    void stepsOfFields();
};

void TestGesture::readAtEachStep()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    QVERIFY(!desk.editor.isDragging()); // nothing is shown yet
    for (int k = 1; k <= steps; ++k) {
        showStep(desk.editor, gesture, kind, k);
        const Painting wanted = expected(desk.start, kind, k);
        QCOMPARE(pictureOf(desk.editor.shown()), pictureOf(std::make_shared<const Painting>(wanted)));
        QCOMPARE(desk.painting(), wanted);
        QCOMPARE(desk.stack().count(), 4);
        QVERIFY(desk.editor.isModified());
        QVERIFY(desk.editor.canUndo() && !desk.editor.canRedo());
        QCOMPARE(desk.editor.undoText(), QString("gesture"));
    }
    gesture.giveUp();
    desk.checkUntouched();
}

void TestGesture::committed()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    for (int k = 1; k <= steps; ++k)
        showStep(desk.editor, gesture, kind, k);
    gesture.commit();
    QVERIFY(!gesture.isOpen() && !desk.editor.isDragging());
    QCOMPARE(desk.painting(), expected(desk.start, kind, steps));
    QCOMPARE(desk.stack().count(), 3);
    QCOMPARE(desk.editor.undoText(), QString("gesture"));
    showStep(desk.editor, gesture, kind, 1); // it is over
    QCOMPARE(desk.painting(), expected(desk.start, kind, steps));
    desk.editor.undo();
    QCOMPARE(desk.painting(), desk.start);
    QVERIFY(!desk.editor.isModified());
    desk.editor.redo();
    QCOMPARE(desk.painting(), expected(desk.start, kind, steps));
    desk.checkWalk();
}

void TestGesture::givenUp()
{
    QFETCH(Kind, kind);
    for (int shown = 0; shown <= steps; ++shown) {
        Desk desk(kind);
        const PaintingPtr before = desk.editor.document().painting();
        Gesture gesture = desk.begin();
        for (int k = 1; k <= shown; ++k)
            showStep(desk.editor, gesture, kind, k);
        gesture.giveUp();
        QVERIFY(!gesture.isOpen());
        for (std::size_t i = 0; i < 3; ++i) // the very same strokes
            QCOMPARE(desk.painting().strokes[i], before->strokes[i]);
        desk.checkUntouched();
    }
}

void TestGesture::destroyed()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    {
        Gesture gesture = desk.begin();
        showStep(desk.editor, gesture, kind, 3);
    }
    desk.checkUntouched();
}

void TestGesture::backAtItsStart()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    for (const int k : {1, 2, 3, 0})
        showStep(desk.editor, gesture, kind, k);
    gesture.commit();
    desk.checkUntouched();
}

void TestGesture::whoeverKeepsAJournalHears()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    QSignalSpy edited(&desk.editor, &Editor::edited), ended(&desk.editor, &Editor::dragEnded);
    Gesture gesture = desk.begin();
    showStep(desk.editor, gesture, kind, 1);
    showStep(desk.editor, gesture, kind, 2);
    QCOMPARE(edited.count(), 0);
    gesture.rest();
    QCOMPARE(edited.count(), 1);
    QCOMPARE(ended.count(), 1);
    QVERIFY(!desk.editor.isDragging());
    QCOMPARE(*desk.editor.unsettled().painting(), expected(desk.start, kind, 2));
    showStep(desk.editor, gesture, kind, 3);
    QVERIFY(desk.editor.isDragging());
    gesture.giveUp();
    QCOMPARE(edited.count(), 2); // it has what is not there any more
    gesture = desk.begin();
    showStep(desk.editor, gesture, kind, 3);
    gesture.commit();
    QCOMPARE(edited.count(), 3);
    desk.editor.undo();
    desk.editor.redo();
    QCOMPARE(edited.count(), 5);
}

void TestGesture::theSelectionComesBack()
{
    Desk desk(Kind::Edits);
    const Selection before{{1}, {{1, 3}}};
    desk.editor.document().setSelection(before);
    Gesture gesture = desk.begin();
    gesture.show(deleteSelection(desk.editor.document()));
    QVERIFY(desk.editor.selection() != before);
    gesture.giveUp();
    QCOMPARE(desk.editor.selection(), before);
    gesture = desk.begin();
    gesture.show(deleteSelection(desk.editor.document()));
    gesture.commit();
    desk.editor.document().setSelection({{3}, {}});
    desk.editor.undo();
    QCOMPARE(desk.editor.selection(), before);
}

void TestGesture::whatFloatsIsSettledByReading()
{
    Desk desk(Kind::Floats);
    Pictures &pictures = *desk.pictures;
    Gesture gesture = desk.begin();
    for (int k = 1; k <= steps; ++k)
        showStep(desk.editor, gesture, Kind::Floats, k);
    QCOMPARE(pictures.shown.size(), std::size_t(steps));
    QCOMPARE(*desk.editor.unsettled().painting(), desk.start);
    QCOMPARE(pictures.settled, 0);
    QCOMPARE(desk.painting(), expected(desk.start, Kind::Floats, steps));
    QCOMPARE(pictures.settled, 1);
    showStep(desk.editor, gesture, Kind::Floats, 2); // it goes on afloat
    QCOMPARE(*desk.editor.unsettled().painting(), expected(desk.start, Kind::Floats, steps));
    QCOMPARE(desk.painting(), expected(desk.start, Kind::Floats, 2));
    QCOMPARE(pictures.settled, 2);
    // What the picture cannot show is shown by edits.
    gesture.floatBy(Affine::scaling({}, 2, 1), SpreadRule::Stays);
    QVERIFY(*desk.editor.unsettled().painting() != expected(desk.start, Kind::Floats, 2));
    QCOMPARE(pictures.settled, 2);
    showStep(desk.editor, gesture, Kind::Floats, 3);
    desk.editor.clock().setTime(desk.editor.clock().time() + 1'000'000); // another moment
    QCOMPARE(*desk.editor.unsettled().painting(), expected(desk.start, Kind::Floats, 3));
    gesture.giveUp();
    QVERIFY(!pictures.isLifted());
    desk.checkUntouched();
}

void TestGesture::strokesAreLiftedAnew()
{
    Desk desk(Kind::Floats);
    Gesture gesture = desk.begin();
    showStep(desk.editor, gesture, Kind::Floats, 3);
    desk.pictures->covers = false;
    desk.editor.rest();
    QVERIFY(desk.pictures->isLifted());
    showStep(desk.editor, gesture, Kind::Floats, 5);
    QCOMPARE(desk.pictures->shown.back(), Affine::translation({8, -4})); // since it was lifted
    QCOMPARE(desk.painting(), expected(desk.start, Kind::Floats, 5));
    gesture.commit();
    desk.checkWalk();
}

void TestGesture::aHandleMoves()
{
    Desk desk(Kind::Strokes);
    Gesture first = desk.begin();
    showStep(desk.editor, first, Kind::Strokes, 1);
    Gesture second = std::move(first);
    QVERIFY(second.isOpen() && desk.editor.isDragging());
    showStep(desk.editor, second, Kind::Strokes, 2);
    QCOMPARE(desk.painting(), expected(desk.start, Kind::Strokes, 2));
    second = {};
    desk.checkUntouched();
    Gesture nothing;
    showStep(desk.editor, nothing, Kind::Strokes, 1);
    nothing.commit();
    desk.checkUntouched();
}

void TestGesture::theEditorGoesFirst()
{
    Gesture gesture;
    {
        Desk desk(Kind::Floats);
        gesture = desk.begin();
        showStep(desk.editor, gesture, Kind::Floats, 1);
    }
    gesture.floatBy(Affine(), SpreadRule::Scales);
    gesture.commit();
    QVERIFY(!gesture.isOpen());
}

void TestGesture::dragsOfFields()
{
    Desk desk(Kind::Edits);
    const auto enter = [&](ValueEntry &entry, float density) {
        desk.editor.push(changeSegments(desk.editor.document(), {{1, 2}}, [=](Segment &s) { s.density = density; }),
                         "value", &entry);
    };
    ValueEntry entry;
    entry.beginDrag();
    QVERIFY(!desk.editor.isDragging()); // nothing has come
    enter(entry, 20);
    enter(entry, 30);
    QCOMPARE(desk.painting().find(1)->segments[2].density, 30.0f);
    entry.giveUpDrag();
    desk.checkUntouched();
    entry.beginDrag();
    enter(entry, 20);
    enter(entry, 11);
    entry.commitDrag();
    desk.checkUntouched();
    entry.beginDrag();
    enter(entry, 20);
    enter(entry, 30);
    entry.commitDrag();
    QCOMPARE(desk.stack().count(), 3);
    desk.checkWalk();
}

void TestGesture::stepsOfFields()
{
    Desk desk(Kind::Edits);
    const auto enter = [&](ValueEntry &entry, float density) {
        desk.editor.push(changeSegments(desk.editor.document(), {{1, 2}}, [=](Segment &s) { s.density = density; }),
                         "value", &entry);
    };
    ValueEntry entry, other;
    enter(entry, 20);
    QVERIFY(!desk.editor.isStepping());
    enter(entry, 21);
    QVERIFY(desk.editor.isStepping()); // a hand that goes on
    QVERIFY(!desk.editor.isDragging());
    QCOMPARE(desk.stack().count(), 3); // one step, done at once
    enter(entry, 11);                  // back at its start it is none
    QCOMPARE(desk.stack().count(), 2);
    QCOMPARE(desk.painting(), desk.start);
    QVERIFY(!desk.editor.isModified());
    enter(entry, 22);
    enter(other, 23);
    enter(entry, 24); // another one came between
    QCOMPARE(desk.stack().count(), 5);
    desk.save();
    enter(entry, 25); // what is in a file stays a step
    QCOMPARE(desk.stack().count(), 6);
    desk.editor.undo();
    enter(entry, 26);
    QCOMPARE(desk.stack().count(), 6);
    enter(entry, 27);
    entry.endSteps();
    enter(entry, 28);
    QCOMPARE(desk.stack().count(), 7);
    desk.checkWalk();
}

QTEST_GUILESS_MAIN(TestGesture)
#include "test_gesture.moc"
