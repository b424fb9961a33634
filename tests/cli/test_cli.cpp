// suffuse-cli's arguments, exit codes and answers.
#include "cli_process.h"

#include <QJsonArray>
#include <QTest>

#include <cmath>
#include <csignal>

#include <fcntl.h>
#include <unistd.h>

class TestCli : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void helpAndVersion();
    void wrongUsage_data();
    void wrongUsage();
    void info();
    void infoOfGroups();
    void backends();
    void convertIsExact();
    void convertLeavesItsInput();
    void convertWithBrush();
    void convertDrawing();
    void convertToDrawing();
    void textsOfDrawings();
    void probe();
    void probeTakesNegativeNumbers();
    void verify();
    void standardInput();
    void standardOutput();
    void nobodyReadsOn_data();
    void nobodyReadsOn();

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }

    QTemporaryDir m_folder;
};

void TestCli::initTestCase()
{
    QVERIFY(m_folder.isValid());
    QVERIFY(writeFile(path("a.json"), smallPainting()));
}

void TestCli::helpAndVersion()
{
    const CliOutcome help = runCli({"--help"});
    QCOMPARE(help.code, 0);
    for (const char *command : {"render", "info", "convert", "probe", "verify"}) {
        QVERIFY2(help.out.contains(command), command);
        const CliOutcome own = runCli({command, "--help"});
        QCOMPARE(own.code, 0);
        QVERIFY2(own.out.startsWith("Usage: suffuse-cli " + QByteArray(command) + " [options] "),
                 qPrintable(own.text()));
        QVERIFY2(own.out.simplified().contains("to read; -: standard input"), qPrintable(own.text()));
    }
    QCOMPARE(runCli({"help"}).out, help.out);
    QCOMPARE(runCli({"help", "render"}).out, runCli({"render", "--help"}).out);
    QCOMPARE(runCli({"help", "paint"}).code, 2);
    QCOMPARE(runCli({"--version"}).out, QByteArray("suffuse-cli " SUFFUSE_VERSION "\n"));
}

