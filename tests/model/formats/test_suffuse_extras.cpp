// What a document file holds beside the picture.
#include "model/formats/files.h"
#include "suffuse_chunks.h"
#include "tests/model/random_paintings.h"

#include <QCborArray>
#include <QCborMap>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <limits>

using namespace suffuse;

namespace {

DocumentExtras someExtras()
{
    DocumentExtras extras;
    extras.preview = QByteArray("\x89PNG\r\n\x1a\n") + "pixels";
    extras.view = WorkspaceState{{-12.5, 1e9}, 3.25, -0.7, true, 1'234'567, false, 7, {3, 7}};
    extras.history = "steps";
    extras.profile = "a profile";
    extras.resolution = 72.5;
    extras.unknown = {{"meta", QByteArray("\0a\xff", 3)}, {"xyzw", {}}, {"meta", "again"}};
    return extras;
}

Painting somePainting()
{
    return test::RandomPaintings(41).painting(5, 12);
}

/// Chunks that a reader may not skip, as bytes.
test::ChunkList pictureOf(const QByteArray &file)
{
    test::ChunkList chunks = test::chunksOf(file);
    std::erase_if(chunks, [](const auto &c) { return c.first.front() >= 'a'; });
    return chunks;
}

} // namespace

class TestSuffuseExtras : public QObject {
    Q_OBJECT

private slots:
    void extrasComeBack()
    {
        const QByteArray bytes = writeDocument(somePainting(), someExtras(), FileFormat::Suffuse);
        const auto d = readDocument(bytes, QStringLiteral("a.suffuse"));
        QVERIFY2(d, d ? "" : qPrintable(d.error()));
        QVERIFY(d->losses.empty());
        QVERIFY(d->painting == somePainting());
        QVERIFY(d->extras == someExtras());
        QCOMPARE(writeDocument(d->painting, d->extras, FileFormat::Suffuse), bytes);
        const auto p = readPainting(bytes, QStringLiteral("a.suffuse"));
        QVERIFY(p && *p == somePainting());
    }

    /// Where all of the canvas was shown, the file does not say where its middle was.
    void aViewOfAllComesBack()
    {
        DocumentExtras extras;
        WorkspaceState &view = extras.view.emplace();
        view.isFitted = true;
        view.layer = 2;
        view.begun = BegunLayer{"Shades", true, 2, 5};
        view.symmetry = Symmetry{true, SymmetryKind::Kaleidoscope, {10.5, -3}, 0.25, 7};
        view.guides = {{false, 12.5}, {false, -4}, {true, 1e6}};
        view.assistants = {{AssistantKind::Ruler, {{1, 2}, {-3.5, 4}}},
                           {AssistantKind::VanishingPoint, {{1e9, -0.25}}},
                           {AssistantKind::Perspective, {{0, 0}, {9, 1}, {8, 7}, {-1, 6}}},
                           {AssistantKind::Concentric, {{5, 5}, {8, 5}, {5, 7}}}};
        view.print = PrintSetup{"Letter", true, {1, 2.5, 3, 4}, PrintSetup::Size::Scaled, 12.5, PrintSetup::Area::Numbers,
                                Rect::of(-1, 2, 30, 40), PrintSetup::Moment::Time, 1'500'000, false, 720};
        const auto d = readDocument(writeDocument(somePainting(), extras, FileFormat::Suffuse), "a.suffuse");
        QVERIFY(d && d->extras == extras);
    }

    /// What makes no sense of a page leaves all else as it is.
    void pagesThatCannotBeAreLeftOut()
    {
        const auto printOf = [](const PrintSetup &print) {
            DocumentExtras extras;
            extras.view = WorkspaceState{};
            extras.view->guides = {{true, 7}};
            extras.view->print = print;
            const auto d = readDocument(writeDocument(somePainting(), extras, FileFormat::Suffuse), "a.suffuse");
            return d && d->extras.view && d->extras.view->guides == extras.view->guides ? d->extras.view->print
                                                                                         : std::optional(PrintSetup{"?"});
        };
        const PrintSetup good;
        QCOMPARE(printOf(good), std::optional(good));
        const auto changed = [&](auto change) {
            PrintSetup print = good;
            change(print);
            return printOf(print);
        };
        const std::optional<PrintSetup> none;
        QCOMPARE(changed([](PrintSetup &p) { p.margins[2] = -1; }), none);
        QCOMPARE(changed([](PrintSetup &p) { p.margins[2] = std::nan(""); }), none);
        QCOMPARE(changed([](PrintSetup &p) { p.scale = 0; }), none);
        QCOMPARE(changed([](PrintSetup &p) { p.dpi = 1; }), none);
        QCOMPARE(changed([](PrintSetup &p) { p.dpi = 1'000'000; }), none);
        QCOMPARE(changed([](PrintSetup &p) { p.size = PrintSetup::Size(7); }), none);
        QCOMPARE(changed([](PrintSetup &p) { p.area = PrintSetup::Area::Numbers; }), none); // an area that is none
        QCOMPARE(changed([](PrintSetup &p) { p.paper = QString(1000, 'A'); }), none);
    }

