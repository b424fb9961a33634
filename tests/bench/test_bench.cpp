// The measuring code measures what it says: paintings and rows.
#include "model/formats/files.h"
#include "model/painting/validate.h"
#include "render/backends.h"
#include "render/bench/measure.h"
#include "render/bench/plan.h"
#include "tests/bench/small_painting.h"
#include "tests/cli/cli_process.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <map>

using namespace suffuse;

class TestBench : public QObject {
    Q_OBJECT

private slots:
    void generatedPaintingsAreWhatTheySay();
    void table2HasThePapersSizes();
    void repeatedPaintingHasSoManySegments();
    void othersStandAroundTheStroke();
    void medianAndMinimum();
    void rowsAsJson();
    void planTakesEveryRow();
    void commandPrintsRows();
    void commandMeasuresTheBackendAskedFor();
    void commandRefusesWrongUsage_data();
    void commandRefusesWrongUsage();
};

void TestBench::generatedPaintingsAreWhatTheySay()
{
    const Painting painting = bench::makePainting({});
    QCOMPARE(painting.strokes.size(), std::size_t(778));
    QCOMPARE(painting.segmentCount(), std::size_t(17917));
    QCOMPARE(problemOf(painting), QString());
    QCOMPARE(hashOf(bench::makePainting({})), hashOf(painting));
    bench::PaintingOptions other;
    other.seed = 2;
    QVERIFY(hashOf(bench::makePainting(other)) != hashOf(painting));

    std::map<StyleKind, int> kinds;
    for (const StrokePtr &s : painting.strokes) {
        ++kinds[s->style.kind];
        const double spread = s->segments.front().spread(painting.end());
        QVERIFY2(spread > 5.999 && spread < 20.001, qPrintable(QString::number(spread)));
    }
    QVERIFY2(std::abs(kinds[StyleKind::Uniform] - 467) < 60, qPrintable(QString::number(kinds[StyleKind::Uniform])));
    QVERIFY2(std::abs(kinds[StyleKind::Edge] - 124) < 40, qPrintable(QString::number(kinds[StyleKind::Edge])));
}

void TestBench::table2HasThePapersSizes()
{
    QCOMPARE(bench::table2().size(), std::size_t(13));
    int segments = 0;
    for (const bench::Table2Size &size : bench::table2())
        segments += size.segments;
    QCOMPARE(segments, 117836);
    bench::PaintingOptions o;
    o.strokes = 83;
    o.segments = 3780;
    QCOMPARE(bench::makePainting(o).segmentCount(), std::size_t(3780));
}

void TestBench::repeatedPaintingHasSoManySegments()
{
    const Painting painting = bench::makePainting(smallOptions());
    for (std::size_t segments : {1u, 100u, 1001u}) {
        const Painting repeated = bench::repeatedPainting(painting, segments);
        QCOMPARE(repeated.segmentCount(), segments);
        QCOMPARE(problemOf(repeated), QString());
    }
}

void TestBench::othersStandAroundTheStroke()
{
    const Painting painting = bench::makePainting(smallOptions());
    const StrokePtr stroke = bench::middleStroke(painting);
    QVERIFY(stroke);
    const Painting among = bench::amongOthers(painting, stroke, 100);
    QCOMPARE(among.strokes.size(), std::size_t(101));
    QCOMPARE(problemOf(among), QString());
    QCOMPARE(among.indexOf(1), 50);
    QVERIFY(among.strokes[50]->segments == stroke->segments);
    QVERIFY(!bench::middleStroke(Painting{}));
}

void TestBench::medianAndMinimum()
{
    QCOMPARE(bench::timingOf({3, 1, 2}).medianMs, 2.0);
    QCOMPARE(bench::timingOf({3, 1, 2}).minMs, 1.0);
    QCOMPARE(bench::timingOf({4, 1, 2, 3}).medianMs, 2.5);
    QCOMPARE(bench::timingOf({4, 1, 2, 3}).runs, 4);
    QCOMPARE(bench::timingOf({}).runs, 0);
}

