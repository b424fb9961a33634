// The list of strokes: it follows the document by difference, is searched, and changes names in single steps.
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/widgets/habits/entry_field.h"
#include "tests/app/panel_bench.h"
#include "tests/app/shapes.h"
#include "undo/layers/group_edits.h"

#include <QAbstractItemModelTester>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTreeView>
#include <QVBoxLayout>

#include <functional>
#include <map>

using namespace suffuse;

class TestStrokesPanel : public QObject {
    Q_OBJECT

private slots:
    void strokesFollowTheDocument()
    {
        Bench bench;
        StrokesPanel panel(bench.editor);
        QAbstractItemModelTester tester(panel.model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        showAt(panel, {280, 300});
        QCOMPARE(panel.model()->rowCount(), 3);
        QCOMPARE(panel.model()->strokeAt(panel.model()->index(0, 0)), StrokeId(3)); // topmost first
        QSignalSpy resets(panel.model(), &QAbstractItemModel::modelReset);

        bench.select({2});
        QCOMPARE(panel.view()->selectionModel()->selectedRows().size(), 1);
        QVERIFY(panel.view()->selectionModel()->isSelected(panel.viewIndexOf(2)));
        QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, {},
                          panel.view()->visualRect(panel.viewIndexOf(1)).center());
        QCOMPARE(bench.editor.document().selection().strokes, std::set<StrokeId>{1});

        bench.editor.push(
            addStrokes(bench.editor.document(), {makeStroke(bench.editor.document().takeStrokeId(), 2, 5)}, false),
            "add");
        QCOMPARE(panel.model()->rowCount(), 4);
        bench.select({2});
        bench.editor.push(deleteSelection(bench.editor.document()), "delete");
        QCOMPARE(panel.model()->rowCount(), 3);
        QVERIFY(!panel.model()->indexOf(2).isValid());
        bench.editor.undoStack().undo();
        QCOMPARE(panel.model()->rowCount(), 4);
        QCOMPARE(panel.model()->indexOf(2).row(), 2);
        QCOMPARE(bench.editor.document().selection().strokes, std::set<StrokeId>{2});
        bench.editor.push(arrangeSelection(bench.editor.document(), Arrange::Top), "top");
        QCOMPARE(panel.model()->indexOf(2).row(), 0);
        QVERIFY(panel.view()->selectionModel()->isSelected(panel.viewIndexOf(2)));
        QCOMPARE(resets.count(), 0);
    }

