// render --tiles: what it writes, what it refuses, and that a run that was killed or stopped goes on.
#include "cli_pictures.h"

#include "tests/files.h"
#include "tests/trials.h"

#include <QDirIterator>
#include <QRandomGenerator>

#include <csignal>
#include <thread>

#include <sys/file.h>

using namespace suffuse;

class TestCliTiles : public CliPictures {
    Q_OBJECT

    QStringList tiles(const QString &out, const QStringList &more = {}) const
    {
        return QStringList{"render", path("a.json"), "--tiles", path(out), "--size", "400x300", "--backend", "cpu"} +
               more;
    }

    /// Starts a run and sends it a signal soon, or as soon as there is a file; how it ended.
    static CliOutcome signalled(const QStringList &arguments, int signal, int microseconds, const QString &file = {})
    {
        QProcess process;
        process.start(QStringLiteral(SUFFUSE_BIN_DIR "/suffuse-cli"), arguments);
        CliOutcome outcome;
        if (!process.waitForStarted())
            return outcome;
        do
            std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
        while (!file.isEmpty() && !QFile::exists(file) && process.state() == QProcess::Running &&
               !process.waitForFinished(0));
        ::kill(pid_t(process.processId()), signal);
        process.waitForFinished();
        outcome.code = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
        outcome.err = process.readAllStandardError();
        return outcome;
    }

private slots:
    void initTestCase() { prepare(); }

    void theSamePixels()
    {
        const FloatPicture whole = rendered({"--size", "400x300", "--depth", "16", "--transparent"}, "whole.png");
        const CliOutcome outcome =
            runCli(tiles("a.tif", {"--depth", "16", "--transparent", "--tile", "64", "--stats"}));
        QVERIFY2(outcome.code == 0, qPrintable(outcome.text()));
        const QJsonObject stats = outcome.json();
        QCOMPARE(stats["levels"].toInt(), 4);
        QCOMPARE(stats["tiles"].toInt(), 35 + 12 + 4 + 1);
        QCOMPARE(stats["kept"].toInt(), 0);
        QVERIFY(stats["bytes"].toInt() > 0);
        const FloatPicture tiled = picture("a.tif");
        QVERIFY(tiled.width == 400 && tiled.rgba == whole.rgba);
        QVERIFY(!QFile::exists(path("a.tif.part")) && !QFile::exists(path("a.tif.journal")));
        // It is one file, which the same command draws again and replaces, as -o does.
        const QByteArray bytes = bytesOf(path("a.tif"));
        QVERIFY(writeFile(path("a.tif"), "something else"));
        const CliOutcome again =
            runCli(tiles("a.tif", {"--depth", "16", "--transparent", "--tile", "64", "--threads", "1", "--stats"}));
        QVERIFY2(again.code == 0, qPrintable(again.text()));
        QCOMPARE(again.json()["kept"].toInt(-1), 0);
        QCOMPARE(bytesOf(path("a.tif")).size(), bytes.size());
        QVERIFY(picture("a.tif").rgba == whole.rgba);
    }

    void folders()
    {
        QCOMPARE(runCli(tiles("site")).code, 0);
        QCOMPARE(filesIn(path("site")), QStringList({"index.dzi", "index.html", "index_files"}));
        QVERIFY(bytesOf(path("site/index_files/9/1_1.jpg")).startsWith("\xFF\xD8"));
        QVERIFY(bytesOf(path("site/index.dzi")).contains("Format=\"jpg\" Overlap=\"1\" TileSize=\"254\""));
        // All of it is there, and another picture is not mixed in.
        QCOMPARE(runCli(tiles("site", {"--stats"})).json()["sheets"].toInt(-1), 0);
        const CliOutcome other = runCli(tiles("site", {"--quality", "50"}));
        QCOMPARE(other.code, 1);
        QVERIFY2(other.err.contains("of another picture"), qPrintable(other.text()));
        QVERIFY(QDir().mkpath(path("mine_files/photos")));
        const CliOutcome mine = runCli(tiles("mine.dzi"));
        QCOMPARE(mine.code, 1);
        QVERIFY2(mine.err.contains("something else"), qPrintable(mine.text()));
    }

    /// A page that somebody else wrote stays; our own is replaced.
    void pages()
    {
        const QByteArray own = "<!DOCTYPE html>\n<html lang=\"en\">\n<p>My photographs";
        QVERIFY(QDir().mkpath(path("web")));
        for (const QString &page : {QStringLiteral("web/index.html"), QStringLiteral("photos.html")}) {
            QVERIFY(writeFile(path(page), own));
            const QString out = page.startsWith("web") ? QStringLiteral("web") : QStringLiteral("photos.dzi");
            for (const CliOutcome &outcome :
                 {runCli(tiles(out)), runCli({"farm", "plan", path("a.json"), "-o", path("farm-of-" + out), "--tiles",
                                              path(out), "--size", "40x30", "--backend", "cpu"})}) {
                QCOMPARE(outcome.code, 1);
                QVERIFY2(outcome.err.contains(QFile::encodeName(path(page)) + ": there is something else"),
                         qPrintable(outcome.text()));
            }
            QCOMPARE(bytesOf(path(page)), own);
        }
        QVERIFY(!QFile::exists(path("web/index_files")) && !QFile::exists(path("photos_files")));
        QVERIFY(QFile::remove(path("photos.html")));
        QCOMPARE(runCli(tiles("photos.dzi")).code, 0);
        const QByteArray page = bytesOf(path("photos.html"));
        QVERIFY(writeFile(path("photos.html"), QByteArray(page).replace("Suffuse ", "Suffuse 0")));
        QCOMPARE(runCli(tiles("photos.dzi")).code, 0);
        QCOMPARE(bytesOf(path("photos.html")), page);
    }

