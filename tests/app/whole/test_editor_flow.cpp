// A session as a painter has it: paint, select, change, undo.
#include "app/session/commands/commands.h"
#include "app/session/commands/keys.h"
#include "app/tools/brush/brush_tool.h"
#include "model/brush/brush_width.h"
#include "tests/app/session.h"
#include "undo/edits.h"

#include <QDockWidget>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <map>
#include <numbers>
#include <set>

using namespace suffuse;

class TestEditorFlow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void mousePaintsAStroke()
    {
        Session s;
        QVERIFY(!s.window.isWindowModified());
        s.paintLine({200, 300}, {700, 300});
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QVERIFY(!s.editor().document().draft());
        QCOMPARE(s.editor().undoStack().count(), 1);
        QVERIFY(s.window.isWindowModified());
        const Stroke &stroke = *s.painting().strokes.front();
        QVERIFY(stroke.segments.size() >= 3);
        const Point first = stroke.cubicOf(stroke.segments.front()).p[0];
        const Point last = stroke.cubicOf(stroke.segments.back()).p[3];
        QVERIFY(length(first - Point{200, 300}) < 4);
        QVERIFY(length(last - Point{700, 300}) < 4);

        s.dry();
        const QImage picture = s.canvas().picture();
        const Point middle = s.canvas().view().toPixels({450, 300});
        QVERIFY(picture.pixel(int(middle.x), int(middle.y)) != qRgb(255, 255, 255));
    }

    void strokeSpreadsAfterThePenLifts()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        const auto painted = [&] {
            const QImage picture = s.canvas().picture();
            int count = 0;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x)
                    count += picture.pixel(x, y) != qRgb(255, 255, 255);
            return count;
        };
        QTRY_VERIFY_WITH_TIMEOUT(s.canvas().isUpToDate(), waitMs);
        QVERIFY(s.editor().clock().isRunning());
        const int early = painted();
        s.dry();
        QVERIFY(painted() > early);
        QVERIFY(!s.editor().clock().isRunning());
        QCOMPARE(s.editor().clock().time(), s.painting().end());
    }

    void draftIsTheStrokeThatStays()
    {
        Session s;
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({100, 100}));
        for (int i = 1; i <= 10; ++i) {
            s.advance(interval);
            QTest::mouseMove(&s.canvas(), s.at({100.0 + 30 * i, 100}));
        }
        QVERIFY(s.editor().document().draft());
        const StrokeId id = s.editor().document().draft()->id;
        QVERIFY(s.painting().strokes.empty());
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({400, 100}));
        QCOMPARE(s.painting().strokes.at(0)->id, id);
    }

    void escapeGivesTheStrokeUp()
    {
        Session s;
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({100, 100}));
        s.advance(interval);
        QTest::mouseMove(&s.canvas(), s.at({200, 100}));
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QVERIFY(!s.editor().document().draft());
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({200, 100}));
        QVERIFY(s.painting().strokes.empty());
        QCOMPARE(s.editor().undoStack().count(), 0);
    }

    void penPressureBecomesDensity()
    {
        Session s;
        Pen pen;
        const auto stroke = [&](double y, double pressure) {
            pen.send(s.canvas(), QEvent::TabletPress, s.at({200, y}), pressure);
            pen.send(s.canvas(), QEvent::TabletPress, s.at({200, y}), pressure); // drivers repeat it
            for (int i = 1; i <= 20; ++i) {
                s.advance(interval);
                pen.send(s.canvas(), QEvent::TabletMove, s.at({200 + 20.0 * i, y}), pressure);
            }
            pen.send(s.canvas(), QEvent::TabletRelease, s.at({600, y}), 0);
        };
        stroke(200, 1.0);
        stroke(400, 0.2);
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));
        const auto middle = [&](int k) {
            const auto &segments = s.painting().strokes.at(k)->segments;
            return segments.at(segments.size() / 2).density;
        };
        QVERIFY(middle(1) < 0.9f * middle(0));
        QVERIFY(middle(1) > 0);
    }

    void tapLeavesADot()
    {
        Session s;
        s.click({300, 300});
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        s.dry();
        const Point p = s.canvas().view().toPixels({300, 300});
        QVERIFY(s.canvas().picture().pixel(int(p.x), int(p.y)) != qRgb(255, 255, 255));
    }

    void clickSelectsVisiblePaintThenASegment()
    {
        Session s;
        s.paintLine({200, 250}, {700, 250});
        s.advance(interval);
        s.paintLine({200, 450}, {700, 450});
        s.dry();
        const StrokeId upper = s.painting().strokes[0]->id, lower = s.painting().strokes[1]->id;
        s.use(Command::Select);

        const double side = 0.5 * halfWidthOf(s.editor().brush()); // beside the curve, but on the paint
        s.click({450, 250 + side});
        QCOMPARE(s.selection().strokes, std::set<StrokeId>{upper});
        QVERIFY(s.selection().segments.empty());
        s.click({450, 450}, Qt::ShiftModifier);
        QCOMPARE(s.selection().strokes, (std::set<StrokeId>{upper, lower}));
        s.click({450, 450}, Qt::ShiftModifier);
        QCOMPARE(s.selection().strokes, std::set<StrokeId>{upper});
        s.click({450, 350}); // far from paint
        QVERIFY(s.selection().isEmpty());

        s.use(Command::Segments);
        s.click({300, 250});
        QCOMPARE(s.selection().segments.size(), std::size_t(1));
        const int from = s.selection().segments.begin()->segment;
        s.click({600, 250}, Qt::ShiftModifier);
        QVERIFY(s.selection().segments.size() > 3);
        QCOMPARE(s.selection().segments.begin()->segment, from);
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QVERIFY(s.selection().segments.empty());
        QCOMPARE(s.selection().strokes.size(), std::size_t(1));
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QVERIFY(s.selection().isEmpty());
    }

    void runGoesOnUnderAnotherStroke()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        s.advance(interval);
        s.paintLine({450, 100}, {450, 500});
        s.dry();
        const StrokeId covered = s.painting().strokes[0]->id, above = s.painting().strokes[1]->id;
        s.use(Command::Segments);
        s.click({450, 300});
        QCOMPARE(s.selection().strokes, std::set<StrokeId>{above});
        s.click({300, 300});
        s.click({450, 300}, Qt::ShiftModifier);
        QCOMPARE(s.selection().strokes, std::set<StrokeId>{covered});
        QVERIFY(s.selection().segments.size() > 2);
    }

    void undoGivesUpTheStrokeInHand()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(!s.window.action(Command::Redo).isEnabled());
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({100, 100}));
        s.advance(interval);
        QTest::mouseMove(&s.canvas(), s.at({200, 100}));
        s.use(Command::Undo);
        QVERIFY(!s.editor().document().draft());
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({200, 100}));
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        s.use(Command::Undo);
        QVERIFY(s.painting().strokes.empty());
        QVERIFY(s.window.action(Command::Redo).isEnabled());
    }

    void aToolChosenDuringAStrokeComesAfterIt()
    {
        Session s;
        const Tool *brush = s.canvas().tool();
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({100, 100}));
        s.advance(interval);
        QTest::mouseMove(&s.canvas(), s.at({200, 100}));
        s.use(Command::Select);
        QCOMPARE(s.canvas().tool(), brush);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({300, 100}));
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QVERIFY(s.canvas().tool() != brush);
        QVERIFY(s.window.action(Command::Select).isChecked());
    }

    void whoSeesAllGoesOnSeeingAll()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        s.dry();
        Stroke later = *s.painting().strokes[0];
        for (Segment &segment : later.segments)
            segment.born += 60'000'000;
        const Microseconds born = later.segments.back().born;
        Edit edit;
        edit.strokes.emplace(later.id, std::make_shared<const Stroke>(later));
        s.editor().push(std::move(edit), "Later");
        QCOMPARE(s.editor().clock().time(), born);
        QVERIFY(!s.editor().clock().isInPast());
    }

    /// The next stroke begins where the painting ends as it is now; a redo brings strokes back as dry as they were.
    void whatIsUndoneTakesNoTime()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        s.dry();
        PaintingClock &clock = s.editor().clock();
        clock.setManual(false);
        const Microseconds end = clock.time();
        QVERIFY(end > 0);
        s.use(Command::Undo);
        QCOMPARE(clock.time(), 0);
        QTest::qWait(50);
        QCOMPARE(clock.time(), 0);
        s.use(Command::Redo);
        QCOMPARE(clock.time(), end);
        s.use(Command::Undo);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({100, 100}));
        QTest::qWait(5);
        QTest::mouseMove(&s.canvas(), s.at({300, 200}));
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({300, 200}));
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(s.painting().strokes[0]->born(), 0);
        QVERIFY(!clock.isInPast());
    }

    /// Paint that comes after something was undone takes the time that the hand takes, whoever lays it.
    void whatFollowsAnUndoIsAsFarApartAsItWasDone()
    {
        Session s;
        Brush slow = s.editor().brush();
        slow.maxAge = 30;
        s.editor().setBrush(slow);
        PaintingClock &clock = s.editor().clock();
        for (const Command tool : {Command::Brush, Command::Shapes, Command::Bucket}) {
            s.use(Command::Brush);
            clock.setManual(true);
            s.paintLine({200, 300}, {700, 300});
            s.advance(60'000'000);
            clock.setManual(false);
            s.use(Command::Undo);
            s.use(tool);
            const std::size_t before = s.painting().strokes.size();
            QElapsedTimer painting;
            painting.start();
            for (int k = 0; k < 3; ++k) {
                const Point at{100.0 + 200 * k, 100};
                if (tool == Command::Bucket) {
                    s.editor().setColour({k == 1 ? 1.0f : 0.0f, 0, k == 1 ? 0.0f : 1.0f, 1}); // each fills anew
                    s.click(at);
                } else {
                    QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at(at));
                    QTest::mouseMove(&s.canvas(), s.at(at + Point{50, 20}));
                    QTest::mouseMove(&s.canvas(), s.at(at + Point{100, 60}));
                    QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at(at + Point{100, 60}));
                }
                QTRY_COMPARE(s.painting().strokes.size(), before + std::size_t(k) + 1);
                QTest::qWait(30);
            }
            const Microseconds took = painting.nsecsElapsed() / 1000;
            Microseconds first = std::numeric_limits<Microseconds>::max(), last = 0;
            for (const StrokePtr &stroke : s.painting().strokes)
                if (stroke->id > s.painting().strokes.back()->id - 3) {
                    first = std::min(first, stroke->born());
                    last = std::max(last, stroke->born());
                }
            QVERIFY2(last - first <= took, qPrintable(QString::number((last - first) / 1e6)));
        }
    }

    void undoGivesUpEvenTheFirstStroke()
    {
        Session s;
        QVERIFY(!s.window.action(Command::Undo).isEnabled());
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({100, 100}));
        s.advance(interval);
        QTest::mouseMove(&s.canvas(), s.at({200, 100}));
        QVERIFY(s.window.action(Command::Undo).isEnabled());
        s.use(Command::Undo);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({200, 100}));
        QVERIFY(s.painting().strokes.empty());
        QVERIFY(!s.window.action(Command::Undo).isEnabled());
    }

    void rubberBandSelectsWhatItEncloses()
    {
        Session s;
        s.paintLine({200, 250}, {400, 250});
        s.advance(interval);
        s.paintLine({500, 450}, {800, 450});
        s.dry();
        s.use(Command::Select);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({150, 150}));
        QTest::mouseMove(&s.canvas(), s.at({300, 300}));
        QTest::mouseMove(&s.canvas(), s.at({450, 350}));
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({450, 350}));
        QCOMPARE(s.selection().strokes, std::set<StrokeId>{s.painting().strokes[0]->id});
        s.use(Command::SelectAll);
        QCOMPARE(s.selection().strokes.size(), std::size_t(2));
    }

    void dragMovesInOneStep()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        s.dry();
        s.use(Command::Select);
        const Point origin = s.painting().strokes[0]->origin;
        const auto drag = [&](bool escape) {
            QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({450, 300}));
            for (int i = 1; i <= 5; ++i)
                QTest::mouseMove(&s.canvas(), s.at({450, 300.0 + 20 * i}));
            if (escape)
                QTest::keyClick(&s.canvas(), Qt::Key_Escape);
            QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({450, 400}));
        };
        drag(true);
        QCOMPARE(s.painting().strokes[0]->origin, origin);
        QCOMPARE(s.editor().undoStack().count(), 1);
        drag(false);
        QVERIFY(std::abs(s.painting().strokes[0]->origin.y - origin.y - 100) < 3);
        QCOMPARE(s.editor().undoStack().count(), 2);
        s.use(Command::Undo);
        QCOMPARE(s.painting().strokes[0]->origin, origin);

        s.editor().document().setSelection({{s.painting().strokes[0]->id}, {}});
        QTest::keyClick(&s.canvas(), Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(std::abs(s.painting().strokes[0]->origin.x - origin.x - 10) < 1e-6);
    }

    void arrowsMoveByExactDecimals()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        s.dry();
        const StrokeId id = s.painting().strokes[0]->id;
        s.editor().push(changeStrokes(s.editor().document(), {id},
                                      [](Stroke &stroke) {
                                          stroke.origin = {0.1, 0};
                                      }),
                        "origin");
        s.editor().document().setSelection({{id}, {}});
        s.use(Command::Select);
        const auto origin = [&] { return s.painting().strokes[0]->origin; };
        View view = s.canvas().view();
        view.centre = {387.123456789, -1234.56789}; // as it is after some zooming and panning
        view.scale = 1.2345678901;
        for (const auto &[turn, way] : {std::pair(0.0, Point{1, 0}), std::pair(std::numbers::pi / 2, Point{0, -1})}) {
            view.rotation = turn;
            s.canvas().lookThrough(view);
            const Point from = origin();
            QSignalSpy said(s.window.findChild<Commands *>(), &Commands::said);
            QTest::keyClick(&s.canvas(), Qt::Key_Right);
            const QString moved = said.isEmpty() ? QString() : said.last()[0].toString();
            QVERIFY2(moved.contains(QString("moved by %1, %2 u").arg(way.x).arg(way.y)), qPrintable(moved));
            QCOMPARE(origin(), (Point{way.x != 0 ? 1.1 : from.x, way.y != 0 ? -1.0 : 0.0}));
            for (int i = 0; i < 30; ++i)
                QTest::keyClick(&s.canvas(), Qt::Key_Right);
            for (int i = 0; i < 31; ++i)
                QTest::keyClick(&s.canvas(), Qt::Key_Left);
            QCOMPARE(origin(), from);
        }
    }

    void commandsOnTheSelection()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        s.advance(interval);
        s.paintLine({450, 100}, {450, 500});
        s.dry();
        QVERIFY(!s.window.action(Command::Delete).isEnabled());
        const StrokeId first = s.painting().strokes[0]->id;
        s.editor().document().setSelection({{first}, {}});
        QVERIFY(s.window.action(Command::Delete).isEnabled());
        s.use(Command::Raise);
        QCOMPARE(s.painting().strokes[1]->id, first);
        s.use(Command::Bottom);
        QCOMPARE(s.painting().strokes[0]->id, first);
        s.use(Command::Duplicate);
        QCOMPARE(s.painting().strokes.size(), std::size_t(3));
        QVERIFY(!s.selection().strokes.contains(first));
        s.use(Command::Delete);
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));
        const QByteArray before = hashOf(s.painting());
        while (s.editor().undoStack().canUndo())
            s.use(Command::Undo);
        QVERIFY(s.painting().strokes.empty());
        while (s.editor().undoStack().canRedo())
            s.use(Command::Redo);
        QCOMPARE(hashOf(s.painting()), before);
    }

    void actionsKeepTheirNames()
    {
        Session s;
        std::set<QString> names;
        for (int command = 0; command <= int(Command::About); ++command)
            names.insert(s.window.action(Command(command)).objectName());
        QCOMPARE(names.size(), std::size_t(Command::About) + 1); // shortcuts are stored under them
        QVERIFY(!names.contains(QString()));
        s.paintLine({200, 300}, {700, 300});
        const QAction &undo = s.window.action(Command::Undo);
        QCOMPARE(undo.text(), QString("&Undo: Brush stroke"));
        QCOMPARE(undo.iconText(), QString("Undo"));
        QCOMPARE(undo.toolTip(), QString("Undo: Brush stroke (Ctrl+Z)"));
        QCOMPARE(plainTitle(QStringLiteral("打开(&O)…")), QStringLiteral("打开"));
        QCOMPARE(plainTitle("Save &As…"), QString("Save As"));
    }

    /// Keys that once were the tools' own are commands' shortcuts: no two have the same, and others can be given.
    void toolKeysCanBeChanged()
    {
        Session s;
        s.window.activateWindow(); // shortcuts are its
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        std::map<QString, QString> users;
        for (int command = 0; command <= int(Command::About); ++command)
            for (const QKeySequence &key : s.window.action(Command(command)).shortcuts()) {
                const QString name = s.window.action(Command(command)).objectName();
                QVERIFY2(users.emplace(key.toString(), name).second, qPrintable(key.toString()));
            }
        for (const FixedKeys &fixed : fixedKeys())
            for (const QKeySequence &key : fixed.keys)
                QVERIFY2(!users.contains(key.toString()), qPrintable(key.toString()));
        for (const char *key : {"[", "]", "{", "}", "R", "Space"})
            QVERIFY2(users.contains(key), key);

        const auto spread = [&] { return s.editor().brush().spread(); };
        const double before = spread();
        s.window.action(Command::LargerSize).setShortcut(QKeySequence("J"));
        QTest::keyClick(&s.canvas(), Qt::Key_BracketRight);
        QCOMPARE(spread(), before);
        QTest::keyClick(&s.canvas(), Qt::Key_J);
        QVERIFY(spread() > 1.1 * before);

        // Held keys: the new one turns, even where a command has the old one.
        s.window.action(Command::HoldToTurn).setShortcut(QKeySequence("T"));
        const auto dragHolding = [&](Qt::Key key) {
            QTest::keyPress(&s.canvas(), key);
            QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, {350, 200});
            QTest::mouseMove(&s.canvas(), {250, 300});
            QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, {250, 300});
            QTest::keyRelease(&s.canvas(), key);
        };
        dragHolding(Qt::Key_T);
        QVERIFY(s.canvas().view().rotation != 0);
        QVERIFY(s.painting().strokes.empty());
        s.canvas().resetRotation();
        s.window.action(Command::Mirror).setShortcut(QKeySequence("R"));
        QTest::keyClick(&s.canvas(), Qt::Key_R);
        QVERIFY(s.canvas().view().mirrored);
        dragHolding(Qt::Key_X); // of no meaning: paints
        QCOMPARE(s.canvas().view().rotation, 0.0);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
    }

    void newPaintingsLieOnPaper()
    {
        Session s;
        QCOMPARE(s.painting().canvas.paper.kind, PaperKind::Procedural);
        QVERIFY(!s.window.isWindowModified());
        QCOMPARE(s.editor().undoStack().count(), 0);
    }

    void docksHideAndComeBack()
    {
        Session s;
        const QList<QDockWidget *> docks = s.window.findChildren<QDockWidget *>();
        QCOMPARE(docks.size(), 8);
        std::set<QDockWidget *> shown;
        for (QDockWidget *dock : docks)
            if (dock->toggleViewAction()->isChecked())
                shown.insert(dock);
        QCOMPARE(shown.size(), std::size_t(6)); // the probe is not in the way until it is asked for
        s.use(Command::HideDocks);
        for (QDockWidget *dock : docks)
            QVERIFY(dock->isHidden());
        s.use(Command::HideDocks);
        for (QDockWidget *dock : docks)
            QCOMPARE(dock->toggleViewAction()->isChecked(), shown.contains(dock));
    }

    void tabBringsTheDocksBackInEveryTool()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        for (const Command tool : {Command::Select, Command::Segments}) {
            s.use(Command::Brush);
            s.canvas().setFocus();
            QTest::keyClick(&s.canvas(), Qt::Key_Tab);
            QVERIFY(s.window.action(Command::HideDocks).isChecked());
            s.use(tool);
            s.editor().document().setSelection({{s.painting().strokes[0]->id}, {}});
            const Selection before = s.selection();
            QTest::keyClick(&s.canvas(), Qt::Key_Tab);
            QVERIFY(!s.window.action(Command::HideDocks).isChecked());
            QCOMPARE(s.selection(), before);
            QTest::keyClick(&s.canvas(), Qt::Key_Tab); // and is the tool's again
            QVERIFY(!s.window.action(Command::HideDocks).isChecked());
        }
    }

    /// It never takes effect late: with a button down it does nothing, and between the clicks of an outline all.
    void tabWhileSomethingIsDrawn()
    {
        Session s;
        const QAction &hides = s.window.action(Command::HideDocks);
        const QDockWidget &dock = *s.window.findChild<QDockWidget *>("colourDock");
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.use(Command::Brush);
        s.canvas().setFocus();
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({200, 300}));
        QTest::mouseMove(&s.canvas(), s.at({300, 300}));
        QTest::keyClick(&s.canvas(), Qt::Key_Tab);
        QVERIFY(!hides.isChecked() && !dock.isHidden());
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({400, 300}));
        QTest::qWait(50);
        QVERIFY(!hides.isChecked() && !dock.isHidden());
        s.use(Command::HideDocks);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({200, 400}));
        QTest::mouseMove(&s.canvas(), s.at({300, 400}));
        s.use(Command::HideDocks);
        QVERIFY(hides.isChecked() && dock.isHidden());
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({300, 400}));
        QTest::qWait(50);
        QVERIFY(hides.isChecked() && dock.isHidden());
        s.use(Command::HideDocks);
        QVERIFY(!dock.isHidden());
        s.use(Command::OutlinePen);
        s.click({200, 500});
        s.click({300, 500});
        QVERIFY(s.canvas().tool()->isBusy());
        QTest::keyClick(&s.canvas(), Qt::Key_Tab);
        QVERIFY(hides.isChecked() && dock.isHidden() && s.canvas().tool()->isBusy());
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestEditorFlow)
#include "test_editor_flow.moc"
