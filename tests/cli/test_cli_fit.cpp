// From an image file to strokes through suffuse-cli, good and bad.
#include "cli_pictures.h"

#include "model/formats/files.h"

#include <QElapsedTimer>
#include <QTest>

#include <array>
#include <cmath>
#include <csignal>

using namespace suffuse;

class TestCliFit : public CliPictures {
    Q_OBJECT

private slots:
    void initTestCase();
    void statistics();
    void theSameTwice();
    void goesOn();
    void budgets();
    void palette();
    void mask();
    void styles_data();
    void styles();
    void kindsOfPictures_data();
    void kindsOfPictures();
    void largePictures();
    void diffusionCurves();
    void refit();
    void refitMistakes_data();
    void refitMistakes();
    void standardInput();
    void wrongUsage_data();
    void wrongUsage();
    void failures_data();
    void failures();
    void interrupted();
    void whatIsReadIsNotReplaced();

private:
    using Value = std::function<std::array<float, 4>(double x, double y)>;
    QString write(const QString &name, int width, int height, const ImageOptions &options, const Value &value) const;
    CliOutcome fit(const QString &in, const QString &out, const QStringList &options = {}) const
    {
        return runCli(QStringList{"fit", path(in), "-o", path(out), "--iterations", "60"} + options);
    }
    /// The PSNR of what `render` draws of a painting.
    double drawnRatio(const QString &painting, const QString &original) const;
};

namespace {

/// A blue ground with a red disc and a bright bar.
std::array<float, 4> scene(double x, double y)
{
    const bool isDisc = std::hypot((x - 0.3) * 1.3, y - 0.5) < 0.25, isBar = std::abs(x + y - 1.3) < 0.08;
    return isDisc  ? std::array<float, 4>{0.8f, 0.2f, 0.1f, 1}
           : isBar ? std::array<float, 4>{0.9f, 0.9f, 0.7f, 1}
                   : std::array<float, 4>{0.2f, 0.3f, 0.6f, 1};
}

/// Whether a process has a handler for SIGINT.
bool catchesInterrupts(qint64 process)
{
    const QByteArray status = readFile(QStringLiteral("/proc/%1/status").arg(process));
    const qsizetype at = status.indexOf("SigCgt:");
    return at >= 0 && (status.mid(at + 7, 17).trimmed().toULongLong(nullptr, 16) >> (SIGINT - 1) & 1) != 0;
}

} // namespace

QString TestCliFit::write(const QString &name, int width, int height, const ImageOptions &options,
                          const Value &value) const
{
    FloatPicture picture;
    picture.resize(width, height);
    std::vector<float> rgba(4 * std::size_t(width) * std::size_t(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::array<float, 4> v = value((x + 0.5) / width, (y + 0.5) / height);
            std::copy(v.begin(), v.end(), rgba.begin() + 4 * (std::ptrdiff_t(y) * width + x));
        }
    picture.store({0, 0, width, height}, rgba.data(), width);
    const Result<void> written = writeImage(path(name), picture, options);
    if (!written)
        qWarning("%s", qPrintable(written.error()));
    return path(name);
}

double TestCliFit::drawnRatio(const QString &painting, const QString &original) const
{
    const CliOutcome drawn = runCli({"render", path(painting), "-o", path("drawn.png"), "--depth", "16"});
    if (drawn.code != 0)
        qWarning("%s", qPrintable(drawn.text()));
    const FloatPicture a = picture("drawn.png"), b = picture(original);
    if (a.width != b.width || a.height != b.height)
        return -1;
    double sum = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < 3; ++c)
                sum += std::pow(double(a.at(x, y)[c] - b.at(x, y)[c]), 2);
    return -10 * std::log10(sum / (3.0 * a.width * a.height));
}

void TestCliFit::initTestCase()
{
    prepare();
    write("scene.png", 60, 40, {}, scene);
}

