// The pen and fingers on the canvas, by synthetic devices.
#include "app/dialogs/pen_page.h"
#include "app/dialogs/settings_dialog.h"
#include "app/panels/pen_pad.h"
#include "app/panels/response_editor.h"
#include "app/settings.h"
#include "pen_hand.h"
#include "session.h"

#include <QCheckBox>
#include <QComboBox>
#include <QTemporaryDir>
#include <QtTest>

using namespace suffuse;

namespace {

/// A pen that says what a test wants it to.
class Hand {
public:
    explicit Hand(QPointingDevice::PointerType end = QPointingDevice::PointerType::Pen, bool sensitive = true)
        : m_device("pen", 70 + int(end), QInputDevice::DeviceType::Stylus, end,
                   sensitive ? QInputDevice::Capability::Position | QInputDevice::Capability::Pressure
                             : QInputDevice::Capabilities(QInputDevice::Capability::Position),
                   1, 3)
    {}
    void press(QWidget &widget, QPointF at, double pressure)
    {
        send(widget, QEvent::TabletPress, at, pressure, Qt::LeftButton, Qt::LeftButton);
    }
    void move(QWidget &widget, QPointF at, double pressure)
    {
        send(widget, QEvent::TabletMove, at, pressure, Qt::NoButton, Qt::LeftButton);
    }
    void hover(QWidget &widget, QPointF at) { send(widget, QEvent::TabletMove, at, 0, Qt::NoButton, Qt::NoButton); }
    void release(QWidget &widget, QPointF at)
    {
        send(widget, QEvent::TabletRelease, at, 0, Qt::LeftButton, Qt::NoButton);
    }
    void proximity(bool near)
    {
        QTabletEvent event(near ? QEvent::TabletEnterProximity : QEvent::TabletLeaveProximity, &m_device, {}, {}, 0, 0,
                           0, 0, 0, 0, {}, Qt::NoButton, Qt::NoButton);
        QCoreApplication::sendEvent(qApp, &event);
    }
    /// A straight line at these pressures, a report an interval.
    void line(Session &s, double y, const std::vector<double> &pressures, bool lift = true)
    {
        for (std::size_t i = 0; i < pressures.size(); ++i) {
            const QPointF at = s.at({200 + 20.0 * double(i), y});
            if (i == 0)
                press(s.canvas(), at, pressures[i]);
            else
                move(s.canvas(), at, pressures[i]);
            s.advance(interval);
        }
        if (lift)
            release(s.canvas(), s.at({200 + 20.0 * double(pressures.size() - 1), y}));
    }

private:
    void send(QWidget &widget, QEvent::Type type, QPointF at, double pressure, Qt::MouseButton button,
              Qt::MouseButtons buttons)
    {
        QTabletEvent event(type, &m_device, at, widget.mapToGlobal(at), pressure, 0, 0, 0, 0, 0, {}, button, buttons);
        QCoreApplication::sendEvent(&widget, &event);
    }

    QPointingDevice m_device;
};

float strongest(const Stroke &stroke)
{
    float most = 0;
    for (const Segment &s : stroke.segments)
        most = std::max(most, s.density);
    return most;
}

ResponseCurve half()
{
    return {{{0, 0}, {1, 0.5f}}};
}

bool near(Point a, Point b, double by)
{
    return length(a - b) < by;
}

} // namespace