    void pictureChunksDoNotDependOnThem()
    {
        const Painting p = somePainting();
        QCOMPARE(pictureOf(writeDocument(p, someExtras(), FileFormat::Suffuse)), test::chunksOf(writeSuffuseFile(p)));
        DocumentExtras none;
        none.view = WorkspaceState{};
        QCOMPARE(pictureOf(writeDocument(p, none, FileFormat::Suffuse)), test::chunksOf(writeSuffuseFile(p)));
    }

    /// Written by a program that knows more.
    void unknownChunksSurviveASave()
    {
        const Painting p = somePainting();
        test::ChunkList chunks = test::chunksOf(writeSuffuseFile(p));
        chunks.insert(chunks.begin() + 1, {"licn", "CC BY"});
        chunks.push_back({"futu", QByteArray(1000, 'f')});
        QTemporaryDir folder;
        const auto d = readDocument(test::fileOf(chunks), QStringLiteral("a.suffuse"));
        QVERIFY2(d, d ? "" : qPrintable(d.error()));
        const QString path = folder.filePath(QStringLiteral("b.suffuse"));
        QVERIFY(saveDocument(d->painting, d->extras, path));
        const auto again = loadDocument(path);
        QVERIFY(again && again->painting == p);
        QCOMPARE(again->extras.unknown,
                 (std::vector<AncillaryChunk>{{"licn", "CC BY"}, {"futu", QByteArray(1000, 'f')}}));
    }

    void previewStandsAtTheStart()
    {
        const auto chunks = test::chunksOf(writeDocument(somePainting(), someExtras(), FileFormat::Suffuse));
        QCOMPARE(chunks[0].first, QByteArray("HEAD"));
        QCOMPARE(chunks[1].first, QByteArray("prev"));
        QCOMPARE(chunks[2].first, QByteArray("view"));
    }

    void senselessExtrasAreLeftOut_data()
    {
        QTest::addColumn<QByteArray>("type");
        QTest::addColumn<QByteArray>("payload");
        const auto view = [](const char *name, const QCborValue &value) {
            QCborMap map{{QLatin1String("centre"), QCborArray{1.0, 2.0}}, {QLatin1String("scale"), 1.0}};
            map.insert(QLatin1String(name), value);
            return QCborValue(map).toCbor();
        };
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("no PNG") << QByteArray("prev") << QByteArray("GIF89a");
        QTest::newRow("huge PNG") << QByteArray("prev") << QByteArray("\x89PNG\r\n\x1a\n") + QByteArray(2 << 20, 'x');
        QTest::newRow("no CBOR") << QByteArray("view") << QByteArray("\xff\xff");
        QTest::newRow("empty") << QByteArray("view") << QByteArray();
        QTest::newRow("NaN scale") << QByteArray("view") << view("scale", nan);
        QTest::newRow("no scale") << QByteArray("view") << view("scale", 0.0);
        QTest::newRow("endless centre") << QByteArray("view")
                                        << view("centre", QCborArray{1.0, std::numeric_limits<double>::infinity()});
        QTest::newRow("short centre") << QByteArray("view") << view("centre", QCborArray{1.0});
        QTest::newRow("NaN rotation") << QByteArray("view") << view("rotation", nan);
        QTest::newRow("type") << QByteArray("view") << view("mirrored", 3);
        for (const auto &[name, value] : {std::pair("no inch", QCborValue(0.0)),
                                          {"a huge inch", QCborValue(1e9)},
                                          {"NaN inch", QCborValue(nan)},
                                          {"an inch in words", QCborValue("150")},
                                          {"an inch below 0", QCborValue(-150)}})
            QTest::newRow(name) << QByteArray("inch") << value.toCbor();
        QTest::newRow("inch of no CBOR") << QByteArray("inch") << QByteArray("\xff\xff");
    }
    void senselessExtrasAreLeftOut()
    {
        QFETCH(QByteArray, type);
        QFETCH(QByteArray, payload);
        test::ChunkList chunks = test::chunksOf(writeSuffuseFile(somePainting()));
        chunks.insert(chunks.begin() + 1, {type, payload});
        const auto d = readDocument(test::fileOf(chunks), QStringLiteral("a.suffuse"));
        QVERIFY2(d, d ? "" : qPrintable(d.error()));
        QVERIFY(d->painting == somePainting());
        QVERIFY(d->extras == DocumentExtras());
    }

