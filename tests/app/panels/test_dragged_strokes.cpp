// The list of strokes: rows are dragged to other places, groups with what is in them.
#include "app/panels/strokes/rows/drag_picture.h"
#include "app/panels/strokes/rows/dragged_rows.h"
#include "app/panels/strokes/rows/row_moves.h"
#include "app/panels/strokes/strokes_filter.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/panels/strokes/strokes_view.h"
#include "app/widgets/habits/held_button.h"
#include "model/formats/files.h"
#include "model/painting/validate.h"
#include "tests/app/panel_bench.h"
#include "undo/layers/group_edits.h"

#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QMimeData>
#include <QShortcut>
#include <QSignalSpy>
#include <QTest>
#include <QTreeView>

using namespace suffuse;

class TestDraggedStrokes : public QObject {
    Q_OBJECT

private slots:
    void dropReorders()
    {
        Bench bench(4); // rows 4 3 2 1
        StrokesPanel panel(bench.editor);
        StrokesModel *model = panel.model();
        const auto drop = [&](StrokeId id, int row) {
            const std::unique_ptr<QMimeData> data(model->mimeData({model->indexOf(id)}));
            model->dropMimeData(data.get(), Qt::MoveAction, row, 0, {});
        };
        drop(1, 1); // below 4
        QCOMPARE(orderOf(bench.editor), (std::vector<StrokeId>{2, 3, 1, 4}));
        QCOMPARE(bench.steps(), 1);
        drop(3, 0);
        QCOMPARE(orderOf(bench.editor), (std::vector<StrokeId>{2, 1, 4, 3}));
        drop(4, 4); // to the bottom
        QCOMPARE(orderOf(bench.editor), (std::vector<StrokeId>{4, 2, 1, 3}));
        QCOMPARE(bench.steps(), 3);
        bench.editor.undoStack().setIndex(0);
        QCOMPARE(orderOf(bench.editor), (std::vector<StrokeId>{1, 2, 3, 4}));
        QCOMPARE(model->strokeAt(model->index(0, 0)), StrokeId(4));
    }

