// A damaged file gives what is whole of it and says what is missing.
#include "model/formats/files.h"
#include "model/journal/journal_layout.h"
#include "suffuse_chunks.h"
#include "tests/model/random_paintings.h"
#include "tests/trials.h"

#include <QTest>

using namespace suffuse;

namespace {

/// Of the damaged files sanitizers, to which each is ten times the work, see one in so many. Fuzzers are theirs alone.
#ifdef SUFFUSE_SANITIZED
constexpr int step = 13;
#else
constexpr int step = 1;
#endif

Result<LoadedDocument> opened(const QByteArray &bytes)
{
    return readDocument(bytes, QStringLiteral("a.suffuse"));
}

/// Six strokes in three chunks.
Painting largePainting()
{
    test::RandomPaintings random(31);
    Painting p;
    for (StrokeId id = 1; id <= 6; ++id) {
        auto stroke = std::make_shared<Stroke>(*random.painting(1, 40).strokes.front());
        Segment next = stroke->segments.back();
        next.bezier[0] = next.bezier[3];
        stroke->segments.resize(segmentsPerChunk(0) / 2, next);
        stroke->id = id;
        stroke->group = 0;
        p.strokes.push_back(stroke);
    }
    p.swatches = {{QStringLiteral("sky"), {0, 0, 1, 1}}};
    p.canvas.width = 500;
    return p;
}

bool anyContains(const std::vector<QString> &losses, const char *text)
{
    return std::any_of(losses.begin(), losses.end(), [&](const QString &s) { return s.contains(QLatin1String(text)); });
}

void flip(QByteArray &bytes, qsizetype at)
{
    bytes[at] = char(bytes[at] ^ 4);
}

std::vector<StrokeId> ids(const Painting &p)
{
    std::vector<StrokeId> list;
    for (const StrokePtr &s : p.strokes)
        list.push_back(s->id);
    return list;
}

} // namespace

class TestSuffuseSalvage : public QObject {
    Q_OBJECT

private slots:
    void wholeFilesLoseNothing()
    {
        const Painting p = largePainting();
        const auto d = opened(writeSuffuseFile(p));
        QVERIFY2(d, d ? "" : qPrintable(d.error()));
        QVERIFY(d->losses.empty());
        QVERIFY(d->painting == p);
        QCOMPARE(d->format, FileFormat::Suffuse);
    }

    void oneStrokeChunkIsLost()
    {
        const Painting p = largePainting();
        QByteArray bytes = writeSuffuseFile(p);
        flip(bytes, test::startOf(bytes, "STRK", 1) + 30);
        QVERIFY(!readPainting(bytes, QStringLiteral("a.suffuse")));
        const auto d = opened(bytes);
        QVERIFY2(d, d ? "" : qPrintable(d.error()));
        QCOMPARE(ids(d->painting), (std::vector<StrokeId>{1, 2, 5, 6}));
        QVERIFY(*d->painting.strokes[2] == *p.strokes[4]);
        QVERIFY(d->painting.canvas == p.canvas);
        QCOMPARE(d->losses, (std::vector<QString>{QStringLiteral("2 of 6 strokes are missing, with %1 of %2 segments")
                                                      .arg(segmentsPerChunk(0))
                                                      .arg(p.segmentCount())}));
    }

    /// Wherever one bit of a small painting's strokes is wrong, nearly all of them are there.
    void oneWrongBitLosesLittle()
    {
        test::RandomPaintings random(5);
        Painting p;
        for (StrokeId id = 1; id <= 28; ++id) {
            auto stroke = std::make_shared<Stroke>(*random.painting(1, 40).strokes.front());
            Segment next = stroke->segments.back();
            next.bezier[0] = next.bezier[3];
            stroke->segments.resize(id == 7 ? 900 : 58, next); // a chunk of its own
            stroke->id = id;
            stroke->group = 0;
            p.strokes.push_back(stroke);
        }
        const QByteArray whole = writeSuffuseFile(p);
        QCOMPARE(writeSuffuseFile(p), whole);
        int chunks = 0;
        for (qsizetype at = 0; (at = test::startOf(whole, "STRK", chunks)) > 0; ++chunks) {
            QByteArray bytes = whole;
            flip(bytes, at + 30);
            const auto d = opened(bytes);
            QVERIFY2(d, d ? "" : qPrintable(d.error()));
            QVERIFY(d->painting.strokes.size() >= 26);
            QVERIFY(at == test::startOf(whole, "STRK", 3) || d->painting.find(7));
        }
        QVERIFY(chunks >= 14);
    }

