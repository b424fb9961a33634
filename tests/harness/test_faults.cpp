// Disks that fill up, calls that fail one after the other, and targets that are no plain files: the old bytes stay, and
// saving elsewhere works. SUFFUSE_LONG=1, or SUFFUSE_TRIALS=n, tries longer.
#include "model/formats/atomic_save.h"
#include "model/formats/files.h"
#include "tests/files.h"
#include "tests/harness/trials.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cerrno>
#include <sys/stat.h>
#include <unistd.h>

using namespace suffuse;

namespace {

struct Attempt {
    bool ran = false;
    bool saved = false;
    int hits = 0;
    QByteArray message;
    bool savedElsewhere = false;
};

Attempt saveWith(const QString &fault, const QString &path, const QString &other)
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("SUFFUSE_FAULT", fault);
    environment.insert("LD_PRELOAD", harnessFile("libsuffuse_faults.so"));
    process.setProcessEnvironment(environment);
    process.start(victim(), {"fault", path, other});
    Attempt attempt;
    attempt.ran =
        process.waitForFinished(120'000) && process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0;
    const QByteArray said = process.readAllStandardOutput();
    attempt.saved = said.startsWith("saved");
    const Said how = lastSaid(said, attempt.saved ? "saved" : "failed");
    attempt.hits = how.number;
    attempt.message = how.rest;
    attempt.savedElsewhere = said.contains("elsewhere");
    return attempt;
}

/// Runs the victim over a faulty disk and checks what is left. Returns how often a call failed.
int tryFault(const QString &fault)
{
    const QByteArray old = "the old painting";
    QTemporaryDir folder;
    const QString path = folder.filePath("a.suffuse"), other = folder.filePath("b.suffuse");
    if (!put(path, old))
        return -1;
    const Attempt attempt = saveWith(fault, path, other);
    const auto check = [&](bool good, const char *what) {
        if (!good)
            QTest::qFail(qPrintable(QString("%1: %2; %3").arg(fault, what, QString::fromUtf8(attempt.message))),
                         __FILE__, __LINE__);
        return good;
    };
    const bool isNew = bytesOf(path) != old;
    if (!check(attempt.ran, "it crashed") ||
        !check(attempt.saved || !attempt.message.isEmpty(), "it failed without a word") ||
        !check(!attempt.saved || isNew, "it said that it saved") ||
        // A folder that could not be synced is told of, though the new file is in place.
        !check(attempt.saved || !isNew || attempt.message.contains("was written, but the folder"),
               "the old file is gone") ||
        !check(!isNew || bool(loadPainting(path)), "the file is damaged") ||
        !check(attempt.savedElsewhere && bool(loadPainting(other)), "it could not be saved elsewhere"))
        return -1;
    const QStringList left = QDir(folder.path()).entryList(QDir::Files | QDir::Hidden);
    for (const QString &name : left)
        if (!check(QStringList({"a.suffuse", "a.suffuse~", "b.suffuse"}).contains(name), "something was left behind"))
            return -1;
    return attempt.hits;
}

} // namespace

