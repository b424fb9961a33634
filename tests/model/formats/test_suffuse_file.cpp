// docs/file-format.md: bit-exact, small, and no damage goes unseen.
#include "model/formats/files.h"
#include "tests/model/random_paintings.h"
#include "suffuse_chunks.h"

#include <QCborMap>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

using namespace suffuse;
using test::ChunkList;
using test::fileOf;

namespace {

QString errorOf(const QByteArray &bytes)
{
    const auto p = readSuffuseFile(bytes, QStringLiteral("a.suffuse"));
    return p ? QStringLiteral("no error") : p.error();
}

ChunkList chunksOf(const Painting &painting)
{
    return test::chunksOf(writeSuffuseFile(painting));
}

/// Every bit, signs of zeros included.
bool sameBits(const Painting &a, const Painting &b)
{
    return a == b && writeTextForm(a) == writeTextForm(b);
}

} // namespace

class TestSuffuseFile : public QObject {
    Q_OBJECT

private slots:
    void randomPaintingsComeBack()
    {
        for (quint32 seed = 100; seed < 200; ++seed) {
            test::RandomPaintings random(seed);
            const Painting p = random.painting(int(seed % 9), 30);
            const QByteArray bytes = writeSuffuseFile(p);
            const auto q = readSuffuseFile(bytes, QStringLiteral("a.suffuse"));
            QVERIFY2(q, q ? "" : qPrintable(q.error()));
            QVERIFY2(sameBits(*q, p), qPrintable(QString::number(seed)));
            QCOMPARE(writeSuffuseFile(*q), bytes);
            QCOMPARE(detectFormat(bytes), FileFormat::Suffuse);
        }
    }

