// The layer that is painted on: what becomes of it when groups go and come back, and of what is painted there.
#include "app/session/commands/selection_commands.h"
#include "app/session/current_layer.h"
#include "model/painting/validate.h"
#include "tests/session/layer_stage.h"
#include "undo/edits.h"
#include "undo/layers/group_edits.h"

#include <QSignalSpy>
#include <QTest>

using namespace suffuse;

class TestCurrentLayer : public QObject {
    Q_OBJECT

private slots:
    void aGroupThatGoesLeavesTheOneAroundIt()
    {
        Stage s;
        s.layer.choose(3);
        s.editor.push(ungroup(s.editor.document(), 3), "ungroup");
        QCOMPARE(s.layer.group(), GroupId(2));
        s.editor.push(ungroup(s.editor.document(), 2), "ungroup");
        QCOMPARE(s.layer.group(), GroupId(0));
        s.editor.undo();
        QCOMPARE(s.layer.group(), GroupId(2));
        s.editor.document().reset(std::make_shared<const Painting>());
        QCOMPARE(s.layer.group(), GroupId(0));
    }

    void aNewLayerIsThereFromItsFirstStrokeOn()
    {
        Stage s;
        s.layer.choose(1);
        QSignalSpy changed(&s.layer, &CurrentLayer::changed), noted(&s.layer, &CurrentLayer::noted);
        s.table[Command::NewLayer].trigger();
        QVERIFY(s.layer.isComing());
        QCOMPARE(s.layer.title(), QString("Layer 1"));
        QCOMPARE(int(noted.count()), 1);
        QCOMPARE(s.painting().groups.size(), std::size_t(3));
        QVERIFY(!s.table[Command::MergeLayerDown].isEnabled());
        const GroupId made = s.layer.group();
        const StrokeId stroke = s.paint();
        QVERIFY(!s.layer.isComing());
        QCOMPARE(int(changed.count()), 2);
        QCOMPARE(s.order(), (Order{1, 2, stroke, 3, 4, 5}));
        QCOMPARE(s.painting().find(stroke)->group, made);
        QCOMPARE(s.editor.undoStack().count(), 1);
        s.editor.undo();
        QVERIFY(s.layer.isComing()); // It is painted on again.
        QCOMPARE(s.layer.group(), made);
        const StrokeId other = s.paint();
        QCOMPARE(s.painting().find(other)->group, made);
        s.table[Command::NewLayer].trigger();
        QCOMPARE(s.layer.title(), QString("Layer 2"));
    }

    /// It is seen only where the layer below has paint. One that is still to come becomes the one or the other.
    void aClippedLayerComesAboveItsLayer()
    {
        Stage s;
        QVERIFY(!s.table[Command::NewClippedLayer].isEnabled());
        s.layer.choose(1);
        s.table[Command::NewClippedLayer].trigger();
        QVERIFY(s.layer.isComing());
        const GroupId made = s.layer.group();
        const StrokeId stroke = s.paint();
        QCOMPARE(s.order(), (Order{1, 2, stroke, 3, 4, 5}));
        QCOMPARE(s.painting().find(stroke)->group, made);
        QVERIFY(s.painting().findGroup(made)->clips);
        QCOMPARE(s.painting().findGroup(made)->parent, s.painting().findGroup(1)->parent);
        s.table[Command::NewLayer].trigger();
        s.table[Command::NewClippedLayer].trigger();
        const StrokeId shade = s.paint();
        QVERIFY(s.painting().findGroup(s.painting().find(shade)->group)->clips);
        s.table[Command::NewClippedLayer].trigger();
        s.table[Command::NewLayer].trigger();
        const StrokeId plain = s.paint();
        QVERIFY(!s.painting().findGroup(s.painting().find(plain)->group)->clips);
        QCOMPARE(s.order(), (Order{1, 2, stroke, shade, plain, 3, 4, 5}));
    }

