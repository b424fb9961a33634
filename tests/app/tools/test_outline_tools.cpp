// Outlines that are drawn node by node, and what is drawn around.
#include "app/session/settings/brush_library.h"
#include "app/tools/shapes/lasso_fill_tool.h"
#include "app/tools/shapes/pen_tool.h"
#include "app/widgets/asking/messages.h"
#include "model/area/area_sets.h"
#include "model/area/outline.h"
#include "model/formats/files.h"
#include "model/painting/validate.h"
#include "model/shaping/nodes/reshape.h"
#include "tests/app/session.h"

#include <QComboBox>
#include <QScopeGuard>
#include <QStatusBar>
#include <QTemporaryDir>

using namespace suffuse;

namespace {

constexpr Qt::KeyboardModifiers none = {};

struct Drawing : Session {
    explicit Drawing(Command tool)
    {
        use(Command::Zoom100);
        use(tool);
    }

    void press(Point at_, Qt::KeyboardModifiers modifiers = none)
    {
        QTest::mousePress(&canvas(), Qt::LeftButton, modifiers, at(at_));
    }
    void release(Point at_, Qt::KeyboardModifiers modifiers = none)
    {
        QTest::mouseRelease(&canvas(), Qt::LeftButton, modifiers, at(at_));
    }
    void move(Point to, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers = none)
    {
        const QPoint pixel = at(to);
        QMouseEvent event(QEvent::MouseMove, pixel, canvas().mapToGlobal(pixel), Qt::NoButton, buttons, modifiers);
        QCoreApplication::sendEvent(&canvas(), &event);
    }
    /// Presses that follow each other at once would be double clicks.
    void click(Point where, Qt::KeyboardModifiers modifiers = none)
    {
        QTest::mouseClick(&canvas(), Qt::LeftButton, modifiers, at(where), 1000);
    }
    void drag(const std::vector<Point> &way, Qt::KeyboardModifiers modifiers = none)
    {
        press(way.front(), modifiers);
        for (std::size_t i = 1; i < way.size(); ++i)
            for (int k = 1; k <= 5; ++k) {
                advance(interval);
                move(way[i - 1] + (k / 5.0) * (way[i] - way[i - 1]), Qt::LeftButton, modifiers);
            }
        release(way.back(), modifiers);
    }
    void key(Qt::Key which) { QTest::keyClick(&canvas(), which); }
    const Stroke &last() { return *painting().strokes.back(); }
    int steps() { return editor().undoStack().count(); }
    bool isBusy() { return canvas().tool()->isBusy(); }
};

double extentOf(const Stroke &stroke)
{
    return sizeOf(areaOf(closedOutline(stroke), FillRule::NonZero));
}

bool isClosed(const Stroke &stroke)
{
    return stroke.segments.front().bezier[0] == stroke.segments.back().bezier[3];
}

bool isNear(Point a, Point b, double by = 1.5)
{
    return length(a - b) < by;
}

} // namespace

