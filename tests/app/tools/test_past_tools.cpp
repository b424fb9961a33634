// Eraser and knife at a moment of the past: what is not painted yet is left alone.
#include "app/tools/shaping/eraser_tool.h"
#include "tests/app/timed.h"

using namespace suffuse;

namespace {

/// Two strokes from left to right, the upper one painted first; the lower one begins at 3 seconds.
StrokeList twoRows()
{
    return {drawnAt(1, second, {200, 200}, {600, 200}), drawnAt(2, 3 * second, {200, 300}, {600, 300}, {0, 0, 1, 1})};
}

struct Past : Timed {
    explicit Past(Microseconds time, StrokeList strokes = twoRows()) : Timed(std::move(strokes))
    {
        playback().seek(time);
        Q_ASSERT(editor().clock().isInPast());
    }
};

} // namespace

class TestPastTools : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void theEraserTakesWhatIsThere()
    {
        Past s(2 * second);
        s.use(Command::Eraser);
        static_cast<EraserTool *>(s.canvas().tool())->setRadius(12);
        const Stroke later = s.stroke(2);
        s.drag({{400, 150}, {400, 350}}, shift); // cuts
        QCOMPARE(chainsOf(s.stroke(1)).size(), std::size_t(2));
        QVERIFY(s.stroke(2) == later);
        QCOMPARE(s.order(), (std::vector<StrokeId>{1, 2}));
        s.use(Command::ToEnd);
        s.drag({{450, 150}, {450, 350}}, shift);
        QVERIFY(!(s.stroke(2) == later));
        s.use(Command::Undo);
        s.use(Command::Undo);
        QCOMPARE(s.order(), (std::vector<StrokeId>{1, 2}));
    }

    void theKnifeCutsWhatIsThere()
    {
        Past s(2 * second);
        s.use(Command::Knife);
        const std::size_t segments = s.stroke(2).segments.size();
        s.drag({{430, 150}, {430, 350}});
        QCOMPARE(s.stroke(1).segments.size(), segments + 1);
        QCOMPARE(s.stroke(2).segments.size(), segments);
        s.drag({{470, 150}, {470, 350}}, shift);
        QCOMPARE(chainsOf(s.stroke(1)).size(), std::size_t(2));
        QCOMPARE(chainsOf(s.stroke(2)).size(), std::size_t(1));
        QCOMPARE(s.order().back(), StrokeId(2));
        s.use(Command::ToEnd);
        s.drag({{430, 250}, {430, 350}});
        QCOMPARE(s.stroke(2).segments.size(), segments + 1);
    }

    /// In the middle of a stroke that is being painted then: only its first part is there.
    void halfAStroke()
    {
        Past s(1'150'000); // two of four segments: 200 to 400
        s.use(Command::Eraser);
        static_cast<EraserTool *>(s.canvas().tool())->setRadius(12);
        const Stroke whole = s.stroke(1);
        s.drag({{500, 150}, {500, 250}}, shift);
        s.drag({{500, 150}, {500, 250}}); // nothing can be lifted there, either
        QVERIFY(s.stroke(1) == whole);
        QCOMPARE(s.steps(), 0);
        s.drag({{300, 150}, {300, 250}}, shift);
        QCOMPARE(chainsOf(s.stroke(1)).size(), std::size_t(2));
        const std::vector<Segment> &left = s.stroke(1).segments;
        QVERIFY(std::ranges::find(left, whole.segments[2].born, &Segment::born) != left.end());
        QVERIFY(std::ranges::find(left, whole.segments[3].born, &Segment::born) != left.end());
    }

    /// Lifting in the past: what is lifted is lifted from then on, and what comes later is spared.
    void theEraserLiftsInThePast()
    {
        Past s(2 * second);
        s.use(Command::Eraser);
        static_cast<EraserTool *>(s.canvas().tool())->setRadius(12);
        const Stroke later = s.stroke(2);
        s.drag({{400, 150}, {400, 350}});
        QVERIFY(s.stroke(1).hasErasure());
        QVERIFY(s.stroke(2) == later);
        for (const Segment &segment : s.stroke(1).segments)
            if (segment.lift)
                QVERIFY(segment.born >= 2 * second && segment.born < 3 * second);
        QVERIFY(s.editor().clock().isInPast());
        s.use(Command::Undo);
        QVERIFY(!s.stroke(1).hasErasure());
    }

    /// What is selected and not painted yet has neither outline nor handles, and cannot be dragged on the canvas.
    void whatIsNotBegunHasNoOutline()
    {
        Past s(2 * second);
        const auto shown = [&] {
            while (!s.canvas().isUpToDate())
                QTest::qWait(5);
            return s.canvas().grab().toImage();
        };
        s.use(Command::Select);
        s.select({});
        const QImage bare = shown();
        s.select({2});
        QCOMPARE(shown(), bare);
        QCOMPARE(s.selected(), std::set<StrokeId>{2});
        QVERIFY(s.canvas().selection().isEmpty());
        const Stroke later = s.stroke(2);
        QTest::keyClick(&s.canvas(), Qt::Key_Right);
        s.drag({{200, 300}, {260, 340}}); // at its end, where a handle would be
        QVERIFY(s.stroke(2) == later);
        s.select({1, 2});
        QCOMPARE(s.canvas().selection().strokes, std::set<StrokeId>{1});
        const QImage both = shown();
        s.select({1});
        QCOMPARE(shown(), both);
        s.select({1, 2});
        const Stroke first = s.stroke(1);
        s.drag({{400, 200}, {430, 230}});
        QVERIFY(!(s.stroke(1) == first));
        QVERIFY(s.stroke(2) == later);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2})); // still selected
        s.use(Command::Segments);
        s.select({2});
        const QImage nodes = shown();
        s.select({});
        QCOMPARE(shown(), nodes);
        s.select({2});
        s.use(Command::ToEnd);
        QCOMPARE(s.canvas().selection().strokes, std::set<StrokeId>{2});
        QVERIFY(shown() != nodes);
    }

    /// Handles and outline come and go while time is scrubbed.
    void outlinesComeAndGoWithTime()
    {
        for (const Command tool : {Command::Select, Command::Segments}) {
            Past s(2 * second);
            s.use(tool);
            s.select({1, 2});
            const auto seen = [&] {
                QTest::qWait(30);
                const QPixmap screen = s.window.screen()->grabWindow(s.window.winId());
                return screen.copy(QRect(s.canvas().mapTo(&s.window, QPoint()), s.canvas().size())).toImage();
            };
            const auto settle = [&] { QTRY_VERIFY_WITH_TIMEOUT(s.canvas().isUpToDate(), waitMs); };
            settle();
            const QImage early = seen();
            s.playback().seek(3 * second + second / 2);
            settle();
            QCOMPARE(s.canvas().selection().strokes, (std::set<StrokeId>{1, 2}));
            QVERIFY(seen() != early);
            s.playback().seek(2 * second);
            settle();
            QCOMPARE(s.canvas().selection().strokes, std::set<StrokeId>{1});
            QCOMPARE(seen(), early);
            s.canvas().update();
            QCOMPARE(seen(), early); // all painted anew
        }
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestPastTools)
#include "test_past_tools.moc"
