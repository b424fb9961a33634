// A second start gives its files to the program that runs, by a session bus of this test's own.
#include "app/window/files/running_program.h"
#include "model/formats/files.h"
#include "tests/app/session.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDialog>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QUrl>

#include <future>

using namespace suffuse;

class TestRunningProgram : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const QString daemon = QStandardPaths::findExecutable("dbus-daemon");
        if (daemon.isEmpty())
            QSKIP("dbus-daemon is not installed");
        m_daemon.start(daemon, {"--session", "--nofork", "--nopidfile", "--print-address=1",
                                "--address=unix:dir=" + m_folder.path()});
        QVERIFY(m_daemon.waitForReadyRead(waitMs));
        qputenv("DBUS_SESSION_BUS_ADDRESS", m_daemon.readLine().trimmed());
        for (const QString &name : {QString("lake.suffuse"), QString("ä 湖#1.suffuse")}) {
            Painting painting;
            painting.canvas.width = 300;
            QVERIFY(savePainting(painting, path(name)));
        }
        QVERIFY(!handOver({{path("lake.suffuse")}})); // nobody runs yet
        QVERIFY(m_program.begin());
        RunningProgram other([] { return nullptr; });
        QVERIFY(!other.begin()); // there is one already
    }

    void cleanup()
    {
        for (MainWindow *window : windows())
            delete window;
    }

    void cleanupTestCase()
    {
        m_daemon.kill();
        m_daemon.waitForFinished();
    }

    void filesAreOpened()
    {
        QVERIFY(asked({{path("lake.suffuse"), path("ä 湖#1.suffuse")}}));
        QTRY_COMPARE_WITH_TIMEOUT(names(), QStringList({"lake.suffuse", "ä 湖#1.suffuse"}), waitMs);
        QVERIFY(asked({{path("lake.suffuse")}})); // It is open already.
        QVERIFY(asked({})); // The window is raised, and no other one is made.
        QVERIFY(asked({{}, true}));
        QTRY_COMPARE_WITH_TIMEOUT(names(), QStringList({"", "lake.suffuse", "ä 湖#1.suffuse"}), waitMs);
    }

    /// As desktops send it, without a window so far.
    void desktopsAsk()
    {
        const QStringList uris{QUrl::fromLocalFile(path("ä 湖#1.suffuse")).toString(QUrl::FullyEncoded),
                               "https://example.org/lake.suffuse"};
        QVERIFY(sent("Open", {uris, QVariantMap{{"desktop-startup-id", "x"}}}));
        QTRY_COMPARE_WITH_TIMEOUT(names(), QStringList({"ä 湖#1.suffuse"}), waitMs);
        QVERIFY(sent("ActivateAction", {"NewPainting", QVariantList(), QVariantMap()}));
        QTRY_COMPARE_WITH_TIMEOUT(names(), QStringList({"", "ä 湖#1.suffuse"}), waitMs);
        QVERIFY(sent("Activate", {QVariantMap()}));
        QVERIFY(!sent("Quit", {}));
        QCOMPARE(names().size(), 2);
    }

    void aDialogIsNotDisturbed()
    {
        QVERIFY(asked({}));
        QTRY_COMPARE_WITH_TIMEOUT(names(), QStringList({""}), waitMs);
        QDialog dialog(windows().front());
        dialog.setModal(true);
        dialog.show();
        QTRY_COMPARE_WITH_TIMEOUT(QApplication::activeModalWidget(), &dialog, waitMs);
        QVERIFY(asked({{path("lake.suffuse")}}));
        for (int i = 0; i < 50; ++i)
            QCoreApplication::processEvents();
        QCOMPARE(names(), QStringList({""}));
        dialog.close();
        QTRY_COMPARE_WITH_TIMEOUT(names(), QStringList({"lake.suffuse"}), waitMs);
    }

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }

    static QList<MainWindow *> windows()
    {
        QList<MainWindow *> list;
        for (QWidget *widget : QApplication::topLevelWidgets())
            if (auto *window = qobject_cast<MainWindow *>(widget))
                list << window;
        return list;
    }
    /// The files of all windows, in order.
    static QStringList names()
    {
        QStringList list;
        for (MainWindow *window : windows())
            list << QFileInfo(window->editor().filePath()).fileName();
        list.sort();
        return list;
    }

    /// What another process's start does, while this one's events go on.
    static bool asked(const StartRequest &request)
    {
        return outOfTheWay([&] { return handOver(request); });
    }
    static bool sent(const QString &method, const QVariantList &arguments)
    {
        QDBusMessage message = QDBusMessage::createMethodCall("org.suffuse.Suffuse", "/org/suffuse/Suffuse",
                                                              "org.freedesktop.Application", method);
        message.setArguments(arguments);
        return outOfTheWay([&] {
            bool isAnswered = false;
            {
                const QDBusConnection bus = QDBusConnection::connectToBus(QDBusConnection::SessionBus, "desktop");
                isAnswered = bus.call(message).type() == QDBusMessage::ReplyMessage;
            }
            QDBusConnection::disconnectFromBus("desktop");
            return isAnswered;
        });
    }
    static bool outOfTheWay(const std::function<bool()> &task)
    {
        std::future<bool> result = std::async(std::launch::async, task);
        while (result.wait_for(std::chrono::milliseconds(5)) != std::future_status::ready)
            QCoreApplication::processEvents();
        return result.get();
    }

    QTemporaryDir m_folder;
    QProcess m_daemon;
    RunningProgram m_program{[] {
        auto *window = new MainWindow;
        window->resize(900, 700);
        window->show();
        return window;
    }};
};

QTEST_MAIN(TestRunningProgram)
#include "test_running_program.moc"
