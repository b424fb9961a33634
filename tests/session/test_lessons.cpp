// Lessons: each step waits for what the painting shows, however it came about, and for nothing else.
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/session/lessons/lesson.h"
#include "tests/session/layer_stage.h"

#include <QSignalSpy>
#include <QTest>

using namespace suffuse;

namespace {

/// What was changed has been looked at.
void settle()
{
    for (int i = 0; i < 5; ++i)
        QCoreApplication::processEvents();
}

void select(Editor &editor, StrokeId stroke)
{
    Edit edit;
    edit.selection = stroke ? Selection{{stroke}, {}} : Selection();
    editor.document().exchange(edit);
}

Edit changed(Editor &editor, StrokeId id, const std::function<void(Segment &)> &how)
{
    Stroke stroke = *editor.document().painting()->find(id);
    for (Segment &segment : stroke.segments)
        how(segment);
    Edit edit;
    edit.strokes[id] = std::make_shared<const Stroke>(std::move(stroke));
    return edit;
}

/// Gives a stroke other segments, as a step.
void change(Editor &editor, StrokeId id, const std::function<void(Segment &)> &how)
{
    editor.push(changed(editor, id, how), "change");
}

} // namespace

class TestLessons : public QObject {
    Q_OBJECT

private slots:
    void aStrokeIsPaintedColouredAndTakenBack()
    {
        Stage s;
        Lesson lesson(LessonKind::Change, s.editor);
        QSignalSpy stepped(&lesson, &Lesson::stepped);
        QVERIFY(lesson.place().kind == LessonPlace::Kind::Canvas);
        settle();
        select(s.editor, 1);                                                 // is not what is asked for
        change(s.editor, 1, [](Segment &segment) { segment.colour.red = 1; }); // neither
        select(s.editor, 0);
        settle();
        QCOMPARE(lesson.step(), 0);
        const QString first = lesson.text();
        const StrokeId painted = s.paint();
        settle();
        QCOMPARE(lesson.step(), 1);
        QVERIFY(lesson.text() != first);
        QVERIFY(lesson.place().kind == LessonPlace::Kind::Tool);
        select(s.editor, painted);
        settle();
        QCOMPARE(lesson.step(), 2);
        change(s.editor, painted, [](Segment &segment) { segment.diffusion = 77; });
        settle();
        QCOMPARE(lesson.step(), 2);
        change(s.editor, painted, [](Segment &segment) { segment.colour.yellow = 0.5f; });
        settle();
        QCOMPARE(lesson.step(), 3);
        s.editor.undo();
        settle();
        QVERIFY(lesson.isDone());
        QCOMPARE(lesson.step(), lesson.count());
        QCOMPARE(int(stepped.count()), lesson.count());
        s.editor.undo();
        s.editor.undo();
        settle();
        QVERIFY(lesson.isDone()); // what was learned stays
    }

    void paintSpreadsAndDries()
    {
        Stage s;
        s.editor.clock().setManual(true);
        Lesson lesson(LessonKind::Spread, s.editor);
        const StrokeId painted = s.paint();
        s.editor.clock().setTime(0);
        settle();
        QCOMPARE(lesson.step(), 1);
        s.editor.clock().setTime(s.painting().end());
        settle();
        QCOMPARE(lesson.step(), 2);
        select(s.editor, painted);
        settle();
        change(s.editor, painted, [](Segment &segment) { segment.colour.yellow = 0.5f; });
        settle();
        QCOMPARE(lesson.step(), 3);
        // While a slider is dragged nothing is decided.
        Gesture gesture = s.editor.begin("drag");
        gesture.show(changed(s.editor, painted, [](Segment &segment) { segment.diffusion = 99; }));
        settle();
        QCOMPARE(lesson.step(), 3);
        gesture.commit();
        settle();
        QVERIFY(lesson.isDone());
    }

    void aLayerIsMadePaintedOnAndFaded()
    {
        Stage s;
        s.layer.choose(1);
        Lesson lesson(LessonKind::Layers, s.editor);
        settle();
        QCOMPARE(lesson.step(), 0); // there was a layer before
        s.table[Command::NewLayer].trigger();
        settle();
        QCOMPARE(lesson.step(), 1);
        s.paint();
        settle();
        QCOMPARE(lesson.step(), 2);
        QVERIFY(QByteArray(lesson.place().dock) == "strokesDock");
        std::vector<Group> groups = s.painting().groups;
        groups.back().opacity = 0.5f;
        Edit edit;
        edit.groups = groups;
        s.editor.push(std::move(edit), "fade");
        settle();
        QVERIFY(lesson.isDone());
    }

    void eachHasATitleAndItsOwnSteps()
    {
        Stage s;
        QStringList titles;
        for (const LessonKind kind : lessonKinds) {
            const Lesson lesson(kind, s.editor);
            titles << titleOf(kind);
            QVERIFY(lesson.count() > 2 && !lesson.text().isEmpty());
        }
        QCOMPARE(titles.removeDuplicates(), 0);
    }
};

QTEST_MAIN(TestLessons)
#include "test_lessons.moc"
