// Assistants under the hand: strokes that follow them, and the tool that makes and changes them.
#include "app/session/drawing_aids.h"
#include "app/session/painting/assisted_pen.h"
#include "app/tools/assistants/assistant_tool.h"
#include "app/widgets/numbers/number_field.h"
#include "app/window/layout/workspace_view.h"
#include "model/shaping/nodes/reshape.h"
#include "tests/app/session.h"

#include <QComboBox>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

using namespace suffuse;

namespace {

const Assistant vanishingPoint{AssistantKind::VanishingPoint, {{900, 200}}};

void setAssistants(Session &s, std::vector<Assistant> assistants)
{
    s.editor().aids().setAssistants(std::move(assistants));
}

const std::vector<Assistant> &assistantsOf(Session &s)
{
    return s.editor().aids().assistants();
}

AssistantTool &toolOf(Session &s)
{
    s.use(Command::Assistants);
    return *qobject_cast<AssistantTool *>(s.canvas().tool());
}

/// Drags with the mouse through places on the canvas.
void dragThrough(Session &s, const std::vector<Point> &places, Qt::KeyboardModifiers held = {})
{
    QTest::mousePress(&s.canvas(), Qt::LeftButton, held, s.at(places.front()));
    for (std::size_t i = 1; i < places.size(); ++i) {
        s.advance(interval);
        QTest::mouseMove(&s.canvas(), s.at(places[i]));
    }
    QTest::mouseRelease(&s.canvas(), Qt::LeftButton, held, s.at(places.back()));
}

/// A stroke as a hand draws it that wants a straight line, and does not quite get one.
std::vector<Point> shaky(Point from, Point to)
{
    std::vector<Point> places{from};
    const Point way = to - from, across = (1 / length(way)) * Point{-way.y, way.x};
    for (int i = 1; i <= 30; ++i)
        places.push_back(from + (i / 30.0) * way + (8 * std::sin(0.7 * i)) * across);
    return places;
}

std::vector<Point> nodesOf(const Stroke &stroke)
{
    std::vector<Point> nodes;
    for (int k = 0; k < nodeCount(stroke); ++k)
        nodes.push_back(nodePosition(stroke, k));
    return nodes;
}

/// How far the nodes of a stroke are from a line at most.
double offLine(const Stroke &stroke, Point a, Point b)
{
    const Point along = (1 / length(b - a)) * (b - a);
    double most = 0;
    for (const Point &node : nodesOf(stroke))
        most = std::max(most, std::abs(cross(along, node - a)));
    return most;
}

double pixelOf(Session &s)
{
    return s.canvas().devicePixelRatioF() / s.canvas().view().scale;
}

} // namespace

