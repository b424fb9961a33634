// suffuse-cli recover: lists journals and writes one to a file.
#include "cli_process.h"
#include "model/formats/files.h"
#include "model/journal/journal_writer.h"
#include "model/brush/stroke_builder.h"

#include <QJsonArray>
#include <QTest>

using namespace suffuse;

class TestRecover : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        auto painting = std::make_shared<Painting>();
        painting->canvas.width = 321;
        std::vector<PenSample> samples;
        for (int i = 0; i < 20; ++i)
            samples.push_back({{10.0 + 5 * i, 50.0 + i * i}, 10'000 * i, 0.5f});
        painting->strokes.push_back(buildStroke(builtinBrushes().front(), 7, samples));
        m_painting = painting;
        JournalWriter writer(m_folder.path(), {});
        writer.begin({"flowers.suffuse", "/home/me/flowers.suffuse", {}, 300}, painting, true);
    }

    void listsAndExtracts()
    {
        const CliOutcome list = recover({"--list", "--json"});
        QCOMPARE(list.code, 0);
        const QJsonArray journals = list.json()["journals"].toArray();
        QCOMPARE(journals.size(), 1);
        const QJsonObject journal = journals[0].toObject();
        QCOMPARE(journal["state"].toString(), QString("lost"));
        QCOMPARE(journal["name"].toString(), QString("flowers.suffuse"));
        QCOMPARE(journal["path"].toString(), QString("/home/me/flowers.suffuse"));
        QCOMPARE(journal["strokes"].toInt(), 1);
        const QString id = journal["id"].toString();
        QVERIFY(QString::fromUtf8(recover({}).out).contains(id));
        QVERIFY(recover({}).out.contains("flowers.suffuse, 1 stroke\n"));

        for (const QString &name : {QString("a.suffuse"), QString("a.json")}) {
            const QString out = m_folder.filePath(name);
            const CliOutcome written = recover({id, "-o", out});
            QVERIFY2(written.code == 0, qPrintable(written.text()));
            QCOMPARE(hashOf(*loadPainting(out)), hashOf(*m_painting));
        }
        QCOMPARE(loadDocument(m_folder.filePath("a.suffuse"))->extras.resolution, 300.0); // as large on paper
        QCOMPARE(recover({}).out, recover({"--list"}).out); // it is still there
    }

    void wrongUseIsToldApart()
    {
        QCOMPARE(recover({"x"}).code, 2);
        QCOMPARE(recover({"-o", "a.suffuse"}).code, 2);
        QCOMPARE(recover({"--list", "x", "-o", "a.suffuse"}).code, 2);
        const CliOutcome picture = recover({"x", "-o", m_folder.filePath("b.png")});
        QCOMPARE(picture.code, 2);
        QVERIFY2(picture.err.contains(".suffuse or .json"), qPrintable(picture.text()));
        const CliOutcome missing = recover({"x", "-o", m_folder.filePath("b.suffuse")});
        QCOMPARE(missing.code, 1);
        QVERIFY(missing.err.contains("there is no such journal"));
        QVERIFY(!QFile::exists(m_folder.filePath("b.suffuse")));
        const CliOutcome nothing = runCli({"recover"}, {}, {"SUFFUSE_JOURNALS=" + m_folder.filePath("none")});
        QCOMPARE(nothing.code, 0);
        QVERIFY(nothing.out.contains("nothing to recover"));
    }

    void whatARunningProgramWritesIsLeftAlone()
    {
        QTemporaryDir folder;
        JournalWriter writer(folder.path(), {});
        writer.begin({"a", {}, {}}, m_painting, true);
        writer.flush();
        const CliOutcome list = runCli({"recover", "--json"}, {}, {"SUFFUSE_JOURNALS=" + folder.path()});
        QCOMPARE(list.json()["journals"].toArray()[0].toObject()["state"].toString(), QString("in use"));
    }

private:
    CliOutcome recover(const QStringList &arguments) const
    {
        return runCli(QStringList{"recover"} + arguments, {}, {"SUFFUSE_JOURNALS=" + m_folder.path()});
    }

    QTemporaryDir m_folder;
    PaintingPtr m_painting;
};

QTEST_APPLESS_MAIN(TestRecover)
#include "test_recover.moc"