void TestCliFit::statistics()
{
    const CliOutcome outcome = fit("scene.png", "scene.suffuse", {"--strokes", "10", "--json", "--iterations", "200"});
    // --iterations is given twice.
    QCOMPARE(outcome.code, 2);
    const CliOutcome fitted = fit("scene.png", "scene.suffuse", {"--strokes", "10", "--json"});
    QVERIFY2(fitted.code == 0, qPrintable(fitted.text()));
    const QJsonObject stats = fitted.json();
    QCOMPARE(stats["width"].toInt(), 60);
    QCOMPARE(stats["height"].toInt(), 40);
    QVERIFY(stats["strokes"].toInt() > 4 && stats["strokes"].toInt() <= 10);
    QCOMPARE(stats["numbers"].toInt(), 27 * stats["strokes"].toInt());
    QVERIFY(stats["seconds"].toDouble() > 0);
    QCOMPARE(stats["iterations"].toInt(), 60); // as many as were asked for
    QVERIFY(stats["msSsim"].toDouble() > 0.5 && stats["msSsim"].toDouble() <= 1);
    QCOMPARE(stats["msSsimScales"].toInt(), 2);
    const double ratio = stats["psnr"].toDouble();
    QVERIFY2(ratio > 20, qPrintable(QString::number(ratio)));
    QVERIFY(std::abs(stats["error"].toDouble() - 255 * std::pow(10, -ratio / 20)) < 1e-6);
    // What `render` draws is what was fitted.
    QVERIFY(std::abs(drawnRatio("scene.suffuse", "scene.png") - ratio) < 0.05);
}

void TestCliFit::theSameTwice()
{
    for (const char *name : {"one.json", "two.json"})
        QVERIFY(fit("scene.png", name, {"--strokes", "6", "--threads", name[0] == 'o' ? "1" : "3"}).code == 0);
    QVERIFY(readFile(path("one.json")) == readFile(path("two.json")));
    QVERIFY(fit("scene.png", "three.json", {"--strokes", "6", "--seed", "7"}).code == 0);
    QVERIFY(readFile(path("one.json")) != readFile(path("three.json")));
}

void TestCliFit::goesOn()
{
    const CliOutcome first = fit("scene.png", "first.suffuse", {"--strokes", "4", "--json"});
    const CliOutcome second =
        fit("scene.png", "second.suffuse", {"--strokes", "12", "--json", "--from", path("first.suffuse")});
    QVERIFY2(first.code == 0 && second.code == 0, qPrintable(second.text()));
    QCOMPARE(second.json()["iterations"].toInt(), 60);
    QVERIFY(second.json()["psnr"].toDouble() > first.json()["psnr"].toDouble() + 1);
    QVERIFY(second.json()["strokes"].toInt() > first.json()["strokes"].toInt());
    const CliOutcome other = fit("scene.png", "other.suffuse", {"--from", path("a.json")});
    QCOMPARE(other.code, 1);
    QVERIFY2(other.err.contains("a.json"), other.err.constData());
    QVERIFY(!QFile::exists(path("other.suffuse")));
}

void TestCliFit::budgets()
{
    const CliOutcome numbers = fit("scene.png", "n.suffuse", {"--numbers", "110", "--json"});
    QVERIFY2(numbers.code == 0, qPrintable(numbers.text()));
    QVERIFY(numbers.json()["numbers"].toInt() <= 110 && numbers.json()["strokes"].toInt() > 0);
    const CliOutcome error = fit("scene.png", "e.suffuse", {"--error", "30", "--json"});
    QVERIFY2(error.code == 0, qPrintable(error.text()));
    QVERIFY(error.json()["error"].toDouble() <= 30);
    QVERIFY(error.json()["strokes"].toInt() < 60);
    const CliOutcome widths =
        fit("scene.png", "w.json", {"--strokes", "6", "--least-width", "6", "--greatest-width", "8"});
    QVERIFY2(widths.code == 0, qPrintable(widths.text()));
}

void TestCliFit::palette()
{
    const CliOutcome outcome = fit("scene.png", "p.suffuse", {"--strokes", "10", "--palette", "3", "--json"});
    QVERIFY2(outcome.code == 0, qPrintable(outcome.text()));
    QVERIFY(outcome.json()["paints"].toInt() >= 2 && outcome.json()["paints"].toInt() <= 3);
    const Result<Painting> painting = loadPainting(path("p.suffuse"));
    QVERIFY(bool(painting));
    QCOMPARE(int(painting->swatches.size()), outcome.json()["paints"].toInt());
    for (const StrokePtr &stroke : painting->strokes) {
        const Colour c = stroke->segments.front().colour;
        QVERIFY(std::any_of(painting->swatches.begin(), painting->swatches.end(), [&](const Swatch &s) {
            return s.colour.red == c.red && s.colour.yellow == c.yellow && s.colour.blue == c.blue;
        }));
    }
}