class TestAssistantTool : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void aStrokeGoesToTheVanishingPoint()
    {
        Session s;
        setAssistants(s, {vanishingPoint});
        const Point from = s.canvas().view().toCanvas(s.canvas().view().toPixels({200, 500}));
        dragThrough(s, shaky(from, {600, 330}));
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        const Stroke &led = *s.painting().strokes[0];
        const Point first = nodePosition(led, 0);
        QVERIFY(length(first - from) <= pixelOf(s)); // where the press was
        QVERIFY(offLine(led, first, {900, 200}) < 0.05);
        QVERIFY(length(nodePosition(led, nodeCount(led) - 1) - first) > 350);
        QCOMPARE(s.editor().undoStack().count(), 1);
    }

    /// With the switch off, with assistants that are not seen, and in a direction that none has.
    void aStrokeIsFree()
    {
        Session s;
        setAssistants(s, {vanishingPoint});
        const auto last = [&] { return s.painting().strokes[s.painting().strokes.size() - 1]; };
        for (const Command command : {Command::SnapToAssistants, Command::ShowAssistants}) {
            QVERIFY(s.window.action(command).isChecked());
            s.use(command);
            dragThrough(s, shaky({200, 500}, {600, 330}));
            QVERIFY(offLine(*last(), {200, 500}, {900, 200}) > 4);
            s.use(command);
        }
        dragThrough(s, shaky({200, 200}, {200, 600}));
        QVERIFY(offLine(*last(), {200, 200}, {200, 600}) > 4);
        dragThrough(s, shaky({200, 500}, {600, 330}));
        QVERIFY(offLine(*last(), nodePosition(*last(), 0), {900, 200}) < 0.05);
    }

    void aStrokeGoesRoundAnEllipse()
    {
        Session s;
        const Assistant ring = Assistant::between(AssistantKind::Ellipse, {300, 250}, {700, 550});
        setAssistants(s, {ring});
        std::vector<Point> places;
        for (int i = 0; i <= 240; ++i) {
            const double t = -1.5 + 0.025 * i, r = 1 + 0.03 * std::sin(5 * t);
            places.push_back({500 + 200 * r * std::cos(t), 400 + 150 * r * std::sin(t)});
        }
        dragThrough(s, places);
        const Stroke &led = *s.painting().strokes[0];
        const AssistantTrack track = *ring.ownTrack();
        double most = 0;
        for (const Point &node : nodesOf(led))
            most = std::max(most, length(track.nearest(node) - node));
        QVERIFY2(most < 0.2, qPrintable(QString::number(most)));
        QVERIFY(curveBox(led).width() > 399 && curveBox(led).height() > 299);
    }

    /// Times, pressures and tilts are those of the pen, and what has waited comes all at once.
    void samplesKeepTheirValues()
    {
        AssistedPen pen;
        pen.begin({{AssistantKind::Ruler, {{0, 100}, {500, 100}}}}, 6, 20);
        QVERIFY(pen.take({{10, 90}, 1'000, 0.25F, 0.5F}).empty());
        QVERIFY(pen.take({{14, 91}, 2'000, 0.5F, 0.25F}).empty());
        const std::vector<PenSample> first = pen.take({{20, 92}, 3'000, 0.75F, 0});
        QCOMPARE(first.size(), std::size_t(3));
        const Microseconds times[] = {1'000, 2'000, 3'000};
        const float pressures[] = {0.25F, 0.5F, 0.75F}, tilts[] = {0.5F, 0.25F, 0};
        const double places[] = {10, 14, 20};
        for (std::size_t i = 0; i < 3; ++i) {
            QCOMPARE(first[i].position, (Point{places[i], 100}));
            QCOMPARE(first[i].time, times[i]);
            QCOMPARE(first[i].pressure, pressures[i]);
            QCOMPARE(first[i].tilt, tilts[i]);
        }
        const std::vector<PenSample> next = pen.take({{30, 300}, 4'000}); // it stays what it was at the start
        QCOMPARE(next.size(), std::size_t(1));
        QCOMPARE(next[0].position, (Point{30, 100}));
        QVERIFY(pen.finish().empty());
        pen.begin({}, 6, 20); // without any, nothing waits
        QCOMPARE(pen.take({{10, 90}}).size(), std::size_t(1));
        QVERIFY(!pen.track());
    }

    void aTapStaysADot()
    {
        Session s;
        setAssistants(s, {vanishingPoint});
        s.click({400, 400});
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QVERIFY(length(nodePosition(*s.painting().strokes[0], 0) - Point{400, 400}) <= 2 * pixelOf(s));
    }

    void escLeavesNothingOfAStroke()
    {
        Session s;
        setAssistants(s, {vanishingPoint});
        for (const double way : {1.0, 100.0}) { // before it is decided, and after
            QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({300, 500}));
            s.advance(interval);
            QTest::mouseMove(&s.canvas(), s.at({300 + way, 500}));
            QVERIFY(s.canvas().tool()->isBusy());
            QTest::keyClick(&s.canvas(), Qt::Key_Escape);
            QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({300 + way, 500}));
            QVERIFY(s.painting().strokes.empty() && s.editor().shown()->strokes.empty());
        }
    }

    /// The copies are those of the line that was led.
    void symmetryCopiesWhatWasLed()
    {
        Session s;
        setAssistants(s, {vanishingPoint});
        Symmetry symmetry = s.editor().aids().symmetry();
        symmetry.isOn = true;
        symmetry.centre = {500, 400};
        s.editor().aids().setSymmetry(symmetry);
        dragThrough(s, shaky({100, 500}, {400, 385}));
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));
        const Point first = nodePosition(*s.painting().strokes[0], 0);
        QVERIFY(offLine(*s.painting().strokes[0], first, {900, 200}) < 0.05);
        QVERIFY(offLine(*s.painting().strokes[1], {1000 - first.x, first.y}, {100, 200}) < 0.05);
    }

    void itWorksInATurnedView()
    {
        Session s;
        setAssistants(s, {vanishingPoint});
        s.canvas().rotateBy(40);
        s.canvas().mirror();
        s.canvas().zoomBy(0.7);
        dragThrough(s, shaky({300, 500}, {600, 350}));
        const Stroke &led = *s.painting().strokes[0];
        QVERIFY(offLine(led, nodePosition(led, 0), {900, 200}) < 0.05);
    }

    void aPenIsLed()
    {
        Session s;
        setAssistants(s, {vanishingPoint});
        Pen pen;
        const std::vector<Point> places = shaky({200, 500}, {600, 330});
        pen.send(s.canvas(), QEvent::TabletPress, s.at(places[0]), 0.4);
        for (std::size_t i = 1; i < places.size(); ++i) {
            s.advance(interval);
            pen.send(s.canvas(), QEvent::TabletMove, s.at(places[i]), 0.4 + 0.01 * double(i));
        }
        pen.send(s.canvas(), QEvent::TabletRelease, s.at(places.back()), 0);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        const Stroke &led = *s.painting().strokes[0];
        QVERIFY(offLine(led, nodePosition(led, 0), {900, 200}) < 0.05);
    }

    void aDragMakesOne_data()
    {
        QTest::addColumn<AssistantKind>("kind");
        QTest::addColumn<std::vector<Point>>("points");
        using enum AssistantKind;
        QTest::newRow("ruler") << Ruler << std::vector<Point>{{300, 300}, {600, 500}};
        QTest::newRow("parallel") << Parallel << std::vector<Point>{{300, 300}, {600, 500}};
        QTest::newRow("vanishing point") << VanishingPoint << std::vector<Point>{{600, 500}};
        QTest::newRow("perspective") << Perspective
                                     << std::vector<Point>{{300, 300}, {600, 300}, {600, 500}, {300, 500}};
        QTest::newRow("ellipse") << Ellipse << std::vector<Point>{{450, 400}, {600, 400}, {450, 500}};
        QTest::newRow("concentric") << Concentric << std::vector<Point>{{450, 400}, {600, 400}, {450, 500}};
    }
    void aDragMakesOne()
    {
        QFETCH(AssistantKind, kind);
        QFETCH(std::vector<Point>, points);
        Session s;
        toolOf(s).setKind(kind);
        dragThrough(s, {{300, 300}, {400, 330}, {600, 500}});
        QCOMPARE(assistantsOf(s).size(), std::size_t(1));
        const Assistant &one = assistantsOf(s)[0];
        QCOMPARE(one.kind, kind);
        QCOMPARE(one.points.size(), points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            QVERIFY(length(one.points[i] - points[i]) <= pixelOf(s));
        QVERIFY(toolOf(s).hasChosen());
        QCOMPARE(s.editor().undoStack().count(), 0);
        QVERIFY(s.painting().strokes.empty());
        s.use(Command::Delete);
        QVERIFY(assistantsOf(s).empty());
        QVERIFY(!s.window.action(Command::Delete).isEnabled());
        if (kind != AssistantKind::VanishingPoint) // of a line and a box a click is none
            s.click({300, 300});
        QVERIFY(assistantsOf(s).empty());
    }

    void pointsAndLinesAreDragged()
    {
        Session s;
        toolOf(s);
        setAssistants(s, {{AssistantKind::Ruler, {{300, 300}, {600, 300}}}});
        dragThrough(s, {{600, 300}, {620, 350}, {600, 500}});
        QVERIFY(length(assistantsOf(s)[0].points[1] - Point{600, 500}) <= pixelOf(s));
        QCOMPARE(assistantsOf(s)[0].points[0], (Point{300, 300}));
        dragThrough(s, {{600, 500}, {620, 350}, {600, 310}}, Qt::ShiftModifier); // in steps of 15°
        QVERIFY(std::abs(assistantsOf(s)[0].points[1].y - 300) < 1e-9);
        dragThrough(s, {{450, 300}, {450, 330}, {470, 350}}); // between them
        const Point by = assistantsOf(s)[0].points[0] - Point{300, 300};
        QVERIFY(length(by - Point{20, 50}) <= 2 * pixelOf(s));
        QVERIFY(std::abs(assistantsOf(s)[0].points[1].y - 300 - by.y) < 1e-9);
        // Esc puts back what is dragged.
        const std::vector<Assistant> before = assistantsOf(s);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at(before[0].points[0]));
        QTest::mouseMove(&s.canvas(), s.at({100, 100}));
        QVERIFY(assistantsOf(s) != before);
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({100, 100}));
        QCOMPARE(assistantsOf(s), before);
        QCOMPARE(s.editor().undoStack().count(), 0);
    }

    void pointsSnapToGuides()
    {
        Session s;
        toolOf(s);
        setAssistants(s, {vanishingPoint});
        s.editor().aids().setGuides({{false, 350}});
        dragThrough(s, {{900, 200}, {850, 300}, {800, 350 + 4 * pixelOf(s)}});
        QCOMPARE(assistantsOf(s)[0].points[0].y, 350.0);
    }

    /// Return makes one, Tab goes to its points, arrows move, Delete removes.
    void theKeyboardIsEnough()
    {
        Session s;
        AssistantTool &tool = toolOf(s);
        tool.setKind(AssistantKind::Ruler);
        s.canvas().setFocus();
        QTest::keyClick(&s.canvas(), Qt::Key_Return);
        QCOMPARE(assistantsOf(s).size(), std::size_t(1));
        const Assistant made = assistantsOf(s)[0];
        QTest::keyClick(&s.canvas(), Qt::Key_Down);
        QCOMPARE(assistantsOf(s)[0], made.movedBy({0, 1}));
        QTest::keyClick(&s.canvas(), Qt::Key_Tab);
        QTest::keyClick(&s.canvas(), Qt::Key_Tab);
        QTest::keyClick(&s.canvas(), Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(assistantsOf(s)[0].points[0], made.points[0] + (Point{0, 1}));
        QCOMPARE(assistantsOf(s)[0].points[1], made.points[1] + (Point{10, 1}));
        QTest::keyClick(&s.canvas(), Qt::Key_Tab, Qt::ShiftModifier);
        QTest::keyClick(&s.canvas(), Qt::Key_Left);
        QCOMPARE(assistantsOf(s)[0].points[0], made.points[0] + (Point{-1, 1}));
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QVERIFY(!tool.hasChosen());
        QTest::keyClick(&s.canvas(), Qt::Key_Tab);
        QVERIFY(s.window.action(Command::Delete).isEnabled());
        s.use(Command::Delete);
        QVERIFY(assistantsOf(s).empty());
        QCOMPARE(s.editor().undoStack().count(), 0);
    }

    /// What Delete means is the assistant, while one is chosen, and no stroke.
    void deleteSparesStrokes()
    {
        Session s;
        s.paintLine({200, 600}, {400, 600});
        s.use(Command::SelectAll);
        setAssistants(s, {vanishingPoint});
        toolOf(s);
        s.click({900, 200});
        s.use(Command::Delete);
        QVERIFY(assistantsOf(s).empty());
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
    }

    void numbersAreTyped()
    {
        Session s;
        QWidget &row = *toolOf(s).options();
        toolOf(s).setKind(AssistantKind::Ellipse);
        row.findChild<QToolButton *>("add")->click();
        const QList<NumberField *> fields = row.findChildren<NumberField *>();
        QCOMPARE(fields.size(), 5);
        const double degree = std::numbers::pi / 180, wanted[] = {450, 350, 30 * degree, 120, 40};
        for (int i = 0; i < 5; ++i)
            emit fields[i]->entered(wanted[i]);
        const Assistant &one = assistantsOf(s)[0];
        QVERIFY(length(one.points[0] - Point{450, 350}) < 1e-9);
        QVERIFY(std::abs(one.form().angle - 30 * degree) < 1e-9);
        QVERIFY(std::abs(one.form().first - 120) < 1e-9 && std::abs(one.form().second - 40) < 1e-9);
        for (int i = 0; i < 5; ++i)
            QVERIFY(fields[i]->value() && std::abs(*fields[i]->value() - wanted[i]) < 1e-9);
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QVERIFY(!fields[0]->isEnabled());
        QVERIFY(!fields[3]->isVisible());
    }

    /// The file keeps them; another painting has none, and nothing of a drag comes into it.
    void theyBelongToThePainting()
    {
        Session s;
        QVERIFY(!workspaceOf(s.canvas(), s.editor()));
        setAssistants(s, {vanishingPoint, Assistant::between(AssistantKind::Perspective, {1, 2}, {30, 40})});
        const auto kept = workspaceOf(s.canvas(), s.editor());
        QVERIFY(kept);
        Session other;
        showWorkspace(*kept, other.canvas(), other.editor());
        QCOMPARE(assistantsOf(other), assistantsOf(s));
        QVERIFY(other.window.action(Command::RemoveAssistants).isEnabled());
        toolOf(other);
        QTest::mousePress(&other.canvas(), Qt::LeftButton, {}, other.at({900, 200}));
        QTest::mouseMove(&other.canvas(), other.at({800, 300}));
        other.editor().newPainting(Editor::usualCanvas());
        QTest::mouseMove(&other.canvas(), other.at({700, 300}));
        QTest::mouseRelease(&other.canvas(), Qt::LeftButton, {}, other.at({700, 300}));
        QVERIFY(assistantsOf(other).empty());
        s.use(Command::RemoveAssistants);
        QVERIFY(assistantsOf(s).empty());
    }

    void senselessOnesAreNotTaken()
    {
        DrawingAids aids;
        const double endless = std::numeric_limits<double>::infinity();
        aids.setAssistants(
            {{AssistantKind::Ruler, {{0, 0}}}, vanishingPoint, {AssistantKind::VanishingPoint, {{endless, 0}}}});
        QCOMPARE(aids.assistants(), std::vector<Assistant>{vanishingPoint});
        aids.setAssistants(std::vector<Assistant>(5000, vanishingPoint));
        QVERIFY(aids.assistants().size() <= 100);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestAssistantTool)
#include "test_assistant_tool.moc"
