// Many machines draw one picture: the bits are the same however the work is divided, whatever is killed, damaged or
// full. SUFFUSE_TRIALS=100, or SUFFUSE_LONG=1, kills more workers.
#include "cli_process.h"

#include "tests/files.h"
#include "tests/trials.h"

#include <QCryptographicHash>
#include <QDirIterator>
#include <QJsonArray>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QTest>

#include <thread>

#include <sys/time.h>

using namespace suffuse;

namespace {

/// A folder with a painting, a farm in it, and what is drawn.
class Farm {
public:
    explicit Farm(const QStringList &what)
    {
        writeFile(path("a.json"), smallPainting());
        QStringList arguments{"farm", "plan", path("a.json"), "-o", path("farm"), "--backend", "cpu"};
        for (QString each : what)
            arguments << each.replace("OUT", path("out"));
        planned = runCli(arguments);
    }

    QString path(const QString &name) const { return m_folder.filePath(name); }
    CliOutcome run(const QString &task, const QStringList &more = {}) const
    {
        return runCli(QStringList{"farm", "run", path("farm"), "--task", task, "--threads", "2"} + more);
    }
    CliOutcome does(const char *command) const { return runCli({"farm", command, path("farm")}); }
    qint64 drawn(const QString &task) const { return run(task, {"--stats"}).json()["drawn"].toInteger(-1); }
    /// All that was drawn, with its names.
    QByteArray hash() const
    {
        QStringList names;
        for (QDirIterator it(path("out"), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories); it.hasNext();)
            if (const QString name = it.next(); !name.endsWith(".farm")) // it says whose this is
                names << name;
        names.sort();
        QCryptographicHash hash(QCryptographicHash::Sha256);
        for (const QString &name : names) {
            hash.addData(name.mid(path("out").size()).toUtf8());
            hash.addData(bytesOf(name));
        }
        return hash.result().toHex() + ' ' + QByteArray::number(names.size());
    }
    /// Lines of all journals that say that something is finished.
    int records() const
    {
        int count = 0;
        for (const QString &name : filesIn(path("farm/journals")))
            count += int(bytesOf(path("farm/journals/" + name)).count("\nsheet "));
        return count;
    }

