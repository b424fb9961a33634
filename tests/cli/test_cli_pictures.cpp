// From painting to image file through suffuse-cli, good and bad.
#include "cli_pictures.h"

#include <QCryptographicHash>
#include <QDir>
#include <QJsonArray>
#include <QTest>

#include <cmath>
#include <cstring>

#include <sys/stat.h>
#include <unistd.h>

using namespace suffuse;

class TestCliPictures : public CliPictures {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }
    void png();
    void formatsAgree_data();
    void formatsAgree();
    void pfmNeedsNoModule();
    void qualityAndResolution();
    void sizeOnPaper();
    void standardOutput();
    void sizesAndAreas();
    void moments();
    void transparent();
    void threadsAndBackends();
    void cuda();
    void hostileInputs_data();
    void hostileInputs();
    void unwritableTargets();
    void oldPictureSurvives();
    void recordings_data();
    void recordings();
    void awkwardStrokes();
    void drafts();
    void linkedPictures();
};

void TestCliPictures::png()
{
    const CliOutcome outcome = runCli({"render", path("a.json"), "-o", path("a.png"), "--stats"});
    QVERIFY2(outcome.code == 0, qPrintable(outcome.text()));
    const QJsonObject stats = outcome.json();
    QCOMPARE(stats["width"].toInt(), 40);
    QCOMPARE(stats["height"].toInt(), 30);
    QCOMPARE(stats["segments"].toInt(), 3);
    QCOMPARE(stats["backend"].toString(), QString("CPU"));
    QVERIFY(stats["nodes"].toInt() >= 3 && stats["tiles"].toInt() > 0);
    for (const char *stage : {"load", "nodes", "binning", "tiles", "render", "write"})
        QVERIFY2(stats["ms"][stage].isDouble(), stage);
    const FloatPicture p = picture("a.png");
    QCOMPARE(p.width, 40);
    QCOMPARE(p.height, 30);
    // White paper in the corner; blue on the bar; the dot is redder than green.
    const float *corner = p.at(0, 0), *bar = p.at(12, 15), *dot = p.at(30, 8);
    for (int c = 0; c < 3; ++c)
        QCOMPARE(corner[c], 1.0f);
    QVERIFY(bar[0] < 0.05f && bar[1] < 0.05f && bar[2] > 0.95f);
    QVERIFY(dot[0] > 0.8f && dot[1] < 0.4f);
}

void TestCliPictures::formatsAgree_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<double>("tolerance");
    const double half = 1.0 / 1024;
    QTest::newRow("PNG 8") << "f.png" << QStringList() << 0.5 / 255 + 1e-6;
    QTest::newRow("PNG 16") << "f16.png" << QStringList{"--depth", "16"} << 0.5 / 65535 + 1e-6;
    QTest::newRow("TIFF 8") << "f.tif" << QStringList() << 0.5 / 255 + 1e-6;
    QTest::newRow("TIFF 16") << "f16.tiff" << QStringList{"--depth", "16"} << 0.5 / 65535 + 1e-6;
    QTest::newRow("TIFF half") << "fh.tif" << QStringList{"--depth", "half"} << half;
    QTest::newRow("TIFF float") << "ff.tif" << QStringList{"--depth", "float"} << 1e-7;
    QTest::newRow("EXR half") << "f.exr" << QStringList() << half;
    QTest::newRow("EXR float") << "ff.exr" << QStringList{"--depth", "float"} << 1e-6;
    QTest::newRow("JPEG") << "f.jpg" << QStringList() << 0.08;
    QTest::newRow("WebP") << "f.webp" << QStringList() << 0.25; // colour at half resolution
}

void TestCliPictures::formatsAgree()
{
    QFETCH(QString, name);
    QFETCH(QStringList, options);
    QFETCH(double, tolerance);
    const FloatPicture truth = rendered({"--depth", "float", "--size", "80x60"}, "truth.tif");
    const FloatPicture p = rendered(options + QStringList{"--size", "80x60"}, name);
    QCOMPARE(p.width, 80);
    QCOMPARE(p.height, 60);
    double largest = 0, sum = 0;
    for (std::size_t i = 0; i < p.rgba.size(); ++i) {
        largest = std::max(largest, double(std::abs(p.rgba[i] - truth.rgba[i])));
        sum += std::abs(p.rgba[i] - truth.rgba[i]);
    }
    QVERIFY(sum / double(p.rgba.size()) < 0.005);
    QVERIFY2(largest <= tolerance, qPrintable(QString::number(largest)));
}

