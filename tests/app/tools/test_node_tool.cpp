// Nodes, handles and segments under the hand: what the pointer makes of a stroke.
#include "app/panels/colour/colour_panel.h"
#include "model/colour/colour_shift.h"
#include "tests/app/nodes.h"

#include <QStatusBar>
#include <QTemporaryDir>

#include <numbers>

using namespace suffuse;

namespace {

double angleOf(Point p)
{
    return std::atan2(p.y, p.x);
}

} // namespace

class TestNodeTool : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void clicksAndBandsSelectNodes()
    {
        NodeSession s;
        s.click(nodePlace[1]);
        QCOMPARE(s.tool().nodes(), s.nodes({1}));
        s.click(nodePlace[3], Qt::ShiftModifier);
        QCOMPARE(s.tool().nodes(), s.nodes({1, 3}));
        s.click(nodePlace[1], Qt::ShiftModifier);
        QCOMPARE(s.tool().nodes(), s.nodes({3}));
        s.drag({350, 270}, {550, 380});
        QCOMPARE(s.tool().nodes(), s.nodes({2, 3}));
        s.drag({170, 270}, {230, 330}, Qt::ShiftModifier);
        QCOMPARE(s.tool().nodes(), s.nodes({0, 2, 3}));
        s.use(Command::SelectAll);
        QCOMPARE(s.tool().nodes(), s.nodes({0, 1, 2, 3, 4}));
        s.key(Qt::Key_Escape);
        QVERIFY(s.tool().nodes().empty());
        QCOMPARE(s.selection().strokes, std::set<StrokeId>{s.id});
        QCOMPARE(s.steps(), 1);
    }

    void nodesAndSegmentsAreNeverSelectedBoth()
    {
        NodeSession s;
        s.click(nodePlace[1]);
        s.click({350, 320});
        QVERIFY(s.tool().nodes().empty());
        QCOMPARE(s.selection().segments, (std::set<SegmentRef>{{s.id, 1}}));
        s.click({450, 320}, Qt::ShiftModifier);
        QCOMPARE(s.selection().segments, (std::set<SegmentRef>{{s.id, 1}, {s.id, 2}}));
        s.click({250, 320}, Qt::ControlModifier);
        QCOMPARE(s.selection().segments.size(), std::size_t(3));
        s.click(nodePlace[1]);
        QVERIFY(s.selection().segments.empty());
        QCOMPARE(s.tool().nodes(), s.nodes({1}));
        s.editor().document().setSelection({{s.id}, {{s.id, 0}}});
        QVERIFY(s.tool().nodes().empty());
    }

    void dragMovesTheNode_data()
    {
        QTest::addColumn<double>("degrees");
        QTest::addColumn<bool>("mirrored");
        QTest::addColumn<double>("scale");
        QTest::newRow("upright") << 0.0 << false << 1.0;
        QTest::newRow("turned") << 33.0 << false << 0.8;
        QTest::newRow("mirrored and turned") << -70.0 << true << 0.7;
        QTest::newRow("near") << 20.0 << true << 2000.0;
        QTest::newRow("far") << 0.0 << false << 0.5;
    }

    void dragMovesTheNode()
    {
        QFETCH(double, degrees);
        QFETCH(bool, mirrored);
        QFETCH(double, scale);
        NodeSession s;
        if (mirrored)
            s.canvas().mirror();
        s.canvas().rotateBy(degrees);
        s.canvas().setZoom(scale);
        const View &view = s.canvas().view();
        s.canvas().panBy(Point{0.5 * view.width, 0.5 * view.height} - view.toPixels(nodePlace[2]));
        const Stroke before = s.stroke();
        const Point to = nodePlace[2] + (1 / scale) * Point{60, -35};
        s.drag(nodePlace[2], to);
        const Point by = s.sent(to) - s.sent(nodePlace[2]);
        QCOMPARE(s.tool().nodes(), s.nodes({2}));
        QVERIFY(s.stroke() == withNodeMoved(before, {2}, by));
        QCOMPARE(s.steps(), 2);
        s.use(Command::Undo);
        QVERIFY(s.stroke() == before);
    }

    void dragsThatComeBackLeaveNoStep()
    {
        NodeSession s;
        const Stroke before = s.stroke();
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at(nodePlace[1]));
        s.move({330, 390});
        QVERIFY(!(s.stroke() == before));
        s.move(nodePlace[1]);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at(nodePlace[1]));
        QVERIFY(s.stroke() == before);
        QCOMPARE(s.steps(), 1);
        s.drag(nodePlace[1], {330, 390}, {}, false);
        QVERIFY(!(s.stroke() == before));
        s.key(Qt::Key_Escape);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({330, 390}));
        QVERIFY(s.stroke() == before);
        QCOMPARE(s.steps(), 1);
        s.drag(nodePlace[1], {330, 390}, {}, false);
        s.use(Command::Undo); // gives up what is in hand
        QVERIFY(s.stroke() == before);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({330, 390}));
        QCOMPARE(s.steps(), 1);
    }

    void anotherPaintingEndsTheDrag()
    {
        NodeSession s;
        s.drag(nodePlace[1], {330, 390}, {}, false);
        auto other = std::make_shared<Painting>();
        other->strokes = {wave(s.id, 100, 100)};
        s.editor().document().reset(other);
        s.move({350, 395});
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({350, 395}));
        QVERIFY(s.stroke() == *wave(s.id, 100, 100));
        QVERIFY(s.tool().nodes().empty());
    }

    /// The ends of a fill's gradient are dragged by their knobs.
    void theEndsOfAGradientAreDragged()
    {
        NodeSession s;
        const auto fill = [](Stroke &stroke) {
            Fill graded;
            graded.gradient = Gradient{toOffset({250, 420}, stroke.origin), toOffset({350, 420}, stroke.origin), {}};
            graded.gradient->colour = {0, 0, 0, 0};
            stroke.fill = graded;
        };
        s.editor().push(changeStrokes(s.editor().document(), {s.id}, fill), "fill");
        const int steps = s.steps();
        const auto end = [&](bool second) {
            const Gradient &gradient = *s.stroke().fill->gradient;
            return s.stroke().origin + (second ? gradient.to : gradient.from);
        };
        // The end that is transparent, on white paper, has a dark edge and the pattern of what is transparent.
        QImage shown(s.canvas().size() * s.canvas().devicePixelRatioF(), QImage::Format_RGB32);
        shown.fill(Qt::white);
        QPainter painter(&shown);
        s.canvas().tool()->paint(painter, s.canvas().view(), s.canvas().devicePixelRatioF());
        painter.end();
        const Point knob = s.canvas().view().toPixels({350, 420});
        const auto darkest = [&](double from, double to) {
            int least = 255;
            for (double r = from; r <= to; r += 0.5)
                least = std::min(least, qGray(shown.pixel(int(std::lround(knob.x)), int(std::lround(knob.y + r)))));
            return least;
        };
        QVERIFY(darkest(8.5, 11) < 200);
        QVERIFY(qGray(shown.pixel(int(knob.x) + 2, int(knob.y) - 3)) < 215);
        const Point before = s.sent({350, 420}), after = s.sent({380, 460});
        s.hover({350, 420});
        QVERIFY(s.canvas().tool()->hint().contains("gradient"));
        s.drag({350, 420}, {380, 460});
        QVERIFY(length(end(true) - (Point{350, 420} + after - before)) < 1e-3);
        QVERIFY(length(end(false) - Point{250, 420}) < 1e-3);
        QCOMPARE(s.steps(), steps + 1);
        s.drag({250, 420}, {200, 400}, Qt::ControlModifier, false);
        const Point arm = end(false) - end(true);
        const double turns = std::atan2(arm.y, arm.x) / (std::numbers::pi / 12);
        QVERIFY(std::abs(turns - std::round(turns)) < 1e-4);
        QTest::keyClick(&s.canvas(), Qt::Key_Escape); // gives it up
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, Qt::ControlModifier, s.at({200, 400}));
        QVERIFY(length(end(false) - Point{250, 420}) < 1e-3);
        QCOMPARE(s.steps(), steps + 1);
        s.use(Command::Undo);
        QVERIFY(length(end(true) - Point{350, 420}) < 1e-3);
    }

    void deleteWithAKnobChosenKeepsTheStroke()
    {
        NodeSession s;
        const auto fill = [](Stroke &stroke) {
            Fill graded;
            graded.gradient = Gradient{toOffset({250, 420}, stroke.origin), toOffset({350, 420}, stroke.origin), {}};
            stroke.fill = graded;
        };
        s.editor().push(changeStrokes(s.editor().document(), {s.id}, fill), "fill");
        const Stroke before = s.stroke();
        const std::size_t count = s.painting().strokes.size();
        s.click({350, 420});
        s.use(Command::Delete);
        QCOMPARE(s.painting().strokes.size(), count);
        QVERIFY(s.stroke() == before);
        QVERIFY2(s.window.statusBar()->currentMessage().contains("gradient"),
                 qPrintable(s.window.statusBar()->currentMessage()));
        const Offset to = before.fill->gradient->to;
        s.key(Qt::Key_Right);
        QCOMPARE(s.stroke().fill->gradient->to, (Offset{to.x + 1, to.y}));
        s.key(Qt::Key_Down, Qt::ShiftModifier);
        QCOMPARE(s.stroke().fill->gradient->to, (Offset{to.x + 1, to.y + 10}));
        QVERIFY(s.stroke().origin == before.origin && s.stroke().segments == before.segments);
        QCOMPARE(s.stroke().fill->gradient->from, before.fill->gradient->from);
        s.key(Qt::Key_Escape); // From now on Delete means the stroke, which is selected still.
        QCOMPARE(s.selection().strokes, std::set<StrokeId>{s.id});
        s.use(Command::Delete);
        QCOMPARE(s.painting().strokes.size(), count - 1);
    }

    void aChosenKnobTakesColours()
    {
        NodeSession s;
        const auto fill = [](Stroke &stroke) {
            Fill graded;
            graded.colour = {0.2f, 0.3f, 0.4f, 0.75f};
            graded.gradient = Gradient{toOffset({250, 420}, stroke.origin), toOffset({350, 420}, stroke.origin), {}};
            graded.gradient->colour = {0, 0, 0, 0};
            stroke.fill = graded;
        };
        s.editor().push(changeStrokes(s.editor().document(), {s.id}, fill), "fill");
        const Stroke before = s.stroke();
        ColourTarget &target = s.editor().colourTarget();
        const auto first = [&s] { return s.stroke().fill->colour; };
        const auto second = [&s] { return s.stroke().fill->gradient->colour; };
        const Colour green{0, 1, 1, 1};

        // The end was transparent; nobody would see its colour.
        s.click({350, 420});
        QCOMPARE(target.title(), QString("Colour of the gradient's end"));
        const int steps = s.steps();
        target.take(green);
        QCOMPARE(second(), (Colour{0, 1, 1, 0.75f}));
        QVERIFY(first() == before.fill->colour && s.stroke().segments == before.segments);
        QCOMPARE(s.steps(), steps + 1);
        target.setOpacity(0.5f);
        QCOMPARE(second(), (Colour{0, 1, 1, 0.5f}));
        s.use(Command::Undo);
        s.use(Command::Undo);
        QVERIFY(s.stroke() == before);

        // By a field of the dock; the other end keeps its opacity.
        s.click({250, 420});
        QCOMPARE(target.title(), QString("Colour of the gradient's start"));
        emit s.window.findChild<ColourPanel *>()->hex()->typed("#ff0000");
        QVERIFY(first() != before.fill->colour && first().opacity == 0.75f);
        QVERIFY(second() == before.fill->gradient->colour && s.stroke().segments == before.segments);
        s.use(Command::Undo);

        // By the eyedropper, which leaves the knob chosen.
        s.use(Command::Eyedropper);
        s.dry();
        s.click({300, 340});
        QVERIFY(first() != before.fill->colour);
        QVERIFY(second() == before.fill->gradient->colour && s.stroke().segments == before.segments);
        s.use(Command::Undo);
        QVERIFY(s.stroke() == before);

        // The brush, where the user wants that; another choice of the knob means the knob again.
        s.use(Command::Segments);
        target.choose(ColourTarget::Kind::Brush);
        target.take(green);
        QVERIFY(s.stroke() == before && samePaint(s.editor().brush().colour, green));
        s.click({250, 420});
        target.take(green);
        QVERIFY(first() != before.fill->colour);
        s.use(Command::Undo);

        // Without it all is as it was.
        s.key(Qt::Key_Escape);
        target.take(green);
        QVERIFY(first() != before.fill->colour && s.stroke().segments != before.segments);
        s.use(Command::Undo);
        s.click({250, 420});
        s.use(Command::Brush);
        QCOMPARE(target.kind(), ColourTarget::Kind::Brush);
    }

    void tabAndTheViewWaitForTheEndOfADrag()
    {
        NodeSession s;
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        for (const Command tool : {Command::Segments, Command::Select, Command::Brush}) {
            s.use(tool);
            s.canvas().setFocus();
            const View before = s.canvas().view();
            s.drag({250, 320}, {260, 330}, {}, false);
            for (const Qt::Key key : {Qt::Key_Tab, Qt::Key_Backtab}) {
                if (tool != Command::Brush || key == Qt::Key_Backtab) // Tab would hide the docks afterwards.
                    s.key(key, key == Qt::Key_Backtab ? Qt::ShiftModifier : Qt::NoModifier);
                QCOMPARE(QApplication::focusWidget(), static_cast<QWidget *>(&s.canvas()));
            }
            for (const Command command : {Command::Mirror, Command::RotateLeft, Command::ZoomIn, Command::Zoom100,
                                          Command::Fit, Command::ZoomToSelection})
                s.use(command);
            QVERIFY(s.canvas().view() == before);
            QVERIFY(!s.window.action(Command::Mirror).isChecked());
            QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({260, 330}));
            s.use(Command::Mirror);
            QVERIFY(s.canvas().view().mirrored);
            s.use(Command::Mirror);
        }
    }

    void tabWithNothingSelectedLeavesTheDocks()
    {
        NodeSession s;
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        s.editor().document().setSelection({});
        s.key(Qt::Key_Tab);
        QVERIFY(!s.window.action(Command::HideDocks).isChecked());
        QCOMPARE(QApplication::focusWidget(), static_cast<QWidget *>(&s.canvas()));
    }

    /// A knob on a node is the ring around it.
    void anEndOfAGradientOnANodeIsDraggedByItsRing()
    {
        NodeSession s;
        const auto fill = [](Stroke &stroke) {
            Fill graded;
            graded.gradient =
                Gradient{toOffset(nodePlace[0], stroke.origin), toOffset(nodePlace[4], stroke.origin), {}};
            stroke.fill = graded;
        };
        s.editor().push(changeStrokes(s.editor().document(), {s.id}, fill), "fill");
        const Stroke before = s.stroke();
        const Point ring = nodePlace[4] + Point{0, -7};
        s.hover(ring);
        QVERIFY(s.canvas().tool()->hint().contains("gradient"));
        s.drag(ring, ring + Point{30, 40});
        QCOMPARE(nodePosition(s.stroke(), 4), nodePosition(before, 4));
        const Point end = s.stroke().origin + s.stroke().fill->gradient->to;
        QVERIFY(length(end - (nodePlace[4] + Point{30, 40})) < 1.5);
        s.use(Command::Undo);
        s.drag(nodePlace[4], nodePlace[4] + Point{30, 40});
        QVERIFY(length(nodePosition(s.stroke(), 4) - (nodePlace[4] + Point{30, 40})) < 1.5);
        QCOMPARE(s.stroke().fill->gradient->to, before.fill->gradient->to);
    }

    /// Taps of the arrow keys that follow each other are one step of the nodes that are selected.
    void nudgesOfNodesAreOneStep()
    {
        NodeSession s;
        const int before = s.editor().undoStack().count();
        s.tool().selectNodes(s.nodes({1}));
        for (int i = 0; i < 4; ++i)
            s.key(Qt::Key_Right);
        QCOMPARE(s.editor().undoStack().count(), before + 1);
        s.tool().selectNodes(s.nodes({2}));
        s.key(Qt::Key_Right);
        s.key(Qt::Key_Down);
        QCOMPARE(s.editor().undoStack().count(), before + 2);
    }

    void severalNodesMoveTogether()
    {
        NodeSession s;
        const Stroke before = s.stroke();
        s.drag({350, 270}, {550, 380});
        s.drag(nodePlace[3], {500, 400});
        const Point by = s.sent({500, 400}) - s.sent(nodePlace[3]);
        QVERIFY(s.stroke() == withNodeMoved(before, {2, 3}, by));
    }

    void nodesSnapToOthersAndToTheGrid()
    {
        NodeSession s;
        s.addWave(230, 450, false);
        s.canvas().setAids({.snapToNodes = true, .snapToGrid = true, .gridStep = 50});
        s.drag(nodePlace[2], {427, 453}); // (430, 450) is a node of the other
        QVERIFY(length(nodePosition(s.stroke(), 2) - Point{430, 450}) < 1e-4);
        s.drag(nodePosition(s.stroke(), 2), {398, 203});
        QVERIFY(length(nodePosition(s.stroke(), 2) - Point{400, 200}) < 1e-4);
    }

    void controlKeepsAnAxisAndWithAltTheHandle()
    {
        NodeSession s;
        const Stroke before = s.stroke();
        s.drag(nodePlace[1], {310, 400}, Qt::ControlModifier);
        QCOMPARE(nodePosition(s.stroke(), 1).x, nodePosition(before, 1).x);
        QVERIFY(std::abs(nodePosition(s.stroke(), 1).y - 400) < 2);
        s.use(Command::Undo);
        s.drag(nodePlace[1], {330, 370}, Qt::ControlModifier | Qt::AltModifier); // its handles are level
        QCOMPARE(nodePosition(s.stroke(), 1).y, nodePosition(before, 1).y);
        QVERIFY(std::abs(nodePosition(s.stroke(), 1).x - 330) < 2);
    }

    void handlesKeepTheKindOfTheirNode()
    {
        NodeSession s;
        s.click(nodePlace[2]);
        const Stroke before = s.stroke();
        const Point handle = *handlePosition(before, 2, true), to = handle + Point{-5, -30};
        s.drag(handle, to);
        const Point moved = handle + (s.sent(to) - s.sent(handle));
        QVERIFY(s.stroke() == withHandleMoved(before, 2, true, moved));
        const Point node = nodePosition(s.stroke(), 2);
        const Point after = *handlePosition(s.stroke(), 2, true) - node,
                    other = *handlePosition(s.stroke(), 2, false) - node;
        QVERIFY(std::abs(cross(after, other)) < 1e-3 * length(after) * length(other));
        QVERIFY(dot(after, other) < 0);
        QCOMPARE(s.steps(), 2);
        s.use(Command::Undo);

        s.drag(handle, to, Qt::ShiftModifier);
        QCOMPARE(nodeKind(s.stroke(), 2), NodeKind::Corner);
        QCOMPARE(*handlePosition(s.stroke(), 2, false), *handlePosition(before, 2, false));
        s.use(Command::Undo);
        QVERIFY(s.stroke() == before);

        s.drag(handle, handle + Point{-4, -31}, Qt::ControlModifier);
        const double steps = angleOf(*handlePosition(s.stroke(), 2, true) - node) / (std::numbers::pi / 12);
        QVERIFY(std::abs(steps - std::round(steps)) < 1e-4);
    }

    void handlesOfNeighboursCanBeDragged()
    {
        NodeSession s;
        s.click(nodePlace[2]);
        const Stroke before = s.stroke();
        const Point handle = *handlePosition(before, 3, false);
        s.drag(handle, handle + Point{0, 25});
        QVERIFY(!(s.stroke() == before));
        QCOMPARE(nodePosition(s.stroke(), 3), nodePosition(before, 3));
        QCOMPARE(s.tool().nodes(), s.nodes({2}));
    }

    void theCurveBends()
    {
        NodeSession s;
        const Stroke before = s.stroke();
        const Point middle = before.cubicOf(before.segments[1]).at(0.5), to = middle + Point{15, -40};
        s.drag(middle, to);
        QCOMPARE(s.steps(), 2);
        double distance = 0;
        const CurvePlace place = nearestPlace(s.stroke(), s.sent(to), &distance);
        QCOMPARE(place.segment, 1);
        QVERIFY(distance < 2);
        for (int k = 0; k < 5; ++k)
            QCOMPARE(nodePosition(s.stroke(), k), nodePosition(before, k));
        QVERIFY(s.stroke().segments[3] == before.segments[3]);
    }

    void doubleClickInsertsANodeAndThePictureStays()
    {
        NodeSession s;
        const QImage before = s.pictureNow();
        const Stroke stroke = s.stroke();
        const Point place = stroke.cubicOf(stroke.segments[1]).at(0.4);
        s.click(place);
        QCOMPARE(s.selection().segments.size(), std::size_t(1));
        QTest::mouseDClick(&s.canvas(), Qt::LeftButton, {}, s.at(place));
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at(place));
        QCOMPARE(nodeCount(s.stroke()), 6);
        QCOMPARE(s.tool().nodes(), s.nodes({2}));
        QCOMPARE(s.steps(), 2);
        QVERIFY(length(nodePosition(s.stroke(), 2) - place) < 2);
        QVERIFY(largestDifference(before, s.pictureNow()) <= 1);
        s.use(Command::Undo);
        QVERIFY(s.stroke() == stroke);
    }

    void lockedStrokesAreLeftAlone()
    {
        NodeSession s;
        s.editor().push(changeStrokes(s.editor().document(), {s.id}, [](Stroke &stroke) { stroke.locked = true; }),
                        "lock");
        const Stroke before = s.stroke();
        s.drag(nodePlace[2], {400, 200});
        s.use(Command::SelectAll);
        s.use(Command::Delete);
        QVERIFY(s.stroke() == before);
        QVERIFY(s.tool().nodes().empty());
    }

    void hintsSayWhatIsUnderThePointer()
    {
        NodeSession s;
        std::set<QString> hints{s.tool().hint()};
        s.hover(nodePlace[1]);
        hints.insert(s.tool().hint());
        s.hover({350, 320});
        hints.insert(s.tool().hint());
        s.click(nodePlace[1]);
        s.hover(*handlePosition(s.stroke(), 1, true));
        hints.insert(s.tool().hint());
        QCOMPARE(hints.size(), std::size_t(4));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestNodeTool)
#include "test_node_tool.moc"
