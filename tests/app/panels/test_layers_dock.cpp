// Layers in the Strokes dock: which one is painted on, and how it is chosen there.
#include "app/panels/strokes/group_hand.h"
#include "app/panels/strokes/rows/row_look.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/panels/strokes/strokes_view.h"
#include "app/session/commands/selection_commands.h"
#include "app/widgets/look/group_tags.h"
#include "app/widgets/look/theme.h"
#include "tests/app/panel_bench.h"
#include "undo/layers/group_edits.h"
#include "undo/layers/layer_edits.h"

#include <QLabel>
#include <QMenu>
#include <QSignalSpy>
#include <QTreeView>

#include <algorithm>

using namespace suffuse;

namespace {

/// From bottom to top: 1, 2, group 1 {3, 4}, 5.
struct Layered : Bench {
    Layered() : Bench(5)
    {
        select({3, 4});
        editor.push(groupSelection(editor.document(), "sky"), "group");
        select({});
    }
};

struct LayersDock {
    StrokesPanel panel;
    explicit LayersDock(Editor &editor) : panel(editor) { showAt(panel, {280, 400}); }
    QTreeView &view() { return *panel.view(); }
    QModelIndex groupRow() { return view().model()->index(1, 0); }
    void click(const QModelIndex &row, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseClick(view().viewport(), Qt::LeftButton, modifiers, view().visualRect(row).center());
    }
    GroupCells cells() { return static_cast<StrokesView &>(view()).cellsOf(groupRow()); }
    /// Drags from the middle of the opacity, and holds the button.
    void dragOpacity(int by)
    {
        const QPoint from = cells().opacity.center();
        QTest::mousePress(view().viewport(), Qt::LeftButton, {}, from);
        for (int step = 1; step <= 4; ++step)
            QTest::mouseMove(view().viewport(), from + QPoint(by * step / 4, 0));
    }
    QString said()
    {
        const auto *label = panel.findChild<QLabel *>("layer");
        return label->isVisible() ? label->text() : QString();
    }
};

} // namespace

class TestLayersDock : public QObject {
    Q_OBJECT

private slots:
    void aRowThatIsClickedIsPaintedOn()
    {
        Layered bench;
        LayersDock dock(bench.editor);
        QCOMPARE(dock.said(), QString("Painting on top of all"));
        dock.click(dock.groupRow());
        QCOMPARE(bench.editor.layer().group(), GroupId(1));
        QCOMPARE(bench.editor.selection().strokes, (std::set<StrokeId>{3, 4})); // as before
        QCOMPARE(dock.said(), QString("Painting on: sky"));
        QVERIFY(dock.groupRow().data(StrokesModel::CurrentLayerRole).toBool());
        QCOMPARE(dock.groupRow().data(Qt::AccessibleTextRole).toString(), QString("sky, painted on"));
        dock.click(dock.panel.viewIndexOf(5));
        QCOMPARE(bench.editor.layer().group(), GroupId(0));
        QCOMPARE(dock.said(), QString("Painting on top of all"));
        QVERIFY(!dock.groupRow().data(StrokesModel::CurrentLayerRole).toBool());
        dock.view().expand(dock.groupRow());
        dock.click(dock.panel.viewIndexOf(3));
        QCOMPARE(bench.editor.layer().group(), GroupId(1));
        QCOMPARE(bench.editor.selection().strokes, std::set<StrokeId>{3});
        QTest::mouseClick(dock.view().viewport(), Qt::LeftButton, {},
                          dock.view().viewport()->rect().bottomLeft() - QPoint(-60, 8));
        QCOMPARE(bench.editor.layer().group(), GroupId(0));
    }

    /// The row of the layer is brought into sight, where it is not in a group that is closed.
    void theLayersRowIsShown()
    {
        Layered bench;
        std::vector<StrokePtr> many;
        for (int i = 0; i < 60; ++i) {
            Stroke copy = bench.stroke(5);
            copy.id = bench.editor.document().takeStrokeId();
            many.push_back(std::make_shared<const Stroke>(std::move(copy)));
        }
        bench.editor.push(addStrokes(bench.editor.document(), std::move(many), false), "many");
        bench.editor.laterChanges().flush();
        LayersDock dock(bench.editor);
        const QModelIndex group = dock.view()
                                      .model()
                                      ->match(dock.view().model()->index(0, 0), StrokesModel::GroupIdRole,
                                              QVariant::fromValue<qulonglong>(1), 1, Qt::MatchExactly)
                                      .value(0);
        QVERIFY(group.isValid());
        dock.view().scrollTo(dock.view().model()->index(0, 0));
        const auto isSeen = [&] {
            return dock.view().viewport()->rect().contains(dock.view().visualRect(group).center());
        };
        QVERIFY(!isSeen());
        bench.editor.layer().choose(1);
        QTRY_VERIFY(isSeen());
        QVERIFY(!dock.view().isExpanded(group));
    }