void TestCliPictures::pfmNeedsNoModule()
{
    QTemporaryDir empty;
    const QStringList without{"SUFFUSE_MODULE_DIR=" + empty.path()};
    const CliOutcome pfm = runCli({"render", path("a.json"), "-o", path("a.pfm")}, {}, without);
    QVERIFY2(pfm.code == 0, qPrintable(pfm.text()));
    const QByteArray bytes = readFile(path("a.pfm"));
    const QByteArray header = "PF\n40 30\n-1.0\n";
    QVERIFY(bytes.startsWith(header));
    QCOMPARE(bytes.size(), header.size() + 40 * 30 * 3 * 4);
    const FloatPicture truth = rendered({"--depth", "float"}, "t.tif");
    const auto *values = reinterpret_cast<const float *>(bytes.constData() + header.size());
    std::vector<float> copy(40 * 30 * 3);
    std::memcpy(copy.data(), values, copy.size() * sizeof(float));
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x)
            for (int c = 0; c < 3; ++c) // rows from bottom to top
                QCOMPARE(copy[std::size_t(((29 - y) * 40 + x) * 3 + c)], truth.at(x, y)[c]);

    const CliOutcome png = runCli({"render", path("a.json"), "-o", path("none.png")}, {}, without);
    QCOMPARE(png.code, 1);
    QVERIFY2(png.err.contains("suffuse_image_io.so") && png.err.contains("is missing") && png.err.contains(".pfm"),
             qPrintable(png.text()));
    QVERIFY(!QFile::exists(path("none.png")));
}

void TestCliPictures::qualityAndResolution()
{
    const auto bytes = [&](const QStringList &options, const char *name) {
        rendered(options + QStringList{"--size", "400"}, name);
        return readFile(path(name));
    };
    for (const char *name : {"q.jpg", "q.webp"}) {
        const qsizetype low = bytes({"--quality", "20"}, name).size(), usual = bytes({}, name).size();
        QVERIFY2(low < usual && usual < bytes({"--quality", "100"}, name).size(), name);
    }
    QVERIFY(bytes({"--dpi", "300"}, "q.jpg").contains(QByteArray("JFIF\0\1\1\1\1\x2C\1\x2C", 12)));
    QVERIFY(bytes({"--dpi", "300"}, "q.png").contains(QByteArray("pHYs\0\0\x2E\x23\0\0\x2E\x23\1", 13)));
    QVERIFY(!bytes({}, "q.png").contains("pHYs"));
    const CliOutcome png = runCli({"render", path("a.json"), "-o", path("q.png"), "--quality", "50"});
    QVERIFY2(png.code == 0 && png.err.contains("--quality is ignored"), qPrintable(png.text()));
    const CliOutcome webp = runCli({"render", path("a.json"), "-o", path("q.webp"), "--dpi", "72"});
    QVERIFY2(webp.code == 0 && webp.err.contains("--dpi is ignored"), qPrintable(webp.text()));
}

