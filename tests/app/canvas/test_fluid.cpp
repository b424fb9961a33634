// What comes first on the screen, and what stands in for a picture that takes too long.
#include "app/canvas/overlay/selection_outline.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/inspector/segment_section.h"
#include "app/session/frames/coarse_frames.h"
#include "app/session/settings/settings.h"
#include "render/backends.h"
#include "render/bench/generator.h"
#include "tests/app/selecting.h"
#include "tests/app/slow_renderer.h"
#include "tests/app/worker_frames.h"

#include <QLabel>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>

using namespace suffuse;

namespace {

/// As slow as a large painting, where it has something to draw.
Result<std::unique_ptr<Renderer>> makeSlowRenderer(const RendererOptions &options)
{
    return makeSlow(options, [](const RenderRequest &request, RenderStats &stats) {
        if (request.view.width > width / 2 && !stats.dirty.empty()) { // not the coarse one
            QThread::msleep(40);
            stats.totalMs += 40;
        }
    });
}

/// Its pictures take until they are cancelled or all are let go.
class HeldRenderer : public SlowRenderer {
public:
    /// Relaxed: ThreadSanitizer must not take them for an order that the worker itself puts between its threads.
    struct Hold {
        std::atomic<int> begun = 0;
        std::atomic<bool> free = false;
    };

    HeldRenderer(std::unique_ptr<Renderer> renderer, Hold &hold)
        : SlowRenderer(std::move(renderer), [](const RenderRequest &, RenderStats &) {}), m_hold(hold)
    {}
    Result<RenderStats> render(const RenderRequest &request, Target &target, const std::atomic<bool> *cancel) override
    {
        Result<RenderStats> stats = SlowRenderer::render(request, target, nullptr);
        m_hold.begun.fetch_add(1, std::memory_order_relaxed);
        while (!*cancel && !m_hold.free.load(std::memory_order_relaxed))
            QThread::msleep(1);
        if (stats)
            stats->cancelled = *cancel;
        return stats;
    }

private:
    Hold &m_hold;
};

/// Three strokes, the first two moved by so many units.
RenderRequest movedBy(double units, bool interactive)
{
    RenderRequest r = request(9);
    auto painting = std::make_shared<Painting>(*r.painting);
    for (const double y : {40.0, 160.0}) {
        Stroke stroke = *std::as_const(painting->strokes)[0];
        stroke.id = painting->nextStrokeId();
        stroke.origin = {40 + units, y};
        painting->strokes.push_back(std::make_shared<const Stroke>(stroke));
    }
    r.painting = painting;
    r.interactive = interactive;
    return r;
}

Pixels<std::uint32_t> shownBy(FrameThread &worker)
{
    Pixels<std::uint32_t> argb;
    worker.withFrame([&](ShownFrame &frame) { argb = frame.picture.argb; });
    return argb;
}

/// Notes when the canvas is painted.
class PaintWatch : public QObject {
public:
    PaintWatch(QWidget &widget, QStringList &log) : m_log(log) { widget.installEventFilter(this); }

protected:
    bool eventFilter(QObject *, QEvent *event) override
    {
        if (event->type() == QEvent::Paint)
            m_log << "canvas";
        return false;
    }

private:
    QStringList &m_log;
};

} // namespace