class TestPen : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toUtf8());
        m_screen = QTest::createTouchDevice();
    }
    void init() { settings::store().clear(); }

    void pressuresAreMadeFit()
    {
        PenPressure pen;
        QCOMPARE(pen.take(0.2, true, true), 0.2);
        QCOMPARE(pen.take(0, false, true), 0.0);
        QCOMPARE(pen.take(1, false, true), 0.2); // one report of full pressure out of nothing
        QCOMPARE(pen.take(0.25, false, true), 0.25);
        QCOMPARE(pen.take(1, false, true), 0.25);
        QCOMPARE(pen.take(1, false, true), 1.0); // no blip: it stays
        QCOMPARE(pen.take(0.7, false, true), 0.7);
        QCOMPARE(pen.take(1, false, true), 1.0); // a hand can do that
        QCOMPARE(pen.take(std::nan(""), false, true), 1.0);
        QCOMPARE(pen.take(7, false, true), 1.0);
        QCOMPARE(pen.take(1, true, true), 0.5);  // no touch begins with all there is
        QCOMPARE(pen.take(1, true, false), 1.0); // this pen measures none
        pen.setCurve(half());
        QCOMPARE(pen.take(0.5, true, true), 0.25);
        QCOMPARE(pen.take(0, false, true), 0.0);
        pen.setCurve({{{0.5f, 0}, {1, 1}}});
        QVERIFY(pen.take(0.3, false, true) > 0); // pressed is never lifted
    }

    void stampsTellHowLateAReportIs()
    {
        ReportLag lag;
        QCOMPARE(lag.take(0, 5'000'000), 0); // it has no stamp
        QCOMPARE(lag.take(100, 5'007'000), 0);
        QCOMPARE(lag.take(108, 5'012'000), 0);      // this one waited for less
        QCOMPARE(lag.take(116, 5'031'000), 10'999); // and this one for more, but for what clocks drift
        QCOMPARE(lag.take(0, 5'031'000), 0);
        QCOMPARE(lag.take(20, 5'400'000), 0); // the device has begun anew
        QCOMPARE(lag.take(28, 5'410'000), 1'999);
        QCOMPARE(lag.take(9'000, 5'418'000), 0); // and once more
        const Microseconds hours = 18'000'000'000;
        QCOMPARE(lag.take(9'000 + hours / 1000, 5'518'000 + hours), 0); // its clock is the slower one
    }

    /// The window was busy when the pen came down: the stroke is as old as it is, nothing of it is yet to come, and
    /// its reports keep their pace.
    void aLatePressIsNotPutOff_data()
    {
        QTest::addColumn<bool>("running");
        QTest::newRow("while the clock stands") << false;
        QTest::newRow("while it runs") << true;
    }
    void aLatePressIsNotPutOff()
    {
        QFETCH(bool, running);
        Session s;
        s.editor().setManualClock(false);
        s.use(Command::Brush);
        if (running) {
            s.paintLine({200, 200}, {500, 200});
            QTest::qWait(250);
            QVERIFY(s.editor().isRunning());
        }
        PenHand pen;
        const auto report = [&](QEvent::Type type, double x, int late, double pressure) {
            using namespace std::chrono;
            const auto now = duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
            const QPoint at = s.at({x, 300});
            pen.send(s.canvas(), {type, {double(at.x()), double(at.y())}, pressure, 0, 0, quint64(now - late)});
        };
        for (int i = 0; i < 5; ++i) // near by, not pressed: nothing waits
            report(QEvent::TabletMove, 200, 0, 0);
        const Microseconds before = s.editor().time();
        report(QEvent::TabletPress, 200, 100, 0.5);
        for (int i = 0; i < 6; ++i) {
            report(QEvent::TabletMove, 260 + 40 * i, 90 - 14 * i, 0.5);
            QVERIFY(s.editor().document().draft());
            QVERIFY(s.editor().document().draft()->segments.back().born <= s.editor().time());
        }
        const StrokePtr draft = s.editor().document().draft();
        if (!running)
            QCOMPARE(draft->born(), before);
        else
            QVERIFY(draft->born() < before && draft->born() > before - 150'000);
        QVERIFY(draft->segments.back().born - draft->born() >= 50'000);
        s.canvas().tool()->cancel();
    }

    void theCurveIsPaintedWith()
    {
        Session plain, curved;
        curved.canvas().setPenSettings({half(), false});
        Hand().line(plain, 300, std::vector<double>(12, 0.4));
        Hand().line(curved, 300, std::vector<double>(12, 0.8));
        QCOMPARE(plain.painting().strokes.size(), std::size_t(1));
        const Stroke &a = *plain.painting().strokes[0], &b = *curved.painting().strokes[0];
        QCOMPARE(b.segments.size(), a.segments.size());
        for (std::size_t i = 0; i < a.segments.size(); ++i)
            QVERIFY(std::abs(b.segments[i].density / a.segments[i].density - 1) < 1e-5f);
        // The mouse always presses fully.
        Session mouse;
        mouse.paintLine({200, 300}, {600, 300});
        curved.paintLine({200, 500}, {600, 500});
        QCOMPARE(strongest(*curved.painting().strokes[1]), strongest(*mouse.painting().strokes[0]));
    }

    void blipsLeaveNoBlobs()
    {
        const auto painted = [](std::vector<double> pressures) {
            Session s;
            Hand().line(s, 300, pressures);
            [&] { QCOMPARE(s.editor().undoStack().count(), 1); }();
            return *s.painting().strokes.at(0);
        };
        const std::vector<double> steady(20, 0.3);
        const float usual = strongest(painted(steady));
        for (const auto &[at, value] : {std::pair(std::size_t(9), 1.0), {9, 0.0}, {18, 1.0}}) {
            auto pressures = steady;
            pressures[at] = value;
            QVERIFY2(std::abs(strongest(painted(pressures)) / usual - 1) < 0.02f, qPrintable(QString::number(at)));
        }
        auto firm = steady;
        firm[0] = 1;
        QVERIFY(strongest(painted(firm)) < strongest(painted(std::vector<double>(20, 1.0))));
    }

    void aTapWithoutMoveIsADot()
    {
        Session s;
        Hand hand;
        hand.press(s.canvas(), s.at({300, 300}), 0.6);
        hand.press(s.canvas(), s.at({300, 300}), 0.6); // drivers repeat it
        s.advance(interval);
        hand.release(s.canvas(), s.at({300, 300}));
        hand.release(s.canvas(), s.at({300, 300}));
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(s.editor().undoStack().count(), 1);
        QVERIFY(!s.canvas().tool()->isBusy());
    }

    void aLostReleaseEndsTheStroke()
    {
        Session s;
        Hand hand;
        hand.line(s, 200, std::vector<double>(10, 0.5), false); // lifted outside the window
        QVERIFY(s.canvas().tool()->isBusy());
        hand.hover(s.canvas(), s.at({700, 500})); // comes back in the air
        QVERIFY(!s.canvas().tool()->isBusy());
        QCOMPARE(s.editor().undoStack().count(), 1);
        const Segment &last = s.painting().strokes[0]->segments.back();
        QVERIFY(near(s.painting().strokes[0]->origin + last.bezier[3], {380, 200}, 15)); // not where it came back
        hand.line(s, 300, std::vector<double>(10, 0.5), false);
        hand.proximity(false); // or never comes back
        QVERIFY(!s.canvas().tool()->isBusy());
        QCOMPARE(s.editor().undoStack().count(), 2);
        s.paintLine({200, 400}, {500, 400}); // the mouse is not locked out
        QCOMPARE(s.editor().undoStack().count(), 3);
    }

    void escapeGivesAPenStrokeUp()
    {
        Session s;
        Hand hand;
        hand.line(s, 200, std::vector<double>(10, 0.5), false);
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        hand.move(s.canvas(), s.at({500, 400}), 0.5);
        hand.release(s.canvas(), s.at({500, 400}));
        QVERIFY(s.painting().strokes.empty() && !s.editor().document().draft());
        hand.line(s, 300, std::vector<double>(10, 0.5));
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
    }

    void mouseAndPenDoNotMix()
    {
        Session s;
        Hand hand;
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({200, 200}));
        for (int i = 1; i <= 10; ++i) {
            s.advance(interval);
            QTest::mouseMove(&s.canvas(), s.at({200 + 20.0 * i, 200}));
            hand.move(s.canvas(), s.at({200 + 20.0 * i, 500}), 0.5);
            if (i == 5) {
                hand.press(s.canvas(), s.at({300, 500}), 0.5);
                hand.release(s.canvas(), s.at({300, 500}));
            }
        }
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({400, 200}));
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        hand.press(s.canvas(), s.at({200, 400}), 0.5);
        for (int i = 1; i <= 10; ++i) {
            s.advance(interval);
            hand.move(s.canvas(), s.at({200 + 20.0 * i, 400}), 0.5);
            QTest::mouseClick(&s.canvas(), Qt::LeftButton, {}, s.at({300, 600}));
            QTest::mouseMove(&s.canvas(), s.at({300, 600}));
        }
        hand.release(s.canvas(), s.at({400, 400}));
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));
        for (const auto &[index, y] : {std::pair(0, 200.0), {1, 400.0}}) {
            const Stroke &stroke = *s.painting().strokes.at(std::size_t(index));
            for (const Segment &segment : stroke.segments)
                QVERIFY(std::abs((stroke.origin + segment.bezier[3]).y - y) < 3);
        }
    }

    void theOtherEndIsKnownBeforeItTouches()
    {
        Session s;
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.use(Command::Brush);
        Hand eraser(QPointingDevice::PointerType::Eraser), pen;
        eraser.proximity(true);
        QVERIFY(s.window.action(Command::Eraser).isChecked());
        eraser.proximity(false);
        pen.proximity(true);
        QVERIFY(s.window.action(Command::Brush).isChecked());
        pen.proximity(false);
    }

    void hoveringShowsTheSpread()
    {
        Session s;
        Hand hand;
        s.dry();
        hand.hover(s.canvas(), s.at({500, 300}));
        QTRY_VERIFY(s.canvas().isUpToDate());
        const QImage with = s.canvas().grab().toImage();
        hand.proximity(false);
        const QImage without = s.canvas().grab().toImage();
        const double r = s.editor().brush().spread() * s.canvas().view().scale;
        const Point centre = s.canvas().view().toPixels({500, 300});
        int differing = 0, elsewhere = 0;
        for (int y = 0; y < with.height(); ++y)
            for (int x = 0; x < with.width(); ++x)
                if (with.pixel(x, y) != without.pixel(x, y))
                    (length(Point{double(x), double(y)} - centre) < 1.5 * r + 6 ? differing : elsewhere)++;
        QVERIFY(differing > 20);
        QCOMPARE(elsewhere, 0);
    }

    void fingersMoveTheViewWhereOnlyThePenPaints()
    {
        Session s;
        s.canvas().setPenSettings({{}, true});
        s.dry();
        const Point before = s.canvas().view().centre;
        const double scale = s.canvas().view().scale;
        const QPoint a(300, 300), b(500, 300);
        QTest::touchEvent(&s.canvas(), m_screen).press(0, a);
        for (int i = 1; i <= 10; ++i)
            QTest::touchEvent(&s.canvas(), m_screen).move(0, a + QPoint(6 * i, 3 * i));
        QTest::touchEvent(&s.canvas(), m_screen).release(0, a + QPoint(60, 30));
        QVERIFY(near(s.canvas().view().centre, before - (1 / scale) * Point{60, 30}, 1e-6));
        QCOMPARE(s.canvas().view().scale, scale);

        // Two: apart by half as much again, turned by a quarter.
        const Point held = s.canvas().view().toCanvas({400, 300});
        QTest::touchEvent(&s.canvas(), m_screen).press(0, a);
        QTest::touchEvent(&s.canvas(), m_screen).stationary(0).press(1, b);
        for (int i = 1; i <= 15; ++i) {
            const double angle = i / 15.0 * std::numbers::pi / 2, r = 100 * (1 + i / 30.0);
            const QPoint to(qRound(r * std::cos(angle)), qRound(r * std::sin(angle)));
            QTest::touchEvent(&s.canvas(), m_screen).move(0, QPoint(400, 300) - to).move(1, QPoint(400, 300) + to);
        }
        QTest::touchEvent(&s.canvas(), m_screen).release(0, {400, 150}).release(1, {400, 450});
        QVERIFY(std::abs(s.canvas().view().scale / scale - 1.5) < 0.01);
        QVERIFY(std::abs(std::abs(s.canvas().view().rotation) - std::numbers::pi / 2) < 0.01);
        QVERIFY(near(s.canvas().view().toPixels(held), {400, 300}, 2));
        QVERIFY(s.painting().strokes.empty());
        QCOMPARE(s.editor().undoStack().count(), 0);
        // The pen still paints.
        Hand().line(s, 300, std::vector<double>(10, 0.5));
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
    }

    void oneFingerPaintsWhereItMay()
    {
        Session s;
        s.dry();
        const double scale = s.canvas().view().scale;
        const auto touch = [&] { return QTest::touchEvent(&s.canvas(), m_screen); };
        touch().press(0, {300, 300});
        for (int i = 1; i <= 10; ++i) {
            s.advance(interval);
            touch().move(0, {300 + 10 * i, 300});
        }
        touch().release(0, {400, 300});
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(s.canvas().view().scale, scale);
        // A second finger means the view: what the first one began is given up.
        touch().press(0, {300, 400});
        touch().move(0, {320, 400});
        QVERIFY(s.canvas().tool()->isBusy());
        touch().stationary(0).press(1, {520, 400});
        QVERIFY(!s.canvas().tool()->isBusy());
        touch().move(0, {270, 400}).move(1, {570, 400});
        touch().release(0, {270, 400}).release(1, {570, 400});
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QVERIFY(!s.editor().document().draft());
        QVERIFY(std::abs(s.canvas().view().scale / scale - 1.5) < 0.01);
    }

    void theHandThatHoldsThePenIsIgnored()
    {
        Session s;
        s.dry();
        Hand hand;
        const View view = s.canvas().view();
        hand.proximity(true);
        QTest::touchEvent(&s.canvas(), m_screen).press(0, {600, 500});
        hand.line(s, 300, std::vector<double>(5, 0.5), false);
        QTest::touchEvent(&s.canvas(), m_screen).move(0, {640, 520});
        QTest::touchEvent(&s.canvas(), m_screen).stationary(0).press(1, {500, 500});
        QTest::touchEvent(&s.canvas(), m_screen).move(0, {620, 520}).move(1, {400, 500});
        hand.release(s.canvas(), s.at({280, 300}));
        QTest::touchEvent(&s.canvas(), m_screen).release(0, {620, 520}).release(1, {400, 500});
        hand.proximity(false);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(s.canvas().view().scale, view.scale);
        QCOMPARE(s.canvas().view().centre, view.centre);
    }

    void settingsKeepThePen()
    {
        QCOMPARE(settings::penSettings(), PenSettings{});
        const PenSettings pen{{{{0, 0.1f}, {0.3f, 0.25f}, {1, 0.9f}}}, true};
        settings::setPenSettings(pen);
        QCOMPARE(settings::penSettings(), pen);
        Session s;
        QCOMPARE(s.canvas().penSettings(), pen);
        for (const QStringList &damaged : {QStringList{"0 0"}, {"0 0", "nan 1"}, {"1 0", "0 1"}, {"a", "b"}, {}}) {
            settings::store().setValue("pen/pressure", damaged);
            QCOMPARE(settings::penSettings().pressure, ResponseCurve{});
        }
    }

    void curvesAreEdited()
    {
        ResponseEditor editor;
        editor.resize(220, 220);
        editor.show();
        const auto drag = [&](QPointF from, QPointF to) {
            QTest::mousePress(&editor, Qt::LeftButton, {}, from.toPoint());
            QTest::mouseMove(&editor, ((from + to) / 2).toPoint());
            QTest::mouseMove(&editor, to.toPoint());
            QTest::mouseRelease(&editor, Qt::LeftButton, {}, to.toPoint());
        };
        QSignalSpy edited(&editor, &ResponseEditor::edited);
        drag(editor.toWidget({0.4, 0.7}), editor.toWidget({0.5, 0.8})); // another point
        QCOMPARE(editor.curve().points.size(), std::size_t(3));
        QVERIFY(std::abs(editor.curve().points[1].x - 0.5f) < 0.02f &&
                std::abs(editor.curve().points[1].y - 0.8f) < 0.02f);
        drag(editor.toWidget({0.5, 0.8}), editor.toWidget({1, 0.2})); // not past the next one
        QVERIFY(editor.curve().isValid());
        QVERIFY(editor.curve().points[1].x < 1);
        drag(editor.toWidget({0, 0}), editor.toWidget({0, 0.25}));
        QVERIFY(std::abs(editor.curve().points[0].y - 0.25f) < 0.02f);
        QTest::keyClick(&editor, Qt::Key_Up);
        QVERIFY(std::abs(editor.curve().points[0].y - 0.26f) < 0.02f);
        QTest::keyClick(&editor, Qt::Key_PageUp);
        QTest::keyClick(&editor, Qt::Key_Delete);
        QCOMPARE(editor.curve().points.size(), std::size_t(2));
        QTest::keyClick(&editor, Qt::Key_Delete); // two stay
        QCOMPARE(editor.curve().points.size(), std::size_t(2));
        QVERIFY(edited.count() > 5);
    }

    void thePageIsTriedAndKept()
    {
        {
            SettingsDialog dialog;
            dialog.show();
            PenPage &page = *dialog.pen();
            QCOMPARE(page.feel()->currentIndex(), 1);
            emit page.feel()->activated(2);
            page.fingersMoveView()->setChecked(true);
            dialog.reject();
        }
        QCOMPARE(settings::penSettings(), PenSettings{});
        SettingsDialog dialog;
        dialog.show();
        PenPage &page = *dialog.pen();
        const auto tried = [&] {
            Hand hand;
            page.pad()->clear();
            hand.press(*page.pad(), {40, 60}, 0.4);
            for (int i = 1; i < 20; ++i)
                hand.move(*page.pad(), {40.0 + 6 * i, 60}, 0.4);
            hand.release(*page.pad(), {154, 60});
            return strongest(*page.pad()->strokes().at(0));
        };
        page.pad()->resize(260, 120);
        const float even = tried();
        emit page.feel()->activated(2);
        const float firm = tried();
        emit page.feel()->activated(0);
        const float soft = tried();
        QVERIFY2(firm < even && even < soft, qPrintable(QString("%1 %2 %3").arg(firm).arg(even).arg(soft)));
        page.fingersMoveView()->setChecked(true);
        dialog.accept();
        QVERIFY(settings::penSettings().fingersMoveView);
        QCOMPARE(settings::penSettings().pressure.points.size(), std::size_t(3));
    }

private:
    QTemporaryDir m_folder;
    QPointingDevice *m_screen = nullptr;
};

QTEST_MAIN(TestPen)
#include "test_pen.moc"
