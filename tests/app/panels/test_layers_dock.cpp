// Layers in the Strokes dock: which one is painted on, and how it is chosen there.
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_panel.h"
#include "tests/app/panel_bench.h"
#include "undo/group_edits.h"

#include <QLabel>
#include <QTreeView>

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
        QCOMPARE(dock.said(), QString());
        dock.click(dock.groupRow());
        QCOMPARE(bench.editor.layer().group(), GroupId(1));
        QCOMPARE(bench.editor.selection().strokes, (std::set<StrokeId>{3, 4})); // as before
        QCOMPARE(dock.said(), QString("Painting on: sky"));
        QVERIFY(dock.groupRow().data(StrokesModel::CurrentLayerRole).toBool());
        QCOMPARE(dock.groupRow().data(Qt::AccessibleTextRole).toString(), QString("sky, painted on"));
        dock.click(dock.panel.viewIndexOf(5));
        QCOMPARE(bench.editor.layer().group(), GroupId(0));
        QCOMPARE(dock.said(), QString());
        QVERIFY(!dock.groupRow().data(StrokesModel::CurrentLayerRole).toBool());
        dock.view().expand(dock.groupRow());
        dock.click(dock.panel.viewIndexOf(3));
        QCOMPARE(bench.editor.layer().group(), GroupId(1));
        QCOMPARE(bench.editor.selection().strokes, std::set<StrokeId>{3});
        QTest::mouseClick(dock.view().viewport(), Qt::LeftButton, {},
                          dock.view().viewport()->rect().bottomLeft() - QPoint(-60, 8));
        QCOMPARE(bench.editor.layer().group(), GroupId(0));
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
};

QTEST_MAIN(TestLayersDock)
#include "test_layers_dock.moc"
