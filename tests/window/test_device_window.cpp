// Pictures that stay on a device, in a real window: they reach the texture of whatever context there is, and where they
// cannot, the same picture comes over memory.
#include "tests/app/fake_device.h"
#include "tests/window/screen.h"

#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QProcess>

using namespace suffuse;

namespace {

constexpr const char *contextsApart = "SUFFUSE_TEST_CONTEXTS_APART";

/// Everything that the device gave was given back, in order.
#define COMPARE_DEVICE_LEFT(device)                                                                                    \
    do {                                                                                                               \
        QCOMPARE((device).links.load(), 0);                                                                            \
        QCOMPARE((device).badLinkEnds.load(), 0);                                                                      \
        QCOMPARE((device).frames.load(), 0);                                                                           \
        QCOMPARE((device).strayEnds.load(), 0);                                                                        \
    } while (false)

} // namespace

class TestDeviceWindow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void thePictureStaysOnTheDevice();
    void otherWindowsAndDocks();
    void otherContexts();
    void aTextureThatCannotBeLinked();
    void aTextureThatIsLost();
    void aDeviceThatIsLost();

private:
    OwnSettings m_settings;
};

void TestDeviceWindow::initTestCase()
{
    BEGIN_ON_SCREEN(m_settings, "opengl");
    qInfo("contexts %s", qEnvironmentVariableIsSet(contextsApart) ? "apart" : "shared");
}

void TestDeviceWindow::thePictureStaysOnTheDevice()
{
    FakeDevice device;
    {
        Session s(makerOn(device));
        QVERIFY(QTest::qWaitForWindowExposed(&s.window));
        s.paintLine({150, 360}, {850, 420}); // through what zoom 3 shows
        COMPARE_SCREEN(s);
        s.dry();
        COMPARE_SCREEN(s);
        s.use(Command::Undo);
        s.use(Command::Redo);
        s.canvas().setZoom(3);
        COMPARE_SCREEN(s);
        s.canvas().fit();
        s.window.resize(900, 640); // another texture
        COMPARE_SCREEN(s);
        QVERIFY(s.canvas().picture().isNull()); // nothing came over memory
        QVERIFY(device.copies > 2);
        QCOMPARE(device.links.load(), 1);
        QVERIFY(device.linksMade > 1);
        QCOMPARE(s.canvas().backendText(), QString("CUDA · Fake 1"));
        QCOMPARE(s.canvas().backendNotice(), QString());
    }
    COMPARE_DEVICE_LEFT(device);
}

void TestDeviceWindow::otherWindowsAndDocks()
{
    FakeDevice device;
    {
        Session s(makerOn(device));
        QVERIFY(QTest::qWaitForWindowExposed(&s.window));
        s.paintLine({150, 200}, {850, 500});
        s.dry();
        for (const bool floating : {true, false}) {
            for (QDockWidget *dock : s.window.findChildren<QDockWidget *>())
                dock->setFloating(floating);
            COMPARE_SCREEN(s);
        }
        s.use(Command::HideDocks); // they would take the room of the canvas while it is away
        {
            QMainWindow other;
            other.resize(700, 500);
            other.setCentralWidget(s.window.takeCentralWidget());
            other.show();
            QVERIFY(QTest::qWaitForWindowExposed(&other));
            COMPARE_SCREEN(s);
            s.window.setCentralWidget(other.takeCentralWidget());
            s.canvas().show();
        }
        QTRY_VERIFY(s.canvas().width() > 400); // laid out again
        COMPARE_SCREEN(s);
        s.window.hide();
        s.window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&s.window));
        s.paintLine({150, 500}, {850, 200});
        COMPARE_SCREEN(s);
        QVERIFY(s.canvas().picture().isNull());
        QCOMPARE(device.links.load(), 1);
        QCOMPARE(device.badLinkEnds.load(), 0);
    }
    COMPARE_DEVICE_LEFT(device);
}

