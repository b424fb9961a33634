// Edits of nodes, shapes and groups: what they do, and that undo takes it back.
#include "model/painting/validate.h"
#include "model/shaping/erasing/erase.h"
#include "tests/undo/random_shape_edits.h"
#include "tests/undo/steps.h"

#include <QTest>
#include <QUndoStack>

using namespace suffuse;
using namespace suffuse::test;

namespace {

using Order = std::vector<StrokeId>;

void lock(Document &d, StrokeId id)
{
    Edit edit = setLocked(d, {id}, true);
    d.exchange(edit);
}

std::set<StrokeId> everyStroke(const Document &d)
{
    std::set<StrokeId> ids;
    for (const StrokePtr &stroke : d.painting()->strokes)
        ids.insert(stroke->id);
    return ids;
}

} // namespace

class TestShapeEdits : public QObject {
    Q_OBJECT

private slots:
    void undoReturnsToEqualDocuments()
    {
        for (unsigned walk = 0; walk < 60; ++walk) {
            AwkwardStrokes random(walk);
            Document d;
            d.reset(awkwardPainting(random, 6));
            QUndoStack stack;
            ShapeEdits edits(d, walk);
            const QByteArray first = hashOf(*d.painting());
            StepRun run;
            bool runs = false;
            for (int i = 0; i < 150; ++i) {
                if (edits.below(4) == 0) {
                    run.reset();
                    runs = edits.below(2);
                }
                const QByteArray before = hashOf(*d.painting());
                const Selection selection = d.selection();
                Edit edit = edits.next();
                if (d.painting()->segmentCount() > 3000) // uneven maps split
                    break;
                if (edit.isEmpty())
                    continue;
                const Selection selected = d.selection();
                Edit copy = edit;
                d.exchange(copy);
                QCOMPARE(problemOf(*d.painting()), QString());
                d.exchange(copy);
                QCOMPARE(hashOf(*d.painting()), before);
                QCOMPARE(d.selection(), selected);
                pushStep(stack, d, std::move(edit), QStringLiteral("edit"), runs ? &run : nullptr);
            }
            QVERIFY(stack.index() > 10);
            checkUndoAllAndRedo(stack, d, first);
            if (QTest::currentTestFailed())
                return;
        }
    }

    void lockedStrokesAreLeftAlone()
    {
        for (unsigned walk = 0; walk < 20; ++walk) {
            AwkwardStrokes random(walk);
            Document d;
            d.reset(awkwardPainting(random, 5));
            lock(d, 3);
            ShapeEdits edits(d, walk);
            Stroke expected = strokeOf(d, 3);
            for (int i = 0; i < 150; ++i) {
                Edit edit = edits.next();
                if (!edit.strokes.contains(3))
                    continue;
                // Names, visibility and its lock may change, and its group may be dissolved.
                const StrokePtr after = edit.strokes.at(3);
                QVERIFY(after);
                expected.name = after->name;
                expected.visible = after->visible;
                expected.locked = after->locked;
                expected.group = after->group;
                QCOMPARE(*after, expected);
            }
        }
    }

    void insertedNodesKeepTheSelectionOnTheirSegments()
    {
        Document d;
        d.reset(makePainting(2));
        select(d, {1, 2}, {{1, 1}, {1, 3}, {2, 0}});
        Edit edit = insertNodes(d, {{1, {{1, 0.5}, {0, 0.5}}}});
        d.exchange(edit);
        QCOMPARE(strokeOf(d, 1).segments.size(), std::size_t(6));
        QCOMPARE(d.selection().segments, (std::set<SegmentRef>{{1, 2}, {1, 3}, {1, 5}, {2, 0}}));
        d.exchange(edit);
        QCOMPARE(d.selection().segments, (std::set<SegmentRef>{{1, 1}, {1, 3}, {2, 0}}));
        QVERIFY(insertNodes(d, {{1, {{1, 0.0}, {2, 1.0}, {9, 0.5}}}}).isEmpty());
        QVERIFY(insertNodes(d, {{7, {{0, 0.5}}}}).isEmpty());
    }

