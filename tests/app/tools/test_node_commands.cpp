// Commands and keys of the Segments tool: what is deleted, copied, inserted and nudged, and what is selected then.
#include "app/session/files/clipboard.h"
#include "model/formats/files.h"
#include "tests/app/nodes.h"

#include <QClipboard>
#include <QMimeData>
#include <QStatusBar>
#include <QTemporaryDir>

using namespace suffuse;

class TestNodeCommands : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void deletedNodesAreBridged()
    {
        NodeSession s;
        const Stroke before = s.stroke();
        s.click(nodePlace[2]);
        s.use(Command::Delete);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(nodeCount(s.stroke()), 4);
        QCOMPARE(nodePosition(s.stroke(), 2), nodePosition(before, 3));
        QVERIFY(s.tool().nodes().empty());
        s.use(Command::Undo);
        QVERIFY(s.stroke() == before);
        s.editor().document().setSelection({{s.id}, {{s.id, 1}}}); // segments: the stroke has a gap
        s.use(Command::Delete);
        QCOMPARE(chainsOf(s.stroke()).size(), std::size_t(2));
    }

    /// Once parts are deleted, their strokes are selected to be seen. They are not what the next Delete means.
    void deleteDoesNotGoOnWithTheStroke()
    {
        NodeSession s;
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        const Stroke before = s.stroke();
        const auto deletesNoMore = [&s] {
            const auto painting = s.editor().document().painting();
            const int steps = s.steps();
            s.window.statusBar()->clearMessage();
            s.key(Qt::Key_Delete);
            const QString said = s.window.statusBar()->currentMessage();
            return s.editor().document().painting() == painting && s.steps() == steps &&
                   said == NodeTool::tr("What was selected is deleted; its strokes are merely shown. Click what else "
                                        "is to go, or take whole strokes with the Select tool.");
        };
        s.click(nodePlace[2]);
        s.key(Qt::Key_Delete);
        QCOMPARE(nodeCount(s.stroke()), 4);
        QVERIFY(deletesNoMore());
        // Undo selects the node again, and redo leaves nothing to be deleted.
        s.use(Command::Undo);
        QVERIFY(s.stroke() == before);
        QCOMPARE(s.tool().nodes(), s.nodes({2}));
        s.use(Command::Redo);
        QVERIFY(s.tool().nodes().empty());
        QVERIFY(deletesNoMore());
        s.use(Command::Undo);
        // So it is with segments, by either key.
        for (const Qt::KeyboardModifiers modifiers : {Qt::NoModifier, Qt::ControlModifier}) {
            s.editor().document().setSelection({{s.id}, {{s.id, 1}}});
            s.key(Qt::Key_Delete, modifiers);
            QCOMPARE(s.stroke().segments.size(), std::size_t(3));
            QVERIFY(deletesNoMore());
            // What is changed in the strokes meanwhile selects nothing.
            s.use(Command::GrowPaint);
            QVERIFY(deletesNoMore());
            s.use(Command::Undo);
            s.use(Command::Undo);
            QCOMPARE(s.selection(), (Selection{{s.id}, {{s.id, 1}}}));
            s.use(Command::Redo);
            QVERIFY(deletesNoMore());
            s.use(Command::Undo);
        }
        // What is clicked is meant again, and so are strokes that are selected by another tool.
        s.key(Qt::Key_Delete);
        s.click(nodePlace[1]);
        s.key(Qt::Key_Delete);
        QCOMPARE(s.stroke().segments.size(), std::size_t(2));
        QVERIFY(deletesNoMore());
        s.use(Command::Select);
        s.key(Qt::Key_Delete);
        QVERIFY(s.painting().strokes.empty());
    }

    /// Where segments are selected, strokes that are shown beside them are not deleted with them.
    void segmentsAreDeletedAlone()
    {
        NodeSession s;
        const StrokeId other = s.addWave(200, 420, false);
        s.editor().document().setSelection({{s.id, other}, {{s.id, 1}, {other, 1}}});
        s.use(Command::Delete);
        QCOMPARE(s.selection(), (Selection{{s.id, other}, {}}));
        s.editor().document().setSelection({{s.id, other}, {{s.id, 0}}}); // as Shift+click adds it
        s.use(Command::Delete);
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));
        QCOMPARE(s.stroke().segments.size(), std::size_t(2));
        QCOMPARE(s.stroke(other).segments.size(), std::size_t(3));
        s.use(Command::Delete);
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));
    }

    /// A key that is held comes again and again. It has done what it was pressed for.
    void aHeldDeleteDeletesOnce()
    {
        NodeSession s;
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        const std::set<SegmentRef> segment{{s.id, 1}};
        const auto comesAgain = [&s](Qt::Key key, Qt::KeyboardModifiers modifiers) {
            QTest::simulateEvent(&s.canvas(), true, key, modifiers, {}, true);
        };
        s.editor().document().setSelection({{s.id}, segment});
        const int steps = s.steps();
        QTest::keyPress(&s.canvas(), Qt::Key_Delete);
        QCOMPARE(s.steps(), steps + 1);
        comesAgain(Qt::Key_Delete, {});
        s.editor().document().setSelection({{s.id}, segment});
        comesAgain(Qt::Key_Delete, {});
        comesAgain(Qt::Key_X, Qt::ControlModifier);
        QTest::keyRelease(&s.canvas(), Qt::Key_Delete);
        QCOMPARE(s.steps(), steps + 1);
        QCOMPARE(s.stroke().segments.size(), std::size_t(3));
        s.key(Qt::Key_Delete); // pressed anew
        QCOMPARE(s.steps(), steps + 2);
    }

    void segmentsBetweenNodesAreDeletedOrBridged()
    {
        NodeSession s;
        QVERIFY(!s.window.action(Command::DeleteSegments).isEnabled());
        s.drag({280, 260}, {420, 380});
        QCOMPARE(s.tool().nodes(), s.nodes({1, 2}));
        s.use(Command::DeleteSegments);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(chainsOf(s.stroke()), (std::vector<Chain>{{0, 0}, {1, 2}}));
        s.use(Command::Undo);
        s.editor().document().setSelection({{s.id}, {{s.id, 1}, {s.id, 2}}});
        s.use(Command::BridgeSegments);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(s.stroke().segments.size(), std::size_t(3));
    }

    /// A node stands for itself and not for its stroke.
    void aNodeAloneIsNotCopied()
    {
        for (const Command command : {Command::Cut, Command::Copy, Command::Duplicate}) {
            NodeSession s;
            QGuiApplication::clipboard()->setText("before");
            const Stroke before = s.stroke();
            const int steps = s.steps();
            s.click(nodePlace[2]);
            s.use(command);
            QCOMPARE(s.painting().strokes.size(), std::size_t(1));
            QVERIFY(s.stroke() == before);
            QCOMPARE(s.steps(), steps);
            QCOMPARE(s.tool().nodes(), s.nodes({2}));
            QCOMPARE(QGuiApplication::clipboard()->text(), QString("before"));
            const QString said = s.window.statusBar()->currentMessage();
            QVERIFY2(said.contains("node alone"), qPrintable(said));
        }
    }

    void segmentsBetweenNodesAreCutCopiedAndDoubled()
    {
        NodeSession s;
        const Stroke before = s.stroke();
        const auto copied = [] {
            return readTextForm(QGuiApplication::clipboard()->mimeData()->data(clipboard::strokesMime), {});
        };
        s.drag({280, 260}, {420, 380});
        QCOMPARE(s.tool().nodes(), s.nodes({1, 2}));
        s.use(Command::Copy);
        QCOMPARE(copied()->strokes.size(), std::size_t(1));
        QCOMPARE(copied()->strokes.front()->segments.size(), std::size_t(1));
        QCOMPARE(s.tool().nodes(), s.nodes({1, 2}));
        QVERIFY(s.stroke() == before);
        s.use(Command::Duplicate);
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));
        QCOMPARE(s.painting().strokes.back()->segments.size(), std::size_t(1));
        s.use(Command::Undo);
        s.editor().document().setSelection({{s.id}, {}});
        s.drag({280, 260}, {420, 380});
        QGuiApplication::clipboard()->setText("before");
        s.use(Command::Cut);
        QCOMPARE(copied()->strokes.front()->segments.size(), std::size_t(1));
        QCOMPARE(chainsOf(s.stroke()), (std::vector<Chain>{{0, 0}, {1, 2}})); // as Delete Segments leaves it
        s.use(Command::Undo);
        QVERIFY(s.stroke() == before);
    }

    void tabGoesOnFromASegment()
    {
        NodeSession s;
        s.editor().document().setSelection({{s.id}, {{s.id, 2}}});
        s.key(Qt::Key_Tab);
        QCOMPARE(s.tool().nodes(), s.nodes({3}));
        s.editor().document().setSelection({{s.id}, {{s.id, 1}, {s.id, 2}}});
        s.key(Qt::Key_Backtab, Qt::ShiftModifier);
        QCOMPARE(s.tool().nodes(), s.nodes({1}));
    }

    void commandsSetTheKind()
    {
        NodeSession s;
        QVERIFY(!s.window.action(Command::NodeCorner).isEnabled());
        s.click(nodePlace[1]);
        s.use(Command::NodeCorner);
        QCOMPARE(nodeKind(s.stroke(), 1), NodeKind::Corner);
        s.use(Command::NodeSymmetric);
        QCOMPARE(nodeKind(s.stroke(), 1), NodeKind::Symmetric);
        s.use(Command::NodeSmooth);
        QCOMPARE(nodeKind(s.stroke(), 1), NodeKind::Smooth);
        QCOMPARE(s.tool().nodes(), s.nodes({1}));
        s.use(Command::Brush);
        QVERIFY(!s.window.action(Command::NodeCorner).isEnabled());
    }

    void keysOfInkscape()
    {
        NodeSession s;
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        const Stroke before = s.stroke();
        s.click(nodePlace[1]);
        s.key(Qt::Key_C, Qt::ShiftModifier);
        QCOMPARE(nodeKind(s.stroke(), 1), NodeKind::Corner);
        s.key(Qt::Key_Y, Qt::ShiftModifier);
        QCOMPARE(nodeKind(s.stroke(), 1), NodeKind::Symmetric);
        s.key(Qt::Key_S, Qt::ShiftModifier);
        QCOMPARE(nodeKind(s.stroke(), 1), NodeKind::Smooth);
        s.key(Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(s.tool().nodes().size(), std::size_t(5));
        s.click(nodePlace[2]);
        s.key(Qt::Key_Delete);
        QCOMPARE(nodeCount(s.stroke()), 4);
        s.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(nodeCount(s.stroke()), 5);
        s.drag({280, 260}, {420, 380});
        s.key(Qt::Key_Delete, Qt::ControlModifier);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1)); // one stroke with a gap
        QCOMPARE(chainsOf(s.stroke()).size(), std::size_t(2));
        QCOMPARE(s.selection(), (Selection{{s.id}, {}}));
        s.key(Qt::Key_K);
        QVERIFY(s.window.action(Command::Knife).isChecked());
        s.editor().undoStack().setIndex(1);
        QVERIFY(s.stroke() == before);
    }

    /// Who has begun with segments goes on with them, also where a node lies under the pointer.
    void shiftGoesOnWithSegments()
    {
        NodeSession s;
        s.click({250, 320});
        QCOMPARE(s.selection(), (Selection{{s.id}, {{s.id, 0}}}));
        s.click(nodePlace[3], Qt::ShiftModifier);
        QVERIFY(s.tool().nodes().empty());
        QVERIFY(s.selection().segments.contains({s.id, 0}));
        QVERIFY(s.selection().segments.contains({s.id, 1}));
        QVERIFY(s.selection().segments.contains({s.id, 2}));
    }

    void nodesAreInsertedBetweenSelectedOnes()
    {
        NodeSession s;
        s.drag({280, 260}, {420, 380});
        s.use(Command::InsertNodes);
        QCOMPARE(nodeCount(s.stroke()), 6);
        QCOMPARE(s.tool().nodes(), s.nodes({1, 2, 3}));
    }

    void tabGoesFromNodeToNode()
    {
        NodeSession s;
        const StrokeId other = s.addWave(200, 450, false);
        s.editor().document().setSelection({{s.id, other}, {}});
        s.key(Qt::Key_Tab);
        QCOMPARE(s.tool().nodes(), s.nodes({0}));
        s.key(Qt::Key_Tab);
        QCOMPARE(s.tool().nodes(), s.nodes({1}));
        s.key(Qt::Key_Backtab, Qt::ShiftModifier);
        s.key(Qt::Key_Backtab, Qt::ShiftModifier);
        QCOMPARE(s.tool().nodes(), (std::set<NodeRef>{{other, 4}}));
        s.key(Qt::Key_Tab);
        QCOMPARE(s.tool().nodes(), s.nodes({0}));
        QVERIFY(!s.window.action(Command::HideDocks).isChecked());
    }

    /// What is chosen by keys can be seen before the next key changes it: nodes, and strokes with Select.
    void tabBringsIntoView()
    {
        NodeSession s;
        const auto isSeen = [&](Point point) {
            const View &view = s.canvas().view();
            const Point p = view.toPixels(point);
            return p.x > 0 && p.y > 0 && p.x < view.width && p.y < view.height;
        };
        s.editor().document().setSelection({{s.id}, {}});
        s.canvas().zoomBy(4);
        for (int node = 0; node < 5; ++node) {
            s.canvas().panBy({node % 2 ? 900.0 : -3000.0, 1500.0 - 700.0 * node});
            s.key(Qt::Key_Tab);
            QCOMPARE(s.tool().nodes(), s.nodes({node}));
            QVERIFY(isSeen(nodePosition(s.stroke(), node)));
        }
        const View view = s.canvas().view();
        s.canvas().bringIntoView(nodePosition(s.stroke(), 4)); // It is seen already.
        QVERIFY(s.canvas().view() == view);
        s.use(Command::Select);
        s.editor().document().setSelection({});
        s.canvas().panBy({1e5, 1e5});
        s.key(Qt::Key_Tab);
        QVERIFY(s.editor().selection().strokes.contains(s.id));
        QVERIFY(!s.canvas().selectionOnScreen().isEmpty());
    }

    void arrowsNudgeNodes()
    {
        NodeSession s;
        const Stroke before = s.stroke();
        s.click(nodePlace[2]);
        s.key(Qt::Key_Down);
        QVERIFY(length(nodePosition(s.stroke(), 2) - nodePosition(before, 2) - Point{0, 1}) < 1e-4);
        QCOMPARE(nodePosition(s.stroke(), 1), nodePosition(before, 1));
        s.key(Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(length(nodePosition(s.stroke(), 2) - nodePosition(before, 2) - Point{-10, 1}) < 1e-4);
        QCOMPARE(s.steps(), 2); // taps that follow each other
        s.use(Command::Undo);
        QVERIFY(s.stroke() == before);
    }

    void arrowsNudgeSelectedSegments()
    {
        NodeSession s;
        const Stroke before = s.stroke();
        const auto movedBy = [&](int node) { return nodePosition(s.stroke(), node) - nodePosition(before, node); };
        s.click({350, 320});
        QCOMPARE(s.selection().segments, (std::set<SegmentRef>{{s.id, 1}}));
        s.key(Qt::Key_Down);
        s.key(Qt::Key_Left, Qt::ShiftModifier);
        QCOMPARE(s.stroke().origin, before.origin);
        for (const int node : {1, 2})
            QVERIFY(length(movedBy(node) - Point{-10, 1}) < 1e-4);
        for (const int node : {0, 3, 4})
            QCOMPARE(movedBy(node), Point());
        const Point arm = *handlePosition(before, 2, true) - nodePosition(before, 2);
        QVERIFY(length(*handlePosition(s.stroke(), 2, true) - nodePosition(s.stroke(), 2) - arm) < 1e-4);
        QCOMPARE(s.selection().segments, (std::set<SegmentRef>{{s.id, 1}}));
        QCOMPARE(s.steps(), 2); // taps that follow each other
        s.use(Command::Undo);
        QVERIFY(s.stroke() == before);
        // A run of them goes along as a whole.
        s.click({350, 320});
        s.click({450, 320}, Qt::ShiftModifier);
        s.key(Qt::Key_Up);
        for (const int node : {1, 2, 3})
            QVERIFY(length(movedBy(node) - Point{0, -1}) < 1e-4);
        QCOMPARE(movedBy(0), Point());
        QCOMPARE(movedBy(4), Point());
    }

    void nodesThatUndoTakesAwayAreDropped()
    {
        NodeSession s;
        s.use(Command::SelectAll);
        s.use(Command::InsertNodes);
        QCOMPARE(nodeCount(s.stroke()), 9);
        QCOMPARE(s.tool().nodes().size(), std::size_t(9));
        s.use(Command::Undo);
        QCOMPARE(s.tool().nodes(), s.nodes({0, 1, 2, 3, 4}));
        s.use(Command::Undo);
        QVERIFY(s.painting().strokes.empty());
        QVERIFY(s.tool().nodes().empty());
        s.key(Qt::Key_Tab);
        QVERIFY(s.tool().nodes().empty());
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestNodeCommands)
#include "test_node_commands.moc"
