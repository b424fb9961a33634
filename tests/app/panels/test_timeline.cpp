// Time in the window: playing, painting in the past, drying.
#include "app/panels/inspector/rows/rewet_rows.h"
#include "app/widgets/numbers/time_text.h"
#include "tests/app/timed.h"
#include "undo/time_edits.h"

#include <QToolButton>

using namespace suffuse;

class TestTimeline : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
        qputenv("SUFFUSE_BACKEND", "cpu");
    }

    void playsAtItsSpeedToTheEnd()
    {
        Timed s;
        Playback &playback = s.playback();
        QCOMPARE(playback.begin(), second);
        QCOMPARE(playback.end(), 11'300'000);
        playback.setSkipsPauses(false);
        playback.setSpeed(2);
        playback.play(); // from the end: from the beginning
        QVERIFY(playback.isPlaying());
        QCOMPARE(s.editor().clock().time(), second);
        QVERIFY(s.editor().clock().isInPast());
        playback.advance(400'000);
        QCOMPARE(s.editor().clock().time(), 1'800'000);
        playback.setSpeed(0.1);
        playback.advance(15);
        playback.advance(15); // three microseconds in all
        QCOMPARE(s.editor().clock().time(), 1'800'003);
        playback.setSpeed(5000);
        QCOMPARE(playback.speed(), Playback::fastest);
        playback.advance(60'000);
        QCOMPARE(s.editor().clock().time(), playback.end());
        QVERIFY(!playback.isPlaying());
        QVERIFY(!s.editor().clock().isInPast());
        QVERIFY(!s.editor().clock().isRunning());
    }

    void loopsAndSkipsPauses()
    {
        Timed s;
        Playback &playback = s.playback();
        s.use(Command::LoopPlaying);
        QVERIFY(playback.loops());
        QVERIFY(playback.skipsPauses());
        playback.seek(4 * second);
        playback.play();
        playback.advance(300'000 + 500'000 + 200'000); // the last stroke dries at 4.3, half a second is kept
        QCOMPARE(s.editor().clock().time(), 10'200'000);
        playback.advance(2 * second);
        QCOMPARE(s.editor().clock().time(), second);
        QVERIFY(playback.isPlaying());
        s.use(Command::Play);
        QVERIFY(!playback.isPlaying());
        s.use(Command::NextStroke);
        QCOMPARE(s.editor().clock().time(), 2 * second);
        s.use(Command::NextStroke);
        s.use(Command::NextStroke);
        QCOMPARE(s.editor().clock().time(), 10 * second);
        s.use(Command::NextStroke);
        QCOMPARE(s.editor().clock().time(), playback.end());
        s.use(Command::PreviousStroke);
        QCOMPARE(s.editor().clock().time(), 10 * second);
        s.use(Command::ToStart);
        QCOMPARE(s.editor().clock().time(), second);
        s.use(Command::LetDry);
        QCOMPARE(s.editor().clock().time(), playback.end());
        QCOMPARE(s.steps(), 0);
    }

    void itPlaysByTheClock()
    {
        Timed s;
        s.editor().clock().setManual(false);
        s.playback().setSpeed(10);
        s.use(Command::Play);
        QTRY_VERIFY_WITH_TIMEOUT(s.editor().clock().time() > 2 * second, waitMs);
        QTRY_VERIFY_WITH_TIMEOUT(!s.playback().isPlaying(), waitMs);
        QCOMPARE(s.editor().clock().time(), s.playback().end());
    }

    /// The picture at a moment is the same bits however it was reached.
    void scrubbedIsPlayedIsRendered()
    {
        Timed s;
        const Microseconds moments[] = {1'234'567, 2'500'000, 3'111'111, 10'050'000, 11'300'000};
        std::vector<QImage> played;
        s.playback().setSkipsPauses(false);
        for (const Microseconds T : moments) {
            while (s.editor().clock().time() < T || s.editor().clock().time() == s.playback().end()) {
                s.playback().play();
                s.playback().advance(std::min<Microseconds>(170'000, T - s.editor().clock().time()));
                s.playback().pause();
                if (s.editor().clock().time() == T)
                    break;
                QTest::qWait(1); // frames between come and go
            }
            played.push_back(s.pictureNow());
        }
        for (std::size_t i = std::size(moments); i-- > 0;) { // backwards
            s.playback().seek(moments[i]);
            const QImage scrubbed = s.pictureNow();
            QVERIFY(!scrubbed.isNull());
            QCOMPARE(scrubbed, played[i]);
            QCOMPARE(rendered(s.painting(), moments[i], s.canvas().view()), scrubbed);
        }
        QVERIFY(played[0] != played[1]);
        QVERIFY(played[3] != played[4]);
    }

    void thePastStandsStill()
    {
        Timed s;
        s.editor().clock().setManual(false);
        s.playback().seek(2'200'000); // strokes 1 and 2 are wet
        QVERIFY(s.editor().clock().isInPast());
        QTest::qWait(60);
        QCOMPARE(s.editor().clock().time(), 2'200'000);
        QVERIFY(!s.editor().clock().isRunning());
        s.playback().seek(99 * second);
        QVERIFY(!s.editor().clock().isInPast());
        QCOMPARE(s.editor().clock().time(), 11'300'000);
    }

    /// What is shown lies between 0 and the end, also when the end comes earlier; what comes back is as dry as it was.
    void theMomentShownFollowsTheEnd()
    {
        Timed s;
        s.playback().seek(s.playback().end());
        const QImage before = s.pictureNow();
        const Microseconds clock = s.editor().clock().time();
        s.select({4});
        s.use(Command::Delete);
        QCOMPARE(s.playback().end(), 4'300'000);
        QCOMPARE(s.editor().clock().shown(), 4'300'000);
        QVERIFY(!s.editor().clock().isInPast());
        const auto says = [&](const QString &text) {
            const auto labels = s.panel->findChildren<QLabel *>();
            return std::any_of(labels.begin(), labels.end(), [&](const QLabel *l) { return l->text() == text; });
        };
        QTRY_VERIFY_WITH_TIMEOUT(says("0:04.300 / 0:04.300"), waitMs);
        s.use(Command::Undo);
        QCOMPARE(s.editor().clock().shown(), clock);
        QCOMPARE(s.pictureNow(), before);
        s.use(Command::Redo);
        s.view().setFocus();
        QTest::keyClick(&s.view(), Qt::Key_Left); // a step from what is shown
        QVERIFY(s.editor().clock().time() < 4'300'000);
        s.use(Command::SelectAll);
        s.use(Command::Delete);
        QCOMPARE(s.editor().clock().shown(), 0);
        QTRY_VERIFY_WITH_TIMEOUT(says("0:00.000 / 0:00.000"), waitMs);
    }

    /// The end is that of the stroke in hand, too. An outline that waits for its next node dries, and then the picture,
    /// and with it the moment, stays.
    void theMomentShownIsNeverAfterTheEndOfWhatIsInHand()
    {
        Timed s;
        s.playback().seek(s.playback().end());
        const Microseconds painted = s.playback().end();
        const auto says = [&](Microseconds shown, Microseconds end) {
            const auto labels = s.panel->findChildren<QLabel *>();
            return std::any_of(labels.begin(), labels.end(),
                               [&](const QLabel *l) { return l->text() == clockText(shown) + " / " + clockText(end); });
        };
        for (const Command tool : {Command::OutlinePen, Command::LassoFill}) {
            s.use(tool);
            for (const Point corner : {Point{250, 300}, {550, 300}, {550, 400}})
                QTest::mouseClick(&s.canvas(), Qt::LeftButton, {}, s.at(corner), 1000);
            const Microseconds dry = s.editor().document().draft()->driesAt();
            QVERIFY(dry > painted);
            s.advance(100'000);
            const Microseconds now = s.editor().clock().time();
            QVERIFY(now < dry);
            QVERIFY(says(now, dry));
            s.advance(100 * second);
            QCOMPARE(s.editor().clock().shown(), dry);
            QVERIFY(says(dry, dry));
            s.use(Command::Undo); // gives the outline up
            if (s.canvas().tool()->isBusy())
                s.canvas().tool()->cancel();
            QCOMPARE(s.editor().clock().shown(), painted);
            s.advance(0);
            QVERIFY(says(painted, painted));
        }
    }

    /// Letters that are typed while the timeline shows the past are seen when they have spread, as a stroke is.
    void lettersInThePastAreSeen()
    {
        Timed s;
        s.playback().seek(2'500'000);
        const QImage before = s.pictureNow();
        s.use(Command::Text);
        s.click({300, 420});
        QTest::keyClicks(&s.canvas(), "Hill");
        QVERIFY(s.editor().clock().isInPast());
        QVERIFY(s.editor().clock().isRunning());
        s.editor().clock().setManual(false);
        QTRY_VERIFY_WITH_TIMEOUT(!s.editor().clock().isRunning(), waitMs);
        QVERIFY(s.editor().clock().isInPast());
        QCOMPARE(s.order(), (std::vector<StrokeId>{1, 2, 5, 6, 7, 8, 3, 4})); // what came later covers them
        Microseconds dry = 0;
        for (const StrokePtr &stroke : s.painting().strokes)
            if (stroke->id > 4)
                dry = std::max(dry, stroke->driesAt());
        QCOMPARE(s.editor().clock().time(), dry);
        const QImage now = s.pictureNow();
        const Point pixel = s.canvas().view().toPixels({300, 420});
        int changed = 0;
        for (int y = int(pixel.y) - 60; y < int(pixel.y) + 10; ++y)
            for (int x = int(pixel.x); x < int(pixel.x) + 100; ++x)
                changed += before.pixelColor(x, y) != now.pixelColor(x, y);
        QVERIFY2(changed > 50, qPrintable(QString::number(changed)));
        s.use(Command::Select);
        s.editor().undo();
        QVERIFY(!s.editor().undoStack().canUndo() || s.painting().strokes.size() <= 4);
    }

    void paintsInThePast()
    {
        Timed s;
        const QImage before = s.pictureNow();
        s.playback().seek(2'500'000);
        QVERIFY(s.hint().startsWith("You paint in the past"));
        s.paintLine({250, 300}, {550, 300});
        QCOMPARE(s.steps(), 1);
        const StrokeId painted = s.painting().strokes[2]->id;
        QCOMPARE(s.order(), (std::vector<StrokeId>{1, 2, painted, 3, 4}));
        const Stroke &stroke = s.stroke(painted);
        QCOMPARE(stroke.born(), 2'500'000);
        QVERIFY(s.editor().clock().isInPast());
        QVERIFY(s.editor().clock().isRunning()); // it still spreads
        s.editor().clock().setManual(false);
        QTRY_VERIFY_WITH_TIMEOUT(!s.editor().clock().isRunning(), waitMs);
        QCOMPARE(s.editor().clock().time(), stroke.driesAt()); // and no further
        QVERIFY(s.editor().clock().isInPast());
        s.use(Command::ToEnd);
        QVERIFY(!s.hint().startsWith("You paint in the past"));
        const QImage with = s.pictureNow();
        QVERIFY(with != before);
        // Where the last stroke lies over it all, the new one cannot be seen.
        const Point middle = s.canvas().view().toPixels({300, 300});
        const QColor now = with.pixelColor(int(middle.x), int(middle.y)),
                     was = before.pixelColor(int(middle.x), int(middle.y));
        QVERIFY(std::abs(now.red() - was.red()) + std::abs(now.green() - was.green()) +
                    std::abs(now.blue() - was.blue()) <
                6);
        QCOMPARE(rendered(s.painting(), s.painting().end(), s.canvas().view()), with);
        s.use(Command::Undo);
        QCOMPARE(s.order(), (std::vector<StrokeId>{1, 2, 3, 4}));
        QCOMPARE(s.pictureNow(), before);
    }

    /// The stroke in hand lies where the finished one will.
    void theDraftHasItsPlace()
    {
        Timed s;
        s.playback().seek(2'950'000);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({250, 300}));
        for (int i = 1; i <= 20; ++i) {
            s.advance(interval); // stroke 3 begins meanwhile
            QTest::mouseMove(&s.canvas(), s.at({250.0 + 15 * i, 300}));
        }
        const StrokeId id = s.editor().document().draft()->id;
        QCOMPARE(s.editor().shown()->strokes[2]->id, id);
        QCOMPARE(s.editor().shown()->strokes.size(), std::size_t(5));
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({550, 300}));
        QCOMPARE(s.painting().strokes[2]->id, id);
        QVERIFY(s.editor().clock().isInPast());
        // One that is given up leaves the clock where the pen left it.
        s.playback().seek(2 * second);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({250, 300}));
        s.advance(interval);
        QTest::mouseMove(&s.canvas(), s.at({300, 300}));
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QCOMPARE(s.editor().clock().time(), 2 * second + interval);
        QTRY_VERIFY_WITH_TIMEOUT(!s.editor().clock().isRunning(), waitMs);
        QCOMPARE(s.steps(), 1);
    }

    void thePenStopsPlaying()
    {
        Timed s;
        s.playback().setSpeed(0.1);
        s.use(Command::Play);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({250, 300}));
        const Microseconds T = s.editor().clock().time();
        s.playback().advance(second);
        QVERIFY(!s.playback().isPlaying());
        QCOMPARE(s.editor().clock().time(), T);
        s.advance(interval);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({300, 300}));
        QCOMPARE(s.steps(), 1);
        QCOMPARE(s.painting().strokes[1]->born(), T); // after the first
    }

    void whatIsNotPaintedYetIsNotPicked()
    {
        Timed s;
        s.use(Command::Select);
        s.playback().seek(2'900'000);
        s.click({400, 300}); // where all of them cross
        QCOMPARE(s.selected(), std::set<StrokeId>{2});
        s.use(Command::ToEnd);
        s.click({50, 50});
        s.click({400, 300});
        QCOMPARE(s.selected(), std::set<StrokeId>{4});
    }

    void finalPreviewIsTheEnd()
    {
        Timed s({drawnAt(1, second, {200, 200}, {600, 400})});
        const QImage dry = s.pictureNow();
        s.playback().seek(1'500'000); // painted, wet
        const QImage wet = s.pictureNow();
        QVERIFY(wet != dry);
        s.use(Command::FinalPreview);
        QCOMPARE(s.pictureNow(), dry);
        s.playback().seek(1'600'000);
        QCOMPARE(s.pictureNow(), dry);
        s.playback().seek(1'150'000); // half of it is painted
        const QImage half = s.pictureNow();
        QVERIFY(half != dry);
        s.use(Command::FinalPreview);
        QVERIFY(s.pictureNow() != half);
        QCOMPARE(s.steps(), 0);
        // The stroke in hand, too.
        s.use(Command::ToEnd);
        s.use(Command::FinalPreview);
        s.paintLine({200, 450}, {600, 450});
        const QImage early = s.pictureNow();
        s.dry();
        QCOMPARE(s.pictureNow(), early);
    }

    void freezeAndRewet()
    {
        Timed s;
        s.playback().seek(2'500'000);
        const QImage then = s.pictureNow();
        s.use(Command::FreezeNow);
        QCOMPARE(s.steps(), 1);
        QVERIFY(s.stroke(2).driesAt() <= 2'500'001);
        s.playback().seek(2'999'000);
        QCOMPARE(s.pictureNow(), then); // it stays
        s.use(Command::Undo);

        s.use(Command::Rewet);
        QCOMPARE(s.steps(), 1); // nothing is selected: redo is still there
        QVERIFY(!s.window.action(Command::Rewet).isEnabled());
        s.select({1});
        s.playback().seek(5 * second);
        bool asked = false;
        QTimer::singleShot(0, &s.window, [&] {
            QWidget *dialog = QApplication::activeModalWidget();
            auto *box = dialog ? dialog->findChild<QDoubleSpinBox *>() : nullptr;
            if (!box)
                return;
            asked = true;
            box->selectAll();
            QTest::keyClicks(box, "2*"); // not to be read yet
            QTest::keyClick(box, Qt::Key_Return);
            QVERIFY(dialog->isVisible());
            QTest::keyClicks(box, "1");
            QTest::keyClick(box, Qt::Key_Return);
        });
        s.use(Command::Rewet);
        QVERIFY(asked);
        QCOMPARE(s.stroke(1).segments[0].rewet, (std::vector<Rewet>{{5 * second, 2 * second}}));
        QCOMPARE(s.stroke(1).driesAt(), 7 * second);
        s.use(Command::RemoveRewetting);
        QVERIFY(s.stroke(1).segments[0].rewet.empty());
        s.use(Command::Undo);
        s.use(Command::Undo);
        QCOMPARE(s.stroke(1).driesAt(), 2'300'000);
    }

    void theInspectorTakesRewettingsAway()
    {
        Timed s;
        s.select({1, 2});
        s.editor().push(rewet(s.editor().document(), 5 * second, second / 2), "wet");
        s.select({1});
        s.editor().push(rewet(s.editor().document(), 7 * second, 2 * second), "wet");
        const QByteArray wetted = hashOf(s.painting());
        RewetRows &rows = *s.window.findChild<RewetRows *>();
        const auto texts = [&rows] {
            QStringList texts;
            for (const QLabel *label : rows.findChildren<QLabel *>())
                if (label->text().startsWith("at "))
                    texts << label->text();
            return texts;
        };
        QTRY_COMPARE_WITH_TIMEOUT(texts(), (QStringList{"at 0:05.000 for 0.5 s", "at 0:07.000 for 2 s"}), waitMs);
        s.select({1, 2});
        QTRY_COMPARE_WITH_TIMEOUT(texts(), (QStringList{"at 0:05.000 for 0.5 s", "at 0:07.000 for 2 s, some segments"}),
                                  waitMs);
        rows.findChildren<QToolButton *>().first()->click();
        QVERIFY(s.stroke(2).segments[0].rewet.empty());
        QCOMPARE(s.stroke(1).segments[0].rewet, (std::vector<Rewet>{{7 * second, 2 * second}}));
        QTRY_COMPARE_WITH_TIMEOUT(texts().size(), 1, waitMs);
        s.use(Command::Undo);
        QCOMPARE(hashOf(s.painting()), wetted);
        s.select({4});
        QTRY_VERIFY_WITH_TIMEOUT(!rows.isVisibleTo(rows.parentWidget()), waitMs);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestTimeline)
#include "test_timeline.moc"