/// A document that says how large it is on paper keeps that in pictures and drawings.
void TestCliPictures::sizeOnPaper()
{
    DocumentExtras extras;
    extras.resolution = 200;
    const Result<Painting> painting = loadPainting(path("a.json")); // 40 × 30
    QVERIFY(painting && saveDocument(*painting, extras, path("paper.suffuse")));
    const auto bytes = [&](const QStringList &options) {
        const CliOutcome done = runCli(QStringList{"render", path("paper.suffuse"), "-o", path("p.png")} + options);
        return done.code == 0 ? readFile(path("p.png")) : done.err;
    };
    QVERIFY(bytes({}).contains(QByteArray("pHYs\0\0\x1E\xC2\0\0\x1E\xC2\1", 13))); // 200 dpi, 7874 a metre
    QVERIFY(bytes({"--scale", "2"}).contains(QByteArray("pHYs\0\0\x3D\x84\0\0\x3D\x84\1", 13))); // 400 dpi
    QVERIFY(bytes({"--dpi", "300"}).contains(QByteArray("pHYs\0\0\x2E\x23\0\0\x2E\x23\1", 13)));
    const CliOutcome info = runCli({"info", path("paper.suffuse")});
    QVERIFY2(info.text().contains("  on paper  5.1 × 3.8 mm, 200 units an inch"), qPrintable(info.text()));
    QVERIFY(info.text().contains("(size on paper)"));
    const auto resolutionOf = [this](const QString &file) -> QJsonValue {
        return runCli({"info", "--json", path(file)}).json()["canvas"].toObject()["resolution"];
    };
    QCOMPARE(resolutionOf("paper.suffuse").toDouble(), 200.0);
    QVERIFY(resolutionOf("a.json").isNull());
    QVERIFY(!runCli({"info", path("a.json")}).text().contains("on paper"));
    QCOMPARE(runCli({"convert", path("paper.suffuse"), path("p.svg")}).code, 0);
    const QByteArray svg = readFile(path("p.svg"));
    QVERIFY2(svg.contains("width=\"5.08mm\" height=\"3.81mm\" viewBox=\"0 0 40 30\""), svg.left(400).constData());
    QCOMPARE(runCli({"convert", path("paper.suffuse"), path("again.suffuse")}).code, 0);
    QCOMPARE(loadDocument(path("again.suffuse"))->extras.resolution, 200.0);
}

void TestCliPictures::standardOutput()
{
    QVERIFY(!rendered({}, "file.png").rgba.empty());
    const CliOutcome png = runCli({"render", path("a.json"), "-o", "-"});
    QVERIFY2(png.code == 0 && png.err.isEmpty(), png.err.constData());
    QVERIFY(png.out == readFile(path("file.png")));
    QVERIFY(!rendered({"--depth", "16"}, "file.tif").rgba.empty());
    const CliOutcome tiff = runCli({"render", path("a.json"), "-o", "-", "--format", "tiff", "--depth", "16"});
    QVERIFY(tiff.code == 0 && tiff.out == readFile(path("file.tif")));
    QVERIFY(!QFile::exists("-"));
}

void TestCliPictures::sizesAndAreas()
{
    QCOMPARE(rendered({"--scale", "2.5"}, "s.png").width, 100);
    QCOMPARE(rendered({"--size", "20"}, "s.png").height, 15);
    const FloatPicture part = rendered({"--area", "10,10,20,10", "--depth", "16"}, "part.png");
    const FloatPicture whole = rendered({"--depth", "16"}, "whole.png");
    QCOMPARE(part.width, 20);
    QCOMPARE(part.height, 10);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 20; ++x)
            for (int c = 0; c < 3; ++c)
                QVERIFY(std::abs(part.at(x, y)[c] - whole.at(x + 10, y + 10)[c]) < 2e-4f);
    // Beyond the canvas there is paper, and at deep zoom there is still paint.
    QCOMPARE(rendered({"--area", "-30,-30,20,20"}, "outside.png").at(3, 3)[0], 1.0f);
    QVERIFY(rendered({"--area", "12,15,1e-6,1e-6", "--size", "16x16"}, "deep.png").at(8, 8)[0] < 0.05f);
}

void TestCliPictures::moments()
{
    const auto blue = [](const FloatPicture &p, int x) { return p.at(x, 15)[0] < 0.5f; };
    const FloatPicture early = rendered({"--time", "0.4"}, "m.png");
    QVERIFY(blue(early, 12));
    QVERIFY(!blue(early, 28));
    const FloatPicture late = rendered({"--time", "1.5"}, "m.png");
    QVERIFY(blue(late, 12) && blue(late, 28));
    QCOMPARE(late.at(30, 8)[1], 1.0f); // the dot is not there yet
    QVERIFY(rendered({}, "m.png").at(30, 8)[1] < 0.5f);
    QCOMPARE(rendered({"--time", "0"}, "m.png").at(12, 15)[0], 1.0f);
}

