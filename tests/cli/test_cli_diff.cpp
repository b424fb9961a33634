// suffuse-cli diff, and damaged documents on the command line.
#include "cli_process.h"
#include "model/formats/files.h"

#include <QJsonArray>
#include <QTest>

using namespace suffuse;

namespace {

StrokePtr stroke(StrokeId id, int segments, double y)
{
    auto s = std::make_shared<Stroke>();
    s->id = id;
    s->name = QStringLiteral("s%1").arg(id);
    s->segments.resize(std::size_t(segments));
    for (int k = 0; k < segments; ++k) {
        const float x = float(10 + 10 * k);
        Segment &segment = s->segments[std::size_t(k)];
        segment.bezier = {Offset{x, float(y)}, Offset{x + 3, float(y)}, Offset{x + 6, float(y)},
                          Offset{x + 10, float(y)}};
    }
    return s;
}

Painting base()
{
    Painting p;
    p.canvas.width = 100;
    p.canvas.height = 80;
    for (StrokeId id = 1; id <= 4; ++id)
        p.strokes.push_back(stroke(id, 5, 10.0 * double(id)));
    return p;
}

/// Stroke 2 goes, 5 comes, 3 and the canvas change, 1 moves to the top.
Painting edited()
{
    Painting p = base();
    auto changed = std::make_shared<Stroke>(*p.strokes[2]);
    changed->segments[1].diffusion = 20;
    changed->segments.push_back(stroke(3, 6, 30)->segments.back());
    changed->locked = true;
    p.strokes = {changed, p.strokes[3], stroke(5, 2, 70), p.strokes[0]};
    p.canvas.background = {0.5f, 0, 0, 1};
    p.swatches = {{QStringLiteral("red"), {1, 0, 0, 1}}};
    return p;
}

} // namespace

class TestCliDiff : public QObject {
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString path(const char *name) const { return m_folder.filePath(QString::fromLatin1(name)); }

private slots:
    void initTestCase()
    {
        QVERIFY(savePainting(base(), path("a.suffuse")));
        QVERIFY(savePainting(base(), path("a.json")));
        QVERIFY(savePainting(edited(), path("b.suffuse")));
    }

    void theSame()
    {
        const CliOutcome outcome = runCli({"diff", path("a.suffuse"), path("a.json")});
        QVERIFY2(outcome.code == 0, qPrintable(outcome.text()));
        QVERIFY(outcome.out.contains("hold the same painting"));
        const CliOutcome asJson = runCli({"diff", path("a.suffuse"), path("a.json"), "--json"});
        QCOMPARE(asJson.code, 0);
        QCOMPARE(asJson.json()["same"].toBool(), true);
        QVERIFY(asJson.json()["changed"].toArray().isEmpty());
    }

    void asText()
    {
        const CliOutcome outcome = runCli({"diff", path("a.suffuse"), path("b.suffuse")});
        QVERIFY2(outcome.code == 1, qPrintable(outcome.text()));
        const QString text = QString::fromUtf8(outcome.out);
        for (const char *line :
             {": 1 stroke added, 1 removed, 1 changed, 1 moved\n", "\ncanvas.background: [0,0,0,1] → [0.5,0,0,1]\n",
              "\nswatches[0].name: + \"red\"\n", "\n- stroke 2 “s2”, segments: 5\n", "\n+ stroke 5 “s5”, segments: 2\n",
              "\n~ stroke 3 “s3”\n    segments added: 5\n    locked: false → true\n"
              "    segments[1].diffusion: 12.5 → 20\n",
              "\n^ stroke 1 “s1”: from place 0 to 3\n"})
            QVERIFY2(text.contains(QString::fromUtf8(line)),
                     qPrintable(QString::fromUtf8(line) + "\nis not in\n" + text));
    }