    /// What a search hides could lie between the rows: they are not dragged then, and that is said.
    void aSearchRefusesDragsAndSaysSo()
    {
        Bench bench(0);
        auto painting = std::make_shared<Painting>();
        for (StrokeId id = 1; id <= 4; ++id) {
            Stroke stroke = *makeStroke(id, 1, 5);
            stroke.name = id % 2 ? "leaf" : "roof";
            painting->strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        bench.editor.document().reset(painting);
        StrokesPanel panel(bench.editor);
        panel.resize(300, 400);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        panel.search()->setText("leaf");
        QSignalSpy said(&panel, &StrokesPanel::said);
        QWidget &viewport = *panel.view()->viewport();
        const QPoint from = panel.view()->visualRect(panel.viewIndexOf(3)).center();
        const auto send = [&](QEvent::Type type, QPoint at, Qt::MouseButton button, Qt::MouseButtons buttons) {
            QMouseEvent event(type, at, viewport.mapToGlobal(at), button, buttons, {});
            QCoreApplication::sendEvent(&viewport, &event);
        };
        send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        for (int y = 10; y <= 60; y += 10)
            send(QEvent::MouseMove, from + QPoint(0, y), Qt::NoButton, Qt::LeftButton);
        send(QEvent::MouseButtonRelease, from + QPoint(0, 60), Qt::LeftButton, Qt::NoButton);
        QCOMPARE(said.size(), 1);
        QVERIFY(said[0][0].toString().contains("Clear the search"));
        QCOMPARE(orderOf(bench.editor), (std::vector<StrokeId>{1, 2, 3, 4}));
        QCOMPARE(bench.steps(), 0);
    }

    /// It shows what is dragged, small and beside the pointer, so that the place where it goes is seen.
    void aSmallPictureIsDragged()
    {
        Bench bench(6);
        bench.editor.push(
            changeStrokes(bench.editor.document(), {1, 2}, [](Stroke &stroke) { stroke.name = QString(200, 'm'); }),
            "a long name");
        StrokesPanel panel(bench.editor);
        showAt(panel, {300, 400});
        const auto picture = [&](const QModelIndexList &rows) { return dragPicture(*panel.view(), rows); };
        const QPixmap one = picture({panel.viewIndexOf(1)}), other = picture({panel.viewIndexOf(3)}),
                      some = picture({panel.viewIndexOf(3), panel.viewIndexOf(4)});
        for (const QPixmap &each : {one, other, some}) {
            QVERIFY(each.deviceIndependentSize().width() < 0.75 * panel.width());
            QVERIFY(each.deviceIndependentSize().height() <=
                    panel.view()->visualRect(panel.viewIndexOf(1)).height() + 8);
        }
        QVERIFY(other.toImage() != some.toImage() && one.width() > other.width());
        QVERIFY(dragHotSpot().x() < 0 && dragHotSpot().y() < 0); // The pointer is outside.
    }

    /// Undo and Delete give up what is dragged from one place to another, as they do with every drag. QDrag takes all
    /// keys.
    void keysEndADragOfRows()
    {
        int ended = 0, undone = 0;
        QWidget window;
        QShortcut undo(QKeySequence::Undo, &window);
        connect(&undo, &QShortcut::activated, &window, [&] { ++undone; });
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        {
            const KeysEndDrag ends([&] { ++ended; });
            QCoreApplication::processEvents();
            struct TakesAll : QObject { // as QDrag's own filter does
                bool eventFilter(QObject *, QEvent *event) override
                {
                    return event->type() == QEvent::ShortcutOverride && (event->accept(), true);
                }
            } takesAll;
            window.installEventFilter(&takesAll);
            QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
            QCOMPARE(ended, 1);
            QTest::keyClick(&window, Qt::Key_Delete);
            QCOMPARE(ended, 2);
            QTest::keyClick(&window, Qt::Key_A);
            QCOMPARE(ended, 2);
            QCOMPARE(undone, 0);
        }
        QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(ended, 2);
        QCOMPARE(undone, 1);
    }

    void groupsAreATree()
    {
        Bench bench(0);
        auto painting = std::make_shared<Painting>();
        painting->groups = {{1, "Trees", 0, true, false}, {2, "", 1, true, false}};
        for (const auto &[id, group] : {std::pair<StrokeId, GroupId>{1, 0}, {2, 2}, {3, 1}, {4, 0}}) {
            Stroke stroke = *makeStroke(id, 1, 5);
            stroke.group = group;
            painting->strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        bench.editor.document().reset(painting);
        StrokesModel model(bench.editor);
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QCOMPARE(model.rowCount(), 3); // 4, Trees, 1
        const QModelIndex trees = model.index(1, 0);
        QCOMPARE(trees.data().toString(), QString("Trees"));
        QCOMPARE(model.rowCount(trees), 2);
        QCOMPARE(model.strokesBelow(trees), (std::set<StrokeId>{2, 3}));
        model.toggle(trees.siblingAtColumn(StrokesModel::EyeColumn));
        QVERIFY(!bench.editor.document().painting()->groups[0].visible);
        // Into the group, on its top.
        const std::unique_ptr<QMimeData> data(model.mimeData({model.indexOf(1)}));
        model.dropMimeData(data.get(), Qt::MoveAction, 0, 0, model.index(1, 0));
        QCOMPARE(bench.stroke(1).group, GroupId(1));
        QCOMPARE(orderOf(bench.editor), (std::vector<StrokeId>{2, 3, 1, 4}));
        bench.editor.undoStack().setIndex(0);
        QCOMPARE(bench.stroke(1).group, GroupId(0));
        QCOMPARE(model.rowCount(), 3);
    }

    /// Another program gets what it would get by the clipboard, and may only copy it.
    void rowsOfferAllFormsToOthers()
    {
        Bench bench(2);
        StrokesModel model(bench.editor);
        QVERIFY(model.supportedDragActions() & Qt::CopyAction);
        const std::unique_ptr<QMimeData> data(model.mimeData({model.indexOf(2)}));
        for (const char *form : {"application/x-suffuse-strokes+json", "image/svg+xml", "application/pdf", "image/png"})
            QVERIFY2(data->hasFormat(form), form);
        QVERIFY(data->data("image/svg+xml").contains("<svg"));
        const Result<Painting> own = readTextForm(data->data("application/x-suffuse-strokes+json"), "a");
        QVERIFY(own && own->strokes.size() == 1 && own->strokes[0]->id == 2);
    }

    void groupsMoveAsGroups()
    {
        Bench bench(0);
        auto painting = std::make_shared<Painting>();
        painting->groups = {{1, "Trees", 0, true, false}, {2, "Leaves", 1, true, false}, {3, "Sky", 0, true, false}};
        for (const auto &[id, group] : {std::pair<StrokeId, GroupId>{1, 3}, {2, 2}, {3, 2}, {4, 1}, {5, 0}}) {
            Stroke stroke = *makeStroke(id, 1, 5);
            stroke.group = group;
            painting->strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        bench.editor.document().reset(painting);
        StrokesModel model(bench.editor);
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        const auto drop = [&](const QModelIndex &row, int at, const QModelIndex &parent) {
            const std::unique_ptr<QMimeData> data(model.mimeData({row}));
            model.dropMimeData(data.get(), Qt::MoveAction, at, 0, parent);
        };
        const auto group = [&](GroupId id) {
            for (const Group &g : bench.editor.document().painting()->groups)
                if (g.id == id)
                    return g;
            return Group();
        };
        // Rows: 5, Trees(4, Leaves(3, 2)), Sky(1). Sky goes into Trees, on its top, and stays a group.
        drop(model.index(2, 0), 0, model.index(1, 0));
        QCOMPARE(bench.steps(), 1);
        QCOMPARE(group(3).parent, GroupId(1));
        QCOMPARE(bench.stroke(1).group, GroupId(3));
        QCOMPARE(orderOf(bench.editor), (std::vector<StrokeId>{2, 3, 4, 1, 5}));
        QVERIFY(problemOf(*bench.editor.document().painting()).isEmpty());
        // A group into itself, or into what is in it: no.
        drop(model.index(1, 0), 0, model.index(2, 0, model.index(1, 0)));
        QCOMPARE(bench.steps(), 1);
        // Leaves come out to the bottom.
        drop(model.index(2, 0, model.index(1, 0)), 2, {});
        QCOMPARE(group(2).parent, GroupId(0));
        QCOMPARE(bench.stroke(2).group, GroupId(2));
        QVERIFY(problemOf(*bench.editor.document().painting()).isEmpty());
        QCOMPARE(model.rowCount(), 3);
        bench.editor.undoStack().setIndex(0);
        QVERIFY(*bench.editor.document().painting() == *painting);
        // A locked stroke stays where it is.
        bench.editor.push(changeStrokes(bench.editor.document(), {5}, [](Stroke &s) { s.locked = true; }), "lock");
        drop(model.indexOf(5), 3, {});
        QCOMPARE(bench.steps(), 1);
    }

    /// A row that is dropped into an open group is seen there.
    void openGroupsStayOpen()
    {
        Bench bench(0);
        auto painting = std::make_shared<Painting>();
        painting->groups = {{1, "Trees", 0, true, false}, {2, "Sky", 0, true, false}};
        for (const auto &[id, group] : {std::pair<StrokeId, GroupId>{1, 2}, {2, 2}, {3, 1}, {4, 1}, {5, 0}}) {
            Stroke stroke = *makeStroke(id, 1, 5);
            stroke.group = group;
            painting->strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        bench.editor.document().reset(painting);
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 300});
        const auto isOpen = [&](int row) { return panel.view()->isExpanded(panel.view()->model()->index(row, 0)); };
        panel.view()->expand(panel.view()->model()->index(1, 0)); // rows: 5, Trees, Sky
        StrokesModel &model = *panel.model();
        const std::unique_ptr<QMimeData> data(model.mimeData({model.indexOf(5)}));
        model.dropMimeData(data.get(), Qt::MoveAction, 1, 0, model.index(1, 0));
        QCOMPARE(bench.stroke(5).group, GroupId(1));
        QVERIFY(isOpen(0) && !isOpen(1)); // rows: Trees, Sky
        QVERIFY(panel.view()->visualRect(panel.viewIndexOf(5)).isValid());
        bench.editor.undoStack().undo();
        QVERIFY(isOpen(1) && !isOpen(2));
    }

    /// What is dropped on a closed group is selected, and is seen in it: the group opens, and those around it.
    void aDropOpensItsGroup()
    {
        Bench bench(0);
        auto painting = std::make_shared<Painting>();
        painting->groups = {{1, "Trees", 0, true, false}, {2, "Leaves", 1, true, false}, {3, "Sky", 0, true, false}};
        for (const auto &[id, group] : {std::pair<StrokeId, GroupId>{1, 3}, {2, 2}, {3, 2}, {4, 1}, {5, 0}}) {
            Stroke stroke = *makeStroke(id, 1, 5);
            stroke.group = group;
            painting->strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        bench.editor.document().reset(painting);
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 300});
        StrokesModel &model = *panel.model();
        bench.select({5});
        const auto drop = [&](const QModelIndex &on) {
            const std::unique_ptr<QMimeData> data(model.mimeData({model.indexOf(5)}));
            model.dropMimeData(data.get(), Qt::MoveAction, -1, -1, on);
        };
        drop(model.index(0, 0, model.index(1, 0)).siblingAtRow(1)); // Leaves, within Trees
        QCOMPARE(bench.stroke(5).group, GroupId(2));
        QVERIFY(panel.view()->visualRect(panel.viewIndexOf(5)).isValid());
        QVERIFY(panel.view()->visualRect(panel.viewIndexOf(4)).isValid());
        QVERIFY(!panel.view()->visualRect(panel.viewIndexOf(1)).isValid()); // Sky stays closed
    }

    /// A press selects a group's strokes before it is known that a drag begins. Whatever was selected before, the group
    /// moves as a group; a stroke alone in its group comes out of it.
    void pressedGroupsMoveAsGroups()
    {
        Bench bench(0);
        auto painting = std::make_shared<Painting>();
        painting->groups = {{1, "Trees", 0, true, false}, {2, "Sky", 0, true, false}};
        for (const auto &[id, group] : {std::pair<StrokeId, GroupId>{1, 2}, {2, 1}, {3, 1}, {4, 0}}) {
            Stroke stroke = *makeStroke(id, 1, 5);
            stroke.group = group;
            painting->strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        bench.editor.document().reset(painting);
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 300});
        StrokesView &view = *qobject_cast<StrokesView *>(panel.view());
        const auto row = [&](int at, const QModelIndex &parent = {}) { return view.model()->index(at, 0, parent); };
        const auto click = [&](const QModelIndex &index, Qt::KeyboardModifiers keys = {}) {
            QTest::mouseClick(view.viewport(), Qt::LeftButton, keys, view.visualRect(index).center());
        };
        /// What a drag that begins now takes.
        const auto dragged = [&] {
            view.selectWholeGroups();
            const std::unique_ptr<QMimeData> data(view.model()->mimeData(view.selectionModel()->selectedIndexes()));
            return DraggedRows::fromBytes(data->data(panel.model()->mimeTypes().constFirst()), panel.model()).value();
        };
        // Rows: 4, Trees(3, 2), Sky(1).
        for (const QList<int> &before : {QList<int>(), {0}, {2}, {0, 2}, {1}}) {
            bench.select({});
            for (const int at : before)
                click(row(at), Qt::ControlModifier);
            QTest::mousePress(view.viewport(), Qt::LeftButton, {}, view.visualRect(row(1)).center());
            if (!before.contains(1)) {
                QCOMPARE(dragged().groups, std::set<GroupId>{1});
                QCOMPARE(dragged().strokes, (std::set<StrokeId>{2, 3}));
            }
            QTest::mouseRelease(view.viewport(), Qt::LeftButton, {}, view.visualRect(row(1)).center());
            QCOMPARE(dragged().groups, std::set<GroupId>{1});
        }
        click(row(2), Qt::ControlModifier);
        QCOMPARE(dragged().groups, (std::set<GroupId>{1, 2}));
        // Two groups that look selected are pressed, and move together; a second press on one of them with Ctrl leaves
        // the other.
        bench.select({1, 2, 3});
        QTest::mousePress(view.viewport(), Qt::LeftButton, {}, view.visualRect(row(1)).center());
        QCOMPARE(dragged().groups, (std::set<GroupId>{1, 2}));
        QTest::mouseRelease(view.viewport(), Qt::LeftButton, {}, view.visualRect(row(1)).center());
        QCOMPARE(bench.editor.selection().strokes, (std::set<StrokeId>{2, 3}));
        bench.select({1, 2, 3});
        click(row(1), Qt::ControlModifier);
        QCOMPARE(bench.editor.selection().strokes, std::set<StrokeId>{1});
        view.expand(row(2));
        click(row(0, row(2)));
        QCOMPARE(dragged().groups, std::set<GroupId>());
        QCOMPARE(dragged().strokes, std::set<StrokeId>{1});
        QCOMPARE(bench.steps(), 0);
    }