void TestCliFit::mask()
{
    // The mask has another size than the picture, and lets the left half count.
    write("mask.png", 30, 20, {}, [](double x, double) {
        const float v = x < 0.5 ? 1 : 0;
        return std::array<float, 4>{v, v, v, 1};
    });
    write("black.png", 3, 3, {}, [](double, double) { return std::array<float, 4>{0, 0, 0, 1}; });
    const CliOutcome half = fit("scene.png", "m.suffuse", {"--strokes", "6", "--json", "--mask", path("mask.png")}),
                     whole = fit("scene.png", "m2.suffuse", {"--strokes", "6", "--json"});
    QVERIFY2(half.code == 0, qPrintable(half.text()));
    QVERIFY(half.json()["psnr"].toDouble() > whole.json()["psnr"].toDouble());
    QVERIFY(drawnRatio("m.suffuse", "scene.png") < drawnRatio("m2.suffuse", "scene.png"));
    const CliOutcome none = fit("scene.png", "m3.suffuse", {"--mask", path("black.png")});
    QCOMPARE(none.code, 1);
    QVERIFY2(none.err.contains("black.png"), none.err.constData());
}

void TestCliFit::styles_data()
{
    QTest::addColumn<QString>("style");
    QTest::newRow("feathering") << "feathering";
    QTest::newRow("uniform") << "uniform";
    QTest::newRow("edge") << "edge";
}

void TestCliFit::styles()
{
    QFETCH(QString, style);
    const CliOutcome outcome = fit("scene.png", "s.suffuse", {"--strokes", "8", "--json", "--style", style});
    QVERIFY2(outcome.code == 0, qPrintable(outcome.text()));
    QVERIFY(std::abs(drawnRatio("s.suffuse", "scene.png") - outcome.json()["psnr"].toDouble()) < 0.05);
    const Result<Painting> painting = loadPainting(path("s.suffuse"));
    QVERIFY(painting && !painting->strokes.empty());
    QCOMPARE(int(painting->strokes[0]->style.kind), style == "feathering" ? 1 : style == "uniform" ? 0 : 2);
}

void TestCliFit::kindsOfPictures_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("least");
    ImageOptions deep, clear;
    deep.depth = ImageDepth::Bits16;
    clear.alpha = true;
    write("grey16.png", 40, 30, deep, [](double x, double y) {
        const auto v = float(0.2 + 0.6 * x * y);
        return std::array<float, 4>{v, v, v, 1};
    });
    write("alpha.png", 40, 30, clear, [](double x, double) {
        return std::array<float, 4>{0, 0, 1, x < 0.5 ? 1.0f : 0.0f};
    });
    write("flat.png", 40, 30, {}, [](double, double) { return std::array<float, 4>{0.2f, 0.4f, 0.6f, 1}; });
    write("dot.png", 1, 1, {}, [](double, double) { return std::array<float, 4>{1, 0, 0, 1}; });
    write("line.png", 90, 1, {}, scene);
    write("noise.png", 40, 30, {}, [](double x, double y) {
        const auto at = [](double v) { return float(v - std::floor(v)); };
        return std::array<float, 4>{at(x * 9871.3 + y * 7771.9), at(x * 5417.1 - y * 1291.7), at(y * 3313.3 * x), 1};
    });
    QTest::newRow("grey, 16 bits") << "grey16.png" << 30.0;
    QTest::newRow("transparent") << "alpha.png" << 18.0;
    QTest::newRow("one colour") << "flat.png" << 50.0;
    QTest::newRow("one pixel") << "dot.png" << 50.0;
    QTest::newRow("one row") << "line.png" << 10.0;
    QTest::newRow("noise") << "noise.png" << 8.0;
}

void TestCliFit::kindsOfPictures()
{
    QFETCH(QString, name);
    QFETCH(double, least);
    const CliOutcome outcome = fit(name, "k.suffuse", {"--strokes", "6", "--json"});
    QVERIFY2(outcome.code == 0, qPrintable(outcome.text()));
    QVERIFY2(outcome.json()["psnr"].toDouble() > least, qPrintable(outcome.text()));
    QCOMPARE(runCli({"render", path("k.suffuse"), "-o", path("k.png")}).code, 0);
    QCOMPARE(picture("k.png").width, picture(name).width);
}

