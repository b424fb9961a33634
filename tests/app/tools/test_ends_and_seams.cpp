// Where strokes begin and end: ends are joined and broken, the seam of a closed outline, and the brush that goes on.
#include "app/session/commands/commands.h"
#include "tests/app/nodes.h"
#include "undo/edits.h"
#include "undo/fill_edits.h"

#include <QSignalSpy>
#include <QStatusBar>
#include <QTemporaryDir>

using namespace suffuse;

class TestEndsAndSeams : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    /// Where a closed outline begins and ends is one node.
    void theSeamOfAClosedOutlineIsOneNode()
    {
        NodeSession s;
        const StrokeId id = s.addSquare();
        const Stroke before = s.stroke(id);
        const auto cornerOf = [&](int k) { return nodePosition(s.stroke(id), k); };
        const auto isClosedNow = [&] { return isClosed(s.stroke(id), chainsOf(s.stroke(id)).front()); };
        s.drag({300, 400}, {280, 370});
        QVERIFY(isClosedNow());
        QVERIFY(length(cornerOf(0) - Point{280, 370}) < 1.5);
        QCOMPARE(cornerOf(0), cornerOf(4));
        QCOMPARE(cornerOf(1), nodePosition(before, 1));
        QCOMPARE(s.tool().nodes(), (std::set<NodeRef>{{id, 0}, {id, 4}}));
        s.key(Qt::Key_Right); // by key, too
        QVERIFY(isClosedNow() && cornerOf(0).x > 280);
        s.use(Command::Undo);
        s.use(Command::Undo);
        QVERIFY(s.stroke(id) == before);

        // Shift+click takes it in and off as a whole.
        s.click({300, 400});
        s.click({500, 400}, Qt::ShiftModifier);
        QCOMPARE(s.tool().nodes(), (std::set<NodeRef>{{id, 0}, {id, 1}, {id, 4}}));
        s.click({300, 400}, Qt::ShiftModifier);
        QCOMPARE(s.tool().nodes(), (std::set<NodeRef>{{id, 1}}));
        // Tab goes around, and on to the same node but once.
        s.click({300, 400});
        std::vector<std::set<NodeRef>> way;
        for (int i = 0; i < 4; ++i) {
            s.key(Qt::Key_Tab);
            way.push_back(s.tool().nodes());
        }
        QCOMPARE(way, (std::vector<std::set<NodeRef>>{{{id, 1}}, {{id, 2}}, {{id, 3}}, {{id, 0}, {id, 4}}}));

        // Without it the outline goes on around, as without any other node.
        s.use(Command::Delete);
        QCOMPARE(s.stroke(id).segments.size(), std::size_t(3));
        QVERIFY(isClosedNow());
        std::set<std::pair<double, double>> corners;
        for (int k = 0; k < 3; ++k)
            corners.insert({cornerOf(k).x, cornerOf(k).y});
        QCOMPARE(corners, (std::set<std::pair<double, double>>{{500, 400}, {500, 600}, {300, 600}}));
        s.use(Command::Undo);
        QVERIFY(s.stroke(id) == before);
    }

    void theSeamOfAClosedOutlineCanBeSmooth()
    {
        NodeSession s;
        const StrokeId id = s.addSquare();
        const Stroke before = s.stroke(id);
        s.click({300, 400});
        s.use(Command::NodeSmooth);
        const Stroke &smooth = s.stroke(id);
        QCOMPARE(s.tool().nodes(), (std::set<NodeRef>{{id, 0}, {id, 4}}));
        for (int node = 0; node <= 4; ++node) {
            QCOMPARE(nodePosition(smooth, node), nodePosition(before, node));
            QCOMPARE(nodeKind(smooth, node), node % 4 == 0 ? NodeKind::Smooth : NodeKind::Corner);
        }
        QVERIFY(isClosed(smooth, chainsOf(smooth).front()));
        const auto turnOf = [&](int before, int after) {
            const Stroke &now = s.stroke(id);
            const Point in = *handlePosition(now, before, false) - nodePosition(now, before);
            const Point out = *handlePosition(now, after, true) - nodePosition(now, after);
            return std::pair(std::abs(in.x * out.y - in.y * out.x), dot(in, out));
        };
        QVERIFY(turnOf(4, 0).first < 1e-3 && turnOf(4, 0).second < 0);
        s.use(Command::Undo);
        // All at once, none stays a corner.
        s.use(Command::SelectAll);
        for (const auto &[command, kind] : {std::pair(Command::NodeSmooth, NodeKind::Smooth),
                                            std::pair(Command::NodeSymmetric, NodeKind::Symmetric)}) {
            s.use(command);
            for (int node = 0; node <= 4; ++node)
                QCOMPARE(nodeKind(s.stroke(id), node), kind);
            QVERIFY(turnOf(4, 0).first < 1e-3 && turnOf(4, 0).second < 0);
            s.use(Command::Undo);
        }
        QVERIFY(s.stroke(id) == before);
    }

    void breakingTheSeamSaysWhyItDoesNothing()
    {
        NodeSession s;
        const StrokeId id = s.addSquare();
        const Stroke before = s.stroke(id);
        s.click({300, 400});
        s.use(Command::BreakNodes);
        QVERIFY(s.stroke(id) == before);
        QVERIFY2(s.window.statusBar()->currentMessage().contains("begins and ends at this node"),
                 qPrintable(s.window.statusBar()->currentMessage()));
        s.click({500, 400});
        s.use(Command::BreakNodes);
        QVERIFY(s.stroke(id) != before);
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
        s.click(nodePlace[4]);
        QCOMPARE(s.tool().nodes(), s.nodes({4}));
        s.use(Command::JoinNodes); // one end is not enough
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));
        s.click({700, 300}, Qt::ShiftModifier); // the other's first node
        QCOMPARE(s.tool().nodes(), (std::set<NodeRef>{{s.id, 4}, {other, 0}}));
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        s.use(Command::JoinNodes);
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
            s.click(nodePlace[4]);
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

    void nodesStayWhereAnotherStrokeIsAdded()
    {
        NodeSession s;
        const StrokeId other = s.addWave(200, 450, false);
        s.click(nodePlace[4]);
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
        s.click(nodePlace[2]);
        s.use(Command::BreakNodes);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(chainsOf(s.stroke()).size(), std::size_t(2));
        QCOMPARE(s.selection().strokes, std::set<StrokeId>{s.id});
        s.drag({380, 280}, {420, 320}); // both ends that lie there
        QCOMPARE(s.tool().nodes().size(), std::size_t(2));
        s.use(Command::JoinNodes);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(s.painting().strokes[0]->segments.size(), std::size_t(4));
        QCOMPARE(chainsOf(s.stroke()).size(), std::size_t(1));
        s.use(Command::Undo);
        s.use(Command::Undo);
        QVERIFY(s.stroke() == before);

        s.click(nodePlace[1]);
        s.use(Command::ReverseStrokes);
        QVERIFY(s.stroke() == reversed(before));
        QCOMPARE(s.tool().nodes(), s.nodes({3})); // the same node
    }

    void anEndStaysSelectedWhereAStrokeWasBroken()
    {
        NodeSession s;
        const Stroke before = s.stroke();
        s.click(nodePlace[2]);
        s.use(Command::BreakNodes);
        QCOMPARE(s.tool().nodes(), s.nodes({2}));
        s.key(Qt::Key_Down, Qt::ShiftModifier); // moves this end, and neither the stroke nor the other end
        QCOMPARE(s.stroke().origin, before.origin);
        QVERIFY(length(nodePosition(s.stroke(), 2) - nodePlace[2] - Point{0, 10}) < 1e-3);
        QVERIFY(length(nodePosition(s.stroke(), endNode(s.stroke(), 1)) - nodePlace[2]) < 1e-3);
        QVERIFY(length(nodePosition(s.stroke(), 0) - nodePlace[0]) < 1e-3);
        // An end breaks no further, and stays.
        s.click(nodePlace[0]);
        s.use(Command::BreakNodes);
        QCOMPARE(s.tool().nodes(), s.nodes({0}));
    }

    void joinSaysWhyItDoesNothing()
    {
        NodeSession s;
        const Stroke before = s.stroke();
        const auto said = [&s] { return s.window.statusBar()->currentMessage(); };
        s.use(Command::JoinNodes);
        QVERIFY2(said().contains("two ends"), qPrintable(said()));
        s.window.statusBar()->clearMessage();
        s.click(nodePlace[0]);
        s.use(Command::JoinNodes);
        QVERIFY2(said().contains("two ends"), qPrintable(said()));
        s.window.statusBar()->clearMessage();
        s.drag({280, 260}, {420, 380}); // two nodes, which are no ends
        s.use(Command::JoinNodes);
        QVERIFY2(said().contains("two ends"), qPrintable(said()));
        QVERIFY(s.stroke() == before);
    }

    /// Of many ends, the two nearest ones of two chains are joined, and the outer ones stay ends.
    void gapsAreJoinedWhenAllIsSelected()
    {
        NodeSession s;
        s.editor().document().setSelection({{s.id}, {{s.id, 1}}});
        s.use(Command::DeleteSegments);
        QCOMPARE(chainsOf(s.stroke()).size(), std::size_t(2));
        s.use(Command::SelectAll);
        QCOMPARE(int(s.tool().nodes().size()), nodeCount(s.stroke()));
        QVERIFY(s.window.action(Command::JoinNodes).isEnabled());
        s.use(Command::JoinNodes);
        QCOMPARE(chainsOf(s.stroke()).size(), std::size_t(1));
        QVERIFY(!isClosed(s.stroke(), chainsOf(s.stroke()).front()));
        QVERIFY(length(nodePosition(s.stroke(), 0) - nodePlace[0]) < 1e-3);
        QVERIFY(length(nodePosition(s.stroke(), endNode(s.stroke(), int(s.stroke().segments.size()) - 1)) -
                       nodePlace[4]) < 1e-3);
    }

    void brushGoesOnFromAnEnd()
    {
        NodeSession s;
        const Stroke before = s.stroke();
        s.use(Command::Brush);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, Qt::ShiftModifier, s.at(nodePlace[4]));
        for (int i = 1; i <= 10; ++i) {
            s.advance(interval);
            s.move(nodePlace[4] + Point{10.0 * i, 8.0 * i}, Qt::ShiftModifier);
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

QTEST_MAIN(TestEndsAndSeams)
#include "test_ends_and_seams.moc"
