// Knife, eraser, attribute brush and eyedropper under the hand.
#include "app/tools/brush/attribute_brush_tool.h"
#include "app/tools/shaping/eraser_tool.h"
#include "app/tools/shaping/knife_tool.h"
#include "app/tools/tool_options.h"
#include "model/painting/validate.h"
#include "render/probe.h"
#include "tests/app/shapes.h"

#include <QLabel>
#include <QLineEdit>
#include <QStackedWidget>
#include <QTemporaryDir>

#include <random>

using namespace suffuse;

namespace {

/// The least distance of the painting's curves to a point.
double nearestCurve(const Painting &painting, Point point)
{
    double least = 1e9;
    for (const StrokePtr &stroke : painting.strokes) {
        double distance = 0;
        nearestPlace(*stroke, point, &distance);
        least = std::min(least, distance);
    }
    return least;
}

std::size_t segmentsOf(const Painting &painting)
{
    return painting.segmentCount();
}

} // namespace

class TestShapeTools : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    /// A tool without settings has a row all the same, which says what it does.
    void theKnifesRowSaysWhatItDoes()
    {
        WaveSession s;
        s.use(Command::Knife);
        const QWidget *row = s.canvas().tool()->options();
        QVERIFY(row && row->isVisible());
        QVERIFY(row->findChild<QLabel *>()->text().contains("nodes"));
    }

    void knifeInsertsNodesAndThePictureStays()
    {
        WaveSession s;
        const StrokeId other = s.addWave(200, 450, false);
        const QImage picture = s.pictureNow();
        const Stroke before = s.stroke(), otherBefore = s.stroke(other);
        s.use(Command::Knife);
        s.drag({360, 250}, {345, 550}); // over both, but only one is selected
        QCOMPARE(s.steps(), 3);
        QCOMPARE(nodeCount(s.stroke()), 6);
        QVERIFY(s.stroke(other) == otherBefore);
        QVERIFY(largestDifference(picture, s.pictureNow()) <= 1);
        s.use(Command::Undo);
        QVERIFY(s.stroke() == before);
        s.editor().document().setSelection({});
        s.drag({360, 250}, {345, 550});
        QCOMPARE(nodeCount(s.stroke()), 6);
        QCOMPARE(nodeCount(s.stroke(other)), 6);
        QCOMPARE(s.steps(), 3);
        QVERIFY(largestDifference(picture, s.pictureNow()) <= 1);
    }

    void knifeSaysWhatItDid()
    {
        WaveSession s;
        s.addWave(200, 450, false);
        s.use(Command::Knife);
        const auto hint = [&] { return s.canvas().tool()->hint(); };
        const QString usual = hint();
        s.drag({360, 250}, {345, 550}); // two strokes, of which one is selected
        QCOMPARE(hint(), QStringLiteral("1 node(s) inserted in 1 stroke(s)"));
        s.use(Command::Undo);
        QCOMPARE(hint(), usual); // it has gone with what it told of
        s.drag({700, 250}, {700, 550});
        QCOMPARE(hint(), QStringLiteral("The line crosses no selected stroke."));
        s.editor().document().setSelection({});
        s.drag({360, 250}, {345, 550}, Qt::ShiftModifier);
        QCOMPARE(hint(), QStringLiteral("2 stroke(s) cut into 4 part(s)"));
        s.drag({700, 250}, {700, 550}, {}, false);
        QCOMPARE(hint(), usual);
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
    }

    void knifeWithShiftCutsApart()
    {
        WaveSession s;
        const auto before = s.editor().document().painting();
        s.use(Command::Knife);
        s.drag({360, 250}, {345, 400}, Qt::ShiftModifier);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1)); // one stroke, so that the picture stays
        QCOMPARE(chainsOf(s.stroke()).size(), std::size_t(2));
        QCOMPARE(segmentsOf(s.painting()), std::size_t(5));
        QCOMPARE(s.selection().strokes, std::set<StrokeId>{s.id});
        s.use(Command::Undo);
        QVERIFY(s.painting() == *before);
        s.drag({360, 250}, {345, 400}, Qt::ShiftModifier, false);
        s.use(Command::Undo); // what is in hand is given up
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, Qt::ShiftModifier, s.at({345, 400}));
        QVERIFY(s.painting() == *before);
    }

    void knifeLeavesLockedStrokesAlone()
    {
        WaveSession s;
        s.editor().push(changeStrokes(s.editor().document(), {s.id}, [](Stroke &t) { t.locked = true; }), "lock");
        s.use(Command::Knife);
        s.drag({360, 250}, {345, 400});
        QCOMPARE(nodeCount(s.stroke()), 5);
        QCOMPARE(s.steps(), 2);
    }

    void eraserShowsItsWorkWhileItDrags()
    {
        WaveSession s;
        s.editor().document().setSelection({});
        const auto before = s.editor().document().painting();
        const QImage picture = s.pictureNow();
        s.use(Command::Eraser);
        auto &eraser = *qobject_cast<EraserTool *>(s.canvas().tool());
        eraser.setRadius(12);
        s.drag({350, 260}, {350, 380}, Qt::ShiftModifier, false); // cuts
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));    // the button is still down
        QCOMPARE(chainsOf(s.stroke()).size(), std::size_t(2));
        const Point crossing = before->strokes[0]->cubicOf(before->strokes[0]->segments[1]).at(0.5);
        QVERIFY(nearestCurve(s.painting(), crossing) > 11);
        QVERIFY(s.pictureNow() != picture);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({350, 380}));
        QCOMPARE(s.steps(), 2);
        QVERIFY(s.painting().strokes[0]->segments[0] == before->strokes[0]->segments[0]); // untouched: same bits
        const auto erased = s.editor().document().painting();
        s.use(Command::Undo);
        QVERIFY(s.painting() == *before);
        QCOMPARE(s.pictureNow(), picture);
        s.use(Command::Redo);
        QVERIFY(s.painting() == *erased);
    }

    void eraserGivesUp()
    {
        WaveSession s;
        const auto before = s.editor().document().painting();
        const Selection selection = s.selection();
        s.use(Command::Eraser);
        s.drag({250, 260}, {450, 380}, Qt::ShiftModifier, false);
        QVERIFY(!(s.painting() == *before));
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({450, 380}));
        QVERIFY(s.painting() == *before);
        QCOMPARE(s.selection(), selection);
        QCOMPARE(s.steps(), 1);
        s.drag({250, 500}, {450, 500}); // over nothing
        QCOMPARE(s.steps(), 1);
    }

    void eraserKeepsToTheSelection()
    {
        WaveSession s;
        const StrokeId other = s.addWave(200, 340, false);
        const Stroke otherBefore = s.stroke(other);
        s.use(Command::Eraser);
        // All of the selected stroke goes; the other is spared to the end of the drag.
        qobject_cast<EraserTool *>(s.canvas().tool())->setRadius(90);
        s.drag({180, 320}, {620, 320}, Qt::ShiftModifier);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QVERIFY(s.stroke(other) == otherBefore);
    }

    void bracketsChangeTheSize()
    {
        WaveSession s;
        s.window.activateWindow(); // shortcuts are its
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.use(Command::Eraser);
        auto &eraser = *qobject_cast<EraserTool *>(s.canvas().tool());
        const double radius = eraser.radius();
        QTest::keyClick(&s.canvas(), Qt::Key_BracketRight);
        QVERIFY(eraser.radius() > 1.1 * radius);
        QTest::keyClick(&s.canvas(), Qt::Key_BracketLeft);
        QVERIFY(std::abs(eraser.radius() - radius) < 1e-9);
        auto *bar = s.window.findChild<ToolOptionsBar *>("toolOptions");
        QVERIFY(bar);
        QVERIFY(eraser.options()->isVisible());
        auto *size = eraser.options()->findChild<QLineEdit *>();
        size->setFocus();
        size->selectAll();
        QTest::keyClicks(size, "33");
        QTest::keyClick(size, Qt::Key_Return);
        QCOMPARE(eraser.radius(), 16.5);
        QTRY_VERIFY(!size->hasFocus());
        s.use(Command::Pan);
        QVERIFY(!eraser.options()->isVisible());
    }

    void thePensOtherEndErases()
    {
        WaveSession s;
        s.editor().document().setSelection({});
        s.use(Command::Brush);
        QPointingDevice device("eraser end", 8, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Eraser,
                               QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 1);
        const auto send = [&](QEvent::Type type, Point where, double pressure) {
            const QPointF at = s.at(where);
            QTabletEvent event(type, &device, at, s.canvas().mapToGlobal(at), pressure, 0, 0, 0, 0, 0, {},
                               type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton,
                               type == QEvent::TabletRelease ? Qt::NoButton : Qt::LeftButton);
            QCoreApplication::sendEvent(&s.canvas(), &event);
        };
        send(QEvent::TabletPress, {350, 260}, 0.5);
        QVERIFY(s.window.action(Command::Eraser).isChecked());
        send(QEvent::TabletMove, {350, 320}, 0.5);
        send(QEvent::TabletMove, {350, 380}, 0.5);
        send(QEvent::TabletRelease, {350, 380}, 0);
        QVERIFY(s.stroke().hasErasure());
        QCOMPARE(s.steps(), 2);
        Pen pen;
        pen.send(s.canvas(), QEvent::TabletPress, s.at({300, 500}), 0.5);
        QVERIFY(s.window.action(Command::Brush).isChecked());
        pen.send(s.canvas(), QEvent::TabletRelease, s.at({300, 500}), 0);
    }

    void attributeBrushPaintsWithAFalloff()
    {
        WaveSession s;
        const Stroke before = s.stroke();
        s.use(Command::AttributeBrush);
        auto &brush = *qobject_cast<AttributeBrushTool *>(s.canvas().tool());
        brush.setRadius(150);
        brush.setFlow(0.5);
        brush.setWish({.attribute = Attribute::Density, .relative = true, .value = 3, .colour = {}});
        s.click({350, 320}); // the middle of the second segment; those of its neighbours are 100 away
        QCOMPARE(s.steps(), 2);
        const auto factor = [&](std::size_t k) { return s.stroke().segments[k].density / before.segments[k].density; };
        QVERIFY(std::abs(factor(1) - std::pow(3, 0.5)) < 0.01);
        const double beside = std::pow(3, 0.5 * falloff(100, 150));
        QVERIFY(std::abs(factor(0) - beside) < 0.02);
        QVERIFY(std::abs(factor(2) - beside) < 0.02);
        QVERIFY(s.stroke().segments[3] == before.segments[3]);
        QCOMPARE(s.stroke().segments[1].diffusion, before.segments[1].diffusion);
        s.use(Command::Undo);
        QVERIFY(s.stroke() == before);
    }

    void attributeBrushLaysDownMoreWhereItStays()
    {
        WaveSession s;
        const Stroke before = s.stroke();
        s.use(Command::AttributeBrush);
        auto &brush = *qobject_cast<AttributeBrushTool *>(s.canvas().tool());
        brush.setRadius(60);
        brush.setFlow(0.3);
        brush.setWish({.attribute = Attribute::Granulation, .relative = false, .value = 0, .colour = {}});
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({350, 320}));
        const float atOnce = s.stroke().segments[1].granulation;
        QVERIFY(std::abs(atOnce - 0.7f) < 0.01f);
        QTRY_VERIFY_WITH_TIMEOUT(s.stroke().segments[1].granulation < 0.01f, waitMs);
        QVERIFY(s.stroke().segments[1].granulation >= 0);
        QCOMPARE(s.stroke().segments[3].granulation, 1.0f);
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({350, 320}));
        QVERIFY(s.stroke() == before);
        QCOMPARE(s.steps(), 1);
    }

    void attributeBrushKeepsToSelectionAndLocks()
    {
        WaveSession s;
        const StrokeId locked = s.addWave(200, 310, false), other = s.addWave(200, 320, false);
        s.editor().push(changeStrokes(s.editor().document(), {locked}, [](Stroke &t) { t.locked = true; }), "lock");
        const Stroke lockedBefore = s.stroke(locked), otherBefore = s.stroke(other);
        const Stroke before = s.stroke();
        s.editor().document().setSelection({{s.id, locked}, {{s.id, 1}}});
        s.use(Command::AttributeBrush);
        auto &brush = *qobject_cast<AttributeBrushTool *>(s.canvas().tool());
        brush.setRadius(200);
        brush.setWish({.attribute = Attribute::Colour, .relative = false, .value = 1, .colour = {}});
        s.editor().setColour({0, 1, 0, 0.3f});
        s.drag({220, 320}, {580, 320});
        QVERIFY(s.stroke(locked) == lockedBefore);
        QVERIFY(s.stroke(other) == otherBefore);
        QVERIFY(s.stroke().segments[0] == before.segments[0]);
        const Colour painted = s.stroke().segments[1].colour;
        QVERIFY(painted.yellow > before.segments[1].colour.yellow);
        QVERIFY(painted.red < before.segments[1].colour.red);
        QCOMPARE(painted.opacity, before.segments[1].colour.opacity);
        QCOMPARE(s.editor().undoStack().undoText(), AttributeBrushTool::tr("Paint colour"));
    }

    void attributesStayInTheirDomains()
    {
        const Segment segment;
        for (const Attribute attribute : allAttributes)
            for (const bool relative : {false, true})
                for (const double value : {-1.0, 0.0, 0.5, 1000.0})
                    for (const double share : {0.0, 0.3, 1.0}) {
                        const Segment changed =
                            withAttribute(segment, {attribute, relative, value, {1, 1, 1, 1}}, share);
                        QCOMPARE(problemOf(changed), QString());
                        if (share == 0)
                            QVERIFY(changed == segment);
                    }
        QCOMPARE(withAttribute(segment, {Attribute::Diffusion, false, 50, {}}, 1).diffusion, 50.0f);
        QCOMPARE(withAttribute(segment, {Attribute::Diffusion, false, 50, {}}, 0.5).diffusion, 25.0f); // 12.5 → 25 → 50
        QCOMPARE(withAttribute(segment, {Attribute::MaxAge, true, 4, {}}, 0.5).maxAge, 2.0f);
        QCOMPARE(falloff(0, 10), 1.0);
        QVERIFY(std::abs(falloff(5, 10) - 0.5) < 1e-12);
        QCOMPARE(falloff(10, 10), 0.0);
    }

    void eyedropperPicksThePictureAndTheStroke()
    {
        WaveSession s;
        const Point place = s.stroke().cubicOf(s.stroke().segments[1]).at(0.5);
        s.use(Command::Eyedropper);
        s.editor().setColour({0.1f, 0.2f, 0.3f, 0.4f});
        s.click(place);
        const Result<Probe> found = probe(s.painting(), s.editor().clock().time(), s.sent(place).x, s.sent(place).y);
        const Colour picked = s.editor().brush().colour;
        QCOMPARE(picked.red, float(found->strokes.back().rybAfter[0]));
        QCOMPARE(picked.yellow, float(found->strokes.back().rybAfter[1]));
        QCOMPARE(picked.blue, float(found->strokes.back().rybAfter[2]));
        QCOMPARE(picked.opacity, 0.4f);
        s.click(place, Qt::ShiftModifier);
        QCOMPARE(s.editor().brush().colour, s.stroke().segments[1].colour);
        s.click({300, 500}); // bare paper
        QCOMPARE(s.editor().brush().colour, (Colour{0, 0, 0, s.stroke().segments[1].colour.opacity}));
        QCOMPARE(s.steps(), 1);

        s.drag(place, {400, 500}, {}, false);
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({400, 500}));
        QCOMPARE(s.editor().brush().colour.red, 0.0f);
    }

    void besideTheCanvasThereIsNoColourToPick()
    {
        WaveSession s;
        const Colour before{0.1f, 0.2f, 0.3f, 0.4f};
        const Point beside{-20, 300};
        s.editor().setColour(before);
        const auto said = [&s] { return s.canvas().tool()->hint().contains("Beside the canvas"); };
        s.use(Command::Eyedropper);
        s.click(beside);
        QCOMPARE(s.editor().brush().colour, before);
        QVERIFY(said());
        s.use(Command::Brush);
        s.click(beside, Qt::ControlModifier);
        QCOMPARE(s.editor().brush().colour, before);
        QVERIFY(said());
        s.use(Command::Eyedropper);
        s.window.action(Command::ShowBeyond).setChecked(true);
        s.click(beside);
        QVERIFY(!said());
        QCOMPARE(s.editor().brush().colour.red, 0.0f);
        s.window.action(Command::ShowBeyond).setChecked(false);
    }

    /// Within a fill it is the fill that paints: the eyedropper takes its colour, and the attribute brush paints it.
    void fillsArePickedAndPainted()
    {
        WaveSession s;
        const Point within{300, 308}; // between the wave and the line that closes it
        const Colour green{0.1f, 0.8f, 0.6f, 1};
        const auto fill = [&](Stroke &stroke) {
            for (Segment &segment : stroke.segments)
                segment.density = 0;
            Fill painted;
            painted.diffusion = 1;
            painted.colour = green;
            stroke.fill = painted;
        };
        s.editor().push(changeStrokes(s.editor().document(), {s.id}, fill), "fill");
        s.editor().clock().setTime(s.painting().end());
        s.use(Command::Eyedropper);
        s.editor().colourTarget().choose(ColourTarget::Kind::Brush);
        s.click(within, Qt::ShiftModifier);
        QCOMPARE(s.editor().brush().colour, green);

        s.use(Command::AttributeBrush);
        auto *tool = static_cast<AttributeBrushTool *>(s.canvas().tool());
        tool->setFlow(1);
        s.editor().setColour({1, 0, 0, 1});
        tool->setWish({Attribute::Colour, false, 1, {}});
        s.click(within);
        QCOMPARE(s.stroke().fill->colour, (Colour{1, 0, 0, 1}));
        tool->setWish({Attribute::Density, true, 2, {}});
        s.click(within);
        QCOMPARE(s.stroke().fill->density, 2.0f);
        QCOMPARE(s.stroke().segments[0].density, 0.0f);
        // A line's density means nothing there, and the status bar says so.
        const QString usual = tool->hint();
        const int steps = s.steps();
        tool->setWish({Attribute::Density, false, 5, {}});
        s.click(within);
        QCOMPARE(s.steps(), steps);
        QVERIFY(tool->hint() != usual);
    }

    void brushWithControlPicks()
    {
        WaveSession s;
        const Point place = s.stroke().cubicOf(s.stroke().segments[1]).at(0.5);
        s.use(Command::Brush);
        s.click(place, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(s.editor().brush().colour, s.stroke().segments[1].colour);
        s.click({300, 500}, Qt::ControlModifier);
        QCOMPARE(s.editor().brush().colour.blue, 0.0f);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(s.steps(), 1);
        QVERIFY(!s.canvas().tool()->isBusy());
    }

    /// Whatever tools, buttons and keys do in whatever order: the painting stays sound, and undo leads back.
    void aWildHandCanBeUndone_data()
    {
        QTest::addColumn<unsigned>("seed");
        for (const unsigned seed : {1u, 2u, 3u})
            QTest::addRow("%u", seed) << seed;
    }

    void aWildHandCanBeUndone()
    {
        QFETCH(unsigned, seed);
        WaveSession s;
        s.addWave(230, 380, false);
        s.addWave(180, 420, true);
        std::mt19937 random(seed);
        const auto below = [&](int n) { return int(random() % unsigned(n)); };
        const auto place = [&] { return Point{150.0 + below(500), 250.0 + below(250)}; };
        const Command tools[] = {Command::Brush,          Command::Select,     Command::Segments, Command::Segments,
                                 Command::Segments,       Command::Knife,      Command::Eraser,   Command::Eraser,
                                 Command::AttributeBrush, Command::Eyedropper, Command::Pan};
        const Command commands[] = {Command::Undo,           Command::Undo,           Command::Redo,
                                    Command::Delete,         Command::SelectAll,      Command::SelectAll,
                                    Command::NodeCorner,     Command::NodeSmooth,     Command::NodeSymmetric,
                                    Command::InsertNodes,    Command::BreakNodes,     Command::JoinNodes,
                                    Command::DeleteSegments, Command::BridgeSegments, Command::ReverseStrokes};
        const Qt::KeyboardModifiers modifiers[] = {Qt::NoModifier,    Qt::NoModifier,
                                                   Qt::ShiftModifier, Qt::ControlModifier,
                                                   Qt::AltModifier,   Qt::ShiftModifier | Qt::ControlModifier};
        const Qt::Key keys[] = {Qt::Key_Escape, Qt::Key_Tab, Qt::Key_Backtab,     Qt::Key_Left,
                                Qt::Key_Down,   Qt::Key_Tab, Qt::Key_BracketLeft, Qt::Key_BracketRight};
        bool down = false;
        Point at = place();
        for (int i = 0; i < 1200; ++i) {
            const Qt::KeyboardModifiers held = modifiers[below(6)];
            switch (below(10)) {
            case 0:
                s.use(tools[below(std::size(tools))]);
                break;
            case 1:
                s.use(commands[below(std::size(commands))]);
                break;
            case 2:
                QTest::keyClick(&s.canvas(), keys[below(std::size(keys))], below(4) ? Qt::NoModifier : held);
                break;
            case 3:
            case 4:
                if (down)
                    QTest::mouseRelease(&s.canvas(), Qt::LeftButton, held, s.at(at));
                else
                    QTest::mousePress(&s.canvas(), Qt::LeftButton, held, s.at(at = place()));
                down = !down;
                break;
            default:
                at = below(3) ? at + Point{double(below(61) - 30), double(below(61) - 30)} : place();
                s.advance(interval);
                down ? s.move(at, held) : s.hover(at, held);
            }
            if (i % 50 == 0)
                QCOMPARE(problemOf(s.painting()), QString());
        }
        if (down)
            QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at(at));
        QVERIFY(!s.canvas().tool()->isBusy());
        QCOMPARE(problemOf(s.painting()), QString());
        const auto after = s.editor().document().painting();
        const int done = s.editor().undoStack().index();
        s.editor().undoStack().setIndex(0);
        QVERIFY(s.painting().strokes.empty());
        s.editor().undoStack().setIndex(done);
        QVERIFY(s.painting() == *after);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestShapeTools)
#include "test_shape_tools.moc"
