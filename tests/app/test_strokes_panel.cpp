// The lists of strokes and history: they follow the document by difference and change it in single steps.
#include "app/panels/history_panel.h"
#include "app/panels/strokes_model.h"
#include "app/panels/strokes_panel.h"
#include "tests/app/panel_bench.h"
#include "undo/edits.h"

#include <QAbstractItemModelTester>
#include <QMimeData>
#include <QSignalSpy>
#include <QTreeView>
#include <QUndoView>

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

    void eyesLocksAndNames()
    {
        Bench bench;
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 300});
        bench.select({3});
        const auto click = [&](StrokeId id, int column) {
            const QModelIndex index = panel.viewIndexOf(id).siblingAtColumn(column);
            QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, {}, panel.view()->visualRect(index).center());
        };
        click(2, StrokesModel::EyeColumn);
        QVERIFY(!bench.stroke(2).visible);
        click(2, StrokesModel::LockColumn);
        QVERIFY(bench.stroke(2).locked);
        click(2, StrokesModel::LockColumn); // a locked stroke can be unlocked
        QVERIFY(!bench.stroke(2).locked);
        QCOMPARE(bench.steps(), 3);
        QCOMPARE(bench.editor.document().selection().strokes, std::set<StrokeId>{3});
        const QModelIndex row = panel.model()->indexOf(1);
        QVERIFY(row.data(Qt::FontRole).value<QFont>().italic());
        QVERIFY(panel.model()->setData(row, "Cloud"));
        QCOMPARE(bench.stroke(1).name, QString("Cloud"));
        QVERIFY(!row.data(Qt::FontRole).isValid());
        panel.search()->setText("clou");
        QCOMPARE(panel.view()->model()->rowCount(), 1);
        QCOMPARE(bench.editor.document().selection().strokes, std::set<StrokeId>{3}); // hidden, still selected
        panel.search()->clear();
        QCOMPARE(panel.view()->model()->rowCount(), 3);
    }

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

    void historyGoesThere()
    {
        Bench bench;
        HistoryPanel panel(bench.editor);
        showAt(panel, {280, 200});
        for (const char *name : {"one", "two"})
            bench.editor.push(changeStrokes(bench.editor.document(), {1}, [&](Stroke &s) { s.name = name; }), name);
        QCOMPARE(panel.view()->model()->rowCount(), 3);
        panel.view()->setCurrentIndex(panel.view()->model()->index(1, 0));
        QCOMPARE(bench.stroke(1).name, QString("one"));
    }
};

QTEST_MAIN(TestStrokesPanel)
#include "test_strokes_panel.moc"