    /// It stands out, whatever is selected: other rows look selected in a weaker way.
    void theLayersRowStandsOut()
    {
        Layered bench;
        LayersDock dock(bench.editor);
        const auto ground = [&](const QModelIndex &index) { // beside the picture, which comes later
            bench.editor.laterChanges().flush();
            const QImage image = dock.view().viewport()->grab().toImage();
            const QRect row = dock.view().visualRect(index);
            return image.pixelColor(QPoint(row.right() - 2, row.top() + 2));
        };
        // Whether the window is the active one is for the system to say.
        const auto isOf = [](const QColor &colour, const QPalette &palette) {
            return colour == palette.color(QPalette::Active, QPalette::Highlight) ||
                   colour == palette.color(QPalette::Inactive, QPalette::Highlight);
        };
        const auto isStrong = [&](const QModelIndex &row) { return isOf(ground(row), dock.view().palette()); };
        const WeakPalette weak;
        const auto isWeak = [&](const QModelIndex &row) { return isOf(ground(row), weak.of(dock.view().palette())); };
        bench.select({3, 4}); // No row is clicked: below the pointer they look otherwise.
        bench.editor.layer().choose(1);
        QVERIFY(isStrong(dock.groupRow()));
        bench.select({5});
        bench.editor.layer().choose(0);
        QVERIFY(isWeak(dock.panel.viewIndexOf(5)) && !isStrong(dock.panel.viewIndexOf(5)));
        QVERIFY(!isWeak(dock.panel.viewIndexOf(1)));
        bench.editor.layer().choose(1);
        QVERIFY(isStrong(dock.groupRow()) && isWeak(dock.panel.viewIndexOf(5)));
        bench.editor.document().setSelection({{3, 4}, {}});
        bench.editor.layer().choose(0);
        QVERIFY(isWeak(dock.groupRow()) && !isStrong(dock.groupRow()));
    }

    /// The arrow before a group is seen on the ground of its row, whether that is the layer's, selected or neither.
    void theArrowOfAGroupIsSeen()
    {
        Layered bench;
        LayersDock dock(bench.editor);
        const auto contrast = [&] {
            bench.editor.laterChanges().flush();
            const QImage image = dock.view().viewport()->grab().toImage();
            const QRect row = dock.view().visualRect(dock.groupRow());
            const int ground = qGray(image.pixel(1, row.top() + 2));
            int most = 0;
            for (int x = 0; x < row.left(); ++x)
                for (int y = row.top() + 2; y < row.bottom() - 1; ++y)
                    most = std::max(most, std::abs(qGray(image.pixel(x, y)) - ground));
            return most;
        };
        for (const QPalette &palette : {lightPalette(), darkPalette()}) {
            dock.view().setPalette(palette);
            for (const bool isLayer : {false, true})
                for (const std::set<StrokeId> &selected : {std::set<StrokeId>(), {3, 4}})
                    for (const bool open : {false, true}) {
                        bench.select(selected);
                        bench.editor.layer().choose(isLayer ? 1 : 0);
                        dock.view().setExpanded(dock.groupRow(), open);
                        QVERIFY2(contrast() > 100, qPrintable(QString::number(contrast())));
                    }
        }
    }

    /// Their eyes are dimmed, since they are not seen.
    void othersAreDimmedWhileOneIsShownAlone()
    {
        Layered bench;
        LayersDock dock(bench.editor);
        const auto eye = [&](const QModelIndex &index) {
            return dock.view()
                .viewport()
                ->grab(dock.view().visualRect(index.siblingAtColumn(StrokesModel::EyeColumn)))
                .toImage();
        };
        const QImage group = eye(dock.groupRow()), other = eye(dock.panel.viewIndexOf(1));
        bench.editor.push(toggleSolo(bench.editor.document(), 1), "solo");
        QCOMPARE(eye(dock.groupRow()), group);
        QVERIFY(eye(dock.panel.viewIndexOf(1)) != other);
    }

