// kill -9 while saving and while painting, and power cuts: what no fsync brought to the disk is gone, too, names as
// well as bytes. SUFFUSE_LONG=1, or SUFFUSE_TRIALS=n, tries longer.
#include "model/formats/files.h"
#include "model/journal/recovery.h"
#include "tests/files.h"
#include "tests/harness/trials.h"

#include <QDir>
#include <QProcess>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

#include <thread>

using namespace suffuse;

namespace {

/// The folder that a victim works in.
class Disk {
public:
    Disk() { QDir(m_root.path()).mkpath("disk"), QDir(m_root.path()).mkpath("durable"); }

    QString folder() const { return m_root.filePath("disk"); }
    QProcessEnvironment environment() const
    {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("LD_PRELOAD", harnessFile("libsuffuse_faults.so"));
        environment.insert("SUFFUSE_DISK", folder());
        environment.insert("SUFFUSE_DURABLE", m_root.filePath("durable"));
        return environment;
    }
    /// What is there when the power is back: what tests/harness/fault_shim.cpp kept.
    QString folderAfterPowerCut() const
    {
        const QString after = m_root.filePath("after");
        QDir().mkpath(after);
        for (const QByteArray &line : bytesOf(m_root.filePath("durable/names")).split('\n')) {
            const qsizetype space = line.indexOf(' ');
            if (space > 0) // a file that was never synced has a name and no bytes
                put(after + '/' + QFile::decodeName(line.mid(space + 1)),
                    bytesOf(m_root.filePath("durable/" + QString::fromLatin1(line.left(space)))));
        }
        return after;
    }

private:
    QTemporaryDir m_root;
};

/// Starts it and kills it at some moment after its first line; what it said.
QByteArray runAndKill(const Disk &disk, bool powerCut, const QStringList &arguments, QRandomGenerator &random)
{
    QProcess process;
    if (powerCut)
        process.setProcessEnvironment(disk.environment());
    process.start(victim(), arguments);
    QByteArray said;
    while (!said.contains('\n') && process.waitForReadyRead(60'000))
        said += process.readAllStandardOutput();
    std::this_thread::sleep_for(std::chrono::microseconds(random.bounded(60'000)));
    process.kill();
    process.waitForFinished(60'000);
    return said + process.readAllStandardOutput();
}

/// Without what was being said when it ended.
QByteArray wholeLines(const QByteArray &said)
{
    return said.left(said.lastIndexOf('\n') + 1);
}

} // namespace

class TestKill : public QObject {
    Q_OBJECT

private slots:
    void initTestCase_data()
    {
        QTest::addColumn<bool>("powerCut");
        QTest::newRow("kill") << false;
        QTest::newRow("power cut") << true;
    }
    void init()
    {
#ifdef SUFFUSE_SANITIZED
        QFETCH_GLOBAL(bool, powerCut);
        if (powerCut)
            QSKIP("the sanitizer's runtime library and the one of faults cannot both come first");
#endif
    }

    /// The file is the old one or the new one, whole.
    void whileSaving()
    {
        QFETCH_GLOBAL(bool, powerCut);
        const int n = trials(30, 10'000);
        QRandomGenerator random(1 + firstSeed());
        int later = 0;
        for (int i = 0; i < n; ++i) {
            const Disk disk;
            const QStringList what{"save", disk.folder() + "/a.suffuse", QString::number(firstSeed() + quint32(i))};
            const QByteArray said = wholeLines(runAndKill(disk, powerCut, what, random));
            const QString path = (powerCut ? disk.folderAfterPowerCut() : disk.folder()) + "/a.suffuse";
            const int saved = lastSaid(said, "saved").number, begun = lastSaid(said, "saving").number;
            if (saved == 0 && !QFile::exists(path))
                continue;
            const Result<Painting> painting = loadPainting(path);
            QVERIFY2(painting, painting ? "" : qPrintable(QString("trial %1: %2").arg(i).arg(painting.error())));
            const int k = int(painting->canvas.width) - 100;
            QVERIFY2(k == saved || k == begun,
                     qPrintable(QString("trial %1: %2, said %3 and %4").arg(i).arg(k).arg(saved).arg(begun)));
            later += k > saved;
        }
        qInfo("%d times while saving: every file whole; %d times the new one before it was said", n, later);
    }

    /// At most the stroke in hand is lost: everything that was finished before the last one is there.
    void whilePainting()
    {
        QFETCH_GLOBAL(bool, powerCut);
        const int n = trials(30, 10'000);
        QRandomGenerator random(2 + firstSeed());
        int lost = 0, strokes = 0;
        for (int i = 0; i < n; ++i) {
            const Disk disk;
            const QStringList what{"paint", disk.folder(), QString::number(firstSeed() + quint32(i))};
            const QByteArray said = wholeLines(runAndKill(disk, powerCut, what, random));
            const int written = lastSaid(said, "written").number;
            const Journals found = findJournals(powerCut ? disk.folderAfterPowerCut() : disk.folder());
            QVERIFY2(found.unreadable.empty() && found.inUse.empty(), qPrintable(QString("trial %1").arg(i)));
            QCOMPARE(found.lost.size() + found.saved.size(), std::size_t(written > 0 || !found.lost.empty()));
            if (found.lost.empty())
                continue;
            const QByteArray hash = hashOf(found.lost[0].content.painting).toHex();
            int k = 0;       // the last moment at which it looked so
            int records = 0; // that were said to be finished; a stroke that came to nothing makes none
            int acknowledged = 0;
            QByteArray before;
            for (const QByteArray &line : said.split('\n')) {
                const QList<QByteArray> words = line.split(' ');
                if (words.value(0) != "finished")
                    continue;
                records += words[2] != before;
                before = words[2];
                if (words[1].toInt() == written)
                    acknowledged = records;
                if (words[2] == hash)
                    k = words[1].toInt();
            }
            const int finished = lastSaid(said, "finished").number;
            const int there = int(found.lost[0].content.edits) + 1; // the first is the whole painting
            QVERIFY2(there >= acknowledged,
                     qPrintable(QString("trial %1: %2 of %3").arg(i).arg(there).arg(acknowledged)));
            // It may have been killed before it could say what is on disk already: that may be a way back, too.
            QVERIFY2(k >= written || there > records, qPrintable(QString("trial %1: another painting").arg(i)));
            lost += there < records;
            strokes += finished;
        }
        qInfo("%d times while painting, %d edits finished: all that was acknowledged was there; %d times the last "
              "finished one was not on disk yet",
              n, strokes, lost);
    }
};

QTEST_GUILESS_MAIN(TestKill)
#include "test_kill.moc"