    void oneAtATime()
    {
        QFile journal(path("two.tif.journal"));
        QVERIFY(journal.open(QIODevice::WriteOnly));
        QCOMPARE(::flock(journal.handle(), LOCK_EX), 0);
        const CliOutcome second = runCli(tiles("two.tif"));
        QCOMPARE(second.code, 1);
        QVERIFY2(second.err.contains("another program is drawing"), qPrintable(second.text()));
        journal.close();
        QCOMPARE(runCli(tiles("two.tif")).code, 0);
    }

    void refused_data()
    {
        QTest::addColumn<QString>("out");
        QTest::addColumn<QStringList>("more");
        QTest::addColumn<QString>("message");
        QTest::newRow("ending") << "a.png" << QStringList() << ".dzi or .tif";
        QTest::newRow("alpha in JPEG") << "b.dzi" << QStringList{"--format", "jpg", "--transparent"} << "--format png";
        QTest::newRow("format") << "b.dzi" << QStringList{"--format", "webp"} << "jpg or png";
        QTest::newRow("format of TIFF") << "b.tif" << QStringList{"--format", "jpg"} << "is for Deep Zoom";
        QTest::newRow("depth") << "b.tif" << QStringList{"--depth", "half"} << "8 or 16 bits";
        QTest::newRow("tile of TIFF") << "b.tif" << QStringList{"--tile", "100"} << "multiple of 16";
        QTest::newRow("tile") << "b.dzi" << QStringList{"--tile", "5"} << "from 16 to 4096";
        QTest::newRow("-o") << "b.dzi" << QStringList{"-o", "c.png"} << "not for --tiles";
        QTest::newRow("too large") << "b.dzi" << QStringList{"--size", "2147483647"} << "at most 2147479552 a side";
    }
    void refused()
    {
        QFETCH(QString, out);
        QFETCH(QStringList, more);
        QFETCH(QString, message);
        QStringList arguments = tiles(out, more);
        if (more.contains("--size"))
            arguments.removeAt(arguments.indexOf("--size") + 1), arguments.removeAt(arguments.indexOf("--size"));
        const CliOutcome outcome = runCli(arguments);
        QCOMPARE(outcome.code, 2);
        QVERIFY2(QString::fromUtf8(outcome.err).contains(message), qPrintable(outcome.text()));
        QVERIFY(!QFile::exists(path(out)));
    }

    /// An empty name is not the root of the file system, and an ending alone is not a name.
    void nameless()
    {
        for (const QString &out : {QString(), path(".dzi"), path(".tif"), QStringLiteral(".TIFF")})
            for (const QStringList &command :
                 {QStringList{"render", path("a.json")}, QStringList{"farm", "plan", path("a.json"), "-o", path("farm")}}) {
                const CliOutcome outcome = runCli(command + QStringList{"--tiles", out, "--size", "40x30"});
                QCOMPARE(outcome.code, 2);
                QVERIFY2(outcome.err.contains("the name is missing"), qPrintable(outcome.text()));
            }
        QVERIFY(!QFile::exists(path("_files")) && !QFile::exists(path("farm")));
    }

    /// The largest picture there is begins, with the memory of any other, and is stopped.
    void largest()
    {
        const QStringList arguments{"render",     path("a.json"), "--tiles", path("huge.tif"), "--size",
                                    "2147479552", "--backend",    "cpu",     "--threads",      "1"};
        const CliOutcome stopped = signalled(arguments, SIGTERM, 20'000, path("huge.tif.journal"));
        QVERIFY2(stopped.code == 1 && stopped.err.contains("the same command goes on"), stopped.err.constData());
        QVERIFY(!QFile::exists(path("huge.tif")));
    }

    void goesOn_data()
    {
        QTest::addColumn<QString>("out");
        QTest::addColumn<int>("signal");
        QTest::newRow("Deep Zoom, killed") << "k.dzi" << SIGKILL;
        QTest::newRow("Deep Zoom, stopped") << "s.dzi" << SIGINT;
        QTest::newRow("TIFF, killed") << "k.tif" << SIGKILL;
        QTest::newRow("TIFF, stopped") << "s.tif" << SIGTERM;
    }
    void goesOn()
    {
        QFETCH(QString, out);
        QFETCH(int, signal);
        const QStringList how{"--tile", "64", "--sheet", "64", "--threads", "1", "--stats"};
        QRandomGenerator random(4 + firstSeed());
        for (int i = trials(2, 100); i > 0; --i) {
            const CliOutcome ended = signalled(tiles(out, how), signal, int(random.bounded(60'000)));
            QVERIFY2(signal == SIGKILL || ended.code == 0 || ended.code == 1 || ended.code == -1,
                     ended.err.constData());
        }
        QCOMPARE(runCli(tiles(out, how)).code, 0);
        const QString calm = "calm-" + out;
        QCOMPARE(runCli(tiles(calm, how)).code, 0);
        if (out.endsWith(".tif")) {
            QVERIFY(picture(out).rgba == picture(calm).rgba);
            return;
        }
        const QString a = path(out.chopped(4) + "_files/"), b = path(calm.chopped(4) + "_files/");
        int files = 0;
        for (QDirIterator it(b, {"*.jpg"}, QDir::Files, QDirIterator::Subdirectories); it.hasNext(); ++files) {
            const QString name = it.next().mid(b.size());
            QCOMPARE(bytesOf(a + name), bytesOf(b + name));
        }
        QVERIFY(files > 50);
    }
};

QTEST_GUILESS_MAIN(TestCliTiles)
#include "test_cli_tiles.moc"
