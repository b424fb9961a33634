// Brushes: curves, what they do to a stroke, and their files.
#include "model/brush/stroke_builder.h"
#include "model/formats/brushes/brush_file.h"
#include "model/formats/brushes/mypaint_brush.h"
#include "model/formats/files.h"
#include "model/painting/validate.h"

#include <QDirIterator>
#include <QTemporaryDir>
#include <QTest>

#include <map>
#include <numbers>
#include <set>

using namespace suffuse;

namespace {

/// A wave, written with rising and falling pressure, tilt and pace.
std::vector<PenSample> wave(int count = 150)
{
    std::vector<PenSample> samples;
    Microseconds time = 0;
    for (int i = 0; i <= count; ++i) {
        const double u = double(i) / count;
        time += 6'000 + Microseconds(4'000 * std::sin(9 * u));
        samples.push_back({{40 + 500 * u, 120 + 60 * std::sin(7 * u)},
                           time,
                           float(0.1 + 0.9 * std::sin(std::numbers::pi * u)),
                           float(0.5 + 0.5 * std::cos(5 * u))});
    }
    return samples;
}

std::vector<PenSample> line(double length, int count = 60, float pressure = 1)
{
    std::vector<PenSample> samples;
    for (int i = 0; i <= count; ++i)
        samples.push_back({{100 + length * i / count, 50}, i * 8'000, pressure});
    return samples;
}

Brush plain()
{
    Brush brush;
    brush.dynamics.clear();
    return brush;
}

double spreadOf(const Segment &s)
{
    return std::sqrt(4.0 * s.diffusion * s.maxAge);
}

/// Peak of a long line with the segment's values, for round tips.
double peakOf(const Segment &s)
{
    return s.density / (std::sqrt(std::numbers::pi) * spreadOf(s));
}

} // namespace

class TestBrush : public QObject {
    Q_OBJECT

private slots:
    void curvesAreMonotoneBetweenTheirPoints()
    {
        const ResponseCurve ramp{{{0, 0.35f}, {1, 1}}};
        for (double x : {0.0, 0.25, 0.5, 1.0})
            QVERIFY(std::abs(ramp.at(x) - (0.35 + 0.65 * x)) < 1e-7);
        const ResponseCurve bent{{{0.1f, 0}, {0.3f, 0.05f}, {0.5f, 0.9f}, {0.8f, 1}, {0.9f, 0.2f}}};
        QVERIFY(bent.isValid());
        for (const Offset p : bent.points)
            QVERIFY(std::abs(bent.at(p.x) - double(p.y)) < 1e-7);
        QCOMPARE(bent.at(0), 0.0);
        QCOMPARE(bent.at(1), double(0.2f));
        for (double x = 0; x < 0.8; x += 0.001)
            QVERIFY(bent.at(x + 0.001) >= bent.at(x) - 1e-12);
        for (double x = 0.8; x < 0.9; x += 0.001)
            QVERIFY(bent.at(x + 0.001) <= bent.at(x) + 1e-12);
        QVERIFY(!(ResponseCurve{{{0, 0}}}).isValid());
        QVERIFY(!(ResponseCurve{{{0.5f, 0}, {0.5f, 1}}}).isValid());
        QVERIFY(!(ResponseCurve{{{0, 0}, {1, 1.5f}}}).isValid());
        QVERIFY(!(ResponseCurve{{{0, 0}, {1, std::numeric_limits<float>::quiet_NaN()}}}).isValid());
    }

    void dynamicsMultiply()
    {
        Brush brush = plain();
        brush.colour = {0.5f, 0.5f, 0.5f, 0.8f};
        brush.secondColour = {1, 0, 0.5f, 0.4f};
        brush.setCurve(BrushQuantity::Size, BrushInput::Pressure, {{{0, 0}, {1, 1}}});
        brush.setCurve(BrushQuantity::Size, BrushInput::Tilt, {{{0, 1}, {1, 0.5f}}});
        brush.setCurve(BrushQuantity::Density, BrushInput::Speed, {{{0, 1}, {1, 0}}});
        brush.setCurve(BrushQuantity::ColourMix, BrushInput::Distance, {{{0, 0}, {1, 1}}});
        brush.setCurve(BrushQuantity::MaxAge, BrushInput::Pressure, {{{0, 0.5f}, {1, 1}}});
        QCOMPARE(problemOf(brush), QString());
        const Paint p = paintAt(brush, {0.5, 1, 0.25 * brush.fullSpeed, 0.5 * brush.fullDistance}, 7);
        QVERIFY(std::abs(p.size - 0.25) < 1e-7);
        QVERIFY(std::abs(p.peak - 0.75 * brush.peak) < 1e-6);
        QVERIFY(std::abs(p.maxAge - 0.75 * brush.maxAge) < 1e-6);
        QCOMPARE(p.colour, (Colour{0.75f, 0.25f, 0.5f, 0.6f}));
        QCOMPARE(p.granulation, double(brush.granulation));
        // Without pressure, size stops short of nothing.
        QCOMPARE(paintAt(brush, {0, 0, 0, 0}, 7).size, leastSize);
        brush.removeCurve(BrushQuantity::Size, BrushInput::Pressure);
        QVERIFY(!brush.curve(BrushQuantity::Size, BrushInput::Pressure));
        QVERIFY(brush.curve(BrushQuantity::Size, BrushInput::Tilt));
    }

    void sizeKeepsThePeak()
    {
        Brush brush = plain();
        brush.setCurve(BrushQuantity::Size, BrushInput::Pressure, {{{0, 0}, {1, 1}}});
        const StrokePtr whole = buildStroke(brush, 1, line(400)), half = buildStroke(brush, 1, line(400, 60, 0.5f));
        QCOMPARE(whole->segments[0].diffusion, brush.diffusion);
        QVERIFY(std::abs(half->segments[0].diffusion - 0.25f * brush.diffusion) < 1e-6);
        QVERIFY(std::abs(peakOf(half->segments[0]) - brush.peak) < 1e-6);
        brush.setSpread(30);
        QVERIFY(std::abs(brush.spread() - 30) < 1e-5);
    }

    void randomBelongsToTheStroke()
    {
        Brush brush = plain();
        brush.setCurve(BrushQuantity::Size, BrushInput::StrokeRandom, {{{0, 0.1f}, {1, 1}}});
        brush.setCurve(BrushQuantity::Density, BrushInput::Drift, {{{0, 0}, {1, 1}}});
        brush.jitter = {0.2f, 0.2f, 0.2f, 0.1f, true};
        std::set<double> sizes;
        double sum = 0;
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            const Paint a = paintAt(brush, {1, 0, 0, 3}, seed), b = paintAt(brush, {1, 0, 0, 3}, seed);
            QCOMPARE(a.size, b.size);
            QCOMPARE(a.colour, b.colour);
            QCOMPARE(paintAt(brush, {1, 0, 0, 90}, seed).size, a.size); // one value a stroke
            sizes.insert(a.size);
            sum += a.size;
        }
        QVERIFY(sizes.size() > 190);
        QVERIFY(std::abs(sum / 200 - 0.55) < 0.06); // the mean of what is uniform in [0.1, 1]
        // Drift is smooth, and comes near both ends.
        double least = 1e9, greatest = 0;
        for (double d = 0; d < 400; d += 0.01) {
            const double here = paintAt(brush, {1, 0, 0, d}, 5).peak,
                         next = paintAt(brush, {1, 0, 0, d + 0.01}, 5).peak;
            QVERIFY(std::abs(next - here) < 0.006 * brush.peak);
            least = std::min(least, here);
            greatest = std::max(greatest, here);
        }
        QVERIFY(least < 0.1 * brush.peak && greatest > 0.9 * brush.peak);
        QVERIFY(buildStroke(brush, 4, wave())->segments != buildStroke(brush, 5, wave())->segments);
    }

    void strokesTaper()
    {
        Brush brush = plain();
        brush.taper = {2, 3, 0.1f};
        const double s = brush.spread();
        const StrokePtr stroke = buildStroke(brush, 1, line(20 * s));
        QCOMPARE(problemOf(*stroke), QString());
        double distance = 0;
        for (const Segment &g : stroke->segments) {
            const double l = arcLength(stroke->cubicOf(g)), middle = (distance + 0.5 * l) / s;
            const double wanted = taperAt(brush.taper, middle, 20 - middle);
            QVERIFY2(std::abs(spreadOf(g) / s - wanted) < 0.02, qPrintable(QString::number(middle)));
            QVERIFY(std::abs(peakOf(g) - brush.peak) < 1e-5); // thinner, not fainter
            distance += l;
        }
        QVERIFY(std::abs(spreadOf(stroke->segments.front()) / s - 0.1) < 0.05);
        QVERIFY(std::abs(spreadOf(stroke->segments.back()) / s - 0.1) < 0.05);
        QCOMPARE(taperAt(brush.taper, 2, 3), 1.0);
        QCOMPARE(taperAt(brush.taper, 0, 20), double(0.1f));
        // A tap is a whole dot, and a stroke that grows out of it does not jump.
        const StrokePtr dot = buildStroke(brush, 1, line(0.09 * s, 3)), dash = buildStroke(brush, 1, line(0.11 * s, 3));
        QVERIFY(std::abs(spreadOf(dot->segments[0]) - s) < 1e-5);
        for (const Segment &g : dash->segments)
            QVERIFY(spreadOf(g) > 0.9 * s);
    }

    void tipsTurnWithThePathOrStandStill()
    {
        Brush brush = plain();
        brush.tip = {9, 0, false};
        const double s = brush.spread();
        std::vector<PenSample> down = line(300);
        for (PenSample &p : down)
            p.position = {50, p.position.x};
        const Segment across = buildStroke(brush, 1, line(300))->segments[3];
        const Segment along = buildStroke(brush, 1, down)->segments[3];
        QCOMPARE(across.anisotropyRatio, 9.0f);
        QCOMPARE(across.anisotropyAngle, along.anisotropyAngle);
        // The wide axis lies along x: a vertical line is three times as broad, with the same peak.
        QVERIFY(std::abs(across.density / (std::sqrt(std::numbers::pi) * s) - brush.peak) < 1e-5);
        QVERIFY(std::abs(along.density / (std::sqrt(std::numbers::pi) * 3 * s) - brush.peak) < 1e-5);
        brush.tip.followsPath = true;
        const Segment turned = buildStroke(brush, 1, down)->segments[3];
        QVERIFY(std::abs(turned.anisotropyAngle - std::numbers::pi / 2) < 1e-3);
        QVERIFY(std::abs(turned.density / (std::sqrt(std::numbers::pi) * s) - brush.peak) < 1e-5);
    }

    void theIntervalIsTheBrushs()
    {
        Brush brush = plain();
        brush.interval = 50'000;
        QCOMPARE(buildStroke(brush, 1, line(400, 50))->segments.size(), std::size_t(8)); // 0.4 s
    }

    void builtinBrushesAreSound()
    {
        std::set<QString> names, groups;
        for (const Brush &b : builtinBrushes()) {
            QVERIFY2(problemOf(b).isEmpty(), qPrintable(b.name + ": " + problemOf(b)));
            QVERIFY(names.insert(b.name).second);
            groups.insert(b.group);
            const StrokePtr stroke = buildStroke(b, 1, wave());
            QVERIFY2(problemOf(*stroke).isEmpty(), qPrintable(b.name));
            QCOMPARE(stroke->brush, b.name);
            QVERIFY2(stroke->segments.size() < 1200, qPrintable(b.name));
        }
        QVERIFY(names.size() >= 16);
        QCOMPARE(groups, (std::set<QString>{"ink", "watercolour", "dry", "flat", "air"}));
    }

    void whatIsFrozenStays()
    {
        for (const Brush &brush : builtinBrushes()) {
            StrokeBuilder builder(brush, 9);
            std::vector<Segment> frozen;
            for (const PenSample &s : wave()) {
                builder.add(s);
                const StrokePtr stroke = builder.stroke();
                QVERIFY(builder.frozenSegments() >= int(frozen.size()));
                QVERIFY2(std::equal(frozen.begin(), frozen.end(), stroke->segments.begin()), qPrintable(brush.name));
                frozen.assign(stroke->segments.begin(), stroke->segments.begin() + builder.frozenSegments());
            }
            QVERIFY2(!frozen.empty(), qPrintable(brush.name));
            builder.finish();
            QVERIFY(std::equal(frozen.begin(), frozen.end(), builder.stroke()->segments.begin()));
            QCOMPARE(*builder.stroke(), *buildStroke(brush, 9, wave()));
        }
    }

    void filesHoldEverything()
    {
        for (Brush brush : builtinBrushes()) {
            brush.name += QStringLiteral(" “é”\n");
            brush.interval = 12'345;
            const QByteArray bytes = writeBrush(brush);
            const Result<Brush> read = readBrush(bytes, "a.suffuse-brush");
            QVERIFY2(read, qPrintable(read.error()));
            QCOMPARE(*read, brush);
            QCOMPARE(writeBrush(*read), bytes);
        }
    }

    void badFilesAreRefused_data()
    {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QString>("says");
        const auto row = [](const char *name, const char *from, const char *to, const char *says) {
            QTest::newRow(name) << QByteArray(from) << QByteArray(to) << QString::fromUtf8(says);
        };
        row("format", "suffuse-brush\"", "suffuse-brash\"", "format");
        row("version", "\"version\": 1", "\"version\": 2", "version: 2 is not a version");
        row("member", "\"peak\"", "\"peek\"", "peek: is not a member");
        row("domain", "\"ratio\": 1", "\"ratio\": 0", "tip.ratio: 0 is not in");
        row("quantity", "\"quantity\": \"density\"", "\"quantity\": \"desnity\"",
            "dynamics[0].quantity: “desnity” is none of");
        row("curve", "[1, 1]", "[0, 1]", "dynamics[0].curve: needs 2 to 16 points");
        row("infinite", "\"in\": 0", "\"in\": 1e99", "taper.in: 1e99 is too large");
        row("colour", "\"second\": [0", "\"second\": [7", "second[0]: 7 is not in [0, 1]");
    }

    void badFilesAreRefused()
    {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(QString, says);
        QByteArray bytes = writeBrush(Brush{});
        QVERIFY(bytes.contains(from));
        bytes.replace(bytes.indexOf(from), from.size(), to);
        const Result<Brush> read = readBrush(bytes, "a.suffuse-brush");
        QVERIFY(!read);
        QVERIFY2(read.error().startsWith("a.suffuse-brush: ") && read.error().contains(says), qPrintable(read.error()));
    }

    void cutOffFilesAreRefused()
    {
        const QByteArray bytes = writeBrush(builtinBrushes()[1]);
        for (qsizetype n = 0; n + 2 < bytes.size(); ++n)
            QVERIFY(!readBrush(bytes.first(n), "a.suffuse-brush"));
    }

    void myPaintBrushesComeIn()
    {
        const QByteArray myb = R"({"comment": "MyPaint brush file", "group": "set#2", "version": 3, "settings": {
            "radius_logarithmic": {"base_value": 2.0, "inputs": {"pressure": [[0, -1], [1, 0.5]], "speed1": [[0, 0], [4, -0.5]]}},
            "hardness": {"base_value": 0.9, "inputs": {}},
            "opaque": {"base_value": 0.8, "inputs": {}},
            "opaque_multiply": {"base_value": 0, "inputs": {"pressure": [[0, 0], [0.5, 0.5], [1, 1]]}},
            "color_h": {"base_value": 0, "inputs": {}}, "color_s": {"base_value": 1, "inputs": {}},
            "color_v": {"base_value": 1, "inputs": {}},
            "elliptical_dab_ratio": {"base_value": 3, "inputs": {}},
            "elliptical_dab_angle": {"base_value": 45, "inputs": {}},
            "slow_tracking": {"base_value": 5, "inputs": {}},
            "smudge": {"base_value": 0.4, "inputs": {}},
            "offset_by_random": {"base_value": 0, "inputs": {"ascension": [[0, 0], [1, 1]]}},
            "dabs_per_second": {"base_value": 80, "inputs": {}}}})";
        QTemporaryDir folder;
        QVERIFY(writeFileAtomically(folder.filePath("Ink Pen.myb"), myb));
        Result<LoadedBrush> loaded = loadBrush(folder.filePath("Ink Pen.myb"));
        QVERIFY2(loaded, qPrintable(loaded.error()));
        const Brush &b = loaded->brush;
        QCOMPARE(problemOf(b), QString());
        QCOMPARE(b.name, QString("Ink Pen"));
        QCOMPARE(b.group, QString("set#2"));
        // e^2.5 wide at full pressure; a third of it across the ellipse.
        const double half = b.spread() * std::sqrt(std::log(b.peak / b.style.xi[0])) * std::sqrt(double(b.tip.ratio));
        QVERIFY2(std::abs(half - std::exp(2.5)) < 0.01, qPrintable(QString::number(half)));
        QCOMPARE(b.tip.ratio, 9.0f);
        QVERIFY(!b.tip.followsPath);
        const ResponseCurve *size = b.curve(BrushQuantity::Size, BrushInput::Pressure);
        QVERIFY(size && std::abs(size->at(0) - std::exp(-1.5)) < 1e-6 && size->at(1) == 1);
        QVERIFY(b.curve(BrushQuantity::Size, BrushInput::Speed));
        QVERIFY(std::abs(b.curve(BrushQuantity::Opacity, BrushInput::Pressure)->at(0.25) - 0.25) < 1e-6);
        QVERIFY(std::abs(b.colour.opacity - 0.8f) < 1e-6);
        QCOMPARE(b.colour.red, 1.0f);
        QCOMPARE(b.colour.blue, 0.0f);
        QCOMPARE(b.stabiliser.kind, Stabiliser::Kind::Weighted);
        QCOMPARE(loaded->left, (QStringList{"offset_by_random", "smudge"}));
        QVERIFY(!readMyPaintBrush("{\"settings\": {}, \"base_value\": 1}", "a.myb"));
        QVERIFY(!readMyPaintBrush("{\"settings\": {\"base_value\":", "a.myb"));
    }

    /// SUFFUSE_MYPAINT_BRUSHES names a folder of them, as MyPaint's own (/usr/share/mypaint-data).
    void brushesOfMyPaint()
    {
        const QString folder = qEnvironmentVariable("SUFFUSE_MYPAINT_BRUSHES");
        if (folder.isEmpty())
            QSKIP("SUFFUSE_MYPAINT_BRUSHES is not set");
        int read = 0, whole = 0, invisible = 0;
        std::map<QString, int> left;
        QStringList unread;
        for (QDirIterator it(folder, {"*.myb"}, QDir::Files, QDirIterator::Subdirectories); it.hasNext();) {
            const QString path = it.next();
            const Result<LoadedBrush> loaded = loadBrush(path);
            if (!loaded) {
                unread << loaded.error();
                continue;
            }
            ++read;
            const StrokePtr stroke = buildStroke(loaded->brush, 1, wave());
            QVERIFY2(stroke && problemOf(*stroke).isEmpty(), qPrintable(path));
            const bool seen =
                std::ranges::any_of(stroke->segments, [](const Segment &s) { return s.colour.opacity > 0.01f; });
            if (!seen)
                qInfo("nothing is seen of %s, left: %s", qPrintable(path), qPrintable(loaded->left.join(", ")));
            invisible += !seen;
            whole += loaded->left.isEmpty();
            for (const QString &name : loaded->left)
                ++left[name];
        }
        qInfo("%d read, %d of them whole; nothing is seen of %d", read, whole, invisible);
        for (const auto &[name, count] : left)
            qInfo("%4d  %s", count, qUtf8Printable(name));
        QVERIFY2(unread.isEmpty(), qPrintable(unread.join('\n')));
        QVERIFY(read > 0);
    }

    void fileOfAnotherKind()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("a.suffuse-brush");
        QVERIFY(!loadBrush(path));
        Brush brush = builtinBrushes()[2];
        brush.name.clear();
        QVERIFY(writeFileAtomically(path, writeBrush(brush)));
        Result<LoadedBrush> loaded = loadBrush(path);
        QVERIFY2(loaded, qPrintable(loaded.error()));
        QCOMPARE(loaded->brush.name, QString("a")); // after the file
        QVERIFY(writeFileAtomically(path, QByteArray(2 << 20, ' ')));
        QVERIFY(loadBrush(path).error().contains("1 MB"));
    }
    /// What the brushes that come along must not do: stray from their hue, end in points where they are called a wash,
    /// or lose their dark edge to the paper.
    void presetsKeepWhatTheirNamesSay()
    {
        for (const Brush &brush : builtinBrushes()) {
            const auto &jitter = brush.jitter;
            const float most = std::max({jitter.red, jitter.yellow, jitter.blue, jitter.lightness});
            QVERIFY2(most <= 0.06f, qPrintable(brush.name));
            const bool isBlunt = brush.taper.in == 0 && brush.taper.out == 0;
            if (brush.name.contains("wash"))
                QVERIFY2(isBlunt || brush.taper.tip >= 0.4f, qPrintable(brush.name));
        }
        // The edge is where the density, which the paper's hollows lessen, has fallen to ξ1.
        const Brush &edge = *findBrush("watercolour-edge");
        const auto edgeAt = [&](double grain) {
            const double density = edge.peak * (edge.granulation + (1 - edge.granulation) * grain);
            return std::sqrt(std::log(density / double(edge.style.xi[0])));
        };
        constexpr double hollow = 0.55;
        QVERIFY2(edgeAt(1) - edgeAt(hollow) < 0.08, qPrintable(QString::number(edgeAt(1) - edgeAt(hollow))));
    }
};

QTEST_GUILESS_MAIN(TestBrush)
#include "test_brush.moc"