void TestCli::wrongUsage_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("says");
    const QString in = path("a.json"), out = path("out.png");
    const auto row = [](const char *name, const QStringList &arguments, const char *says) {
        QTest::newRow(name) << arguments << QString(says);
    };
    row("no command", {}, "Usage");
    row("unknown command", {"paint", in}, "no such command");
    row("unknown option", {"render", in, "-o", out, "--colour"}, "colour");
    row("no input", {"render", "-o", out}, "too few");
    row("two inputs", {"render", in, in, "-o", out}, "too many");
    row("no output", {"render", in}, "-o OUT");
    row("unknown ending", {"render", in, "-o", path("out.bmp")}, "png, tiff");
    row("wrong height", {"render", in, "-o", out, "--size", "80x61"}, "80x60");
    row("wrong height of an area", {"render", in, "-o", out, "--area", "0,0,10,20", "--size", "50x50"}, "50x100");
    row("size is no size", {"render", in, "-o", out, "--size", "big"}, "WxH");
    row("size 0", {"render", in, "-o", out, "--size", "0x0"}, "WxH");
    row("size and scale", {"render", in, "-o", out, "--size", "80", "--scale", "2"}, "not both");
    row("scale 0", {"render", in, "-o", out, "--scale", "0"}, "above 0");
    row("too large", {"render", in, "-o", out, "--size", "2000000000"}, "too large");
    row("too large by scale", {"render", in, "-o", out, "--scale", "1e300"}, "too large");
    row("too thin an area", {"render", in, "-o", out, "--area", "0,0,1e-9,1e9", "--size", "5"}, "too large");
    row("empty area", {"render", in, "-o", out, "--area", "0,0,0,5"}, "X,Y,W,H");
    row("infinite area", {"render", in, "-o", out, "--area", "0,0,inf,5"}, "X,Y,W,H");
    row("half an area", {"render", in, "-o", out, "--area", "0,0,5"}, "X,Y,W,H");
    row("no moment", {"render", in, "-o", out, "--time", "nan"}, "--time");
    row("quality 0", {"render", in, "-o", path("out.jpg"), "--quality", "0"}, "from 1 to 100");
    row("half a quality", {"render", in, "-o", path("out.jpg"), "--quality", "90.5"}, "from 1 to 100");
    row("no resolution", {"render", in, "-o", out, "--dpi", "0"}, "from 1 to 10000");
    row("a format for a file", {"render", in, "-o", out, "--format", "jpg"}, "--format is for -o -");
    row("no format", {"render", in, "-o", "-", "--format", "bmp"}, "png, tiff");
    row("two things on standard output", {"render", in, "-o", "-", "--stats"}, "standard output");
    row("a document of no format", {"convert", in, "-", "--format", "txt"}, "suffuse, json, svg or pdf");
    row("convert to a file by format", {"convert", in, path("b.json"), "--format", "json"}, "chooses the format");
    row("no depth", {"render", in, "-o", out, "--depth", "12"}, "8, 16, half or float");
    row("PNG holds no half", {"render", in, "-o", out, "--depth", "half"}, "8, 16");
    row("EXR holds no 8 bit", {"render", in, "-o", path("out.exr"), "--depth", "8"}, "half, float");
    row("JPEG is opaque", {"render", in, "-o", path("out.jpg"), "--transparent"}, "transparency");
    row("no backend", {"render", in, "-o", out, "--backend", "vulkan"}, "auto, cpu, cuda or reference");
    row("no device", {"render", in, "-o", out, "--devices", "0"}, "--devices 0");
    row("devices are no number", {"render", in, "-o", out, "--devices", "every"}, "all, or a number");
    row("devices of the CPU", {"render", in, "-o", out, "--backend", "cpu", "--devices", "all"}, "--backend cuda");
    row("no threads", {"render", in, "-o", out, "--threads", "0"}, "--threads");
    row("info without a file", {"info"}, "--backends");
    row("info of two things", {"info", in, "--backends"}, "--backends");
    row("convert without a target", {"convert", in}, "too few");
    row("convert to an unknown ending", {"convert", in, path("a.txt")}, ".suffuse, .json");
    row("convert to a picture", {"convert", in, path("a.png")}, "suffuse-cli render");
    row("convert to layers", {"convert", in, path("a.psd")}, "suffuse-cli render");
    row("a drawing of no kind", {"convert", in, path("a.svg"), "--as", "dots"}, "outlines, bands or hybrid");
    row("a drawing of no bands", {"convert", in, path("a.svg"), "--bands", "0"}, "from 1 to 256");
    row("bands of outlines", {"convert", in, path("a.svg"), "--as", "outlines", "--bands", "4"}, "--as bands");
    row("bands of a document", {"convert", in, path("a.json"), "--bands", "4"}, ".svg");
    row("a page of no size", {"convert", in, path("a.pdf"), "--page", "B9"}, "200x150mm");
    row("pages of SVG", {"convert", in, in, path("a.svg")}, "the pages of a PDF");
    row("a page of SVG", {"convert", in, path("a.svg"), "--page", "A4"}, "--page is for PDF");
    row("a size given twice", {"render", in, "-o", out, "--size", "40", "--size", "80"}, "--size is given twice");
    row("an output given twice", {"render", in, "-o", out, "--output", path("b.png")}, "--output is given twice");
    row("a switch given twice", {"info", in, "--json", "--json"}, "--json is given twice");
    row("convert onto itself", {"convert", in, in}, "another name");
    row("convert onto itself, --plain", {"convert", in, path("./a.json"), "--plain"}, "another name");
    row("no brush", {"convert", in, path("b.json"), "--brush", "spade"}, "ink-wash");
    row("probe without a place", {"probe", in, "3"}, "too few");
    row("render before the beginning", {"render", in, "-o", out, "--time", "-1"}, "nothing is painted before 0 s");
    row("probe at no number", {"probe", in, "a", "b"}, "X and Y");
    row("verify with a wrong height", {"verify", in, "--size", "80x50"}, "80x60");
}

void TestCli::wrongUsage()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, says);
    const CliOutcome outcome = runCli(arguments);
    QVERIFY2(outcome.code == 2, qPrintable(outcome.text()));
    QVERIFY2(QString::fromUtf8(outcome.err).contains(says), qPrintable(outcome.text()));
    QVERIFY2(outcome.out.isEmpty(), qPrintable(outcome.text()));
    QCOMPARE(filesIn(m_folder.path()), QStringList("a.json"));
}

