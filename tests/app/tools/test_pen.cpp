// The pen on the canvas, by synthetic devices.
#include "app/session/settings/settings.h"
#include "tests/app/pen_hand.h"
#include "tests/app/session.h"
#include "tests/app/synthetic_pen.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace suffuse;

namespace {

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
        s.editor().clock().setManual(false);
        s.use(Command::Brush);
        if (running) {
            s.paintLine({200, 200}, {500, 200});
            QTest::qWait(250);
            QVERIFY(s.editor().clock().isRunning());
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
        const Microseconds before = s.editor().clock().time();
        report(QEvent::TabletPress, 200, 100, 0.5);
        for (int i = 0; i < 6; ++i) {
            report(QEvent::TabletMove, 260 + 40 * i, 90 - 14 * i, 0.5);
            QVERIFY(s.editor().document().draft());
            QVERIFY(s.editor().document().draft()->segments.back().born <= s.editor().clock().time());
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
        SyntheticPen().line(plain, 300, std::vector<double>(12, 0.4));
        SyntheticPen().line(curved, 300, std::vector<double>(12, 0.8));
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
            SyntheticPen().line(s, 300, pressures);
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
        SyntheticPen pen;
        pen.press(s.canvas(), s.at({300, 300}), 0.6);
        pen.press(s.canvas(), s.at({300, 300}), 0.6); // drivers repeat it
        s.advance(interval);
        pen.release(s.canvas(), s.at({300, 300}));
        pen.release(s.canvas(), s.at({300, 300}));
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(s.editor().undoStack().count(), 1);
        QVERIFY(!s.canvas().tool()->isBusy());
    }

    void aLostReleaseEndsTheStroke()
    {
        Session s;
        SyntheticPen pen;
        pen.line(s, 200, std::vector<double>(10, 0.5), false); // lifted outside the window
        QVERIFY(s.canvas().tool()->isBusy());
        pen.hover(s.canvas(), s.at({700, 500})); // comes back in the air
        QVERIFY(!s.canvas().tool()->isBusy());
        QCOMPARE(s.editor().undoStack().count(), 1);
        const Segment &last = s.painting().strokes[0]->segments.back();
        QVERIFY(near(s.painting().strokes[0]->origin + last.bezier[3], {380, 200}, 15)); // not where it came back
        pen.line(s, 300, std::vector<double>(10, 0.5), false);
        pen.proximity(false); // or never comes back
        QVERIFY(!s.canvas().tool()->isBusy());
        QCOMPARE(s.editor().undoStack().count(), 2);
        s.paintLine({200, 400}, {500, 400}); // the mouse is not locked out
        QCOMPARE(s.editor().undoStack().count(), 3);
    }

    void escapeGivesAPenStrokeUp()
    {
        Session s;
        SyntheticPen pen;
        pen.line(s, 200, std::vector<double>(10, 0.5), false);
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        pen.move(s.canvas(), s.at({500, 400}), 0.5);
        pen.release(s.canvas(), s.at({500, 400}));
        QVERIFY(s.painting().strokes.empty() && !s.editor().document().draft());
        pen.line(s, 300, std::vector<double>(10, 0.5));
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
    }

    void mouseAndPenDoNotMix()
    {
        Session s;
        SyntheticPen pen;
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({200, 200}));
        for (int i = 1; i <= 10; ++i) {
            s.advance(interval);
            QTest::mouseMove(&s.canvas(), s.at({200 + 20.0 * i, 200}));
            pen.move(s.canvas(), s.at({200 + 20.0 * i, 500}), 0.5);
            if (i == 5) {
                pen.press(s.canvas(), s.at({300, 500}), 0.5);
                pen.release(s.canvas(), s.at({300, 500}));
            }
        }
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({400, 200}));
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        pen.press(s.canvas(), s.at({200, 400}), 0.5);
        for (int i = 1; i <= 10; ++i) {
            s.advance(interval);
            pen.move(s.canvas(), s.at({200 + 20.0 * i, 400}), 0.5);
            QTest::mouseClick(&s.canvas(), Qt::LeftButton, {}, s.at({300, 600}));
            QTest::mouseMove(&s.canvas(), s.at({300, 600}));
        }
        pen.release(s.canvas(), s.at({400, 400}));
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
        SyntheticPen eraser(QPointingDevice::PointerType::Eraser), pen;
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
        SyntheticPen pen;
        s.dry();
        pen.hover(s.canvas(), s.at({500, 300}));
        QTRY_VERIFY(s.canvas().isUpToDate());
        const QImage with = s.canvas().grab().toImage();
        pen.proximity(false);
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

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestPen)
#include "test_pen.moc"
