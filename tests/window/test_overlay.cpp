// Only parts of the canvas are painted while something is dragged: nothing of where it stood may stay on the screen.
#include "app/tools/node_tool.h"
#include "tests/app/selecting.h"
#include "tests/window/screen.h"

#include <QScreen>
#include <QTemporaryDir>

using namespace suffuse;

class TestOverlay : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void draggedStroke();
    void draggedNode();
    void nudgedAndUndone();

private:
    /// Pixels in which the screen differs from the canvas painted anew.
    static int stalePixels(Selecting &s);

    QTemporaryDir m_folder;
};

void TestOverlay::initTestCase()
{
    if (const QString why = noScreen(); !why.isEmpty())
        QSKIP(qPrintable(why));
    QVERIFY(m_folder.isValid());
    qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    qputenv("SUFFUSE_PRESENTER", "raster");
}

int TestOverlay::stalePixels(Selecting &s)
{
    QTest::qWait(300); // until the frames after the drag have come
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
    QCOMPARE(s.steps(), 1);
    QCOMPARE(stalePixels(s), 0); // with the button still down
    s.send(QEvent::MouseButtonRelease, s.logical(view.toPixels({600, 410})), shift);
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
    QCOMPARE(s.steps(), 1);
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

int main(int argc, char **argv)
{
    if (qEnvironmentVariableIsEmpty("DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen"); // so that it can say why it does nothing
    QApplication app(argc, argv);
    TestOverlay test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_overlay.moc"