void TestCli::info()
{
    const CliOutcome outcome = runCli({"info", path("a.json"), "--json"});
    QVERIFY2(outcome.code == 0, qPrintable(outcome.text()));
    const QJsonObject o = outcome.json();
    QCOMPARE(o["format"].toString(), QString("suffuse-text"));
    QCOMPARE(o["bytes"].toInt(), int(smallPainting().size()));
    QCOMPARE(o["strokes"].toInt(), 2);
    QCOMPARE(o["segments"].toInt(), 3);
    QCOMPARE(o["canvas"]["width"].toDouble(), 40.0);
    QCOMPARE(o["canvas"]["height"].toDouble(), 30.0);
    QCOMPARE(o["begin"].toDouble(), 0.0);
    QCOMPARE(o["end"].toDouble(), 3.0);
    QCOMPARE(o["duration"].toDouble(), 3.0);
    const QJsonArray bounds = o["bounds"].toArray();
    QCOMPARE(bounds.size(), 4);
    QVERIFY(bounds[0].toDouble() < 5 && bounds[0].toDouble() + bounds[2].toDouble() > 35);
    QVERIFY(runCli({"info", path("a.json")}).out.contains("40 × 30"));
    QCOMPARE(o["groups"].toInt(-1), 0);
    QCOMPARE(o["blendingGroups"].toInt(-1), 0);
    QVERIFY(runCli({"info", path("a.json")}).out.contains("\n  groups    0\n"));
}

/// A group blends by its opacity, by its mode, or because it is isolated; one that is as usual does not.
void TestCli::infoOfGroups()
{
    QJsonObject root = QJsonDocument::fromJson(smallPainting()).object();
    root["version"] = 3;
    root["groups"] =
        QJsonArray{QJsonObject{{"id", 1}}, QJsonObject{{"id", 2}, {"opacity", 0.5}},
                   QJsonObject{{"id", 3}, {"blend", "multiply"}}, QJsonObject{{"id", 4}, {"isolated", true}}};
    QTemporaryDir folder;
    const QString file = folder.filePath("groups.json");
    QVERIFY(writeFile(file, QJsonDocument(root).toJson()));
    const CliOutcome outcome = runCli({"info", file, "--json"});
    QVERIFY2(outcome.code == 0, qPrintable(outcome.text()));
    QCOMPARE(outcome.json()["groups"].toInt(), 4);
    QCOMPARE(outcome.json()["blendingGroups"].toInt(), 3);
    QVERIFY(runCli({"info", file}).out.contains("\n  groups    4, 3 of them blending\n"));
    QCOMPARE(outcome.json()["clippedGroups"].toInt(-1), 0);
    const QJsonObject wash{{"style", QJsonObject{{"kind", "uniform"}, {"xi", QJsonArray{0.5, 0.05}}}},
                           {"mix", QJsonObject{{"mode", "alpha"}}}};
    root["groups"] = QJsonArray{QJsonObject{{"id", 1}}, QJsonObject{{"id", 2}, {"clips", true}},
                                QJsonObject{{"id", 3}, {"clips", true}, {"wash", wash}},
                                QJsonObject{{"id", 4}, {"mask", true}, {"solo", true}}};
    QVERIFY(writeFile(file, QJsonDocument(root).toJson()));
    const CliOutcome roles = runCli({"info", file, "--json"});
    QVERIFY2(roles.code == 0, qPrintable(roles.text()));
    QCOMPARE(roles.json()["clippedGroups"].toInt(), 2);
    QCOMPARE(roles.json()["masks"].toInt(), 1);
    QCOMPARE(roles.json()["washes"].toInt(), 1);
    QCOMPARE(roles.json()["soloGroups"].toInt(), 1);
    const QByteArray said = runCli({"info", file}).out;
    QVERIFY2(said.contains("\n  groups    4, 3 of them blending, 2 clipped, 1 masking, 1 a wash, 1 shown alone\n"),
             said.constData());
}

void TestCli::backends()
{
    const CliOutcome outcome = runCli({"info", "--backends", "--json"});
    QCOMPARE(outcome.code, 0);
    QMap<QString, QJsonObject> found;
    for (const QJsonValue &b : outcome.json()["backends"].toArray())
        found[b["name"].toString()] = b.toObject();
    QVERIFY(found["CPU"]["available"].toBool());
    QVERIFY(found["reference"]["available"].toBool());
    QVERIFY(found.contains("CUDA"));
    QVERIFY(found["CUDA"]["available"].toBool() != !found["CUDA"]["reason"].toString().isEmpty());
    QVERIFY(runCli({"info", "--backends"}).out.contains("CPU"));
}

