// What is dragged is let go when a dialog or a menu takes the mouse, or when the release got lost.
#include "app/widgets/colour/colour_wheel.h"
#include "app/widgets/curves/curve_editor.h"
#include "app/widgets/numbers/bar_slider.h"
#include "tests/app/timed.h"

#include <QDialog>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>

using namespace suffuse;

namespace {

/// What takes the mouse from whom holds it.
enum class By { Dialog, Menu, LostRelease, Tip };

void take(By by, QWidget &window, QWidget &held, QPoint next)
{
    if (by == By::LostRelease) {
        const QPointF p(next);
        QMouseEvent event(QEvent::MouseMove, p, held.mapToGlobal(p), Qt::NoButton, Qt::NoButton, {});
        QCoreApplication::sendEvent(&held, &event);
        return;
    }
    QDialog dialog(&window);
    QMenu menu(&window);
    QLabel tip(QStringLiteral("tip"), &window, Qt::ToolTip);
    menu.addAction(QStringLiteral("Entry"));
    if (by == By::Dialog)
        dialog.open();
    else if (by == By::Menu)
        menu.popup(window.mapToGlobal(QPoint(5, 5)));
    else
        tip.show();
    QTest::qWait(1);
}

} // namespace

class TestHeldButton : public QObject {
    Q_OBJECT

private slots:
    void aBarOfTheTimeline_data()
    {
        QTest::addColumn<int>("by");
        QTest::newRow("dialog") << int(By::Dialog);
        QTest::newRow("menu") << int(By::Menu);
        QTest::newRow("lost release") << int(By::LostRelease);
    }

    /// The step is made as the release would make it, and the pointer moves nothing after that.
    void aBarOfTheTimeline()
    {
        QFETCH(int, by);
        Timed s;
        const QPoint from = s.middleOf(2), to = from + QPoint(40, 0);
        s.press(from);
        s.moveTo(from + QPoint(10, 0));
        s.moveTo(to);
        QVERIFY(!s.editor().undoStack().canUndo());
        take(By(by), s.window, *s.view().viewport(), to);
        QCOMPARE(s.steps(), 1);
        const auto moved = hashOf(s.painting());
        s.moveTo(to + QPoint(60, 0));
        s.release(to + QPoint(60, 0));
        QCOMPARE(hashOf(s.painting()), moved);
        QCOMPARE(s.steps(), 1);
        s.use(Command::Undo);
        QCOMPARE(s.middleOf(2), from);
    }

    void slidersWheelsAndCurves_data() { aBarOfTheTimeline_data(); }

    void slidersWheelsAndCurves()
    {
        QFETCH(int, by);
        QWidget window;
        auto *slider = new BarSlider(&window);
        auto *wheel = new ColourWheel(&window);
        auto *curve = new CurveEditor(&window);
        slider->setGeometry(0, 0, 200, 22);
        wheel->setGeometry(0, 30, 150, 150);
        curve->setGeometry(0, 200, 200, 120);
        window.resize(220, 340);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QSignalSpy slid(slider, &QSlider::sliderReleased), turned(wheel, &ColourWheel::finished);
        QSignalSpy drawn(curve, &CurveField::released);
        const auto drag = [&](QWidget &widget, QPoint from, QPoint to, const QSignalSpy &ended) {
            QTest::mousePress(&widget, Qt::LeftButton, {}, from);
            const QPointF p(to);
            QMouseEvent event(QEvent::MouseMove, p, widget.mapToGlobal(p), Qt::NoButton, Qt::LeftButton, {});
            QCoreApplication::sendEvent(&widget, &event);
            take(By::Tip, window, widget, to); // takes no mouse
            const auto before = ended.count();
            take(By(by), window, widget, to);
            return before == 0 && ended.count() == 1;
        };
        QVERIFY(drag(*slider, {20, 11}, {90, 11}, slid));
        QVERIFY(!slider->isSliderDown());
        QVERIFY(drag(*wheel, {75, 4}, {140, 75}, turned));
        QVERIFY(drag(*curve, {30, 60}, {90, 40}, drawn));
        QVERIFY(!curve->isDragging());
    }

    /// Its next key would press a button beside the wheel, for example.
    void tabStaysWithWhatIsDragged()
    {
        QWidget window;
        auto *wheel = new ColourWheel(&window);
        auto *button = new QPushButton(QStringLiteral("beside"), &window);
        wheel->setGeometry(0, 0, 150, 150);
        button->setGeometry(0, 160, 100, 30);
        window.resize(200, 200);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        wheel->setFocus();
        QTest::mousePress(wheel, Qt::LeftButton, {}, {75, 4});
        QTest::keyClick(wheel, Qt::Key_Tab);
        QVERIFY(wheel->hasFocus());
        QTest::mouseRelease(wheel, Qt::LeftButton, {}, {75, 4});
        QTest::keyClick(wheel, Qt::Key_Tab);
        QVERIFY(button->hasFocus());
    }
};

QTEST_MAIN(TestHeldButton)
#include "test_held_button.moc"
