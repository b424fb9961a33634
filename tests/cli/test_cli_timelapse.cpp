// Numbered frames of a painting being painted, by suffuse-cli.
#include "cli_pictures.h"

#include <unistd.h>

using namespace suffuse;

class TestCliTimelapse : public CliPictures {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }
    void framesAreThoseOfTheirMoments();
    void mistakes_data();
    void mistakes();
    void missingFolder();
    void stopped();
};

void TestCliTimelapse::framesAreThoseOfTheirMoments()
{
    QVERIFY(QDir().mkdir(path("film")));
    const CliOutcome made = runCli({"timelapse", path("a.json"), "-o", path("film/f%03d.png"), "--duration", "2",
                                    "--fps", "6", "--size", "80x60", "--stats"});
    QVERIFY2(made.code == 0, qPrintable(made.text()));
    QCOMPARE(made.json()["frames"].toInt(), 12);
    QVERIFY(made.json()["tilesEvaluated"].toInt() < made.json()["tiles"].toInt()); // only what changed
    QStringList expected;
    for (int i = 1; i <= 12; ++i)
        expected << QStringLiteral("f%1.png").arg(i, 3, 10, QLatin1Char('0'));
    QCOMPARE(filesIn(path("film")), expected);
    // The last frame is the finished picture, and each frame that of its moment: it is over at 3 s, nothing rests.
    const auto frame = [&](int i) { return picture(QStringLiteral("film/") + expected[i - 1]); };
    QVERIFY(frame(12).rgba == rendered({"--size", "80x60"}, "end.png").rgba);
    QVERIFY(frame(4).rgba == rendered({"--size", "80x60", "--time", "1"}, "second.png").rgba);
    QVERIFY(frame(4).rgba != frame(5).rgba);
    // Again, over what is there.
    const CliOutcome again = runCli({"timelapse", path("a.json"), "-o", path("film/f%03d.png"), "--duration", "1",
                                     "--fps", "2", "--transparent", "--idle", "0"});
    QVERIFY2(again.code == 0, qPrintable(again.text()));
    QCOMPARE(filesIn(path("film")), expected);
    QCOMPARE(frame(2).width, 40);
    QCOMPARE(frame(2).at(0, 0)[3], 0.0f);
    QCOMPARE(frame(3).width, 80);
}

void TestCliTimelapse::mistakes_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QString>("says");
    QTest::newRow("no number") << QStringList{"-o", path("x/frame.png")} << "%05d";
    QTest::newRow("two numbers") << QStringList{"-o", path("x/%d-%d.png")} << "%05d";
    QTest::newRow("no name") << QStringList{} << "-o";
    QTest::newRow("format") << QStringList{"-o", path("x/%d.gif")} << "gif";
    QTest::newRow("duration") << QStringList{"-o", path("x/%d.png"), "--duration", "0"} << "--duration";
    QTest::newRow("too many") << QStringList{"-o", path("x/%d.png"), "--duration", "1000000"} << "too many";
    QTest::newRow("idle") << QStringList{"-o", path("x/%d.png"), "--idle", "-1"} << "--idle";
    QTest::newRow("alpha") << QStringList{"-o", path("x/%d.jpg"), "--transparent"} << "jpg";
}

void TestCliTimelapse::mistakes()
{
    QFETCH(QStringList, options);
    QFETCH(QString, says);
    const CliOutcome outcome = runCli(QStringList{"timelapse", path("a.json")} + options);
    QVERIFY2(outcome.code == 2, qPrintable(outcome.text()));
    QVERIFY2(QString::fromUtf8(outcome.err).contains(says, Qt::CaseInsensitive), qPrintable(outcome.text()));
    QVERIFY(!QFileInfo::exists(path("x")));
}

/// As `render` has it: nobody's typing mistake becomes a folder.
void TestCliTimelapse::missingFolder()
{
    for (const QString name : {"nodir/f%03d.png", "nodir/film.webp"}) {
        const CliOutcome film = runCli({"timelapse", path("a.json"), "-o", path(name), "--duration", "1"});
        QVERIFY2(film.code == 1 && film.err.contains("nodir does not exist"), qPrintable(film.text()));
    }
    const CliOutcome picture = runCli({"render", path("a.json"), "-o", path("nodir/o.png")});
    QVERIFY2(picture.code == 1 && picture.err.contains("nodir does not exist"), qPrintable(picture.text()));
    QVERIFY(!QFileInfo::exists(path("nodir")));
}

void TestCliTimelapse::stopped()
{
    QProcess process;
    QVERIFY(QDir().mkdir(path("stopped")));
    process.start(
        QStringLiteral(SUFFUSE_BIN_DIR "/suffuse-cli"),
        {"timelapse", path("a.json"), "-o", path("stopped/%d.png"), "--duration", "1000", "--size", "400x300"});
    QVERIFY(process.waitForStarted());
    QTRY_VERIFY(filesIn(path("stopped")).size() == 1); // the hidden folder of frames
    process.terminate();
    QVERIFY(process.waitForFinished());
    QCOMPARE(process.exitCode(), 1);
    QVERIFY(process.readAllStandardError().contains("nothing was written"));
    QCOMPARE(filesIn(path("stopped")), QStringList());
    if (::geteuid() == 0)
        return; // may write anywhere
    QVERIFY(QDir().mkdir(path("closed")));
    QVERIFY(QFile::setPermissions(path("closed"), QFileDevice::ReadOwner | QFileDevice::ExeOwner));
    const CliOutcome closed = runCli({"timelapse", path("a.json"), "-o", path("closed/%d.png"), "--duration", "1"});
    QVERIFY2(closed.code == 1 && closed.err.contains("closed"), qPrintable(closed.text()));
}

QTEST_GUILESS_MAIN(TestCliTimelapse)
#include "test_cli_timelapse.moc"
