// The rows of the Strokes dock as they are seen.
#include "app/panels/strokes/rows/row_look.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/panels/strokes/thumbnails/stroke_thumbnails.h"
#include "tests/app/panel_bench.h"
#include "undo/edits.h"
#include "undo/layers/group_edits.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTreeView>

#include <algorithm>
#include <map>
#include <random>

using namespace suffuse;

namespace {

/// All rows, a line for each.
QString textOf(const QAbstractItemModel &model, const QModelIndex &parent = {}, int depth = 0)
{
    QString text;
    for (int row = 0; row < model.rowCount(parent) && depth < 9; ++row) {
        const QModelIndex index = model.index(row, 0, parent);
        text += QString(depth, ' ') + index.data().toString() + '\n' + textOf(model, index, depth + 1);
    }
    return text;
}

} // namespace

class TestStrokesView : public QObject {
    Q_OBJECT

private slots:
    void manyRowsThatChangeAreToldTogether()
    {
        Bench bench(300);
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 300});
        bench.editor.document().setSelection({});
        panel.view()->expand(panel.viewIndexOf(299));
        QApplication::processEvents();
        QSignalSpy changes(panel.model(), &QAbstractItemModel::dataChanged);
        const auto *thumbnails = panel.view()->findChild<StrokeThumbnails *>();
        const auto seen = [&] {
            panel.view()->viewport()->grab(); // asks for the thumbnails of the rows in sight
            [&] { QTRY_VERIFY(thumbnails->isIdle()); }();
            return panel.view()->viewport()->grab().toImage();
        };
        const QImage before = seen();
        std::set<StrokeId> odd;
        for (StrokeId id = 1; id <= 300; id += 2)
            odd.insert(id);
        bench.editor.push(changeStrokes(bench.editor.document(), odd, [](Stroke &stroke) { stroke.visible = false; }),
                          "hide");
        QCOMPARE(changes.count(), 1); // of 150 rows, none of their segments
        QApplication::processEvents();
        const QImage hidden = seen();
        QVERIFY(hidden != before);
        bench.editor.undoStack().undo();
        QCOMPARE(seen(), before);
        const auto recolour = [&](std::set<StrokeId> strokes) {
            return changeStrokes(bench.editor.document(), strokes, [](Stroke &stroke) {
                for (Segment &segment : stroke.segments)
                    segment.colour = {1, 0, 0, 1};
            });
        };
        bench.editor.push(recolour({299}), "colour of the segments that are open");
        QVERIFY(seen() != before);
        bench.editor.undoStack().undo();
        QCOMPARE(seen(), before);
    }

    /// However its strokes came to be selected, and whether it is open or not; groups within it, too.
    void aWhollySelectedGroupIsMarked()
    {
        Bench bench(6);
        bench.select({1, 2});
        bench.editor.push(groupSelection(bench.editor.document(), "inner"), "inner group");
        bench.select({1, 2, 3});
        bench.editor.push(groupSelection(bench.editor.document(), "outer"), "outer group");
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 400});
        const auto looksSelected = [&](const QModelIndex &index) {
            QApplication::processEvents();
            const QImage view = panel.view()->viewport()->grab().toImage();
            const QRect row = panel.view()->visualRect(index);
            return view.pixelColor(row.right() - 2, row.top() + 2) ==
                   WeakPalette().of(panel.view()->palette()).color(QPalette::Highlight);
        };
        QModelIndex outermost = panel.viewIndexOf(1).parent();
        QVERIFY(outermost.isValid());
        while (outermost.parent().isValid())
            outermost = outermost.parent();
        for (const bool open : {true, false}) {
            const auto selected = [&](std::set<StrokeId> strokes) {
                bench.select(std::move(strokes));
                panel.view()->setExpanded(outermost, open); // it opens for what is selected
                return looksSelected(outermost);
            };
            QVERIFY(selected({1, 2, 3}));
            QVERIFY(!selected({1, 2}));
            QVERIFY(selected({1, 2, 3, 5}));
            QVERIFY(!selected({5}));
        }
        bench.select({1, 2, 3}); // the row is marked, not selected: its strokes can be taken out one by one
        QVERIFY(!panel.view()->selectionModel()->isSelected(outermost));
        panel.view()->expandToDepth(1);
        panel.view()->collapse(panel.viewIndexOf(3));
        panel.view()->scrollTo(panel.viewIndexOf(3));
        const QRect row = panel.view()->visualRect(panel.viewIndexOf(3));
        QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, Qt::ControlModifier, row.center());
        QCOMPARE(bench.editor.document().selection().strokes, (std::set<StrokeId>{1, 2}));
    }

    /// Whatever is moved into whatever group, the rows are those of rows that are made anew, also during a search.
    void rowsFollowAnyGrouping()
    {
        Bench bench(40);
        std::mt19937 random(7);
        const auto below = [&](std::size_t n) { return std::size_t(random() % n); };
        Edit grouped;
        grouped.groups.emplace();
        for (GroupId id = 1; id <= 8; ++id) {
            Group group;
            group.id = id;
            group.name = QStringLiteral("group %1").arg(id);
            group.parent = id > 4 ? id - 4 : 0;
            grouped.groups->push_back(group);
            // It keeps a stroke, since it would go with its last one.
            Stroke kept = *bench.editor.document().painting()->find(StrokeId(id));
            kept.group = id;
            grouped.strokes.emplace(kept.id, std::make_shared<const Stroke>(std::move(kept)));
        }
        bench.editor.push(std::move(grouped), "groups");
        StrokesPanel panel(bench.editor);
        showAt(panel);
        const QAbstractItemModelTester rows(panel.model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        const QAbstractItemModelTester shown(panel.view()->model(),
                                             QAbstractItemModelTester::FailureReportingMode::QtTest);
        for (int step = 0; step < 120; ++step) {
            const Painting &painting = *bench.editor.document().painting();
            Edit edit;
            std::vector<StrokeId> order = orderOf(bench.editor);
            std::map<StrokeId, GroupId> groupOf;
            for (const StrokePtr &stroke : painting.strokes)
                groupOf[stroke->id] = stroke->group;
            for (std::size_t k = below(6); k-- > 0;)
                if (const StrokeId any = order[below(order.size())]; any > 8)
                    groupOf[any] = GroupId(below(9));
            if (below(3) == 0) {
                edit.groups = painting.groups;
                edit.groups->at(4 + below(4)).parent = GroupId(below(5));
            }
            if (below(4) == 0)
                std::ranges::shuffle(order, random);
            else if (below(2) == 0)
                std::rotate(order.begin(), order.begin() + std::ptrdiff_t(below(order.size())), order.end());
            for (const StrokePtr &stroke : painting.strokes)
                if (groupOf[stroke->id] != stroke->group) {
                    Stroke moved = *stroke;
                    moved.group = groupOf[stroke->id];
                    edit.strokes.emplace(moved.id, std::make_shared<const Stroke>(std::move(moved)));
                }
            edit.order = std::move(order);
            if (step % 30 == 20)
                panel.search()->setText(step % 60 == 20 ? "3" : "group 2");
            if (step % 30 == 0)
                panel.search()->clear();
            bench.editor.push(std::move(edit), "move");
            if (below(5) == 0)
                bench.editor.undo();
            StrokesPanel fresh(bench.editor);
            fresh.search()->setText(panel.search()->text());
            QCOMPARE(textOf(*panel.view()->model()), textOf(*fresh.view()->model()));
        }
    }
};

QTEST_MAIN(TestStrokesView)
#include "test_strokes_view.moc"
