// Commands on layers, and what comes into them: they are copied, moved, merged, shown alone and pasted into.
#include "app/session/commands/selection_commands.h"
#include "app/session/current_layer.h"
#include "app/session/files/import_strokes.h"
#include "model/painting/validate.h"
#include "tests/session/layer_stage.h"
#include "undo/edits.h"
#include "undo/layers/group_alone.h"
#include "undo/layers/group_edits.h"

#include <QSignalSpy>
#include <QTest>

using namespace suffuse;

class TestLayerCommands : public QObject {
    Q_OBJECT

private slots:
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

QTEST_MAIN(TestLayerCommands)
#include "test_layer_commands.moc"