    void keysInTheDockChooseIt()
    {
        Layered bench;
        LayersDock dock(bench.editor);
        dock.click(dock.panel.viewIndexOf(5));
        QTest::keyClick(&dock.view(), Qt::Key_Down);
        QCOMPARE(bench.editor.layer().group(), GroupId(1));
        QTest::keyClick(&dock.view(), Qt::Key_Down);
        QCOMPARE(bench.editor.layer().group(), GroupId(0));
    }

    /// What is selected on the canvas, by a range or one by one, is not where people want to paint.
    void selectingElsewhereLeavesIt()
    {
        Layered bench;
        LayersDock dock(bench.editor);
        dock.click(dock.groupRow());
        bench.select({5});
        QCOMPARE(bench.editor.layer().group(), GroupId(1));
        dock.click(dock.panel.viewIndexOf(2), Qt::ControlModifier);
        dock.click(dock.panel.viewIndexOf(1), Qt::ShiftModifier);
        QCOMPARE(bench.editor.layer().group(), GroupId(1));
        dock.click(dock.groupRow().siblingAtColumn(StrokesModel::EyeColumn));
        QVERIFY(!bench.editor.document().painting()->groups[0].visible);
        QCOMPARE(bench.editor.layer().group(), GroupId(1));
    }

    /// What comes back or is selected is seen, and for that no other group opens than those around its row.
    void closedGroupsStayClosed()
    {
        Layered bench;
        bench.select({3, 4, 5}); // group 2 {group 1 {3, 4}, 5}
        bench.editor.push(groupSelection(bench.editor.document(), "all"), "group");
        bench.select({});
        LayersDock dock(bench.editor);
        const auto outer = [&] { return dock.view().model()->index(0, 0); };
        const auto inner = [&] { return dock.panel.viewIndexOf(3).parent(); };
        const auto isOpen = [&](const QModelIndex &group) { return dock.view().isExpanded(group); };
        const auto shows = [&](const QModelIndex &row) {
            bench.editor.laterChanges().flush();
            QApplication::processEvents();
            return dock.view().currentIndex() == row && !dock.view().visualRect(row).isEmpty();
        };
        bench.select({3, 4, 5}); // all in it: its row says so
        QVERIFY(shows(outer()) && !isOpen(outer()));
        bench.select({3, 4});
        QVERIFY(shows(inner()) && isOpen(outer()) && !isOpen(inner()));
        dock.view().collapse(outer());
        bench.select({3, 2}); // one of them is seen
        QVERIFY(shows(dock.panel.viewIndexOf(2)) && !isOpen(outer()));
        bench.select({3});
        QVERIFY(shows(dock.panel.viewIndexOf(3)) && isOpen(outer()) && isOpen(inner()));
        dock.view().collapse(outer());
        const StrokePtr stroke = makeStroke(bench.editor.document().takeStrokeId(), 2, 10);
        bench.editor.push(addStrokes(bench.editor.document(), {stroke}, false), "paint");
        bench.editor.laterChanges().flush();
        QApplication::processEvents();
        QVERIFY(!isOpen(dock.panel.viewIndexOf(5).parent())); // The selection is what it was.
        bench.editor.undo();
        dock.view().collapseAll();
        bench.select({3, 4, 5});
        commands::deleteSelected(bench.editor);
        QCOMPARE(dock.view().model()->rowCount(), 2);
        bench.editor.undo();
        QVERIFY(shows(outer()) && !isOpen(outer()) && !isOpen(inner()));
    }

    void aMarkedGroupHasAStripOfItsColour()
    {
        Layered bench;
        LayersDock dock(bench.editor);
        const auto strip = [&] {
            const QImage image = dock.view().viewport()->grab().toImage();
            const QRect row = dock.view().visualRect(dock.groupRow());
            return image.pixelColor(QPoint(row.left() + 1, row.center().y()));
        };
        QVERIFY(strip() != colourOf(GroupTag::Green));
        bench.editor.push(setGroupTag(bench.editor.document(), {1}, GroupTag::Green), "mark");
        QCOMPARE(strip(), colourOf(GroupTag::Green));
        QVERIFY(dock.groupRow().data(Qt::ToolTipRole).toString().contains(nameOf(GroupTag::Green)));
    }

