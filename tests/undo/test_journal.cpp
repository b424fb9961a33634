// A journal leads to the painting as it was, whatever was done, wherever it is cut off, and whatever a file says.
#include "model/journal/journal_writer.h"
#include "model/journal/recovery.h"
#include "tests/files.h"
#include "tests/model/random_paintings.h"
#include "tests/undo/random_edits.h"
#include "tests/undo/steps.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRandomGenerator>
#include <QTemporaryDir>

#include <csignal>
#include <sys/resource.h>

using namespace suffuse;

namespace {

/// A document that is edited at random, undo and redo among it.
struct Painter {
    explicit Painter(unsigned seed, PaintingPtr painting = makePainting(20)) : random(document, seed)
    {
        document.reset(std::move(painting));
    }
    void step()
    {
        const int what = random.below(5);
        if (what == 0 && stack.canUndo())
            stack.undo();
        else if (what == 1 && stack.canRedo())
            stack.redo();
        else if (Edit edit = random.next(); !edit.isEmpty())
            pushStep(stack, document, std::move(edit));
    }

    Document document;
    QUndoStack stack;
    RandomEdits random;
};

const JournalHead aHead{QStringLiteral("flowers.suffuse"), QStringLiteral("/home/me/flowers.suffuse"),
                        QByteArray(32, 'h')};

/// A journal of some steps, and the hashes of the paintings at the end of each record.
struct Recorded {
    QByteArray bytes;
    std::vector<qsizetype> ends;
    std::vector<QByteArray> hashes;
};

Recorded record(unsigned seed, int steps)
{
    test::RandomPaintings paintings(seed);
    Painter painter(seed, std::make_shared<const Painting>(paintings.painting(6, 4)));
    JournalEncoder encoder;
    Recorded recorded;
    const auto keep = [&](const QByteArray &more) {
        encoder.kept();
        recorded.bytes += more;
        recorded.ends.push_back(recorded.bytes.size());
        recorded.hashes.push_back(hashOf(*painter.document.painting()));
    };
    keep(encoder.begin(aHead, painter.document.painting(), false, 1'000));
    for (int i = 0; i < steps; ++i) {
        painter.step();
        keep(encoder.edit(painter.document.painting(), true, 2'000 + i));
    }
    return recorded;
}

} // namespace

class TestJournal : public QObject {
    Q_OBJECT

    QString path(const QString &name) const { return m_folder->filePath(name); }
    QStringList journals() const
    {
        return QDir(m_folder->path()).entryList({QStringLiteral("*.journal*")}, QDir::Files);
    }

    std::unique_ptr<QTemporaryDir> m_folder;

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    /// Every prefix leads to the painting after its last whole record.
    void everyCutLeadsToTheLastWholeRecord()
    {
        for (unsigned seed = 1; seed <= 2; ++seed) {
            const Recorded r = record(seed, 20);
            std::size_t whole = 0;
            for (qsizetype cut = 0; cut <= r.bytes.size(); cut += 1 + cut % 23) {
                while (whole < r.ends.size() && r.ends[whole] <= cut)
                    ++whole;
                const Result<JournalContent> content = readJournal(r.bytes.left(cut), QStringLiteral("a.journal"));
                QCOMPARE(bool(content), whole > 0);
                if (!content) {
                    QVERIFY(content.error().contains("a.journal"));
                    continue;
                }
                QCOMPARE(hashOf(content->painting), r.hashes[whole - 1]);
                QCOMPARE(content->head, aHead);
            }
            QCOMPARE(hashOf(readJournal(r.bytes, {})->painting), r.hashes.back());
        }
    }

    /// A flipped bit ends it there, or is refused.
    void damageNeverMakesAnotherPainting()
    {
        const Recorded r = record(9, 25);
        QRandomGenerator random(3);
        for (int i = 0; i < 200; ++i) {
            QByteArray damaged = r.bytes;
            const qsizetype at = random.bounded(damaged.size());
            damaged[at] = char(damaged[at] ^ (1 << random.bounded(8)));
            const Result<JournalContent> content = readJournal(damaged, {});
            if (!content)
                continue;
            const auto whole = std::upper_bound(r.ends.begin(), r.ends.end(), at) - r.ends.begin();
            QVERIFY(whole > 0);
            QCOMPARE(hashOf(content->painting), r.hashes[std::size_t(whole) - 1]);
        }
    }

    /// Records that are whole but make no sense end the reading; what came before stands.
    void recordsThatMakeNoSenseAreRefused()
    {
        const PaintingPtr before = makePainting(3), other = makePainting(6);
        JournalEncoder encoder, elsewhere;
        const QByteArray begin = encoder.begin(aHead, before, false, 1);
        encoder.kept();
        elsewhere.begin(aHead, other, false, 1);
        elsewhere.kept();
        auto after = std::make_shared<Painting>(*other);
        after->strokes.erase(after->strokes.begin() + 4);
        const QByteArray removesWhatIsNotThere = elsewhere.edit(after, true, 2);
        const Result<JournalContent> content = readJournal(begin + removesWhatIsNotThere, {});
        QVERIFY2(content, content ? "" : qPrintable(content.error()));
        QCOMPARE(hashOf(content->painting), hashOf(*before));
        QCOMPARE(content->wholeBytes, qint64(begin.size()));
        QVERIFY(!readJournal("no journal", {}));
        QVERIFY(!readJournal({}, {}));
    }

    void writerIsFollowedToTheLastStep()
    {
        quint64 written = 0;
        QByteArray last;
        quint64 serial = 0;
        {
            JournalWriter writer(m_folder->path(), {[&](quint64 n) { written = n; }, {}});
            Painter painter(4);
            writer.begin(aHead, painter.document.painting(), false);
            for (int i = 0; i < 300; ++i) {
                painter.step();
                serial = writer.record(painter.document.painting(), true);
                if (i % 50 == 0) {
                    writer.flush();
                    QCOMPARE(written, serial);
                }
            }
            QVERIFY(findJournals(m_folder->path()).lost.empty()); // it is in use
            QCOMPARE(findJournals(m_folder->path()).inUse.size(), std::size_t(1));
            last = hashOf(*painter.document.painting());
        }
        QCOMPARE(written, serial);
        const Journals found = findJournals(m_folder->path());
        QCOMPARE(found.lost.size(), std::size_t(1));
        QCOMPARE(found.lost[0].name(), aHead.name);
        QCOMPARE(hashOf(found.lost[0].content.painting), last);
        // Only one program is offered it.
        QVERIFY(findJournals(m_folder->path()).lost.empty());
        QCOMPARE(QFileInfo(found.lost[0].file->path()).permissions() & ~QFile::Permissions(0x6600),
                 QFile::Permissions());
    }

    void savedAndClosedDocumentsAreNotOffered()
    {
        {
            JournalWriter writer(m_folder->path(), {});
            Painter painter(5);
            writer.begin(aHead, painter.document.painting(), false);
            painter.step();
            writer.record(painter.document.painting(), true);
            writer.saved({QStringLiteral("b"), QStringLiteral("/b"), {}}, false);
        }
        Journals found = findJournals(m_folder->path());
        QVERIFY(found.lost.empty());
        QCOMPARE(found.saved.size(), std::size_t(1));
        tidyJournals(found, m_folder->path(), QDateTime::currentDateTime());
        QVERIFY(journals().isEmpty());
        {
            JournalWriter writer(m_folder->path(), {});
            writer.begin(aHead, makePainting(3), true);
            writer.flush();
            QCOMPARE(journals().size(), 1);
            writer.remove();
        }
        QVERIFY(journals().isEmpty());
    }

    void emptyUnmodifiedDocumentsLeaveNoFile()
    {
        JournalWriter writer(m_folder->path(), {});
        writer.begin({}, makePainting(0), false);
        writer.flush();
        QVERIFY(journals().isEmpty());
        writer.record(makePainting(1), true);
        writer.flush();
        QCOMPARE(journals().size(), 1);
    }

    /// Long sessions stay bounded, and lose nothing over it.
    void longJournalsAreBegunAnew()
    {
        QByteArray last;
        qint64 largest = 0;
        {
            JournalWriter writer(m_folder->path(), {});
            Painter painter(6, makePainting(800));
            writer.begin(aHead, painter.document.painting(), false);
            for (int i = 0; i < 300; ++i) {
                auto next = std::make_shared<Painting>(*painter.document.painting());
                for (StrokePtr &stroke : next->strokes) { // all of them, with numbers that do not compress
                    auto changed = std::make_shared<Stroke>(*stroke);
                    for (Segment &s : changed->segments)
                        s.density = float(painter.random.real(1, 20)), s.diffusion = float(painter.random.real(1, 20));
                    stroke = changed;
                }
                writer.record(next, true);
                writer.flush();
                last = hashOf(*next);
                for (const QString &name : journals())
                    largest = std::max(largest, QFileInfo(path(name)).size());
            }
        }
        QVERIFY2(largest > 4 << 20 && largest < 6 << 20, qPrintable(QString::number(largest)));
        const Journals found = findJournals(m_folder->path());
        QCOMPARE(found.lost.size(), std::size_t(1));
        QCOMPARE(hashOf(found.lost[0].content.painting), last);
        QCOMPARE(journals().size(), 1);
    }

    /// A full disk is told of once; when there is room again nothing is missing.
    void fullDiskIsToldOnceAndCaughtUpWith()
    {
        int told = 0;
        QByteArray last;
        {
            JournalWriter writer(m_folder->path(), {{}, [&](const QString &) { ++told; }});
            Painter painter(8);
            writer.begin(aHead, painter.document.painting(), false);
            writer.flush();
            const qint64 full = QFileInfo(path(journals().value(0))).size() + 100;
            rlimit usual{};
            QCOMPARE(::getrlimit(RLIMIT_FSIZE, &usual), 0);
            const auto handler = std::signal(SIGXFSZ, SIG_IGN);
            const rlimit tight{rlim_t(full), usual.rlim_max};
            QCOMPARE(::setrlimit(RLIMIT_FSIZE, &tight), 0);
            for (int i = 0; i < 40; ++i) {
                painter.step();
                writer.record(painter.document.painting(), true);
                writer.flush();
            }
            ::setrlimit(RLIMIT_FSIZE, &usual);
            std::signal(SIGXFSZ, handler);
            QCOMPARE(told, 1);
            painter.step();
            writer.record(painter.document.painting(), true);
            last = hashOf(*painter.document.painting());
        }
        QCOMPARE(told, 1);
        const Journals found = findJournals(m_folder->path());
        QCOMPARE(found.lost.size(), std::size_t(1));
        QCOMPARE(hashOf(found.lost[0].content.painting), last);
    }

    void recoveredJournalsGoWhenTheNewOneIsThere()
    {
        {
            JournalWriter writer(m_folder->path(), {});
            writer.begin(aHead, makePainting(3), true);
        }
        Journals found = findJournals(m_folder->path());
        QCOMPARE(found.lost.size(), std::size_t(1));
        const QString old = found.lost[0].file->path();
        {
            JournalWriter writer(m_folder->path(), {});
            writer.begin(aHead, std::make_shared<const Painting>(found.lost[0].content.painting), true,
                         std::move(found.lost[0].file));
            writer.flush();
            QVERIFY(!QFileInfo::exists(old));
        }
        QCOMPARE(findJournals(m_folder->path()).lost.size(), std::size_t(1));
    }

    void oldOnesAreTidied()
    {
        {
            JournalWriter writer(m_folder->path(), {});
            writer.begin(aHead, makePainting(3), true);
        }
        QVERIFY(put(path("x.journal"), "damaged"));
        QVERIFY(put(path("y.journal.new"), "unfinished"));
        const QDateTime now = QDateTime::currentDateTime();
        const auto leftAfter = [&](int days) {
            Journals found = findJournals(m_folder->path());
            tidyJournals(found, m_folder->path(), now.addDays(days));
            return std::make_pair(journals().size(), found.lost.size());
        };
        QCOMPARE(leftAfter(0), std::make_pair(qsizetype(3), std::size_t(1)));
        QCOMPARE(leftAfter(10), std::make_pair(qsizetype(2), std::size_t(1)));
        QCOMPARE(leftAfter(40), std::make_pair(qsizetype(1), std::size_t(1)));
        QCOMPARE(leftAfter(100), std::make_pair(qsizetype(0), std::size_t(0)));
    }

    void pipesAndLinksAreLeftAlone()
    {
        QVERIFY(put(path("real"), "secret"));
        QVERIFY(QFile::link(path("real"), path("link.journal")));
        QVERIFY(QDir(m_folder->path()).mkdir("folder.journal"));
        Journals found = findJournals(m_folder->path());
        tidyJournals(found, m_folder->path(), QDateTime::currentDateTime().addDays(400));
        QVERIFY(QFileInfo::exists(path("real")) && QFileInfo::exists(path("folder.journal")));
        QCOMPARE(bytesOf(path("real")), QByteArray("secret"));
    }
};

QTEST_APPLESS_MAIN(TestJournal)
#include "test_journal.moc"