void TestBench::rowsAsJson()
{
    bench::Row row;
    row.name = "drag-among-10000";
    row.backend = "CPU";
    row.device = "2 threads · AVX2";
    row.painting = "figure11f";
    row.width = 1024;
    row.height = 768;
    row.threads = 2;
    row.timing = {1.5, 1.25, 30};
    bench::Row compared = row;
    compared.baseline = "drag-among-100";
    compared.ratio = 1.125;
    const QJsonArray array = QJsonDocument::fromJson(bench::toJson({row, compared})).array();
    QCOMPARE(array.size(), 2);
    const QJsonObject object = array.at(0).toObject();
    QCOMPARE(object.keys(), QStringList({"backend", "baseline", "device", "height", "median_ms", "min_ms", "name",
                                         "painting", "ratio", "runs", "threads", "width"}));
    QCOMPARE(object["median_ms"].toDouble(), 1.5);
    QVERIFY(object["baseline"].isNull() && object["ratio"].isNull());
    QCOMPARE(array.at(1)["baseline"].toString(), QString("drag-among-100"));
    QCOMPARE(array.at(1)["ratio"].toDouble(), 1.125);
    const QStringList lines = bench::toTable({row, compared}).split('\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 3);
    QVERIFY(lines.at(2).endsWith("1.13") || lines.at(2).endsWith("1.12"));
}

void TestBench::planTakesEveryRow()
{
    bench::Plan plan;
    plan.make = makeRenderer;
    plan.painting = std::make_shared<const Painting>(bench::makePainting(smallOptions()));
    plan.name = "small";
    plan.devices = {RendererOptions{Backend::Cpu, 0, 0}};
    plan.threads = {1, 2};
    plan.widths = {64, 128};
    plan.growth = {50, 100};
    plan.runs = 1;
    const auto rows = bench::run(plan);
    QVERIFY2(rows, rows ? "" : qPrintable(rows.error()));
    std::map<QString, int> names;
    for (const bench::Row &row : *rows) {
        ++names[row.name];
        QVERIFY2(row.timing.runs > 0 && row.timing.minMs > 0 && row.timing.minMs <= row.timing.medianMs,
                 qPrintable(row.name));
        QVERIFY(row.width == 64 || row.width == 128);
        QCOMPARE(row.height, row.width * 3 / 4);
        QCOMPARE(row.backend, QString("CPU"));
        QVERIFY(!row.device.isEmpty());
    }
    const std::map<QString, int> expected = {{"full-render", 4},
                                             {"cold-render", 4},
                                             {"zoom-render", 4},
                                             {"node-build", 4},
                                             {"binning", 4},
                                             {"open", 1},
                                             {"drag", 1},
                                             {"edit-segment", 1},
                                             {"growth-50", 1},
                                             {"growth-100", 1},
                                             {"live-stroke", 1},
                                             {"drag-among-100", 1},
                                             {"drag-among-10000", 1},
                                             {"live-stroke-2000", 1},
                                             {"drag-in-20-layers", 1},
                                             {"drag-in-20-clipped", 1},
                                             {"layer-opacity", 1}};
    QVERIFY(names == expected);

    plan.only = {"drag"};
    const auto dragOnly = bench::run(plan);
    QVERIFY(dragOnly && dragOnly->size() == 1);
    const std::atomic<bool> cancel{true};
    plan.cancel = &cancel;
    QVERIFY(!bench::run(plan));
}

void TestBench::commandPrintsRows()
{
    QTemporaryDir folder;
    const QString path = folder.filePath("small.suffuse");
    QVERIFY(savePainting(bench::makePainting(smallOptions()), path));
    const CliOutcome json = runCli({"bench", "--json", "--painting", path, "--only", "full-render,drag,growth",
                                    "--segments", "50", "--threads", "1", "--runs", "2", "--size", "64x48"});
    QVERIFY2(json.code == 0, qPrintable(json.text()));
    const QJsonArray rows = QJsonDocument::fromJson(json.out).array();
    QStringList names;
    for (const QJsonValue &row : rows) {
        names.append(row["name"].toString());
        QCOMPARE(row["painting"].toString(), QString("small"));
        QCOMPARE(row["threads"].toInt(), 1);
        QCOMPARE(row["width"].toInt(), 64);
        QVERIFY(row["median_ms"].toDouble() > 0);
    }
    QCOMPARE(names, QStringList({"full-render", "drag", "growth-50"}));
    const CliOutcome table = runCli({"bench", "--painting", path, "--only", "binning", "--runs", "1", "--threads", "1",
                                     "--spread", "6", "20", "--size", "64"});
    QVERIFY2(table.code == 0, qPrintable(table.text()));
    QCOMPARE(table.out.count('\n'), 2);
    QVERIFY(table.out.contains("64×48"));
}

void TestBench::commandMeasuresTheBackendAskedFor()
{
    QTemporaryDir folder;
    const QString path = folder.filePath("small.suffuse");
    QVERIFY(savePainting(bench::makePainting(smallOptions()), path));
    const QStringList arguments{"bench", "--json", "--painting", path,     "--runs",
                                "1",     "--size", "64x48",      "--only", "full-render,drag,edit-segment"};
    for (const auto &[option, name] : {std::pair("cpu", "CPU"), {"cuda", "CUDA"}}) {
        const CliOutcome outcome = runCli(arguments + QStringList{"--backend", option});
        if (outcome.code != 0) { // no device here: said so, and nothing else measured in its place
            QCOMPARE(name, "CUDA");
            QVERIFY2(QString::fromUtf8(outcome.err).contains(name) && outcome.out.isEmpty(),
                     qPrintable(outcome.text()));
            continue;
        }
        const QJsonArray rows = QJsonDocument::fromJson(outcome.out).array();
        QVERIFY(rows.size() >= 3);
        for (const QJsonValue &row : rows) {
            QCOMPARE(row["backend"].toString(), QString(name));
            QVERIFY(!row["device"].toString().isEmpty() && row["median_ms"].toDouble() > 0);
        }
    }
}

void TestBench::commandRefusesWrongUsage_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("named");
    QTest::newRow("a row that is not there") << QStringList{"--only", "nope"} << "full-render";
    QTest::newRow("no threads") << QStringList{"--threads", "0"} << "--threads 0";
    QTest::newRow("half a range") << QStringList{"--spread", "6"} << "--spread 6 20";
    QTest::newRow("a range upside down") << QStringList{"--spread", "20", "6"} << "--spread 6 20";
    QTest::newRow("a backend that is not there") << QStringList{"--backend", "x"} << "reference";
    QTest::newRow("some devices") << QStringList{"--devices", "some"} << "all";
    QTest::newRow("another shape") << QStringList{"--size", "1024x700"} << "1024x768";
    QTest::newRow("a width of words") << QStringList{"--width", "wide"} << "--width wide";
    QTest::newRow("an argument") << QStringList{"more"} << "more";
}

void TestBench::commandRefusesWrongUsage()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, named);
    const CliOutcome outcome = runCli(QStringList{"bench"} + arguments);
    QVERIFY2(outcome.code == 2 && outcome.out.isEmpty(), qPrintable(outcome.text()));
    QVERIFY2(QString::fromUtf8(outcome.err).contains(named), qPrintable(outcome.text()));
}

QTEST_GUILESS_MAIN(TestBench)
#include "test_bench.moc"
