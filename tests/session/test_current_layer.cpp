// The layer that is painted on: what becomes of it when groups go and come back, and the commands that work on it.
#include "app/session/commands/selection_commands.h"
#include "app/session/commands/session_rows.h"
#include "app/session/current_layer.h"
#include "app/session/files/import_strokes.h"
#include "model/painting/validate.h"
#include "undo/edits.h"
#include "undo/layers/group_alone.h"
#include "undo/layers/group_edits.h"

#include <QSignalSpy>
#include <QTest>

using namespace suffuse;

namespace {

StrokePtr lineStroke(StrokeId id, GroupId group = 0)
{
    Stroke stroke;
    stroke.id = id;
    stroke.group = group;
    Segment segment;
    segment.bezier = {Offset{0, 0}, {10, 0}, {20, 0}, {30, 0}};
    segment.born = Microseconds(1000 * id);
    stroke.segments = {segment};
    return std::make_shared<const Stroke>(std::move(stroke));
}

/// From bottom to top: 1, group 1 {2}, group 2 {3, group 3 {4}}, 5.
struct Stage {
    OpenPainting open;
    Commands table;
    Editor &editor = open.editor;
    CurrentLayer &layer = open.editor.layer();

    Stage()
    {
        auto painting = std::make_shared<Painting>();
        const GroupId groups[] = {0, 1, 2, 3, 0};
        for (int i = 1; i <= 5; ++i)
            painting->strokes.push_back(lineStroke(StrokeId(i), groups[i - 1]));
        for (const auto &[id, parent] : {std::pair(1, 0), {2, 0}, {3, 2}}) {
            Group group;
            group.id = GroupId(id);
            group.parent = GroupId(parent);
            group.name = QStringLiteral("group %1").arg(id);
            painting->groups.push_back(std::move(group));
        }
        addSessionRows(table, open);
        editor.document().reset(painting);
        editor.undoStack().clear();
        table.update();
    }
    const Painting &painting() { return *editor.document().painting(); }
    StrokeId paint()
    {
        const StrokePtr stroke = lineStroke(editor.document().takeStrokeId());
        editor.push(layer.take(addStrokes(editor.document(), {stroke}, false)), "paint");
        return stroke->id;
    }
    std::vector<StrokeId> order() { return orderOf(painting()); }
};

using Order = std::vector<StrokeId>;

} // namespace

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

    void aCopyIsSelectedInPlaceOfItsOriginal()
    {
        Stage s;
        s.layer.choose(2);
        s.editor.document().setSelection({{1, 3, 4}, {{4, 0}}});
        s.table[Command::DuplicateLayer].trigger();
        QCOMPARE(s.layer.title(), QString("group 2 copy"));
        std::set<StrokeId> wanted{1};
        for (const StrokePtr &stroke : s.painting().strokes)
            if (stroke->id > 5)
                wanted.insert(stroke->id);
        QCOMPARE(s.editor.selection().strokes, wanted);
        QCOMPARE(s.editor.selection().segments.size(), std::size_t(1));
        QVERIFY(s.editor.selection().segments.begin()->stroke > 5);
        s.layer.choose(2);
        s.table[Command::DuplicateLayer].trigger();
        QCOMPARE(s.layer.title(), QString("group 2 copy 2"));
        s.editor.undo();
        s.editor.undo();
        QCOMPARE(s.editor.selection().strokes, (std::set<StrokeId>{1, 3, 4}));
        QCOMPARE(s.layer.group(), GroupId(2));
    }

    void aNewLayerLeavesTheSelectionOfTheOldOne()
    {
        Stage s;
        s.layer.choose(2);
        s.editor.document().setSelection({{1, 4}, {{4, 0}}});
        s.table[Command::NewLayer].trigger();
        QVERIFY((s.editor.selection() == Selection{{1}, {}}));
    }

    void namesOfNewLayersCountOn()
    {
        Stage s;
        s.table[Command::NewLayer].trigger();
        s.paint();
        s.editor.push(renameGroup(s.editor.document(), s.layer.group(), "Sky"), "rename");
        s.table[Command::NewLayer].trigger();
        QCOMPARE(s.layer.title(), QString("Layer 2"));
        s.layer.choose(1);
        s.editor.push(renameGroup(s.editor.document(), 1, "Layer 7"), "rename");
        s.table[Command::NewLayer].trigger();
        QCOMPARE(s.layer.title(), QString("Layer 8"));
    }

    /// Strokes come into the layer, above what is selected there; groups come above it.
    void whatIsPastedComesToTheLayer()
    {
        Stage s;
        const auto paste = [&s](bool asGroup) {
            const StrokePtr stroke = lineStroke(9);
            Painting copied;
            copied.strokes = {asGroup ? lineStroke(9, 4) : stroke};
            if (asGroup)
                copied.groups = {{4, "group 2"}};
            addStrokes(s.editor, copied, Landing(), "paste");
            return s.painting().find(*s.editor.selection().strokes.begin());
        };
        s.layer.choose(2);
        StrokePtr came = paste(false);
        QCOMPARE(came->group, GroupId(2));
        QCOMPARE(s.order(), (Order{1, 2, 3, 4, came->id, 5}));
        s.editor.undo();
        s.editor.document().setSelection({{1, 3}, {}});
        came = paste(false);
        QCOMPARE(s.order(), (Order{1, 2, 3, came->id, 4, 5}));
        s.editor.undo();
        s.editor.document().setSelection({{4}, {}}); // which is in a group of the layer
        came = paste(false);
        QCOMPARE(came->group, GroupId(2));
        QCOMPARE(s.order(), (Order{1, 2, 3, 4, came->id, 5}));
        s.editor.undo();
        came = paste(true);
        QCOMPARE(s.order(), (Order{1, 2, 3, 4, came->id, 5}));
        const Group pasted = *s.painting().findGroup(came->group);
        QCOMPARE(pasted.parent, GroupId(0));
        QCOMPARE(pasted.name, QString("group 2 copy"));
        QCOMPARE(s.layer.group(), pasted.id);
        s.editor.undo();
        QCOMPARE(s.layer.group(), GroupId(2));
        s.layer.choose(0);
        came = paste(true);
        QCOMPARE(s.order(), (Order{1, 2, 3, 4, 5, came->id}));
        QCOMPARE(s.layer.group(), GroupId(0));
        QCOMPARE(problemOf(s.painting()), QString());
    }

    /// As a hidden layer of a drawing: its strokes are not seen, and so they are not selected.
    void aHiddenGroupComesInHidden()
    {
        Stage s;
        Painting copied;
        copied.strokes = {lineStroke(9, 4), lineStroke(10)};
        copied.groups = {{4, "hidden"}};
        copied.groups[0].visible = false;
        addStrokes(s.editor, copied, Landing(), "paste");
        QCOMPARE(s.editor.selection().strokes.size(), std::size_t(1));
        QVERIFY(!s.painting().groups.back().visible);
        QVERIFY(s.painting().isVisible(*s.painting().find(*s.editor.selection().strokes.begin())));
    }

    void keysGoThroughTheLayers()
    {
        Stage s;
        const auto step = [&](Command command) {
            s.table[command].trigger();
            return s.layer.group();
        };
        using enum Command;
        QCOMPARE(step(LayerAbove), GroupId(0));
        for (const GroupId group : {2, 3, 1, 1})
            QCOMPARE(step(LayerBelow), group);
        for (const GroupId group : {3, 2, 0, 0})
            QCOMPARE(step(LayerAbove), group);
        s.layer.choose(3);
        QVERIFY(s.table[NoLayer].isEnabled());
        QCOMPARE(step(NoLayer), GroupId(0));
        QVERIFY(!s.table[NoLayer].isEnabled());
    }

    void layersAreMovedCopiedAndMerged()
    {
        Stage s;
        QSignalSpy said(&s.table, &Commands::said);
        s.layer.choose(2);
        s.table[Command::LowerLayer].trigger();
        QCOMPARE(s.order(), (Order{1, 3, 4, 2, 5}));
        s.table[Command::RaiseLayer].trigger();
        QCOMPARE(s.order(), (Order{1, 2, 3, 4, 5}));
        s.table[Command::DuplicateLayer].trigger();
        QCOMPARE(s.painting().strokes.size(), std::size_t(7));
        QVERIFY(s.layer.group() != 2 && !s.layer.isComing());
        QVERIFY(said.isEmpty());
        s.editor.push(setGroupOpacity(s.editor.document(), {s.layer.group()}, 0.5f), "opacity");
        s.table[Command::MergeLayerDown].trigger();
        QCOMPARE(s.layer.group(), GroupId(2));
        QCOMPARE(int(said.count()), 1); // It is a group within the lower one.
        s.table[Command::MergeLayerDown].trigger();
        QCOMPARE(s.layer.group(), GroupId(1));
        QCOMPARE(int(said.count()), 1);
        const int steps = s.editor.undoStack().count();
        s.table[Command::MergeLayerDown].trigger();
        QCOMPARE(int(said.count()), 2); // A stroke lies below.
        QCOMPARE(s.editor.undoStack().count(), steps);
        QCOMPARE(problemOf(s.painting()), QString());
    }

    void othersAreHiddenAndShown()
    {
        Stage s;
        s.layer.choose(1);
        s.editor.document().setSelection({{2, 5}, {}});
        s.table[Command::HideOtherLayers].trigger();
        QVERIFY(s.table[Command::HideOtherLayers].isChecked());
        QCOMPARE(s.editor.selection().strokes, std::set<StrokeId>{2});
        s.layer.choose(2);
        QVERIFY(!s.table[Command::HideOtherLayers].isChecked());
        s.table[Command::HideOtherLayers].trigger();
        QVERIFY(s.painting().isVisible(*s.painting().find(4)) && !s.painting().isVisible(*s.painting().find(2)));
        s.table[Command::HideOtherLayers].trigger();
        QVERIFY(s.painting().isVisible(*s.painting().find(2)) && s.painting().isVisible(*s.painting().find(5)));
    }

    /// What a layer is clipped to is hidden with the others: a blank sheet is explained.
    void aClippedLayerAloneIsExplained()
    {
        Stage s;
        QSignalSpy said(&s.table, &Commands::said);
        s.layer.choose(2);
        s.table[Command::HideOtherLayers].trigger();
        s.table[Command::HideOtherLayers].trigger();
        QCOMPARE(int(said.count()), 0);
        Edit edit;
        edit.groups = s.painting().groups;
        for (Group &group : *edit.groups)
            group.clips = group.id == 2;
        s.editor.push(std::move(edit), "clip");
        s.table[Command::HideOtherLayers].trigger();
        QCOMPARE(int(said.count()), 1);
        QVERIFY(said.front().front().toString().contains("clipped"));
        s.table[Command::HideOtherLayers].trigger(); // All is seen again.
        QCOMPARE(int(said.count()), 1);
    }

    /// What comes is seen: into what is shown alone, or else all is shown again, in the same step.
    void whatComesIsSeen()
    {
        Stage s;
        QSignalSpy noted(&s.layer, &CurrentLayer::noted);
        const auto isAlone = [&s](GroupId group) { return s.painting().findGroup(group)->solo; };
        const auto paste = [&s] {
            const StrokePtr stroke = lineStroke(s.editor.document().takeStrokeId());
            s.editor.push(s.layer.takePasted(addStrokes(s.editor.document(), {stroke}, false)), "paste");
            return s.painting().find(stroke->id);
        };
        s.layer.choose(2);
        s.table[Command::HideOtherLayers].trigger();
        noted.clear();
        const StrokeId painted = s.paint();
        QCOMPARE(s.painting().find(painted)->group, GroupId(2));
        QCOMPARE(paste()->group, GroupId(2));
        QVERIFY(isAlone(2) && noted.isEmpty());
        for (const GroupId layer : {GroupId(1), GroupId(0)}) {
            for (const bool pasted : {false, true}) {
                s.layer.choose(layer);
                noted.clear();
                const StrokeId drawn = pasted ? 0 : s.paint();
                const StrokePtr came = pasted ? paste() : s.painting().find(drawn);
                QVERIFY(s.painting().isVisible(*came) && !isAlone(2));
                QCOMPARE(came->group, layer);
                QCOMPARE(int(noted.count()), 1);
                s.editor.undo();
                QVERIFY(isAlone(2));
            }
            const StrokePtr draft = lineStroke(s.editor.document().takeStrokeId());
            s.editor.document().setDraft(draft);
            QVERIFY(s.editor.shown()->isVisible(*s.editor.shown()->find(draft->id)));
            s.editor.document().setDraft(nullptr);
        }
    }

    /// Tools find what is in the layer, and nothing of one that is hidden, locked or still to come.
    void toolsReachTheLayerOnly()
    {
        Stage s;
        const auto reached = [&s] { return orderOf(*s.layer.reached()); };
        s.editor.clock().setTime(s.painting().end());
        s.layer.choose(2);
        QCOMPARE(reached(), (Order{1, 2, 3, 4, 5}));
        s.table[Command::ThisLayerOnly].trigger();
        QVERIFY(s.table[Command::ThisLayerOnly].isChecked());
        QCOMPARE(reached(), (Order{3, 4}));
        commands::selectAll(s.editor);
        QCOMPARE(s.editor.selection().strokes, (std::set<StrokeId>{3, 4}));
        commands::invertSelection(s.editor);
        QVERIFY(s.editor.selection().isEmpty());
        s.paint();
        QCOMPARE(s.layer.reached()->strokes.size(), std::size_t(3)); // It follows the painting.
        for (const bool hides : {true, false}) {
            Edit edit;
            edit.groups = s.painting().groups;
            (hides ? edit.groups->at(1).visible : edit.groups->at(1).locked) = !hides;
            s.editor.push(std::move(edit), "switch");
            QVERIFY(s.layer.reached()->strokes.empty());
            s.editor.undo();
        }
        s.layer.beginNew();
        QVERIFY(s.layer.reached()->strokes.empty());
        s.layer.choose(0); // Where there is no layer, there is none to keep to.
        QCOMPARE(s.layer.reached()->strokes.size(), std::size_t(6));
        QVERIFY(Stage().layer.isOnly()); // It is remembered.
        s.table[Command::ThisLayerOnly].trigger();
        QVERIFY(!Stage().layer.isOnly());
    }

    /// A group's own picture leaves out how it is put on what lies below, and keeps what is in it.
    void aGroupAloneIsItsOwnPicture()
    {
        Stage s;
        Painting painting = s.painting();
        painting.groups[1].visible = false, painting.groups[1].opacity = 0.5f, painting.groups[1].mask = true;
        painting.groups[2].opacity = 0.25f, painting.groups[2].visible = false;
        const Painting alone = groupAlone(painting, 2);
        QCOMPARE(orderOf(alone), (Order{3, 4}));
        QCOMPARE(problemOf(alone), QString());
        QVERIFY(alone.isVisible(*alone.find(3)) && !alone.isVisible(*alone.find(4)));
        QVERIFY(!alone.findGroup(2)->isIsolated());
        QCOMPARE(alone.findGroup(3)->opacity, 0.25f);
        QVERIFY(groupAlone(painting, 9).strokes.empty());
        QCOMPARE(orderOf(groupAlone(painting, 3)), Order{4});
    }
};

QTEST_MAIN(TestCurrentLayer)
#include "test_current_layer.moc"