    /// Alt with Up and Down moves rows by one, into groups that are open and out of theirs, and the frame goes with
    /// them.
    void keysMoveRows()
    {
        Bench bench(0);
        auto painting = std::make_shared<Painting>();
        painting->groups = {{1, "Trees", 0, true, false}, {2, "Sky", 0, true, false}};
        for (const auto &[id, group] : {std::pair<StrokeId, GroupId>{1, 2}, {2, 1}, {3, 1}, {4, 0}, {5, 0}}) {
            Stroke stroke = *makeStroke(id, 1, 5);
            stroke.group = group;
            painting->strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        bench.editor.document().reset(painting);
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 300});
        QTreeView &view = *panel.view();
        QSignalSpy said(&panel, &StrokesPanel::said);
        const auto press = [&](Qt::Key key) { QTest::keyClick(&view, key, Qt::AltModifier); };
        const auto rows = [&] { // from the top, with the group of each
            QString text;
            const auto look = [&](const QModelIndex &parent, const auto &again) -> void {
                for (int row = 0; row < view.model()->rowCount(parent); ++row) {
                    const QModelIndex index = view.model()->index(row, 0, parent);
                    if (const StrokeId stroke = index.data(StrokesModel::StrokeIdRole).toULongLong()) {
                        text += QString::number(stroke);
                    } else {
                        text += index.data().toString().left(1) + '(';
                        again(index, again);
                        text += ')';
                    }
                }
            };
            look({}, look);
            return text;
        };
        QCOMPARE(rows(), QString("54T(32)S(1)"));
        view.setFocus();
        view.setCurrentIndex(panel.viewIndexOf(5));
        press(Qt::Key_Down);
        QCOMPARE(rows(), QString("45T(32)S(1)"));
        QCOMPARE(view.currentIndex(), panel.viewIndexOf(5));
        QCOMPARE(bench.editor.selection().strokes, std::set<StrokeId>{5});
        press(Qt::Key_Down); // past a closed group
        QCOMPARE(rows(), QString("4T(32)5S(1)"));
        press(Qt::Key_Up);
        QCOMPARE(rows(), QString("45T(32)S(1)"));
        view.expand(panel.viewIndexOf(3).parent());
        for (const char *wanted : {"4T(532)S(1)", "4T(352)S(1)", "4T(325)S(1)", "4T(32)5S(1)"}) {
            press(Qt::Key_Down);
            QCOMPARE(rows(), QString(wanted));
            QCOMPARE(view.currentIndex(), panel.viewIndexOf(5));
            QVERIFY(!view.visualRect(view.currentIndex()).isEmpty());
        }
        QCOMPARE(bench.steps(), 1); // moves that follow each other
        for (const char *wanted : {"4T(325)S(1)", "4T(352)S(1)", "4T(532)S(1)", "45T(32)S(1)", "54T(32)S(1)"}) {
            press(Qt::Key_Up);
            QCOMPARE(rows(), QString(wanted));
        }
        const int steps = bench.steps();
        press(Qt::Key_Up);
        QCOMPARE(int(said.count()), 1);
        QCOMPARE(bench.steps(), steps);
        view.collapseAll();
        view.setCurrentIndex(panel.viewIndexOf(3).parent()); // a group goes as a whole
        press(Qt::Key_Down);
        QCOMPARE(rows(), QString("54S(1)T(32)"));
        view.expand(panel.viewIndexOf(1).parent());
        press(Qt::Key_Up);
        QCOMPARE(rows(), QString("54S(1T(32))"));
        bench.editor.undo();
        bench.editor.undo();
        QCOMPARE(rows(), QString("54T(32)S(1)"));
        bench.editor.push(setLocked(bench.editor.document(), {5}, true), "lock");
        view.setCurrentIndex(panel.viewIndexOf(5));
        press(Qt::Key_Down);
        QCOMPARE(rows(), QString("54T(32)S(1)"));
        QCOMPARE(int(said.count()), 2);
        panel.search()->setText("Stroke");
        view.setCurrentIndex(panel.viewIndexOf(4));
        press(Qt::Key_Down);
        QCOMPARE(rows(), QString("54T(32)S(1)"));
        QCOMPARE(int(said.count()), 3);
    }
};

QTEST_MAIN(TestDraggedStrokes)
#include "test_dragged_strokes.moc"
