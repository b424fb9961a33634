// The values of a stroke that are typed where it lies.
#include "app/panels/inspector/fill_section.h"
#include "app/panels/inspector/segment_section.h"
#include "app/session/painting/seen_width.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/bar_slider.h"
#include "app/window/pointer/value_card.h"
#include "tests/app/crossing.h"
#include "undo/edits.h"

#include <QTemporaryDir>
#include <QToolButton>

using namespace suffuse;

class TestValueCard : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void doubleClickEditsTheValuesThere()
    {
        Crossing s;
        s.doubleClick({250, 300});
        QCOMPARE(s.selection(), (Selection{{1}, {}}));
        QVERIFY(s.values() && s.values()->isOpen());
        ValueCard &card = *s.values();
        QCOMPARE(QApplication::focusWidget(), card.width()->number());
        const float before = s.stroke(1).segments[0].density;
        enter(*card.segments()->density()->number(), "31");
        QCOMPARE(s.stroke(1).segments[0].density, 31.f);
        QCOMPARE(s.stroke(1).segments[3].density, 31.f); // all of the stroke
        QCOMPARE(s.stroke(2).segments[0].density, before);
        QCOMPARE(s.steps(), 1);
        QVERIFY(!card.isOpen()); // by Return
        QVERIFY(s.canvasHasKeyboard());
        s.editor().undoStack().undo();
        QCOMPARE(s.stroke(1).segments[0].density, before);
        // One segment alone.
        s.doubleClick({250, 300});
        card.segmentButton()->click();
        QCOMPARE(s.selection().segments, (std::set<SegmentRef>{{1, 0}}));
        enter(*card.segments()->density()->number(), "17");
        QCOMPARE(s.stroke(1).segments[0].density, 17.f);
        QCOMPARE(s.stroke(1).segments[1].density, before);
        s.doubleClick({60, 60}); // nothing is there
        QVERIFY(!card.isOpen());
    }

    /// Where there is no width to set, the keyboard begins in the next field: a number that is typed is none of the
    /// canvas' keys.
    void theKeyboardBeginsInAFieldThatCanBeUsed()
    {
        Crossing s;
        s.editor().push(changeSegments(s.editor().document(), {{1, 0}, {1, 1}, {1, 2}, {1, 3}},
                                       [](Segment &segment) { segment.density = 0; }),
                        "without paint");
        s.use(Command::Select);
        s.select({1});
        s.key(Qt::Key_Return);
        QVERIFY(s.values() && s.values()->isOpen());
        QVERIFY(!s.values()->width()->number()->isEnabled());
        QCOMPARE(QApplication::focusWidget(), s.values()->segments()->diffusion()->number());
        s.key(Qt::Key_3);
        QVERIFY(s.values()->isOpen() && s.canvas().tool()->hint() != QString());
        QVERIFY(s.window.action(Command::Select).isChecked());
    }

    /// Of what is a fill alone the card shows the fill, and a number can be typed at once.
    void theValuesOfAFill()
    {
        Crossing s;
        const StrokeId id = s.painting().strokes.back()->id;
        s.editor().push(changeStrokes(s.editor().document(), {id},
                                      [](Stroke &stroke) {
                                          for (Segment &segment : stroke.segments)
                                              segment.density = 0;
                                          stroke.fill = Fill{};
                                      }),
                        "fill");
        s.use(Command::Select);
        s.editor().document().setSelection({{id}, {}});
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        QTest::keyClick(&s.canvas(), Qt::Key_Return);
        ValueCard &card = *s.values();
        QVERIFY(card.isOpen());
        QVERIFY(card.fill()->isVisible() && !card.segments()->isVisible());
        QLineEdit *field = card.fill()->row(&Fill::diffusion)->number();
        QCOMPARE(QApplication::focusWidget(), field);
        enter(*field, "30");
        QCOMPARE(s.painting().find(id)->fill->diffusion, 30.0f);
        QVERIFY(!card.isOpen());
        s.editor().document().setSelection({{s.painting().strokes.front()->id}, {}});
        QTest::keyClick(&s.canvas(), Qt::Key_Return);
        QVERIFY(!card.fill()->isVisible() && card.segments()->isVisible());
        QCOMPARE(QApplication::focusWidget(), card.width()->number());
    }

    /// What was refused is said, in a card that is still there.
    void aRefusedNumberLeavesTheCardOpen()
    {
        Crossing s;
        s.select({1});
        s.key(Qt::Key_Return);
        ValueCard &card = *s.values();
        QVERIFY(card.isOpen());
        const int steps = s.steps();
        QLineEdit *diffusion = card.segments()->diffusion()->number();
        diffusion->setFocus();
        enter(*diffusion, "0");
        QVERIFY(card.isOpen());
        QVERIFY(std::ranges::any_of(card.findChildren<HintLabel *>(), [](const HintLabel *hint) {
            return hint->isVisible() && hint->text().contains("0");
        }));
        QCOMPARE(s.steps(), steps);
        enter(*diffusion, "30");
        QVERIFY(!card.isOpen());
        QCOMPARE(s.steps(), steps + 1);
    }

    void escapeClosesTheValuesAndGivesUpTheDrag()
    {
        Crossing s;
        s.doubleClick({250, 300});
        ValueCard &card = *s.values();
        const Painting before = s.painting();
        BarSlider &slider = *card.segments()->density()->slider();
        QTest::mousePress(&slider, Qt::LeftButton, {}, slider.rect().center());
        QTest::mouseMove(&slider, slider.rect().center() + QPoint(20, 0));
        QVERIFY(!(s.painting() == before));
        QTest::keyClick(&slider, Qt::Key_Escape);
        QVERIFY(s.painting() == before);
        QTest::mouseRelease(&slider, Qt::LeftButton, {}, slider.rect().center());
        QCOMPARE(s.steps(), 0);
        s.key(Qt::Key_Escape);
        QVERIFY(!card.isOpen());
        QVERIFY(s.canvasHasKeyboard());
        QVERIFY(s.painting() == before);
    }

    void widthKeepsWhatVaries()
    {
        Crossing s;
        Edit edit = changeStrokes(s.editor().document(), {1}, [](Stroke &stroke) {
            stroke.segments[1].density *= 1.4f;
            stroke.segments[2].density *= 0.8f;
        });
        s.editor().push(std::move(edit), "vary");
        const Microseconds time = s.editor().clock().time();
        const auto width = [&](int k) { return seenWidth(s.stroke(1), k, time)->width; };
        const double ratio = width(2) / width(1);
        s.doubleClick({250, 300});
        ValueCard &card = *s.values();
        QVERIFY(card.width()->number()->value());
        QVERIFY(std::abs(*card.width()->number()->value() - 2 * width(1)) < 1e-6); // the widest
        enter(*card.width()->number(), "30");
        QVERIFY2(std::abs(2 * width(1) - 30) < 1e-3, qPrintable(QString::number(2 * width(1))));
        QVERIFY(std::abs(width(2) / width(1) - ratio) < 1e-4);
        QCOMPARE(s.editor().undoStack().undoText(), QString("Change width"));
        s.editor().undoStack().undo();
        QVERIFY(std::abs(width(2) / width(1) - ratio) < 1e-9);
    }

    /// The handle that shows a width takes a number, too.
    void doubleClickOnTheWidthHandleTypesTheWidth()
    {
        Crossing s;
        s.use(Command::Segments);
        s.editor().document().setSelection({{1}, {{1, 1}}});
        s.dry();
        std::optional<Point> handle;
        for (double y = 250; y <= 350 && !handle; ++y) { // beside the middle of the segment
            const Point at{350, y};
            s.send(QEvent::MouseMove, s.at(at), none);
            if (s.canvas().tool()->hint().contains("set the width"))
                handle = at;
        }
        QVERIFY(handle);
        s.doubleClick(*handle);
        QVERIFY(s.values() && s.values()->isOpen());
        QCOMPARE(QApplication::focusWidget(), s.values()->width()->number());
        QVERIFY(s.values()->segmentButton()->isChecked());
        QCOMPARE(s.steps(), 0);
        enter(*s.values()->width()->number(), "24");
        const double width = seenWidth(s.stroke(1), 1, s.editor().clock().time())->width;
        QVERIFY2(std::abs(2 * width - 24) < 1e-3, qPrintable(QString::number(2 * width)));
        QCOMPARE(s.stroke(1).segments[0].density, 20.f);
        QCOMPARE(s.steps(), 1);
    }

    void returnOpensTheValuesOfTheSelection()
    {
        Crossing s;
        s.select({1, 2});
        s.key(Qt::Key_Return);
        QVERIFY(s.values() && s.values()->isOpen());
        QVERIFY(s.window.rect().contains(s.values()->geometry()));
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
        s.key(Qt::Key_Escape);
        QVERIFY(!s.values()->isOpen());
        s.select({});
        QVERIFY(!s.window.action(Command::EditHere).isEnabled());
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestValueCard)
#include "test_value_card.moc"