    /// The picture is whole: that is no loss, and one sentence says what is not there.
    void damageBesideThePicture_data()
    {
        QTest::addColumn<QByteArray>("type");
        QTest::addColumn<QString>("said");
        QTest::newRow("preview") << QByteArray("prev") << QStringLiteral("the preview");
        QTest::newRow("view") << QByteArray("view") << QStringLiteral("how it was last looked at");
        QTest::newRow("history") << QByteArray("hist") << QStringLiteral("the undo history");
    }
    void damageBesideThePicture()
    {
        QFETCH(QByteArray, type);
        QFETCH(QString, said);
        const Painting p = largePainting();
        DocumentExtras extras;
        extras.preview = QByteArray("\x89PNG\r\n\x1a\n") + QByteArray(40, 'x');
        extras.view = WorkspaceState{{10, 20}, 2, 0, false, {}};
        extras.history = QByteArray(60, 'h');
        const QByteArray whole = writeSuffuseFile(p, extras);
        for (const qsizetype place : {4, 12}) { // its length, its payload
            QByteArray bytes = whole;
            flip(bytes, test::startOf(whole, type.constData()) + place);
            const auto d = opened(bytes);
            QVERIFY2(d, d ? "" : qPrintable(d.error()));
            QVERIFY(d->losses.empty());
            QVERIFY(d->painting == p);
            QCOMPARE(d->leftOut, QStringLiteral("Damaged and left out: %1. All 6 strokes are here.").arg(said));
        }
        // With the picture hurt too it is one of the losses.
        QByteArray bytes = whole;
        flip(bytes, test::startOf(whole, type.constData()) + 12);
        flip(bytes, test::startOf(whole, "STRK") + 30);
        const auto d = opened(bytes);
        QVERIFY(d && d->leftOut.isEmpty());
        QCOMPARE(d->losses.size(), std::size_t(2));
        QVERIFY(anyContains(d->losses, qPrintable(said)));
    }

    /// The chunk after it is found where the length says so, and where the length lies.
    void lengthsAndTypesMayBeDamaged()
    {
        const Painting p = largePainting();
        const QByteArray whole = writeSuffuseFile(p);
        for (const qsizetype place : {0, 1, 4, 5, 6, 7}) {
            QByteArray bytes = whole;
            flip(bytes, test::startOf(whole, "STRK", 0) + place);
            const auto d = opened(bytes);
            QVERIFY2(d, d ? "" : qPrintable(d.error()));
            QCOMPARE(ids(d->painting), (std::vector<StrokeId>{3, 4, 5, 6}));
        }
    }

    void truncatedFiles()
    {
        const Painting p = largePainting();
        const QByteArray whole = writeSuffuseFile(p);
        const auto cut = opened(whole.left(test::startOf(whole, "STRK", 2) + 50));
        QVERIFY2(cut, cut ? "" : qPrintable(cut.error()));
        QCOMPARE(ids(cut->painting), (std::vector<StrokeId>{1, 2, 3, 4}));
        QVERIFY(anyContains(cut->losses, "2 of 6 strokes are missing"));
        const auto noEnd = opened(whole.left(test::startOf(whole, "ENDS")));
        QVERIFY(noEnd && noEnd->painting == p);
        QCOMPARE(noEnd->losses,
                 (std::vector<QString>{
                     QStringLiteral("the file is damaged or cut off at byte %1").arg(test::startOf(whole, "ENDS")),
                     QStringLiteral("all 6 strokes are here")}));
    }

    void brokenEnds()
    {
        const Painting p = largePainting();
        const QByteArray whole = writeSuffuseFile(p);
        QByteArray bytes = whole;
        flip(bytes, test::startOf(whole, "ENDS") + 12);
        const auto d = opened(bytes);
        QVERIFY(d && d->painting == p);
        QVERIFY(anyContains(d->losses, "the end of the file is damaged"));
        const auto longer = opened(whole + "x");
        QVERIFY(longer && longer->painting == p);
        QVERIFY(anyContains(longer->losses, "the end of the file is damaged"));
        // A chunk that went without a trace.
        const qsizetype a = test::startOf(whole, "STRK", 0), b = test::startOf(whole, "STRK", 1);
        const auto less = opened(whole.left(a) + whole.mid(b));
        QVERIFY(less);
        QCOMPARE(ids(less->painting), (std::vector<StrokeId>{3, 4, 5, 6}));
        QVERIFY(anyContains(less->losses, "the end of the file is damaged"));
        QVERIFY(anyContains(less->losses, "2 of 6 strokes are missing"));
    }

