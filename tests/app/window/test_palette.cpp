// The table of commands, and the palette that finds what is in it.
#include "app/dialogs/shortcuts_dialog.h"
#include "app/session/settings/brush_library.h"
#include "app/session/settings/settings.h"
#include "app/window/palette_entries.h"
#include "model/formats/files.h"
#include "tests/app/session.h"

#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>

#include <algorithm>
#include <set>

using namespace suffuse;

namespace {

const Commands &tableOf(Session &s)
{
    return *s.window.findChild<Commands *>();
}

PaletteEntry entry(const char *title, const char *id = "")
{
    PaletteEntry made;
    made.title = QString::fromUtf8(title);
    made.id = QString::fromLatin1(id);
    return made;
}

/// Opens the palette by the command, types, and presses a key; says what was found first, and whether it could be run.
struct Asked {
    QString first;
    bool enabled = false;
    bool stayed = false; ///< the key did not close it; Escape did
    QString said;        ///< all that the palette says
};
Asked ask(Session &s, const QString &typed, Qt::Key key = Qt::Key_Return)
{
    Asked asked;
    QTimer::singleShot(0, &s.window, [&] {
        auto *palette = qobject_cast<CommandPalette *>(QApplication::activeModalWidget());
        if (!palette)
            return;
        QTest::keyClicks(palette->search(), typed);
        if (const QListWidgetItem *item = palette->list()->currentItem()) {
            asked.first = item->text();
            asked.enabled = item->toolTip().isEmpty();
        }
        for (const QLabel *label : palette->findChildren<QLabel *>())
            if (label->isVisible())
                asked.said += label->text();
        QTest::keyClick(palette->search(), key);
        asked.stayed = palette->isVisible();
        if (asked.stayed)
            QTest::keyClick(palette->search(), Qt::Key_Escape);
    });
    s.use(Command::FindCommand);
    return asked;
}

} // namespace