class TestFluid : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
        QVERIFY(m_folder.isValid());
    }

    void init() { settings::store().clear(); }

    void withoutACanvasChangesComeAtOnce()
    {
        Document document;
        LaterChanges later(document);
        QSignalSpy spy(&later, &LaterChanges::changed);
        document.reset(request(1).painting);
        document.setSelection({{1}, {}});
        QCOMPARE(spy.count(), 2);
        QVERIFY(!later.isWaiting());
    }

    void whatWaitsComesAsOne()
    {
        Document document;
        document.reset(movedBy(0, false).painting);
        LaterChanges later(document);
        std::vector<Change> heard;
        connect(&later, &LaterChanges::changed, this, [&](const Change &change) { heard.push_back(change); });
        later.setCanvasShown(true);
        document.setSelection({{1}, {}});
        document.setSelection({{2}, {}});
        QVERIFY(later.isWaiting());
        QCOMPARE(heard.size(), std::size_t(0));
        later.painted();
        QTRY_COMPARE(heard.size(), std::size_t(1));
        QVERIFY(heard[0].selection && heard[0].strokes.empty());

        document.setSelection({{3}, {}});
        Edit edit;
        edit.strokes[2] = std::make_shared<const Stroke>(*document.painting()->find(2));
        edit.canvas = document.painting()->canvas;
        document.exchange(edit); // this does not wait, and takes with it what does
        QCOMPARE(heard.size(), std::size_t(2));
        QVERIFY(heard[1].selection);
        QCOMPARE(heard[1].strokes, std::vector<StrokeId>{2});

        document.setSelection({{1}, {}});
        QTRY_COMPARE(heard.size(), std::size_t(3)); // nothing is painted: it comes all the same
        document.setSelection({{2}, {}});
        later.flush();
        QCOMPARE(heard.size(), std::size_t(4));
        later.flush();
        QCOMPARE(heard.size(), std::size_t(4));
    }

    void theOverlayComesBeforeThePanels()
    {
        Selecting s({line(1, {100, 100}, {400, 100}), line(2, {100, 300}, {400, 300})});
        s.dry();
        QStringList log;
        PaintWatch watch(*s.canvas().findChild<QWidget *>(), log);
        connect(&s.editor().laterChanges(), &LaterChanges::changed, this, [&] { log << "panels"; });
        s.click({250, 100});
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        QVERIFY(!log.contains("panels"));
        QTRY_VERIFY(log.contains("panels"));
        QVERIFY2(log.indexOf("canvas") >= 0 && log.indexOf("canvas") < log.indexOf("panels"),
                 qPrintable(log.join(' ')));
    }

    void whoActsFindsPanelsUpToDate()
    {
        Selecting s({line(1, {100, 100}, {400, 100}), line(2, {100, 300}, {400, 300})});
        s.dry();
        s.select({});
        QVERIFY(!s.window.action(Command::Delete).isEnabled());
        s.click({250, 100});
        QVERIFY(s.editor().laterChanges().isWaiting());
        QVERIFY(s.window.action(Command::Delete).isEnabled()); // whoever asks for it gets it as it is now
        s.click({250, 300});
        QVERIFY(s.editor().laterChanges().isWaiting());
        QTest::keyPress(&s.canvas(), Qt::Key_Shift);
        QVERIFY(!s.editor().laterChanges().isWaiting());
        QTest::keyRelease(&s.canvas(), Qt::Key_Shift);
        s.click({250, 100});
        s.use(Command::Delete);
        QVERIFY(!s.painting().find(1));
        QVERIFY(s.painting().find(2));
    }

    void panelsFollowADrag()
    {
        Selecting s({line(1, {100, 100}, {400, 100}), line(2, {100, 300}, {400, 300})});
        s.dry();
        s.select({1});
        s.pressAndMove({{250, 100}, {260, 110}, {270, 130}}, none);
        QVERIFY(s.editor().isDragging());
        QTRY_VERIFY(!s.editor().laterChanges().isWaiting());
        QCOMPARE(s.window.action(Command::Undo).isEnabled(), true);
        QVERIFY(s.window.action(Command::Undo).text().contains("Move"));
    }

    void undoGivesUpADragThatHasChangedNothingYet()
    {
        Selecting s({line(1, {100, 100}, {400, 100}), line(2, {100, 300}, {400, 300})});
        s.dry();
        s.editor().undoStack().clear();
        QVERIFY(!s.window.action(Command::Undo).isEnabled());
        for (const bool band : {true, false}) {
            const Point from = band ? Point{20, 20} : Point{250, 100};
            if (!band)
                s.select({1});
            s.send(QEvent::MouseButtonPress, s.logical(s.canvas().view().toPixels(from)), none);
            QVERIFY(s.canvas().tool()->isBusy());
            QVERIFY(s.window.action(Command::Undo).isEnabled());
            s.use(Command::Undo);
            QVERIFY(!s.canvas().tool()->isBusy());
            QVERIFY(!s.window.action(Command::Undo).isEnabled());
            s.send(QEvent::MouseMove, s.logical(s.canvas().view().toPixels({300, 200})), none);
            s.send(QEvent::MouseButtonRelease, s.logical(s.canvas().view().toPixels({300, 200})), none);
            QCOMPARE(s.steps(), 0);
            QCOMPARE(s.stroke(1).origin, (Point{100, 100}));
            QVERIFY(!s.window.action(Command::Undo).isEnabled());
        }
    }

    void manyOutlinesMoveWithTheView()
    {
        bench::PaintingOptions options;
        options.strokes = 100;
        options.segments = 1000;
        options.width = options.height = 400;
        const Painting painting = bench::makePainting(options);
        Selection all;
        for (const StrokePtr &stroke : painting.strokes)
            all.strokes.insert(stroke->id);
        const OverlayColours colours{Qt::gray, Qt::black, QColor(20, 110, 230), Qt::green, Qt::magenta};
        const auto drawn = [&](SelectionOutline &outline, const View &view) {
            QImage image(view.width, view.height, QImage::Format_ARGB32_Premultiplied);
            image.fill(Qt::white);
            QPainter painter(&image);
            outline.paint(painter, view, painting, all, colours, 1);
            return image;
        };
        View view = View::ofArea(Rect::of(0, 0, 400, 400), 400, 400);
        SelectionOutline kept;
        const QImage before = drawn(kept, view);
        QVERIFY(kept.isThin());
        for (const Point by : {Point{37, -12}, Point{90, 140}, Point{-300, 20}}) { // the last one needs other lines
            view.centre = view.centre + by;
            SelectionOutline fresh;
            const QImage a = drawn(kept, view), b = drawn(fresh, view);
            int lines = 0, differ = 0;
            for (int y = 0; y < a.height(); ++y)
                for (int x = 0; x < a.width(); ++x) {
                    lines += b.pixel(x, y) != qRgb(255, 255, 255);
                    differ += a.pixel(x, y) != b.pixel(x, y);
                }
            QVERIFY(lines > 1000);
            QVERIFY2(differ < lines / 20, qPrintable(QString("%1 of %2").arg(differ).arg(lines)));
            QVERIFY(a != before);
        }
    }

    void coarseFramesLookLikeTheExactOnes()
    {
        bench::PaintingOptions options;
        options.strokes = 20;
        options.segments = 300;
        options.width = width;
        options.height = height;
        RenderRequest r = request(1);
        r.painting = std::make_shared<const Painting>(bench::makePainting(options));
        r.time = r.painting->end();
        for (const int factor : {2, 4})
            for (const QSize size : {QSize(width, height), QSize(width + 1, height + 3)}) {
                r.view.width = size.width(), r.view.height = size.height();
                r.view.rotation = factor == 4 ? 0.3 : 0;
                Picture8 picture;
                picture.resize(r.view.width, r.view.height);
                CoarseFrames frames({.threads = 1}, makeRenderer, factor);
                QVERIFY(!frames.isAt(r));
                const Result<RenderStats> stats = frames.draw(r);
                QVERIFY(bool(stats));
                QVERIFY(frames.isAt(r));
                double area = 0;
                for (const PixelRect &rect : stats->dirty)
                    area += double(rect.width) * rect.height;
                QCOMPARE(area, double(r.view.width) * r.view.height); // whole, no pixel twice
                frames.enlargeInto(picture, stats->dirty);
                const double mean = meanDifference(picture.argb, pixelsOf(r));
                QVERIFY2(mean < 2.5 * factor, qPrintable(QString::number(mean)));
            }
    }

    void aLongPictureGivesWayButNeverTwiceInARow()
    {
        HeldRenderer::Hold hold;
        FrameThread worker({.backend = Backend::Cpu, .threads = 1},
                           [&hold](const RendererOptions &options) -> Result<std::unique_ptr<Renderer>> {
                               auto renderer = makeRenderer(options);
                               if (!renderer)
                                   return renderer;
                               return std::unique_ptr<Renderer>(
                                   std::make_unique<HeldRenderer>(std::move(*renderer), hold));
                           });
        QVector<quint64> shown;
        QObject here;
        connect(&worker, &FrameThread::frameReady, &here, [&](const FrameInfo &frame) { shown << frame.serial; });
        QVector<quint64> asked{worker.request(request(1))};
        for (int i = 2; i <= 3; ++i) { // each while the one before takes long
            QTRY_COMPARE_WITH_TIMEOUT(hold.begun.load(std::memory_order_relaxed), i - 1, waitMs);
            QTest::qWait(600);
            asked << worker.request(request(float(i)));
        }
        hold.free.store(true, std::memory_order_relaxed);
        QTRY_COMPARE_WITH_TIMEOUT(shown, asked.mid(1), waitMs);
        QCOMPARE(shownBy(worker), pixelsOf(request(3)));
    }

    void aSlowGestureIsCoarseAndItsRestExact()
    {
        FrameThread worker({.backend = Backend::Cpu, .threads = 2}, makeSlowRenderer);
        worker.setCoarseWanted(true);
        QVector<int> coarseness;
        QObject here;
        connect(&worker, &FrameThread::frameReady, &here,
                [&](const FrameInfo &frame) { coarseness << frame.coarseness; });
        QCOMPARE(draw(worker, movedBy(0, false)).coarseness, 1);
        quint64 last = 0;
        RenderRequest r;
        for (int i = 1; i <= 6; ++i) {
            r = movedBy(i, true);
            const FrameInfo frame = draw(worker, r);
            QCOMPARE(frame.error, QString());
            last = frame.serial;
            QVERIFY2(frame.coarseness > 1, qPrintable(QString::number(i)));
            QVERIFY(!frame.stats.dirty.empty());
            QVERIFY(frame.evaluated < double(width) * height / 4);
        }
        QVERIFY(worker.shownSerial() < last);
        QVERIFY(greatestDifference(shownBy(worker), pixelsOf(r)) > 0);
        QTRY_COMPARE(worker.shownSerial(), last); // it pauses
        QCOMPARE(coarseness.last(), 1);
        QCOMPARE(shownBy(worker), pixelsOf(r));
    }

    /// Strokes that a gesture cuts or takes away are predicted as those that it moves.
    void aSlowGestureIsCoarseWhereStrokesComeAndGo()
    {
        FrameThread worker({.backend = Backend::Cpu, .threads = 2}, makeSlowRenderer);
        worker.setCoarseWanted(true);
        const RenderRequest whole = movedBy(0, false);
        (void)draw(worker, whole);
        RenderRequest cut = whole;
        auto painting = std::make_shared<Painting>(*whole.painting);
        for (const std::size_t i : {std::size_t(2), std::size_t(1)}) { // in two, the second with an id of its own
            Stroke first = *std::as_const(painting->strokes)[i], second = first;
            first.origin = first.origin + Offset{-9, 0};
            second.origin = second.origin + Offset{9, 0};
            second.id = painting->nextStrokeId();
            painting->strokes[i] = std::make_shared<const Stroke>(first);
            painting->strokes.insert(painting->strokes.cbegin() + std::ptrdiff_t(i) + 1,
                                     std::make_shared<const Stroke>(second));
        }
        cut.painting = painting;
        cut.interactive = true;
        FrameInfo frame = draw(worker, cut);
        QVERIFY(frame.coarseness > 1); // from the first one on
        QTRY_COMPARE(worker.shownSerial(), frame.serial);
        QCOMPARE(shownBy(worker), pixelsOf(cut));

        RenderRequest gone = cut;
        auto less = std::make_shared<Painting>(*painting);
        less->strokes.resize(1);
        gone.painting = less;
        frame = draw(worker, gone);
        QVERIFY(frame.coarseness > 1);
        QTRY_COMPARE(worker.shownSerial(), frame.serial);
        QCOMPARE(shownBy(worker), pixelsOf(gone));
    }

    void aGestureThatComesBackLeavesNoCoarsePixel()
    {
        FrameThread worker({.backend = Backend::Cpu, .threads = 2}, makeSlowRenderer);
        worker.setCoarseWanted(true);
        const RenderRequest still = movedBy(0, false);
        (void)draw(worker, still);
        for (int i = 1; i <= 4; ++i)
            (void)draw(worker, movedBy(i % 4, true));
        QVERIFY(shownBy(worker) != pixelsOf(still));
        (void)draw(worker, still);
        QCOMPARE(shownBy(worker), pixelsOf(still));
    }

    void otherFramesStayExact()
    {
        FrameThread worker({.backend = Backend::Cpu, .threads = 2}, makeSlowRenderer);
        (void)draw(worker, movedBy(0, false));
        for (int i = 1; i <= 3; ++i) // not wanted
            QCOMPARE(draw(worker, movedBy(i, true)).coarseness, 1);
        worker.setCoarseWanted(true);
        QCOMPARE(draw(worker, movedBy(4, false)).coarseness, 1); // no gesture
        RenderRequest elsewhere = movedBy(5, true);
        elsewhere.view.centre = elsewhere.view.centre + Point{3, 1};
        QCOMPARE(draw(worker, elsewhere).coarseness, 1); // another view
        QCOMPARE(shownBy(worker), pixelsOf(elsewhere));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestFluid)
#include "test_fluid.moc"