    /// Files of earlier versions have such groups. Nothing of them can be selected.
    void aGroupWithoutStrokesIsDeletedByItsMenu()
    {
        Layered bench;
        auto painting = std::make_shared<Painting>(*bench.editor.document().painting());
        painting->groups.push_back({9, "empty", 0, true, false});
        bench.editor.document().reset(painting);
        LayersDock dock(bench.editor);
        QModelIndex row;
        for (int i = 0; i < dock.view().model()->rowCount(); ++i)
            if (const QModelIndex index = dock.view().model()->index(i, 0); index.data().toString() == "empty")
                row = index;
        QVERIFY(row.isValid());
        const auto deleting = [&](const QModelIndex &of, QMenu &menu) {
            dock.panel.fillMenu(menu, of);
            const QList<QAction *> all = menu.actions();
            return *std::ranges::find_if(
                all, [](const QAction *action) { return action->text().remove('&').startsWith("Delete"); });
        };
        QMenu other, menu;
        QVERIFY(!deleting(dock.groupRow(), other)->isEnabled()); // Nothing of it is selected.
        QAction *action = deleting(row, menu);
        QVERIFY(action->isEnabled());
        action->trigger();
        QVERIFY(!bench.editor.document().painting()->findGroup(9));
        QCOMPARE(bench.editor.document().painting()->groups.size(), std::size_t(1));
        bench.editor.undo();
        QVERIFY(bench.editor.document().painting()->findGroup(9));
    }

    void aLayerThatIsToComeIsNamed()
    {
        Layered bench;
        LayersDock dock(bench.editor);
        bench.editor.layer().beginNew();
        QCOMPARE(dock.said(), QString("New layer: Layer 1"));
        const StrokePtr stroke = makeStroke(bench.editor.document().takeStrokeId(), 2, 10);
        bench.editor.push(bench.editor.layer().take(addStrokes(bench.editor.document(), {stroke}, false)), "paint");
        QCOMPARE(dock.said(), QString("Painting on: Layer 1"));
        bench.editor.push(renameGroup(bench.editor.document(), bench.editor.layer().group(), "sea"), "rename");
        QCOMPARE(dock.said(), QString("Painting on: sea"));
    }

    void aRowSaysWhatIsUnusualAboutItsGroup()
    {
        Layered bench;
        LayersDock dock(bench.editor);
        dock.panel.resize(400, 400);
        QVERIFY(dock.groupRow().data(Qt::ToolTipRole).toString().isEmpty());
        const GroupCells plain = dock.cells();
        QVERIFY(!plain.opacity.isEmpty() && !plain.mode.isEmpty() && plain.marks.isEmpty());
        Edit edit;
        edit.groups = bench.editor.document().painting()->groups;
        Group &group = edit.groups->front();
        group.blend = BlendMode::Multiply;
        group.clips = group.mask = group.solo = true;
        group.wash = Wash();
        bench.editor.push(edit, "all");
        QCOMPARE(marksOf(group).size(), 4);
        QCOMPARE(dock.groupRow().data(Qt::ToolTipRole).toString().count('\n'), 4);
        const GroupCells all = dock.cells();
        QVERIFY(all.marks.width() >= 4 * 14 && all.marks.right() < all.mode.left());
        QVERIFY(all.mode.right() < all.opacity.left());
        QVERIFY(dock.view().viewport()->rect().contains(all.opacity));
        const GroupCells narrow = groupCells(group, {0, 0, 120, 24}, 90, dock.view().font());
        QVERIFY(narrow.mode.isEmpty() && narrow.marks.isEmpty()); // The name comes first.
        QVERIFY(static_cast<StrokesView &>(dock.view()).cellsOf(dock.panel.viewIndexOf(5)).opacity.isEmpty());
    }

    void theOpacityIsDraggedInOneStep()
    {
        Layered bench;
        LayersDock dock(bench.editor);
        const auto opacity = [&] { return bench.editor.document().painting()->groups[0].opacity; };
        const int steps = bench.steps();
        dock.dragOpacity(-80);
        QCOMPARE(opacity(), 0.6f);
        QTest::mouseRelease(dock.view().viewport(), Qt::LeftButton, {}, dock.cells().opacity.center());
        QCOMPARE(bench.steps(), steps + 1);
        QCOMPARE(opacity(), 0.6f);
        QVERIFY(bench.editor.selection().isEmpty()); // The row was not clicked.
        bench.editor.undo();
        QCOMPARE(opacity(), 1.0f);
        dock.dragOpacity(-500);
        QCOMPARE(opacity(), 0.0f);
        QTest::keyClick(&dock.view(), Qt::Key_Escape);
        QCOMPARE(opacity(), 1.0f);
        QTest::mouseRelease(dock.view().viewport(), Qt::LeftButton, {}, dock.cells().opacity.center());
        QCOMPARE(opacity(), 1.0f);
        QVERIFY(!dock.view().viewport()->findChild<QLineEdit *>("groupOpacity"));
    }

