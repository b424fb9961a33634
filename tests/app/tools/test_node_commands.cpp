// Commands and keys of the Segments tool, and the brush that goes on with a stroke.
#include "app/session/commands/commands.h"
#include "tests/app/nodes.h"
#include "undo/edits.h"
#include "undo/fill_edits.h"

#include <QSignalSpy>
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
        s.click(nodeAt[2]);
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

    void commandsSetTheKind()
    {
        NodeSession s;
        QVERIFY(!s.window.action(Command::NodeCorner).isEnabled());
        s.click(nodeAt[1]);
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
        s.click(nodeAt[1]);
        s.key(Qt::Key_C, Qt::ShiftModifier);
        QCOMPARE(nodeKind(s.stroke(), 1), NodeKind::Corner);
        s.key(Qt::Key_Y, Qt::ShiftModifier);
        QCOMPARE(nodeKind(s.stroke(), 1), NodeKind::Symmetric);
        s.key(Qt::Key_S, Qt::ShiftModifier);
        QCOMPARE(nodeKind(s.stroke(), 1), NodeKind::Smooth);
        s.key(Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(s.tool().nodes().size(), std::size_t(5));
        s.click(nodeAt[2]);
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

    void twoStrokesAreJoinedWhereTheyAre()
    {
        NodeSession s;
        const StrokeId other = s.addWave(700, 300, false); // from 700 to 1100, level with the first
        const Stroke before = s.stroke(), otherBefore = s.stroke(other);
        s.canvas().panBy({-250, 0});
        s.click({250, 320});
        QCOMPARE(s.selection(), (Selection{{s.id}, {{s.id, 0}}}));
        s.click({850, 320}, Qt::ShiftModifier); // another stroke's
        QCOMPARE(s.selection(), (Selection{{s.id, other}, {{s.id, 0}, {other, 1}}}));
        s.click({1050, 320}, Qt::ShiftModifier); // a run on that one
        QCOMPARE(s.selection(), (Selection{{s.id, other}, {{s.id, 0}, {other, 1}, {other, 2}, {other, 3}}}));
        s.click({550, 320}, Qt::ShiftModifier); // back on the first
        QVERIFY(s.selection().segments.contains({s.id, 3}));
        QCOMPARE(s.selection().segments.size(), std::size_t(5));
        s.click(nodeAt[4]);
        QCOMPARE(s.tool().nodes(), s.nodes({4}));
        QVERIFY(!s.window.action(Command::JoinNodes).isEnabled());
        s.click({700, 300}, Qt::ShiftModifier); // the other's first node
        QCOMPARE(s.tool().nodes(), (std::set<NodeRef>{{s.id, 4}, {other, 0}}));
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        s.key(Qt::Key_J, Qt::ShiftModifier);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        const Stroke &whole = *s.painting().strokes.front();
        const auto isThere = [&](Point place) {
            for (int k = 0; k < nodeCount(whole); ++k)
                if (length(nodePosition(whole, k) - place) < 1e-3)
                    return true;
            return false;
        };
        for (const Stroke *part : {&before, &otherBefore})
            for (int k = 0; k < nodeCount(*part); ++k)
                QVERIFY(isThere(nodePosition(*part, k)));
    }

    /// One stroke has one fill, and the status bar says whose was kept.
    void aJoinSaysWhichFillIsKept()
    {
        const auto joined = [](const std::optional<Colour> &lower, const std::optional<Colour> &upper) {
            NodeSession s;
            const StrokeId other = s.addWave(700, 300, false);
            const auto fill = [&s](StrokeId id, const std::optional<Colour> &colour) {
                if (colour)
                    s.editor().push(changeStrokes(s.editor().document(), {id},
                                                  [&](Stroke &stroke) {
                                                      Fill with = usualFill(stroke);
                                                      with.diffusion = 4;
                                                      with.density = 3;
                                                      with.colour = *colour;
                                                      stroke.fill = with;
                                                  }),
                                    "fill");
            };
            fill(s.id, lower);
            fill(other, upper);
            s.canvas().panBy({-250, 0});
            s.editor().document().setSelection({{s.id, other}, {}});
            s.click(nodeAt[4]);
            s.click({700, 300}, Qt::ShiftModifier);
            QSignalSpy said(s.window.findChild<Commands *>(), &Commands::said);
            s.use(Command::JoinNodes);
            const bool isOne = s.painting().strokes.size() == 1;
            return isOne ? said.isEmpty() ? QString("nothing") : said.first().first().toString()
                         : QString("not joined");
        };
        const Colour red{1, 0, 0, 1}, blue{0, 0, 1, 1};
        QVERIFY(joined(red, blue).contains("the upper one's fill"));
        QVERIFY(joined(red, {}).contains("no fill"));
        QCOMPARE(joined(red, red), QString("nothing"));
        QCOMPARE(joined({}, blue), QString("nothing"));
        QCOMPARE(joined({}, {}), QString("nothing"));
    }

    /// Who has begun with segments goes on with them, also where a node lies under the pointer.
    void shiftGoesOnWithSegments()
    {
        NodeSession s;
        s.click({250, 320});
        QCOMPARE(s.selection(), (Selection{{s.id}, {{s.id, 0}}}));
        s.click(nodeAt[3], Qt::ShiftModifier);
        QVERIFY(s.tool().nodes().empty());
        QVERIFY(s.selection().segments.contains({s.id, 0}));
        QVERIFY(s.selection().segments.contains({s.id, 1}));
        QVERIFY(s.selection().segments.contains({s.id, 2}));
    }

    void nodesStayWhereAnotherStrokeIsAdded()
    {
        NodeSession s;
        const StrokeId other = s.addWave(200, 450, false);
        s.click(nodeAt[4]);
        s.click({250, 470}, Qt::ShiftModifier);
        QCOMPARE(s.selection(), (Selection{{s.id, other}, {}}));
        QCOMPARE(s.tool().nodes(), s.nodes({4}));
        s.click({600, 450}, Qt::ShiftModifier);
        QVERIFY(s.window.action(Command::JoinNodes).isEnabled());
    }

    void breakJoinAndReverse()
    {
        NodeSession s;
        const Stroke before = s.stroke();
        s.click(nodeAt[2]);
        s.use(Command::BreakNodes);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(chainsOf(s.stroke()).size(), std::size_t(2));
        QCOMPARE(s.selection().strokes, std::set<StrokeId>{s.id});
        QVERIFY(!s.window.action(Command::JoinNodes).isEnabled());
        s.drag({380, 280}, {420, 320}); // both ends that lie there
        QCOMPARE(s.tool().nodes().size(), std::size_t(2));
        s.use(Command::JoinNodes);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(s.painting().strokes[0]->segments.size(), std::size_t(4));
        QCOMPARE(chainsOf(s.stroke()).size(), std::size_t(1));
        s.use(Command::Undo);
        s.use(Command::Undo);
        QVERIFY(s.stroke() == before);

        s.click(nodeAt[1]);
        s.use(Command::ReverseStrokes);
        QVERIFY(s.stroke() == reversed(before));
        QCOMPARE(s.tool().nodes(), s.nodes({3})); // the same node
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

    void arrowsNudgeNodes()
    {
        NodeSession s;
        const Stroke before = s.stroke();
        s.click(nodeAt[2]);
        s.key(Qt::Key_Down);
        QVERIFY(length(nodePosition(s.stroke(), 2) - nodePosition(before, 2) - Point{0, 1}) < 1e-4);
        QCOMPARE(nodePosition(s.stroke(), 1), nodePosition(before, 1));
        s.key(Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(length(nodePosition(s.stroke(), 2) - nodePosition(before, 2) - Point{-10, 1}) < 1e-4);
        QCOMPARE(s.steps(), 3);
        s.use(Command::Undo);
        s.use(Command::Undo);
        QVERIFY(s.stroke() == before);
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

    void brushGoesOnFromAnEnd()
    {
        NodeSession s;
        const Stroke before = s.stroke();
        s.use(Command::Brush);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, Qt::ShiftModifier, s.at(nodeAt[4]));
        for (int i = 1; i <= 10; ++i) {
            s.advance(interval);
            s.move(nodeAt[4] + Point{10.0 * i, 8.0 * i}, Qt::ShiftModifier);
        }
        QCOMPARE(s.stroke().segments.size(), before.segments.size()); // the draft is not part of it yet
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, Qt::ShiftModifier, s.at({700, 380}));
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(s.steps(), 2);
        QVERIFY(s.stroke().segments.size() > 5);
        for (std::size_t k = 0; k < 4; ++k)
            QVERIFY(s.stroke().segments[k] == before.segments[k]);
        const Segment &added = s.stroke().segments.back();
        QCOMPARE(added.colour, before.segments.back().colour);
        QCOMPARE(added.diffusion, before.segments.back().diffusion);
        QVERIFY(length(nodePosition(s.stroke(), nodeCount(s.stroke()) - 1) - Point{700, 380}) < 3);
        QVERIFY(added.born > before.segments.back().born);
        s.use(Command::Undo);
        QVERIFY(s.stroke() == before);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestNodeCommands)
#include "test_node_commands.moc"