void TestCli::convertIsExact()
{
    QVERIFY2(runCli({"convert", path("a.json"), path("b.suffuse")}).code == 0, "to binary");
    QVERIFY2(runCli({"convert", path("b.suffuse"), path("c.json")}).code == 0, "to text");
    QVERIFY2(runCli({"convert", path("c.json"), path("d.suffuse")}).code == 0, "and back");
    QVERIFY(!readFile(path("b.suffuse")).isEmpty());
    QCOMPARE(readFile(path("b.suffuse")), readFile(path("d.suffuse")));
    const QJsonObject o = runCli({"info", path("b.suffuse"), "--json"}).json();
    QCOMPARE(o["format"].toString(), QString("suffuse"));
    QVERIFY(!o["chunks"].toArray().isEmpty());
    QCOMPARE(o["segments"].toInt(), 3);
}

void TestCli::convertLeavesItsInput()
{
    QVERIFY(runCli({"convert", path("a.json"), path("own.suffuse")}).code == 0);
    const QByteArray before = readFile(path("own.suffuse"));
    QVERIFY(QFile::link("own.suffuse", path("link.suffuse")));
    QVERIFY(QDir(m_folder.path()).mkdir("folder"));
    QVERIFY(QFile::link(m_folder.path(), path("folder/back")));
    const QString names[] = {path("own.suffuse"), path("./own.suffuse"), path("link.suffuse"),
                             path("folder/back/own.suffuse")};
    for (const QString &in : names)
        for (const QString &out : names) {
            const CliOutcome outcome = runCli({"convert", in, out, "--plain"});
            QVERIFY2(outcome.code == 2 && outcome.err.contains("give OUT another name"), qPrintable(outcome.text()));
        }
    QCOMPARE(readFile(path("own.suffuse")), before);
    QVERIFY(QFileInfo(path("link.suffuse")).isSymLink());
    QVERIFY(runCli({"convert", path("link.suffuse"), path("other.suffuse")}).code == 0);
    QVERIFY(runCli({"convert", path("link.suffuse"), path("other.suffuse")}).code == 0); // what is there is replaced
    // Standard input is no file of that name.
    QVERIFY(runCli({"convert", "-", path("other.suffuse")}, smallPainting()).code == 0);
}

void TestCli::convertToDrawing()
{
    for (const QString kind : {"outlines", "bands", "hybrid"}) {
        const QString out = path(kind + ".svgz");
        const CliOutcome outcome = runCli({"convert", path("a.json"), out, "--as", kind});
        QVERIFY2(outcome.code == 0, outcome.err.constData());
        QVERIFY2(outcome.out.contains("differs from the picture by at most"), outcome.out.constData());
        QVERIFY(runCli({"convert", path("a.json"), path("direct.json")}).code == 0);
        QVERIFY(runCli({"convert", out, path("back.json")}).code == 0);
        QCOMPARE(readFile(path("back.json")), readFile(path("direct.json")));
    }
    const CliOutcome piped = runCli({"convert", path("a.json"), "-", "--format", "svg"});
    QVERIFY(piped.code == 0);
    QVERIFY(piped.out.contains("<svg") && piped.err.contains("of 255"));
    const CliOutcome page = runCli({"convert", path("a.json"), path("a.pdf"), "--as", "hybrid", "--page", "A5"});
    QVERIFY2(page.code == 0 && page.out.contains("of 255"), qPrintable(page.text()));
    QVERIFY(readFile(path("a.pdf")).startsWith("%PDF-1.7"));
    QCOMPARE(runCli({"info", path("a.pdf"), "--json"}).json()["format"].toString(), QString("pdf"));
    QVERIFY(runCli({"convert", path("a.pdf"), path("back.json")}).code == 0);
    QCOMPARE(readFile(path("back.json")), readFile(path("direct.json")));
    const CliOutcome drawn = runCli({"render", path("a.pdf"), "-o", path("a.pfm")});
    QVERIFY2(drawn.code == 0 && runCli({"render", path("a.json"), "-o", path("b.pfm")}).code == 0,
             qPrintable(drawn.text()));
    QCOMPARE(readFile(path("a.pfm")), readFile(path("b.pfm")));
    const CliOutcome paper = runCli({"convert", path("a.json"), "-", "--format", "pdf"});
    QVERIFY(paper.code == 0 && paper.out.startsWith("%PDF-1.7") && paper.err.contains("of 255"));
    // Several are the pages of one.
    const CliOutcome pages = runCli({"convert", path("a.json"), path("a.pdf"), path("c.pdf"), "--as", "outlines"});
    QVERIFY2(pages.code == 0 && pages.out.count("of 255") == 2 && pages.out.contains("a.json: "),
             qPrintable(pages.text()));
    const CliOutcome first = runCli({"convert", path("c.pdf"), path("back.json")});
    QVERIFY2(first.code == 0 && first.err.contains("2 paintings"), qPrintable(first.text()));
    QCOMPARE(readFile(path("back.json")), readFile(path("direct.json")));
    // A missing module is said, and nothing is written.
    const CliOutcome bare = runCli({"convert", path("a.json"), path("b.pdf"), "--as", "outlines"}, {},
                                   {"SUFFUSE_MODULE_DIR=" + path("no such folder")});
    QVERIFY2(bare.code == 1 && bare.err.contains("install Suffuse again"), qPrintable(bare.text()));
    QVERIFY(!QFileInfo::exists(path("b.pdf")));
}

