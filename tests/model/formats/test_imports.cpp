// Recordings become paintings: what is found in them, their timing, and what is said of damaged ones.
#include "model/formats/files.h"
#include "model/formats/ink/recording.h"
#include "model/formats/svg/css/css_colours.h"
#include "model/paint/half_width.h"
#include "model/painting/ryb.h"
#include "model/painting/validate.h"

#include <QFile>
#include <QRandomGenerator>
#include <QTest>

#include <numbers>

using namespace suffuse;

namespace {

Result<Painting> import(const QByteArray &bytes)
{
    return readPainting(bytes, QStringLiteral("a.ink"));
}

QString errorOf(const QByteArray &bytes)
{
    const auto p = import(bytes);
    return p ? QStringLiteral("no error") : p.error();
}

/// With ' for ".
QByteArray json(QByteArray text)
{
    return text.replace('\'', '"');
}

double seconds(const StrokePtr &stroke)
{
    return toSeconds(stroke->segments.back().born - stroke->born());
}

QByteArray csvLine(double time)
{
    QByteArray text("x,y,time\n");
    for (int k = 0; k < 40; ++k)
        text += QByteArray::number(10 + k) + ",20," + QByteArray::number(time * k, 'g', 17) + "\n";
    return text;
}

} // namespace

class TestImports : public QObject {
    Q_OBJECT

private slots:
    void recordings_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<int>("format");
        QTest::addColumn<int>("strokes");
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("most");
        const auto row = [](const char *path, FileFormat format, int strokes, double least, double most) {
            QTest::newRow(path) << QString::fromLatin1(path) << int(format) << strokes << least << most;
        };
        // The seconds from the first stroke to the last segment, from the recordings' own stamps.
        row("ink/sensor_data.csv", FileFormat::InkCsv, 4, 6.3, 6.6);
        row("ink/digital_ink.json", FileFormat::UniversalInk, 177, 60, 1e5);
        row("excalidraw/biology.excalidrawlib", FileFormat::Excalidraw, 173, 50, 1e4);
        row("excalidraw/despair.excalidrawlib", FileFormat::Excalidraw, 137, 40, 1e4);
        row("painting30sec.dat", FileFormat::MyPaintEvents, 30, 28, 30);
    }

    void recordings()
    {
        QFETCH(QString, path);
        QFETCH(int, format);
        QFETCH(int, strokes);
        QFETCH(double, least);
        QFETCH(double, most);
        QFile file(QStringLiteral(SUFFUSE_SOURCE_DIR "/../shared/data/") + path);
        if (!file.open(QIODevice::ReadOnly))
            QSKIP(qPrintable(QStringLiteral("../shared/data/%1 is missing").arg(path)));
        const QByteArray bytes = file.readAll();
        QCOMPARE(int(detectFormat(bytes)), format);
        const auto p = readPainting(bytes, path);
        QVERIFY2(p, p ? "" : qPrintable(p.error()));
        QCOMPARE(int(p->strokes.size()), strokes);
        QCOMPARE(problemOf(*p), QString());
        Microseconds first = std::numeric_limits<Microseconds>::max(), last = 0;
        Rect box;
        for (const StrokePtr &s : p->strokes) {
            first = std::min(first, s->born());
            last = std::max(last, s->segments.back().born);
            QCOMPARE(s->brush, builtinBrushes().front().name);
            for (const Segment &segment : s->segments) {
                box.include(s->origin + segment.bezier[0]);
                box.include(s->origin + segment.bezier[3]);
            }
        }
        QVERIFY2(first >= 0 && first < 100'000,
                 qPrintable(QString::number(first))); // a first pair of equal samples may go
        QVERIFY2(toSeconds(last) >= least && toSeconds(last) <= most, qPrintable(QString::number(toSeconds(last))));
        QVERIFY(p->canvas.area().contains({box.left, box.top}) && p->canvas.area().contains({box.right, box.bottom}));
        QCOMPARE(p->canvas.width, std::ceil(p->canvas.width));
        const auto again = readSuffuseFile(writeSuffuseFile(*p), QStringLiteral("a.suffuse"));
        QVERIFY(again && *again == *p);
        const auto text = readTextForm(writeTextForm(*p), QStringLiteral("a.json"));
        QVERIFY(text && *text == *p);
    }

    void damagedRecordingsEnd()
    {
        for (const char *path :
             {"ink/sensor_data.csv", "ink/digital_ink.json", "excalidraw/despair.excalidrawlib", "painting30sec.dat"}) {
            QFile file(QStringLiteral(SUFFUSE_SOURCE_DIR "/../shared/data/") + QLatin1String(path));
            if (!file.open(QIODevice::ReadOnly))
                QSKIP("../shared/data is missing");
            const QByteArray bytes = file.readAll();
            QRandomGenerator random(1);
            for (int k = 0; k < 25; ++k) {
                QByteArray damaged = k % 2 ? bytes.left(random.bounded(qint64(bytes.size()))) : bytes;
                for (int n = 0; n < 4 && !damaged.isEmpty(); ++n)
                    damaged[random.bounded(int(damaged.size()))] = char(random.bounded(256));
                const auto p = import(damaged);
                if (p)
                    QCOMPARE(problemOf(*p), QString());
                else
                    QVERIFY2(p.error().startsWith(QLatin1String("a.ink: ")), qPrintable(p.error()));
            }
        }
    }

    void canvasIsBoundsPlusTwoSpreads()
    {
        const auto p = import("x,y,time,pressure\n-100,50,0,1\n-60.5,50,0.1,1\n-20,80,0.2,1\n");
        QVERIFY2(p, p ? "" : qPrintable(p.error()));
        const double s = builtinBrushes().front().spread();
        QCOMPARE(p->canvas.width, std::ceil(80 + 4 * s));
        QCOMPARE(p->canvas.height, std::ceil(30 + 4 * s));
        const Stroke &stroke = *p->strokes[0];
        const Point start = stroke.origin + stroke.segments.front().bezier[0];
        const Point end = stroke.origin + stroke.segments.back().bezier[3];
        QVERIFY(length(start - Point{2 * s, 2 * s}) < 1e-3);
        QVERIFY(length(end - Point{2 * s + 80, 2 * s + 30}) < 1e-3);
    }

    void timeUnits()
    {
        // 8 ms a sample, 39 steps: the last segment starts within 1/60 s of 0.312 s.
        for (const double unit : {0.008, 8.0, 8000.0}) {
            const auto p = import(csvLine(unit));
            QVERIFY(p);
            const double t = seconds(p->strokes[0]);
            QVERIFY2(t > 0.28 && t < 0.313, qPrintable(QString::number(t)));
        }
        // A name may say the unit, whatever the steps look like.
        const auto slow = import(csvLine(0.5).replace("time", "time_ms"));
        QVERIFY(slow && seconds(slow->strokes[0]) < 0.021);
        // Milliseconds since 1970 when a stroke starts, plus seconds.
        const auto mixed =
            import("stroke,x,y,timestamp\n0,0,0,1722443386312.0\n0,5,0,1722443386312.05\n0,9,0,1722443386312.1\n"
                   "1,0,9,1722443387312.0\n1,5,9,1722443387312.05\n1,9,9,1722443387312.1\n");
        QVERIFY(mixed);
        QCOMPARE(mixed->strokes[1]->born() - mixed->strokes[0]->born(), Microseconds(1'000'000));
        // No times at all.
        const auto untimed = import("x;y\n0;0\n5;0\n9;1\n20;5\n30;8\n40;9\n");
        QVERIFY(untimed && untimed->strokes.size() == 1);
        QVERIFY(seconds(untimed->strokes[0]) <= 0.04);
    }

    void columnsInAnyOrder()
    {
        const auto p = import("# a "
                              "comment\n\"Pressure\"\tstroke\tTime\tY\tX\n0.5\ta\t0\t2\t1\n0.7\tb\t1\t9\t9\n0.5\ta\t0."
                              "01\t2\t30\n\n0.7\tb\t1.01\t20\t9\n");
        QVERIFY2(p, p ? "" : qPrintable(p.error()));
        QCOMPARE(p->strokes.size(), std::size_t(2));
        const auto headless = import("1,2,0,1\n30,2,0.01,1\n31,2,0.02,0\n60,2,0.5,1\n70,2,0.51,1\n");
        QVERIFY(headless);
        QCOMPARE(headless->strokes.size(), std::size_t(2)); // the pen was up once
        const auto dot = import("x,y\r\n5,6\r\n");
        QVERIFY(dot);
        QCOMPARE(dot->strokes.size(), std::size_t(1));
        const auto unpressed = import("x,y,pressure\n1,2,0\n30,2,0\n");
        QVERIFY(unpressed && unpressed->strokes.size() == 1);
    }

    void badLinesAreNamed()
    {
        QVERIFY2(errorOf("x,y,time\n1,2,0\n3,oops,1\n")
                     .startsWith(QStringLiteral("a.ink: line 3, column y: “oops” is not a number")),
                 qPrintable(errorOf("x,y,time\n1,2,0\n3,oops,1\n")));
        QVERIFY(errorOf("x,y,time\n1,2,nan\n").contains(QStringLiteral("line 2, column time: “nan”")));
        QVERIFY(errorOf("x,y\n1e300,2\n").contains(QLatin1String("line 2, column x")));
        QVERIFY(errorOf("x,y\n1\n").contains(QLatin1String("line 2, column y")));
        QVERIFY(errorOf("x,y\n").contains(QLatin1String("no pen strokes")));
        QVERIFY(errorOf("x,y\n0,0\n1e9,0\n").contains(QLatin1String("at most 1e6")));
        QVERIFY(errorOf("0 1 2 1\n0 1 x 1\n").contains(QStringLiteral("line 2, column y: “x”")));
        QVERIFY(errorOf("0 1 2 1\n0 1\n").contains(QLatin1String("line 2, column y")));
        QVERIFY(errorOf("{\"type\": \"excalidraw\", \"elements\": [").contains(QLatin1String("line 1, column ")));
        QVERIFY(
            errorOf("{\"type\": \"excalidraw\", \"elements\": []}").contains(QLatin1String("no freedraw elements")));
        QVERIFY(errorOf("{\"type\": \"excalidraw\", \"elements\": [{\"type\": \"freedraw\", \"x\": 0, \"y\": 0, "
                        "\"points\": [[0,0],[1,\"a\"]]}]}")
                    .contains(QLatin1String("elements[0].points[1][1]: is not a number")));
        QVERIFY(errorOf("{\"inkData\": {\"strokes\": [{\"splineX\": [1,2], \"splineY\": [1]}]}}")
                    .contains(QLatin1String("inkData.strokes[0]: splineX has 2 numbers, splineY 1")));
        QVERIFY(errorOf("{\"inkData\": {\"strokes\": [{\"splineX\": 3}]}}")
                    .contains(QLatin1String("inkData.strokes[0].splineX")));
        QVERIFY(errorOf("{\"inkData\": 7}").contains(QLatin1String("neither a painting")) ||
                errorOf("{\"inkData\": 7}").contains(QLatin1String("no pen strokes")));
    }

    void foreignFilesAreNamed()
    {
        QVERIFY(errorOf({}).contains(QLatin1String("is empty")));
        // A compressed file may hold what can be read, or not: the message says what that is.
        const QString gzip = errorOf(QByteArray("\x1f\x8b\x08\x00", 4) + QByteArray(60, 'x'));
        QVERIFY2(gzip.contains(QLatin1String("gzip")) && gzip.contains(QLatin1String("Suffuse reads .suffuse")) &&
                     gzip.contains(QLatin1String("SVG")),
                 qPrintable(gzip));
        QVERIFY(errorOf("<?xml version=\"1.0\"?><notes/>").contains(QLatin1String("Suffuse reads .suffuse")));
        QVERIFY(errorOf("\x89PNG\r\n\x1a\n").contains(QLatin1String("is a picture")));
        QVERIFY(errorOf("<?xml version=\"1.0\"?><kml/>").contains(QLatin1String("neither a painting")));
        QVERIFY(errorOf("{\"a\": [1,2]}").contains(QLatin1String("neither a painting")));
        QVERIFY(errorOf(QByteArray("\xff\xfe{\0", 4)).contains(QLatin1String("UTF-16")));
        QVERIFY(errorOf(QByteArray(100, '\0')).contains(QLatin1String("neither a painting")));
        QVERIFY(errorOf("name,value\na,1\n").contains(QLatin1String("neither a painting")));
        QCOMPARE(detectFormat("{\"canvas\": {}, \"format\": \"suffuse-text\"}"), FileFormat::Text);
        QCOMPARE(detectFormat("{\"strokes\": [{\"format\": \"}\\\"\"}]}"), FileFormat::Text);
    }

    void universalInkTilts()
    {
        const auto tiltsOf = [](const QByteArray &altitudes) {
            const QByteArray bytes =
                R"({"inputData": {"inputContextData": {"sensorContexts": [{"sensorChannelsContext": [{"channels": [
                    {"id": "t", "type": "ink/Timestamp", "resolution": 1000},
                    {"id": "a", "type": "ink/Altitude", "resolution": 1, "precision": 2}]}]}]},
                   "sensorData": [{"id": "s", "timestamp": 5, "dataChannels": [
                    {"sensorChannelID": "t", "values": [0, 10, 10]}, {"sensorChannelID": "a", "values": )" +
                altitudes + R"(}]}]}, "inkData": {"strokes": [{"sensorDataID": "s", "splineX": [0, 20, 40],
                   "splineY": [0, 0, 0]}]}})";
            const auto recording = readUniversalInk(bytes, "a.json");
            std::vector<double> tilts;
            if (recording)
                for (const PenSample &sample : recording->paths.at(0).samples)
                    tilts.push_back(double(sample.tilt));
            return tilts;
        };
        // Radians over the tablet in hundredths, as differences: upright, 60° from upright, flat.
        const std::vector<double> tilts = tiltsOf("[157, -105, -52]");
        QCOMPARE(tilts.size(), std::size_t(3));
        QVERIFY(tilts[0] < 0.001 && std::abs(tilts[1] - 1) < 0.01);
        QCOMPARE(tilts[2], 1.0);
        QVERIFY(std::abs(tiltsOf("[105, 0, 0]")[1] - 0.5) < 0.005);
        QCOMPARE(tiltsOf("[0, 0, 0]"), (std::vector<double>{0, 0, 0})); // not measured
    }

    /// Width of the dry stroke in the middle of each of its segments.
    static std::vector<double> widthsOf(const Stroke &stroke)
    {
        std::vector<double> widths;
        for (const Segment &s : stroke.segments)
            widths.push_back(
                2 * halfWidth(double(s.diffusion), double(s.density), double(s.maxAge), visibleCut(stroke.styleOf(s))));
        return widths;
    }

    void universalInkWidths_data()
    {
        QTest::addColumn<QByteArray>("stroke");
        QTest::addColumn<QByteArray>("brush");
        QTest::addColumn<double>("first");
        QTest::addColumn<double>("last");
        const QByteArray circle = "ink/Circle?precision=8&radius=";
        QTest::newRow("along the stroke") << QByteArray("\"size\": [2, 3, 4, 5, 6]") << circle << 4.0 << 12.0;
        QTest::newRow("of the style") << QByteArray("\"style\": {\"properties\": {\"size\": {\"value\": 3.5}}}")
                                      << circle << 7.0 << 7.0;
        QTest::newRow("of a brush of its own radius")
            << QByteArray("\"size\": [2, 2, 2, 2, 2], \"style\": {\"brushURI\": \"b\"}") << circle + "0.5" << 2.0
            << 2.0;
        QTest::newRow("hairlines") << QByteArray("\"size\": [0.4, 0.4, 0.4, 0.4, 0.5]") << circle << 0.8 << 1.0;
    }
    void universalInkWidths()
    {
        QFETCH(const QByteArray, stroke);
        QFETCH(const QByteArray, brush);
        QFETCH(const double, first);
        QFETCH(const double, last);
        const QByteArray bytes =
            json("{'inputData': {'inputContextData': {'sensorContexts': [{'sensorChannelsContext': [{'channels': "
                 "[{'id': 'p', 'type': 'ink/Pressure', 'precision': 2}]}]}]}, 'sensorData': [{'id': 's', "
                 "'dataChannels': [{'sensorChannelID': 'p', 'values': [90, -80, 40, 0, 3]}]}]}, 'brushes': "
                 "{'vectorBrushes': [{'name': 'b', 'prototype': [{'shapeURI': '") +
            brush +
            json("'}]}]}, 'inkData': {'strokes': [{'sensorDataID': 's', 'splineX': [0, 40, 80, 120, 160], 'splineY': "
                 "[0, 0, 0, 0, 0], ") +
            stroke + "}]}}";
        for (const Brush &painted : builtinBrushes()) { // whatever the brush in hand makes of pressure and speed
            Brush edged = painted;
            edged.style = builtinBrushes().front().style, edged.peak = 2;
            edged.jitter = {}, edged.dynamics.clear();
            edged.setCurve(BrushQuantity::Density, BrushInput::Pressure, {});
            edged.setCurve(BrushQuantity::Size, BrushInput::Speed, {{{0, 1}, {1, 0.1f}}});
            edged.taper.in = 4;
            const auto p = readPainting(bytes, "a.json", &edged);
            QVERIFY2(p, p ? "" : qPrintable(p.error()));
            const std::vector<double> widths = widthsOf(*p->strokes.at(0));
            QVERIFY2(std::abs(widths.front() - first) < 0.05 * first && std::abs(widths.back() - last) < 0.05 * last,
                     qPrintable(QString("%1 %2").arg(widths.front()).arg(widths.back())));
        }
    }

    void whatRecordingsHoldBesideIsSaid()
    {
        const auto leftOut = [](const QByteArray &bytes) {
            const auto document = readDocument(bytes, "a.ink");
            return document ? document->leftOut : document.error();
        };
        QCOMPARE(leftOut(json("{'inkData': {'strokes': [{'splineX': [0, 9], 'splineY': [0, 9], 'size': [1, 2]}]}}")),
                 QString());
        QCOMPARE(
            leftOut(json("{'inkData': {'strokes': [ {'splineX': [0, 9], 'splineY': [0, 9], 'rotation': [1, 1], "
                         "'style': {'brushURI': 'pencil'}}, {'splineX': [0, 9], 'splineY': [0, 9], 'scaleX': [2, "
                         "2]}]}, 'brushes': {'rasterBrushes': [{'name': 'pencil'}]}, 'views': [{'name': 'words'}]}")),
            QString(
                "1 brush shape(s), 2 turned or stretched brush tip(s), 1 view(s) of recognised text were left out."));
        QCOMPARE(leftOut("x,y,Azimuth,time,hue\n1,2,0,0,1\n9,9,0,1,1\n"),
                 QString("column “Azimuth”, column “hue” were left out."));
        QCOMPARE(leftOut("x,y,SENSOR_ALTITUDE,pen_width,time\n1,2,0.5,1,0\n9,9,0.5,1,1\n"), QString());
        QCOMPARE(leftOut(json("{'type': 'excalidraw', 'elements': [{'type': 'line'}, {'type': 'text'}, {'type': "
                              "'text', 'isDeleted': true}, {'type': 'freedraw', 'x': 0, 'y': 0, 'backgroundColor': "
                              "'red', 'points': [[0,0],[90,0],[90,90],[0,0]]}]}")),
                 QString("1 fill(s), 2 element(s) not drawn freehand were left out."));
    }

    void csvWidthsAndTilts()
    {
        const auto p = import("x,y,width,time\n0,0,6,0\n40,0,6,0.05\n80,0,12,0.1\n120,0,12,0.15\n");
        QVERIFY2(p, p ? "" : qPrintable(p.error()));
        const std::vector<double> widths = widthsOf(*p->strokes.at(0));
        QVERIFY(std::abs(widths.front() - 6) < 0.4 && std::abs(widths.back() - 12) < 0.4);
        for (const QByteArray unit : {"1.5707963,1.0471976,0.5235988", "90,60,30"}) {
            const QList<QByteArray> a = unit.split(',');
            const auto recording =
                readInkCsv("x,y,altitude\n0,0," + a[0] + "\n9,0," + a[1] + "\n20,0," + a[2] + "\n", "a");
            QVERIFY(recording);
            const auto &samples = recording->paths.at(0).samples;
            QVERIFY(samples[0].tilt < 1e-4f && std::abs(samples[1].tilt - 0.5f) < 1e-4f && samples[2].tilt > 0.9999f);
        }
        QVERIFY(errorOf("x,y,width\n0,0,thick\n").contains("line 2, column width"));
    }

    /// 4.25 × the stroke's width × what the pressure leaves is the radius.
    void excalidrawWidths()
    {
        const auto width = [](const QByteArray &more) {
            const auto p = import(json("{'type': 'excalidraw', 'elements': [{'type': 'freedraw', 'x': 0, 'y': 0, "
                                       "'strokeWidth': 2, 'points': [[0,0],[60,0],[120,0],[180,0],[240,0]], ") +
                                  more + "}]}");
            return p ? widthsOf(*p->strokes.at(0)).back() : 0;
        };
        const double size = 2 * 4.25 * 2;
        const auto near = [](double a, double b) { return std::abs(a - b) < 0.05 * b; };
        QVERIFY(near(width(json("'pressures': [0.5, 0.5, 0.5, 0.5, 0.5]")), size * std::sqrt(0.5)));
        QVERIFY(near(width(json("'pressures': [1, 1, 1, 1, 1]")), size * std::sin(0.4 * std::numbers::pi)));
        QVERIFY(near(width(json("'simulatePressure': true, 'pressures': []")), size * std::sqrt(0.5)));
    }

    void excalidrawColoursAndTurns()
    {
        const auto p = import(
            "{\"elements\": [{\"type\": \"freedraw\", \"x\": 100, \"y\": 100, \"angle\": 1.5707963267948966, "
            "\"strokeColor\": \"#f00\","
            " \"opacity\": 50, \"points\": [[0,0],[50,0],[100,0]], \"pressures\": []}, {\"type\": \"rectangle\"},"
            " {\"type\": \"freedraw\", \"isDeleted\": true, \"points\": [[0,0]]}], \"type\": \"excalidraw\"}");
        QVERIFY2(p, p ? "" : qPrintable(p.error()));
        QCOMPARE(p->strokes.size(), std::size_t(1));
        QCOMPARE(p->strokes[0]->segments[0].colour, (Colour{1, 0, 0, 0.5f}));
        QVERIFY(p->canvas.height > p->canvas.width + 90); // upright after a quarter turn
    }

    void cssColours()
    {
        using Rgba = std::array<double, 4>;
        QCOMPARE(*cssColour(QStringLiteral("#1e90ff")), *cssColour(QStringLiteral("DodgerBlue")));
        QCOMPARE(*cssColour(QStringLiteral("#fff")), *cssColour(QStringLiteral("white")));
        QCOMPARE(*cssColour(QStringLiteral("#0000")), *cssColour(QStringLiteral("transparent")));
        QCOMPARE(*cssColour(QStringLiteral("#ff000080")), (Rgba{1, 0, 0, 128 / 255.0}));
        QCOMPARE(*cssColour(QStringLiteral("rgba(255, 0, 51, 0.5)")), (Rgba{1, 0, 0.2, 0.5}));
        QCOMPARE(*cssColour(QStringLiteral("rgb(100%, 0%,20%)")), (Rgba{1, 0, 0.2, 1})); // as Cairo writes them
        QCOMPARE(*cssColour(QStringLiteral("rgb(255 0 51 / 50%)")), (Rgba{1, 0, 0.2, 0.5}));
        QCOMPARE(*cssColour(QStringLiteral("hsl(360, 100%, 25%)")), (Rgba{0.5, 0, 0, 1}));
        QCOMPARE(*cssColour(QStringLiteral("hsla(-240deg 100% 50% / .5)")), (Rgba{0, 1, 0, 0.5}));
        for (const char *bad :
             {"hsl(1,2)", "hsl(a,1%,1%)", "", "#12", "#12345g", "nocolour", "rgb(1,2)", "rgb", "rgb(a,b,c)", "rgb)"})
            QVERIFY2(!cssColour(QLatin1String(bad)), bad);
    }
};

QTEST_APPLESS_MAIN(TestImports)
#include "test_imports.moc"
