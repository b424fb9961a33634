// The timeline's bars: a hand drags them and their ends, and they keep to their lanes.
#include "app/panels/timeline/timeline_bars.h"
#include "tests/app/timed.h"

using namespace suffuse;

class TestDraggedBars : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
        qputenv("SUFFUSE_BACKEND", "cpu");
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

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestDraggedBars)
#include "test_dragged_bars.moc"