    /// Whose only stroke is deleted with it, since its row is selected.
    void aLayerThatIsDeletedIsLeft_data()
    {
        QTest::addColumn<int>("layer");
        QTest::addColumn<std::vector<int>>("selected");
        QTest::addColumn<int>("next");
        QTest::newRow("one below") << 2 << std::vector{3, 4} << 1;
        QTest::newRow("one above") << 1 << std::vector{2} << 2;
        QTest::newRow("one around") << 3 << std::vector{4} << 2;
        QTest::newRow("it goes with the one around") << 3 << std::vector{3, 4} << 1;
        QTest::newRow("all") << 3 << std::vector{2, 3, 4} << 0;
    }
    void aLayerThatIsDeletedIsLeft()
    {
        QFETCH(const int, layer);
        QFETCH(const std::vector<int>, selected);
        QFETCH(const int, next);
        Stage s;
        s.layer.choose(GroupId(layer));
        s.editor.push(setGroupIsolated(s.editor.document(), {1, 2, 3}, true), "isolate");
        const PaintingPtr before = s.editor.document().painting();
        s.editor.document().setSelection({{selected.begin(), selected.end()}, {}});
        QVERIFY(!commands::deleteSelected(s.editor).isEmpty());
        QVERIFY(!s.painting().findGroup(GroupId(layer)));
        QCOMPARE(s.layer.group(), GroupId(next));
        QVERIFY(!s.layer.isComing());
        const PaintingPtr after = s.editor.document().painting();
        s.editor.undo();
        QVERIFY(s.painting() == *before);
        QCOMPARE(s.layer.group(), GroupId(layer));
        s.editor.redo();
        QVERIFY(s.painting() == *after);
        QCOMPARE(s.layer.group(), GroupId(next));
    }

    /// It is in none of the ways deleted that leave it: what is painted next makes it again, as it was, where it was.
    void aLayerThatIsEmptiedComesAgain_data()
    {
        QTest::addColumn<int>("layer");
        QTest::addColumn<bool>("moves");
        QTest::addColumn<bool>("inGesture");
        for (const bool inGesture : {false, true}) {
            QTest::addRow("1, %d", inGesture) << 1 << false << inGesture;
            for (const bool moves : {false, true}) // A whole group in no other one is moved as it is.
                QTest::addRow("3, %d, %d", moves, inGesture) << 3 << moves << inGesture;
        }
    }
    void aLayerThatIsEmptiedComesAgain()
    {
        QFETCH(const int, layer);
        QFETCH(const bool, moves);
        QFETCH(const bool, inGesture);
        Stage s;
        const auto group = GroupId(layer);
        const StrokeId only = group == 1 ? 2 : 4;
        s.layer.choose(group);
        s.editor.push(setGroupOpacity(s.editor.document(), {group}, 0.5f), "opacity");
        const Group was = *s.painting().findGroup(group);
        const Order order = s.order();
        const auto empty = [&]() -> Edit {
            s.editor.document().setSelection({{only}, {}});
            return moves ? reorder(s.editor.document(), {only}, 0) : deleteSelection(s.editor.document());
        };
        if (inGesture) {
            Gesture given = s.editor.begin("empty");
            given.show(empty());
            QVERIFY(s.layer.isComing());
            given.giveUp();
            QVERIFY(!s.layer.isComing() && s.painting().findGroup(group));
            Gesture gesture = s.editor.begin("empty");
            gesture.show(empty());
            gesture.commit();
        } else {
            s.editor.push(empty(), "empty");
        }
        QVERIFY(!s.painting().findGroup(group));
        QCOMPARE(problemOf(s.painting()), QString());
        QCOMPARE(s.layer.group(), group);
        QVERIFY(s.layer.isComing());
        const StrokeId painted = s.paint();
        QVERIFY(*s.painting().findGroup(group) == was);
        QCOMPARE(s.painting().find(painted)->group, group);
        Order wanted = order;
        std::ranges::replace(wanted, only, painted);
        if (moves)
            wanted.push_back(only);
        QCOMPARE(s.order(), wanted);
        s.editor.undo();
        QVERIFY(s.layer.isComing());
        s.editor.undo();
        QCOMPARE(s.order(), order);
        QVERIFY(*s.painting().findGroup(group) == was);
        QVERIFY(s.layer.group() == group && !s.layer.isComing());
        s.editor.redo();
        QVERIFY(s.layer.group() == group && s.layer.isComing());
        s.editor.redo();
        QCOMPARE(s.order(), wanted);
        QVERIFY(s.layer.group() == group && !s.layer.isComing());
    }