    void deletedNodesTakeSegmentsAndStrokesAlong()
    {
        Document d;
        d.reset(makePainting(3));
        select(d, {1, 2}, {{1, 2}});
        Edit edit = deleteNodes(d, {{1, 2}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {3, 3}});
        d.exchange(edit);
        QCOMPARE(orderOf(d), (Order{1, 2}));
        QCOMPARE(strokeOf(d, 1).segments.size(), std::size_t(3));
        QCOMPARE(strokeOf(d, 1).segments[1].density, 10.5f); // 10 and 11, equally long
        QCOMPARE(strokeOf(d, 2).segments.size(), std::size_t(3));
        QCOMPARE(strokeOf(d, 2).segments[0].density, 10.0f);
        QCOMPARE(d.selection().segments, (std::set<SegmentRef>{{1, 1}}));
        d.exchange(edit);
        QCOMPARE(*d.painting(), *makePainting(3));
    }

    void splittingMakesStrokesThatStandTogether()
    {
        Document d;
        d.reset(makePainting(3));
        select(d, {2}, {{2, 0}, {2, 2}});
        const Stroke before = strokeOf(d, 2);
        Edit edit = splitAt(d, {{2, {{1, 0.5}, {2, 0.0}}}});
        d.exchange(edit);
        QCOMPARE(orderOf(d), (Order{1, 2, 4, 5, 3}));
        QCOMPARE(strokeOf(d, 2).segments.size(), std::size_t(2));
        QCOMPARE(strokeOf(d, 4).segments.size(), std::size_t(1));
        QCOMPARE(strokeOf(d, 5).segments.size(), std::size_t(2));
        QCOMPARE(strokeOf(d, 5).segments[1], before.segments[3]);
        QCOMPARE(strokeOf(d, 5).brush, before.brush);
        QCOMPARE(d.selection().strokes, (std::set<StrokeId>{2, 4, 5}));
        QCOMPARE(d.selection().segments, (std::set<SegmentRef>{{2, 0}, {5, 0}}));
        // And joined again: the curve that there was, with two more nodes.
        Edit join = joinSelection(d);
        d.exchange(join);
        QCOMPARE(orderOf(d), (Order{1, 5, 3}));
        QCOMPARE(strokeOf(d, 5).segments.size(), std::size_t(5));
        QCOMPARE(strokeOf(d, 5).segments[0], before.segments[0]);
        d.exchange(join);
        d.exchange(edit);
        QCOMPARE(orderOf(d), (Order{1, 2, 3}));
        QVERIFY(splitAtNodes(d, {{1, 0}, {1, 4}}).isEmpty());
    }

    void joinTakesTheNearestEnds()
    {
        Document d;
        d.reset(makePainting(3)); // from 60 i to 60 i + 40
        select(d, {1, 2});
        Edit edit = joinSelection(d);
        d.exchange(edit);
        QCOMPARE(orderOf(d), (Order{2, 3}));
        const Stroke whole = strokeOf(d, 2);
        QCOMPARE(whole.segments.size(), std::size_t(9));
        QCOMPARE(nodePosition(whole, 0), (Point{60, 0}));
        QCOMPARE(nodePosition(whole, 9), (Point{160, 0}));
        QCOMPARE(whole.segments[4].density, 9.0f); // the bridge, by the upper one's start
        QCOMPARE(d.selection().strokes, std::set<StrokeId>{2});
        d.exchange(edit);
        Edit nodes = joinNodes(d, {1, 0}, {3, 4});
        d.exchange(nodes);
        QCOMPARE(orderOf(d), (Order{2, 3}));
        d.exchange(nodes);
        Edit ring = joinNodes(d, {1, 0}, {1, 4});
        d.exchange(ring);
        QCOMPARE(strokeOf(d, 1).segments.size(), std::size_t(5));
        QCOMPARE(nodePosition(strokeOf(d, 1), 5), nodePosition(strokeOf(d, 1), 0));
        QVERIFY(joinNodes(d, {2, 1}, {3, 0}).isEmpty()); // not an end
        QVERIFY(joinNodes(d, {2, 0}, {9, 0}).isEmpty());
        QVERIFY(joinNodes(d, {2, 0}, {2, 0}).isEmpty());
    }

