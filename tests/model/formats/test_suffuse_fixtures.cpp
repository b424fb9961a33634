// Files of every version keep opening, bit for bit (tests/fixtures).
#include "model/formats/files.h"

#include <QDir>
#include <QFile>
#include <QTest>

using namespace suffuse;

namespace {

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QDir fixtures()
{
    return QDir(QStringLiteral(SUFFUSE_SOURCE_DIR "/tests/fixtures"));
}

} // namespace

class TestSuffuseFixtures : public QObject {
    Q_OBJECT

private slots:
    void stillOpens_data()
    {
        QTest::addColumn<QString>("path");
        for (const QString &version : fixtures().entryList({QStringLiteral("v*")}, QDir::Dirs))
            for (const QString &name : QDir(fixtures().filePath(version)).entryList({QStringLiteral("*.suffuse")}))
                QTest::newRow(qPrintable(version + '/' + name)) << fixtures().filePath(version + '/' + name);
    }
    void stillOpens()
    {
        QFETCH(QString, path);
        const auto document = loadDocument(path);
        QVERIFY2(document, document ? "" : qPrintable(document.error()));
        QVERIFY(document->losses.empty());
        QString text = path;
        text.replace(QLatin1String(".suffuse"), QLatin1String(".json"));
        QCOMPARE(writeTextForm(document->painting), contentOf(text));
        const Result<Painting> read = readTextForm(contentOf(text), text);
        QVERIFY2(read, read ? "" : qPrintable(read.error()));
        QVERIFY(*read == document->painting && hashOf(*read) == hashOf(document->painting));
        const auto again = readDocument(writeDocument(document->painting, document->extras, FileFormat::Suffuse), path);
        QVERIFY(again && again->painting == document->painting && again->extras == document->extras);
    }

    /// The files of a folder are of its version as text; documents have no version 5 of their own.
    void everyVersionIsThere()
    {
        for (int version = 1; version <= 5; ++version) {
            const QDir folder(fixtures().filePath(QStringLiteral("v%1").arg(version)));
            const QStringList names = folder.entryList({QStringLiteral("*.json")});
            QVERIFY(!names.isEmpty());
            for (const QString &name : names)
                QVERIFY2(contentOf(folder.filePath(name)).contains("\"version\": " + QByteArray::number(version) + ","),
                         qPrintable(name));
        }
    }

    void followedTextsOfVersion5()
    {
        const auto document = loadDocument(fixtures().filePath(QStringLiteral("v5/followed.suffuse")));
        QVERIFY2(document, document ? "" : qPrintable(document.error()));
        const std::vector<Group> &groups = document->painting.groups;
        QCOMPARE(groups.size(), std::size_t(2));
        QCOMPARE(groups[0].text->follows, StrokeId(7));
        QCOMPARE(groups[0].text->followMap, (Affine{0.1, -1e12, 3, 0, {0.30000000000000004, -1e-9}}));
        QCOMPARE(groups[1].text->follows, StrokeId(4503599627370497));
        QVERIFY(groups[1].text->followMap.isIdentity());
    }

    void extrasOfVersion1()
    {
        const auto document = loadDocument(fixtures().filePath(QStringLiteral("v1/extras.suffuse")));
        QVERIFY2(document, document ? "" : qPrintable(document.error()));
        const DocumentExtras &extras = document->extras;
        QVERIFY(extras.preview.startsWith("\x89PNG"));
        QVERIFY(extras.view.has_value());
        QCOMPARE(*extras.view, (WorkspaceState{{12.5, -40}, 2, 0.25, true, 1'500'000}));
        QCOMPARE(extras.unknown, (std::vector<AncillaryChunk>{{"zzzz", ""}, {"licn", "CC BY 4.0"}}));
    }
};

QTEST_APPLESS_MAIN(TestSuffuseFixtures)
#include "test_suffuse_fixtures.moc"