    /// A press that becomes a drag and is given up has chosen nothing to paint on.
    void aLayerIsChosenWhenTheButtonIsLetGo()
    {
        Layered bench;
        LayersDock dock(bench.editor);
        const QPoint at = dock.view().visualRect(dock.groupRow()).center();
        QTest::mousePress(dock.view().viewport(), Qt::LeftButton, {}, at);
        QCOMPARE(bench.editor.layer().group(), GroupId(0));
        QTest::mouseRelease(dock.view().viewport(), Qt::LeftButton, {}, at);
        QCOMPARE(bench.editor.layer().group(), GroupId(1));
    }

    /// What was given up, or taken back by an undo, stays so until the button is let go, wherever the pointer goes.
    void aDragThatIsGivenUpIsOver()
    {
        for (const bool byUndo : {false, true}) {
            Layered bench;
            LayersDock dock(bench.editor);
            const auto opacity = [&] { return bench.editor.document().painting()->groups[0].opacity; };
            const PaintingPtr before = bench.editor.document().painting();
            const int steps = bench.editor.undoStack().index();
            const QPoint from = dock.cells().opacity.center();
            dock.dragOpacity(-80);
            QCOMPARE(opacity(), 0.6f);
            if (byUndo)
                bench.editor.undo();
            else
                QTest::keyClick(&dock.view(), Qt::Key_Escape);
            QCOMPARE(opacity(), 1.0f);
            for (int step = 1; step <= 6; ++step)
                QTest::mouseMove(dock.view().viewport(), from + QPoint(-80 + 4 * step, 12 * step));
            QCOMPARE(opacity(), 1.0f);
            QTest::mouseRelease(dock.view().viewport(), Qt::LeftButton, {}, from + QPoint(-50, 72));
            QCOMPARE(opacity(), 1.0f);
            QCOMPARE(bench.editor.undoStack().index(), steps);
            QVERIFY(*bench.editor.document().painting() == *before); // No row was dragged.
            QVERIFY(bench.editor.selection().isEmpty());             // None was swept over.
            dock.dragOpacity(-40);
            QTest::mouseRelease(dock.view().viewport(), Qt::LeftButton, {}, from + QPoint(-40, 0));
            QCOMPARE(opacity(), 0.8f);
        }
    }

    /// It would stand on another row, and what is typed would go nowhere.
    void theFieldGoesWithItsGroup()
    {
        Layered bench;
        LayersDock dock(bench.editor);
        bench.editor.document().setSelection({{3, 4}, {}});
        GroupId copy = 0;
        bench.editor.push(duplicateGroup(bench.editor.document(), 1, "copy", copy), "duplicate");
        bench.editor.laterChanges().flush();
        const auto field = [&] { return dock.view().viewport()->findChild<QLineEdit *>("groupOpacity"); };
        QTest::mouseClick(dock.view().viewport(), Qt::LeftButton, {}, dock.cells().opacity.center());
        QVERIFY(field());
        bench.editor.undo();
        bench.editor.laterChanges().flush();
        QTRY_VERIFY(!field());
    }

    void theOpacityIsTypedAfterAClick()
    {
        Layered bench;
        LayersDock dock(bench.editor);
        QSignalSpy said(&dock.panel, &StrokesPanel::said);
        const int steps = bench.steps();
        const auto field = [&] {
            QTest::mouseClick(dock.view().viewport(), Qt::LeftButton, {}, dock.cells().opacity.center());
            return dock.view().viewport()->findChild<QLineEdit *>("groupOpacity");
        };
        QLineEdit *open = field();
        QVERIFY(open);
        QTest::keyClicks(open, "35");
        QTest::keyClick(open, Qt::Key_Return);
        QCOMPARE(bench.editor.document().painting()->groups[0].opacity, 0.35f);
        QCOMPARE(bench.steps(), steps + 1);
        QTRY_VERIFY(!dock.view().viewport()->findChild<QLineEdit *>("groupOpacity"));
        const auto enter = [&](const QString &text) {
            QLineEdit *again = field();
            QTest::keyClicks(again, text);
            QTest::keyClick(again, Qt::Key_Return);
            QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            return bench.editor.document().painting()->groups[0].opacity;
        };
        QCOMPARE(enter("60%"), 0.6f); // as the cell writes it
        QCOMPARE(enter("2*20"), 0.4f);
        QCOMPARE(int(said.count()), 0);
        QCOMPARE(enter("130"), 0.4f);
        QVERIFY(said.last().at(0).toString().contains("out of range"));
        QCOMPARE(enter("abc"), 0.4f);
        QVERIFY(said.last().at(0).toString().startsWith("“abc”"));
        QCOMPARE(enter("35"), 0.35f);
        said.clear();
        bench.editor.push(setGroupLocked(bench.editor.document(), 1, true), "lock");
        QLineEdit *locked = field();
        QTest::keyClicks(locked, "50");
        QTest::keyClick(locked, Qt::Key_Return);
        QCOMPARE(int(said.count()), 1);
        QCOMPARE(bench.editor.document().painting()->groups[0].opacity, 0.35f);
    }