    void manySegmentsTakeSeveralChunks()
    {
        auto s = std::make_shared<Stroke>();
        s->segments.resize(70'000); // all the same: nothing but constants
        for (Segment &segment : s->segments)
            segment.bezier = {};
        Painting p;
        for (StrokeId id = 1; id <= 8; ++id) {
            auto other = std::make_shared<Stroke>(*s);
            other->id = id;
            p.strokes.push_back(other);
        }
        const QByteArray bytes = writeSuffuseFile(p);
        const auto chunks = suffuseChunks(bytes, QStringLiteral("a.suffuse"));
        QVERIFY(chunks);
        QCOMPARE(chunks->size(), std::size_t(2 + 8 + 1));
        QVERIFY(bytes.size() >= 560'000); // past half a million, a byte for each segment
        const auto q = readSuffuseFile(bytes, QStringLiteral("a.suffuse"));
        QVERIFY2(q, q ? "" : qPrintable(q.error()));
        QVERIFY(*q == p);
        p.strokes.resize(4);
        QVERIFY(writeSuffuseFile(p).size() < 3000);
    }

    void chunkSizesAddUp()
    {
        test::RandomPaintings random(4);
        const QByteArray bytes = writeSuffuseFile(random.painting(5, 5));
        const auto chunks = suffuseChunks(bytes, QStringLiteral("a.suffuse"));
        QVERIFY(chunks);
        qint64 sum = suffuseSignatureSize;
        for (const ChunkInfo &chunk : *chunks)
            sum += chunk.bytes;
        QCOMPARE(sum, bytes.size());
        QCOMPARE(chunks->front().name, QStringLiteral("HEAD"));
        QCOMPARE(chunks->back().name, QStringLiteral("ENDS"));
    }

    void everyTruncationIsAnError()
    {
        test::RandomPaintings random(21);
        const QByteArray bytes = writeSuffuseFile(random.painting(3, 8));
        for (qsizetype size = 0; size < bytes.size(); ++size) {
            const auto p = readPainting(bytes.left(size), QStringLiteral("a.suffuse"));
            QVERIFY2(!p && p.error().startsWith(QLatin1String("a.suffuse: ")), qPrintable(QString::number(size)));
        }
    }

    void everyBitFlipIsAnError()
    {
        test::RandomPaintings random(22);
        const QByteArray bytes = writeSuffuseFile(random.painting(2, 3));
        for (qsizetype bit = 0; bit < bytes.size() * 8; ++bit) {
            QByteArray damaged = bytes;
            damaged[bit / 8] = char(damaged[bit / 8] ^ (1 << bit % 8));
            QVERIFY2(!readSuffuseFile(damaged, QStringLiteral("a.suffuse")), qPrintable(QString::number(bit)));
        }
    }

    /// Behind right checksums too: an error, or some valid painting.
    void hostileChunksDoNoHarm()
    {
        test::RandomPaintings random(23);
        const auto chunks = chunksOf(random.painting(4, 12));
        int refused = 0, trials = 0;
        for (std::size_t k = 0; k < chunks.size(); ++k) {
            for (qsizetype at = 0; at < chunks[k].second.size(); ++at) {
                auto changed = chunks;
                QByteArray &payload = changed[k].second;
                const quint32 how = random.below(4);
                if (how == 0)
                    payload.truncate(at);
                else if (how == 1)
                    payload[at] = char(-1);
                else
                    payload[at] = char(payload[at] ^ (1 << random.below(8)));
                const auto p = readSuffuseFile(fileOf(changed), QStringLiteral("a.suffuse"));
                ++trials;
                refused += !p;
                if (!p)
                    QVERIFY2(p.error().startsWith(QLatin1String("a.suffuse: ")), qPrintable(p.error()));
                else
                    QVERIFY(readSuffuseFile(writeSuffuseFile(*p), QStringLiteral("b.suffuse")));
            }
        }
        QVERIFY(trials > 500);
        QVERIFY(refused > trials / 2);
    }

    void declaredSizesAreBounded()
    {
        test::RandomPaintings random(24);
        auto chunks = chunksOf(random.painting(4, 12));
        auto strokes = std::find_if(chunks.begin(), chunks.end(), [](const auto &c) { return c.first == "STRK"; });
        QVERIFY(strokes != chunks.end());
        QByteArray huge;
        appendU32(huge, 0xffffffffu);
        appendU32(huge, 0xffffffffu);
        strokes->second.replace(0, 8, huge);
        QVERIFY2(errorOf(fileOf(chunks)).contains(QLatin1String("more than the file can hold")),
                 qPrintable(errorOf(fileOf(chunks))));
        // A block of names that claims 2^60 bytes.
        QByteArray names;
        appendU32(names, 1);
        appendU32(names, 1);
        appendVarint(names, std::uint64_t(1) << 60);
        strokes->second = names + char(1) + char(4) + "abcd";
        QVERIFY2(errorOf(fileOf(chunks)).contains(QLatin1String("chunk STRK at byte")),
                 qPrintable(errorOf(fileOf(chunks))));
    }

    void messagesNameThePlace()
    {
        test::RandomPaintings random(25);
        const Painting p = random.painting(2, 4);
        QByteArray bytes = writeSuffuseFile(p);
        const auto chunks = splitChunks(bytes, QString());
        QVERIFY(chunks);
        const Chunk &last = (*chunks)[chunks->size() - 2];
        QByteArray damaged = bytes;
        damaged[last.start + 20] = char(damaged[last.start + 20] ^ 1);
        QCOMPARE(errorOf(damaged).section(QLatin1Char(';'), 0, 0),
                 QStringLiteral("a.suffuse: chunk STRK at byte %1: checksum differs").arg(last.start));
        QVERIFY(errorOf(QByteArray(bytes).replace("\r\n", "\n")).contains(QLatin1String("line endings")));
        QVERIFY(errorOf(bytes + "x").contains(QLatin1String("1 bytes follow")));
        QVERIFY(errorOf("hello").contains(QLatin1String("not a .suffuse file")));
        QVERIFY(errorOf(bytes.left(300)).contains(QLatin1String("a.suffuse: ")));
    }

    void newerAndUnknownParts()
    {
        test::RandomPaintings random(26);
        const Painting p = random.painting(2, 4);
        auto chunks = chunksOf(p);
        chunks.insert(chunks.begin() + 1, {"prev", "a thumbnail of the future"});
        const auto q = readSuffuseFile(fileOf(chunks), QStringLiteral("a.suffuse"));
        QVERIFY2(q, q ? "" : qPrintable(q.error()));
        QVERIFY(*q == p);
        chunks[1].first = "PREV";
        QVERIFY(errorOf(fileOf(chunks)).contains(QLatin1String("chunk PREV at byte")));
        chunks.erase(chunks.begin() + 1);
        QCborMap head = QCborValue::fromCbor(chunks[0].second).toMap();
        head.insert(QLatin1String("version"), 9);
        chunks[0].second = QCborValue(head).toCbor();
        QVERIFY(readSuffuseFile(fileOf(chunks), QStringLiteral("a.suffuse")));
        head.insert(QLatin1String("reader"), 9);
        chunks[0].second = QCborValue(head).toCbor();
        QVERIFY(errorOf(fileOf(chunks)).contains(QLatin1String("reader of version 9")));
        head.insert(QLatin1String("reader"), 1);
        head.insert(QLatin1String("strokes"), 3);
        chunks[0].second = QCborValue(head).toCbor();
        QVERIFY(errorOf(fileOf(chunks)).contains(QLatin1String("should hold 3 strokes")));
    }

    /// The paper's figure 11f takes 426.3 KB there.
    void paperFigureIsSmall()
    {
        const QString script = QStringLiteral(SUFFUSE_SOURCE_DIR "/../shared/data/make_paintings.py");
        if (!QFileInfo::exists(script))
            QSKIP("../shared/data/make_paintings.py is missing");
        QTemporaryDir folder;
        QProcess python;
        python.start(QStringLiteral("python3"),
                     {script, folder.path(), QStringLiteral("--only"), QStringLiteral("figure11f")});
        QVERIFY(python.waitForFinished(-1) && python.exitCode() == 0);
        const auto p = loadPainting(folder.filePath(QStringLiteral("figure11f.json")));
        QVERIFY2(p, p ? "" : qPrintable(p.error()));
        QCOMPARE(p->strokes.size(), std::size_t(778));
        QCOMPARE(p->segmentCount(), std::size_t(17917));
        const QByteArray bytes = writeSuffuseFile(*p);
        qInfo("figure11f: %lld bytes, %.2f a segment", static_cast<long long>(bytes.size()),
              double(bytes.size()) / 17917);
        QVERIFY(bytes.size() <= 215'000);
        const auto q = readSuffuseFile(bytes, QStringLiteral("a.suffuse"));
        QVERIFY2(q, q ? "" : qPrintable(q.error()));
        QVERIFY(sameBits(*q, *p));
    }
};

QTEST_APPLESS_MAIN(TestSuffuseFile)
#include "test_suffuse_file.moc"
