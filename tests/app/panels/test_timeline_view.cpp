// The timeline's ruler and bars.
#include "app/panels/timeline/timeline_picture.h"
#include "tests/app/timed.h"
#include "undo/time_edits.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QToolTip>

using namespace suffuse;

class TestTimelineView : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
        qputenv("SUFFUSE_BACKEND", "cpu");
    }

    void theRulerScrubs()
    {
        Timed s;
        s.press(s.onRuler(3 * second));
        QVERIFY(std::abs(s.editor().clock().time() - 3 * second) < 100'000);
        s.moveTo(s.onRuler(1'500'000));
        QVERIFY(std::abs(s.editor().clock().time() - 1'500'000) < 100'000);
        s.moveTo(s.onRuler(-5 * second));
        QCOMPARE(s.editor().clock().time(), second); // not before there is anything
        s.moveTo(s.onRuler(40 * second));
        QCOMPARE(s.editor().clock().time(), s.painting().end());
        s.release(s.onRuler(40 * second));
        QCOMPARE(s.steps(), 0);
    }

    void aScrubIsGivenUp_data()
    {
        QTest::addColumn<int>("key");
        QTest::newRow("Esc") << int(Qt::Key_Escape);
        QTest::newRow("Delete") << int(Qt::Key_Delete);
    }

    /// The key may come without having been offered as a shortcut: a window that lets docks keep the keys that are
    /// typed in them asks nobody else.
    void aScrubIsGivenUp()
    {
        QFETCH(int, key);
        Timed s;
        for (const Microseconds before : {s.painting().end(), 2 * second}) {
            s.playback().seek(before);
            const bool inPast = s.editor().clock().isInPast();
            s.press(s.onRuler(3 * second));
            s.moveTo(s.onRuler(1'500'000));
            QKeyEvent event(QEvent::KeyPress, key, {});
            QCoreApplication::sendEvent(&s.view(), &event);
            QCOMPARE(s.editor().clock().time(), before);
            QCOMPARE(s.editor().clock().isInPast(), inPast);
            s.release(s.onRuler(1'500'000));
            QCOMPARE(s.editor().clock().time(), before);
        }
    }

    void labelsMakeWayForThePlayhead()
    {
        QCOMPARE(TimelinePicture::labelLeft(100, 30, 500, 1000), 104.0);
        for (const double tick : {-200.0, -20.0, 1003.0, 1200.0}) // what is out of the view stays there
            QCOMPARE(TimelinePicture::labelLeft(tick, 30, 500, 1000), tick + 4);
        for (const double width : {20.0, 34.0})
            for (double tick = 0; tick <= 1000; tick += 4)
                for (double head = 0; head <= 1000; head += 3) {
                    const double left = TimelinePicture::labelLeft(tick, width, head, 1000);
                    QVERIFY(left >= 0 && left + width <= 1000);
                    QVERIFY(left >= head + 5 || left + width <= head - 5);
                    QVERIFY(std::abs(left - tick) <= 2 * width + 16);
                }
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
        QCOMPARE(s.editor().clock().time(), second);
        QTest::keyClick(&s.view(), Qt::Key_Right);
        QCOMPARE(s.editor().clock().time(), 1'040'000);
        QTest::keyClick(&s.view(), Qt::Key_Right, shift);
        QTest::keyClick(&s.view(), Qt::Key_Left);
        QCOMPARE(s.editor().clock().time(), 2 * second);
        QTest::keyClick(&s.view(), Qt::Key_Space);
        QVERIFY(s.playback().isPlaying());
        QTest::keyClick(&s.view(), Qt::Key_Space);
        QVERIFY(!s.playback().isPlaying());
        QTest::keyClick(&s.view(), Qt::Key_End);
        QCOMPARE(s.editor().clock().time(), s.painting().end());
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

    /// Over whatever lies there; where it will lie is decided when it is let go.
    void draggedBarsKeepTheirLanes()
    {
        Timed s; // lanes 0, 1, 0, 0; each is wet for a second
        const auto shown = [&] {
            QTest::qWait(120); // bars follow edits now and then
            return s.view().viewport()->grab().toImage();
        };
        const auto across = [&](Microseconds by) {
            return QPoint(int(std::lround(s.view().xOf(by) - s.view().xOf(0))), 0);
        };
        const int upper = s.middleOf(1).y(), lower = s.middleOf(2).y();
        const auto differ = [&](const QImage &a, const QImage &b, Microseconds time, int y) {
            const QPoint at(int(s.view().xOf(time)), y);
            return a.pixel(at) != b.pixel(at);
        };
        s.select({2});
        const QPoint second2 = s.middleOf(2);
        QImage before = shown();
        s.press(second2);
        s.moveTo(second2 + across(2 * second));
        s.moveTo(second2 + across(4 * second)); // from 6 to 7.3 s, where both lanes are empty
        QImage during = shown();
        QVERIFY(differ(before, during, 6'800'000, lower));
        QVERIFY(!differ(before, during, 6'800'000, upper));
        QTest::keyClick(&s.view(), Qt::Key_Escape);
        s.release(second2);

        s.select({3});
        const QPoint third = s.middleOf(3);
        before = shown();
        s.press(third);
        s.moveTo(third - across(second));
        s.moveTo(third - across(1'500'000)); // from 1.5 to 2.8 s, where the first one is in its lane
        during = shown();
        QVERIFY(differ(before, during, 2'600'000, upper));
        QVERIFY(!differ(before, during, 1'750'000, lower));
        s.release(third - across(1'500'000));
    }

    /// Where there is no room in its lane a bar gets another one, and stays in view.
    void aDraggedBarIsSeenAfterwards()
    {
        StrokeList strokes{drawnAt(1, second, {200, 200}, {600, 400})};
        for (int i = 0; i < 12; ++i)
            strokes.push_back(drawnAt(StrokeId(2 + i), 10 * second, {200, 200.0 + 10 * i}, {600, 200.0 + 10 * i}));
        Timed s(strokes);
        const auto isSeen = [&s] {
            const QRect lanes = s.view().viewport()->rect().adjusted(0, 20, 0, 0);
            return lanes.contains(s.middleOf(1));
        };
        QVERIFY(isSeen());
        const double perSecond = (s.middleOf(2).x() - s.middleOf(1).x()) / 9.0;
        s.press(s.middleOf(1));
        s.moveTo(s.middleOf(1) + QPoint(int(9 * perSecond), 0));
        s.release(s.middleOf(1) + QPoint(int(9 * perSecond), 0));
        QCOMPARE(s.steps(), 1);
        QVERIFY(s.painting().find(1)->born() > 9 * second);
        QVERIFY(isSeen());
    }

    /// Where the drag of a bar that is seen in part is given up, the view stays where it was.
    void aDragThatIsGivenUpScrollsNothing()
    {
        StrokeList strokes;
        for (int i = 0; i < 14; ++i)
            strokes.push_back(drawnAt(StrokeId(1 + i), second, {200, 200.0 + 10 * i}, {600, 200.0 + 10 * i}));
        Timed s(strokes);
        QScrollBar &bar = *s.view().verticalScrollBar();
        QVERIFY(bar.maximum() > 40);
        bar.setValue(20);
        const int height = s.view().viewport()->height();
        const auto isCut = [&](const StrokePtr &stroke) {
            const QRectF rect = s.view().drawnRect(stroke->id);
            return rect.top() + 3 < height && rect.bottom() > height;
        };
        StrokeId id = 0; // of the bar across the lower edge
        for (int value = 20; value < 40 && id == 0; ++value) {
            bar.setValue(value);
            for (const StrokePtr &stroke : s.painting().strokes)
                id = isCut(stroke) ? stroke->id : id;
        }
        QVERIFY(id != 0);
        const int before = bar.value();
        const QPoint at(s.middleOf(id).x(), int(s.view().drawnRect(id).top()) + 2);
        s.press(at);
        s.moveTo(at + QPoint(20, 0));
        s.moveTo(at + QPoint(40, 0));
        QTest::keyClick(&s.view(), Qt::Key_Escape);
        s.release(at + QPoint(40, 0));
        QCOMPARE(s.steps(), 0);
        QCOMPARE(bar.value(), before);
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

    void endsThatAreDraggedWithAltEase()
    {
        Timed s;
        s.view().zoomBy(6);
        s.select({4});
        const QByteArray first = hashOf(s.painting());
        const QPoint begin = s.beginOf(4), end = s.endOf(4);
        const auto drag = [&](QPoint from, QPoint to, bool lets = true) {
            s.press(from, alt);
            s.moveTo(from + (to - from) / 2);
            s.moveTo(to);
            if (lets)
                s.release(to);
        };
        drag(begin, begin + QPoint((end.x() - begin.x()) / 2, 0));
        QCOMPARE(s.steps(), 1);
        QCOMPARE(s.editor().undoStack().text(0), QString("Ease in time"));
        const auto since = [&](std::size_t k) { return s.stroke(4).segments[k].born - 10 * second; };
        QCOMPARE(since(0), 0);
        QCOMPARE(since(3), 300'000);
        QVERIFY(since(1) > 130'000 && since(1) < since(2)); // it begins slowly
        s.use(Command::Undo);
        QCOMPARE(hashOf(s.painting()), first);
        drag(end, end - QPoint((end.x() - begin.x()) / 2, 0));
        QVERIFY(since(2) < 170'000 && since(3) == 300'000); // it ends slowly
        s.use(Command::Undo);
        drag(begin, begin + QPoint(60, 0), false); // Escape, and back to where it was: no step
        QVERIFY(hashOf(s.painting()) != first);
        QTest::keyClick(&s.view(), Qt::Key_Escape);
        s.release(begin);
        QCOMPARE(hashOf(s.painting()), first);
        drag(begin, begin + QPoint(60, 0), false);
        s.moveTo(begin);
        s.release(begin);
        QCOMPARE(hashOf(s.painting()), first);
        QVERIFY(!s.editor().undoStack().canUndo());
    }

    void barsHaveAMenu()
    {
        Timed s;
        const auto menuAt = [&](QPoint at) {
            QContextMenuEvent event(QContextMenuEvent::Mouse, at, s.view().viewport()->mapToGlobal(at));
            QCoreApplication::sendEvent(s.view().viewport(), &event);
            return qobject_cast<QMenu *>(QApplication::activePopupWidget());
        };
        const auto entry = [](QMenu *menu, const QString &text) {
            for (QAction *action : menu->actions())
                if (action->text().remove('&') == text)
                    return action;
            return static_cast<QAction *>(nullptr);
        };
        QMenu *menu = menuAt(s.middleOf(3));
        QVERIFY(menu);
        QCOMPARE(s.selected(), std::set<StrokeId>{3});
        QVERIFY(entry(menu, "Drawing Pace"));
        QTRY_VERIFY_WITH_TIMEOUT(entry(menu, "Re-wet…")->isEnabled(), waitMs);
        entry(menu, "Go to Its Start")->trigger();
        QCOMPARE(s.editor().clock().time(), 3 * second);
        entry(menu, "Go to When It Is Dry")->trigger();
        QCOMPARE(s.editor().clock().time(), s.stroke(3).driesAt());
        menu->close();
        menu = menuAt({int(s.view().xOf(8 * second)), s.view().viewport()->height() - 3}); // beside all bars
        QVERIFY(menu);
        QVERIFY(entry(menu, "Loop") && !entry(menu, "Re-wet…"));
        QCOMPARE(s.selected(), std::set<StrokeId>{3});
        menu->close();
    }

    void barsSayWhatTheyAre()
    {
        Timed s;
        const auto tipAt = [&](QPoint at) {
            QHelpEvent event(QEvent::ToolTip, at, s.view().viewport()->mapToGlobal(at));
            QCoreApplication::sendEvent(s.view().viewport(), &event);
            return QToolTip::text();
        };
        QString tip = tipAt(s.middleOf(4));
        QCOMPARE(tip, QString("Stroke 4\nDrawn from 0:10.000 to 0:10.300\nDry at 0:11.300"));
        s.select({4});
        s.editor().push(rewet(s.editor().document(), 11 * second, second), "wet");
        tip = tipAt(s.middleOf(4));
        QVERIFY2(tip.endsWith("Wetted again, dry at 0:12.000"), qPrintable(tip));
    }

    void theStrokeInHandHasABar()
    {
        Timed s;
        const auto shown = [&] {
            QTest::qWait(120); // bars follow edits now and then
            return s.view().viewport()->grab().toImage();
        };
        s.editor().clock().setTime(14 * second);
        s.view().fit();
        const QImage before = shown();
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({250, 300}));
        for (int i = 1; i <= 20; ++i) {
            s.advance(100'000);
            QTest::mouseMove(&s.canvas(), s.at({250 + 15.0 * i, 300}));
        }
        const StrokeId drawn = s.editor().document().draft()->id;
        const QImage during = shown();
        const int x = int(s.view().xOf(15 * second)); // with the pen up, the time until it is dry is shown, too
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({550, 300}));
        const QRectF bar = s.view().drawnRect(drawn);
        QVERIFY(bar.width() > 20);
        const int y = int(bar.center().y()); // in the lane in which it stays
        QVERIFY(during.pixelColor(x, y) != before.pixelColor(x, y));
        QCOMPARE(during.pixelColor(x, y), shown().pixelColor(bar.center().toPoint()));
    }

    void thereIsRoomForTheNextMoments()
    {
        Timed s;
        s.editor().clock().setTime(s.painting().end());
        s.view().fit();
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({250, 300}));
        int moves = 0;
        for (int i = 1; i <= 20; ++i) {
            const double before = s.view().xOf(second);
            s.advance(20'000);
            QTest::mouseMove(&s.canvas(), s.at({250 + 15.0 * i, 300}));
            moves += s.view().xOf(second) != before;
            QVERIFY(s.view().xOf(s.editor().clock().time()) < s.view().viewport()->width());
        }
        QCOMPARE(moves, 1); // not every moment moves what stands
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({550, 300}));
        s.editor().clock().setTime(s.painting().end());
        s.view().fit();
        const double right = s.view().viewport()->width() - s.view().xOf(s.painting().end());
        QVERIFY(right > 0 && right < 20); // and none is left when all is to be shown
    }

    /// Its bar waits for a pause; what is selected does not.
    void aSelectedStrokeMayHaveOutgrownItsBar()
    {
        Timed s;
        const auto shown = [&] { return s.view().viewport()->grab().toImage(); };
        s.select({4});
        auto grown = std::make_shared<Stroke>(s.stroke(4));
        std::set<SegmentRef> added;
        for (int k = 0; k < 8; ++k) {
            added.insert({4, int(grown->segments.size())});
            grown->segments.push_back(grown->segments.back());
            grown->segments.back().born += second / 10;
        }
        Edit edit;
        edit.strokes = {{4, grown}};
        s.editor().push(std::move(edit), "Grow");
        const QImage before = shown();
        s.editor().document().setSelection({{4}, added});
        QCOMPARE(shown(), before);
        QTRY_VERIFY(shown() != before);
    }

    /// What erases a stroke has no bar. It is marked while the stroke is selected, and words say whether it goes along.
    void movingABarTellsOfItsErasures()
    {
        StrokeList strokes = fourStrokes();
        auto erased = std::make_shared<Stroke>(*strokes[2]);
        Segment lift = erased->segments.front();
        lift.lift = lift.start = true;
        lift.colour = {};
        lift.born = 7 * second;
        erased->segments.push_back(lift);
        const int erasure = int(erased->segments.size()) - 1;
        strokes[2] = erased;
        Timed s(strokes);
        QCOMPARE(erasuresOf(*erased), (std::vector<TimeSpan>{{7 * second, 7 * second}}));
        const auto mark = [&](Microseconds at) {
            const QImage shown = s.view().viewport()->grab().toImage();
            const QRectF bar = s.view().drawnRect(3);
            return shown.pixelColor(int(std::lround(s.view().xOf(at))), int(bar.center().y()) + 4);
        };
        const QColor ground = mark(7 * second);
        s.select({3});
        const QColor marked = mark(7 * second);
        QVERIFY(marked != ground);
        const auto said = [&](const QString &part) {
            return std::ranges::any_of(s.panel->findChildren<QLabel *>(),
                                       [&](const QLabel *label) { return label->text().contains(part); });
        };
        s.press(s.middleOf(3));
        const QPoint later(int(std::lround(s.view().xOf(5 * second) - s.view().xOf(3 * second))), 0);
        const QPoint from = s.middleOf(3);
        s.moveTo(from + later / 2);
        s.moveTo(from + later);
        QVERIFY(said("with its erasures"));
        QVERIFY(mark(s.stroke(3).segments[std::size_t(erasure)].born) != ground);
        QCOMPARE(mark(7 * second), ground);
        s.release(from + later);
        QVERIFY(!said("with its erasures"));
        s.use(Command::Undo);
        // A run of its paint moves alone, and so does what is drawn in another time.
        s.editor().document().setSelection({{3}, {{3, 0}}});
        s.press(s.middleOf(3));
        s.moveTo(s.middleOf(3) + QPoint(12, 0));
        s.moveTo(s.middleOf(3) + QPoint(15, 0));
        QVERIFY(said("erasures keep their time"));
        QCOMPARE(s.stroke(3).segments[std::size_t(erasure)].born, 7 * second);
        s.release(s.middleOf(3));
        // Where nothing is erased there is nothing to say.
        s.select({4});
        s.press(s.middleOf(4));
        s.moveTo(s.middleOf(4) + QPoint(12, 0));
        s.moveTo(s.middleOf(4) + QPoint(15, 0));
        QVERIFY(said("Later by") && !said("erasures"));
        s.release(s.middleOf(4));
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
        QVERIFY(s.panel->what()->text().startsWith("“nonsense”"));
        enter("50%"); // no number of times
        QCOMPARE(s.playback().speed(), 12.5);
        QVERIFY(!s.panel->what()->text().isEmpty());
        enter("0,5");
        QCOMPARE(s.playback().speed(), 0.5);
        QCOMPARE(s.panel->what()->text(), QString());
        for (const char *beyond : {"0.001", "0", "2000"}) {
            enter(beyond);
            QCOMPARE(s.playback().speed(), 0.5);
            QVERIFY(s.panel->what()->text().contains("out of range"));
        }
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

    /// What takes paint away has neither a colour nor a drying time that anybody sees.
    void barsAreOfPaint()
    {
        const Stroke painted = *drawnAt(1, second, {0, 0}, {10, 0});
        const TimelineBar before = barOf(painted);
        Stroke erased = painted;
        for (int k = 0; k < 3 * int(painted.segments.size()); ++k) {
            Segment lift = painted.segments.front();
            lift.lift = lift.start = true;
            lift.colour = {};
            lift.born = 20 * second;
            erased.segments.push_back(lift);
        }
        TimelineBar after = barOf(erased);
        QCOMPARE(after.done, erased.driesAt());
        after.done = before.done;
        QVERIFY(after == before);
        // Where a fill is all that paints the bar is the fill's.
        Stroke filled = painted;
        for (Segment &segment : filled.segments)
            segment.density = 0;
        Fill fill;
        fill.born = 4 * second;
        fill.maxAge = 0.5f;
        fill.colour = {0.1f, 0.2f, 0.3f, 1};
        filled.fill = fill;
        const TimelineBar ofFill = barOf(filled);
        QCOMPARE(ofFill.colour, fill.colour);
        QCOMPARE(ofFill.drawn, std::max(before.drawn, 4 * second));
        QCOMPARE(ofFill.dry, fill.driesAt());

        TimelineBars bars;
        auto painting = std::make_shared<Painting>();
        painting->strokes = {std::make_shared<const Stroke>(painted)};
        bars.setPainting(painting);
        auto now = std::make_shared<Painting>();
        now->strokes = {std::make_shared<const Stroke>(erased)};
        QVERIFY(bars.setPainting(now));
        QCOMPARE(bars.span(), (TimeSpan{second, erased.driesAt()})); // There is something to see until then.
    }

    void aMovedBarStaysInItsLane()
    {
        TimelineBars bars;
        auto painting = std::make_shared<Painting>();
        painting->strokes = fourStrokes(); // lanes 0, 1, 0, 0
        bars.setPainting(painting);
        const auto lanes = [&](std::size_t which, Microseconds born) {
            const auto moved = std::make_shared<Painting>(bars.painting());
            moved->strokes[which] = drawnAt(StrokeId(which + 1), born, {0, 0}, {10, 0});
            bars.setPainting(moved);
            std::vector<int> result;
            for (std::size_t i = 0; i < bars.size(); ++i)
                result.push_back(bars[i].lane);
            return result;
        };
        using Lanes = std::vector<int>;
        QCOMPARE(lanes(1, 6 * second), (Lanes{0, 1, 0, 0})); // the upper one is free there
        QCOMPARE(bars.laneCount(), 2);
        QCOMPARE(lanes(1, 20 * second), (Lanes{0, 1, 0, 0})); // behind all others
        QCOMPARE(bars.span().end, bars[1].end);
        QCOMPARE(lanes(3, 1'100'000), (Lanes{0, 1, 0, 1})); // no room: the others stay
        QCOMPARE(lanes(0, 30 * second), (Lanes{0, 1, 0, 1}));
        QCOMPARE(lanes(2, 30 * second), (Lanes{0, 1, 1, 1}));
        QCOMPARE(lanes(1, 30 * second), (Lanes{0, 2, 1, 1}));
        QCOMPARE(bars.laneCount(), 3);
        std::vector<std::size_t> seen;
        for (int lane = 0; lane < bars.laneCount(); ++lane)
            bars.forEachIn(lane, {0, 60 * second}, 0, [&](std::size_t i) { seen.push_back(i); });
        QCOMPARE(seen, (std::vector<std::size_t>{0, 3, 2, 1}));
    }

    /// Undo brings a bar back to where it was seen.
    void aBarThatComesBackTakesItsLane()
    {
        TimelineBars bars;
        auto painting = std::make_shared<Painting>();
        painting->strokes = fourStrokes(); // lanes 0, 1, 0, 0
        bars.setPainting(painting);
        const auto lanesOf = [&] {
            std::vector<int> result;
            for (std::size_t i = 0; i < bars.size(); ++i)
                result.push_back(bars[i].lane);
            return result;
        };
        const std::vector<int> first = lanesOf();
        const auto moved = std::make_shared<Painting>(*painting);
        moved->strokes[3] = drawnAt(4, 1'100'000, {0, 0}, {10, 0});
        bars.setPainting(moved);
        QVERIFY(lanesOf() != first); // there is no room for it
        bars.setPainting(painting);
        QCOMPARE(lanesOf(), first);
        // It does not come back into a lane that is taken meanwhile.
        bars.setPainting(moved);
        const auto taken = std::make_shared<Painting>(*moved);
        taken->strokes[2] = drawnAt(3, painting->strokes[3]->born(), {0, 0}, {10, 0});
        bars.setPainting(taken);
        const auto back = std::make_shared<Painting>(*taken);
        back->strokes[3] = painting->strokes[3];
        bars.setPainting(back);
        QVERIFY(bars[3].lane != bars[2].lane);
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

QTEST_MAIN(TestTimelineView)
#include "test_timeline_view.moc"