/// Whether widgets keep their context when they change the window is settled when a program starts: this one runs
/// itself.
void TestDeviceWindow::otherContexts()
{
    if (qEnvironmentVariableIsSet(contextsApart))
        QSKIP("they are apart already");
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(contextsApart, "1");
    program.setProcessEnvironment(environment);
    program.setProcessChannelMode(QProcess::MergedChannels);
    program.start(QCoreApplication::applicationFilePath(), {"otherWindowsAndDocks", "aTextureThatIsLost"});
    QVERIFY(program.waitForFinished(600'000));
    const QByteArray output = program.readAll();
    QVERIFY2(program.exitStatus() == QProcess::NormalExit && program.exitCode() == 0, output.constData());
    QVERIFY2(output.contains("contexts apart"), output.constData());
}

void TestDeviceWindow::aTextureThatCannotBeLinked()
{
    FakeDevice device;
    device.linksFail = true;
    {
        Session s(makerOn(device));
        QVERIFY(QTest::qWaitForWindowExposed(&s.window));
        s.paintLine({150, 200}, {850, 300});
        COMPARE_SCREEN(s);
        QVERIFY(!s.canvas().picture().isNull()); // it came over memory
        const QString why = "another device draws this OpenGL context";
        QVERIFY2(s.canvas().backendNotice().contains(why), qPrintable(s.canvas().backendNotice()));
        QVERIFY(s.window.findChild<QLabel *>("backend")->toolTip().contains(why));
        QCOMPARE(s.canvas().backendText(), QString("CUDA · Fake 1")); // which still renders
        const int onDevice = device.deviceFrames;
        s.paintLine({150, 500}, {850, 200});
        s.window.resize(900, 640);
        COMPARE_SCREEN(s);
        QCOMPARE(device.deviceFrames.load(), onDevice); // asked once, not again and again
    }
    QCOMPARE(device.linksMade.load(), 0);
    COMPARE_DEVICE_LEFT(device);
}

void TestDeviceWindow::aTextureThatIsLost()
{
    FakeDevice device;
    {
        Session s(makerOn(device));
        QVERIFY(QTest::qWaitForWindowExposed(&s.window));
        s.paintLine({150, 200}, {850, 300});
        COMPARE_SCREEN(s);
        QVERIFY(s.canvas().picture().isNull());
        device.copiesUntilFailure = 0;
        s.paintLine({150, 500}, {850, 200});
        COMPARE_SCREEN(s);
        QVERIFY(!s.canvas().picture().isNull());
        QVERIFY2(s.canvas().backendNotice().contains("the texture is gone"), qPrintable(s.canvas().backendNotice()));
    }
    COMPARE_DEVICE_LEFT(device);
}

void TestDeviceWindow::aDeviceThatIsLost()
{
    FakeDevice device;
    {
        Session s(makerOn(device));
        QVERIFY(QTest::qWaitForWindowExposed(&s.window));
        s.paintLine({150, 200}, {850, 300});
        COMPARE_SCREEN(s);
        device.publishesUntilFailure = 0; // the picture is there and cannot be had
        s.paintLine({150, 500}, {850, 200});
        COMPARE_SCREEN(s);
        device.lost = true;
        s.paintLine({200, 600}, {800, 600});
        s.canvas().setZoom(2);
        COMPARE_SCREEN(s);
        QTRY_VERIFY(s.canvas().backendText().startsWith("CPU · "));
        QVERIFY(s.canvas().backendNotice().contains("CUDA stopped"));
    }
    COMPARE_DEVICE_LEFT(device);
}

int main(int argc, char **argv)
{
    if (!qEnvironmentVariableIsSet(contextsApart)) // as main.cpp of the program has it
        QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    prepareOpenGl();
    if (qEnvironmentVariableIsEmpty("DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen"); // so that it can say why it does nothing
    QApplication app(argc, argv);
    TestDeviceWindow test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_device_window.moc"