void TestCli::convertWithBrush()
{
    QVERIFY(writeFile(path("pen.csv"), "x,y,time,pressure\n0,0,0,0.5\n10,0,0.02,0.6\n20,5,0.04,0.7\n30,5,0.06,0.7\n"));
    QVERIFY(runCli({"convert", path("pen.csv"), path("default.json")}).code == 0);
    const CliOutcome edge = runCli({"convert", path("pen.csv"), path("edge.json"), "--brush", "watercolour-edge"});
    QVERIFY2(edge.code == 0, qPrintable(edge.text()));
    const auto styleKind = [](const QByteArray &text) {
        return QJsonDocument::fromJson(text)["strokes"][0]["style"]["kind"].toString();
    };
    QCOMPARE(styleKind(readFile(path("edge.json"))), QString("edge"));
    QVERIFY(readFile(path("default.json")) != readFile(path("edge.json")));
    QVERIFY(edge.err.isEmpty());
    const CliOutcome painting = runCli({"convert", path("a.json"), path("same.json"), "--brush", "watercolour-edge"});
    QVERIFY2(painting.code == 0 && painting.err.contains("--brush is ignored"), qPrintable(painting.text()));
}

void TestCli::convertDrawing()
{
    QVERIFY(writeFile(
        path("drawing.txt"),
        "<svg viewBox='0 0 60 40' width='120'><path d='M10 20h40' stroke='#f00' stroke-width='6'/><image/></svg>"));
    const CliOutcome made = runCli({"convert", path("drawing.txt"), path("drawing.suffuse")});
    QVERIFY2(made.code == 0 && made.err.contains("drawing.txt: 1 image"), qPrintable(made.text()));
    QCOMPARE(runCli({"info", path("drawing.txt"), "--json"}).json()["format"].toString(), QString("svg"));
    const QString left = runCli({"info", path("drawing.txt"), "--json"}).json()["leftOut"].toString();
    QVERIFY2(left.startsWith("1 image"), qPrintable(left));
    QCOMPARE(runCli({"info", path("drawing.suffuse"), "--json"}).json()["leftOut"].toString(), QString());
    // Whatever shows the drawing tells what is not in it.
    for (const QStringList &shows : {QStringList{"info", path("drawing.txt")},
                                     {"probe", path("drawing.txt"), "60", "40"},
                                     {"render", path("drawing.txt"), "-o", path("drawing.pfm")},
                                     {"verify", path("drawing.txt")},
                                     {"diff", path("drawing.txt"), path("drawing.txt")}}) {
        const CliOutcome shown = runCli(shows);
        QVERIFY2(shown.code == 0 && shown.err.contains("drawing.txt: 1 image"), qPrintable(shown.text()));
    }
    const QJsonObject canvas = runCli({"info", path("drawing.suffuse"), "--json"}).json()["canvas"].toObject();
    QCOMPARE(canvas["width"].toDouble(), 120.0);
    QCOMPARE(canvas["height"].toDouble(), 80.0);
    // Paint on the line, none beside it.
    const auto opacityAt = [&](const QString &y) {
        const QJsonArray strokes =
            runCli({"probe", path("drawing.suffuse"), "60", y, "--json"}).json()["strokes"].toArray();
        return strokes.isEmpty() ? 0 : strokes.at(0)["opacity"].toDouble();
    };
    QVERIFY(opacityAt("40") > 0.9);
    QVERIFY(opacityAt("60") < 0.01);
    QVERIFY(writeFile(path("words.svg"), "<svg>\n<image/></svg>"));
    const CliOutcome refused = runCli({"convert", path("words.svg"), path("words.suffuse")});
    QVERIFY2(refused.code == 1 && refused.err.contains(path("words.svg").toUtf8() + ": holds no paths"),
             qPrintable(refused.text()));
    QVERIFY(!QFileInfo::exists(path("words.suffuse")));
}