class TestPalette : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        QStandardPaths::setTestModeEnabled(true);
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    /// Users' settings hold these names. Whatever the order of the rows, a name belongs to its command for ever.
    void namesBelongToRows()
    {
        Session s;
        const std::pair<Command, const char *> names[] = {
            {Command::New, "new"},           {Command::Undo, "undo"},           {Command::Redo, "redo"},
            {Command::Raise, "raise"},       {Command::Lower, "lower"},         {Command::GroupStrokes, "group"},
            {Command::FlipDown, "flipDown"}, {Command::ShowAll, "showAll"},     {Command::Favourite7, "favourite7"},
            {Command::LetDry, "letDry"},     {Command::HoldToPan, "holdToPan"}, {Command::About, "about"}};
        for (const auto &[command, name] : names)
            QCOMPARE(s.window.action(command).objectName(), QString(name));
        std::set<QString> all;
        for (const QAction *action : tableOf(s).all())
            QVERIFY2(!action->objectName().isEmpty() && all.insert(action->objectName()).second,
                     qPrintable(action->text()));
        settings::store().setValue("shortcuts/raise", "Ctrl+Alt+U");
        applyStoredShortcuts(tableOf(s).all());
        QCOMPARE(s.window.action(Command::Raise).shortcut(), QKeySequence("Ctrl+Alt+U"));
        QCOMPARE(s.window.action(Command::Lower).shortcut(), QKeySequence(Qt::Key_PageDown));
        settings::store().remove("shortcuts/raise");
    }

    /// Of those that match equally well, what can be used comes first, so that Return does something.
    void whatCanBeUsedComesFirst()
    {
        std::vector<PaletteEntry> entries{entry("Object ▸ Align Left"), entry("Object ▸ Align Right"),
                                          entry("Object ▸ Realign"), entry("Align")};
        entries[0].enabled = entries[3].enabled = false;
        CommandPalette palette(entries, nullptr);
        const auto shown = [&] {
            QStringList titles;
            for (int row = 0; row < palette.list()->count(); ++row)
                titles << palette.list()->item(row)->text().section(QStringLiteral(" ▸ "), -1);
            return titles;
        };
        QCOMPARE(shown(), (QStringList{"Align Left", "Align Right", "Realign", "Align"})); // as they stand in the menus
        palette.search()->setText("align");
        // The whole name is still better than a part of it.
        QCOMPARE(shown(), (QStringList{"Align", "Align Right", "Align Left", "Realign"}));
    }

    /// Every id that users' settings may hold, for ever; a new command adds its own.
    void noIdIsEverChanged()
    {
        Session s;
        const QStringList known =
            QStringLiteral(
                "new open save saveAs saveCopy revert restoreBackup keepHistory importStrokes importUnderlay "
                "importPicture pictureToStrokes export "
                "exportAgain exportDrawing print printPreview close quit undo redo cut copy paste pasteInPlace copyAppearance "
                "pasteAppearance "
                "pasteAppearanceEvenly matchAppearance delete duplicate selectAll selectFound searchStrokes "
                "deselect settings canvasMenu brushPalette editHere brush select segments redraw push shapes "
                "outlinePen lassoFill bucket text "
                "knife eraser "
                "attributeBrush eyedropper assistants pan raise lower top "
                "bottom insertNodes nodeCorner nodeSmooth nodeSymmetric breakNodes joinNodes deleteSegments "
                "bridgeSegments reverseStrokes invertSelection sameColour sameStyle sameBrush sameName recolourArtwork "
                "mapToSwatches lasso touchPath "
                "group ungroup clipGroups maskGroups washGroups draftGroups textToStrokes releaseTexts fill removeFill addGradient "
                "removeGradient union difference intersection "
                "exclusion division inset "
                "outset "
                "strokeToOutline combine breakApart removeErasures lock unlockAll hide showAll rename flipAcross "
                "flipDown quarterLeft quarterRight "
                "scaleSpread simplify refit smoothStrokes straighten growPaint shrinkPaint offset applyBrush applyBrushForm "
                "applyBrushColour applyBrushTexture vary along "
                "alignLeft alignCentre alignRight alignTop alignMiddle alignBottom alignToSelection "
                "alignToLast alignToFirst alignToBiggest alignToCanvas distributeGapsAcross distributeGapsDown "
                "distributeCentresAcross distributeCentresDown newLayer newClippedLayer duplicateLayer mergeLayerDown "
                "raiseLayer "
                "lowerLayer layerAbove layerBelow noLayer hideOtherLayers thisLayerOnly snapToNodes snapToGrid "
                "showGrid gridStep "
                "showUnderlay underlayToLayer "
                "showOutlines showErasures showBeyond paintInSymmetry symmetryAcross symmetryDown symmetryBoth symmetryTurns "
                "symmetryKaleidoscope symmetryArms symmetryAngle symmetryToMiddle showSymmetry showRulers rulersInUnits rulersInMillimetres rulersInInches showGuides snapToGuides lockGuides "
                "addLevelGuide addUprightGuide removeGuides showAssistants snapToAssistants removeAssistants softProof gamutWarning proofProfile play toStart previousStroke "
                "nextStroke toEnd loopPlaying "
                "skipPauses letDry "
                "freezeNow rewet removeRewetting paceEven paceEaseIn paceEaseOut paceEaseInOut finalPreview "
                "exportTimelapse favourite1 favourite2 favourite3 favourite4 favourite5 favourite6 favourite7 "
                "favourite8 favourite9 smallerSize largerSize lessOpacity moreOpacity repeatExtension "
                "manageExtensions paintWithKeys holdToPan holdToTurn "
                "holdToHideOutlines zoomIn zoomOut zoom100 fit zoomToSelection rotateLeft rotateRight resetRotation "
                "mirror hideDocks "
                "resetLayout workspacePaint workspaceRefine workspaceTime saveWorkspace nextPanel previousPanel fullScreen newView findCommand manual welcome shortcuts about")
                .split(' ');
        QStringList ids;
        for (const QAction *action : tableOf(s).all())
            ids << action->objectName();
        QCOMPARE(ids, known); // in the order of the shortcut editor, too
        QCOMPARE(ids.size(), int(Command::About) + 1);
    }

    /// What cannot be used says there why, too.
    void whatIsGreyHasAReason()
    {
        Session s;
        int grey = 0;
        for (const PaletteEntry &entry : s.window.paletteEntries()) {
            grey += !entry.enabled;
            QVERIFY2(entry.enabled == entry.whyNot.isEmpty(), qPrintable(entry.id));
        }
        QVERIFY2(grey > 40, qPrintable(QString::number(grey)));
    }

    void everyRowDoesSomethingAndIsFound()
    {
        Session s;
        std::set<QString> found;
        for (const PaletteEntry &entry : s.window.paletteEntries())
            found.insert(entry.id);
        for (int i = 0; i <= int(Command::About); ++i) {
            const CommandRow &row = tableOf(s).row(Command(i));
            const QString id = row.action->objectName();
            QVERIFY2(row.doesSomething() && !row.action->text().isEmpty(), qPrintable(id));
            const bool inMenu = std::ranges::any_of(row.action->associatedObjects(), [](const QObject *place) {
                return qobject_cast<const QMenu *>(place) != nullptr;
            });
            // What is held cannot be chosen; how a band selects is chosen in the Select tool's row.
            const bool elsewhere = row.isHeld() || Command(i) == Command::Lasso || Command(i) == Command::TouchPath;
            QVERIFY2(inMenu != elsewhere, qPrintable(id));
            const bool searched = !row.isHeld() && row.action->isVisible() && Command(i) != Command::FindCommand;
            QVERIFY2(found.contains(id) == searched, qPrintable(id));
        }
    }

    void rowsFollowTheSelection()
    {
        Session s;
        const auto enabled = [&](Command command) { return s.window.action(command).isEnabled(); };
        QVERIFY(!enabled(Command::Play) && !enabled(Command::Undo) && !enabled(Command::Raise));
        s.paintLine({200, 200}, {500, 250});
        QVERIFY(enabled(Command::Play) && enabled(Command::Undo));
        QVERIFY(s.window.action(Command::Undo).text().contains(s.editor().undoStack().undoText()));
        s.use(Command::SelectAll);
        QVERIFY(enabled(Command::Raise) && enabled(Command::FlipAcross) && !enabled(Command::AlignLeft));
        s.use(Command::AlignToCanvas);
        QVERIFY(enabled(Command::AlignLeft));
        s.use(Command::Deselect);
        QVERIFY(!enabled(Command::Raise) && !enabled(Command::AlignLeft) && !enabled(Command::Rewet));
    }

    void ranks()
    {
        const PaletteEntry flip = entry("Objekt ▸ Horizontal spiegeln", "flipAcross");
        QVERIFY(paletteRank(flip, "") && paletteRank(flip, "SPIEG hor") && paletteRank(flip, "objekt spi"));
        QVERIFY(paletteRank(flip, "flip"));  // in English, too
        QVERIFY(paletteRank(flip, "hrzsp")); // with letters left out
        QVERIFY(!paletteRank(flip, "vertikal") && !paletteRank(flip, "horizontal drehen"));
        QVERIFY(*paletteRank(flip, "hor") < *paletteRank(flip, "spieg"));
        QVERIFY(*paletteRank(flip, "spieg") < *paletteRank(flip, "objekt"));
        QVERIFY(*paletteRank(flip, "objekt") < *paletteRank(flip, "hzspgl"));
        QVERIFY(*paletteRank(entry("Bearbeiten ▸ Alles"), "alles") <
                *paletteRank(entry("Ansicht ▸ Alles zeigen"), "alles"));
        QVERIFY(paletteRank(entry("编辑 ▸ 全选", "selectAll"), "全选"));
    }

    void runsACommand()
    {
        Session s;
        QVERIFY(!s.window.action(Command::Select).isChecked());
        const Asked asked = ask(s, "attribute br");
        QVERIFY(asked.enabled && !asked.stayed);
        QVERIFY(asked.first.endsWith("Attribute Brush"));
        QVERIFY(s.window.action(Command::AttributeBrush).isChecked());
    }

    void doesNotRunWhatIsDisabled()
    {
        Session s;
        const Asked asked = ask(s, "flipacross");
        QVERIFY(asked.first.endsWith("Flip Horizontally"));
        QVERIFY(!asked.enabled && asked.stayed);
        QVERIFY2(asked.said.startsWith("“Flip Horizontally” cannot be used now. Nothing is selected"), qPrintable(asked.said));
        QCOMPARE(ask(s, "attribute br").said, QString());
        QCOMPARE(s.editor().undoStack().count(), 0);
    }

    void escapeGivesTheKeyboardBack()
    {
        Session s;
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        const Asked asked = ask(s, "knife", Qt::Key_Escape);
        QVERIFY(!asked.stayed);
        QTRY_VERIFY(s.canvas().hasFocus());
        QVERIFY(!s.window.action(Command::Knife).isChecked());
    }

    void arrowsPassAllRows()
    {
        Session s;
        CommandPalette palette(s.window.paletteEntries(), &s.window);
        const int count = palette.list()->count();
        QVERIFY(count > 100);
        std::set<int> seen{palette.list()->currentRow()};
        for (int i = 1; i < count; ++i) {
            QTest::keyClick(palette.search(), Qt::Key_Down);
            seen.insert(palette.list()->currentRow());
        }
        QCOMPARE(int(seen.size()), count);
        QTest::keyClick(palette.search(), Qt::Key_Down);
        QCOMPARE(palette.list()->currentRow(), 0);
        palette.search()->setText("no such thing at all");
        QCOMPARE(palette.list()->count(), 0);
        QTest::keyClick(palette.search(), Qt::Key_Return);
        QVERIFY(!palette.chosen());
    }

    void findsBrushes()
    {
        Session s;
        s.use(Command::Select);
        const QString name = BrushLibrary::instance().brushes().at(3).name;
        QVERIFY(s.editor().brush().name != name);
        const Asked asked = ask(s, "brush " + brushTitle(name));
        QVERIFY2(asked.first.endsWith(brushTitle(name)), qPrintable(asked.first));
        QCOMPARE(s.editor().brush().name, name);
        QVERIFY(s.window.action(Command::Brush).isChecked());
    }

    void findsRecentFiles()
    {
        Session s;
        const QString path = m_folder.filePath("harbour at dusk.suffuse");
        s.paintLine({200, 200}, {500, 250});
        QVERIFY(s.window.saveTo(path));
        Session other;
        ask(other, "harbour dusk");
        // It is open already: the window that shows it comes to the front instead of a second one.
        QVERIFY(other.editor().filePath().isEmpty());
        s.window.close();
        ask(other, "harbour dusk");
        QCOMPARE(other.editor().filePath(), path);
    }

    void findsDocks()
    {
        Session s;
        auto *dock = s.window.findChild<QDockWidget *>("probeDock");
        QVERIFY(dock && dock->isHidden());
        ask(s, "docks probe");
        QVERIFY(!dock->isHidden());
    }

    /// It is not closed, as by the menu, but comes to the front, and the keyboard with it.
    void aDockBehindAnotherComesToTheFront()
    {
        Session s;
        auto *strokes = s.window.findChild<QDockWidget *>("strokesDock");
        const QList<QDockWidget *> beside = s.window.tabifiedDockWidgets(strokes);
        auto *other = beside.isEmpty() ? s.window.findChild<QDockWidget *>("inspectorDock") : beside.front();
        s.window.tabifyDockWidget(strokes, other);
        other->show();
        other->raise();
        QTRY_VERIFY(strokes->visibleRegion().isEmpty() && !strokes->isHidden());
        ask(s, "docks strokes");
        QTRY_VERIFY(!strokes->visibleRegion().isEmpty());
        const auto hasKeyboard = [&] { return strokes->isAncestorOf(QApplication::focusWidget()); };
        QTRY_VERIFY(hasKeyboard());
        s.canvas().setFocus();
        ask(s, "docks strokes"); // which is seen already
        QTRY_VERIFY(hasKeyboard());
        QVERIFY(!strokes->isHidden());
        ask(s, "docks strokes");
        QVERIFY(strokes->isHidden());
    }

    /// What works while a key is held does nothing here; what finds is not found.
    void leavesOutWhatCannotRun()
    {
        Session s;
        for (const PaletteEntry &found : s.window.paletteEntries()) {
            QVERIFY2(!found.id.startsWith("holdTo") && found.id != "findCommand", qPrintable(found.title));
            QVERIFY(!found.title.isEmpty() && found.run);
        }
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestPalette)
#include "test_palette.moc"
