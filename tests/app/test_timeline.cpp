// Time in the window: playing, scrubbing, painting in the past, drying, and the timeline's bars.
#include "app/panels/timeline_panel.h"
#include "app/panels/timeline_view.h"
#include "app/playback.h"
#include "model/formats/files.h"
#include "tests/app/selecting.h"

#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTimer>

using namespace suffuse;

namespace {

constexpr Microseconds second = 1'000'000;

/// A straight stroke whose segments are born a tenth of a second apart.
StrokePtr drawnAt(StrokeId id, Microseconds born, Point from, Point to, Colour colour = {1, 0, 0, 1})
{
    auto stroke = std::make_shared<Stroke>(*line(id, from, to));
    for (std::size_t k = 0; k < stroke->segments.size(); ++k) {
        stroke->segments[k].born = born + Microseconds(k) * second / 10;
        stroke->segments[k].colour = colour;
    }
    return stroke;
}

/// Four strokes that cross in the middle, begun at 1, 2, 3 and 10 seconds; each dries 1.3 s after.
StrokeList fourStrokes()
{
    return {drawnAt(1, second, {200, 200}, {600, 400}), drawnAt(2, 2 * second, {600, 200}, {200, 400}, {0, 1, 0, 1}),
            drawnAt(3, 3 * second, {400, 150}, {400, 450}, {0, 0, 1, 1}),
            drawnAt(4, 10 * second, {200, 300}, {600, 300}, {1, 1, 0, 1})};
}

/// A window with strokes in it, the timeline shown.
struct Timed : Selecting {
    explicit Timed(StrokeList strokes = fourStrokes()) : Selecting(std::move(strokes))
    {
        panel = window.findChild<TimelinePanel *>();
        qobject_cast<QDockWidget *>(panel->parentWidget())->show();
        use(Command::Brush);
        QTRY_VERIFY_WITH_TIMEOUT(view().viewport()->height() > 80, waitMs);
    }
    TimelineView &view() { return *panel->view(); }
    Playback &playback() { return window.playback(); }
    QPoint middleOf(StrokeId id) { return view().drawnRect(id).center().toPoint(); }
    QPoint endOf(StrokeId id)
    {
        const QRectF rect = view().drawnRect(id);
        return QPointF(rect.right(), rect.center().y()).toPoint();
    }
    QPoint beginOf(StrokeId id)
    {
        const QRectF rect = view().drawnRect(id);
        return QPointF(rect.left(), rect.center().y()).toPoint();
    }
    QPoint onRuler(Microseconds time) { return {int(std::lround(view().xOf(time))), 5}; }
    void press(QPoint at, Qt::KeyboardModifiers keys = {})
    {
        QTest::mousePress(view().viewport(), Qt::LeftButton, keys, at);
    }
    void moveTo(QPoint at)
    {
        const QPointF p(at);
        QMouseEvent event(QEvent::MouseMove, p, view().viewport()->mapToGlobal(p), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(view().viewport(), &event);
    }
    void release(QPoint at) { QTest::mouseRelease(view().viewport(), Qt::LeftButton, {}, at); }
    void dragBar(QPoint from, QPoint to)
    {
        press(from);
        moveTo(from + (to - from) / 2);
        moveTo(to);
        release(to);
    }
    QImage pictureNow()
    {
        [&] { QTRY_VERIFY_WITH_TIMEOUT(canvas().isUpToDate(), waitMs); }();
        return canvas().picture();
    }
    std::vector<StrokeId> order()
    {
        std::vector<StrokeId> ids;
        for (const StrokePtr &s : painting().strokes)
            ids.push_back(s->id);
        return ids;
    }
    QString hint()
    {
        for (const QLabel *label : window.findChildren<QLabel *>())
            if (label->text().endsWith(canvas().tool()->hint()))
                return label->text();
        return {};
    }

    TimelinePanel *panel = nullptr;
};

/// What a renderer that has drawn nothing before makes of it.
QImage rendered(const Painting &painting, Microseconds time, const View &view)
{
    auto renderer = makeRenderer({.backend = Backend::Cpu, .threads = 1});
    RenderRequest request;
    request.painting = std::make_shared<const Painting>(painting);
    request.time = time;
    request.view = view;
    Picture8 picture;
    if (!renderer || !(*renderer)->render(request, picture, nullptr))
        return {};
    return QImage(reinterpret_cast<const uchar *>(picture.argb.data()), picture.width, picture.height,
                  picture.width * 4, QImage::Format_ARGB32)
        .copy();
}

} // namespace

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
        QCOMPARE(s.editor().time(), second);
        QVERIFY(s.editor().isInPast());
        playback.advance(400'000);
        QCOMPARE(s.editor().time(), 1'800'000);
        playback.setSpeed(0.1);
        playback.advance(15);
        playback.advance(15); // three microseconds in all
        QCOMPARE(s.editor().time(), 1'800'003);
        playback.setSpeed(5000);
        QCOMPARE(playback.speed(), Playback::fastest);
        playback.advance(60'000);
        QCOMPARE(s.editor().time(), playback.end());
        QVERIFY(!playback.isPlaying());
        QVERIFY(!s.editor().isInPast());
        QVERIFY(!s.editor().isRunning());
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
        QCOMPARE(s.editor().time(), 10'200'000);
        playback.advance(2 * second);
        QCOMPARE(s.editor().time(), second);
        QVERIFY(playback.isPlaying());
        s.use(Command::Play);
        QVERIFY(!playback.isPlaying());
        s.use(Command::NextStroke);
        QCOMPARE(s.editor().time(), 2 * second);
        s.use(Command::NextStroke);
        s.use(Command::NextStroke);
        QCOMPARE(s.editor().time(), 10 * second);
        s.use(Command::NextStroke);
        QCOMPARE(s.editor().time(), playback.end());
        s.use(Command::PreviousStroke);
        QCOMPARE(s.editor().time(), 10 * second);
        s.use(Command::ToStart);
        QCOMPARE(s.editor().time(), second);
        s.use(Command::LetDry);
        QCOMPARE(s.editor().time(), playback.end());
        QCOMPARE(s.steps(), 0);
    }

    void itPlaysByTheClock()
    {
        Timed s;
        s.editor().setManualClock(false);
        s.playback().setSpeed(10);
        s.use(Command::Play);
        QTRY_VERIFY_WITH_TIMEOUT(s.editor().time() > 2 * second, waitMs);
        QTRY_VERIFY_WITH_TIMEOUT(!s.playback().isPlaying(), waitMs);
        QCOMPARE(s.editor().time(), s.playback().end());
    }

    /// The picture at a moment is the same bits however it was reached.
    void scrubbedIsPlayedIsRendered()
    {
        Timed s;
        const Microseconds moments[] = {1'234'567, 2'500'000, 3'111'111, 10'050'000, 11'300'000};
        std::vector<QImage> played;
        s.playback().setSkipsPauses(false);
        for (const Microseconds T : moments) {
            while (s.editor().time() < T || s.editor().time() == s.playback().end()) {
                s.playback().play();
                s.playback().advance(std::min<Microseconds>(170'000, T - s.editor().time()));
                s.playback().pause();
                if (s.editor().time() == T)
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
        s.editor().setManualClock(false);
        s.playback().seek(2'200'000); // strokes 1 and 2 are wet
        QVERIFY(s.editor().isInPast());
        QTest::qWait(60);
        QCOMPARE(s.editor().time(), 2'200'000);
        QVERIFY(!s.editor().isRunning());
        s.playback().seek(99 * second);
        QVERIFY(!s.editor().isInPast());
        QCOMPARE(s.editor().time(), 11'300'000);
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
        QVERIFY(s.editor().isInPast());
        QVERIFY(s.editor().isRunning()); // it still spreads
        s.editor().setManualClock(false);
        QTRY_VERIFY_WITH_TIMEOUT(!s.editor().isRunning(), waitMs);
        QCOMPARE(s.editor().time(), stroke.driesAt()); // and no further
        QVERIFY(s.editor().isInPast());
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
        QVERIFY(s.editor().isInPast());
        // One that is given up leaves the clock where the pen left it.
        s.playback().seek(2 * second);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({250, 300}));
        s.advance(interval);
        QTest::mouseMove(&s.canvas(), s.at({300, 300}));
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QCOMPARE(s.editor().time(), 2 * second + interval);
        QTRY_VERIFY_WITH_TIMEOUT(!s.editor().isRunning(), waitMs);
        QCOMPARE(s.steps(), 1);
    }

    void thePenStopsPlaying()
    {
        Timed s;
        s.playback().setSpeed(0.1);
        s.use(Command::Play);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({250, 300}));
        const Microseconds T = s.editor().time();
        s.playback().advance(second);
        QVERIFY(!s.playback().isPlaying());
        QCOMPARE(s.editor().time(), T);
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
            auto *dialog = qobject_cast<QInputDialog *>(QApplication::activeModalWidget());
            if (!dialog)
                return;
            asked = true;
            dialog->setDoubleValue(2);
            dialog->accept();
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

    void theRulerScrubs()
    {
        Timed s;
        s.press(s.onRuler(3 * second));
        QVERIFY(std::abs(s.editor().time() - 3 * second) < 100'000);
        s.moveTo(s.onRuler(1'500'000));
        QVERIFY(std::abs(s.editor().time() - 1'500'000) < 100'000);
        s.moveTo(s.onRuler(-5 * second));
        QCOMPARE(s.editor().time(), second); // not before there is anything
        s.moveTo(s.onRuler(40 * second));
        QCOMPARE(s.editor().time(), s.painting().end());
        s.release(s.onRuler(40 * second));
        QCOMPARE(s.steps(), 0);
    }

    void thePlayheadLeavesNoTrace()
    {
        Timed s;
        const auto shown = [&] {
            QTest::qWait(20); // what is to be painted, is
            const QPixmap screen = s.window.screen()->grabWindow(s.window.winId());
            const QPoint corner = s.view().viewport()->mapTo(&s.window, QPoint());
            return screen.copy(QRect(corner, s.view().viewport()->size())).toImage();
        };
        s.playback().seek(5 * second);
        const QImage first = shown();
        s.playback().seek(8 * second);
        QVERIFY(shown() != first);
        s.playback().seek(5 * second);
        QCOMPARE(shown(), first);
    }

    void keysOfTheTimeline()
    {
        Timed s;
        s.view().setFocus();
        QTest::keyClick(&s.view(), Qt::Key_Home);
        QCOMPARE(s.editor().time(), second);
        QTest::keyClick(&s.view(), Qt::Key_Right);
        QCOMPARE(s.editor().time(), 1'040'000);
        QTest::keyClick(&s.view(), Qt::Key_Right, shift);
        QTest::keyClick(&s.view(), Qt::Key_Left);
        QCOMPARE(s.editor().time(), 2 * second);
        QTest::keyClick(&s.view(), Qt::Key_Space);
        QVERIFY(s.playback().isPlaying());
        QTest::keyClick(&s.view(), Qt::Key_Space);
        QVERIFY(!s.playback().isPlaying());
        QTest::keyClick(&s.view(), Qt::Key_End);
        QCOMPARE(s.editor().time(), s.painting().end());
        QCOMPARE(s.order(), (std::vector<StrokeId>{1, 2, 3, 4})); // nothing was lowered to the bottom
    }

    void barsSelect()
    {
        Timed s;
        s.dragBar(s.middleOf(2), s.middleOf(2));
        QCOMPARE(s.selected(), std::set<StrokeId>{2});
        s.press(s.middleOf(3), shift);
        s.release(s.middleOf(3));
        QCOMPARE(s.selected(), (std::set<StrokeId>{2, 3}));
        s.press(s.middleOf(2), shift);
        s.release(s.middleOf(2));
        QCOMPARE(s.selected(), std::set<StrokeId>{3});
        const QPoint empty(int(s.view().xOf(7 * second)), s.middleOf(1).y());
        s.press(empty);
        s.moveTo({int(s.view().xOf(2'500'000)), s.view().viewport()->height() - 2});
        QCOMPARE(s.selected(), (std::set<StrokeId>{2, 3}));
        s.release({int(s.view().xOf(2'500'000)), s.view().viewport()->height() - 2});
        s.press(empty);
        s.release(empty);
        QVERIFY(s.selected().empty());
        s.view().zoomBy(8);
        QTest::mouseDClick(s.view().viewport(), Qt::LeftButton, {},
                           QPoint(int(s.view().xOf(s.stroke(4).segments[2].born)) + 3, s.middleOf(4).y()));
        QCOMPARE(s.selection().segments, (std::set<SegmentRef>{{4, 2}}));
        QCOMPARE(s.steps(), 0);
    }

    void draggedBarsMoveInTime()
    {
        Timed s;
        const QByteArray first = hashOf(s.painting());
        const auto across = [&](Microseconds by) {
            return QPoint(int(std::lround(s.view().xOf(by) - s.view().xOf(0))), 0);
        };
        s.select({1, 2});
        s.dragBar(s.middleOf(2), s.middleOf(2) + across(second));
        QCOMPARE(s.steps(), 1);
        QCOMPARE(s.editor().undoStack().text(0), QString("Move in time"));
        const Microseconds by = s.stroke(2).born() - 2 * second;
        QVERIFY(std::abs(by - second) < 50'000);
        QCOMPARE(s.stroke(1).born(), second + by);
        QCOMPARE(s.stroke(1).segments[3].born - s.stroke(1).segments[0].born, 300'000);
        s.use(Command::Undo);
        QCOMPARE(hashOf(s.painting()), first);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
        // Back to where it was, Escape, undo during the drag: no step.
        s.press(s.middleOf(2));
        for (const Microseconds to : {200'000, 900'000, -500'000})
            s.moveTo(s.middleOf(2) + across(to));
        s.moveTo(s.middleOf(2));
        s.release(s.middleOf(2));
        QCOMPARE(hashOf(s.painting()), first);
        QVERIFY(!s.editor().undoStack().canUndo());
        const QPoint held = s.middleOf(2);
        for (const bool undo : {false, true}) {
            s.press(held);
            s.moveTo(held + across(second));
            QVERIFY(hashOf(s.painting()) != first);
            if (undo)
                QTest::keyClick(&s.view(), Qt::Key_Z, ctrl);
            else
                QTest::keyClick(&s.view(), Qt::Key_Escape);
            QCOMPARE(hashOf(s.painting()), first);
            s.moveTo(held + across(2 * second));
            s.release(held);
            QCOMPARE(hashOf(s.painting()), first);
            QVERIFY(!s.editor().undoStack().canUndo());
        }
    }

    void draggedEndsStretch()
    {
        Timed s;
        s.view().zoomBy(4);
        s.select({4});
        const QPoint end = s.endOf(4);
        const QPoint to(int(s.view().xOf(10'600'000)), end.y());
        s.dragBar(end, to);
        QCOMPARE(s.steps(), 1);
        const Microseconds drawn = s.stroke(4).segments[3].born - 10 * second;
        QVERIFY(std::abs(drawn - 600'000) < 40'000);
        QCOMPARE(s.stroke(4).born(), 10 * second);
        QVERIFY(std::abs(s.stroke(4).segments[1].born - 10 * second - drawn / 3) <= 1);
        const Microseconds last = s.stroke(4).segments[3].born;
        s.dragBar(s.beginOf(4), QPoint(int(s.view().xOf(10'300'000)), end.y()));
        QCOMPARE(s.stroke(4).segments[3].born, last);
        QVERIFY(std::abs(s.stroke(4).born() - 10'300'000) < 40'000);
        s.use(Command::PaceEaseIn);
        QCOMPARE(s.stroke(4).segments[3].born, last);
        QVERIFY(s.stroke(4).segments[1].born - s.stroke(4).born() > last - s.stroke(4).segments[2].born);
        for (int i = 0; i < 3; ++i)
            s.use(Command::Undo);
        QCOMPARE(s.stroke(4).segments[3].born, 10'300'000);
    }

    void lockedBarsStay()
    {
        StrokeList strokes = fourStrokes();
        auto locked = std::make_shared<Stroke>(*strokes[1]);
        locked->locked = true;
        strokes[1] = locked;
        Timed s(strokes);
        s.dragBar(s.middleOf(2), s.middleOf(2) + QPoint(80, 0));
        QCOMPARE(s.steps(), 0);
        QCOMPARE(s.stroke(2).born(), 2 * second);
    }

    void zoomsAtThePointerAndScrolls()
    {
        Timed s;
        const double x = s.view().xOf(3 * second);
        const QPointF at(x, 60);
        const Microseconds held = s.view().timeAt(x);
        for (int i = 0; i < 12; ++i) {
            QWheelEvent wheel(at, s.view().viewport()->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, ctrl,
                              Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(s.view().viewport(), &wheel);
        }
        QVERIFY(std::abs(s.view().xOf(held) - x) < 2);
        QVERIFY(s.view().xOf(4 * second) - s.view().xOf(3 * second) > 800);
        QVERIFY(s.view().horizontalScrollBar()->maximum() > 5000);
        s.view().horizontalScrollBar()->setValue(0);
        QVERIFY(s.view().xOf(0) >= 0);
        s.view().fit();
        QCOMPARE(s.view().horizontalScrollBar()->maximum(), 0);
        QVERIFY(s.view().xOf(s.painting().end()) < s.view().viewport()->width());
    }

    void speedIsTyped()
    {
        Timed s;
        QLineEdit *field = s.panel->speed()->lineEdit();
        const auto enter = [&](const QString &text) {
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, text);
            QTest::keyClick(field, Qt::Key_Return);
        };
        enter("12.5x");
        QCOMPARE(s.playback().speed(), 12.5);
        enter("nonsense");
        QCOMPARE(s.playback().speed(), 12.5);
        enter("0.001");
        QCOMPARE(s.playback().speed(), Playback::slowest);
    }

    void barsShareLanes()
    {
        TimelineBars bars;
        auto painting = std::make_shared<Painting>();
        painting->strokes = fourStrokes(); // each of the first three begins while the one before is wet
        bars.setPainting(painting);
        QCOMPARE(bars.laneCount(), 2);
        QCOMPARE(bars[2].lane, 0);
        QCOMPARE(bars[3].lane, 0);
        QCOMPARE(bars.span(), (TimeSpan{second, 11'300'000}));
        const auto moved = std::make_shared<Painting>(*painting);
        moved->strokes[3] = drawnAt(4, 1'100'000, {0, 0}, {10, 0});
        bars.setPainting(moved);
        QCOMPARE(bars.span().end, 4'300'000);
        for (std::size_t i = 0; i < bars.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(bars[i].lane != bars[j].lane || bars[i].begin > bars[j].end || bars[j].begin > bars[i].end);
        std::vector<std::size_t> seen;
        bars.forEachIn(0, {0, 20 * second}, 0, [&](std::size_t i) { seen.push_back(i); });
        QCOMPARE(seen, (std::vector<std::size_t>{0, 2}));
        seen.clear();
        bars.forEachIn(0, {0, 20 * second}, 5 * second, [&](std::size_t i) { seen.push_back(i); });
        QCOMPARE(seen, (std::vector<std::size_t>{0}));
    }

    void tenThousandStrokes()
    {
        Painting painting;
        for (int i = 0; i < 10'000; ++i)
            painting.strokes.push_back(drawnAt(StrokeId(i + 1), Microseconds(i) * 300'000,
                                               {5.0 * (i % 100), 5.0 * (i / 100)},
                                               {5.0 * (i % 100) + 4, 5.0 * (i / 100)}));
        const auto shared = std::make_shared<const Painting>(painting);
        Editor editor;
        Playback playback(editor);
        editor.document().reset(shared);
        TimelineView view(editor, playback);
        view.resize(1200, 200);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        const auto best = [](auto work) {
            qint64 least = std::numeric_limits<qint64>::max();
            for (int k = 0; k < 5; ++k) {
                QElapsedTimer clock;
                clock.start();
                work();
                least = std::min(least, clock.nsecsElapsed());
            }
            return double(least) * 1e-6;
        };
        TimelineBars bars;
        int turn = 0;
        qInfo("10,000 strokes: all shown %.2f ms, zoomed in %.2f ms, bars anew %.2f ms, one changed %.2f ms",
              best([&] { view.viewport()->grab(); }), (view.zoomBy(300), best([&] { view.viewport()->grab(); })),
              best([&] { TimelineBars().setPainting(shared); }),
              (bars.setPainting(shared), best([&] {
                   auto next = std::make_shared<Painting>(bars.painting());
                   next->strokes[5000] = drawnAt(5001, 1'500'000'000 + ++turn, {0, 0}, {4, 0});
                   bars.setPainting(next);
               })));
        QCOMPARE(bars.size(), std::size_t(10'000));
        QCOMPARE(bars[5000].begin, 1'500'000'000 + turn);
        QVERIFY(bars.laneCount() < 8);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestTimeline)
#include "test_timeline.moc"