void TestCli::textsOfDrawings()
{
    QVERIFY(writeFile(path("letters.svg"), "<svg viewBox='0 0 60 40'><text x='30' y='30' font-size='30' "
                                           "text-anchor='middle'>IXI</text></svg>"));
    const CliOutcome made = runCli({"convert", path("letters.svg"), path("letters.json")});
    QVERIFY2(made.code == 0 && made.err.isEmpty(), qPrintable(made.text()));
    QVERIFY(readFile(path("letters.json")).contains("\"string\": \"IXI\""));
    QVERIFY(readFile(path("letters.json")).contains("\"name\": \"X\""));
    const CliOutcome drawn = runCli({"render", path("letters.svg"), "-o", path("letters.pfm")});
    QVERIFY2(drawn.code == 0 && drawn.err.isEmpty(), qPrintable(drawn.text()));
    // From standard input, and in a program that starts without knowing of it.
    const CliOutcome probed = runCli({"probe", "-", "30", "20", "--json"}, readFile(path("letters.svg")));
    QVERIFY2(probed.code == 0 && !probed.json()["strokes"].toArray().isEmpty(), qPrintable(probed.text()));
    // Without its part that knows fonts the text is left out, and why is said.
    const CliOutcome without =
        runCli({"info", path("letters.svg")}, {}, {"SUFFUSE_MODULE_DIR=" + path("no such folder")});
    QVERIFY2(without.code == 1 && without.err.contains("suffuse_lettering.so, is missing"), qPrintable(without.text()));
}

void TestCli::probe()
{
    const CliOutcome outcome = runCli({"probe", path("a.json"), "20", "15", "--json"});
    QVERIFY2(outcome.code == 0, qPrintable(outcome.text()));
    const QJsonObject o = outcome.json();
    QCOMPARE(o["time"].toDouble(), 3.0);
    QCOMPARE(o["paper"].toDouble(), 1.0);
    const QJsonObject bar = o["strokes"][0].toObject();
    QCOMPARE(bar["id"].toInt(), 1);
    QCOMPARE(bar["name"].toString(), QString("bar"));
    // A straight line, 15 units to both sides, s = √8: φ = φˢ/(√π s)·erf(15/s), eq 13.
    const double s = std::sqrt(8.0);
    const double expected = 6 / (std::sqrt(3.14159265358979323846) * s) * std::erf(15 / s);
    QVERIFY2(std::abs(bar["density"].toDouble() - expected) < 1e-9, qPrintable(outcome.text()));
    QVERIFY(std::abs(bar["segments"][0]["share"].toDouble() - 0.5) < 1e-9);
    QCOMPARE(bar["colour"].toArray(), QJsonArray({0, 0, 1, 1}));
    QVERIFY(bar["opacity"].toDouble() > 0.99);

    // Before its second half is born only one segment is there.
    const QJsonObject early = runCli({"probe", path("a.json"), "12", "15", "--time", "0.25", "--json"}).json();
    QCOMPARE(early["time"].toDouble(), 0.25);
    QCOMPARE(early["strokes"][0]["segments"].toArray().size(), 1);
    // At the left end the right half counts for nothing.
    const QByteArray shown = runCli({"probe", path("a.json"), "5", "15"}).out;
    QVERIFY2(shown.contains("bar") && shown.contains("segment 0") && !shown.contains("segment 1"), shown.constData());
    QVERIFY2(shown.contains("1 segment with a share below 1e-06 left out"), shown.constData());
    QVERIFY(runCli({"probe", path("a.json"), "5", "15", "--all"}).out.contains("segment 1"));
    const QJsonObject few = runCli({"probe", path("a.json"), "5", "15", "--json"}).json()["strokes"][0].toObject();
    QCOMPARE(few["segments"].toArray().size(), 1);
    QCOMPARE(few["segmentsLeftOut"].toInt(), 1);
    const QJsonObject all =
        runCli({"probe", path("a.json"), "5", "15", "--json", "--all"}).json()["strokes"][0].toObject();
    QCOMPARE(all["segments"].toArray().size(), 2);
    QCOMPARE(all["segmentsLeftOut"].toInt(), 0);
}