    /// What makes no sense in the aids for drawing is left out by itself, and the view stays.
    void senselessAidsLeaveTheView()
    {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const QCborMap symmetry{{QLatin1String("on"), true},
                                {QLatin1String("kind"), 9},
                                {QLatin1String("centre"), QCborArray{1.0, 2.0}},
                                {QLatin1String("angle"), 0.0},
                                {QLatin1String("arms"), 6}};
        const QCborMap view{{QLatin1String("layer"), 3},
                            {QLatin1String("symmetry"), symmetry},
                            {QLatin1String("guides"),
                             QCborMap{{QLatin1String("level"), QCborArray{nan, QLatin1String("no"), 5.0}},
                                      {QLatin1String("upright"), 7}}},
                            {QLatin1String("assistants"),
                             QCborArray{QCborArray{2, 10.0, 20.0}, QCborArray{2, nan, 20.0}, QCborArray{2, 10.0},
                                        QCborArray{2, 1e13, 20.0}, QCborArray{2, 10.0, 20.0, 30.0, 40.0},
                                        QCborArray{6, 10.0, 20.0}, QCborArray{-1, 10.0, 20.0}, QCborArray{},
                                        QLatin1String("no"), QCborArray{QLatin1String("no"), 1.0, 2.0},
                                        QCborArray{0, 1, 2, 3, 4}}}};
        test::ChunkList chunks = test::chunksOf(writeSuffuseFile(somePainting()));
        chunks.insert(chunks.begin() + 1, {"view", QCborValue(view).toCbor()});
        const auto d = readDocument(test::fileOf(chunks), QStringLiteral("a.suffuse"));
        QVERIFY2(d, d ? "" : qPrintable(d.error()));
        QVERIFY(d->extras.view && !d->extras.view->symmetry);
        QCOMPARE(d->extras.view->layer, GroupId(3));
        QCOMPARE(d->extras.view->guides, (std::vector<Guide>{{false, 5}}));
        QCOMPARE(d->extras.view->assistants,
                 (std::vector<Assistant>{{AssistantKind::VanishingPoint, {{10, 20}}},
                                         {AssistantKind::Ruler, {{1, 2}, {3, 4}}}}));
    }

    /// CBOR that breaks off anywhere is not looked into.
    void damagedViewsDoNoHarm()
    {
        const auto whole = test::chunksOf(writeDocument(Painting(), someExtras(), FileFormat::Suffuse));
        QCOMPARE(whole[2].first, QByteArray("view"));
        const qsizetype size = whole[2].second.size();
        for (qsizetype at = 0; at < size; ++at) {
            test::ChunkList chunks = whole;
            chunks[2].second.truncate(at);
            const auto cut = readDocument(test::fileOf(chunks), QStringLiteral("a.suffuse"));
            QVERIFY(cut && !cut->extras.view);
            for (int value = 0; value < 256; ++value) {
                chunks[2].second = whole[2].second;
                chunks[2].second[at] = char(value);
                QVERIFY(readDocument(test::fileOf(chunks), QStringLiteral("a.suffuse")));
            }
        }
    }

    /// Files of today have no size on paper, and whoever reads the painting alone can ask for it.
    void theSizeOnPaperIsRead()
    {
        QTemporaryDir folder;
        const QString with = folder.filePath("with.suffuse"), without = folder.filePath("without.suffuse");
        QVERIFY(saveDocument(somePainting(), someExtras(), with) && savePainting(somePainting(), without));
        double resolution = -1;
        QVERIFY(loadPainting(with, nullptr, nullptr, &resolution));
        QCOMPARE(resolution, 72.5);
        QVERIFY(loadPainting(without, nullptr, nullptr, &resolution));
        QCOMPARE(resolution, 0.0);
        QVERIFY(!test::fileOf(test::chunksOf(writeSuffuseFile(somePainting()))).contains("inch"));
    }

    void textFormHoldsNone()
    {
        QCOMPARE(writeDocument(somePainting(), someExtras(), FileFormat::Text), writeTextForm(somePainting()));
    }
};

QTEST_APPLESS_MAIN(TestSuffuseExtras)
#include "test_suffuse_extras.moc"