    void lostDocument()
    {
        Painting p = largePainting();
        p.groups = {{4, QStringLiteral("g"), 0, true, false}};
        auto member = std::make_shared<Stroke>(*p.strokes[0]);
        member->group = 4;
        p.strokes[0] = member;
        QByteArray bytes = writeSuffuseFile(p);
        flip(bytes, test::startOf(bytes, "DOCU") + 20);
        const auto d = opened(bytes);
        QVERIFY2(d, d ? "" : qPrintable(d.error()));
        QCOMPARE(d->painting.strokes.size(), std::size_t(6));
        QVERIFY(d->painting.canvas == Canvas());
        QVERIFY(d->painting.groups.empty());
        QCOMPARE(d->painting.strokes[0]->group, GroupId(0));
        QVERIFY(anyContains(d->losses, "the canvas, paper, groups, swatches and underlay are missing"));
        QVERIFY(anyContains(d->losses, "1 strokes are in no group any more"));
    }

    void lostHeader()
    {
        const Painting p = largePainting();
        QByteArray bytes = writeSuffuseFile(p);
        flip(bytes, suffuseSignatureSize + 12);
        const auto d = opened(bytes);
        QVERIFY2(d, d ? "" : qPrintable(d.error()));
        QVERIFY(d->painting == p);
        QVERIFY(anyContains(d->losses, "how many there were is not known"));
    }

    void lostImages()
    {
        Painting p = largePainting();
        const auto image = [](char c) {
            return std::make_shared<const QByteArray>(QByteArray("\x89PNG\r\n\x1a\n") + QByteArray(40, c));
        };
        p.canvas.paper.kind = PaperKind::Image;
        p.canvas.paper.image = image('p');
        auto underlay = std::make_shared<Underlay>();
        underlay->image = image('u');
        underlay->area = Rect::of(0, 0, 10, 10);
        p.underlay = underlay;
        for (const std::size_t i : {0, 1}) {
            Stroke s = *p.strokes[i];
            Picture picture;
            picture.image = image(i ? 'b' : 'a');
            picture.sha256 = sha256Of(*picture.image);
            s.picture = picture;
            p.strokes[i] = std::make_shared<const Stroke>(s);
        }
        const QByteArray whole = writeSuffuseFile(p);
        QByteArray bytes = whole;
        flip(bytes, test::startOf(whole, "IMAG", 0) + 20); // the paper's
        auto d = opened(bytes);
        QVERIFY2(d, d ? "" : qPrintable(d.error()));
        QCOMPARE(d->painting.canvas.paper.kind, PaperKind::None);
        QVERIFY(d->painting.underlay && *d->painting.underlay->image == *underlay->image);
        QVERIFY(anyContains(d->losses, "image of the paper is missing"));
        QVERIFY(*d->painting.strokes[1]->picture->image == *p.strokes[1]->picture->image);
        // Where it cannot be told what was lost no image is taken for another.
        bytes = whole;
        flip(bytes, test::startOf(whole, "IMAG", 0) + 1);
        d = opened(bytes);
        QVERIFY2(d, d ? "" : qPrintable(d.error()));
        QVERIFY(!d->painting.underlay && d->painting.canvas.paper.kind == PaperKind::None);
        QCOMPARE(d->painting.strokes.size(), std::size_t(6));
        QVERIFY(d->painting.strokes[0]->picture->image && d->painting.strokes[1]->picture->image);
        // A picture whose image is lost stays, so that a file that has the image could give it back.
        bytes = whole;
        flip(bytes, test::startOf(whole, "IMAG", 2) + 20);
        d = opened(bytes);
        QVERIFY2(d, d ? "" : qPrintable(d.error()));
        QVERIFY(!d->painting.strokes[0]->picture->image && *d->painting.strokes[0]->picture == *p.strokes[0]->picture);
        QVERIFY(d->painting.strokes[1]->picture->image && d->painting.underlay->image);
        QVERIFY(anyContains(d->losses, "of an image layer is missing") || anyContains(d->losses, "image layer(s)"));
        const auto again = readSuffuseFile(writeSuffuseFile(d->painting), QString());
        QVERIFY(again && *again == d->painting);
    }

