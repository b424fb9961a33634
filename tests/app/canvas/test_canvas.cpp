// The view's arithmetic, and the canvas as a hand uses it: wheel, drags, keys.
#include "app/canvas/canvas_widget.h"
#include "app/canvas/overlay/overlay.h"
#include "app/session/editor.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include <numbers>

using namespace suffuse;

namespace {

constexpr int waitMs = 20'000;

/// A straight stroke across the middle of the canvas.
StrokePtr line(StrokeId id, Point from, Point to)
{
    Stroke stroke;
    stroke.id = id;
    stroke.style = {StyleKind::Feathering, {0.4f, 1, 0}};
    Segment segment;
    segment.colour = {0.9f, 0.1f, 0.8f, 1};
    segment.diffusion = 60;
    segment.density = 30;
    for (int k = 0; k < 4; ++k)
        segment.bezier[k] = toOffset(from + (k / 3.0) * (to - from), {0, 0});
    stroke.segments = {segment};
    return std::make_shared<const Stroke>(stroke);
}

PaintingPtr paintingWithLine()
{
    auto painting = std::make_shared<Painting>();
    painting->canvas.width = 400;
    painting->canvas.height = 300;
    painting->strokes = {line(1, {80, 150}, {320, 150})};
    return painting;
}

void sendWheel(QWidget &widget, QPointF at, int angle, Qt::KeyboardModifiers modifiers = {})
{
    QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, angle}, Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&widget, &event);
}

double distance(Point a, Point b)
{
    return length(a - b);
}

} // namespace

