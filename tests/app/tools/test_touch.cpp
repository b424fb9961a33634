// Fingers on the canvas, alone and beside the pen.
#include "app/session/settings/settings.h"
#include "tests/app/session.h"
#include "tests/app/synthetic_pen.h"

#include <QTemporaryDir>
#include <QtTest>

#include <numbers>

using namespace suffuse;

namespace {

bool near(Point a, Point b, double by)
{
    return length(a - b) < by;
}

} // namespace

class TestTouch : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toUtf8());
        m_screen = QTest::createTouchDevice();
    }
    void init() { settings::store().clear(); }

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
        SyntheticPen().line(s, 300, std::vector<double>(10, 0.5));
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
        SyntheticPen pen;
        const View view = s.canvas().view();
        pen.proximity(true);
        QTest::touchEvent(&s.canvas(), m_screen).press(0, {600, 500});
        pen.line(s, 300, std::vector<double>(5, 0.5), false);
        QTest::touchEvent(&s.canvas(), m_screen).move(0, {640, 520});
        QTest::touchEvent(&s.canvas(), m_screen).stationary(0).press(1, {500, 500});
        QTest::touchEvent(&s.canvas(), m_screen).move(0, {620, 520}).move(1, {400, 500});
        pen.release(s.canvas(), s.at({280, 300}));
        QTest::touchEvent(&s.canvas(), m_screen).release(0, {620, 520}).release(1, {400, 500});
        pen.proximity(false);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(s.canvas().view().scale, view.scale);
        QCOMPARE(s.canvas().view().centre, view.centre);
    }

private:
    QTemporaryDir m_folder;
    QPointingDevice *m_screen = nullptr;
};

QTEST_MAIN(TestTouch)
#include "test_touch.moc"