    /// It says nothing of the painting: any bit of it, all of it, more or less of it, and what lies before it.
    void theSignatureIsNoPartOfThePainting()
    {
        const Painting p = largePainting();
        const QByteArray whole = writeSuffuseFile(p);
        std::vector<QByteArray> files;
        for (int bit = 0; bit < 8 * int(suffuseSignatureSize); ++bit) {
            files.push_back(whole);
            files.back()[bit / 8] = char(whole[bit / 8] ^ (1 << bit % 8));
        }
        const QByteArray chunks = whole.mid(suffuseSignatureSize);
        files.insert(files.end(),
                     {QByteArray(suffuseSignatureSize, '\0') + chunks, chunks, "\x89SUFFUSE\n\x1a\n" + chunks,
                      "x,y\n1,2\n...." + chunks, QByteArray(700, 'x') + chunks});
        for (const QByteArray &file : files) {
            const auto d = opened(file);
            QVERIFY2(d, d ? "" : qPrintable(d.error()));
            QVERIFY2(d->losses.empty(), d->losses.empty() ? "" : qPrintable(d->losses.front()));
            QVERIFY(d->painting == p);
            QCOMPARE(d->leftOut,
                     QStringLiteral("Damaged and left out: the first bytes of the file. All 6 strokes are here."));
            QVERIFY(!readPainting(file, QStringLiteral("a.suffuse")));
            QVERIFY(suffuseChunks(file, QStringLiteral("a.suffuse")));
        }
    }

    /// With HEAD behind it, or a chunk of strokes.
    void theSignatureAndMore()
    {
        const Painting p = largePainting();
        const QByteArray whole = writeSuffuseFile(p);
        QByteArray bytes = whole;
        bytes.replace(0, 40, QByteArray(40, '\0'));
        auto d = opened(bytes);
        QVERIFY2(d, d ? "" : qPrintable(d.error()));
        QVERIFY(d->painting == p);
        QVERIFY(anyContains(d->losses, "how many there were is not known"));
        bytes = whole;
        flip(bytes, 3);
        flip(bytes, test::startOf(whole, "STRK", 1) + 30);
        d = opened(bytes);
        QVERIFY2(d, d ? "" : qPrintable(d.error()));
        QCOMPARE(ids(d->painting), (std::vector<StrokeId>{1, 2, 5, 6}));
        QVERIFY(anyContains(d->losses, "the first bytes of the file"));
        QVERIFY(anyContains(d->losses, "2 of 6 strokes are missing"));
        // A chunk that went without a trace is noticed, as with a good signature.
        const qsizetype a = test::startOf(whole, "STRK", 0), b = test::startOf(whole, "STRK", 1);
        bytes = whole.left(a) + whole.mid(b);
        flip(bytes, 3);
        d = opened(bytes);
        QVERIFY(d && anyContains(d->losses, "2 of 6 strokes are missing"));
    }

    /// It is made of chunks, too, but is opened by what recovers.
    void aJournalIsNoDocument()
    {
        const QByteArray whole = writeSuffuseFile(largePainting());
        QByteArray journal = QByteArray(journalName) + suffuseLineEnds;
        appendChunk(journal, "HEAD", "x");
        appendChunk(journal, "BASE", whole);
        QCOMPARE(detectFormat(journal), FileFormat::Unknown);
        QVERIFY(!opened(journal));
    }

    void newerAndEmptyFilesStayErrors()
    {
        test::ChunkList chunks = test::chunksOf(writeSuffuseFile(largePainting()));
        chunks.insert(chunks.begin() + 1, {"NEWS", "x"});
        QVERIFY(!opened(test::fileOf(chunks)));
        QByteArray damaged = test::fileOf(chunks);
        damaged.chop(3);
        const auto d = opened(damaged);
        QVERIFY(!d && d.error().contains(QLatin1String("update Suffuse")));
        QVERIFY(!opened({}));
        const auto nothing = opened(test::fileOf({}).left(15));
        QVERIFY(!nothing && nothing.error().contains(QLatin1String("nothing in it is whole")));
    }

    void otherFormatsAreWholeOrErrors()
    {
        const Painting p = largePainting();
        const QByteArray text = writeTextForm(p);
        const auto d = readDocument(text, QStringLiteral("a.json"));
        QVERIFY(d && d->losses.empty() && d->painting == p && d->format == FileFormat::Text);
        QVERIFY(!readDocument(text.left(text.size() / 2), QStringLiteral("a.json")));
    }

    void everyTruncationOfASmallFile()
    {
        const QByteArray bytes = smallFile();
        const auto whole = opened(bytes);
        int salvaged = 0;
        for (qsizetype size = 0; size < bytes.size(); size += step)
            salvaged += checkDamaged(bytes.left(size), &whole->painting);
        qInfo("%d of %lld cut files gave something", salvaged, static_cast<long long>(bytes.size() / step));
        QVERIFY(salvaged > bytes.size() / step / 2);
    }