    void asJson()
    {
        const CliOutcome outcome = runCli({"diff", path("a.suffuse"), path("b.suffuse"), "--json"});
        QVERIFY2(outcome.code == 1, qPrintable(outcome.text()));
        const QJsonObject json = outcome.json();
        QCOMPARE(json["same"].toBool(true), false);
        QCOMPARE(json["added"].toArray(), (QJsonArray{QJsonObject{{"id", 5}, {"name", "s5"}, {"segments", 2}}}));
        QCOMPARE(json["removed"].toArray(), (QJsonArray{QJsonObject{{"id", 2}, {"name", "s2"}, {"segments", 5}}}));
        QCOMPARE(json["moved"].toArray(), (QJsonArray{QJsonObject{{"id", 1}, {"before", 0}, {"after", 3}}}));
        QCOMPARE(json["changed"].toArray().size(), 1);
        const QJsonObject changed = json["changed"].toArray()[0].toObject();
        QCOMPARE(changed["segmentsChanged"].toArray(), QJsonArray{1});
        QCOMPARE(changed["segmentsAdded"].toArray(), QJsonArray{5});
        QCOMPARE(changed["segmentsRemoved"].toArray(), QJsonArray());
        QCOMPARE(changed["values"].toArray(),
                 (QJsonArray{QJsonObject{{"path", "locked"}, {"before", false}, {"after", true}},
                             QJsonObject{{"path", "segments[1].diffusion"}, {"before", 12.5}, {"after", 20}}}));
        QCOMPARE(json["values"].toArray().size(), 4); // one of the canvas, three of a swatch that came
        QCOMPARE(json["values"].toArray()[1].toObject()["before"], QJsonValue());
    }

    void aPictureShowsWhere()
    {
        const QString out = path("d.pfm");
        const CliOutcome outcome = runCli({"diff", path("a.suffuse"), path("b.suffuse"), "-o", out});
        QVERIFY2(outcome.code == 1, qPrintable(outcome.text()));
        const QByteArray pfm = readFile(out);
        QVERIFY(pfm.startsWith("PF\n100 80\n"));
        const auto *pixels = reinterpret_cast<const float *>(pfm.constData() + (pfm.size() - 100 * 80 * 12));
        const auto at = [&](int x, int y) { return pixels + ((79 - y) * 100 + x) * 3; }; // from the bottom
        const auto isGrey = [](const float *p) {
            return std::abs(p[0] - p[1]) < 1e-4f && std::abs(p[1] - p[2]) < 1e-4f;
        };
        QVERIFY(at(35, 20)[0] > at(35, 20)[2] + 0.3f); // removed: orange
        QVERIFY(at(20, 70)[1] > at(20, 70)[0] + 0.3f); // added: green
        QVERIFY(at(35, 30)[2] > at(35, 30)[0] + 0.3f); // changed: blue
        QVERIFY(at(35, 10)[2] > at(35, 10)[0] + 0.3f); // moved
        QVERIFY(isGrey(at(35, 40)));                   // as it was
        QVERIFY(isGrey(at(90, 75)));
    }

    void troubleIsNoDifference()
    {
        QCOMPARE(runCli({"diff", path("a.suffuse")}).code, 2);
        QCOMPARE(runCli({"diff", path("a.suffuse"), path("none.suffuse")}).code, 2);
        QCOMPARE(runCli({"diff", "-", "-"}).code, 2);
        QCOMPARE(runCli({"diff", path("a.suffuse"), path("b.suffuse"), "--size", "30"}).code, 2);
        QCOMPARE(runCli({"diff", path("a.suffuse"), path("b.suffuse"), "-o", path("x.bmp")}).code, 2);
        QCOMPARE(runCli({"diff", path("a.suffuse"), path("b.suffuse"), "-o", path("no/x.pfm")}).code, 2);
        QCOMPARE(runCli({"diff", "-", path("a.json")}, readFile(path("a.suffuse"))).code, 0);
    }