    void aNewLayerBesideAnEmptiedOneIsAnother()
    {
        Stage s;
        s.layer.choose(1);
        s.editor.document().setSelection({{2}, {}});
        s.editor.push(deleteSelection(s.editor.document()), "empty");
        s.table[Command::NewLayer].trigger();
        QVERIFY(s.layer.group() != 1);
        const StrokeId painted = s.paint();
        QCOMPARE(s.order(), (Order{1, painted, 3, 4, 5}));
        QCOMPARE(s.painting().findGroup(s.layer.group())->name, QString("Layer 1"));
        s.editor.undo();
        s.editor.undo();
        QVERIFY(s.painting().findGroup(1));
    }

    /// As files have them that an earlier version wrote.
    void aGroupWithoutStrokesIsDeleted()
    {
        Stage s;
        auto painting = std::make_shared<Painting>(s.painting());
        painting->groups.push_back({9, "ghost", 0});
        painting->groups.back().mask = true;
        painting->groups.push_back({10, "in it", 9});
        s.editor.document().reset(painting);
        QVERIFY(!commands::canDelete(s.editor));
        s.layer.choose(10);
        QVERIFY(commands::canDelete(s.editor));
        s.layer.choose(9);
        commands::deleteSelected(s.editor);
        QCOMPARE(s.painting().groups.size(), std::size_t(3));
        QVERIFY(s.layer.group() != 9 && !s.layer.isComing());
        s.editor.undo();
        QCOMPARE(s.layer.group(), GroupId(9));
        QVERIFY(s.painting() == *painting);
    }

    void undoAndRedoKeepTheLayer()
    {
        Stage s;
        s.table[Command::NewLayer].trigger();
        const GroupId first = s.layer.group();
        s.paint();
        s.table[Command::NewLayer].trigger();
        const GroupId second = s.layer.group();
        s.paint();
        s.table[Command::DuplicateLayer].trigger();
        const GroupId copy = s.layer.group();
        s.table[Command::MergeLayerDown].trigger();
        QCOMPARE(s.layer.group(), second);
        s.editor.undo();
        QCOMPARE(s.layer.group(), copy);
        s.editor.undo();
        QCOMPARE(s.layer.group(), second);
        QVERIFY(!s.layer.isComing());
        s.editor.undo();
        s.editor.undo();
        QCOMPARE(s.editor.undoStack().index(), 0);
        for (const GroupId now : {first, second, copy, second}) {
            s.editor.redo();
            QVERIFY(s.layer.group() == now || (now == first && s.layer.group() == second));
        }
        s.editor.undoStack().setIndex(0);
        s.editor.undoStack().setIndex(4);
        QCOMPARE(s.layer.group(), second);
        QVERIFY(!s.layer.isComing());
    }

    /// What was chosen since is no step.
    void undoLeavesALayerThatWasChosen()
    {
        Stage s;
        s.layer.choose(2);
        s.table[Command::MergeLayerDown].trigger();
        s.layer.choose(3);
        s.editor.undo();
        QCOMPARE(s.layer.group(), GroupId(3));
        s.layer.choose(0);
        s.editor.redo();
        QCOMPARE(s.layer.group(), GroupId(0));
        s.layer.choose(1);
        s.editor.push(ungroup(s.editor.document(), 1), "ungroup");
        QCOMPARE(s.layer.group(), GroupId(0));
        s.editor.undo();
        QCOMPARE(s.layer.group(), GroupId(1));
    }