void TestCliFit::largePictures()
{
    write("large.png", 600, 400, {}, scene);
    const CliOutcome outcome = fit("large.png", "l.suffuse", {"--strokes", "6", "--json", "--pixels", "2000"});
    QVERIFY2(outcome.code == 0, qPrintable(outcome.text()));
    QVERIFY(outcome.json()["width"].toInt() * outcome.json()["height"].toInt() <= 2100);
    const Result<Painting> painting = loadPainting(path("l.suffuse"));
    QVERIFY(painting && painting->canvas.width == 600 && painting->canvas.height == 400);
    QVERIFY(drawnRatio("l.suffuse", "large.png") > 18); // it looks like the large picture, too
}

void TestCliFit::diffusionCurves()
{
    const QByteArray curve =
        "<curve><control_points_set><control_point x=\"-9\" y=\"20\"/><control_point x=\"12\" y=\"26\"/>"
        "<control_point x=\"22\" y=\"14\"/><control_point x=\"41\" y=\"20\"/></control_points_set>"
        "<left_colors_set><left_color R=\"40\" G=\"90\" B=\"220\" globalID=\"0\"/></left_colors_set>"
        "<right_colors_set><right_color R=\"160\" G=\"90\" B=\"30\" globalID=\"0\"/></right_colors_set>"
        "<blur_points_set><best_scale value=\"2\" globalID=\"0\"/></blur_points_set></curve>";
    QVERIFY(writeFile(path("curves.xml"), "<!DOCTYPE CurveSetXML><curve_set image_width=\"48\" image_height=\"32\">" +
                                              curve + "</curve_set>"));
    const CliOutcome fitted = fit("curves.xml", "curves.suffuse", {"--strokes", "4", "--target", path("solved.png")});
    QVERIFY2(fitted.code == 0, qPrintable(fitted.text()));
    const double ratio = drawnRatio("curves.suffuse", "solved.png");
    QVERIFY2(ratio > 30, qPrintable(QString::number(ratio)));
    const CliOutcome converted =
        runCli({"convert", path("curves.xml"), path("converted.suffuse"), "--fit", "--strokes", "2"});
    QVERIFY2(converted.code == 0, qPrintable(converted.text()));
    const Result<Painting> painting = loadPainting(path("converted.suffuse"));
    QVERIFY(painting && painting->canvas.width == 48 && painting->strokes.size() <= 2);
    QCOMPARE(runCli({"convert", path("curves.xml"), path("x.suffuse"), "--strokes", "2"}).code, 2);
    QCOMPARE(runCli({"convert", path("curves.xml"), path("x.suffuse"), "--fit", "--plain"}).code, 2);
    QCOMPARE(fit("curves.xml", "x.suffuse", {"--target", path("solved.bmp")}).code, 2);
    QVERIFY(!QFile::exists(path("x.suffuse")));
}

void TestCliFit::refit()
{
    QCOMPARE(fit("scene.png", "many.suffuse", {"--strokes", "12"}).code, 0);
    const Result<Painting> many = loadPainting(path("many.suffuse"));
    QVERIFY(many && many->strokes.size() > 6);
    const QString ids = QStringLiteral("%1-%2").arg(many->strokes[2]->id).arg(many->strokes.back()->id);
    const CliOutcome done = runCli({"refit", path("many.suffuse"), "-o", path("few.suffuse"), "--select", ids, "--strokes",
                                    "4", "--iterations", "120", "--json"});
    QVERIFY2(done.code == 0, qPrintable(done.text()));
    const QJsonObject said = done.json();
    QCOMPARE(said["strokesBefore"].toInt(), int(many->strokes.size()) - 2);
    QVERIFY(said["strokes"].toInt() >= 1 && said["strokes"].toInt() <= 4);
    QCOMPARE(said["errorBefore"].toObject()["greatest"].toDouble(), 0.0);
    const QJsonObject error = said["error"].toObject();
    QVERIFY2(error["rootMeanSquare"].toDouble() > 0 && error["rootMeanSquare"].toDouble() < 40, qPrintable(done.text()));
    QVERIFY(error["greatest"].toDouble() >= error["rootMeanSquare"].toDouble());
    const Result<Painting> few = loadPainting(path("few.suffuse"));
    QVERIFY(few);
    QCOMPARE(int(few->strokes.size()), 2 + said["strokes"].toInt());
    QCOMPARE(*few->strokes[0], *many->strokes[0]);
    // No more strokes than an error asks for.
    const CliOutcome coarse =
        runCli({"refit", path("many.suffuse"), "-o", path("coarse.suffuse"), "--error", "60", "--iterations", "40", "--json"});
    QVERIFY2(coarse.code == 0, qPrintable(coarse.text()));
    QVERIFY(coarse.json()["strokes"].toInt() <= 4);
    // To the picture itself, and as a sentence.
    const CliOutcome to = runCli({"refit", path("few.suffuse"), "-o", path("to.suffuse"), "--to", path("scene.png"), "--strokes",
                                  "8", "--iterations", "120"});
    QVERIFY2(to.code == 0 && to.text().contains("Before it was"), qPrintable(to.text()));
    QVERIFY(drawnRatio("to.suffuse", "scene.png") > 18);
    QVERIFY(!to.err.contains("farther"));
    // What comes out worse than it went in is not written without a word.
    const CliOutcome worse = runCli({"refit", path("many.suffuse"), "-o", path("worse.suffuse"), "--to", path("scene.png"),
                                     "--strokes", "1", "--iterations", "2", "--json"});
    QVERIFY2(worse.code == 0 && worse.json()["worse"].toBool(), qPrintable(worse.text()));
    QVERIFY2(worse.err.contains("farther") && worse.err.contains("scene.png"), worse.err.constData());
    const CliOutcome missed = runCli({"refit", path("many.suffuse"), "-o", path("missed.suffuse"), "--strokes", "1",
                                      "--error", "0.5", "--iterations", "2", "--json"});
    QVERIFY2(missed.code == 0 && missed.err.contains("--error 0.5 was not reached"), qPrintable(missed.text()));
    QVERIFY(!missed.json()["worse"].toBool()); // It is compared with itself, which nothing is nearer to.
}