void TestCliPictures::transparent()
{
    for (const char *name : {"t.png", "t.tif", "t.exr", "t.webp"}) {
        const FloatPicture p = rendered({"--transparent"}, name);
        QCOMPARE(p.width, 40);
        QVERIFY2(p.at(0, 0)[3] == 0, name);
        const float *bar = p.at(12, 15);
        QVERIFY2(bar[3] > 0.99f && bar[0] < 0.1f && bar[2] > 0.9f, name);
    }
    // Straight colours: where it is half covered the bar is as blue as inside.
    const FloatPicture p = rendered({"--transparent", "--depth", "16"}, "t.png");
    int edges = 0;
    for (int y = 0; y < 30; ++y)
        if (const float *v = p.at(12, y); v[3] > 0.2f && v[3] < 0.8f) {
            QVERIFY(v[0] < 0.02f && v[2] > 0.98f);
            ++edges;
        }
    QVERIFY(edges >= 2);
}

void TestCliPictures::threadsAndBackends()
{
    QVERIFY(!rendered({"--threads", "1", "--depth", "float"}, "one.tif").rgba.empty());
    QVERIFY(!rendered({"--threads", "3", "--depth", "float"}, "three.tif").rgba.empty());
    QVERIFY(picture("one.tif").rgba == picture("three.tif").rgba);
    const FloatPicture cpu = rendered({"--backend", "cpu", "--depth", "float"}, "cpu.tif");
    const FloatPicture reference = rendered({"--backend", "reference", "--depth", "float"}, "ref.tif");
    QCOMPARE(cpu.rgba.size(), reference.rgba.size());
    for (std::size_t i = 0; i < cpu.rgba.size(); ++i)
        QVERIFY(std::abs(cpu.rgba[i] - reference.rgba[i]) <= 1.0f / 512);
}

/// All GPUs together; without one a reason and no picture; with one that fails the CPU's picture and a word about it.
void TestCliPictures::cuda()
{
    QString reason;
    for (const QJsonValue &b : runCli({"info", "--backends", "--json"}).json()["backends"].toArray())
        if (b["name"].toString() == "CUDA")
            reason = b["reason"].toString();
    const QStringList arguments{"render", path("a.json"), "-o",   path("cuda.tif"), "--depth",
                                "float",  "--backend",    "cuda", "--devices",      "all"};
    const CliOutcome outcome = runCli(arguments);
    if (!reason.isEmpty()) {
        QCOMPARE(outcome.code, 1);
        QVERIFY2(QString::fromUtf8(outcome.err).contains(reason), qPrintable(outcome.text()));
        QVERIFY(!QFile::exists(path("cuda.tif")));
        return;
    }
    QVERIFY2(outcome.code == 0 && outcome.err.isEmpty(), qPrintable(outcome.text()));
    const FloatPicture cpu = rendered({"--backend", "cpu", "--depth", "float"}, "cpu.tif");
    const FloatPicture cuda = picture("cuda.tif");
    QCOMPARE(cuda.rgba.size(), cpu.rgba.size());
    for (std::size_t i = 0; i < cpu.rgba.size(); ++i)
        QVERIFY(std::abs(cpu.rgba[i] - cuda.rgba[i]) <= 1.0f / 512);
    const CliOutcome failing = runCli(arguments, {}, {"SUFFUSE_CUDA_FAIL=5"});
    QVERIFY2(failing.code == 0 && failing.err.contains("The CPU draws now"), qPrintable(failing.text()));
    QVERIFY(picture("cuda.tif").rgba == cpu.rgba);
}