    void erasingTouchesOnlyWhatLiesUnderIt()
    {
        Document d;
        d.reset(makePainting(4));
        lock(d, 3);
        select(d, {1}, {{1, 3}});
        const PaintingPtr before = d.painting();
        Edit edit = eraseAlong(d, {1, 2, 3, 4}, {{0, 0}, {500, 0}}, 3);
        QCOMPARE(edit.strokes.size(), std::size_t(3));
        d.exchange(edit);
        QCOMPARE(orderOf(d), Order{3});
        QVERIFY(d.selection().isEmpty());
        d.exchange(edit);
        QCOMPARE(*d.painting(), *before);
        // A hole: two runs, the second one with an id of its own; the others are the same strokes.
        edit = eraseAlong(d, {1, 2, 3, 4}, {{80, 5}}, 6);
        d.exchange(edit);
        QCOMPARE(orderOf(d), (Order{1, 5, 2, 3, 4}));
        QCOMPARE(d.selection().strokes, (std::set<StrokeId>{1, 5}));
        QCOMPARE(d.selection().segments, (std::set<SegmentRef>{{5, 1}}));
        QCOMPARE(strokeOf(d, 1).segments[0], before->strokes[0]->segments[0]);
        QCOMPARE(strokeOf(d, 5).segments.back(), before->strokes[0]->segments.back());
        const double half = std::sqrt(36.0 - 25.0);
        QVERIFY(std::abs(nodePosition(strokeOf(d, 1), 2).x - (80 - half)) < 1e-5);
        QVERIFY(std::abs(nodePosition(strokeOf(d, 5), 0).x - (80 + half)) < 1e-5);
        for (std::size_t i = 1; i < 4; ++i)
            QCOMPARE(d.painting()->strokes[i + 1], before->strokes[i]); // the pointers
        d.exchange(edit);
        QVERIFY(eraseAlong(d, {2}, {{80, 5}}, 6).isEmpty());
        QVERIFY(eraseAlong(d, {1}, {{80, 50}}, 6).isEmpty());
        QVERIFY(eraseAlong(d, {}, {{80, 5}}, 6).isEmpty()); // no targets: nothing
    }

    void anErasersDragIsOneStep()
    {
        Document d;
        d.reset(makePainting(3));
        QUndoStack stack;
        StepRun run;
        for (double x = 50; x < 250; x += 5)
            if (Edit edit = eraseAlong(d, everyStroke(d), {{x, -20}, {x + 5, 20}}, 2); !edit.isEmpty())
                pushStep(stack, d, std::move(edit), QStringLiteral("erase"), &run);
        QCOMPARE(stack.count(), 1);
        QVERIFY(d.painting()->strokes.size() > 10);
        stack.undo();
        QCOMPARE(*d.painting(), *makePainting(3));
    }

    void combiningAndBreakingApart()
    {
        Document d;
        d.reset(makePainting(3));
        select(d, {1, 3}, {{1, 2}});
        const PaintingPtr before = d.painting();
        Edit edit = combineSelection(d);
        d.exchange(edit);
        QCOMPARE(orderOf(d), (Order{2, 3}));
        QCOMPARE(d.selection(), (Selection{{3}, {}}));
        const Stroke whole = strokeOf(d, 3);
        QCOMPARE(chainsOf(whole), (std::vector<Chain>{{0, 3}, {4, 7}}));
        QCOMPARE(nodePosition(whole, 4), nodePosition(*before->strokes[0], 0));
        Edit apart = breakApart(d);
        d.exchange(apart);
        QCOMPARE(orderOf(d), (Order{2, 3, 4}));
        QCOMPARE(d.selection().strokes, (std::set<StrokeId>{3, 4}));
        QCOMPARE(strokeOf(d, 3).segments, before->strokes[2]->segments);
        QVERIFY(!strokeOf(d, 4).segments.front().start);
        QVERIFY(breakApart(d).isEmpty());
        d.exchange(apart);
        d.exchange(edit);
        QCOMPARE(*d.painting(), *before);
        QVERIFY(combineSelection(d).isEmpty() == false);
        lock(d, 1);
        QVERIFY(combineSelection(d).isEmpty()); // one is left
    }

