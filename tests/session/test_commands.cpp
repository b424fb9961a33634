// The table of commands without a window: rows, switches, and whose a user's keys are.
#include "app/session/commands/keys.h"
#include "app/session/commands/selection_commands.h"
#include "app/session/commands/session_rows.h"
#include "app/session/settings/settings.h"
#include "model/area/outline.h"
#include "model/shaping/shapes.h"
#include "undo/edits.h"
#include "undo/fill_edits.h"
#include "undo/layers/group_edits.h"
#include "undo/time_edits.h"

#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace suffuse;

namespace {

/// A short straight stroke.
StrokePtr stroke(Document &document)
{
    auto made = std::make_shared<Stroke>();
    made->id = document.takeStrokeId();
    Segment segment;
    segment.bezier = {Offset{0, 0}, {10, 0}, {20, 0}, {30, 0}};
    made->segments = {segment};
    return made;
}

void addStroke(Editor &editor)
{
    editor.push(addStrokes(editor.document(), {stroke(editor.document())}, true), "stroke");
}

} // namespace

class TestCommands : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        QStandardPaths::setTestModeEnabled(true); // whose brushes there are
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    /// A stroke that is topmost or lowest already stays there, and no step is made of it.
    void arrangingSaysWhereNothingChanges()
    {
        OpenPainting open;
        open.editor.newPainting(Editor::usualCanvas());
        Commands table;
        addSessionRows(table, open);
        addStroke(open.editor);
        addStroke(open.editor); // which is selected
        const int steps = open.editor.undoStack().count();
        QSignalSpy said(&table, &Commands::said);
        using enum Command;
        // What happens is said, too: the keys are single ones, and painting tools do not show what is selected.
        const QString lowered("Lower to bottom: 1 stroke(s); Undo takes it back."), nothing("Nothing changes.");
        for (const auto &[command, text] :
             {std::pair(Top, nothing), {Raise, nothing}, {Bottom, lowered}, {Bottom, nothing}, {Lower, nothing}}) {
            said.clear();
            table[command].trigger();
            QCOMPARE(int(said.count()), 1);
            QCOMPARE(said.back().front().toString(), text);
        }
        QCOMPARE(open.editor.undoStack().count(), steps + 1);
        table[FlipAcross].trigger();
        QCOMPARE(said.back().front().toString(), QString("Flip horizontally: 1 stroke(s); Undo takes it back."));
    }

    void commandsRunWithoutAWindow()
    {
        OpenPainting open;
        open.editor.newPainting(Editor::usualCanvas());
        Commands table;
        addSessionRows(table, open);
        table.update();
        QVERIFY(!table[Command::Duplicate].isEnabled() && !table[Command::Play].isEnabled());
        addStroke(open.editor);
        QVERIFY(table[Command::Duplicate].isEnabled() && table[Command::Play].isEnabled());
        table[Command::Duplicate].trigger();
        QCOMPARE(open.editor.document().painting()->strokes.size(), std::size_t(2));
        table[Command::GroupStrokes].trigger();
        QCOMPARE(open.editor.document().painting()->groups.size(), std::size_t(1));
        table[Command::Deselect].trigger();
        QVERIFY(!table[Command::Duplicate].isEnabled());
        for (const QAction *action : table.all())
            QVERIFY(!action->objectName().isEmpty() && !action->text().isEmpty());
    }

    void areasAreCombinedOrItIsSaidWhyNot()
    {
        OpenPainting open;
        Editor &editor = open.editor;
        editor.newPainting(Editor::usualCanvas());
        Commands table;
        addSessionRows(table, open);
        const auto addSquare = [&](double x, double y) {
            const StrokeId id = editor.document().takeStrokeId();
            Stroke square = strokeAlong(outlineOf({}, {x, y}, {x + 10, y + 10}), Brush(), id, 0);
            square.fill = usualFill(square);
            editor.push(addStrokes(editor.document(), {std::make_shared<const Stroke>(square)}, true), "square");
            return id;
        };
        const StrokeId first = addSquare(0, 0);
        table.update();
        QVERIFY(!table[Command::UniteAreas].isEnabled() && table[Command::OutsetAreas].isEnabled());
        const StrokeId second = addSquare(20, 0);
        editor.document().setSelection({{first, second}, {}});
        table.update();
        QSignalSpy said(&table, &Commands::said);
        table[Command::IntersectAreas].trigger();
        QCOMPARE(said.size(), 1);
        QCOMPARE(editor.document().painting()->strokes.size(), std::size_t(2));
        const int steps = editor.undoStack().count();
        const PaintingPtr before = editor.document().painting();
        table[Command::UniteAreas].trigger();
        QCOMPARE(said.size(), 1);
        QCOMPARE(editor.undoStack().count(), steps + 1);
        QCOMPARE(editor.undoText(), QString("Union"));
        QCOMPARE(editor.document().painting()->strokes.size(), std::size_t(1));
        QCOMPARE(editor.document().selection().strokes, std::set<StrokeId>{first});
        table.update();
        table[Command::LinesToAreas].trigger(); // The squares have lines, too.
        QCOMPARE(editor.document().painting()->strokes.size(), std::size_t(2));
        editor.undoStack().undo();
        editor.undoStack().undo();
        QVERIFY(*editor.document().painting() == *before);
    }

    void aligningOneGroupSaysWhyNot()
    {
        OpenPainting open;
        Editor &editor = open.editor;
        editor.newPainting(Editor::usualCanvas());
        Commands table;
        addSessionRows(table, open);
        std::set<StrokeId> all;
        for (const double x : {0, 30, 70}) {
            const StrokeId id = editor.document().takeStrokeId();
            Stroke square = strokeAlong(outlineOf({}, {x, x}, {x + 10, x + 10}), Brush(), id, 0);
            editor.push(addStrokes(editor.document(), {std::make_shared<const Stroke>(square)}, true), "square");
            all.insert(id);
        }
        editor.document().setSelection({all, {}});
        table[Command::GroupStrokes].trigger();
        table.update();
        QSignalSpy said(&table, &Commands::said);
        const int steps = editor.undoStack().count();
        table[Command::AlignLeft].trigger();
        QCOMPARE(said.size(), 1);
        QVERIFY(said.back()[0].toString().contains("relative to the canvas"));
        table[Command::DistributeGapsAcross].trigger();
        QCOMPARE(said.size(), 2);
        QVERIFY(said.back()[0].toString().contains("three strokes or groups"));
        QCOMPARE(editor.undoStack().count(), steps);
        table[Command::AlignToCanvas].setChecked(true);
        table[Command::AlignRight].trigger(); // one is enough for that
        QCOMPARE(editor.undoStack().count(), steps + 1);
        table[Command::UngroupStrokes].trigger();
        table[Command::AlignToSelection].setChecked(true);
        table[Command::AlignLeft].trigger();
        QCOMPARE(editor.undoStack().count(), steps + 3);
        QCOMPARE(said.size(), 2);
        // A group that blends does not go silently.
        table[Command::GroupStrokes].trigger();
        editor.push(setGroupOpacity(editor.document(), selectedGroups(editor.document()), 0.5f), "opacity");
        table[Command::UngroupStrokes].trigger();
        QCOMPARE(said.size(), 3);
        QVERIFY(said.back()[0].toString().contains("opacity"));
    }

    /// The values of a fill are a part of what a stroke looks like.
    void appearancesTakeFillsAlong()
    {
        OpenPainting open;
        Editor &editor = open.editor;
        editor.newPainting(Editor::usualCanvas());
        Commands table;
        addSessionRows(table, open);
        const auto addSquare = [&](float diffusion, const Colour &colour) {
            const StrokeId id = editor.document().takeStrokeId();
            Stroke square = strokeAlong(outlineOf({}, {0, 0}, {10, 10}), Brush(), id, 0);
            Fill fill = usualFill(square);
            fill.diffusion = diffusion;
            fill.colour = colour;
            square.fill = fill;
            for (Segment &segment : square.segments)
                segment.density = 0;
            editor.push(addStrokes(editor.document(), {std::make_shared<const Stroke>(square)}, true), "square");
            return id;
        };
        const StrokeId other = addSquare(3, {0, 0, 1, 1});
        addSquare(40, {1, 0.5f, 0, 0.75f});
        table.update();
        table[Command::CopyAppearance].trigger();
        editor.document().setSelection({{other}, {}});
        table.update();
        table[Command::PasteAppearance].trigger();
        const StrokePtr square = editor.document().painting()->find(other);
        QCOMPARE(square->fill->diffusion, 40.0f);
        QCOMPARE(square->fill->colour, (Colour{1, 0.5f, 0, 0.75f}));
        QVERIFY(isFillAlone(*square));
    }

    void nothingIsSelectedWhereNothingIs()
    {
        OpenPainting open;
        open.editor.newPainting(Editor::usualCanvas());
        Commands table;
        addSessionRows(table, open);
        for (const bool painted : {false, true}) {
            if (painted)
                addStroke(open.editor);
            table.update();
            QCOMPARE(table[Command::InvertSelection].isEnabled(), painted);
        }
    }

    /// All is unlocked or shown where strokes or groups are locked or hidden, in one step.
    void allIsUnlockedOrShownWhereSomethingIsClosed()
    {
        OpenPainting open;
        Editor &editor = open.editor;
        editor.newPainting(Editor::usualCanvas());
        Commands table;
        addSessionRows(table, open);
        const auto usable = [&] {
            table.update();
            return std::pair(table[Command::UnlockAll].isEnabled(), table[Command::ShowAll].isEnabled());
        };
        QCOMPARE(usable(), std::pair(false, false));
        addStroke(editor);
        addStroke(editor);
        QCOMPARE(usable(), std::pair(false, false));
        const auto selectAll = [&] { commands::selectAll(editor); };
        selectAll();
        commands::lockSelected(editor);
        QCOMPARE(usable(), std::pair(true, false));
        table[Command::UnlockAll].trigger();
        QCOMPARE(usable(), std::pair(false, false));
        selectAll();
        commands::groupSelected(editor);
        commands::hideSelected(editor);
        QCOMPARE(usable(), std::pair(false, true));
        const PaintingPtr hidden = editor.document().painting();
        table[Command::ShowAll].trigger();
        QCOMPARE(usable(), std::pair(false, false));
        editor.undo();
        QVERIFY(*editor.document().painting() == *hidden);
        QCOMPARE(usable(), std::pair(false, true));
    }

    /// Groups dissolve, and paint dries once and for all, where there is a group, and paint that is wetted again.
    void whatHasNothingToDoIsDisabled()
    {
        OpenPainting open;
        Editor &editor = open.editor;
        editor.newPainting(Editor::usualCanvas());
        Commands table;
        addSessionRows(table, open);
        addStroke(editor);
        addStroke(editor);
        const Painting &painting = *editor.document().painting();
        const StrokeId grouped = painting.strokes[0]->id, single = painting.strokes[1]->id;
        const auto select = [&](const std::set<StrokeId> &strokes, const std::set<SegmentRef> &segments = {}) {
            editor.document().setSelection({strokes, segments});
            table.update();
        };
        select({grouped});
        QVERIFY(!table[Command::UngroupStrokes].isEnabled() && !table[Command::RemoveRewetting].isEnabled());
        table[Command::GroupStrokes].trigger();
        QVERIFY(table[Command::UngroupStrokes].isEnabled());
        const GroupId group = editor.document().painting()->groups[0].id;
        editor.push(setGroupLocked(editor.document(), group, true), "lock");
        select({grouped});
        QVERIFY(!table[Command::UngroupStrokes].isEnabled());
        editor.undoStack().undo();
        select({single});
        QVERIFY(!table[Command::UngroupStrokes].isEnabled());
        editor.push(rewet(editor.document(), 60'000'000, 1'000'000), "rewet");
        select({single});
        QVERIFY(table[Command::RemoveRewetting].isEnabled());
        select({single}, {{single, 0}});
        QVERIFY(table[Command::RemoveRewetting].isEnabled());
        select({grouped});
        QVERIFY(!table[Command::RemoveRewetting].isEnabled());
        select({grouped, single});
        QVERIFY(table[Command::RemoveRewetting].isEnabled());
        table[Command::RemoveRewetting].trigger();
        QVERIFY(!table[Command::RemoveRewetting].isEnabled());
        select({grouped});
        table[Command::UngroupStrokes].trigger();
        QVERIFY(!table[Command::UngroupStrokes].isEnabled());
        QVERIFY(editor.document().painting()->groups.empty());
    }

    /// The switches of groups say what all of the selected ones are, and what was lost with an ungrouped one is said.
    void groupsHaveRoles()
    {
        OpenPainting open;
        Editor &editor = open.editor;
        editor.newPainting(Editor::usualCanvas());
        Commands table;
        addSessionRows(table, open);
        addStroke(editor);
        addStroke(editor);
        const StrokeId low = editor.document().painting()->strokes[0]->id;
        const StrokeId high = editor.document().painting()->strokes[1]->id;
        const auto select = [&](const std::set<StrokeId> &strokes) {
            editor.document().setSelection({strokes, {}});
            table.update();
        };
        const auto groupOf = [&](StrokeId id) {
            const Painting &painting = *editor.document().painting();
            return *painting.findGroup(painting.find(id)->group);
        };
        using enum Command;
        select({high});
        for (const Command command : {ClipGroups, MaskGroups, WashGroups})
            QVERIFY(!table[command].isEnabled()); // A stroke is no group.
        table[GroupStrokes].trigger();
        select({low});
        table[GroupStrokes].trigger();
        QVERIFY(!table[ClipGroups].isEnabled() && table[MaskGroups].isEnabled() && table[WashGroups].isEnabled());
        select({high});
        for (const Command command : {ClipGroups, MaskGroups, WashGroups})
            QVERIFY(table[command].isEnabled() && !table[command].isChecked());
        table[ClipGroups].trigger();
        QVERIFY(groupOf(high).clips && !groupOf(low).clips);
        table[WashGroups].trigger();
        QVERIFY(groupOf(high).wash && !groupOf(low).wash);
        QVERIFY(table[ClipGroups].isChecked() && !table[MaskGroups].isChecked() && table[WashGroups].isChecked());
        select({low, high});
        QVERIFY(!table[WashGroups].isChecked());
        table[WashGroups].trigger();
        QVERIFY(groupOf(low).wash && groupOf(high).wash);
        QVERIFY(table[WashGroups].isChecked());
        table[WashGroups].trigger();
        QVERIFY(!groupOf(low).wash && !groupOf(high).wash);
        table[MaskGroups].trigger();
        QVERIFY(groupOf(low).mask && groupOf(high).mask);
        editor.undo();
        table.update();
        QVERIFY(!groupOf(low).mask && !table[MaskGroups].isChecked());
        // Ungrouping tells where something is lost.
        const QSignalSpy said(&table, &Commands::said);
        select({low});
        table[UngroupStrokes].trigger();
        QCOMPARE(said.count(), 0);
        editor.undo();
        select({low});
        table[WashGroups].trigger();
        table[UngroupStrokes].trigger();
        QCOMPARE(said.count(), 1);
        QVERIFY(said[0][0].toString().contains("wash"));
    }

    /// What has nothing to do says so.
    void commandsSaySomething()
    {
        OpenPainting open;
        open.editor.newPainting(Editor::usualCanvas());
        Commands table;
        addSessionRows(table, open);
        addStroke(open.editor);
        open.editor.clock().setManual(true);
        open.editor.clock().setTime(open.editor.document().painting()->end() + 1'000'000);
        const QSignalSpy said(&table, &Commands::said);
        table[Command::FreezeNow].trigger();
        QCOMPARE(said.size(), 1);
        QCOMPARE(open.editor.undoStack().count(), 1);
    }

    /// A key is stored under the row's id: wherever the row stands, and whichever number its command has.
    void swappedRowsKeepTheirKeys()
    {
        settings::store().setValue("shortcuts/raise", "Ctrl+Alt+U");
        for (const bool swapped : {false, true}) {
            Commands table;
            const Command raise = swapped ? Command::Lower : Command::Raise;
            const Command lower = swapped ? Command::Raise : Command::Lower;
            if (swapped)
                table.add(lower, "lower", "Lower", "", {QKeySequence(Qt::Key_PageDown)});
            table.add(raise, "raise", "Raise", "", {QKeySequence(Qt::Key_PageUp)});
            if (!swapped)
                table.add(lower, "lower", "Lower", "", {QKeySequence(Qt::Key_PageDown)});
            applyStoredShortcuts(table.all());
            QCOMPARE(table[raise].shortcut(), QKeySequence("Ctrl+Alt+U"));
            QCOMPARE(table[lower].shortcut(), QKeySequence(Qt::Key_PageDown));
            QCOMPARE(ownShortcutsOf(table[raise]), QList<QKeySequence>{QKeySequence(Qt::Key_PageUp)});
        }
        settings::store().remove("shortcuts/raise");
    }

    void scopesSayWhereKeysWork()
    {
        Commands table;
        table.add(Command::Delete, "delete", "Delete", "", {}).in(CommandScope::Strokes);
        table.add(Command::Play, "play", "Play", "", {}).in(CommandScope::Timeline);
        table.add(Command::Copy, "copy", "Copy", "", {});
        QCOMPARE(table.of(CommandScope::Strokes), QList<QAction *>{&table[Command::Delete]});
        QCOMPARE(scopeOf(table[Command::Play]), CommandScope::Timeline);
        QCOMPARE(scopeOf(table[Command::Copy]), CommandScope::Window);
        QCOMPARE(scopeOf(QAction()), CommandScope::Window);
        const auto where = [](CommandScope scope, const char *keys) {
            return whereKeysWork(scope, QKeySequence::listFromString(keys));
        };
        QCOMPARE(where(CommandScope::Window, ""), QString());
        QCOMPARE(where(CommandScope::Window, "Ctrl+E"), QString("Everywhere"));
        QCOMPARE(where(CommandScope::Window, "F6"), QString("Everywhere"));
        QCOMPARE(where(CommandScope::Window, "E"), QString("Canvas"));
        QCOMPARE(where(CommandScope::Window, "F2"), QString("Canvas"));
        QCOMPARE(where(CommandScope::Strokes, "Del"), QString("Canvas, Strokes dock"));
        QCOMPARE(where(CommandScope::Timeline, "Shift+D"), QString("Canvas, Timeline dock"));
        QCOMPARE(where(CommandScope::Canvas, "Space"), QString("Canvas, while held"));
    }

    void heldKeysAreTold()
    {
        Commands table;
        QList<QKeySequence> told;
        table.add(Command::HoldToPan, "holdToPan", "Hold", "", {QKeySequence(Qt::Key_Space)})
            .held([&told](const QList<QKeySequence> &keys) { told = keys; });
        QCOMPARE(told, QList<QKeySequence>{QKeySequence(Qt::Key_Space)});
        table[Command::HoldToPan].setShortcut(QKeySequence(Qt::Key_W));
        QCOMPARE(told, QList<QKeySequence>{QKeySequence(Qt::Key_W)});
        QVERIFY(table.runnable().isEmpty());
    }

    /// A switch that is on from the start was switched by nobody.
    void switchesBeginQuietly()
    {
        Commands table;
        int told = 0;
        table.add(Command::ShowGrid, "showGrid", "Grid", "", {}).checkable(true).toggles([&told](bool) { ++told; });
        QVERIFY(table[Command::ShowGrid].isChecked());
        QCOMPARE(told, 0);
        table[Command::ShowGrid].trigger();
        QCOMPARE(told, 1);
    }

    /// A command that cannot be used says why, in its tool tip and where menus say it, until it can.
    void greyCommandsSayWhy()
    {
        OpenPainting open;
        Commands table;
        addSessionRows(table, open);
        table.update();
        int grey = 0;
        for (const QAction *action : table.all()) {
            if (action->isEnabled()) {
                QVERIFY2(action->statusTip().isEmpty(), qPrintable(action->objectName()));
                continue;
            }
            ++grey;
            QVERIFY2(!action->statusTip().isEmpty(), qPrintable(action->objectName()));
            QVERIFY2(action->toolTip().endsWith('\n' + action->statusTip()), qPrintable(action->objectName()));
        }
        QVERIFY2(grey > 40, qPrintable(QString::number(grey)));
        QAction &group = table[Command::GroupStrokes], &left = table[Command::AlignLeft];
        QVERIFY(group.toolTip().contains("Nothing is selected"));
        QVERIFY(left.toolTip().contains("two strokes"));
        addStroke(open.editor);
        open.editor.document().setSelection({{open.editor.document().painting()->strokes.back()->id}, {}});
        table.update();
        QVERIFY(group.isEnabled() && group.statusTip().isEmpty() && !group.toolTip().contains('\n'));
        QVERIFY(!left.isEnabled() && left.toolTip().contains("two strokes"));
    }

    /// Whoever hears of a file's painting finds its path and hash with it.
    void aFileIsKnownAtOnce()
    {
        const QString path = m_folder.filePath("known.suffuse");
        OpenPainting first;
        first.editor.newPainting(Editor::usualCanvas());
        addStroke(first.editor);
        QSignalSpy saved(&first.editor, &Editor::saved);
        first.editor.startSaving(path);
        QVERIFY(saved.wait());

        OpenPainting second;
        int heard = 0;
        const auto look = [&] {
            ++heard;
            QCOMPARE(second.editor.filePath(), path);
            QCOMPARE(second.editor.fileHash(), first.editor.fileHash());
            QCOMPARE(second.editor.document().painting()->strokes.size(), std::size_t(1));
            QVERIFY(!second.editor.isModified());
        };
        connect(&second.editor.document(), &Document::changed, this, look);
        connect(&second.editor, &Editor::opened, this, look);
        QVERIFY(second.editor.open(path));
        QCOMPARE(heard, 2);
        QVERIFY(!second.editor.open(m_folder.filePath("none.suffuse"))); // and nothing is shown of it
        QCOMPARE(heard, 2);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestCommands)
#include "test_commands.moc"