void TestCliFit::refitMistakes_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<int>("code");
    const auto row = [](const char *message, const QStringList &options, int code) { QTest::newRow(message) << options << code; };
    row("-o OUT is missing", {}, 2);
    row("both say which strokes", {"-o", path("x.suffuse"), "--select", "1", "--layer", "a"}, 2);
    row("is IN itself", {"-o", path("a.json")}, 2);
    row("give ids of strokes", {"-o", path("x.suffuse"), "--select", "9-3"}, 2);
    row("there is no stroke 99", {"-o", path("x.suffuse"), "--select", "99"}, 2);
    row("no group of that name", {"-o", path("x.suffuse"), "--layer", "none"}, 2);
    row("give a whole number", {"-o", path("x.suffuse"), "--strokes", "0"}, 2);
    row("crop it to the shape", {"-o", path("x.suffuse"), "--to", path("scene.png")}, 1);
    row("unknown ending", {"-o", path("x.png")}, 2);
}

void TestCliFit::refitMistakes()
{
    QFETCH(const QStringList, options);
    QFETCH(const int, code);
    const CliOutcome outcome = runCli(QStringList{"refit", path("a.json")} + options);
    QVERIFY2(outcome.code == code && outcome.text().contains(QTest::currentDataTag()), qPrintable(outcome.text()));
    QVERIFY(!QFile::exists(path("x.suffuse")));
}

void TestCliFit::standardInput()
{
    const CliOutcome outcome = runCli({"fit", "-", "-o", path("i.suffuse"), "--strokes", "3", "--iterations", "5"},
                                      readFile(path("scene.png")));
    QVERIFY2(outcome.code == 0, qPrintable(outcome.text()));
    QVERIFY(outcome.out.isEmpty());
    QVERIFY(QFile::exists(path("i.suffuse")));
}

void TestCliFit::wrongUsage_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QString>("says");
    const auto row = [](const QStringList &options, const char *says) {
        QTest::newRow(qPrintable(options.join(' '))) << options << QString(says);
    };
    row({"--strokes", "0"}, "whole number");
    row({"--strokes", "3.5"}, "whole number");
    row({"--strokes", "9", "--numbers", "270"}, "give one of them");
    row({"--numbers", "26"}, "27");
    row({"--error", "nothing"}, "number");
    row({"--palette", "0"}, "whole number");
    row({"--style", "round"}, "feathering");
    row({"--style", "edge", "--from", "x.suffuse"}, "--from");
    row({"--least-width", "5", "--greatest-width", "4"}, "below");
    row({"--perceptual", "2"}, "0 to 1");
    row({"--seed", "-1"}, "whole number");
    row({"--threads", "0"}, "whole number");
}