    /// The layer of an edit comes back with what was selected then, and with nothing else.
    void undoThatSelectsGivesBackTheLayer()
    {
        Stage s;
        const auto rename = [&](const QString &name) {
            s.editor.push(renameGroup(s.editor.document(), 1, name), "rename");
        };
        s.layer.choose(1);
        s.editor.document().setSelection({{2}, {}});
        rename("one");
        s.layer.choose(2);
        s.editor.undo(); // The selection is the same one.
        QCOMPARE(s.layer.group(), GroupId(2));
        s.editor.document().setSelection({{3, 4}, {}});
        s.editor.redo();
        QCOMPARE(s.editor.selection().strokes, std::set<StrokeId>{2});
        QCOMPARE(s.layer.group(), GroupId(1));
        s.editor.document().setSelection({});
        rename("two");
        s.layer.choose(2);
        s.editor.document().setSelection({{3, 4}, {}});
        s.editor.undo(); // Nothing is selected.
        QCOMPARE(s.layer.group(), GroupId(2));
        s.editor.document().setSelection({{2}, {}});
        rename("three"); // The stroke of another layer was selected at the canvas.
        s.editor.document().setSelection({});
        s.layer.choose(3);
        s.editor.undo();
        QCOMPARE(s.editor.selection().strokes, std::set<StrokeId>{2});
        QCOMPARE(s.layer.group(), GroupId(2));
    }

    /// While a stroke is being drawn, it is where it will be, in the layer's group.
    void theDraftIsInItsLayer_data()
    {
        QTest::addColumn<int>("group");
        QTest::addColumn<bool>("isNew");
        QTest::addColumn<int>("moment");
        for (const int moment : {0, 1500, 3500})
            for (const int group : {0, 1, 2, 3})
                for (const bool isNew : {false, true})
                    QTest::addRow("%d, %d, %d", group, isNew, moment) << group << isNew << moment;
    }
    void theDraftIsInItsLayer()
    {
        QFETCH(const int, group);
        QFETCH(const bool, isNew);
        QFETCH(const int, moment);
        Stage s;
        if (moment > 0)
            s.editor.clock().lookAt(moment);
        s.layer.choose(GroupId(group));
        if (isNew)
            s.layer.beginNew();
        Stroke drawn = *lineStroke(s.editor.document().takeStrokeId());
        drawn.segments[0].born = moment > 0 ? moment : 1'000'000;
        const auto stroke = std::make_shared<const Stroke>(drawn);
        s.editor.document().setDraft(stroke);
        const PaintingPtr shown = s.editor.shown();
        QCOMPARE(problemOf(*shown), QString());
        s.editor.document().setDraft(nullptr);
        s.editor.push(s.layer.take(addStrokes(s.editor.document(), {stroke}, false)), "paint");
        QVERIFY(*shown == s.painting());
    }

    /// Hidden or locked, by itself or by a group around it.
    void aClosedLayerTakesNoPaint_data()
    {
        QTest::addColumn<int>("closed");
        QTest::addColumn<bool>("isLocked");
        for (const int closed : {2, 3})
            for (const bool isLocked : {false, true})
                QTest::addRow("%d, %d", closed, isLocked) << closed << isLocked;
    }
    void aClosedLayerTakesNoPaint()
    {
        QFETCH(const int, closed);
        QFETCH(const bool, isLocked);
        Stage s;
        s.layer.choose(3);
        QVERIFY(s.layer.takesPaint());
        const auto group = GroupId(closed);
        s.editor.push(isLocked ? setGroupLocked(s.editor.document(), group, true)
                               : setGroupVisible(s.editor.document(), group, false),
                      "close");
        QSignalSpy noted(&s.layer, &CurrentLayer::noted);
        const PaintingPtr before = s.editor.document().painting();
        s.paint();
        QCOMPARE(s.editor.document().painting(), before);
        QCOMPARE(int(noted.count()), 1);
        QVERIFY(noted.front().front().toString().contains(QStringLiteral("group %1").arg(closed)));
        s.layer.beginNew();
        QCOMPARE(s.layer.takesPaint(), closed == 3);
        QCOMPARE(s.layer.group() != 3, true);
    }
};

QTEST_MAIN(TestCurrentLayer)
#include "test_current_layer.moc"
