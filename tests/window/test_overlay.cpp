// Only parts of the canvas are painted while something is dragged: nothing of where it stood may stay on the screen.
#include "app/tools/nodes/node_tool.h"
#include "tests/app/selecting.h"
#include "tests/window/screen.h"

#include <QScreen>

using namespace suffuse;

class TestOverlay : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void draggedStroke();
    void draggedNode();
    void nudgedAndUndone();
    void selectedByBands_data();
    void selectedByBands();
    void oneNodeAmongMany();
    void allAndNone();

private:
    /// Pixels in which the screen differs from the canvas painted anew.
    static int stalePixels(Selecting &s, int wait = 300); // until the frames after the drag have come
    /// So many that their outlines are thinned out, and one that lies apart.
    static StrokeList manyStrokes();

    OwnSettings m_settings;
};

void TestOverlay::initTestCase()
{
    BEGIN_ON_SCREEN(m_settings, "raster");
}

int TestOverlay::stalePixels(Selecting &s, int wait)
{
    QTest::qWait(wait);
    CanvasWidget &canvas = s.canvas();
    const QPoint at = canvas.mapTo(&s.window, QPoint());
    const QImage seen = s.window.screen()
                            ->grabWindow(s.window.winId(), at.x(), at.y(), canvas.width(), canvas.height())
                            .toImage()
                            .convertToFormat(QImage::Format_RGB32);
    const QImage anew = canvas.grab().toImage().convertToFormat(QImage::Format_RGB32);
    if (seen.size() != anew.size())
        return -1;
    int stale = 0;
    for (int y = 0; y < anew.height(); ++y)
        for (int x = 0; x < anew.width(); ++x)
            stale += levels(seen.pixel(x, y), anew.pixel(x, y)) > 2;
    return stale;
}

void TestOverlay::draggedStroke()
{
    Selecting s({line(1, {200, 200}, {400, 260}), line(2, {300, 500}, {700, 480})});
    QVERIFY(QTest::qWaitForWindowExposed(&s.window));
    s.dry();
    s.select({1});
    QCOMPARE(stalePixels(s), 0);
    const View view = s.canvas().view();
    s.send(QEvent::MouseButtonPress, s.logical(view.toPixels({300, 230})), none);
    for (int i = 1; i <= 20; ++i) { // frames come between the reports
        s.send(QEvent::MouseMove, s.logical(view.toPixels({300 + 15.0 * i, 230 + 9.0 * i})), shift);
        QTest::qWait(i % 4 == 0 ? 20 : 3);
    }
    QVERIFY(s.editor().undecided());
    QCOMPARE(stalePixels(s), 0); // with the button still down
    s.send(QEvent::MouseButtonRelease, s.logical(view.toPixels({600, 410})), shift);
    QCOMPARE(s.steps(), 1);
    QCOMPARE(stalePixels(s), 0);
    s.use(Command::Undo);
    QCOMPARE(stalePixels(s), 0);
}

void TestOverlay::draggedNode()
{
    Selecting s({line(1, {200, 200}, {500, 260}), line(2, {300, 500}, {700, 480})});
    QVERIFY(QTest::qWaitForWindowExposed(&s.window));
    s.dry();
    s.use(Command::Segments);
    s.select({1});
    static_cast<NodeTool *>(s.canvas().tool())->selectNodes({{1, 2}});
    const View view = s.canvas().view();
    const Point node = nodePosition(s.stroke(1), 2);
    s.send(QEvent::MouseButtonPress, s.logical(view.toPixels(node)), none);
    for (int i = 1; i <= 20; ++i) {
        s.send(QEvent::MouseMove, s.logical(view.toPixels(node + Point{6.0 * i, 12.0 * i})), none);
        QTest::qWait(i % 4 == 0 ? 20 : 3);
    }
    QVERIFY(s.editor().undecided());
    QCOMPARE(stalePixels(s), 0);
    s.send(QEvent::MouseMove, s.logical(view.toPixels(node)), none); // back to the start
    QCOMPARE(stalePixels(s), 0);
    s.send(QEvent::MouseButtonRelease, s.logical(view.toPixels(node)), none);
    QCOMPARE(s.steps(), 0);
    QCOMPARE(stalePixels(s), 0);
}

