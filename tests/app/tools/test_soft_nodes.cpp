// The nodes of painted strokes: as many as the view needs, and soft drags of them and of the curve between.
#include "app/session/settings/settings.h"
#include "app/tools/nodes/node_tool.h"
#include "app/widgets/numbers/number_field.h"
#include "model/shaping/nodes/coarse_nodes.h"
#include "model/shaping/nodes/soft_move.h"
#include "tests/app/trunk.h"

#include <QTemporaryDir>
#include <QToolButton>
#include <QWheelEvent>

#include <random>

using namespace suffuse;

namespace {

/// The trunk with the Segments tool in hand.
struct SoftSession : TrunkSession {
    SoftSession()
    {
        use(Command::Segments);
        editor().document().setSelection({{trunk}, {}});
    }
    NodeTool &tool() { return *qobject_cast<NodeTool *>(canvas().tool()); }
    const Stroke &shape() { return stroke(trunk); }
    double gap() { return NodeMarks::gap(canvas().view(), canvas().devicePixelRatioF()); }
    /// A node in the middle of the trunk that is shown.
    int shownNode()
    {
        const std::vector<int> shown = coarseNodes(shape(), gap());
        return shown[shown.size() / 2];
    }
    void wheel(Point at, int notches, Qt::KeyboardModifiers modifiers = {})
    {
        const QPointF where = this->at(at);
        QWheelEvent event(where, canvas().mapToGlobal(where), {}, {0, 120 * notches}, Qt::LeftButton, modifiers,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&canvas(), &event);
    }
    void lift(Point to) { QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, at(to)); }
    NumberField *field()
    {
        for (NumberField *field : tool().options()->findChildren<NumberField *>())
            if (field->accessibleName() == "Reach")
                return field;
        return nullptr;
    }
    QToolButton *follows()
    {
        for (QToolButton *button : tool().options()->findChildren<QToolButton *>())
            if (button->text() == "Auto")
                return button;
        return nullptr;
    }
};

/// Everything but curves is the same.
bool keepsValues(const Stroke &after, const Stroke &before)
{
    Stroke same = after;
    for (std::size_t k = 0; k < same.segments.size() && k < before.segments.size(); ++k)
        same.segments[k].bezier = before.segments[k].bezier;
    return same == before;
}

int movedSegments(const Stroke &a, const Stroke &b)
{
    int count = 0;
    for (std::size_t k = 0; k < a.segments.size(); ++k)
        count += !(a.segments[k].bezier == b.segments[k].bezier);
    return count;
}

} // namespace