void TestCliPictures::hostileInputs_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QVERIFY(runCli({"convert", path("a.json"), path("good.suffuse")}).code == 0);
    const QByteArray good = readFile(path("good.suffuse"));
    QVERIFY(good.size() > 64);
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("one byte") << good.left(1);
    QTest::newRow("the signature") << good.left(8);
    QTest::newRow("half") << good.left(good.size() / 2);
    QTest::newRow("all but one byte") << good.left(good.size() - 1);
    QByteArray flipped = good;
    flipped[flipped.size() / 2] = char(flipped[flipped.size() / 2] ^ 0x10);
    QTest::newRow("one bit") << flipped;
    QTest::newRow("a picture") << QByteArray("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
    QTest::newRow("a program") << QByteArray("\x7f"
                                             "ELF\2\1\1\0\0\0\0",
                                             11);
    QTest::newRow("prose") << QByteArray("It was a dark and stormy night.\n");
    QTest::newRow("other JSON") << QByteArray("{\"format\": \"other\"}");
    QTest::newRow("cut JSON") << smallPainting().left(300);
    QTest::newRow("deep JSON") << QByteArray(100'000, '[');
    const auto with = [](const char *what, const char *by) {
        QByteArray text = smallPainting();
        const qsizetype at = text.indexOf(what);
        return at < 0 ? QByteArray() : text.replace(at, qsizetype(qstrlen(what)), by);
    };
    QTest::newRow("NaN") << with("\"density\": 6", "\"density\": NaN");
    QTest::newRow("infinite") << with("\"density\": 6", "\"density\": 1e999");
    QTest::newRow("negative") << with("\"diffusion\": 2", "\"diffusion\": -2");
    QTest::newRow("huge") << with("\"diffusion\": 2", "\"diffusion\": 1e30");
    QTest::newRow("a gap") << with("[20,15],[25", "[21,15],[25");
    QTest::newRow("no canvas") << with("\"width\": 40", "\"width\": 0");
    QTest::newRow("huge canvas") << with("\"width\": 40", "\"width\": 1e300");
    QTest::newRow("same id") << with("\"id\": 2", "\"id\": 1");
    QTest::newRow("unknown style") << with("feathering", "glitter");
}

void TestCliPictures::hostileInputs()
{
    QFETCH(QByteArray, bytes);
    QTemporaryDir folder;
    const QString in = folder.filePath("in"), png = folder.filePath("out.png"),
                  document = folder.filePath("out.suffuse");
    QVERIFY(writeFile(in, bytes));
    for (const QStringList &arguments : {QStringList{"render", in, "-o", png},
                                         {"info", in},
                                         {"convert", in, document},
                                         {"probe", in, "1", "1"},
                                         {"verify", in},
                                         {"info", in, "--json"}}) {
        const CliOutcome outcome = runCli(arguments);
        QVERIFY2(outcome.code == 1, qPrintable(arguments.join(' ') + '\n' + outcome.text()));
        const bool tells = arguments.front() == "info"; // what is whole of a damaged document, and what is missing
        QVERIFY2(tells || outcome.out.isEmpty(), qPrintable(outcome.text()));
        QVERIFY2(outcome.err.startsWith("suffuse-cli: in: ") || outcome.err.startsWith("suffuse-cli: " + in.toUtf8()),
                 qPrintable(outcome.text()));
        QVERIFY2(outcome.err.size() < 1000 && outcome.err.count('\n') <= 10, qPrintable(outcome.text()));
    }
    QCOMPARE(filesIn(folder.path()), QStringList("in"));
}

void TestCliPictures::unwritableTargets()
{
    const auto fails = [&](const QString &out, const char *says) {
        const CliOutcome outcome = runCli({"render", path("a.json"), "-o", out});
        QVERIFY2(outcome.code == 1, qPrintable(outcome.text()));
        QVERIFY2(outcome.err.contains(says) && outcome.err.contains(out.toUtf8()), qPrintable(outcome.text()));
    };
    fails(path("nowhere/a.png"), "does not exist");
    QVERIFY(QDir(m_folder.path()).mkdir("folder.png"));
    fails(path("folder.png"), "is a folder");
    QVERIFY(filesIn(path("folder.png")).isEmpty());
    QCOMPARE(::mkfifo(QFile::encodeName(path("pipe.png")).constData(), 0600), 0);
    fails(path("pipe.png"), "not a plain file");
    // That is said before anything is read or drawn.
    for (const char *ending : {"png", "ora"}) {
        const CliOutcome early = runCli({"render", path("missing.json"), "-o", path("nowhere/a.") + ending});
        QVERIFY2(early.code == 1 && early.err.contains("nowhere"), qPrintable(early.text()));
    }
    const CliOutcome compared = runCli({"diff", path("missing.json"), path("a.json"), "-o", path("nowhere/a.png")});
    QVERIFY2(compared.code == 2 && compared.err.contains("nowhere"), qPrintable(compared.text()));
    QCOMPARE(runCli({"convert", path("a.json"), path("nowhere/a.suffuse")}).code, 1);
    if (::geteuid() != 0) {
        QTemporaryDir closed;
        QFile::setPermissions(closed.path(), QFile::ReadOwner | QFile::ExeOwner);
        fails(closed.filePath("a.png"), "permissions");
        QFile::setPermissions(closed.path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        QVERIFY(filesIn(closed.path()).isEmpty());
    }
    for (const QString &name : filesIn(m_folder.path()))
        QVERIFY2(!name.endsWith(".tmp"), qPrintable(name));
}

void TestCliPictures::oldPictureSurvives()
{
    // A limit on file sizes stands for a full disk; the shell sets it.
    QVERIFY(writeFile(path("old.png"), "old"));
    for (const char *name : {"old.png", "old.tif", "old.exr", "old.jpg", "old.webp", "old.pfm"}) {
        QTemporaryDir folder;
        const QString out = folder.filePath(name);
        QVERIFY(writeFile(out, "old"));
        QProcess shell;
        shell.start("bash", {"-c", "trap '' XFSZ; ulimit -f 4; exec \"$0\" render \"$1\" -o \"$2\" --scale 20",
                             SUFFUSE_BIN_DIR "/suffuse-cli", path("a.json"), out});
        QVERIFY(shell.waitForFinished(120'000));
        const QByteArray err = shell.readAllStandardError();
        QVERIFY2(shell.exitCode() == 1, (name + QByteArray(": ") + err).constData());
        QVERIFY2(err.contains("disk is full") && err.contains(name), err.constData());
        QCOMPARE(readFile(out), QByteArray("old"));
        QCOMPARE(filesIn(folder.path()), QStringList(name));
    }
}

void TestCliPictures::recordings_data()
{
    QTest::addColumn<QString>("file");
    for (const char *file : {"ink/digital_ink.json", "ink/sensor_data.csv", "excalidraw/biology.excalidrawlib",
                             "excalidraw/despair.excalidrawlib", "painting30sec.dat"})
        QTest::newRow(file) << QString(file);
}

void TestCliPictures::recordings()
{
    QFETCH(QString, file);
    const QString in = QStringLiteral(SUFFUSE_SOURCE_DIR "/../shared/data/") + file;
    if (!QFile::exists(in))
        QSKIP("../shared/data is missing: recordings are not checked");
    const QString document = path("recording.suffuse");
    const CliOutcome converted = runCli({"convert", in, document});
    QVERIFY2(converted.code == 0, qPrintable(converted.text()));
    const QJsonObject info = runCli({"info", document, "--json"}).json();
    QVERIFY(info["strokes"].toInt() >= 4 && info["segments"].toInt() > 200);
    const CliOutcome drawn = runCli({"render", document, "-o", path("recording.png"), "--size", "160"});
    QVERIFY2(drawn.code == 0, qPrintable(drawn.text()));
    const FloatPicture p = picture("recording.png");
    int painted = 0;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
            painted += p.at(x, y)[0] < 0.9f;
    QVERIFY2(painted > 100, qPrintable(QString::number(painted)));
    const CliOutcome verified = runCli({"verify", document, "--size", "96"});
    QVERIFY2(verified.code == 0, qPrintable(verified.text()));
}

void TestCliPictures::awkwardStrokes()
{
    const QString file = QStringLiteral(SUFFUSE_SOURCE_DIR "/../shared/data/awkward_inputs.json");
    if (!QFile::exists(file))
        QSKIP("../shared/data is missing: awkward strokes are not checked");
    const QJsonObject strokes = QJsonDocument::fromJson(readFile(file)).object();
    QVERIFY(strokes.size() >= 6);
    for (auto it = strokes.begin(); it != strokes.end(); ++it) {
        QByteArray csv = "x,y,time,pressure\n";
        int k = 0;
        for (const QJsonValue &point : it->toArray()) {
            const bool pair = point.isArray();
            csv += QByteArray::number((pair ? point[0] : point["x"]).toDouble()) + ',' +
                   QByteArray::number((pair ? point[1] : point["y"]).toDouble()) + ',' +
                   QByteArray::number(0.016 * k++) + ",0.7\n";
        }
        if (k == 0)
            continue;
        QVERIFY(writeFile(path("awkward.csv"), csv));
        const CliOutcome outcome = runCli({"render", path("awkward.csv"), "-o", path("awkward.png")});
        QVERIFY2(outcome.code == 0, qPrintable(it.key() + '\n' + outcome.text()));
        const FloatPicture p = picture("awkward.png");
        float darkest = 1;
        for (std::size_t i = 0; i < p.rgba.size(); i += 4)
            darkest = std::min(darkest, p.rgba[i]);
        QVERIFY2(darkest < 0.8f, qPrintable(it.key())); // a single point is a dot
    }
}

void TestCliPictures::drafts()
{
    QByteArray text = smallPainting();
    text.replace("\"strokes\": [", "\"groups\": [{\"id\": 7, \"draft\": true}],\"strokes\": [");
    text.replace("\"version\": 1", "\"version\": 3");
    QJsonObject painting = QJsonDocument::fromJson(text).object();
    QJsonArray strokes = painting["strokes"].toArray();
    for (QJsonValueRef stroke : strokes) {
        QJsonObject own = stroke.toObject();
        own["group"] = 7;
        stroke = own;
    }
    painting["strokes"] = strokes;
    QVERIFY(writeFile(path("draft.json"), QJsonDocument(painting).toJson()));
    const auto rendered = [&](const QStringList &options) {
        const CliOutcome done = runCli(QStringList{"render", path("draft.json"), "-o", path("draft.png")} + options);
        return done.code == 0 ? readFile(path("draft.png")) : done.err;
    };
    const CliOutcome plain = runCli({"render", path("a.json"), "-o", path("plain.png")});
    QVERIFY2(plain.code == 0, qPrintable(plain.text()));
    QCOMPARE(rendered({"--drafts"}), readFile(path("plain.png")));
    const QByteArray without = rendered({});
    QVERIFY(without.startsWith("\x89PNG") && without != readFile(path("plain.png")));
    QCOMPARE(runCli({"info", "--json", path("draft.json")}).json()["drafts"].toInt(), 1);
}

/// What is missing is told, drawn without, and kept by `convert`.
void TestCliPictures::linkedPictures()
{
    FloatPicture image;
    image.resize(4, 4);
    std::fill(image.rgba.begin(), image.rgba.end(), 1.0f);
    const Result<QByteArray> png = encodeImage(ImageFormat::Png, image, {}, "l");
    QVERIFY(png && QDir(path("")).mkpath("in/pictures"));
    QVERIFY(writeFile(path("in/pictures/l.png"), *png));
    const QByteArray picture = "\"picture\": {\"link\": \"pictures/l.png\", \"sha256\": \"" +
                               QCryptographicHash::hash(*png, QCryptographicHash::Sha256).toHex() +
                               "\", \"width\": 4, \"height\": 4, \"corner\": [0,0], \"right\": [40,0], "
                               "\"down\": [0,30]}, \"segments\": [";
    QByteArray text = smallPainting();
    text.replace("\"version\": 1", "\"version\": 3").replace("\"segments\": [", picture);
    QVERIFY(writeFile(path("in/linked.json"), text));
    const CliOutcome whole = runCli({"render", path("in/linked.json"), "-o", path("whole.png")});
    QVERIFY2(whole.code == 0 && whole.err.isEmpty(), qPrintable(whole.text()));
    const CliOutcome moved = runCli({"convert", path("in/linked.json"), path("moved.suffuse")});
    QVERIFY2(moved.code == 0 && moved.err.isEmpty(), qPrintable(moved.text()));
    const CliOutcome again = runCli({"render", path("moved.suffuse"), "-o", path("again.png")});
    QVERIFY2(again.code == 0 && again.err.isEmpty(), qPrintable(again.text()));
    QCOMPARE(readFile(path("again.png")), readFile(path("whole.png")));
    QVERIFY(QFile::remove(path("in/pictures/l.png")));
    const CliOutcome lacking = runCli({"render", path("moved.suffuse"), "-o", path("lacking.png")});
    QVERIFY(lacking.code == 0 && lacking.err.contains("l.png"));
    const CliOutcome info = runCli({"info", "--json", path("moved.suffuse")});
    QVERIFY(info.code == 0 && info.json()["missing"].toString().contains("l.png"));
    const CliOutcome kept = runCli({"convert", path("moved.suffuse"), "-"});
    QVERIFY(kept.code == 0 && kept.out.contains("\"link\": \"in/pictures/l.png\""));
}

QTEST_GUILESS_MAIN(TestCliPictures)
#include "test_cli_pictures.moc"