    CliOutcome planned;

private:
    QTemporaryDir m_folder;
};

const QStringList deepZoom{"--tiles", "OUT/a.dzi", "--size", "400x300",  "--tile",
                           "32",      "--sheet",   "64",     "--format", "png"};
const QStringList tiff{"--tiles", "OUT/a.tif", "--size", "400x300", "--tile", "32", "--sheet", "64"};
const QStringList frames{"--frames", "OUT/f%03d.png", "--size", "80x60", "--fps", "5", "--duration", "2.6"};

void flipByte(const QString &path, qint64 at)
{
    QByteArray bytes = bytesOf(path);
    bytes[at] = char(bytes[at] ^ 16);
    writeFile(path, bytes);
}

/// Runs as on a disk on which no file may be larger than so many kilobytes.
CliOutcome runOnFullDisk(const QStringList &arguments, int kilobytes)
{
    QProcess process;
    process.start("/bin/bash",
                  QStringList{"-c", QString("trap '' XFSZ; ulimit -f %1; exec \"$0\" \"$@\"").arg(kilobytes),
                              QStringLiteral(SUFFUSE_BIN_DIR "/suffuse-cli")} +
                      arguments);
    CliOutcome outcome;
    if (process.waitForFinished(120'000) && process.exitStatus() == QProcess::NormalExit)
        outcome.code = process.exitCode();
    outcome.err = process.readAllStandardError();
    return outcome;
}

} // namespace

class TestFarm : public QObject {
    Q_OBJECT

private slots:
    void sameHashes_data()
    {
        QTest::addColumn<QStringList>("what");
        QTest::newRow("deep zoom") << deepZoom;
        QTest::newRow("tiff") << tiff;
        QTest::newRow("frames") << frames;
    }
    void sameHashes()
    {
        QFETCH(QStringList, what);
        QByteArray alone;
        for (const int tasks : {1, 3, 8}) {
            const Farm farm(what);
            QVERIFY2(farm.planned.code == 0, qPrintable(farm.planned.text()));
            QCOMPARE(farm.does("status").code, 1);
            for (int i = tasks; i >= 1; --i) {
                QCOMPARE(farm.does("join").code, 1);
                const CliOutcome ran = farm.run(QString("%1/%2").arg(i).arg(tasks));
                QVERIFY2(ran.code == 0, qPrintable(ran.text()));
            }
            QCOMPARE(farm.does("status").code, 0);
            const CliOutcome joined = farm.does("join");
            QVERIFY2(joined.code == 0, qPrintable(joined.text()));
            alone = tasks == 1 ? farm.hash() : alone;
            QCOMPARE(farm.hash(), alone);
            QCOMPARE(farm.drawn("1/1"), qint64(0));
        }
    }

    /// A farm's tiles are those of `render --tiles`, its frames those of `timelapse`.
    void asOneMachineDraws()
    {
        QTemporaryDir folder;
        const Farm tiles(tiff), film(frames);
        QCOMPARE(tiles.run("1/1").code, 0);
        QCOMPARE(tiles.does("join").code, 0);
        QCOMPARE(runCli({"render", tiles.path("a.json"), "--tiles", folder.filePath("b.tif"), "--size", "400x300",
                         "--tile", "32", "--sheet", "64", "--threads", "1", "--backend", "cpu"})
                     .code,
                 0);
        // Sheets of one machine may be finished in another order.
        QCOMPARE(bytesOf(folder.filePath("b.tif")).size(), bytesOf(tiles.path("out/a.tif")).size());
        QCOMPARE(film.run("1/1").code, 0);
        QCOMPARE(runCli({"timelapse", film.path("a.json"), "-o", folder.filePath("f%03d.png"), "--size", "80x60",
                         "--fps", "5", "--duration", "2.6", "--backend", "cpu"})
                     .code,
                 0);
        for (const QString &name : filesIn(folder.path()))
            if (name.endsWith(".png"))
                QCOMPARE(bytesOf(folder.filePath(name)), bytesOf(film.path("out/" + name)));
        QCOMPARE(filesIn(film.path("out")).filter(QRegularExpression("png$")).size(), 13);
    }

    /// Two farms that are given one name would overwrite each other's pieces.
    void onePictureHasOneFarm_data() { sameHashes_data(); }
    void onePictureHasOneFarm()
    {
        QFETCH(QStringList, what);
        const Farm farm(what);
        QCOMPARE(farm.planned.code, 0);
        const auto plan = [&](const QString &folder) {
            QStringList arguments{"farm", "plan", farm.path("a.json"), "-o", farm.path(folder), "--backend", "cpu"};
            for (QString each : what)
                arguments << each.replace("OUT", farm.path("out"));
            return runCli(arguments);
        };
        QCOMPARE(plan("farm").code, 0); // the same once more
        const CliOutcome refused = plan("other");
        QCOMPARE(refused.code, 1);
        QVERIFY2(refused.err.contains(("belongs to the farm in " + farm.path("farm")).toUtf8()) &&
                     refused.err.contains("Choose another name"),
                 qPrintable(refused.text()));
        QVERIFY(!QFile::exists(farm.path("other/plan.json")));

        // Where the other one was planned all the same, the first one notices.
        for (const QString &mark : filesIn(farm.path("out")).filter(".farm"))
            QVERIFY(QFile::remove(farm.path("out/" + mark)));
        QCOMPARE(plan("other").code, 0);
        for (const CliOutcome &outcome : {farm.run("1/1"), farm.does("join")}) {
            QCOMPARE(outcome.code, 1);
            QVERIFY2(outcome.err.contains("belongs to the farm in"), qPrintable(outcome.text()));
        }

        // Once the other one's folder is gone, the picture is nobody's.
        QVERIFY(QDir(farm.path("other")).removeRecursively());
        QCOMPARE(farm.run("1/1").code, 0);
        QCOMPARE(farm.does("join").code, 0);
    }

    void statusNamesFrames()
    {
        const Farm farm(frames);
        QCOMPARE(farm.run("2/6").code, 0);
        QCOMPARE(farm.run("4/6").code, 0);
        const CliOutcome status = farm.does("status");
        QCOMPARE(status.code, 1);
        QVERIFY2(status.out.contains("4 of 13 pieces are there"), status.out.constData());
        QVERIFY2(status.out.contains("frames 1, 2, 5, 6, 9-13 are missing"), status.out.constData());
        QCOMPARE(runCli({"farm", "status", farm.path("farm"), "--json"}).json()["missing"].toInt(), 9);
    }

    void damageIsFound_data() { sameHashes_data(); }
    void damageIsFound()
    {
        QFETCH(QStringList, what);
        const Farm farm(what);
        QCOMPARE(farm.run("1/1").code, 0);
        QString victim = what == frames ? farm.path("out/f007.png") : farm.path("out/a_files/9/5_5.png");
        if (what == tiff)
            victim = farm.path("farm/packs/" + filesIn(farm.path("farm/packs")).value(0));
        flipByte(victim, bytesOf(victim).size() - 30);
        const CliOutcome verified = farm.does("verify"), joined = farm.does("join");
        QCOMPARE(verified.code, 1);
        QVERIFY2(verified.out.contains("are missing"), qPrintable(verified.text()));
        QVERIFY2(verified.out.contains((victim + ": is damaged\n").toUtf8()), qPrintable(verified.text()));
        QCOMPARE(verified.out.count(": is "), 1);
        QCOMPARE(joined.code, 1);
        QVERIFY2(joined.err.contains("Nothing was joined"), qPrintable(joined.text()));
        QCOMPARE(farm.drawn("1/1"), qint64(1));
        QCOMPARE(farm.does("verify").code, 0);
        QCOMPARE(farm.does("join").code, 0);
        const Farm other(what);
        QCOMPARE(other.run("1/1").code, 0);
        QCOMPARE(other.does("join").code, 0);
        QCOMPARE(farm.hash(), other.hash());
    }

    /// Each file that is not what a worker wrote down, and a journal that lost lines, is named.
    void lostFilesAreNamed()
    {
        const Farm farm(deepZoom);
        QCOMPARE(farm.run("1/2").code, 0);
        QVERIFY2(!farm.does("verify").out.contains(": is "), "of sheets that nobody drew, no files are named");
        QCOMPARE(farm.run("2/2").code, 0);
        const QString damaged = farm.path("out/a_files/9/5_5.png");
        flipByte(damaged, 40);
        QVERIFY(QFile::remove(farm.path("out/a_files/9/5_4.png")));
        const QJsonObject json = runCli({"farm", "verify", farm.path("farm"), "--json"}).json();
        const QJsonArray files = json["files"].toArray();
        QCOMPARE(files.size(), 2);
        QCOMPARE(files[0]["path"].toString(), farm.path("out/a_files/9/5_4.png"));
        QCOMPARE(files[0]["state"].toString(), QString("missing"));
        QCOMPARE(files[1]["path"].toString(), damaged);
        QCOMPARE(files[1]["state"].toString(), QString("damaged"));
        for (const QString &name : filesIn(farm.path("out/a_files/9")))
            QFile::remove(farm.path("out/a_files/9/" + name));
        const CliOutcome many = farm.does("verify");
        QCOMPARE(many.out.count(": is missing\n"), 20);
        QVERIFY2(many.out.contains("more files are missing or damaged; farm verify --json names all."),
                 qPrintable(many.text()));
        QVERIFY(farm.drawn("1/1") > 1);
        QCOMPARE(farm.does("verify").code, 0);
    }

    void damagedJournalsAreTold()
    {
        const Farm farm(frames);
        QCOMPARE(farm.run("1/2").code, 0);
        QCOMPARE(farm.run("2/2").code, 0);
        const QString name = farm.path("farm/journals/" + filesIn(farm.path("farm/journals"))[0]);
        const QByteArray journal = bytesOf(name);
        const qsizetype second = journal.indexOf("\nsheet ", journal.indexOf("\nsheet ") + 1) + 3;
        // What is cut off at the end is what a worker leaves that is killed: nothing is wrong with it.
        QVERIFY(writeFile(name, journal.chopped(3)));
        const CliOutcome cut = farm.does("status");
        QCOMPARE(cut.code, 1);
        QVERIFY2(!cut.out.contains("damaged"), qPrintable(cut.text()));
        QVERIFY(writeFile(name, journal));
        flipByte(name, second);
        for (const char *command : {"status", "verify"}) {
            const CliOutcome told = farm.does(command);
            QCOMPARE(told.code, 1);
            QVERIFY2(told.out.contains((name + ": 1 line of this journal is damaged").toUtf8()),
                     qPrintable(told.text()));
            QVERIFY2(told.out.contains("Run the tasks again"), qPrintable(told.text()));
        }
        QCOMPARE(farm.drawn("1/1"), qint64(1));
        const CliOutcome good = farm.does("verify");
        QVERIFY2(good.code == 0 && !good.out.contains("damaged"), qPrintable(good.text()));
        // Without the line that says whose it is, it says nothing.
        flipByte(name, journal.indexOf("of ") + 5);
        QCOMPARE(runCli({"farm", "verify", farm.path("farm"), "--json"}).json()["journals"].toArray().size(), 1);
        QVERIFY(farm.drawn("1/1") > 1);
        QCOMPARE(farm.does("join").code, 0);
    }

    void mixesAreRefused()
    {
        const Farm farm(deepZoom);
        const QString path = farm.path("farm/plan.json");
        const QByteArray plan = bytesOf(path);
        QVERIFY(plan.contains("\"backend\": \"CPU\""));
        for (const char *key : {"build", "encoder", "device"}) {
            QJsonObject json = QJsonDocument::fromJson(plan).object(), by = json["by"].toObject();
            by[QLatin1String(key)] = "another";
            json["by"] = by;
            QVERIFY(writeFile(path, QJsonDocument(json).toJson()));
            const CliOutcome refused = farm.run("1/2");
            QCOMPARE(refused.code, 1);
            QVERIFY2(refused.err.contains(key) && refused.err.contains("other bits"), qPrintable(refused.text()));
            QVERIFY(filesIn(farm.path("farm/journals")).isEmpty());
        }
        QVERIFY(writeFile(path, plan));
        QCOMPARE(farm.run("1/2").code, 0);

        // Another painting under the same name.
        QVERIFY(writeFile(farm.path("a.json"), smallPainting().replace("\"density\": 6", "\"density\": 7")));
        const CliOutcome changed = farm.run("2/2");
        QCOMPARE(changed.code, 1);
        QVERIFY2(changed.err.contains("has changed since"), qPrintable(changed.text()));
        const CliOutcome replanned =
            runCli({"farm", "plan", farm.path("a.json"), "-o", farm.path("farm"), "--tiles", farm.path("b.dzi")});
        QCOMPARE(replanned.code, 1);
        QVERIFY2(replanned.err.contains("another plan"), qPrintable(replanned.text()));

        // What a machine wrote that computes wrongly.
        QVERIFY(writeFile(farm.path("a.json"), smallPainting()));
        QCOMPARE(farm.run("2/2").code, 0);
        const QByteArray journal = bytesOf(farm.path("farm/journals/" + filesIn(farm.path("farm/journals"))[0]));
        const auto line = [](const QByteArray &text) {
            const QByteArray hash = QCryptographicHash::hash(text, QCryptographicHash::Sha1).left(8);
            return text + " =" + QByteArray::number(hash.toHex().toULongLong(nullptr, 16), 16) + '\n';
        };
        const qsizetype at = journal.indexOf("sheet ");
        QByteArray wrong = journal.mid(at, journal.indexOf(" =", at) - at);
        wrong[wrong.size() - 1] = wrong.endsWith('0') ? '1' : '0';
        QVERIFY(writeFile(farm.path("farm/journals/0-9-faulty-1.journal"), journal.left(at) + line(wrong)));
        const CliOutcome disputed = farm.does("join");
        QCOMPARE(disputed.code, 1);
        QVERIFY2(disputed.err.contains("two workers made different bits"), qPrintable(disputed.text()));
    }

    /// Wherever a worker is killed, what it finished stays, and no piece that was finished is drawn again.
    void kills()
    {
        const int kills = trials(4, 100);
        const Farm farm(deepZoom), calm(deepZoom);
        QCOMPARE(calm.run("1/1").code, 0);
        QCOMPARE(calm.does("join").code, 0);
        QRandomGenerator random(3 + firstSeed());
        for (int i = 0; i < kills; ++i) {
            QProcess worker;
            worker.start(
                QStringLiteral(SUFFUSE_BIN_DIR "/suffuse-cli"),
                {"farm", "run", farm.path("farm"), "--task", QString("%1/8").arg(1 + i % 8), "--threads", "1"});
            QVERIFY(worker.waitForStarted());
            std::this_thread::sleep_for(std::chrono::microseconds(random.bounded(150'000)));
            worker.kill();
            worker.waitForFinished();
        }
        const int before = farm.records();
        qint64 drawn = 0;
        for (int i = 1; i <= 8; ++i)
            drawn += farm.drawn(QString("%1/8").arg(i));
        const int pieces = calm.records();
        QCOMPARE(drawn, qint64(pieces - before));
        QCOMPARE(farm.records(), pieces);
        QCOMPARE(farm.does("join").code, 0);
        QCOMPARE(farm.hash(), calm.hash());
        qInfo("%d kills, %d of %d pieces had been finished", kills, before, pieces);
    }

    void fullDisks()
    {
        const Farm farm(tiff);
        const CliOutcome full = runOnFullDisk({"farm", "run", farm.path("farm")}, 8);
        QCOMPARE(full.code, 1);
        QVERIFY2(full.err.contains("the disk is full"), qPrintable(full.text()));
        QCOMPARE(farm.does("join").code, 1);
        QVERIFY(farm.drawn("1/1") > 0);
        const CliOutcome joined = runOnFullDisk({"farm", "join", farm.path("farm")}, 8);
        QCOMPARE(joined.code, 1);
        QVERIFY2(joined.err.contains("the disk is full"), qPrintable(joined.text()));
        QCOMPARE(filesIn(farm.path("out")), QStringList(".a.tif.farm"));
        QCOMPARE(farm.does("join").code, 0);
        QCOMPARE(filesIn(farm.path("out")), QStringList("a.tif"));

        QTemporaryDir folder;
        const QStringList tiles{"render", farm.path("a.json"), "--tiles",   folder.filePath("a.dzi"),
                                "--size", "400x300",           "--backend", "cpu"};
        const CliOutcome one = runOnFullDisk(tiles, 2);
        QCOMPARE(one.code, 1);
        QVERIFY2(one.err.contains("the disk is full"), qPrintable(one.text()));
        QVERIFY(!QFile::exists(folder.filePath("a.dzi")));
        QCOMPARE(runCli(tiles).code, 0);
        QVERIFY(QFile::exists(folder.filePath("a.dzi")));
    }

    void vanishedFoldersAndClocks()
    {
        const Farm farm(deepZoom);
        QCOMPARE(farm.run("1/2").code, 0);
        QVERIFY(QDir().rename(farm.path("out/a_files"), farm.path("away")));
        const CliOutcome gone = farm.run("2/2");
        QCOMPARE(gone.code, 1);
        QVERIFY2(gone.err.contains("does not exist"), qPrintable(gone.text()));
        QVERIFY(!QFile::exists(farm.path("out/a_files")));
        QCOMPARE(farm.does("join").code, 1);
        QVERIFY(!QFile::exists(farm.path("out/a.dzi")));
        QVERIFY(QDir().rename(farm.path("away"), farm.path("out/a_files")));
        QVERIFY(QDir().rename(farm.path("farm"), farm.path("away")));
        for (const char *command : {"run", "status", "verify", "join", "slurm"}) {
            const CliOutcome lost = farm.does(command);
            QCOMPARE(lost.code, 1);
            QVERIFY2(lost.err.contains("Is the shared folder there?"), qPrintable(lost.text()));
        }
        QVERIFY(QDir().rename(farm.path("away"), farm.path("farm")));
        // No time of a file means anything.
        int number = 0;
        for (QDirIterator it(farm.path("."), QDir::Files, QDirIterator::Subdirectories); it.hasNext();) {
            const timeval time{number++ % 2 ? 4'102'444'800 : 1, 0}, times[] = {time, time};
            QCOMPARE(::utimes(QFile::encodeName(it.next()).constData(), times), 0);
        }
        QCOMPARE(farm.run("2/2").code, 0);
        QCOMPARE(farm.drawn("1/1"), qint64(0));
        QCOMPARE(farm.does("join").code, 0);
    }

    /// Several paintings, and what is given to engines that others made.
    void jobs()
    {
        QTemporaryDir folder;
        QVERIFY(writeFile(folder.filePath("one.json"), smallPainting()) &&
                writeFile(folder.filePath("two.json"), smallPainting()));
        const QString plan = folder.filePath("farm");
        QStringList arguments{
            "farm", "plan",    folder.filePath("one.json"), folder.filePath("two.json"), "-o", plan, "--backend",
            "cpu",  "--tiles", folder.filePath("same.dzi")};
        QCOMPARE(runCli(arguments).code, 2);
        arguments.last() = folder.filePath("%s.tif");
        const CliOutcome planned = runCli(arguments);
        QVERIFY2(planned.code == 0 && planned.out.contains("2 paintings"), qPrintable(planned.text()));
        QCOMPARE(runCli({"farm", "run", plan}).code, 0);
        QCOMPARE(runCli({"farm", "join", plan}).code, 0);
        QCOMPARE(bytesOf(folder.filePath("one.tif")), bytesOf(folder.filePath("two.tif")));
        QVERIFY(!bytesOf(folder.filePath("one.tif")).isEmpty());

        // A Slurm that only writes down what it was given.
        const QString log = folder.filePath("log");
        QVERIFY(writeFile(folder.filePath("sbatch"), ("#!/bin/sh\necho \"$@\" >>" + log + "\necho 42\n").toUtf8()));
        QFile::setPermissions(folder.filePath("sbatch"), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        const CliOutcome slurm =
            runCli({"farm", "slurm", plan, "--tasks", "5"}, {}, {"PATH=" + folder.path() + ":/usr/bin:/bin"});
        QVERIFY2(slurm.code == 0 && slurm.out.contains("job 42: 5 tasks"), qPrintable(slurm.text()));
        QVERIFY2(bytesOf(log).contains("--dependency=afterok:42"), bytesOf(log).constData());
        const QByteArray script = bytesOf(plan + "/slurm.sh");
        QVERIFY(script.contains("--array=1-5\n") && script.contains("--requeue\n") &&
                script.contains("$SLURM_ARRAY_TASK_ID/5"));
        const QJsonObject openJd = runCli({"farm", "openjd", plan, "--tasks", "5"}).json();
        QCOMPARE(openJd["specificationVersion"].toString(), QString("jobtemplate-2023-09"));
        const CliOutcome flamenco = runCli({"farm", "flamenco", plan, "--tasks", "5"});
        QVERIFY(flamenco.code == 0 && flamenco.out.contains("function compileJob(job)"));
        QCOMPARE(runCli({"farm", "run", plan, "--task", "6/5"}).code, 2);
        QCOMPARE(runCli({"farm", "nothing"}).code, 2);
    }
};

QTEST_GUILESS_MAIN(TestFarm)
#include "test_farm.moc"