    void everyBitOfASmallFile_data()
    {
        QTest::addColumn<int>("bit");
        for (int bit = 0; bit < 8; ++bit)
            QTest::newRow(qPrintable(QString::number(bit))) << bit;
    }
    void everyBitOfASmallFile()
    {
        QFETCH(int, bit);
        const QByteArray bytes = smallFile();
        const auto whole = opened(bytes);
        int salvaged = 0, tried = 0;
        for (qsizetype at = bit % step; at < bytes.size(); at += step, ++tried) {
            QByteArray damaged = bytes;
            damaged[at] = char(damaged[at] ^ (1 << bit));
            salvaged += checkDamaged(damaged, &whole->painting);
        }
        qInfo("%d of %d damaged files gave something", salvaged, tried);
        QVERIFY(tried >= bytes.size() / step);
        QCOMPARE(salvaged, tried);
    }

    /// SUFFUSE_LONG=1: as many as before a release, 201,000.
    void randomDamage_data()
    {
        QTest::addColumn<quint32>("seed");
        const quint32 rows = isLongRun() ? 67 : 1;
        for (quint32 seed = 77; seed < 77 + rows; ++seed)
            QTest::newRow(qPrintable(QString::number(seed))) << seed;
    }
    void randomDamage()
    {
        QFETCH(quint32, seed);
        constexpr int trials = 3'000 / step;
        test::RandomPaintings random(seed);
        std::vector<QByteArray> files;
        for (int k = 0; k < 20; ++k)
            files.push_back(writeSuffuseFile(random.painting(k % 7, 20)));
        int salvaged = 0;
        for (int trial = 0; trial < trials; ++trial) {
            QByteArray bytes = files[random.below(int(files.size()))];
            for (quint32 blows = 1 + random.below(4); blows > 0 && !bytes.isEmpty(); --blows)
                damage(bytes, files[random.below(int(files.size()))], random);
            salvaged += checkDamaged(bytes);
        }
        qInfo("%d of %d randomly damaged files gave something", salvaged, trials);
        QVERIFY(salvaged > trials / 4);
    }

private:
    /// With a preview, a view and a history.
    static QByteArray smallFile()
    {
        test::RandomPaintings random(7);
        DocumentExtras extras;
        extras.preview = QByteArray("\x89PNG\r\n\x1a\n") + QByteArray(40, 'x');
        extras.view = WorkspaceState{{10, 20}, 2, 0, false, {}};
        extras.history = QByteArray(60, 'h');
        QByteArray bytes;
        for (int segments = 4; bytes.size() < 4096; segments += 4)
            bytes = writeSuffuseFile(random.painting(8, segments), extras);
        return bytes;
    }

    static void damage(QByteArray &bytes, const QByteArray &other, test::RandomPaintings &random)
    {
        const qsizetype at = random.below(int(bytes.size()));
        const qsizetype length = random.below(int(std::min<qsizetype>(200, bytes.size() - at))) + 1;
        switch (random.below(6)) {
        case 0:
            bytes.truncate(at);
            break;
        case 1:
            bytes.remove(at, length);
            break;
        case 2:
            bytes.insert(at, bytes.mid(random.below(int(bytes.size())), length));
            break;
        case 3:
            bytes.replace(at, length, QByteArray(length, char(random.below(256))));
            break;
        case 4:
            bytes.replace(at, bytes.size() - at, other.mid(std::min(at, other.size())));
            break;
        default:
            bytes[at] = char(bytes[at] ^ (1 << random.below(8)));
        }
    }

    /// An error with the file's name, or a painting that can be saved; true for the latter. Without a loss it is
    /// `whole`.
    static bool checkDamaged(const QByteArray &bytes, const Painting *whole = nullptr)
    {
        const auto d = opened(bytes);
        if (!d) {
            if (!d.error().startsWith(QLatin1String("a.suffuse: ")))
                QTest::qFail(qPrintable(d.error()), __FILE__, __LINE__);
            return false;
        }
        const auto back = readPainting(writeSuffuseFile(d->painting, d->extras), QStringLiteral("b.suffuse"));
        if (!back || !(*back == d->painting))
            QTest::qFail("what was salvaged cannot be saved", __FILE__, __LINE__);
        if (whole && d->losses.empty() && !(d->painting == *whole))
            QTest::qFail("another picture without a loss", __FILE__, __LINE__);
        if (d->losses.empty() && d->leftOut.isEmpty() && !readPainting(bytes, QStringLiteral("a.suffuse")))
            QTest::qFail("a loss was not told", __FILE__, __LINE__);
        return true;
    }
};

QTEST_APPLESS_MAIN(TestSuffuseSalvage)
#include "test_suffuse_salvage.moc"
