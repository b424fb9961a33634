// What the rows of the list of strokes show: eyes and locks, parts, segments, and small pictures.
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/panels/strokes/strokes_view.h"
#include "app/panels/strokes/thumbnails/group_thumbnails.h"
#include "app/panels/strokes/thumbnails/stroke_thumbnails.h"
#include "tests/app/panel_bench.h"
#include "undo/layers/group_edits.h"

#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTreeView>

using namespace suffuse;

class TestStrokeRows : public QObject {
    Q_OBJECT

private slots:
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
        QVERIFY(row.data(StrokesModel::UnnamedRole).toBool());
        QVERIFY(panel.model()->setData(row, "Cloud"));
        QCOMPARE(bench.stroke(1).name, QString("Cloud"));
        QVERIFY(!row.data(StrokesModel::UnnamedRole).toBool());
        panel.search()->setText("clou");
        QCOMPARE(panel.view()->model()->rowCount(), 1);
        QCOMPARE(bench.editor.document().selection().strokes, std::set<StrokeId>{3}); // hidden, still selected
        panel.search()->clear();
        QCOMPARE(panel.view()->model()->rowCount(), 3);
    }

    /// No key moves or deletes unseen what an eye has hidden.
    void whatAnEyeHidesIsDeselected()
    {
        Bench bench;
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 300});
        bench.select({2, 3});
        const QModelIndex eye = panel.viewIndexOf(3).siblingAtColumn(StrokesModel::EyeColumn);
        QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, {}, panel.view()->visualRect(eye).center());
        QVERIFY(!bench.stroke(3).visible);
        QCOMPARE(bench.editor.document().selection().strokes, std::set<StrokeId>{2});
        QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, {}, panel.view()->visualRect(eye).center());
        QVERIFY(bench.stroke(3).visible);
        QCOMPARE(bench.editor.document().selection().strokes, std::set<StrokeId>{2});
    }

    /// A press on an eye that is drawn on over other rows hides them as well, in one step. It is no drag of a row and
    /// selects nothing, and what is hidden already stays so.
    void eyesAndLocksAreSwept()
    {
        Bench bench(5); // rows 5 4 3 2 1
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 400});
        bench.select({5});
        bench.editor.push(setVisible(bench.editor.document(), {3}, false), "hide");
        const auto at = [&](StrokeId id, int column) {
            return panel.view()->visualRect(panel.viewIndexOf(id).siblingAtColumn(column)).center();
        };
        QWidget &viewport = *panel.view()->viewport();
        const auto draw = [&](int column, Qt::MouseButtons buttons) {
            QTest::mousePress(&viewport, Qt::LeftButton, {}, at(5, column));
            for (const StrokeId id : {4, 3, 2}) {
                const QPointF p(at(id, id == 3 ? int(StrokesModel::NameColumn) : column)); // a hand is not that steady
                QMouseEvent event(QEvent::MouseMove, p, viewport.mapToGlobal(p), Qt::NoButton, buttons, {});
                QCoreApplication::sendEvent(&viewport, &event);
            }
            QTest::mouseRelease(&viewport, Qt::LeftButton, {}, at(2, column));
        };
        draw(StrokesModel::EyeColumn, Qt::LeftButton);
        for (const StrokeId id : {5, 4, 3, 2})
            QVERIFY(!bench.stroke(id).visible);
        QVERIFY(bench.stroke(1).visible);
        QCOMPARE(bench.steps(), 2);
        draw(StrokesModel::LockColumn, Qt::LeftButton);
        for (const StrokeId id : {5, 4, 3, 2})
            QVERIFY(bench.stroke(id).locked);
        QCOMPARE(bench.steps(), 3);
        draw(StrokesModel::EyeColumn, Qt::NoButton); // the release got lost
        QVERIFY(bench.stroke(5).visible && !bench.stroke(4).visible);
        QCOMPARE(bench.steps(), 4);
        QCOMPARE(orderOf(bench.editor), (std::vector<StrokeId>{1, 2, 3, 4, 5}));
        QVERIFY(bench.editor.document().selection().isEmpty()); // what is hidden is not selected
    }

    /// A group's own row says what is hidden or locked in it, and a click on it undoes that where it is all of it.
    void groupsTellWhatIsHiddenAndLockedInThem()
    {
        Bench bench(0);
        auto painting = std::make_shared<Painting>();
        painting->groups = {{1, "Trees", 0, true, false}, {2, "Leaves", 1, true, false}};
        for (const auto &[id, group] : {std::pair<StrokeId, GroupId>{1, 0}, {2, 2}, {3, 2}, {4, 1}}) {
            Stroke stroke = *makeStroke(id, 1, 5);
            stroke.group = group;
            painting->strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        bench.editor.document().reset(painting);
        StrokesModel model(bench.editor);
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QSignalSpy data(&model, &QAbstractItemModel::dataChanged);
        const auto announced = [&](const QModelIndex &row) {
            const bool is = std::any_of(data.begin(), data.end(), [&](const QList<QVariant> &change) {
                const auto from = change[0].toModelIndex(), to = change[1].toModelIndex();
                return from.parent() == row.parent() && from.row() <= row.row() && to.row() >= row.row();
            });
            return is;
        };
        // Rows: Trees(4, Leaves(3, 2)), 1.
        const auto trees = [&](int column) { return model.index(0, column); };
        const auto leaves = [&](int column) { return model.index(1, column, model.index(0, 0)); };
        constexpr int eye = StrokesModel::EyeColumn, lock = StrokesModel::LockColumn;
        const auto isOn = [](const QModelIndex &cell) { return cell.data(StrokesModel::SwitchRole).toBool(); };
        const auto isPart = [](const QModelIndex &cell) { return cell.data(StrokesModel::PartRole).toBool(); };
        const QString visibleTip = trees(eye).data(Qt::ToolTipRole).toString();
        QVERIFY(isOn(trees(eye)) && !isPart(trees(eye)) && !isOn(trees(lock)) && !isPart(trees(lock)));

        bench.editor.push(setVisible(bench.editor.document(), {2}, false), "hide");
        QVERIFY(announced(trees(eye)) && announced(leaves(eye)));
        QVERIFY(isOn(leaves(eye)) && isPart(leaves(eye)) && isOn(trees(eye)) && isPart(trees(eye)));
        QVERIFY(trees(eye).data(Qt::ToolTipRole).toString() != visibleTip);
        QVERIFY(!isPart(trees(lock)));
        data.clear();
        bench.editor.push(setVisible(bench.editor.document(), {3}, false), "hide");
        QVERIFY(announced(leaves(eye)));
        QVERIFY(!isOn(leaves(eye)) && !isPart(leaves(eye)) && isOn(trees(eye)) && isPart(trees(eye)));
        // What is said does not change: no row of a group is announced.
        data.clear();
        bench.editor.push(changeStrokes(bench.editor.document(), {2}, [](Stroke &s) { s.name = "two"; }), "name");
        QVERIFY(!announced(trees(eye)) && !announced(leaves(eye)));

        // A click shows all that is hidden in it, as one step.
        const int steps = bench.steps();
        model.toggle(leaves(eye));
        QCOMPARE(bench.steps(), steps + 1);
        QVERIFY(bench.stroke(2).visible && bench.stroke(3).visible && isOn(leaves(eye)) && !isPart(trees(eye)));
        bench.editor.undoStack().undo();
        QVERIFY(!bench.stroke(2).visible && !isOn(leaves(eye)));
        bench.editor.undoStack().undo(); // stroke 2 has no name
        bench.editor.undoStack().undo(); // stroke 3 is visible
        QVERIFY(isOn(leaves(eye)) && isPart(leaves(eye)));
        // Where it is a part, the click is about the group itself.
        model.toggle(leaves(eye));
        QVERIFY(!bench.editor.document().painting()->groups[1].visible && !isOn(leaves(eye)));
        QVERIFY(isPart(trees(eye))); // stroke 4 is seen

        // A group that is locked counts for all that is in it.
        data.clear();
        bench.editor.push(setGroupLocked(bench.editor.document(), 2, true), "lock");
        QVERIFY(announced(trees(lock)) && announced(leaves(lock)));
        QVERIFY(isOn(leaves(lock)) && isPart(trees(lock)));
        bench.editor.push(setLocked(bench.editor.document(), {4}, true), "lock");
        QVERIFY(isOn(trees(lock)) && !isPart(trees(lock)));
        model.toggle(trees(lock));
        QVERIFY(!bench.stroke(4).locked && !bench.editor.document().painting()->groups[1].locked);
        QVERIFY(!isOn(trees(lock)) && !isPart(trees(lock)) && !isOn(leaves(lock)));
        bench.editor.undoStack().undo();
        QVERIFY(isOn(trees(lock)) && bench.stroke(4).locked);
    }

    /// A stroke of several chains says so in its row and in its tool tip; others say nothing of it.
    void rowsTellOfPiecesAndErasures()
    {
        Bench bench;
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 300});
        const auto saidOf = [&](StrokeId id, int role) { return panel.model()->indexOf(id).data(role).toString(); };
        QVERIFY(saidOf(2, StrokesModel::MakeUpRole).isEmpty());
        const QString before = saidOf(2, Qt::ToolTipRole);
        QVERIFY(!before.contains('\n'));
        const auto row = [&] {
            return panel.view()->viewport()->grab(panel.view()->visualRect(panel.viewIndexOf(2))).toImage();
        };
        const QImage plain = row();
        bench.editor.push(changeStrokes(bench.editor.document(), {2},
                                        [](Stroke &stroke) {
                                            stroke.segments[1].start = true;
                                            stroke.segments[2].start = stroke.segments[2].lift = true;
                                            stroke.segments[3].start = stroke.segments[3].lift = true;
                                        }),
                          "parts");
        QCOMPARE(saidOf(2, StrokesModel::MakeUpRole), QString("2 piece(s), 2 erasure(s)"));
        QCOMPARE(saidOf(2, Qt::ToolTipRole), before + "\n2 piece(s), 2 erasure(s)");
        QVERIFY(saidOf(1, StrokesModel::MakeUpRole).isEmpty());
        const QImage told = row();
        const QRect end(told.width() / 2, 0, told.width() / 4, told.height()); // between the name and the eye
        QVERIFY(plain.copy(end) != told.copy(end));
        bench.editor.undoStack().undo();
        QVERIFY(saidOf(2, StrokesModel::MakeUpRole).isEmpty());
    }

    void segmentsAreRows()
    {
        Bench bench;
        StrokesPanel panel(bench.editor);
        QAbstractItemModelTester tester(panel.model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        showAt(panel, {280, 400});
        const QModelIndex stroke = panel.model()->indexOf(2);
        QCOMPARE(panel.model()->rowCount(stroke), 4);
        panel.view()->expand(panel.viewIndexOf(2));
        const auto rowOf = [&](int segment) {
            return panel.view()->visualRect(panel.view()->model()->index(segment, 0, panel.viewIndexOf(2))).center();
        };
        QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, {}, rowOf(1));
        QCOMPARE(bench.editor.document().selection(), (Selection{{2}, {{2, 1}}}));
        QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, Qt::ShiftModifier, rowOf(3));
        QCOMPARE(bench.editor.document().selection(), (Selection{{2}, {{2, 1}, {2, 2}, {2, 3}}}));
        bench.select({2}, {{2, 0}});
        QVERIFY(panel.view()->selectionModel()->isSelected(panel.view()->model()->index(0, 0, panel.viewIndexOf(2))));
        // Segments come and go with their stroke's values; the search finds strokes, not segments.
        bench.editor.push(changeStrokes(bench.editor.document(), {2}, [](Stroke &s) { s.segments.resize(2); }), "cut");
        QCOMPARE(panel.model()->rowCount(stroke), 2);
        bench.editor.undoStack().undo();
        QCOMPARE(panel.model()->rowCount(stroke), 4);
        panel.search()->setText("Segment");
        QCOMPARE(panel.view()->model()->rowCount(), 0);
        panel.search()->setText("2");
        QCOMPARE(panel.view()->model()->rowCount(), 1);
        QCOMPARE(panel.view()->model()->rowCount(panel.viewIndexOf(2)), 4);
    }

    void thumbnailsAreTheRenderers()
    {
        StrokeThumbnails thumbnails;
        QSignalSpy ready(&thumbnails, &StrokeThumbnails::ready);
        Stroke stroke = *makeStroke(1, 4, 20);
        for (Segment &s : stroke.segments)
            s.density = 30, s.colour = {1, 0, 0, 1};
        const auto red = std::make_shared<const Stroke>(stroke);
        QVERIFY(thumbnails.of(red, 2, true).isNull()); // not asked for
        QVERIFY(!ready.wait(100));
        QVERIFY(thumbnails.of(red, 2, false).isNull());
        QTRY_COMPARE(ready.count(), 1);
        const QImage image = thumbnails.of(red, 2, false);
        QCOMPARE(image.size(), ThumbnailRenderer::size * 2);
        QCOMPARE(image.pixelColor(32, 20).name(), QString("#ff0000"));
        QCOMPARE(image.pixelColor(0, 0).alpha(), 0);
        // Another state of it: the old picture until the new one is there.
        for (Segment &s : stroke.segments)
            s.colour = {0, 0, 1, 1};
        const auto blue = std::make_shared<const Stroke>(stroke);
        QCOMPARE(thumbnails.of(blue, 2, false), image);
        QTRY_COMPARE(ready.count(), 2);
        QCOMPARE(thumbnails.of(blue, 2, false).pixelColor(32, 20).name(), QString("#0000ff"));
    }

    /// A group's picture is what is in it, and is drawn anew where that changes, but not where the group is only put on
    /// what lies below in another way, and never during a gesture.
    void groupsHavePictures()
    {
        Bench bench;
        bench.select({1, 2});
        bench.editor.push(groupSelection(bench.editor.document(), "pair"), "group");
        const GroupId id = bench.editor.document().painting()->groups.at(0).id;
        StrokesTree tree;
        tree.build(bench.editor.document().painting());
        GroupThumbnails thumbnails(tree);
        QSignalSpy ready(&thumbnails, &GroupThumbnails::ready);
        const auto picture = [&](bool quiet = false) { return thumbnails.of(*tree.nodeOfGroup(id), 1, quiet); };
        QVERIFY(picture(true).isNull() && thumbnails.isIdle());
        QVERIFY(picture().isNull() && !thumbnails.isIdle());
        QVERIFY(ready.wait());
        const QImage first = picture();
        QCOMPARE(first.size(), ThumbnailRenderer::size);
        QVERIFY(thumbnails.isIdle());
        const auto change = [&](Edit edit) {
            bench.editor.push(std::move(edit), "change");
            tree.build(bench.editor.document().painting());
        };
        change(setGroupOpacity(bench.editor.document(), {id}, 0.5f));
        QVERIFY(picture() == first && thumbnails.isIdle());
        change(changeStrokes(bench.editor.document(), {2}, [](Stroke &s) {
            for (Segment &segment : s.segments)
                segment.colour = {1, 0, 0, 1};
        }));
        QVERIFY(picture() == first && !thumbnails.isIdle()); // The old one until there is the new one.
        QVERIFY(ready.wait());
        QVERIFY(picture() != first && thumbnails.isIdle());
        change(setVisible(bench.editor.document(), {1, 2}, false));
        picture();
        QVERIFY(ready.wait());
        QVERIFY(picture().isNull() && thumbnails.isIdle()); // There is nothing to be seen.
    }

    /// Marks and opacity stay where a name is long; it is cut short.
    void longNamesGiveWayToMarks()
    {
        Bench bench;
        bench.select({1, 2});
        bench.editor.push(groupSelection(bench.editor.document(), QString(200, 'x')), "group");
        Edit edit;
        edit.groups = bench.editor.document().painting()->groups;
        edit.groups->at(0).clips = edit.groups->at(0).solo = true;
        bench.editor.push(std::move(edit), "marks");
        StrokesPanel panel(bench.editor);
        for (const int width : {200, 280, 500}) {
            showAt(panel, {width, 400});
            const QModelIndex row = panel.viewIndexOf(1).parent();
            const GroupCells cells = static_cast<StrokesView *>(panel.view())->cellsOf(row);
            QVERIFY2(!cells.marks.isEmpty() && cells.opacity.isEmpty() == (width < 240),
                     qPrintable(QString::number(width)));
            QVERIFY(panel.view()->visualRect(row).contains(cells.marks));
            QVERIFY(cells.opacity.isEmpty() || cells.marks.right() < cells.opacity.left());
        }
    }
};

QTEST_MAIN(TestStrokeRows)
#include "test_stroke_rows.moc"