void TestOverlay::nudgedAndUndone()
{
    Selecting s({line(1, {200, 200}, {400, 260}), line(2, {300, 500}, {700, 480})});
    QVERIFY(QTest::qWaitForWindowExposed(&s.window));
    s.dry();
    s.select({1, 2});
    for (int i = 0; i < 5; ++i)
        QTest::keyClick(&s.canvas(), Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(stalePixels(s), 0);
    for (int i = 0; i < 5; ++i)
        s.use(Command::Undo);
    QCOMPARE(stalePixels(s), 0);
    s.canvas().panBy({40, 25});
    QTest::keyClick(&s.canvas(), Qt::Key_Down, Qt::ShiftModifier);
    QCOMPARE(stalePixels(s), 0);
}

StrokeList TestOverlay::manyStrokes()
{
    StrokeList strokes;
    for (int i = 0; i < 60; ++i)
        strokes.push_back(line(StrokeId(i + 1), {120, 120.0 + 8 * i}, {420, 100.0 + 9 * i}, 12));
    strokes.push_back(line(61, {700, 200}, {820, 600}));
    return strokes;
}

void TestOverlay::selectedByBands_data()
{
    QTest::addColumn<double>("turned");
    QTest::newRow("upright") << 0.0;
    QTest::newRow("turned") << 30.0;
}

void TestOverlay::selectedByBands()
{
    QFETCH(double, turned);
    const int few = turned == 0 ? 0 : 10; // a smooth border of the sheet that is cut
    Selecting s(manyStrokes());
    QVERIFY(QTest::qWaitForWindowExposed(&s.window));
    s.canvas().setZoom(0.3); // all in the window, beside a timeline of three lanes
    s.canvas().rotateBy(turned);
    s.dry();
    s.use(Command::SelectAll);
    QVERIFY(stalePixels(s) <= few);
    s.use(Command::Deselect);
    QVERIFY(stalePixels(s) <= few);
    s.select({61});
    QVERIFY(stalePixels(s) <= few);
    const View view = s.canvas().view();
    Rect pixels; // of all but the last
    for (const Point corner : {Point{100, 80}, Point{440, 80}, Point{440, 660}, Point{100, 660}})
        pixels.include(view.toPixels(corner));
    const Point from = view.toCanvas({pixels.left, pixels.top}), to = view.toCanvas({pixels.right, pixels.bottom});
    s.pressAndMove({from, {300, 300}, to}, none); // the handles of what was selected give way
    QVERIFY(stalePixels(s) <= few);
    s.send(QEvent::MouseButtonRelease, s.logical(view.toPixels(to)), none);
    QVERIFY(s.selected().contains(30) && !s.selected().contains(61));
    QVERIFY(stalePixels(s) <= few);
    s.pressAndMove({from, to}, none);
    QTest::keyClick(&s.canvas(), Qt::Key_Escape);
    s.send(QEvent::MouseButtonRelease, s.logical(view.toPixels(to)), none);
    QVERIFY(s.selected().contains(30));
    QVERIFY(stalePixels(s) <= few);
    s.use(Command::Lasso);
    s.drag({{650, 150}, {900, 150}, {900, 650}, {650, 650}}, shift);
    QVERIFY(s.selected().contains(30) && s.selected().contains(61));
    QVERIFY(stalePixels(s) <= few);
    s.use(Command::Lasso);
    s.use(Command::Segments);
    s.drag({{650, 150}, {900, 650}});
    QVERIFY(stalePixels(s) <= few);
}

void TestOverlay::oneNodeAmongMany()
{
    Selecting s(manyStrokes());
    QVERIFY(QTest::qWaitForWindowExposed(&s.window));
    s.dry();
    s.use(Command::SelectAll);
    s.use(Command::Segments);
    static_cast<NodeTool *>(s.canvas().tool())->selectNodes({{61, 2}});
    const View view = s.canvas().view();
    const Point node = nodePosition(s.stroke(61), 2);
    s.send(QEvent::MouseButtonPress, s.logical(view.toPixels(node)), none);
    for (int i = 1; i <= 20; ++i) {
        s.send(QEvent::MouseMove, s.logical(view.toPixels(node + Point{-6.0 * i, 4.0 * i})), none);
        QTest::qWait(i % 4 == 0 ? 20 : 3);
    }
    QTRY_VERIFY(s.canvas().isUpToDate());
    QCOMPARE(stalePixels(s, 30), 0); // before the hand rests, of the one stroke alone
    QVERIFY(s.editor().undecided());
    QCOMPARE(stalePixels(s), 0);
    s.send(QEvent::MouseButtonRelease, s.logical(view.toPixels(node + Point{-120, 80})), none);
    QCOMPARE(s.steps(), 1);
    QCOMPARE(stalePixels(s), 0);
    s.use(Command::Undo);
    QCOMPARE(stalePixels(s), 0);
}

void TestOverlay::allAndNone()
{
    Selecting s(manyStrokes());
    QVERIFY(QTest::qWaitForWindowExposed(&s.window));
    s.canvas().setZoom(0.3); // all in the window, beside a timeline of three lanes
    s.dry();
    const auto all = [&] { s.use(Command::SelectAll); };
    const auto none = [&] { s.use(Command::Deselect); };
    const auto some = [&] { s.select({3, 4, 5}); };
    const auto undo = [&] { s.use(Command::Undo); };
    const auto erase = [&] { s.use(Command::Delete); };
    const auto pan = [&] { s.canvas().panBy({40, 25}); };
    const auto zoom = [&] { s.canvas().zoomBy(1.1); };
    const auto nudge = [&] { QTest::keyClick(&s.canvas(), Qt::Key_Right, Qt::ShiftModifier); };
    const std::vector<std::function<void()>> acts{all,  none, all, pan,  none, all,   zoom, none, all, nudge,
                                                  none, undo, all, none, some, erase, all,  undo, all, none};
    for (std::size_t i = 0; i < acts.size(); ++i) {
        acts[i]();
        const int stale = stalePixels(s);
        QVERIFY2(stale == 0, qPrintable(QString("step %1: %2 pixels").arg(i).arg(stale)));
    }
}

int main(int argc, char **argv)
{
    if (qEnvironmentVariableIsEmpty("DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen"); // so that it can say why it does nothing
    QApplication app(argc, argv);
    TestOverlay test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_overlay.moc"