    /// F2 renames what looks selected, also where no row or a hidden one is current, as after a drag or a duplicate.
    void theRenamedRowIsSelectedAndSeen()
    {
        Bench bench;
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 300});
        bench.select({1, 2});
        bench.editor.push(groupSelection(bench.editor.document(), "Group"), "group");
        QTreeView &view = *panel.view();
        for (const bool hidden : {false, true}) {
            view.collapseAll();
            view.selectionModel()->setCurrentIndex(hidden ? panel.viewIndexOf(1) : QModelIndex(),
                                                   QItemSelectionModel::NoUpdate);
            view.collapseAll();
            view.setFocus();
            QTest::keyClick(&view, Qt::Key_F2);
            QLineEdit *editor = nullptr;
            QTRY_VERIFY((editor = view.viewport()->findChild<QLineEdit *>()));
            QTest::keyClicks(editor, hidden ? "Hill" : "Sky");
            QTest::keyClick(editor, Qt::Key_Return);
            QCOMPARE(bench.editor.document().painting()->groups.at(0).name, QString(hidden ? "Hill" : "Sky"));
            QTRY_VERIFY(!view.viewport()->findChild<QLineEdit *>());
        }
    }

    /// However a name that is typed is ended, it is taken once, and Qt has nothing to complain of.
    void aNameThatIsTypedIsTakenOnce()
    {
        QTest::failOnWarning(QRegularExpression("does not belong to this view"));
        Bench bench;
        QWidget window;
        auto *column = new QVBoxLayout(&window);
        auto *panel = new StrokesPanel(bench.editor);
        auto *elsewhere = new QLineEdit;
        column->addWidget(panel);
        column->addWidget(elsewhere);
        showAt(window, {280, 400});
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QTreeView &view = *panel->view();
        const std::map<QString, std::function<void(QLineEdit &)>> ends{
            {"click", [&](QLineEdit &) { elsewhere->setFocus(Qt::MouseFocusReason); }},
            {"return", [](QLineEdit &field) { QTest::keyClick(&field, Qt::Key_Return); }},
            {"", [](QLineEdit &field) { QTest::keyClick(&field, Qt::Key_Return); }}, // takes the name away
            {"save", [&](QLineEdit &) { EntryField::takeTypedIn(window); }}};
        bench.editor.push(changeStrokes(bench.editor.document(), {2}, [](Stroke &s) { s.name = "before"; }), "name");
        int steps = 1;
        for (const auto &[name, end] : ends) {
            bench.select({2});
            view.setFocus();
            view.setCurrentIndex(panel->viewIndexOf(2));
            QTest::keyClick(&view, Qt::Key_F2);
            QLineEdit *field = nullptr;
            QTRY_VERIFY((field = view.viewport()->findChild<QLineEdit *>()));
            QTRY_VERIFY(field->hasFocus());
            QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
            QTest::keyClick(field, Qt::Key_Delete);
            QTest::keyClicks(field, name);
            end(*field);
            QTRY_COMPARE(bench.stroke(2).name, name);
            QTRY_VERIFY(!view.viewport()->findChild<QLineEdit *>());
            QCOMPARE(bench.steps(), ++steps);
        }
        // Esc takes back what was typed.
        view.setFocus();
        view.setCurrentIndex(panel->viewIndexOf(2));
        QTest::keyClick(&view, Qt::Key_F2);
        QLineEdit *field = nullptr;
        QTRY_VERIFY((field = view.viewport()->findChild<QLineEdit *>()));
        QTest::keyClicks(field, "given up");
        QTest::keyClick(field, Qt::Key_Escape);
        QTRY_VERIFY(!view.viewport()->findChild<QLineEdit *>());
        QCOMPARE(bench.steps(), steps);
    }

    /// A name that is being typed counts before what a shortcut does, like a number.
    void aTypedNameIsTakenByShortcuts()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto *dock = s.window.findChild<QDockWidget *>("strokesDock");
        dock->show();
        dock->raise();
        auto *panel = s.window.findChild<StrokesPanel *>();
        QTRY_VERIFY(!panel->visibleRegion().isEmpty());
        const auto type = [&](const QString &text) {
            panel->view()->setFocus();
            panel->view()->setCurrentIndex(panel->viewIndexOf(s.id));
            panel->view()->edit(panel->viewIndexOf(s.id));
            auto *field = qobject_cast<QLineEdit *>(QApplication::focusWidget());
            QVERIFY(field);
            field->selectAll();
            QTest::keyClicks(field, text);
        };
        const int steps = s.steps();
        type("Sky");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QTRY_COMPARE(s.stroke().name, QString("Sky"));
        type("Sun");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QTRY_VERIFY(!qobject_cast<QLineEdit *>(QApplication::focusWidget()));
        QCOMPARE(s.stroke().name, QString("Sky"));
        type("Sea");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(s.stroke().name, QString("Sea"));
        QCOMPARE(s.painting().strokes.back()->name, QString("Sea")); // it was duplicated after that
        QCOMPARE(s.steps(), steps + 3);
    }

    void groupsAreRenamedInPlace()
    {
        Bench bench;
        bench.select({2, 3});
        bench.editor.push(groupSelection(bench.editor.document(), {}), "group");
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 300});
        const QModelIndex row = panel.view()->model()->index(0, 0);
        QCOMPARE(row.data().toString(), QString("Group 1"));
        QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, {}, panel.view()->visualRect(row).center());
        QTest::mouseDClick(panel.view()->viewport(), Qt::LeftButton, {}, panel.view()->visualRect(row).center());
        QLineEdit *editor = nullptr;
        QTRY_VERIFY((editor = panel.view()->viewport()->findChild<QLineEdit *>()));
        QCOMPARE(editor->placeholderText(), QString("Group 1")); // it has no name of its own yet
        editor->setText("Trees");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(bench.editor.document().painting()->groups[0].name, QString("Trees"));
        QCOMPARE(row.data().toString(), QString("Trees"));
        QCOMPARE(bench.editor.undoStack().undoText(), QString("Rename group"));
        bench.editor.undoStack().undo();
        QCOMPARE(bench.editor.document().painting()->groups[0].name, QString());
    }

    /// Strokes 1 "sea", group a of 2 "tree", 3 "sea" and 4 "tree" (locked), and 5 "tree"; the group is closed.
    static void fillWithTrees(Bench &bench)
    {
        auto painting = std::make_shared<Painting>();
        painting->groups = {{1, "a", 0, true, false}};
        for (StrokeId id = 1; id <= 5; ++id) {
            auto stroke = std::make_shared<Stroke>(*makeStroke(id, 2, 10));
            stroke->name = id % 2 == 0 || id == 5 ? "tree" : "sea";
            stroke->group = id >= 2 && id <= 4 ? 1 : 0;
            stroke->locked = id == 4;
            painting->strokes.push_back(std::move(stroke));
        }
        bench.editor.document().reset(painting);
    }

    void whatIsFoundIsSeenAndSelected()
    {
        Bench bench;
        fillWithTrees(bench);
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 400});
        const auto selected = [&] { return bench.editor.document().selection().strokes; };
        const auto rowOf = [&](StrokeId id) { return panel.view()->visualRect(panel.viewIndexOf(id)); };
        const QModelIndex group = panel.model()->indexOf(2).parent();
        QVERIFY(!panel.view()->isExpanded(panel.viewIndexOf(2).parent()));
        panel.selectFound(); // nothing is searched for
        QVERIFY(selected().empty());
        panel.search()->setText("tree");
        QVERIFY(panel.isSearching());
        QVERIFY(panel.view()->isExpanded(panel.viewIndexOf(2).parent()));
        QVERIFY(!rowOf(2).isEmpty() && !rowOf(4).isEmpty() && !rowOf(5).isEmpty());
        QVERIFY(!panel.viewIndexOf(3).isValid());
        QTest::keyClick(panel.search(), Qt::Key_Return);
        QCOMPARE(selected(), (std::set<StrokeId>{2, 5})); // 4 is locked
        // The group's row stands for what is found in it.
        QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, {},
                          panel.view()->visualRect(panel.viewIndexOf(2).parent()).center());
        QCOMPARE(selected(), (std::set<StrokeId>{2, 4}));
        panel.search()->setText("zzz"); // Nothing is found, and what is selected stays.
        QTest::keyClick(panel.search(), Qt::Key_Return);
        QCOMPARE(selected(), (std::set<StrokeId>{2, 4}));
        QTest::keyClick(panel.search(), Qt::Key_Escape);
        QVERIFY(!panel.isSearching() && panel.search()->text().isEmpty());
        QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
        QApplication::sendEvent(panel.search(), &escape);
        // The second one leaves the field.
        QVERIFY(!escape.isAccepted());
        QVERIFY(!panel.view()->isExpanded(panel.viewIndexOf(2).parent())); // as it was
        QVERIFY(group.isValid());
        panel.search()->setText("a"); // the group itself, and 1 and 3 of "sea"
        QVERIFY(panel.view()->isExpanded(panel.viewIndexOf(3).parent()));
        QVERIFY(panel.viewIndexOf(2).isValid()); // all in a group that is found
    }

    /// The row with the frame is renamed, also a group's of which only a part is found; and where the new name is not
    /// found, what has nothing else to show goes, and the frame goes to the neighbour.
    void whatIsFoundIsRenamed()
    {
        Bench bench;
        fillWithTrees(bench);
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 400});
        QTreeView &view = *panel.view();
        const auto rename = [&](const QString &name) {
            QTest::keyClick(&view, Qt::Key_F2);
            QLineEdit *editor = nullptr;
            QTRY_VERIFY((editor = view.viewport()->findChild<QLineEdit *>()));
            editor->selectAll();
            QTest::keyClicks(editor, name);
            QTest::keyClick(editor, Qt::Key_Return);
            QTRY_VERIFY(!view.viewport()->findChild<QLineEdit *>());
        };
        bench.editor.push(changeStrokes(bench.editor.document(), {2}, [](Stroke &s) { s.name = "trunk"; }), "name");
        panel.search()->setText("tr"); // 5, the group with 4 and 2
        view.setFocus();
        view.setCurrentIndex(panel.viewIndexOf(2).parent());
        QCOMPARE(bench.editor.document().selection().strokes, (std::set<StrokeId>{2, 4}));
        rename("wood");
        QCOMPARE(bench.editor.document().painting()->groups.at(0).name, QString("wood"));
        QCOMPARE(bench.stroke(4).name, QString("tree"));

        panel.search()->setText("trunk"); // the group with 2 alone
        QVERIFY(!panel.viewIndexOf(5).isValid() && panel.viewIndexOf(2).isValid());
        bench.editor.push(changeStrokes(bench.editor.document(), {1}, [](Stroke &s) { s.name = "trunks"; }), "name");
        QTRY_VERIFY(panel.viewIndexOf(1).isValid());
        view.setCurrentIndex(panel.viewIndexOf(2));
        rename("bark");
        QCOMPARE(bench.stroke(2).name, QString("bark"));
        QTRY_COMPARE(view.model()->rowCount(), 1); // 1 alone, without the group
        QTRY_COMPARE(view.currentIndex(), panel.viewIndexOf(1));
    }

    void aRangeTakesRowsNotGroups()
    {
        Bench bench;
        fillWithTrees(bench);
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 400});
        const QModelIndex group = panel.viewIndexOf(2).parent();
        panel.view()->expand(group);
        const auto click = [&](const QModelIndex &index, Qt::KeyboardModifiers modifiers = {}) {
            QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, modifiers,
                              panel.view()->visualRect(index).center());
            return bench.editor.document().selection().strokes;
        };
        click(panel.viewIndexOf(5)); // rows 5, a, 4, 3, 2, 1
        QCOMPARE(click(panel.viewIndexOf(3), Qt::ShiftModifier), (std::set<StrokeId>{3, 4, 5}));
        QVERIFY(!panel.view()->selectionModel()->isSelected(group));
        QCOMPARE(click(panel.viewIndexOf(1), Qt::ShiftModifier), (std::set<StrokeId>{1, 2, 3, 4, 5}));
        click(panel.viewIndexOf(5));
        QCOMPARE(click(group, Qt::ShiftModifier), (std::set<StrokeId>{2, 3, 4, 5})); // it is the end of the range
        QCOMPARE(click(group), (std::set<StrokeId>{2, 3, 4}));
        panel.view()->collapse(group);
        click(panel.viewIndexOf(5));
        QCOMPARE(click(panel.viewIndexOf(1), Qt::ShiftModifier), (std::set<StrokeId>{1, 2, 3, 4, 5}));
    }

    void contextMenu()
    {
        Bench bench;
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 400});
        bench.select({1, 3});
        const auto trigger = [&](const char *text) {
            QMenu menu;
            panel.fillMenu(menu, panel.viewIndexOf(3));
            for (QAction *action : menu.actions())
                if (action->text().remove('&') == text && action->isEnabled())
                    action->trigger();
        };
        trigger("Lock");
        QVERIFY(bench.stroke(1).locked && bench.stroke(3).locked && !bench.stroke(2).locked);
        QCOMPARE(bench.steps(), 1);
        trigger("Delete"); // all that is selected is locked
        QCOMPARE(bench.steps(), 1);
        trigger("Unlock");
        trigger("Hide");
        QVERIFY(!bench.stroke(1).visible && !bench.stroke(3).visible);
        QVERIFY(bench.editor.document().selection().isEmpty());
        bench.select({1, 3});
        trigger("Show");
        QCOMPARE(bench.steps(), 4);
        trigger("Delete");
        QCOMPARE(orderOf(bench.editor), std::vector<StrokeId>{2});
    }

    /// What Edit and Object have for strokes is where they are listed as well.
    void theMenuHasTheCommandsOfTheWindow()
    {
        WaveSession s;
        auto *panel = s.window.findChild<StrokesPanel *>();
        QMenu menu;
        panel->fillMenu(menu, panel->viewIndexOf(1));
        for (const Command command : {Command::Duplicate, Command::GroupStrokes, Command::UngroupStrokes})
            QVERIFY(menu.actions().contains(&s.window.action(command)));
        const QList<QAction *> rows = menu.actions();
        QVERIFY(std::any_of(rows.begin(), rows.end(), [&](const QAction *row) {
            return row->menu() && row->menu()->actions().contains(&s.window.action(Command::Top));
        }));
    }

    void manyRowsWithoutResets()
    {
        Bench bench(10000);
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 300});
        QSignalSpy resets(panel.model(), &QAbstractItemModel::modelReset);
        QSignalSpy data(panel.model(), &QAbstractItemModel::dataChanged);
        for (int i = 1; i <= 20; ++i) {
            bench.select({StrokeId(i * 400)});
            bench.editor.push(changeStrokes(bench.editor.document(), {StrokeId(i * 400)},
                                            [i](Stroke &s) { s.name = QString::number(i); }),
                              "name");
        }
        QCOMPARE(resets.count(), 0);
        QCOMPARE(data.count(), 20);
        panel.view()->selectAll();
        QCOMPARE(bench.editor.document().selection().strokes.size(), std::size_t(10000));
        bench.editor.push(deleteSelection(bench.editor.document()), "delete");
        QCOMPARE(panel.model()->rowCount(), 0);
        QCOMPARE(resets.count(), 0);
    }

    /// Prints how long a large painting takes; it asserts what is shown.
    void hundredThousandSegments()
    {
        for (const int perStroke : {1, 20}) {
            Bench bench(0);
            auto painting = std::make_shared<Painting>();
            for (int i = 1; i <= 100'000 / perStroke; ++i)
                painting->strokes.push_back(makeStroke(StrokeId(i), perStroke, 5));
            bench.editor.document().reset(painting);
            QElapsedTimer timer;
            timer.start();
            StrokesPanel panel(bench.editor);
            panel.resize(280, 600);
            panel.show();
            panel.grab();
            const double open = double(timer.nsecsElapsed()) / 1e6;
            timer.restart();
            constexpr int positions = 100;
            QScrollBar *bar = panel.view()->verticalScrollBar();
            for (int i = 0; i < positions; ++i) {
                bar->setValue(bar->maximum() * i / positions);
                panel.view()->viewport()->grab();
            }
            const double scroll = double(timer.nsecsElapsed()) / 1e6 / positions;
            timer.restart();
            bench.select({StrokeId(50'000 / perStroke)});
            const double select = double(timer.nsecsElapsed()) / 1e6;
            timer.restart();
            bench.editor.push(changeSegments(bench.editor.document(), targetSegments(bench.editor.document()),
                                             [](Segment &s) { s.density = 3; }),
                              "change");
            const double change = double(timer.nsecsElapsed()) / 1e6;
            timer.restart();
            panel.search()->setText("77");
            const double search = double(timer.nsecsElapsed()) / 1e6;
            qInfo("%d segments a stroke: open %.1f ms, scroll %.2f ms, select %.2f ms, change %.2f ms, search %.1f ms",
                  perStroke, open, scroll, select, change, search);
            QVERIFY(panel.view()->model()->rowCount() > 0 && panel.view()->model()->rowCount() < 100'000 / perStroke);
            panel.search()->clear();
            QCOMPARE(panel.view()->model()->rowCount(), 100'000 / perStroke);
            QVERIFY(panel.view()->selectionModel()->isSelected(panel.viewIndexOf(StrokeId(50'000 / perStroke))));
        }
    }

    void aSearchWithoutHitsSaysSo()
    {
        Bench bench;
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 400});
        const auto said = [&panel] {
            for (const QLabel *label : panel.findChildren<QLabel *>())
                if (label->isVisible() && label->objectName() != "layer")
                    return label->text();
            return QString();
        };
        QCOMPARE(said(), QString());
        panel.search()->setText("zebra");
        QCOMPARE(said(), QString("No stroke is called “zebra”."));
        bench.editor.push(changeStrokes(bench.editor.document(), {1}, [](Stroke &s) { s.name = "A zebra"; }), "name");
        bench.editor.laterChanges().flush();
        QCOMPARE(said(), QString());
        bench.editor.undoStack().undo();
        bench.editor.laterChanges().flush();
        QCOMPARE(said(), QString("No stroke is called “zebra”."));
        panel.search()->clear();
        QCOMPARE(said(), QString());
    }
};

QTEST_MAIN(TestStrokesPanel)
#include "test_strokes_panel.moc"
