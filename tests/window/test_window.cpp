// The window on a real screen: both presenters show exactly the picture, docks float and come back, whatever the scale.
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/strokes/strokes_panel.h"
#include "model/formats/files.h"
#include "tests/window/screen.h"

#include <QDockWidget>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QProcess>
#include <QScreen>
#include <QSignalSpy>
#include <QTreeView>

#include <algorithm>

using namespace suffuse;

/// Of a window whose every pixel OpenGL draws by software, at a scale of 2 four of them for one.
constexpr QSize fewPixels(900, 640);

class TestWindow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();

    void bothPresentersShowThePicture_data() { presenters(); }
    void bothPresentersShowThePicture();
    void turnedAndMirroredViews_data() { presenters(); }
    void turnedAndMirroredViews();
    void docksFloatAndComeBack_data() { presenters(); }
    void docksFloatAndComeBack();
    void scaleOfTwo();
    void keysWorkAfterAField();
    void docksShareTheRoom();
    void fullScreenAndBack();
    void paintingKeepsUpWithTheHand_data() { presenters(); }
    void paintingKeepsUpWithTheHand();

private:
    static void presenters();

    OwnSettings m_settings;
};

void TestWindow::initTestCase()
{
    BEGIN_ON_SCREEN(m_settings, "raster");
    qInfo("scale %g", qApp->devicePixelRatio());
}

void TestWindow::init()
{
    QVERIFY(m_settings.begin("raster"));
}

void TestWindow::presenters()
{
    QTest::addColumn<QString>("presenter");
    QTest::newRow("raster") << "raster";
    QTest::newRow("OpenGL") << "OpenGL";
}

void TestWindow::bothPresentersShowThePicture()
{
    QFETCH(QString, presenter);
    qputenv("SUFFUSE_PRESENTER", presenter.toLatin1());
    Session s;
    QVERIFY(QTest::qWaitForWindowExposed(&s.window));
    QCOMPARE(s.canvas().presenterName(), presenter);
    QCOMPARE(s.canvas().view().width, qRound(s.canvas().width() * s.canvas().devicePixelRatioF()));
    s.window.resize(fewPixels);
    s.paintLine({150, 200}, {850, 300});
    s.paintLine({150, 600}, {850, 250});
    COMPARE_SCREEN(s); // half way
    s.dry();
    COMPARE_SCREEN(s);
    s.use(Command::Undo);
    COMPARE_SCREEN(s);
    s.use(Command::Redo);
    s.canvas().setZoom(3);
    COMPARE_SCREEN(s);
}

void TestWindow::turnedAndMirroredViews()
{
    QFETCH(QString, presenter);
    qputenv("SUFFUSE_PRESENTER", presenter.toLatin1());
    Session s;
    QVERIFY(QTest::qWaitForWindowExposed(&s.window));
    s.paintLine({200, 200}, {800, 500});
    s.dry();
    s.canvas().rotateBy(33);
    s.canvas().mirror();
    s.canvas().panBy({17, -9});
    COMPARE_SCREEN(s);
    s.window.resize(fewPixels);
    COMPARE_SCREEN(s);
}

void TestWindow::docksFloatAndComeBack()
{
    QFETCH(QString, presenter);
    qputenv("SUFFUSE_PRESENTER", presenter.toLatin1());
    Session s;
    QVERIFY(QTest::qWaitForWindowExposed(&s.window));
    s.window.resize(fewPixels);
    s.paintLine({150, 200}, {850, 500});
    s.dry();
    const QList<QDockWidget *> docks = s.window.findChildren<QDockWidget *>();
    QCOMPARE(docks.size(), 8);
    for (QDockWidget *dock : docks) {
        dock->setFloating(true);
        QTest::qWait(30);
    }
    COMPARE_SCREEN(s);
    s.paintLine({150, 500}, {850, 200}); // the picture goes on while they float
    s.dry();
    COMPARE_SCREEN(s);
    for (QDockWidget *dock : docks) {
        dock->setFloating(false);
        QTest::qWait(30);
    }
    COMPARE_SCREEN(s);
    s.use(Command::HideDocks);
    QVERIFY(std::none_of(docks.begin(), docks.end(), [](QDockWidget *dock) { return dock->isVisible(); }));
    COMPARE_SCREEN(s);
    s.use(Command::HideDocks);
    COMPARE_SCREEN(s);
}