class TestOutlineTools : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void clicksSetCornersAndTheFirstNodeCloses()
    {
        Drawing s(Command::OutlinePen);
        for (const Point corner : {Point{300, 300}, {500, 300}, {500, 400}, {300, 400}})
            s.click(corner);
        QVERIFY(s.isBusy());
        QCOMPARE(s.steps(), 0);
        QVERIFY(s.editor().document().draft()); // it shows as paint
        s.click({302, 301});
        QVERIFY(!s.isBusy());
        QVERIFY(!s.editor().document().draft());
        QCOMPARE(s.steps(), 1);
        QCOMPARE(s.editor().undoText(), QString("Outline"));
        QCOMPARE(s.last().segments.size(), std::size_t(4));
        QVERIFY(isClosed(s.last()) && isFillAlone(s.last()));
        QVERIFY(std::abs(extentOf(s.last()) - 20'000) < 600);
        for (int node = 1; node < 4; ++node)
            QCOMPARE(nodeKind(s.last(), node), NodeKind::Corner);
        QCOMPARE(s.selection().strokes, std::set<StrokeId>{s.last().id});
        QCOMPARE(s.last().fill->colour, s.editor().brush().colour);
    }

    /// What is in hand is painted with the brush in hand, and the place of its nodes stays.
    void anotherBrushPaintsWhatIsInHand()
    {
        const auto looksLike = [](const Stroke &stroke, const Brush &brush) {
            return stroke.style == brush.style && stroke.fill && stroke.fill->colour == brush.colour;
        };
        for (const Command tool : {Command::OutlinePen, Command::LassoFill, Command::Shapes}) {
            Drawing s(tool);
            s.editor().setBrush(*findBrush("gouache"));
            if (tool == Command::Shapes) {
                s.press({300, 300});
                s.move({500, 400}, Qt::LeftButton);
            } else {
                for (const Point corner : {Point{300, 300}, {500, 300}, {500, 400}})
                    s.click(corner);
            }
            const StrokePtr before = s.editor().document().draft();
            QVERIFY(before && looksLike(*before, *findBrush("gouache")));
            Brush other = *findBrush("watercolour-edge");
            other.colour = {0.25f, 0.5f, 0.75f, 0.5f};
            QVERIFY(!looksLike(*before, other));
            s.editor().setBrush(other);
            const StrokePtr after = s.editor().document().draft();
            QVERIFY(after && looksLike(*after, other));
            QCOMPARE(after->segments.size(), before->segments.size());
            QCOMPARE(after->id, before->id);
            QVERIFY(s.isBusy());
            if (tool == Command::Shapes)
                s.release({500, 400});
            else
                s.key(Qt::Key_Return);
            QVERIFY(looksLike(s.last(), other));
            QCOMPARE(s.steps(), 1);
        }
    }

    /// A key of a brush takes the brush and leaves the outline in hand.
    void keysOfBrushesLeaveTheOutlineInHand()
    {
        Drawing s(Command::OutlinePen);
        s.click({300, 300});
        s.click({500, 300});
        s.click({500, 400});
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        const QStringList names = BrushLibrary::instance().favourites();
        QVERIFY(names.size() >= 3 && s.editor().brush().name != names[2]);
        s.key(Qt::Key_3);
        QCOMPARE(s.editor().brush().name, names[2]);
        QVERIFY(s.isBusy() && s.window.action(Command::OutlinePen).isChecked());
        s.key(Qt::Key_Return);
        QCOMPARE(s.last().style, findBrush(names[2].toUtf8().constData())->style);
        QCOMPARE(s.steps(), 1);
    }

    void dragsSetSmoothNodesAndAltBreaksThem()
    {
        Drawing s(Command::OutlinePen);
        s.click({300, 300});
        s.drag({{400, 400}, {450, 400}});
        s.drag({{500, 300}, {540, 300}}, Qt::AltModifier);
        s.click({600, 400});
        s.key(Qt::Key_Return);
        QCOMPARE(s.steps(), 1);
        const Stroke &stroke = s.last();
        QCOMPARE(stroke.segments.size(), std::size_t(3));
        QVERIFY(!isClosed(stroke));
        QCOMPARE(nodeKind(stroke, 1), NodeKind::Smooth);
        QVERIFY(isNear(*handlePosition(stroke, 1, true), {450, 400}));
        QVERIFY(isNear(*handlePosition(stroke, 1, false), {350, 400}));
        QCOMPARE(nodeKind(stroke, 2), NodeKind::Corner);
        QVERIFY(isNear(*handlePosition(stroke, 2, true), {540, 300}));
        QVERIFY(isNear(*handlePosition(stroke, 2, false), {500, 300}));
    }

    void shiftTurnsBySteps()
    {
        Drawing s(Command::OutlinePen);
        s.click({300, 300});
        s.click({500, 310}, Qt::ShiftModifier);
        s.click({505, 400}, Qt::ShiftModifier);
        s.key(Qt::Key_Return);
        QVERIFY(std::abs(nodePosition(s.last(), 1).y - nodePosition(s.last(), 0).y) < 1e-3);
        QVERIFY(std::abs(nodePosition(s.last(), 2).x - nodePosition(s.last(), 1).x) < 1e-3);
    }

    void backspaceTakesBackAndEscGivesUp()
    {
        Drawing s(Command::OutlinePen);
        s.click({300, 300});
        s.click({500, 300});
        s.click({500, 400});
        s.key(Qt::Key_Backspace);
        s.click({400, 420});
        s.key(Qt::Key_Return);
        QCOMPARE(s.last().segments.size(), std::size_t(2));
        QVERIFY(isNear(nodePosition(s.last(), 2), {400, 420}));
        const PaintingPtr before = s.editor().document().painting();
        s.editor().document().setSelection({});
        s.click({300, 500});
        s.click({500, 500});
        s.key(Qt::Key_Escape);
        QVERIFY(!s.isBusy() && !s.editor().document().draft());
        s.click({300, 500});
        s.key(Qt::Key_Backspace); // the only one
        QVERIFY(!s.isBusy());
        s.click({300, 500});
        s.click({500, 500});
        s.use(Command::Undo); // takes back the last node, and undoes nothing
        QVERIFY(s.isBusy());
        QVERIFY(!s.window.action(Command::Redo).isEnabled()); // another step would come back
        s.use(Command::Undo);
        QVERIFY(!s.isBusy());
        QCOMPARE(s.editor().document().painting(), before);
        QCOMPARE(s.steps(), 1);
    }

    void anotherToolAndADoubleClickEndTheOutline()
    {
        Drawing s(Command::OutlinePen);
        s.click({300, 300});
        s.click({500, 300});
        s.click({500, 400});
        s.use(Command::Select);
        QCOMPARE(s.steps(), 1);
        QCOMPARE(s.last().segments.size(), std::size_t(2));
        s.editor().document().setSelection({});
        s.use(Command::OutlinePen);
        s.click({300, 500});
        s.click({500, 500});
        s.click({500, 600});
        QTest::mouseDClick(&s.canvas(), Qt::LeftButton, none, s.at({500, 600}));
        QCOMPARE(s.steps(), 2);
        QVERIFY(!s.isBusy());
        QCOMPARE(s.last().segments.size(), std::size_t(2));
    }

    /// It would be a stroke that nobody sees.
    void aFillWithoutAnAreaIsNotAdded()
    {
        for (const Command tool : {Command::OutlinePen, Command::LassoFill})
            for (const bool byReturn : {true, false}) {
                Drawing s(tool);
                static_cast<DrawingTool *>(s.canvas().tool())->setPaint(ShapePaint::Fill);
                s.click({200, 200});
                s.click({300, 260});
                if (byReturn)
                    s.key(Qt::Key_Return);
                else
                    s.use(Command::Select);
                QVERIFY(s.painting().strokes.empty());
                QVERIFY(!s.editor().undoStack().canUndo());
                if (byReturn) {
                    QVERIFY2(s.canvas().tool()->hint().contains("no area"), qPrintable(s.canvas().tool()->hint()));
                    s.click({200, 200});
                    QVERIFY(!s.canvas().tool()->hint().contains("no area"));
                    s.click({300, 260});
                    s.click({300, 360});
                    s.key(Qt::Key_Return);
                    QCOMPARE(s.painting().strokes.size(), std::size_t(1));
                }
            }
    }

    /// Its first press closes the outline, and its second one begins no other.
    void aDoubleClickOnTheFirstPointOnlyCloses()
    {
        for (const Command tool : {Command::OutlinePen, Command::LassoFill}) {
            Drawing s(tool);
            for (const Point corner : {Point{300, 300}, {500, 300}, {500, 400}})
                s.click(corner);
            s.click({300, 300});
            QTest::mouseDClick(&s.canvas(), Qt::LeftButton, none, s.at({300, 300}));
            QVERIFY(!s.isBusy());
            QCOMPARE(s.steps(), 1);
            QVERIFY(isFillAlone(s.last()));
        }
    }

    /// With the values that the stroke has at its end, until the other end closes it.
    void itGoesOnFromAnEnd()
    {
        Drawing s(Command::OutlinePen);
        auto *row = s.canvas().tool()->options()->findChild<QComboBox *>("paint");
        row->setCurrentIndex(int(ShapePaint::Outline));
        emit row->activated(int(ShapePaint::Outline));
        s.click({300, 300});
        s.click({500, 300});
        s.key(Qt::Key_Return);
        QVERIFY(!s.last().fill);
        const Segment painted = s.last().segments.front();
        Brush other = s.editor().brush();
        other.colour = {0.1f, 0.2f, 0.3f, 1};
        s.editor().setBrush(other);
        s.click({500, 300}); // the end
        s.click({500, 400});
        s.key(Qt::Key_Return);
        QCOMPARE(s.steps(), 2);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(s.last().segments.size(), std::size_t(2));
        QCOMPARE(s.last().segments.back().colour, painted.colour);
        QCOMPARE(s.last().segments.back().density, painted.density);
        s.click({300, 300}); // the start
        s.click({300, 400});
        s.click({500, 400}); // the other end
        QVERIFY(!s.isBusy());
        QCOMPARE(s.last().segments.size(), std::size_t(4));
        QVERIFY(isClosed(s.last()));
        QCOMPARE(chainsOf(s.last()).size(), std::size_t(1));
        QCOMPARE(problemOf(s.last()), QString());
        s.use(Command::Undo);
        s.use(Command::Undo);
        QCOMPARE(s.last().segments.size(), std::size_t(1));
        row->setCurrentIndex(int(ShapePaint::Fill));
        emit row->activated(int(ShapePaint::Fill));
    }

    void undoTakesBackTheLastCornerOfALasso()
    {
        Drawing s(Command::LassoFill);
        for (const Point corner : {Point{300, 300}, {500, 300}, {500, 400}, {900, 900}})
            s.click(corner);
        s.use(Command::Undo);
        QVERIFY(s.isBusy());
        s.key(Qt::Key_Return);
        QCOMPARE(s.steps(), 1);
        QVERIFY(std::abs(extentOf(s.last()) - 10'000) < 600); // a triangle
        s.click({300, 300});
        s.use(Command::Undo);
        QVERIFY(!s.isBusy());
        QCOMPARE(s.steps(), 1);
        QVERIFY(isFillAlone(s.last()));
    }

    void aLassoFillsWhatIsDrawnAround()
    {
        Drawing s(Command::LassoFill);
        std::vector<Point> around;
        for (int i = 0; i <= 40; ++i)
            around.push_back(Point{450, 350} + 100 * Point{std::cos(0.15 * i), std::sin(0.15 * i)});
        s.drag(around);
        QCOMPARE(s.steps(), 1);
        QCOMPARE(s.editor().undoText(), QString("Lasso fill"));
        QVERIFY(isFillAlone(s.last()) && isClosed(s.last()));
        QVERIFY2(std::abs(extentOf(s.last()) - 31'400) < 600, qPrintable(QString::number(extentOf(s.last()))));
        QVERIFY2(s.last().segments.size() < 30, qPrintable(QString::number(s.last().segments.size())));
        QCOMPARE(problemOf(s.last()), QString());
    }

    void clicksOfTheLassoAreCorners()
    {
        Drawing s(Command::LassoFill);
        s.click({300, 300});
        s.click({500, 300});
        s.drag({{500, 400}, {400, 450}, {300, 400}}, Qt::AltModifier);
        QVERIFY(s.isBusy());
        s.click({301, 302});
        QVERIFY(!s.isBusy());
        QCOMPARE(s.steps(), 1);
        QVERIFY2(std::abs(extentOf(s.last()) - 25'000) < 800, qPrintable(QString::number(extentOf(s.last()))));
        s.click({300, 300});
        s.click({500, 300});
        s.key(Qt::Key_Return); // Two points enclose nothing.
        QCOMPARE(s.steps(), 1);
        s.press({300, 300});
        s.move({400, 400}, Qt::LeftButton);
        s.move({300, 400}, Qt::LeftButton);
        QVERIFY(s.editor().document().draft());
        s.key(Qt::Key_Escape);
        s.release({400, 400});
        QVERIFY(!s.editor().document().draft());
        QCOMPARE(s.steps(), 1);
    }

    void whatWasTakenBackComesBackUntilSomethingElseIsSet()
    {
        for (const Command tool : {Command::OutlinePen, Command::LassoFill}) {
            Drawing s(tool);
            const auto drawn = [&s] { return s.editor().document().draft(); };
            for (const Point at : {Point{200, 200}, Point{300, 220}, Point{320, 280}, Point{260, 320}, Point{220, 300}})
                s.click(at);
            const Stroke whole = *drawn();
            s.use(Command::Undo);
            s.use(Command::Undo);
            QVERIFY(drawn()->segments.size() < whole.segments.size());
            QTest::keyClick(&s.canvas(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
            QTest::keyClick(&s.canvas(), Qt::Key_Y, Qt::ControlModifier);
            QVERIFY(*drawn() == whole);
            QTest::keyClick(&s.canvas(), Qt::Key_Y, Qt::ControlModifier); // there is nothing more
            QVERIFY(*drawn() == whole);
            s.use(Command::Undo);
            s.click({180, 280});
            const Stroke other = *drawn();
            QTest::keyClick(&s.canvas(), Qt::Key_Y, Qt::ControlModifier);
            QVERIFY(*drawn() == other);
            QCOMPARE(s.steps(), 0);
        }
    }

    /// The first point comes back, too, unless something else has happened.
    void allThatWasTakenBackComesBack()
    {
        for (const Command tool : {Command::OutlinePen, Command::LassoFill}) {
            Drawing s(tool);
            const auto redo = [&s] { QTest::keyClick(&s.canvas(), Qt::Key_Y, Qt::ControlModifier); };
            const auto begin = [&s] {
                for (const Point at : {Point{200, 200}, Point{300, 220}, Point{260, 320}})
                    s.click(at);
            };
            begin();
            Stroke whole = *s.editor().document().draft();
            for (int i = 0; i < 3; ++i)
                s.use(Command::Undo);
            QVERIFY(!s.isBusy() && !s.editor().document().draft());
            for (int i = 0; i < 3; ++i)
                redo();
            QVERIFY(s.isBusy());
            whole.id = s.editor().document().draft()->id;
            QVERIFY(*s.editor().document().draft() == whole);
            s.key(Qt::Key_Return);
            QCOMPARE(s.steps(), 1);
            begin();
            for (int i = 0; i < 4; ++i)
                s.use(Command::Undo); // at last the outline before it
            QVERIFY(s.painting().strokes.empty());
            redo();
            QVERIFY(!s.isBusy());
            begin();
            for (int i = 0; i < 3; ++i)
                s.use(Command::Undo);
            s.use(Command::Brush);
            s.use(tool);
            redo();
            QVERIFY(!s.isBusy());
        }
    }

    /// Saving ends nothing: the file has the painting, and what is drawn goes on.
    void whatIsInHandStaysThereWhenThePaintingIsSaved()
    {
        const QString file = m_folder.filePath("inHand.suffuse");
        for (const Command tool : {Command::OutlinePen, Command::LassoFill}) {
            Drawing s(tool);
            const QByteArray before = hashOf(s.painting());
            for (const Point at : {Point{200, 200}, Point{300, 220}, Point{260, 320}, Point{220, 300}})
                s.click(at);
            QVERIFY(s.window.saveTo(file));
            s.use(Command::Save); // once more, though it is saved already
            QTRY_VERIFY_WITH_TIMEOUT(!s.editor().isSaving(), waitMs);
            QVERIFY2(s.window.statusBar()->currentMessage().contains("still being drawn"),
                     qPrintable(s.window.statusBar()->currentMessage()));
            QCOMPARE(hashOf(*loadPainting(file)), before);
            QVERIFY(!s.editor().isModified());
            QVERIFY(s.isBusy());
            QCOMPARE(s.steps(), 0);
            const std::size_t drawn = s.editor().document().draft()->segments.size();
            s.use(Command::Undo); // the last node, as if nothing had been saved
            QVERIFY(s.isBusy());
            QCOMPARE(s.editor().document().draft()->segments.size(), drawn - 1);
            s.key(Qt::Key_Return);
            QCOMPARE(s.steps(), 1);
            QVERIFY(s.window.saveTo(file));
            QVERIFY(!s.window.statusBar()->currentMessage().contains("still being drawn"));
            QCOMPARE(hashOf(*loadPainting(file)), hashOf(s.painting()));
        }
    }

    /// It is seen, so it is asked about like all else before the window closes.
    void whatIsInHandIsAskedAbout()
    {
        for (const Command tool : {Command::OutlinePen, Command::LassoFill}) {
            Drawing s(tool);
            const std::size_t before = s.painting().strokes.size();
            for (const Point at : {Point{400, 200}, Point{500, 220}, Point{460, 320}})
                s.click(at);
            int asked = 0;
            MessageHooks hooks;
            hooks.unsaved = [&](const QString &) {
                ++asked;
                return SaveAnswer::Cancel;
            };
            setMessageHooks(hooks);
            const auto back = qScopeGuard([] { setMessageHooks({}); });
            QVERIFY(!s.window.close());
            QCOMPARE(asked, 1);
            QCOMPARE(s.painting().strokes.size(), before + 1);
        }
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestOutlineTools)
#include "test_outline_tools.moc"