void TestCli::probeTakesNegativeNumbers()
{
    const CliOutcome outcome = runCli({"probe", path("a.json"), "-500.5", "-2e2", "--json"});
    QVERIFY2(outcome.code == 0, qPrintable(outcome.text()));
    QCOMPARE(outcome.json()["x"].toDouble(), -500.5);
    QCOMPARE(outcome.json()["y"].toDouble(), -200.0);
    QVERIFY(outcome.json()["strokes"].toArray().isEmpty());
    const CliOutcome early = runCli({"probe", path("a.json"), "1", "1", "--time", "-1"});
    QVERIFY2(early.code == 2 && early.err.contains("--time -1: nothing is painted"), qPrintable(early.text()));
}

void TestCli::verify()
{
    const CliOutcome outcome = runCli({"verify", path("a.json"), "--size", "80x60"});
    QVERIFY2(outcome.code == 0, qPrintable(outcome.text()));
    QVERIFY2(outcome.out.contains("80 × 60") && outcome.out.contains("CPU") &&
                 outcome.out.contains("within the contract"),
             qPrintable(outcome.text()));
}

void TestCli::standardInput()
{
    const CliOutcome info = runCli({"info", "-", "--json"}, smallPainting());
    QVERIFY2(info.code == 0, qPrintable(info.text()));
    QCOMPARE(info.json()["segments"].toInt(), 3);
    const CliOutcome convert = runCli({"convert", "-", path("stdin.suffuse")}, smallPainting());
    QVERIFY2(convert.code == 0, qPrintable(convert.text()));
    QVERIFY(runCli({"convert", path("a.json"), path("file.suffuse")}).code == 0);
    QCOMPARE(readFile(path("stdin.suffuse")), readFile(path("file.suffuse")));
    QCOMPARE(runCli({"info", "-"}, "").code, 1);
}

void TestCli::standardOutput()
{
    QVERIFY(runCli({"convert", path("a.json"), path("out.suffuse")}).code == 0);
    const CliOutcome document = runCli({"convert", path("a.json"), "-", "--format", "suffuse"});
    QCOMPARE(document.code, 0);
    QVERIFY(!document.out.isEmpty() && document.out == readFile(path("out.suffuse")));
    QCOMPARE(QJsonDocument::fromJson(runCli({"convert", path("a.json"), "-"}).out)["strokes"].toArray().size(), 2);
}

void TestCli::nobodyReadsOn_data()
{
    QTest::addColumn<QStringList>("arguments");
    QVERIFY(writeFile(path("b.json"), smallPainting().replace("\"density\": 30", "\"density\": 31")));
    QTest::newRow("diff") << QStringList{"diff", path("a.json"), path("b.json")};
    QTest::newRow("info") << QStringList{"info", path("a.json"), "--json"};
    QTest::newRow("help") << QStringList{"--help"};
    QTest::newRow("render") << QStringList{"render", path("a.json"), "-o", "-"};
}

/// As with "| head": no message, and the end that others come to.
void TestCli::nobodyReadsOn()
{
    QFETCH(QStringList, arguments);
    int ends[2];
    QCOMPARE(::pipe2(ends, O_CLOEXEC), 0);
    ::close(ends[0]);
    QProcess process;
    process.setChildProcessModifier([&ends] {
        std::signal(SIGPIPE, SIG_DFL);
        ::dup2(ends[1], STDOUT_FILENO);
    });
    process.start(QStringLiteral(SUFFUSE_BIN_DIR "/suffuse-cli"), arguments);
    QVERIFY(process.waitForFinished(60'000));
    ::close(ends[1]);
    QCOMPARE(process.readAllStandardError(), QByteArray());
    QCOMPARE(process.exitStatus(), QProcess::CrashExit);
    QCOMPARE(process.exitCode(), SIGPIPE);
}

QTEST_GUILESS_MAIN(TestCli)
#include "render/backends.h"
#include "test_cli.moc"