class TestCanvas : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_settings.filePath("settings.ini").toLocal8Bit());
        QVERIFY(m_settings.isValid());
    }

    void zoomKeepsThePointUnderThePointer_data()
    {
        QTest::addColumn<double>("rotation");
        QTest::addColumn<bool>("mirrored");
        QTest::newRow("upright") << 0.0 << false;
        QTest::newRow("turned") << 0.7 << false;
        QTest::newRow("mirrored") << -2.1 << true;
    }

    void zoomKeepsThePointUnderThePointer()
    {
        QFETCH(double, rotation);
        QFETCH(bool, mirrored);
        ViewTransform transform;
        transform.resize(801, 603);
        transform.fit(Rect::of(0, 0, 1024, 768), 20);
        if (mirrored)
            transform.mirrorAt({10, 20});
        transform.rotateAt({100, 50}, rotation);
        const Point pixel{123, 456};
        const Point canvas = transform.view().toCanvas(pixel);
        for (int i = 0; i < 200; ++i) {
            transform.zoomAt(pixel, 1.2);
            QVERIFY(distance(transform.view().toPixels(canvas), pixel) < 1e-2);
        }
        QCOMPARE(transform.view().scale, ViewTransform::maxScale);
        for (int i = 0; i < 400; ++i)
            transform.zoomAt(pixel, 0.8);
        QCOMPARE(transform.view().scale, ViewTransform::minScale);
    }

    void mirrorFlipsTheScreen()
    {
        ViewTransform transform;
        transform.resize(200, 100);
        transform.setRotationAt({100, 50}, 0.4);
        const Point canvas{13, -7};
        const Point before = transform.view().toPixels(canvas);
        transform.mirrorAt({100, 50});
        const Point after = transform.view().toPixels(canvas);
        QVERIFY(std::abs(after.x - (200 - before.x)) < 1e-9);
        QVERIFY(std::abs(after.y - before.y) < 1e-9);
    }

    void fitShowsTheWholeTurnedArea()
    {
        ViewTransform transform;
        transform.resize(640, 480);
        transform.setRotationAt({0, 0}, 0.5);
        const Rect area = Rect::of(-300, 200, 5000, 700);
        transform.fit(area, 10);
        double least = 1e9;
        for (const Point corner : {Point{-300, 200}, Point{4700, 200}, Point{4700, 900}, Point{-300, 900}}) {
            const Point p = transform.view().toPixels(corner);
            least = std::min({least, p.x, p.y, 640 - p.x, 480 - p.y});
        }
        QVERIFY(std::abs(least - 10) < 1e-6);
    }

    void oldFrameMapsToTheSamePlaces()
    {
        View from, to;
        from.width = 300, from.height = 200, from.scale = 3, from.rotation = 0.3, from.centre = {1e6 + 1, -2};
        to.width = 500, to.height = 250, to.scale = 40, to.rotation = -1.1, to.mirrored = true, to.centre = {1e6, -3};
        const QTransform map = mapBetween(from, to);
        for (const Point pixel : {Point{0, 0}, Point{300, 0}, Point{17, 193}}) {
            const Point expected = to.toPixels(from.toCanvas(pixel));
            const QPointF mapped = map.map(QPointF(pixel.x, pixel.y));
            QVERIFY(distance(expected, {mapped.x(), mapped.y()}) < 1e-6);
        }
        QVERIFY(mapBetween(from, from).isIdentity() || distance({mapBetween(from, from).dx(), 0}, {0, 0}) < 1e-9);
    }

    void linesAreClippedAtDeepZoom()
    {
        const Rect window = Rect::of(0, 0, 100, 100);
        Point a{-1e12, 50}, b{1e12, 50};
        QVERIFY(clipLine(a, b, window));
        QVERIFY(std::abs(a.x) < 1e-3 && std::abs(b.x - 100) < 1e-3);
        Point c{-10, 200}, d{300, 201};
        QVERIFY(!clipLine(c, d, window));

        View view;
        view.width = view.height = 100;
        view.scale = 1e9;
        view.centre = {50, 50};
        const QPolygonF corners = clippedCorners(view, Rect::of(0, 0, 100, 100), window);
        QCOMPARE(corners.boundingRect().toRect(), QRect(0, 0, 100, 100));

        QPainterPath path;
        addCurve(path, Cubic{{{{0, 50}, {30, 50}, {70, 50}, {100, 50}}}}, view);
        QVERIFY(!path.isEmpty());
        QVERIFY(path.boundingRect().width() < 1000);
    }

    void rendersThePaintingAndFollowsTheView()
    {
        Editor editor;
        CanvasWidget canvas(editor);
        canvas.resize(500, 400);
        canvas.show();
        editor.document().reset(paintingWithLine());
        editor.clock().setTime(editor.document().painting()->end());
        QTRY_VERIFY_WITH_TIMEOUT(canvas.isUpToDate(), waitMs);
        const QImage picture = canvas.picture();
        QCOMPARE(picture.size(), QSize(500, 400));
        const Point middle = canvas.view().toPixels({200, 150});
        const Point corner = canvas.view().toPixels({10, 10});
        QVERIFY(qGray(picture.pixel(int(middle.x), int(middle.y))) < 160);
        QCOMPARE(picture.pixel(int(corner.x), int(corner.y)), qRgb(255, 255, 255));

        QEvent leave(QEvent::Leave); // without a pointer over it, the centre stays
        QCoreApplication::sendEvent(&canvas, &leave);
        canvas.setZoom(4);
        QTRY_VERIFY_WITH_TIMEOUT(canvas.isUpToDate(), waitMs);
        const Point moved = canvas.view().toPixels({200, 150});
        QVERIFY(distance(moved, {250, 200}) < 1e-6);
        QVERIFY(qGray(canvas.picture().pixel(int(moved.x), int(moved.y))) < 160);
    }

    void pasteboardLiesOverThePictureOnly()
    {
        Editor editor;
        CanvasWidget canvas(editor);
        canvas.resize(600, 300);
        canvas.show();
        editor.document().reset(paintingWithLine());
        QTRY_VERIFY_WITH_TIMEOUT(canvas.isUpToDate(), waitMs);
        const QImage shot = canvas.grab().toImage();
        QVERIFY(qGray(shot.pixel(3, 150)) < 250);                      // tinted
        QCOMPARE(canvas.picture().pixel(3, 150), qRgb(255, 255, 255)); // not the picture
        const Point paper = canvas.view().toPixels({20, 20});
        QCOMPARE(shot.pixel(int(paper.x), int(paper.y)), qRgb(255, 255, 255)); // the canvas is clear
    }

    void wheelZoomsAtThePointerAndPans()
    {
        Editor editor;
        CanvasWidget canvas(editor);
        canvas.resize(500, 400);
        canvas.show();
        const QPointF at(100, 300);
        const Point pixel{100, 300};
        const View before = canvas.view();
        const Point canvasPoint = before.toCanvas(pixel);
        sendWheel(canvas, at, 240);
        QVERIFY(std::abs(canvas.view().scale / before.scale - 1.25 * 1.25) < 1e-9);
        QVERIFY(distance(canvas.view().toPixels(canvasPoint), pixel) < 1e-6);
        const View zoomed = canvas.view();
        sendWheel(canvas, at, -120, Qt::ShiftModifier);
        QCOMPARE(canvas.view().scale, zoomed.scale);
        QVERIFY(canvas.view().centre.x > zoomed.centre.x);
        QCOMPARE(canvas.view().centre.y, zoomed.centre.y);
        const View moved = canvas.view();
        QWheelEvent tilted(at, canvas.mapToGlobal(at), {}, {120, 0}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&canvas, &tilted);
        QCOMPARE(canvas.view().scale, moved.scale);
        QVERIFY(canvas.view().centre.x < moved.centre.x);
        QCOMPARE(canvas.view().centre.y, moved.centre.y);
        const View tiltedView = canvas.view(); // Ctrl+wheel zooms, as it does everywhere else
        sendWheel(canvas, at, 120, Qt::ControlModifier);
        QVERIFY(std::abs(canvas.view().scale / tiltedView.scale - 1.25) < 1e-9);
        const View closer = canvas.view();
        sendWheel(canvas, at, 120, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(canvas.view().scale, closer.scale);
        QVERIFY(canvas.view().centre.y < closer.centre.y);
        QCOMPARE(canvas.view().centre.x, closer.centre.x);
    }

    void dragsPanAndRotate()
    {
        Editor editor;
        CanvasWidget canvas(editor);
        canvas.resize(500, 400);
        canvas.show();
        const Point grabbed = canvas.view().toCanvas({200, 200});
        QTest::mousePress(&canvas, Qt::MiddleButton, {}, {200, 200});
        QTest::mouseMove(&canvas, {260, 170});
        QTest::mouseRelease(&canvas, Qt::MiddleButton, {}, {260, 170});
        QVERIFY(distance(canvas.view().toPixels(grabbed), {260, 170}) < 1e-6);

        QTest::keyPress(&canvas, Qt::Key_Space);
        QTest::mousePress(&canvas, Qt::LeftButton, {}, {260, 170});
        QTest::mouseMove(&canvas, {200, 200});
        QTest::mouseRelease(&canvas, Qt::LeftButton, {}, {200, 200});
        QTest::keyRelease(&canvas, Qt::Key_Space);
        QVERIFY(distance(canvas.view().toPixels(grabbed), {200, 200}) < 1e-6);
        QVERIFY(editor.document().painting()->strokes.empty());

        QTest::keyPress(&canvas, Qt::Key_R);
        QTest::mousePress(&canvas, Qt::LeftButton, {}, {350, 200});
        QTest::mouseMove(&canvas, {250, 300});
        QTest::mouseRelease(&canvas, Qt::LeftButton, {}, {250, 300});
        QTest::keyRelease(&canvas, Qt::Key_R);
        QVERIFY(std::abs(canvas.view().rotation - std::numbers::pi / 2) < 1e-9);
        canvas.resetRotation();
        QCOMPARE(canvas.view().rotation, 0.0);
    }

    void workerDropsWhatIsSuperseded()
    {
        FrameThread worker({});
        QSignalSpy frames(&worker, &FrameThread::frameReady);
        quint64 last = 0;
        for (int i = 1; i <= 50; ++i) {
            RenderRequest request;
            request.painting = paintingWithLine();
            request.time = 2'000'000;
            request.view = View::ofArea(Rect::of(i, 0, 400, 300), 400, 300);
            last = worker.request(std::move(request));
        }
        QTRY_COMPARE_WITH_TIMEOUT(worker.shownSerial(), last, waitMs);
        QTRY_VERIFY_WITH_TIMEOUT(!frames.isEmpty(), waitMs);
        QVERIFY(frames.size() <= 50);
        worker.withFrame([](ShownFrame &frame) {
            QCOMPARE(frame.view.centre.x, 250.0);
            QCOMPARE(frame.picture.width, 400);
            QCOMPARE(frame.picture.argb.size(), std::size_t(400 * 300));
        });
    }

    void frameAfterManyChangesIsTheFrameAtOnce()
    {
        // What was cancelled, superseded or copied in parts must leave no trace in the picture.
        Editor editor;
        editor.clock().setManual(true);
        CanvasWidget canvas(editor);
        canvas.resize(420, 320);
        canvas.show();
        editor.document().reset(paintingWithLine());
        for (int step = 0; step <= 10; ++step) {
            editor.clock().setTime(step * 100'000);
            QTest::qWait(3);
        }
        QTRY_VERIFY_WITH_TIMEOUT(canvas.isUpToDate(), waitMs);

        Result<std::unique_ptr<Renderer>> renderer = makeRenderer({}); // as the canvas chooses
        QVERIFY2(bool(renderer), qPrintable(renderer.error()));
        Picture8 picture;
        RenderRequest request{editor.document().snapshot(), editor.clock().time(), canvas.view()};
        QVERIFY(bool((*renderer)->render(request, picture)));
        const QImage shown = canvas.picture();
        QCOMPARE(shown.size(), QSize(picture.width, picture.height));
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x)
                if (shown.pixel(x, y) != picture.argb[std::size_t(y) * picture.width + x])
                    QFAIL(qPrintable(QStringLiteral("pixel %1, %2 differs").arg(x).arg(y)));
    }

private:
    QTemporaryDir m_settings;
};

QTEST_MAIN(TestCanvas)
#include "test_canvas.moc"
#include "render/backends.h"