/// The scale is read when a program starts: this one runs itself.
void TestWindow::scaleOfTwo()
{
    if (qApp->devicePixelRatio() == 2)
        QSKIP("runs at a scale of 2 already");
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("QT_SCALE_FACTOR", "2");
    program.setProcessEnvironment(environment);
    program.setProcessChannelMode(QProcess::MergedChannels);
    program.start(QCoreApplication::applicationFilePath(), {"bothPresentersShowThePicture", "docksFloatAndComeBack"});
    QVERIFY(program.waitForFinished(600'000));
    const QByteArray output = program.readAll();
    QVERIFY2(program.exitStatus() == QProcess::NormalExit && program.exitCode() == 0, output.constData());
    QVERIFY2(output.contains("scale 2"), output.constData());
}

/// As a full HD screen has it: six rows of strokes at least, below fields of the inspector.
void TestWindow::docksShareTheRoom()
{
    Session s;
    QVERIFY(QTest::qWaitForWindowExposed(&s.window));
    if (s.window.screen()->availableSize().height() < 1080)
        QSKIP("the screen is too low");
    s.window.resize(1900, 1050);
    auto *strokes = s.window.findChild<StrokesPanel *>();
    QTRY_VERIFY(s.window.height() == 1050 && strokes->view()->isVisible());
    s.paintLine({150, 200}, {850, 500});
    s.dry();
    // On a screen of this height the list shares its place with the inspector.
    s.window.findChild<QDockWidget *>("strokesDock")->raise();
    const int row = strokes->view()->visualRect(strokes->view()->model()->index(0, 0)).height();
    QVERIFY(row > 0);
    QTRY_VERIFY2(strokes->view()->viewport()->height() >= 6 * row,
                 qPrintable(QString("%1 / %2").arg(strokes->view()->viewport()->height()).arg(row)));
    s.window.findChild<QDockWidget *>("inspectorDock")->raise();
    QTRY_VERIFY(!s.window.findChild<InspectorPanel *>()->visibleRegion().isEmpty());
}

void TestWindow::keysWorkAfterAField()
{
    Session s;
    QVERIFY(QTest::qWaitForWindowExposed(&s.window));
    s.window.activateWindow();
    QTRY_VERIFY_WITH_TIMEOUT(s.window.isActiveWindow(), waitMs);
    QLineEdit *width = nullptr;
    for (QLineEdit *field : s.window.findChildren<QLineEdit *>())
        if (field->isVisible() && field->accessibleName() == "Width")
            width = field;
    QVERIFY(width);
    width->setFocus();
    QTest::qWait(1); // the field selects its text when it gets the focus
    width->selectAll();
    QTest::keyClicks(width, "2000");
    QTest::keyClick(width, Qt::Key_Return);
    QCOMPARE(s.painting().canvas.width, 2000.0);
    QTRY_VERIFY_WITH_TIMEOUT(s.canvas().hasFocus(), waitMs);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(s.painting().canvas.width, 1024.0);
    // In a field in which nothing has been typed, too.
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(s.painting().canvas.width, 2000.0);
    width->setFocus();
    QTest::keyClick(width, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(s.painting().canvas.width, 1024.0);
}

void TestWindow::fullScreenAndBack()
{
    Session s;
    QVERIFY(QTest::qWaitForWindowExposed(&s.window));
    s.use(Command::FullScreen);
    QTRY_VERIFY_WITH_TIMEOUT(s.window.isFullScreen(), waitMs);
    QVERIFY(s.window.action(Command::FullScreen).isChecked());
    s.window.showNormal(); // as a window manager's key does it
    QTRY_VERIFY_WITH_TIMEOUT(!s.window.action(Command::FullScreen).isChecked(), waitMs);
}

/// 778 strokes with 23 segments each lie below, as many as the paper's largest figure has.
PaintingPtr largePainting()
{
    auto painting = std::make_shared<Painting>();
    for (int i = 0; i < 778; ++i) {
        Stroke stroke;
        stroke.id = StrokeId(i + 1);
        stroke.origin = {double(37 * i % 900), double(61 * i % 700)};
        stroke.style = {StyleKind::Uniform, {0.4f, 0.1f, 0}};
        for (int k = 0; k < 23; ++k) {
            const auto at = [&](double t) { return Offset{float(5 * (k + t)), float(20 * std::sin((k + t) / 5 + i))}; };
            Segment segment;
            segment.bezier = {at(0), at(1.0 / 3), at(2.0 / 3), at(1)};
            segment.colour = {float(i % 7) / 7, float(i % 5) / 5, float(i % 3) / 3, 0.8f};
            stroke.segments.push_back(segment);
        }
        painting->strokes.push_back(std::make_shared<const Stroke>(std::move(stroke)));
    }
    return painting;
}

/// "median 8.2 ms, p99 34.0 ms"
QString spread(std::vector<double> times)
{
    std::sort(times.begin(), times.end());
    const auto at = [&](double share) { return times[std::size_t(share * double(times.size() - 1))]; };
    return QStringLiteral("median %1 ms, p99 %2 ms").arg(at(0.5), 0, 'f', 1).arg(at(0.99), 0, 'f', 1);
}

/// Frame times are printed, never judged: how fast a machine is belongs to no test. SUFFUSE_FRAMES_PAINTING names
/// another painting to paint on.
void TestWindow::paintingKeepsUpWithTheHand()
{
    QFETCH(QString, presenter);
    qputenv("SUFFUSE_PRESENTER", presenter.toLatin1());
    Session s;
    PaintingPtr below = largePainting();
    if (const QString file = qEnvironmentVariable("SUFFUSE_FRAMES_PAINTING"); !file.isEmpty()) {
        Result<Painting> loaded = loadPainting(file);
        QVERIFY2(bool(loaded), qPrintable(loaded ? QString() : loaded.error()));
        below = std::make_shared<const Painting>(std::move(*loaded));
    }
    s.editor().document().reset(below);
    s.window.resize(s.window.width() + 1024 - s.canvas().width(), s.window.height() + 768 - s.canvas().height());
    QVERIFY(QTest::qWaitForWindowExposed(&s.window));
    s.canvas().setZoom(1);
    s.dry();
    s.editor().clock().setManual(false);
    const std::size_t before = s.painting().strokes.size();

    struct Frame {
        qint64 at;      ///< µs
        double totalMs; ///< of the renderer
        double lagMs;   ///< from asking for it, which the event before does at once, to having it
    };
    std::vector<Frame> frames;
    QElapsedTimer clock;
    clock.start();
    connect(&s.canvas(), &CanvasWidget::framePresented, &s.window, [&](const FrameInfo &frame) {
        if (!frame.stats.dirty.empty())
            frames.push_back({clock.nsecsElapsed() / 1000, frame.stats.totalMs,
                              1e3 * toSeconds(s.editor().clock().time() - frame.time)});
    });
    const auto point = [&](int i) {
        return QPoint(int(s.canvas().width() * (0.1 + 0.005 * i)),
                      int(s.canvas().height() * (0.5 + 0.3 * std::sin(i * 0.1))));
    };
    // A hand at 125 reports a second, for 1.3 s; where OpenGL is software every report takes long.
    const int reports = presenter == "OpenGL" ? 24 : 160;
    QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, point(0));
    for (int i = 1; i <= reports; ++i) {
        QTest::qWait(std::max<int>(0, int(8 * i - clock.elapsed())));
        QTest::mouseMove(&s.canvas(), point(i));
    }
    QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, point(reports));
    QCOMPARE(s.painting().strokes.size(), before + 1);
    QTRY_VERIFY_WITH_TIMEOUT(!s.editor().clock().isRunning() && s.canvas().isUpToDate(), waitMs);

    QVERIFY(frames.size() > 2);
    std::vector<double> gaps, renders, lags;
    for (std::size_t i = 1; i < frames.size(); ++i)
        gaps.push_back(double(frames[i].at - frames[i - 1].at) / 1000);
    for (const Frame &frame : frames) {
        renders.push_back(frame.totalMs);
        lags.push_back(frame.lagMs);
    }
    qInfo("%s: %zu frames; from frame to frame %s; rendering %s; from event to frame %s", qPrintable(presenter),
          frames.size(), qPrintable(spread(gaps)), qPrintable(spread(renders)), qPrintable(spread(lags)));
    COMPARE_SCREEN(s);
}

int main(int argc, char **argv)
{
    // As main.cpp of the program has it.
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    prepareOpenGl();
    if (qEnvironmentVariableIsEmpty("DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen"); // so that it can say why it does nothing
    QApplication app(argc, argv);
    TestWindow test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_window.moc"