class TestSoftNodes : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }
    void cleanup() { settings::store().remove("tools"); }

    void theViewTellsHowManyNodesThereAre()
    {
        SoftSession s;
        const auto tabs = [&s] { // from the first node to the last one
            s.tool().selectNodes({{s.trunk, 0}});
            int count = 0;
            while (s.tool().nodes() != std::set<NodeRef>{{s.trunk, nodeCount(s.shape()) - 1}} && count < 1000) {
                QTest::keyClick(&s.canvas(), Qt::Key_Tab);
                ++count;
            }
            return count;
        };
        const int all = nodeCount(s.shape());
        QVERIFY(all > 200);
        const int far = tabs();
        QVERIFY2(far >= 9 && far <= 26, qPrintable(QString::number(far)));
        s.canvas().setZoom(4);
        const int near = tabs();
        QVERIFY2(near > 3 * far && near < all, qPrintable(QString::number(near)));
        s.canvas().setZoom(1e6);
        QCOMPARE(tabs(), all - 1);
    }

    void aNodeThatIsLeftOutIsNotHit()
    {
        SoftSession s;
        const std::vector<int> shown = coarseNodes(s.shape(), s.gap());
        const int node = shown[4], hidden = (shown[4] + shown[5]) / 2;
        s.hover(nodePosition(s.shape(), node));
        const QString overNode = s.tool().hint();
        s.hover(nodePosition(s.shape(), hidden));
        QVERIFY(s.tool().hint() != overNode); // the curve
        s.tool().selectNodes({{s.trunk, hidden}});
        s.hover(nodePosition(s.shape(), hidden));
        QCOMPARE(s.tool().hint(), overNode); // what is selected is shown
    }

    /// Del on a node that stands for many takes its bend away: the part between the shown nodes beside it becomes one
    /// curve, whose segments keep their values. At the end of the stroke the part goes.
    void deletingAShownNodeRemovesItsBend()
    {
        SoftSession s;
        const std::vector<int> shown = coarseNodes(s.shape(), s.gap());
        const std::size_t at = shown.size() / 2;
        const int from = shown[at - 1], node = shown[at], to = shown[at + 1];
        QVERIFY(to - from > 6);
        s.drag(nodePosition(s.shape(), node), nodePosition(s.shape(), node) + Point{60, 0}); // the bend
        const Stroke bent = s.shape();
        const auto wayBetween = [&](const Stroke &stroke) {
            double way = 0;
            for (int k = from; k < to; ++k)
                way += arcLength(stroke.cubicOf(stroke.segments[std::size_t(k)]));
            return way / length(nodePosition(stroke, to) - nodePosition(stroke, from));
        };
        s.tool().selectNodes({{s.trunk, node}});
        const int steps = s.steps();
        s.use(Command::Delete);
        QCOMPARE(s.steps(), steps + 1);
        const Stroke &straight = s.shape();
        QVERIFY(keepsValues(straight, bent));
        QVERIFY(movedSegments(straight, bent) > 2 && movedSegments(straight, bent) <= to - from);
        for (int k = 0; k < int(bent.segments.size()); ++k)
            if (k < from || k >= to)
                QCOMPARE(straight.segments[std::size_t(k)], bent.segments[std::size_t(k)]);
        QVERIFY2(wayBetween(straight) < wayBetween(bent),
                 qPrintable(QString("%1 %2").arg(wayBetween(straight)).arg(wayBetween(bent))));
        for (const int k : cornersOf(straight))
            QVERIFY(k <= from || k >= to); // one smooth curve
        QVERIFY(s.tool().nodes().empty());
        s.use(Command::Undo);
        QVERIFY(s.shape() == bent);
        // The end goes with the part that it stands for.
        s.tool().selectNodes({{s.trunk, nodeCount(bent) - 1}});
        s.use(Command::Delete);
        const std::vector<int> now = coarseNodes(bent, s.gap());
        QCOMPARE(int(s.shape().segments.size()), now[now.size() - 2]);
        s.use(Command::Undo);
        // Near enough to see all nodes, one node alone goes.
        s.canvas().setZoom(1e6);
        s.tool().selectNodes({{s.trunk, node}});
        s.use(Command::Delete);
        QCOMPARE(s.shape().segments.size(), bent.segments.size() - 1);
    }

    void theSameNodesStayDuringADrag()
    {
        SoftSession s;
        const std::vector<int> shown = coarseNodes(s.shape(), s.gap());
        const int node = s.shownNode();
        const Point from = nodePosition(s.shape(), node);
        s.drag(from, from + Point{90, 0});
        const Rect window = Rect::of(0, 0, s.canvas().view().width, s.canvas().view().height);
        int seen = 0;
        for (const int k : shown)
            if (window.contains(s.canvas().view().toPixels(nodePosition(s.shape(), k)))) {
                s.hover(nodePosition(s.shape(), k));
                QVERIFY2(s.canvas().cursor().shape() == Qt::SizeAllCursor, qPrintable(QString::number(k)));
                ++seen;
            }
        QVERIFY(seen > 8);
    }

    void aDraggedNodeBendsTheStroke()
    {
        SoftSession s;
        const Stroke before = s.shape();
        const int node = s.shownNode(), steps = s.steps();
        const Point from = nodePosition(before, node), to = from + Point{70, -10};
        s.drag(from, to);
        const Point by = s.sent(to) - s.sent(from);
        QCOMPARE(s.steps(), steps + 1);
        QVERIFY(length(nodePosition(s.shape(), node) - from - by) < 1e-3);
        QVERIFY(keepsValues(s.shape(), before));
        QVERIFY(cornersOf(s.shape()).empty());
        const int moved = movedSegments(s.shape(), before);
        QVERIFY2(moved > 80 && moved < int(before.segments.size()), qPrintable(QString::number(moved)));
        QVERIFY(length(nodePosition(s.shape(), node + 4) - nodePosition(before, node + 4) - by) < 0.1 * length(by));
        s.use(Command::Undo);
        QVERIFY(s.shape() == before);
        s.use(Command::Redo);
        QVERIFY(!(s.shape() == before));
    }

    void escapeRestores()
    {
        SoftSession s;
        const Stroke before = s.shape();
        const int steps = s.steps();
        const Point from = nodePosition(before, s.shownNode());
        s.drag(from, from + Point{70, -10}, {}, false);
        s.wheel(from + Point{70, -10}, 2);
        QVERIFY(!(s.shape() == before));
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QVERIFY(s.shape() == before);
        s.lift(from);
        QVERIFY(s.shape() == before);
        QCOMPARE(s.steps(), steps);
    }

    void theWheelChangesTheReachDuringTheDrag()
    {
        SoftSession s;
        const Stroke before = s.shape();
        const View view = s.canvas().view();
        const Point from = nodePosition(before, s.shownNode()), to = from + Point{40, 0};
        QVERIFY(s.follows()->isChecked());
        s.drag(from, to, {}, false);
        const int usual = movedSegments(s.shape(), before);
        const double reach = s.field()->value().value();
        s.wheel(to, 2);
        QVERIFY(movedSegments(s.shape(), before) > usual);
        QVERIFY(s.field()->value().value() > 1.3 * reach);
        for (int i = 0; i < 40; ++i)
            s.wheel(to, -1);
        QVERIFY(s.shape() == withNodeMoved(before, {s.tool().nodes().begin()->node}, s.sent(to) - s.sent(from)));
        QCOMPARE(s.field()->value().value(), 0.0);
        s.wheel(to, 3);
        const int least = movedSegments(s.shape(), before);
        QVERIFY(least > 4 && least < usual);
        QVERIFY(s.canvas().view() == view);
        s.lift(to);
        QVERIFY(!s.follows()->isChecked()); // it stays, and the wheel zooms again
        s.wheel(to, 1);
        QVERIFY(s.canvas().view() != view);
        s.follows()->click();
        QVERIFY(s.follows()->isChecked());
        QCOMPARE(s.field()->value(), // It shows the reach of the view.
                 std::optional(SoftReach::usual(s.canvas().view(), s.canvas().devicePixelRatioF())));
    }

    /// Where nobody has chosen a reach, a drag leaves the ends of a stroke; the field shows what is in use.
    void theEndsStay()
    {
        SoftSession s;
        const double usual = SoftReach::usual(s.canvas().view(), s.canvas().devicePixelRatioF());
        QCOMPARE(s.field()->value(), std::optional(usual));
        const Stroke before = s.shape();
        const std::vector<int> shown = coarseNodes(before, s.gap());
        int node = -1; // nearer to the foot than the reach
        double way = 0;
        for (int k = 0; k < int(before.segments.size()) && node < 0; ++k) {
            if (way > 0.5 * usual && std::ranges::find(shown, k) != shown.end())
                node = k;
            way += arcLength(offsetsOf(before.segments[std::size_t(k)]));
        }
        QVERIFY(node > 0 && way < 0.9 * usual);
        const Point from = nodePosition(before, node);
        s.drag(from, from + Point{40, 0});
        QVERIFY(length(nodePosition(s.shape(), node) - from) > 30);
        QCOMPARE(nodePosition(s.shape(), 0), nodePosition(before, 0));
        s.use(Command::Undo);
        emit s.field()->entered(usual); // chosen: all within it follows
        s.drag(from, from + Point{40, 0});
        QVERIFY(length(nodePosition(s.shape(), 0) - nodePosition(before, 0)) > 1);
    }

    void keysAndTheFieldChangeIt()
    {
        SoftSession s;
        const Stroke before = s.shape();
        emit s.field()->entered(60);
        const int node = s.shownNode();
        const Point from = nodePosition(before, node), to = from + Point{30, 0};
        s.drag(from, to);
        QVERIFY(s.shape() == SoftMove(before, std::vector<int>{node}, 60).by(s.sent(to) - s.sent(from)));
        s.use(Command::Undo);
        s.use(Command::LargerSize);
        QVERIFY(std::abs(s.field()->value().value() - 60 * std::sqrt(std::sqrt(2.0))) < 1e-6);
        s.use(Command::SmallerSize);
        QVERIFY(std::abs(s.field()->value().value() - 60) < 1e-6);
        emit s.field()->entered(0);
        s.drag(from, to);
        QVERIFY(s.shape() == withNodeMoved(before, {node}, s.sent(to) - s.sent(from)));
        SoftSession other; // it is remembered
        QCOMPARE(other.field()->value(), std::optional<double>(0));
    }

    void anAltDragSetsTheReachAlone()
    {
        SoftSession s;
        const Stroke before = s.shape();
        const int steps = s.steps();
        const Point from = nodePosition(before, s.shownNode());
        s.drag(from, from + Point{80, 0}, Qt::AltModifier);
        QVERIFY(s.shape() == before);
        QCOMPARE(s.steps(), steps);
        const double reach = s.field()->value().value();
        QVERIFY2(std::abs(reach - 80) < 2, qPrintable(QString::number(reach)));
        s.drag(from, from + Point{140, 0}, Qt::AltModifier, false);
        QVERIFY(s.field()->value().value() > 130);
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        s.lift(from);
        QCOMPARE(s.field()->value().value(), reach);
        s.drag(from, from + Point{2, 0}, Qt::AltModifier);
        s.drag(from + Point{30, 0}, from + Point{60, 0}); // beside the stroke: a band, which changes nothing
        QVERIFY(s.shape() == before);
    }

    void selectedNodesMoveSoftlyTogether()
    {
        SoftSession s;
        const Stroke before = s.shape();
        const std::vector<int> shown = coarseNodes(before, s.gap());
        const int a = shown[4], b = shown[8];
        s.tool().selectNodes({{s.trunk, a}, {s.trunk, b}});
        const Point from = nodePosition(before, a), to = from + Point{40, 5};
        s.drag(from, to);
        const Point by = s.sent(to) - s.sent(from);
        for (const int k : {a, b})
            QVERIFY(length(nodePosition(s.shape(), k) - nodePosition(before, k) - by) < 1e-3);
        const int between = (a + b) / 2;
        QVERIFY(length(nodePosition(s.shape(), between) - nodePosition(before, between)) > 0.5 * length(by));
    }

    void arrowsBendAsDragsDo()
    {
        SoftSession s;
        const Stroke before = s.shape();
        const int node = s.shownNode();
        s.tool().selectNodes({{s.trunk, node}});
        QTest::keyClick(&s.canvas(), Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(std::abs(nodePosition(s.shape(), node).x - nodePosition(before, node).x - 10) < 1e-3);
        QVERIFY(movedSegments(s.shape(), before) > 80);
    }

    void sparseStrokesAreMovedByOneNode()
    {
        SoftSession s;
        s.editor().document().setSelection({{s.id}, {}});
        const Stroke before = s.stroke();
        const Point from = nodePosition(before, 2), to = from + Point{20, 30};
        s.drag(from, to);
        QVERIFY(s.stroke() == withNodeMoved(before, {2}, s.sent(to) - s.sent(from)));
    }

    void theCurvePassesUnderThePointer()
    {
        SoftSession s;
        const Stroke before = s.shape();
        const int steps = s.steps();
        std::mt19937 random(3);
        const auto real = [&random](double a, double b) {
            return std::uniform_real_distribution<double>(a, b)(random);
        };
        int bends = 0;
        double farthest = 0;
        for (int i = 0; i < 400; ++i) {
            s.canvas().setZoom(i % 3 == 0 ? 1 : real(0.5, 3));
            const int segment = int(real(0, double(before.segments.size()) - 1));
            const Point from = before.cubicOf(before.segments[std::size_t(segment)]).at(real(0, 1));
            s.canvas().panBy(Point{0.5 * s.canvas().view().width, 0.5 * s.canvas().view().height} -
                             s.canvas().view().toPixels(from));
            s.hover(from);
            if (s.canvas().cursor().shape() != Qt::OpenHandCursor)
                continue; // a node
            const double px = 1 / s.canvas().view().scale;
            const Point to = from + px * Point{real(-250, 250), real(-200, 200)};
            double beside = 0, distance = 0;
            nearestPlace(before, s.sent(from), &beside); // the pointer stands on whole pixels
            s.drag(from, to);
            nearestPlace(s.shape(), s.sent(to), &distance);
            farthest = std::max(farthest, (distance - beside) / px);
            ++bends;
            QCOMPARE(s.steps(), steps + 1);
            QVERIFY(keepsValues(s.shape(), before));
            s.use(Command::Undo);
            QVERIFY(s.shape() == before);
        }
        qInfo() << bends << "bends, at most" << farthest << "pixels from the pointer";
        QVERIFY(bends > 100);
        QVERIFY(farthest <= 1);
    }

    void chainsAreBentApart()
    {
        SoftSession s;
        const int cut = int(s.shape().segments.size()) / 2;
        s.editor().push(changeStrokes(s.editor().document(), {s.trunk},
                                      [cut](Stroke &stroke) { stroke.segments[std::size_t(cut)].start = true; }),
                        "cut");
        const Stroke before = s.shape();
        const Point from = nodePosition(before, cut), to = from + Point{50, 0};
        s.drag(from, to);
        const bool second = !(s.shape().segments[std::size_t(cut)] == before.segments[std::size_t(cut)]);
        for (int k = 0; k < int(before.segments.size()); ++k) // one of the two ends that lie there
            if ((k < cut) == second)
                QVERIFY(s.shape().segments[std::size_t(k)] == before.segments[std::size_t(k)]);
        QVERIFY(movedSegments(s.shape(), before) > 40);
    }

    void lockedStrokesStay()
    {
        SoftSession s;
        const Point from = nodePosition(s.shape(), s.shownNode());
        s.hover(from);
        s.use(Command::LockStrokes);
        s.editor().document().setSelection({{s.trunk}, {}});
        const Stroke before = s.shape();
        s.drag(from, from + Point{40, 0});
        QVERIFY(s.shape() == before);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestSoftNodes)
#include "test_soft_nodes.moc"