    void damagedDocuments()
    {
        QByteArray bytes = readFile(path("a.suffuse"));
        bytes.chop(5);
        QVERIFY(writeFile(path("damaged.suffuse"), bytes));
        const CliOutcome info = runCli({"info", path("damaged.suffuse"), "--json"});
        QCOMPARE(info.code, 1);
        QCOMPARE(info.json()["strokes"].toInt(), 4);
        QVERIFY(info.json()["losses"].toArray().size() >= 2);
        QVERIFY(info.err.contains("all 4 strokes are here"));
        const CliOutcome refused = runCli({"convert", path("damaged.suffuse"), path("c.suffuse")});
        QCOMPARE(refused.code, 1);
        QVERIFY(refused.err.contains("--salvage"));
        QVERIFY(!QFile::exists(path("c.suffuse")));
        const CliOutcome salvaged = runCli({"convert", path("damaged.suffuse"), path("c.suffuse"), "--salvage"});
        QVERIFY2(salvaged.code == 0, qPrintable(salvaged.text()));
        QVERIFY(salvaged.err.contains("the end of the file is damaged"));
        QCOMPARE(runCli({"diff", path("a.suffuse"), path("c.suffuse")}).code, 0);
        QCOMPARE(runCli({"render", path("damaged.suffuse"), "-o", path("x.pfm")}).code, 1);
    }

    /// Its strokes are one chunk: nothing of them is left, and that is no success.
    void nothingToSalvage()
    {
        QByteArray bytes = readFile(path("a.suffuse"));
        const qsizetype at = bytes.indexOf("STRK") + 30;
        bytes[at] = char(bytes[at] ^ 4);
        QVERIFY(writeFile(path("empty.suffuse"), bytes));
        const CliOutcome salvaged = runCli({"convert", path("empty.suffuse"), path("none.suffuse"), "--salvage"});
        QCOMPARE(salvaged.code, 1);
        QVERIFY2(salvaged.err.contains("none of its 4 strokes is whole"), qPrintable(salvaged.text()));
        QVERIFY(!QFile::exists(path("none.suffuse")));
    }

    /// The picture is whole: convert needs no --salvage and says what it left out, info calls the file damaged.
    void damageBesideThePicture()
    {
        QByteArray bytes = readFile(QStringLiteral(SUFFUSE_SOURCE_DIR "/tests/fixtures/v1/extras.suffuse"));
        const qsizetype at = bytes.indexOf("prev") + 20;
        bytes[at] = char(bytes[at] ^ 4);
        QVERIFY(writeFile(path("prev.suffuse"), bytes));
        const CliOutcome converted = runCli({"convert", path("prev.suffuse"), path("whole.suffuse")});
        QCOMPARE(converted.code, 0);
        QVERIFY2(converted.err.contains("Damaged and left out: the preview. All"), qPrintable(converted.text()));
        QCOMPARE(runCli({"info", path("whole.suffuse")}).code, 0);
        const CliOutcome info = runCli({"info", path("prev.suffuse"), "--json"});
        QCOMPARE(info.code, 1);
        QCOMPARE(info.json()["losses"].toArray().size(), 1);
        QVERIFY(info.err.contains("the preview"));
    }

    void infoKnowsWhatLiesBeside()
    {
        const QString file = QStringLiteral(SUFFUSE_SOURCE_DIR "/tests/fixtures/v1/extras.suffuse");
        const CliOutcome text = runCli({"info", file});
        QCOMPARE(text.code, 0);
        for (const char *line :
             {"prev, ", "(preview)", "view, ", "zzzz, 12 bytes (unknown to this version, kept)", "licn, "})
            QVERIFY2(text.out.contains(line), qPrintable(text.text()));
        QCOMPARE(runCli({"convert", file, path("kept.suffuse")}).code, 0);
        QVERIFY(runCli({"info", path("kept.suffuse")}).out.contains("licn, 21 bytes"));
        QCOMPARE(runCli({"convert", file, path("plain.suffuse"), "--plain"}).code, 0);
        const CliOutcome plain = runCli({"info", path("plain.suffuse")});
        QVERIFY(plain.code == 0 && !plain.out.contains("licn") && !plain.out.contains("prev") &&
                plain.out.contains("DOCU"));
        QCOMPARE(runCli({"diff", file, path("plain.suffuse")}).code, 0);
    }
};

QTEST_APPLESS_MAIN(TestCliDiff)
#include "test_cli_diff.moc"