    void erasuresGoWithTheirPartAndComeOff()
    {
        Document d;
        auto painting = std::make_shared<Painting>(*makePainting(1));
        Stroke stroke = *painting->strokes[0];
        Segment lift = stroke.segments.front();
        lift.lift = lift.start = true;
        Stroke far = stroke; // a second chain, far off
        far.origin.x += 1e4;
        stroke = *combined(stroke, far);
        stroke.segments.push_back(lift);
        lift.start = false;
        std::swap(lift.bezier[0], lift.bezier[3]);
        std::swap(lift.bezier[1], lift.bezier[2]);
        stroke.segments.push_back(lift); // back again
        const StrokeList strokes{std::make_shared<const Stroke>(stroke)};
        painting->strokes = strokes;
        d.reset(painting);
        select(d, {1}, {{1, 9}});
        Edit one = removeErasures(d); // the selected one
        QCOMPARE(one.strokes.at(1)->segments.size(), stroke.segments.size() - 1);
        select(d, {1});
        Edit all = removeErasures(d);
        d.exchange(all);
        QVERIFY(!strokeOf(d, 1).hasErasure());
        QCOMPARE(strokeOf(d, 1).segments.size(), std::size_t(8));
        QVERIFY(removeErasures(d).isEmpty());
        d.exchange(all);
        QCOMPARE(strokeOf(d, 1), stroke);
        Edit apart = breakApart(d);
        d.exchange(apart);
        QCOMPARE(strokeOf(d, 1).segments.size(), std::size_t(6));
        QCOMPARE(strokeOf(d, 2).segments.size(), std::size_t(4)); // nothing is erased there
        QVERIFY(!strokeOf(d, 2).hasErasure());
    }

    void aStrokeOfChainsGoesOnFromEachEnd()
    {
        Document d;
        d.reset(makePainting(3)); // from 60 i to 60 i + 40
        select(d, {1, 2});
        Edit edit = combineSelection(d);
        d.exchange(edit);
        const Stroke whole = strokeOf(d, 2);
        QCOMPARE(endNodesOf(whole).size(), std::size_t(4));
        for (const int node : endNodesOf(whole)) {
            Stroke added = *d.painting()->strokes[1];
            added.origin = nodePosition(whole, node) - (nodePosition(added, 0) - added.origin);
            Edit longer = extendStroke(d, {2, node}, added);
            QVERIFY(!longer.isEmpty());
            QCOMPARE(chainsOf(*longer.strokes.at(2)).size(), std::size_t(2));
            QCOMPARE(longer.strokes.at(2)->segments.size(), std::size_t(12));
        }
        QVERIFY(extendStroke(d, {2, 1}, whole).isEmpty()); // not an end
    }

    void reversingIsItsOwnInverse()
    {
        Document d;
        d.reset(makePainting(2));
        select(d, {1, 2}, {{1, 0}});
        Edit edit = reverseSelection(d);
        d.exchange(edit);
        QCOMPARE(d.selection().segments, (std::set<SegmentRef>{{1, 3}}));
        QCOMPARE(nodePosition(strokeOf(d, 1), 0), (Point{100, 0}));
        Edit again = reverseSelection(d);
        d.exchange(again);
        QCOMPARE(*d.painting(), *makePainting(2));
        QCOMPARE(d.selection().segments, (std::set<SegmentRef>{{1, 0}}));
    }

