// Saving replaces a file wholly or leaves it as it was.
#include "model/formats/files.h"
#include "tests/model/random_paintings.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace suffuse;

namespace {

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(unreadable)");
}

} // namespace

class TestAtomicSave : public QObject {
    Q_OBJECT

    QString at(const char *name) const { return m_folder->filePath(QLatin1String(name)); }
    QStringList names() const
    {
        return QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
    }

    std::unique_ptr<QTemporaryDir> m_folder;

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void savesAndLoads()
    {
        test::RandomPaintings random(1);
        const Painting p = random.painting(5, 9);
        for (const char *name : {"a.suffuse", "b.json", "C.SUFFUSE"}) {
            const auto saved = savePainting(p, at(name));
            QVERIFY2(saved, qPrintable(saved.error()));
            const auto q = loadPainting(at(name));
            QVERIFY2(q, q ? "" : qPrintable(q.error()));
            QCOMPARE(q->strokes.size(), p.strokes.size());
            QVERIFY(std::equal(p.strokes.begin(), p.strokes.end(), q->strokes.begin(),
                               [](const auto &a, const auto &b) { return *a == *b; }));
        }
        QCOMPARE(names().size(), 3);
        const auto saved = savePainting(p, at("a.png"));
        QVERIFY(!saved && saved.error().contains(QLatin1String("a.png: the ending is neither .suffuse nor .json")));
    }

    void permissionsStay()
    {
        QVERIFY(writeFileAtomically(at("a"), "one"));
        QVERIFY(QFile::setPermissions(at("a"), QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup));
        const auto before = QFile::permissions(at("a"));
        QVERIFY(writeFileAtomically(at("a"), "two"));
        QCOMPARE(contentOf(at("a")), QByteArray("two"));
        QCOMPARE(QFile::permissions(at("a")), before);
    }

    void linksAreWrittenThrough()
    {
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("real")));
        QVERIFY(writeFileAtomically(at("real/a"), "one"));
        QVERIFY(QFile::link(at("real/a"), at("link")));
        const auto saved = writeFileAtomically(at("link"), "two");
        QVERIFY2(saved, qPrintable(saved.error()));
        QVERIFY(QFileInfo(at("link")).isSymLink());
        QCOMPARE(contentOf(at("real/a")), QByteArray("two"));
    }

    void unfitTargetsAreRefused()
    {
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("folder")));
        const auto folder = writeFileAtomically(at("folder"), "x");
        QVERIFY(!folder && folder.error().startsWith(at("folder") + ": is a folder"));
        QCOMPARE(::mkfifo(QFile::encodeName(at("pipe")).constData(), 0600), 0);
        const auto pipe = writeFileAtomically(at("pipe"), "x");
        QVERIFY(!pipe && pipe.error().startsWith(at("pipe") + ": is a device or a pipe"));
        const auto missing = writeFileAtomically(at("none/a"), "x");
        QVERIFY(!missing && missing.error().contains(QLatin1String("does not exist; create it")));
        const auto unnamed = writeFileAtomically(QString(), "x");
        QVERIFY(!unnamed && unnamed.error().contains(QLatin1String("no name")));
        QVERIFY(writeFileAtomically(at("plain"), "x"));
        QVERIFY(!writeFileAtomically(at("plain/a"), "x"));
        const QString full = QStringLiteral("/dev/full");
        if (QFileInfo::exists(full))
            QVERIFY(!writeFileAtomically(full, "x"));
        QCOMPARE(names().size(), 3);
    }

    void readOnlyFoldersAreRefused()
    {
        if (::geteuid() == 0)
            QSKIP("the administrator may write everywhere");
        QVERIFY(writeFileAtomically(at("a"), "one"));
        QVERIFY(QFile::setPermissions(m_folder->path(), QFile::ReadOwner | QFile::ExeOwner));
        const auto saved = writeFileAtomically(at("a"), "two");
        QFile::setPermissions(m_folder->path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        QVERIFY(!saved && saved.error().contains(QLatin1String("read-only; choose another")));
        QCOMPARE(contentOf(at("a")), QByteArray("one"));
    }

    /// The system refuses to write more than a few bytes, as on a full disk, at several places.
    /// Where no file can be made, room on the disk is not the matter.
    void otherPlacesAreAdvisedWhereThereCanBeNoFile()
    {
        if (!QFileInfo::exists(QStringLiteral("/proc/self")))
            QSKIP("There is no /proc.");
        const auto saved = savePainting(Painting(), QStringLiteral("/proc/a.suffuse"));
        QVERIFY(!saved);
        QVERIFY2(saved.error().contains("choose another") && !saved.error().contains("space"),
                 qPrintable(saved.error()));
    }

    void shortWritesLeaveTheOldFile()
    {
        QVERIFY(writeFileAtomically(at("a"), "the old painting"));
        const QByteArray large(300'000, 'x');
        rlimit usual{};
        QCOMPARE(::getrlimit(RLIMIT_FSIZE, &usual), 0);
        const auto handler = std::signal(SIGXFSZ, SIG_IGN);
        for (const rlim_t limit : {0, 1, 4096, 16384, 100'000, 299'999}) {
            const rlimit tight{limit, usual.rlim_max};
            QCOMPARE(::setrlimit(RLIMIT_FSIZE, &tight), 0);
            const auto saved = writeFileAtomically(at("a"), large);
            ::setrlimit(RLIMIT_FSIZE, &usual);
            QVERIFY2(!saved, qPrintable(QString::number(limit)));
            QVERIFY2(saved.error().contains(QLatin1String("could not be written in full")) &&
                         saved.error().contains(QLatin1String("as before")),
                     qPrintable(saved.error()));
            QCOMPARE(contentOf(at("a")), QByteArray("the old painting"));
            QCOMPARE(names(), QStringList{QStringLiteral("a")});
        }
        std::signal(SIGXFSZ, handler);
        QVERIFY(writeFileAtomically(at("a"), large));
        QCOMPARE(contentOf(at("a")), large);
    }

    void unreadableFilesAreNamed()
    {
        const auto missing = loadPainting(at("none.suffuse"));
        QVERIFY(!missing && missing.error().startsWith(at("none.suffuse") + ": there is no such file"));
        const auto folder = loadPainting(m_folder->path());
        QVERIFY(!folder && folder.error().contains(QLatin1String("is a folder")));
        QVERIFY(writeFileAtomically(at("empty.json"), {}));
        const auto empty = loadPainting(at("empty.json"));
        QVERIFY(!empty && empty.error().startsWith(at("empty.json") + QLatin1String(": This file is empty")));
    }
};

QTEST_APPLESS_MAIN(TestAtomicSave)
#include "test_atomic_save.moc"
