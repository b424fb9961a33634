// The timeline's ruler and bars.
#include "app/panels/timeline/timeline_bars.h"
#include "app/panels/timeline/timeline_picture.h"
#include "tests/app/timed.h"
#include "undo/time_edits.h"

#include <QComboBox>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QToolButton>
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

    /// All of the row is reached by Tab, and a click on a button leaves the keyboard where it is.
    void tabReachesTheButtons()
    {
        Timed s;
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        QList<QToolButton *> buttons = s.panel->findChildren<QToolButton *>();
        buttons.removeIf([](const QToolButton *button) { return !button->isVisible() || !button->isEnabled(); });
        QVERIFY(buttons.size() > 5);
        buttons.front()->setFocus(Qt::TabFocusReason);
        std::set<const QWidget *> reached;
        for (QWidget *at = QApplication::focusWidget(); at && s.panel->isAncestorOf(at) && reached.insert(at).second;
             at = QApplication::focusWidget())
            QTest::keyClick(at, Qt::Key_Tab);
        for (const QToolButton *button : buttons) {
            QVERIFY2(reached.contains(button), qPrintable(button->toolTip()));
            QVERIFY(!(button->focusPolicy() & Qt::ClickFocus));
        }
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