    void aStrokeGoesOnAtEitherEnd()
    {
        Document d;
        d.reset(makePainting(1));
        select(d, {1}, {{1, 1}});
        const Stroke more = *makeStroke(9, 100, 0, 2);
        Edit edit = extendStroke(d, {1, nodeCount(strokeOf(d, 1)) - 1}, more);
        d.exchange(edit);
        QCOMPARE(strokeOf(d, 1).segments.size(), std::size_t(6));
        QCOMPARE(d.selection().segments, (std::set<SegmentRef>{{1, 1}}));
        Edit front = extendStroke(d, {1, 0}, *makeStroke(9, 60, 0, 3));
        d.exchange(front);
        QCOMPARE(strokeOf(d, 1).segments.size(), std::size_t(9));
        QCOMPARE(d.selection().segments, (std::set<SegmentRef>{{1, 4}}));
        QCOMPARE(nodePosition(strokeOf(d, 1), 3), (Point{60, 0})); // drawn away from the start
        QCOMPARE(nodePosition(strokeOf(d, 1), 0), (Point{90, 0}));
    }

    void aDragOfHandlesComesBack()
    {
        AwkwardStrokes random(3);
        Document d;
        d.reset(awkwardPainting(random, 4));
        lock(d, 4);
        const PaintingPtr before = d.painting();
        std::set<SegmentRef> segments;
        for (int k = 0; k < int(before->find(1)->segments.size()); ++k)
            segments.insert({1, k});
        select(d, {1, 2, 4}, segments);
        const Selection selection = d.selection();
        QUndoStack stack;
        StepRun run;
        const auto drag = [&](const Affine &map) {
            pushStep(stack, d, transformSelection(d, *before, selection, map, SpreadRule::Scales),
                     QStringLiteral("scale"), &run);
        };
        for (double k : {1.1, 1.4, 2.0, 0.7})
            drag(Affine::scaling({10, 10}, k, 1 / k));
        QVERIFY(strokeOf(d, 1).segments.size() > before->find(1)->segments.size());
        QCOMPARE(d.selection().segments.size(), strokeOf(d, 1).segments.size()); // the parts of what was selected
        QCOMPARE(strokeOf(d, 4), *before->find(4));
        QCOMPARE(stack.count(), 1);
        drag(Affine());
        QCOMPARE(stack.count(), 0); // it came back to its start
        QCOMPARE(*d.painting(), *before);
        QCOMPARE(d.selection(), selection);
        // All or none: what one stroke cannot take, no one does.
        QVERIFY(transformSelection(d, Affine::scaling({}, 1e13, 1e13), SpreadRule::Scales).isEmpty());
        QVERIFY(transformSelection(d, Affine(), SpreadRule::Scales).isEmpty());
    }

    void dragsReplaceWhatIsThere()
    {
        Document d;
        d.reset(makePainting(2));
        lock(d, 2);
        const Stroke before = strokeOf(d, 1), other = strokeOf(d, 2);
        Edit edit = replaceStrokes(d, {withNodeMoved(before, {1}, {3, 4}), withNodeMoved(other, {1}, {3, 4})});
        QCOMPARE(edit.strokes.size(), std::size_t(1));
        d.exchange(edit);
        QCOMPARE(nodePosition(strokeOf(d, 1), 1), (Point{73, 4}));
        Edit back = replaceStrokes(d, {before});
        d.exchange(back);
        QCOMPARE(strokeOf(d, 1), before);
        QVERIFY(replaceStrokes(d, {before}).isEmpty());
        select(d, {1}, {{1, 1}, {1, 2}});
        Edit bridge = bridgeSegments(d, d.selection().segments);
        d.exchange(bridge);
        QCOMPARE(strokeOf(d, 1).segments.size(), std::size_t(3));
        QCOMPARE(d.selection().segments, (std::set<SegmentRef>{{1, 1}}));
        QCOMPARE(strokeOf(d, 1).segments[2], [&] {
            Segment next = before.segments[3];
            next.node = NodeKind::Smooth;
            return next;
        }());
    }
};

QTEST_APPLESS_MAIN(TestShapeEdits)
#include "test_shape_edits.moc"