void TestCliFit::wrongUsage()
{
    QFETCH(QStringList, options);
    QFETCH(QString, says);
    const CliOutcome outcome = fit("scene.png", "u.suffuse", options);
    QVERIFY2(outcome.code == 2, qPrintable(outcome.text()));
    QVERIFY2(outcome.err.contains(says.toUtf8()), outcome.err.constData());
    QVERIFY(!QFile::exists(path("u.suffuse")));
    QCOMPARE(runCli({"fit", path("scene.png")}).code, 2);
    QCOMPARE(runCli({"fit", path("scene.png"), "-o", path("u.png")}).code, 2);
}

void TestCliFit::failures_data()
{
    QTest::addColumn<QString>("in");
    QTest::addColumn<QString>("out");
    QTest::addColumn<QString>("says");
    QVERIFY(writeFile(path("empty.png"), {}));
    QVERIFY(writeFile(path("half.png"), readFile(path("scene.png")).left(60)));
    QTest::newRow("no file") << "none.png"
                             << "f.suffuse"
                             << "none.png";
    QTest::newRow("an empty file") << "empty.png"
                                   << "f.suffuse"
                                   << "empty.png";
    QTest::newRow("a cut file") << "half.png"
                                << "f.suffuse"
                                << "half.png";
    QTest::newRow("a painting") << "a.json"
                                << "f.suffuse"
                                << "suffuse-cli render";
    QTest::newRow("no folder") << "scene.png"
                               << "none/f.suffuse"
                               << "no folder";
}

void TestCliFit::failures()
{
    QFETCH(QString, in);
    QFETCH(QString, out);
    QFETCH(QString, says);
    const CliOutcome outcome = fit(in, out);
    QVERIFY2(outcome.code == 1, qPrintable(outcome.text()));
    QVERIFY2(outcome.err.contains(says.toUtf8()), outcome.err.constData());
    QVERIFY(outcome.out.isEmpty() && !QFile::exists(path(out)));
}

/// The strokes so far are written, whole, and a further fit goes on with them.
void TestCliFit::whatIsReadIsNotReplaced()
{
    const auto bytesOf = [](const QString &file) {
        QFile read(file);
        return read.open(QIODevice::ReadOnly) ? read.readAll() : QByteArray();
    };
    const QString picture = path("scene.png"), painting = path("own.suffuse");
    QCOMPARE(fit("scene.png", "own.suffuse", {"--strokes", "2"}).code, 0);
    const QByteArray pictureBytes = bytesOf(picture), paintingBytes = bytesOf(painting);
    QVERIFY(!pictureBytes.isEmpty() && !paintingBytes.isEmpty());
    for (const QStringList &arguments : {QStringList{"fit", picture, "-o", path("x.suffuse"), "--target", picture},
                                         QStringList{"refit", painting, "-o", painting},
                                         QStringList{"thumbnail", painting, painting, "64"},
                                         QStringList{"render", painting, "-o", painting, "--format", "png"}}) {
        const CliOutcome outcome = runCli(arguments);
        QVERIFY2(outcome.code == 2 && outcome.err.contains("would be lost"), qPrintable(arguments.join(' ') + outcome.text()));
    }
    QCOMPARE(bytesOf(picture), pictureBytes);
    QCOMPARE(bytesOf(painting), paintingBytes);
    // What was asked for and not reached is said.
    const CliOutcome far = fit("scene.png", "x.suffuse", {"--strokes", "1", "--error", "0.5"});
    QVERIFY2(far.code == 0 && far.err.contains("was not reached"), qPrintable(far.text()));
}

void TestCliFit::interrupted()
{
    QProcess process;
    const QString out = path("stopped.suffuse");
    process.start(SUFFUSE_BIN_DIR "/suffuse-cli",
                  {"fit", path("scene.png"), "-o", out, "--strokes", "40", "--iterations", "1000000"});
    QVERIFY(process.waitForStarted());
    // Before it catches the signal it would end by it. By then it may have no stroke yet, and writes nothing.
    QTRY_VERIFY_WITH_TIMEOUT(catchesInterrupts(process.processId()), 60'000);
    QTest::qWait(1000);
    ::kill(pid_t(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 1);
    const QByteArray said = process.readAllStandardError();
    QVERIFY2(said.contains("stopped"), said.constData());
    QCOMPARE(QFile::exists(out), said.contains("--from"));
    if (QFile::exists(out))
        QCOMPARE(fit("scene.png", "resumed.suffuse", {"--strokes", "40", "--from", out}).code, 0);
    QVERIFY(filesIn(path(".")).filter("stopped").size() <= 1);
}

QTEST_GUILESS_MAIN(TestCliFit)
#include "test_cli_fit.moc"
