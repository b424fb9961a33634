// Edits and their undoing.
#include "model/painting/validate.h"
#include "tests/trials.h"
#include "tests/undo/random_edits.h"
#include "tests/undo/steps.h"

#include <QTest>
#include <QUndoStack>

using namespace suffuse;

namespace {

using Order = std::vector<StrokeId>;

} // namespace

class TestUndo : public QObject {
    Q_OBJECT

private slots:
    void randomWalks()
    {
        const quint32 walks = quint32(trials(200, 10'000)), from = firstSeed();
        const int length = isLongRun() ? 10'000 : 2'000;
        qint64 steps = 0;
        for (quint32 walk = from; walk < from + walks; ++walk) {
            Document d;
            d.reset(makePainting(5));
            QUndoStack stack;
            RandomEdits edits(d, walk);
            const QByteArray first = hashOf(*d.painting());
            StepRun run;
            bool runs = false;
            for (int i = 0; i < length; ++i) {
                if (edits.below(4) == 0) {
                    run.reset();
                    runs = edits.below(2);
                }
                if (edits.below(10) == 0) {
                    for (int k = edits.below(5); k > 0; --k)
                        stack.undo();
                    for (int k = edits.below(3); k > 0; --k)
                        stack.redo();
                }
                if (Edit edit = edits.next(); !edit.isEmpty())
                    pushStep(stack, d, std::move(edit), QStringLiteral("edit"), runs ? &run : nullptr);
                if (i % 10 == 0)
                    QCOMPARE(problemOf(*d.painting()), QString());
            }
            QVERIFY(stack.index() > length / 10);
            steps += stack.index();
            checkUndoAllAndRedo(stack, d, first);
            if (QTest::currentTestFailed())
                return;
        }
        qInfo("%u walks, %lld steps on the way back and forth", walks, static_cast<long long>(steps));
    }

    void aDragIsOneStep()
    {
        Document d;
        d.reset(makePainting(2));
        QUndoStack stack;
        const QByteArray first = hashOf(*d.painting());
        const auto drag = [&](float density, StepRun *run) {
            pushStep(stack, d, changeSegments(d, {{1, 2}}, [=](Segment &s) { s.density = density; }),
                     QStringLiteral("density"), run);
        };
        StepRun one;
        for (int i = 0; i < 50; ++i)
            drag(float(20 + i), &one);
        QCOMPARE(stack.count(), 1);
        StepRun two;
        drag(3, &two);
        drag(4, &two);
        QCOMPARE(stack.count(), 2);
        drag(5, nullptr);
        drag(6, nullptr);
        QCOMPARE(stack.count(), 4);
        stack.undo(), stack.undo(), stack.undo();
        QCOMPARE(d.painting()->strokes[0]->segments[2].density, 69.0f);
        stack.undo();
        QCOMPARE(hashOf(*d.painting()), first);
    }

    void aRunMayTouchDifferentParts()
    {
        Document d;
        d.reset(makePainting(3));
        const QByteArray first = hashOf(*d.painting());
        QUndoStack stack;
        StepRun run;
        for (StrokeId id : {1, 2, 3, 2})
            pushStep(stack, d, changeStrokes(d, {id}, [](Stroke &s) { s.origin.x += 1; }), {}, &run);
        pushStep(stack, d, reorder(d, {1}, 0), {}, &run);
        QCOMPARE(stack.count(), 1);
        QCOMPARE(d.painting()->find(2)->origin.x, 122.0);
        stack.undo();
        QCOMPARE(hashOf(*d.painting()), first);
    }

    void aRunThatComesBackLeavesNoStep()
    {
        Document d;
        d.reset(makePainting(2));
        QUndoStack stack;
        stack.setClean();
        StepRun run;
        for (float density : {20.0f, 30.0f, 9.0f})
            pushStep(stack, d, changeSegments(d, {{1, 0}}, [=](Segment &s) { s.density = density; }), {}, &run);
        QCOMPARE(stack.count(), 0);
        QVERIFY(stack.isClean());
        // And one that would only select.
        Edit selecting;
        selecting.selection = Selection{{1}, {}};
        pushStep(stack, d, selecting);
        QCOMPARE(stack.count(), 0);
        QCOMPARE(d.selection(), (Selection{{1}, {}}));
    }

    void undoBringsTheSelectionBack()
    {
        Document d;
        d.reset(makePainting(3));
        d.setSelection({{2}, {{2, 1}}});
        const Selection before = d.selection();
        QUndoStack stack;
        pushStep(stack, d, deleteSelection(d));
        QVERIFY(d.selection().isEmpty());
        d.setSelection({{3}, {}});
        stack.undo();
        QCOMPARE(d.selection(), before);
        pushStep(stack, d, changeSegments(d, targetSegments(d), [](Segment &s) { s.density = 1; }));
        d.setSelection({});
        stack.undo();
        QCOMPARE(d.selection(), before);
    }

    void deletingSegmentsKeepsTheRest()
    {
        Document d;
        d.reset(makePainting(3));
        const Stroke original = *d.painting()->find(2);
        d.setSelection({{}, {{2, 1}}});
        Edit edit = deleteSelection(d);
        d.exchange(edit);
        QCOMPARE(orderOf(d), (Order{1, 2, 4, 3}));
        const Stroke &head = *d.painting()->find(2), &tail = *d.painting()->find(4);
        QCOMPARE(head.segments, (std::vector<Segment>{original.segments[0]}));
        QCOMPARE(tail.segments, (std::vector<Segment>{original.segments[2], original.segments[3]}));
        QCOMPARE(tail.origin, original.origin);
        d.setSelection({{}, {{4, 0}, {4, 1}}});
        Edit rest = deleteSelection(d);
        d.exchange(rest);
        QCOMPARE(orderOf(d), (Order{1, 2, 3}));
        d.setSelection({{1, 3}, {}});
        Edit whole = deleteSelection(d);
        d.exchange(whole);
        QCOMPARE(orderOf(d), (Order{2}));
    }

    void lockedStrokesAreLeftAlone()
    {
        Document d;
        auto p = std::make_shared<Painting>(*makePainting(3));
        p->groups = {{1, {}, 0, true, true}};
        auto locked = std::make_shared<Stroke>(*p->strokes[0]);
        locked->group = 1;
        p->strokes[0] = locked;
        d.reset(p);
        d.setSelection({{1}, {}});
        QVERIFY(deleteSelection(d).isEmpty());
        QVERIFY(duplicateSelection(d, {5, 5}).isEmpty());
        QVERIFY(arrangeSelection(d, Arrange::Top).isEmpty());
        QVERIFY(reorder(d, {1}, 0).isEmpty());
        QVERIFY(changeSegments(d, targetSegments(d), [](Segment &s) { s.density = 1; }).isEmpty());
        Edit named = changeStrokes(d, {1}, [](Stroke &s) { s.name = QStringLiteral("sky"), s.origin.x = 0; });
        d.exchange(named);
        QCOMPARE(d.painting()->find(1)->name, QStringLiteral("sky"));
        QCOMPARE(d.painting()->find(1)->origin.x, 60.0);
    }

    void invalidChangesAreDropped()
    {
        Document d;
        d.reset(makePainting(1));
        const auto half = changeSegments(d, {{1, 0}, {1, 1}}, [first = true](Segment &s) mutable {
            s.density = first ? -1.0f : 5.0f;
            first = false;
        });
        QCOMPARE(half.strokes.size(), std::size_t(1));
        QCOMPARE(half.strokes.at(1)->segments[0].density, 9.0f);
        QCOMPARE(half.strokes.at(1)->segments[1].density, 5.0f);
        QVERIFY(changeSegments(d, {{1, 1}}, [](Segment &s) { s.bezier[0].x += 1; }).isEmpty()); // off its neighbour
        QVERIFY(changeSegments(d, {{1, 99}, {7, 0}}, [](Segment &s) { s.density = 5; }).isEmpty());
        QVERIFY(changeStrokes(d, {1}, [](Stroke &s) { s.segments.clear(); }).isEmpty());
        QVERIFY(changeStrokes(d, {1}, [](Stroke &s) { s.id = 5; }).isEmpty());
        QVERIFY(addStrokes(d, {makeStroke(1, 0, 0), nullptr}, true).isEmpty()); // the id is taken
        Canvas bad;
        bad.width = -1;
        QVERIFY(setCanvas(d, bad).isEmpty());
        QVERIFY(setCanvas(d, d.painting()->canvas).isEmpty());
    }

    void duplicatesStandAboveTheTopmost()
    {
        Document d;
        d.reset(makePainting(4));
        d.setSelection({{1, 3}, {}});
        Edit edit = duplicateSelection(d, {7, -2});
        d.exchange(edit);
        QCOMPARE(orderOf(d), (Order{1, 2, 3, 5, 6, 4}));
        QCOMPARE(d.painting()->find(6)->origin, (Point{187, -2}));
        QCOMPARE(d.selection(), (Selection{{5, 6}, {}}));
    }

    void arranging()
    {
        Document d;
        auto p = std::make_shared<Painting>();
        // 1 meets 4 only; 2 and 3 lie elsewhere.
        p->strokes = {makeStroke(1, 0, 0), makeStroke(2, 1000, 0), makeStroke(3, 1000, 5), makeStroke(4, 10, 0)};
        d.reset(p);
        const auto arranged = [&d](StrokeId id, Arrange how) {
            d.setSelection({{id}, {}});
            Edit edit = arrangeSelection(d, how);
            return edit.order ? *edit.order : Order();
        };
        QCOMPARE(arranged(1, Arrange::Raise), (Order{2, 3, 4, 1}));
        QCOMPARE(arranged(4, Arrange::Lower), (Order{4, 1, 2, 3}));
        QCOMPARE(arranged(2, Arrange::Raise), (Order{1, 3, 2, 4}));
        QCOMPARE(arranged(3, Arrange::Raise), Order()); // nothing above it is met
        QCOMPARE(arranged(3, Arrange::Bottom), (Order{3, 1, 2, 4}));
        QCOMPARE(arranged(1, Arrange::Top), (Order{2, 3, 4, 1}));
        QCOMPARE(arranged(4, Arrange::Top), Order());
    }

    void groupsStayTogether()
    {
        Document d;
        auto p = std::make_shared<Painting>();
        p->groups = {{1, {}, 0, true, false}, {2, {}, 1, true, false}};
        p->strokes = {makeStroke(1, 0, 0, 1), makeStroke(2, 0, 0, 1, 1), makeStroke(3, 0, 0, 1, 2),
                      makeStroke(4, 0, 0, 1, 2), makeStroke(5, 0, 0, 1)};
        d.reset(p);
        const auto arranged = [&d](const std::set<StrokeId> &ids, Arrange how) {
            d.setSelection({ids, {}});
            Edit edit = arrangeSelection(d, how);
            return edit.order ? *edit.order : Order();
        };
        QCOMPARE(arranged({1}, Arrange::Raise), (Order{2, 3, 4, 1, 5}));     // over the whole group
        QCOMPARE(arranged({2}, Arrange::Top), (Order{1, 3, 4, 2, 5}));       // within its group
        QCOMPARE(arranged({4}, Arrange::Lower), (Order{1, 2, 4, 3, 5}));     // within the subgroup
        QCOMPARE(arranged({2, 3, 4}, Arrange::Top), (Order{1, 5, 2, 3, 4})); // the group as a whole
        QCOMPARE(arranged({3, 4}, Arrange::Bottom), (Order{1, 3, 4, 2, 5})); // the subgroup as a whole

        Edit in = reorder(d, {5}, 4); // joins the group that it is dropped into
        d.exchange(in);
        QCOMPARE(orderOf(d), (Order{1, 2, 3, 5, 4}));
        QCOMPARE(d.painting()->find(5)->group, GroupId(2));
        QCOMPARE(problemOf(*d.painting()), QString());
        Edit out = reorder(d, {2}, 1);
        d.exchange(out);
        QCOMPARE(orderOf(d), (Order{2, 1, 3, 5, 4}));
        QCOMPARE(d.painting()->find(2)->group, GroupId(0));
        QCOMPARE(problemOf(*d.painting()), QString());
        Edit whole = reorder(d, {3, 5, 4}, 2); // a whole group keeps its strokes
        d.exchange(whole);
        QCOMPARE(orderOf(d), (Order{3, 5, 4, 2, 1}));
        QCOMPARE(d.painting()->find(3)->group, GroupId(2));
        QCOMPARE(problemOf(*d.painting()), QString());
        QVERIFY(reorder(d, {3}, 77).isEmpty());
        QVERIFY(reorder(d, {}, 0).isEmpty());
    }

    void addingSelects()
    {
        Document d;
        d.reset(makePainting(1));
        Edit edit = addStrokes(d, {makeStroke(5, 0, 0, 1, 3), makeStroke(6, 0, 0)}, true);
        d.exchange(edit);
        QCOMPARE(orderOf(d), (Order{1, 5, 6}));
        QCOMPARE(d.selection(), (Selection{{5, 6}, {}}));
        QCOMPARE(d.painting()->find(5)->group, GroupId(0)); // no such group here
    }
};

QTEST_GUILESS_MAIN(TestUndo)
#include "test_undo.moc"