    /// What undo and redo select stands out again as the layer, as it did then, and is what is deleted.
    void whatUndoSelectsStandsOut()
    {
        Layered bench;
        bench.select({1, 2});
        bench.editor.push(groupSelection(bench.editor.document(), "sea"), "group");
        bench.select({});
        LayersDock dock(bench.editor);
        const QModelIndex sky = dock.view().model()->index(1, 0), sea = dock.view().model()->index(2, 0);
        const auto isMeant = [](const QModelIndex &row) {
            return row.data(StrokesModel::CurrentLayerRole).toBool() &&
                   row.data(StrokesModel::WhollySelectedRole).toBool();
        };
        dock.click(sky);
        dock.dragOpacity(-30);
        QTest::mouseRelease(dock.view().viewport(), Qt::LeftButton, {}, dock.cells().opacity.center() - QPoint(30, 0));
        dock.click(sea);
        QVERIFY(isMeant(sea) && !isMeant(sky));
        bench.editor.undo();
        QVERIFY(isMeant(sky) && !isMeant(sea));
        dock.click(sea);
        bench.editor.redo();
        bench.editor.laterChanges().flush();
        QVERIFY(isMeant(sky) && !isMeant(sea));
        commands::deleteSelected(bench.editor);
        QVERIFY(!bench.editor.document().painting()->find(3) && bench.editor.document().painting()->find(1));
        QCOMPARE(bench.editor.document().painting()->strokes.size(), std::size_t(3));
    }

    void theModeIsChosenFromAList()
    {
        Layered bench;
        LayersDock dock(bench.editor);
        auto *hand = dock.view().findChild<GroupHand *>();
        QVERIFY(hand);
        QMenu menu;
        hand->fillModes(menu, 1);
        QList<QAction *> modes;
        for (QAction *action : menu.actions())
            if (!action->isSeparator())
                modes << action;
        QCOMPARE(int(modes.size()), blendModes);
        QVERIFY(modes[0]->isChecked());
        modes[2]->trigger();
        QCOMPARE(bench.editor.document().painting()->groups[0].blend, BlendMode::Multiply);
        bench.editor.undo();
        QCOMPARE(bench.editor.document().painting()->groups[0].blend, BlendMode::Normal);
    }

    /// Letters go from entry to entry in the open list, and reach nothing else.
    void aLetterGoesToAModeInTheList()
    {
        Layered bench;
        LayersDock dock(bench.editor);
        QMenu menu;
        dock.view().findChild<GroupHand *>()->fillModes(menu, 1);
        menu.popup({0, 0});
        const auto typed = [&](char letter) {
            QTest::keyClick(&menu, letter);
            return menu.activeAction() ? menu.activeAction()->text() : QString();
        };
        QCOMPARE(typed('m'), QString("Multiply"));
        QCOMPARE(typed('s'), QString("Screen"));
        QCOMPARE(typed('m'), QString("Mask Below"));
        QCOMPARE(typed('m'), QString("Multiply"));
        QKeyEvent key(QEvent::ShortcutOverride, Qt::Key_M, Qt::NoModifier, "m");
        key.ignore();
        QApplication::sendEvent(&menu, &key);
        QVERIFY(key.isAccepted());
        QTest::keyClick(&menu, Qt::Key_Return);
        QCOMPARE(bench.editor.document().painting()->groups[0].blend, BlendMode::Multiply);
    }
};

QTEST_MAIN(TestLayersDock)
#include "test_layers_dock.moc"