class TestFaults : public QObject {
    Q_OBJECT

private slots:
    /// The n-th call fails, or all from there on, for every n until it is not reached.
    void everyCall()
    {
#ifdef SUFFUSE_SANITIZED
        QSKIP("a sanitizer wants its own library to be the first that is preloaded");
#endif
        const int most = trials(0, 2'000);
        int tried = 0, hit = 0;
        do {
            for (const char *call : {"write", "fsync", "rename", "link"})
                for (const int error : {ENOSPC, EIO, EDQUOT})
                    for (const bool on : {false, true})
                        for (int n = 1;; ++n) {
                            const int hits =
                                tryFault(QString("%1 %2 %3 %4").arg(call).arg(n).arg(error).arg(on ? 1'000'000 : n));
                            QVERIFY(hits >= 0);
                            ++tried;
                            hit += hits > 0;
                            if (hits == 0)
                                break;
                        }
        } while (tried < most);
        qInfo("%d disks that failed in %d of them: nothing lost", tried, hit);
        QVERIFY(hit >= 18);
    }

    void linksPipesFoldersAndOwners()
    {
        QTemporaryDir folder;
        const auto at = [&](const char *name) { return folder.filePath(name); };
        Painting painting;
        QVERIFY(savePainting(painting, at("real.suffuse")));
        QVERIFY(QFile::link(at("real.suffuse"), at("link.suffuse")));
        painting.canvas.width = 777;
        QVERIFY(savePainting(painting, at("link.suffuse")));
        QVERIFY(QFileInfo(at("link.suffuse")).isSymLink());
        QCOMPARE(loadPainting(at("real.suffuse"))->canvas.width, 777.0);
        QCOMPARE(::mkfifo(QFile::encodeName(at("pipe.suffuse")).constData(), 0600), 0);
        const Result<void> pipe = savePainting(painting, at("pipe.suffuse"));
        QVERIFY(!pipe && pipe.error().contains("pipe"));
        QVERIFY(!savePainting(painting, at("gone/a.suffuse")));
        QVERIFY(savePainting(painting, at("elsewhere.suffuse")));
        if (::geteuid() == 0) { // the administrator writes another one's file, and it stays theirs
            QCOMPARE(::chown(QFile::encodeName(at("real.suffuse")).constData(), 12345, 23456), 0);
            QVERIFY(savePainting(painting, at("real.suffuse")));
            struct stat info {};
            QCOMPARE(::stat(QFile::encodeName(at("real.suffuse")).constData(), &info), 0);
            QCOMPARE(info.st_uid, uid_t(12345));
            QCOMPARE(info.st_gid, gid_t(23456));
        }
    }

    void backupsAreTheLastVersions()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("a.suffuse");
        for (int k = 1; k <= 6; ++k) {
            Painting painting;
            painting.canvas.width = 100 + k;
            QVERIFY(keepBackups(path, 3));
            QVERIFY(savePainting(painting, path));
        }
        for (int i = 1; i <= 3; ++i)
            QCOMPARE(loadPainting(backupName(path, i))->canvas.width, double(106 - i));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 4);
    }

    /// Whatever stands in the settings' place, they are read and written, or forgotten.
    void anySettingsAreSurvived()
    {
        QTemporaryDir folder;
        const auto comesUp = [&](const QString &path) {
            QProcess process;
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert("SUFFUSE_SETTINGS", path);
            process.setProcessEnvironment(environment);
            process.start(victim(), {"settings"});
            const bool ended = process.waitForFinished(120'000);
            process.kill();
            return ended && process.readAllStandardOutput().contains("up");
        };
        const auto at = [&](const char *name) { return folder.filePath(name); };
        QVERIFY(comesUp(at("none.ini")));
        QVERIFY(comesUp("/dev/null"));
        QVERIFY(QFileInfo::exists("/dev/null"));
        QVERIFY(comesUp("/dev/zero"));
        QVERIFY(QDir().mkdir(at("folder.ini")) && comesUp(at("folder.ini")));
        QCOMPARE(::mkfifo(QFile::encodeName(at("pipe.ini")).constData(), 0600), 0);
        QVERIFY(comesUp(at("pipe.ini")));
        QVERIFY(put(at("large.ini"), QByteArray(30 << 20, '[')) && comesUp(at("large.ini")));
        QVERIFY(QFileInfo::exists(at("large.ini.damaged")));
        // A list of two thousand million elements, says its header.
        QVERIFY(put(at("bomb.ini"), "[General]\ntheme=@Variant(\\0\\0\\0\\x9\\0\\x7f\\xff\\xff\\xff)\n") &&
                comesUp(at("bomb.ini")));
        QVERIFY(put(at("noise.ini"), QByteArray("\xff\xfe\0\0=[]\x80;%%\\x", 12).repeated(999)) &&
                comesUp(at("noise.ini")));
        // Two starts that never came up: the third begins without these settings.
        QVERIFY(put(at("bad.ini"), "[General]\ntheme=dark\n") && put(at("bad.ini.starts"), "2"));
        QVERIFY(comesUp(at("bad.ini")) && QFileInfo::exists(at("bad.ini.damaged")));
        QVERIFY(!QFileInfo::exists(at("bad.ini.starts")));
    }
};

QTEST_GUILESS_MAIN(TestFaults)
#include "test_faults.moc"
