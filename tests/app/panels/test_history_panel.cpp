// The lists of steps: all of the painting, and those that changed one stroke.
#include "app/panels/history/history_panel.h"
#include "app/panels/history/stroke_history_list.h"
#include "tests/app/panel_bench.h"
#include "undo/layers/group_edits.h"

#include <QLabel>
#include <QScrollBar>
#include <QUndoView>

using namespace suffuse;

class TestHistoryPanel : public QObject {
    Q_OBJECT

private slots:
    /// Also where the dock gets lower.
    void thePresentStepStaysInSight()
    {
        Bench bench;
        HistoryPanel panel(bench.editor);
        showAt(panel, {280, 500});
        for (int i = 0; i < 12; ++i)
            bench.editor.push(
                changeSegments(bench.editor.document(), {{1, 0}}, [i](Segment &s) { s.density = float(20 + i); }),
                QString("step %1").arg(i));
        bench.select({1});
        QTRY_VERIFY(panel.strokeView()->isVisible());
        for (const int height : {300, 150, 430, 200}) {
            panel.resize(280, height);
            QCoreApplication::processEvents();
            for (QAbstractItemView *list : {static_cast<QAbstractItemView *>(panel.view()),
                                            static_cast<QAbstractItemView *>(panel.strokeView())}) {
                QVERIFY(list->currentIndex().isValid());
                QVERIFY2(list->viewport()->rect().contains(list->visualRect(list->currentIndex())),
                         qPrintable(QString("%1 at %2").arg(list->accessibleName()).arg(height)));
            }
        }
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

    /// How dark the darkest pixel of a row is, of those that are grey.
    static int inkOf(QListView &view, int row)
    {
        const QImage image = view.viewport()->grab(view.visualRect(view.model()->index(row, 0))).toImage();
        int darkest = 255;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 20; x < image.width(); ++x)
                darkest = std::min(darkest, qGray(image.pixel(x, y)));
        return darkest;
    }

    void undoneStepsLookUndone()
    {
        Bench bench;
        HistoryPanel panel(bench.editor);
        showAt(panel, {280, 200});
        for (const char *name : {"mmmm", "mmmm ", "mmmm  "})
            bench.editor.push(changeStrokes(bench.editor.document(), {1}, [&](Stroke &s) { s.name = name; }), "mmmm");
        QCOMPARE(inkOf(*panel.view(), 1), inkOf(*panel.view(), 2));
        const int done = inkOf(*panel.view(), 1);
        bench.editor.undoStack().undo();
        bench.editor.undoStack().undo();
        for (const int row : {2, 3})
            QVERIFY2(inkOf(*panel.view(), row) > done + 40, qPrintable(QString::number(inkOf(*panel.view(), row))));
        bench.editor.undoStack().redo();
        QCOMPARE(inkOf(*panel.view(), 1), done);
        QVERIFY(inkOf(*panel.view(), 3) > done + 40);
    }

    void oneStrokeGoesBack()
    {
        Bench bench;
        HistoryPanel panel(bench.editor);
        showAt(panel, {280, 400});
        QListWidget *list = panel.strokeView();
        QVERIFY(!list->isVisible()); // no stroke is selected
        const auto set = [&](StrokeId id, float density, const char *name) {
            bench.editor.push(
                changeSegments(bench.editor.document(), {{id, 0}}, [=](Segment &s) { s.density = density; }), name);
        };
        set(1, 10, "ten");
        set(2, 11, "eleven");
        set(1, 12, "twelve");
        bench.select({1});
        QTRY_VERIFY(list->isVisible());
        QTRY_COMPARE(list->count(), 3);
        QCOMPARE(list->item(1)->text(), QString("ten"));
        QCOMPARE(list->currentRow(), 2);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(1)).center());
        QCOMPARE(bench.stroke(1).segments[0].density, 10.0f);
        QCOMPARE(bench.stroke(2).segments[0].density, 11.0f); // the rest stays
        QCOMPARE(bench.steps(), 4);
        QTRY_COMPARE(list->count(), 4);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
        QCOMPARE(bench.stroke(1), *makeStroke(1, 4, 10));
        bench.editor.undoStack().undo();
        QCOMPARE(bench.stroke(1).segments[0].density, 10.0f);
        bench.editor.undoStack().undo();
        QCOMPARE(bench.stroke(1).segments[0].density, 12.0f);
        QTRY_COMPARE(list->count(), 3);
        // The state of now again is no step; a locked stroke stays.
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(2)).center());
        QCOMPARE(bench.editor.undoStack().index(), 3);
        bench.editor.push(changeStrokes(bench.editor.document(), {1}, [](Stroke &s) { s.locked = true; }), "lock");
        QTRY_COMPARE(list->count(), 4);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
        QCOMPARE(bench.stroke(1).segments[0].density, 12.0f);
        bench.select({1, 2});
        QTRY_VERIFY(!list->isVisible());
        // A stroke that was painted here begins with that.
        const StrokeId id = bench.editor.document().takeStrokeId();
        bench.editor.push(addStrokes(bench.editor.document(), {makeStroke(id, 2, 5)}, true), "paint");
        QTRY_COMPARE(list->count(), 1);
        QCOMPARE(list->item(0)->text(), QString("paint"));
    }
};

QTEST_MAIN(TestHistoryPanel)
#include "test_history_panel.moc"
