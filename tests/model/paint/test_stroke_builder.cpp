// Pen samples to strokes.
#include "model/brush/brush_width.h"
#include "model/brush/spline_fit.h"
#include "model/brush/stroke_builder.h"
#include "model/paint/half_width.h"
#include "model/painting/validate.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <numbers>

using namespace suffuse;

namespace {

const QString dataFolder = QStringLiteral(SUFFUSE_SOURCE_DIR "/../shared/data/");

/// Density of a straight segment at its middle (closed form).
double middleDensity(double density, double length, double spread)
{
    return density / (std::sqrt(std::numbers::pi) * spread) * std::erf(length / (2 * spread));
}

std::vector<PenSample> line(double length, int samples, double interval = 0.008, float pressure = 1)
{
    std::vector<PenSample> result;
    for (int i = 0; i < samples; ++i)
        result.push_back({{100 + length * i / (samples - 1), 50}, toMicroseconds(1 + i * interval), pressure});
    return result;
}

/// φˢ of a long line of the brush at this pressure.
double densityFor(const Brush &brush, double pressure)
{
    Segment segment;
    setPaint(segment, brush, paintAt(brush, {pressure}, 1), {1, 0});
    return segment.density;
}

/// A brush whose density at no pressure is this share of the full one.
Brush brushWithFloor(float floor)
{
    Brush brush;
    brush.setCurve(BrushQuantity::Density, BrushInput::Pressure, {{{0, floor}, {1, 1}}});
    return brush;
}

double lengthOf(const Stroke &stroke)
{
    double sum = 0;
    for (const Segment &s : stroke.segments)
        sum += arcLength(stroke.cubicOf(s));
    return sum;
}

/// Distance of a point from a stroke, sampled finely.
double distanceTo(const Stroke &stroke, Point p)
{
    double best = std::numeric_limits<double>::infinity();
    for (const Segment &s : stroke.segments)
        for (int i = 0; i <= 64; ++i)
            best = std::min(best, length(stroke.cubicOf(s).at(i / 64.0) - p));
    return best;
}

/// The recording's strokes: pen-down samples.
std::vector<std::vector<PenSample>> recordedStrokes()
{
    QFile file(dataFolder + QStringLiteral("painting30sec.dat"));
    std::vector<std::vector<PenSample>> strokes;
    if (!file.open(QIODevice::ReadOnly))
        return strokes;
    bool down = false;
    while (!file.atEnd()) {
        const QList<QByteArray> columns = file.readLine().simplified().split(' ');
        if (columns.size() < 4)
            continue;
        const PenSample s{{columns[1].toDouble(), columns[2].toDouble()},
                          toMicroseconds(columns[0].toDouble()),
                          columns[3].toFloat()};
        if (s.pressure > 0 && !down)
            strokes.emplace_back();
        down = s.pressure > 0;
        if (down)
            strokes.back().push_back(s);
    }
    return strokes;
}

} // namespace

class TestStrokeBuilder : public QObject {
    Q_OBJECT

private slots:
    void splineReproducesCubics()
    {
        // The natural spline through samples of x(t) with x″ = 0 at both ends is x itself.
        Eigen::VectorXd times(5);
        times << 0, 0.3, 0.5, 0.8, 1;
        Eigen::MatrixXd values(5, 2);
        for (int i = 0; i < 5; ++i) {
            const double t = times[i];
            values(i, 0) = 3 * t - 2;
            values(i, 1) = -7 * t + 1;
        }
        const Eigen::MatrixXd straight = splineDerivatives(times, values);
        QVERIFY((straight.col(0).array() - 3).abs().maxCoeff() < 1e-12);
        QVERIFY((straight.col(1).array() + 7).abs().maxCoeff() < 1e-12);

        // Clamped at the start and with x″(end) = 0: x = t³ − 3t² + t has x″ = 6t − 6.
        for (int i = 0; i < 5; ++i)
            values(i, 0) = values(i, 1) = std::pow(times[i], 3) - 3 * times[i] * times[i] + times[i];
        const Eigen::MatrixXd cubic = splineDerivatives(times, values, Eigen::RowVectorXd::Ones(2));
        for (int i = 0; i < 5; ++i)
            QVERIFY(std::abs(cubic(i, 1) - (3 * times[i] * times[i] - 6 * times[i] + 1)) < 1e-12);
    }

    void secondDerivativesMeet()
    {
        Eigen::VectorXd t(4);
        t << 0, 1, 1.5, 4;
        Eigen::MatrixXd v(4, 1);
        v << 0, 5, -2, 3;
        const Eigen::MatrixXd d = splineDerivatives(t, v);
        const auto second = [&](int i, bool end) {
            const double h = t[i + 1] - t[i], slope = (v(i + 1, 0) - v(i, 0)) / h;
            return end ? (4 * d(i + 1, 0) + 2 * d(i, 0) - 6 * slope) / h
                       : (6 * slope - 4 * d(i, 0) - 2 * d(i + 1, 0)) / h;
        };
        QVERIFY(std::abs(second(0, false)) < 1e-12 && std::abs(second(2, true)) < 1e-12);
        QVERIFY(std::abs(second(0, true) - second(1, false)) < 1e-9);
        QVERIFY(std::abs(second(1, true) - second(2, false)) < 1e-9);
    }

    void brushesMakeSense()
    {
        QCOMPARE(builtinBrushes().front().name, QStringLiteral("ink-wash"));
        for (const char *name :
             {"ink-wash", "watercolour-edge", "soft-airbrush", "flat-marker", "dry-chalk", "pencil"}) {
            const Brush *b = findBrush(QString::fromLatin1(name));
            QVERIFY2(b, name);
            QVERIFY2(problemOf(*buildStroke(*b, 1, line(100, 30))).isEmpty(), name);
            // Wide enough to be seen, and not wider than its spread allows: w = s√ln(pk/ξ1) (solver: useful inverses).
            if (b->style.kind == StyleKind::Feathering)
                continue;
            for (double pressure : {0.3, 1.0}) {
                const double pk = densityFor(*b, pressure) / (std::sqrt(std::numbers::pi) * b->spread());
                if (pk <= b->style.xi[0])
                    continue;
                const double halfWidth = b->spread() * std::sqrt(std::log(pk / b->style.xi[0]));
                QVERIFY2(halfWidth > 0.2 * b->spread() && halfWidth < 2 * b->spread(), name);
            }
            QVERIFY2(b->peak > b->style.xi[0], name);
        }
        QVERIFY(!findBrush(QStringLiteral("no such brush")));
        const Brush plain;
        QVERIFY(std::abs(plain.spread() * std::sqrt(std::log(plain.peak / plain.style.xi[0])) - 6.6) < 0.1);
    }

    void aTapIsADotWithThePeakOfALine()
    {
        for (const Brush &brush : builtinBrushes()) {
            const Paint paint = paintAt(brush, {1}, 3);
            const double s = spreadOf(brush, paint.size, paint.maxAge);
            const StrokePtr dot = buildStroke(brush, 3, {{{464.91, 286.51}, 5000, 1}});
            QCOMPARE(problemOf(*dot), QString());
            QCOMPARE(dot->segments.size(), std::size_t(1));
            const Cubic c = dot->cubicOf(dot->segments[0]);
            QVERIFY(std::abs(c.p[3].x - c.p[0].x - 0.1 * s) < 1e-5 * s);
            QVERIFY(length(c.at(0.5) - Point{464.91, 286.51}) < 1e-5 * s);
            const double across = spreadAcross(brush.tip, s, {1, 0});
            QVERIFY(std::abs(middleDensity(dot->segments[0].density * s / across, 0.1 * s, s) - paint.peak) < 1e-5);
            QCOMPARE(dot->segments[0].born, Microseconds(5000));
        }
        // A tap that trembles, and light pressure.
        const Brush brush = brushWithFloor(0.5f);
        const StrokePtr light =
            buildStroke(brush, 1, {{{0, 0}, 0, 0.2f}, {{0.1, 0.1}, 9000, 0.4f}, {{0, 0.1}, 20000, 0.1f}});
        QCOMPARE(light->segments.size(), std::size_t(1));
        QVERIFY(std::abs(middleDensity(light->segments[0].density, 0.1 * brush.spread(), brush.spread()) - 1.2 * 0.7) <
                1e-5);
        QVERIFY(!buildStroke(brush, 1, {}));
    }

    void shortStrokesAreRaised()
    {
        Brush brush;
        const double s = brush.spread();
        for (double inSpreads : {0.2, 0.7, 1.5, 1.99}) {
            const StrokePtr stroke = buildStroke(brush, 1, line(inSpreads * s, 20));
            for (const Segment &g : stroke->segments)
                QVERIFY(std::abs(middleDensity(g.density, inSpreads * s, s) - brush.peak) < 1e-4);
        }
        const StrokePtr lengthy = buildStroke(brush, 1, line(2.01 * s, 20));
        for (const Segment &g : lengthy->segments)
            QVERIFY(std::abs(g.density - brush.peak * std::sqrt(std::numbers::pi) * s) < 1e-4);
    }

    void aSteadyLineStaysWhole()
    {
        const Brush brush; // no pressure variation: no splits
        const auto samples = line(400, 51);
        const StrokePtr stroke = buildStroke(brush, 1, samples);
        QCOMPARE(problemOf(*stroke), QString());
        QCOMPARE(stroke->segments.size(), std::size_t(25)); // 0.4 s in sixtieths, rounded up
        QVERIFY(std::abs(lengthOf(*stroke) - 400) < 1e-3);
        for (const Segment &g : stroke->segments)
            QVERIFY(std::abs(stroke->cubicOf(g).p[1].y - 50) < 1e-6);
        QVERIFY(length(stroke->cubicOf(stroke->segments.front()).p[0] - samples.front().position) < 1e-5);
        QVERIFY(length(stroke->cubicOf(stroke->segments.back()).p[3] - samples.back().position) < 1e-4);
        for (std::size_t k = 0; k < stroke->segments.size(); ++k)
            QCOMPARE(stroke->segments[k].born, Microseconds(1'000'000 + Microseconds(k) * samplingInterval));
    }

    void varyingPressureIsSplitFinely()
    {
        const Brush brush = brushWithFloor(0);
        auto samples = line(600, 61);
        for (std::size_t i = 0; i < samples.size(); ++i)
            samples[i].pressure = 0.2f + 0.8f * float(i) / 60;
        const StrokePtr stroke = buildStroke(brush, 1, samples);
        QCOMPARE(problemOf(*stroke), QString());
        const double full = densityFor(brush, 1);
        for (std::size_t k = 0; k < stroke->segments.size(); ++k) {
            const Segment &g = stroke->segments[k];
            QVERIFY(arcLength(stroke->cubicOf(g)) <= 0.5 * brush.spread() + 1e-3);
            // The attribute is the spline's at the middle: density is linear in x here.
            const double share = 0.2 + 0.8 * (stroke->cubicOf(g).at(0.5).x - 100) / 600;
            QVERIFY(std::abs(g.density / full - share) < 0.004);
            if (k > 0)
                QVERIFY(g.born >= stroke->segments[k - 1].born);
        }
    }

    void awkwardInputs()
    {
        QFile file(dataFolder + QStringLiteral("awkward_inputs.json"));
        if (!file.open(QIODevice::ReadOnly))
            QSKIP("../shared/data/awkward_inputs.json is not here");
        const QJsonObject all = QJsonDocument::fromJson(file.readAll()).object();
        QVERIFY(!all.isEmpty());
        const Brush brush;
        for (auto it = all.begin(); it != all.end(); ++it) {
            std::vector<Point> points;
            for (const auto &value : it.value().toArray())
                points.push_back(value.isArray() ? Point{value[0].toDouble(), value[1].toDouble()}
                                                 : Point{value[QStringLiteral("x")].toDouble(),
                                                         value[QStringLiteral("y")].toDouble()});
            if (points.empty())
                continue;
            for (Microseconds step : {0, 1, 8'000, 40'000, 5'000'000}) {
                std::vector<PenSample> samples;
                for (const Point &p : points)
                    samples.push_back({p, Microseconds(samples.size()) * step, 0.5f});
                const StrokePtr stroke = buildStroke(brush, 1, samples);
                QVERIFY2(stroke, qPrintable(it.key()));
                QCOMPARE(problemOf(*stroke), QString());
                Rect box;
                for (const Point &p : points)
                    box.include(p);
                if (box.width() + box.height() < 0.1 * brush.spread()) {
                    QCOMPARE(stroke->segments.size(), std::size_t(1));
                } else if (step == 0 || step >= samplingInterval) {
                    // Simultaneous and sparse samples are all passed.
                    for (const Point &p : points)
                        QVERIFY2(distanceTo(*stroke, p) < 0.02 * (box.width() + box.height()), qPrintable(it.key()));
                }
                for (const Segment &g : stroke->segments)
                    QVERIFY2(stroke->cubicOf(g).controlBox().intersects(box.grown(box.width() + box.height() + 1)),
                             qPrintable(it.key()));
            }
        }
    }

    void hostileSamples()
    {
        const Brush brush;
        constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
        QVERIFY(!buildStroke(brush, 1, {{{nan, 0}, 0, 1}, {{0, inf}, 0, 1}, {{1e300, 0}, 0, 1}}));
        const StrokePtr clean = buildStroke(brush, 1, line(50, 10));
        auto dirty = line(50, 10);
        dirty.insert(dirty.begin() + 4, PenSample{{nan, 3}, 0, 1});
        dirty.insert(dirty.begin() + 7, PenSample{{3, 3}, 0, std::numeric_limits<float>::quiet_NaN()});
        dirty.insert(dirty.begin() + 2, 3, dirty[1]); // duplicates
        QCOMPARE(*buildStroke(brush, 1, dirty), *clean);

        for (double size : {1e-9, 1e-3, 1e6, 3e11}) {
            const Brush b = brushWithFloor(0);
            std::vector<PenSample> wild;
            for (int i = 0; i < 60; ++i)
                wild.push_back({{size * std::sin(i * 1.7), size * std::cos(i * 2.9)},
                                Microseconds(i % 7) * (i % 5 == 0 ? -1'000'000'000'000 : 9'000),
                                float(i % 11) / 10});
            const StrokePtr stroke = buildStroke(b, 1, wild);
            QVERIFY(stroke);
            QCOMPARE(problemOf(*stroke), QString());
        }
        const StrokePtr late = buildStroke(brush, 1,
                                           {{{0, 0}, std::numeric_limits<Microseconds>::min(), 1},
                                            {{50, 0}, std::numeric_limits<Microseconds>::max(), 1}});
        QCOMPARE(problemOf(*late), QString());
    }

    void zeroPressure()
    {
        const Brush brush;
        // A blip in a stroke is dropped, at its start too.
        auto blip = line(200, 40);
        blip[0].pressure = blip[20].pressure = blip[21].pressure = 0;
        const StrokePtr stroke = buildStroke(brush, 1, blip);
        for (const Segment &g : stroke->segments)
            QCOMPARE(g.density, stroke->segments[0].density);
        QVERIFY(length(stroke->cubicOf(stroke->segments[0]).p[0] - blip[1].position) < 1e-5);
        // A device without pressure paints at full pressure, long strokes and short ones.
        for (int samples : {5, 31, 32, 33, 200})
            QCOMPARE(*buildStroke(brush, 1, line(200, samples, 0.008, 0)), *buildStroke(brush, 1, line(200, samples)));
    }

    void pausesAndJumps()
    {
        const Brush brush;
        auto samples = line(100, 26);
        for (std::size_t i = 13; i < samples.size(); ++i)
            samples[i].time += 30'000'000; // the pen stands still for half a minute, without a report
        const StrokePtr stroke = buildStroke(brush, 1, samples);
        QVERIFY(stroke->segments.size() < 20);
        QVERIFY(std::abs(lengthOf(*stroke) - 100) < 1);
        QVERIFY(stroke->segments.back().born > 31'000'000);
        for (const Segment &g : stroke->segments) {
            const bool beforePause = g.bezier[3].x + stroke->origin.x <= 148.1;
            QVERIFY(beforePause ? g.born < 1'200'000 : g.born > 30'500'000);
        }
        // A jump of the pointer: the pieces beside it stay where the pen was.
        auto jump = line(40, 11);
        for (std::size_t i = 6; i < jump.size(); ++i)
            jump[i].position.x += 2000;
        const StrokePtr leap = buildStroke(brush, 1, jump);
        Rect box;
        for (const Segment &g : leap->segments)
            box = box.united(leap->cubicOf(g).controlBox());
        QVERIFY(box.left > 60 && box.right < 2180);
    }

    void frozenSegmentsStay()
    {
        const auto strokes = recordedStrokes();
        if (strokes.empty())
            QSKIP("../shared/data/painting30sec.dat is not here");
        int frozenInAll = 0, samplesInAll = 0;
        std::vector<double> distances;
        for (const auto &samples : strokes) {
            StrokeBuilder builder(*findBrush(QStringLiteral("ink-wash")), 1);
            std::vector<Segment> frozen;
            for (const PenSample &s : samples) {
                builder.add(s);
                const StrokePtr stroke = builder.stroke();
                QCOMPARE(problemOf(*stroke), QString());
                QVERIFY(builder.frozenSegments() >= int(frozen.size()));
                QVERIFY(std::equal(frozen.begin(), frozen.end(), stroke->segments.begin()));
                frozen.assign(stroke->segments.begin(), stroke->segments.begin() + builder.frozenSegments());
            }
            builder.finish();
            const StrokePtr whole = builder.stroke();
            QVERIFY(std::equal(frozen.begin(), frozen.end(), whole->segments.begin()));
            QCOMPARE(builder.frozenSegments(), int(whole->segments.size()));
            QCOMPARE(*whole, *buildStroke(*findBrush(QStringLiteral("ink-wash")), 1, samples));
            frozenInAll += int(frozen.size());
            samplesInAll += int(samples.size());
            for (const PenSample &s : samples)
                distances.push_back(distanceTo(*whole, s.position));
        }
        QVERIFY(frozenInAll > samplesInAll / 4);
        // It follows the pen: only where the pen turns within a sixtieth of a second is a corner cut.
        std::sort(distances.begin(), distances.end());
        QVERIFY2(distances.back() < 5, qPrintable(QString::number(distances.back())));
        const double usual = distances[distances.size() * 9 / 10];
        QVERIFY2(usual < 0.5, qPrintable(QString::number(usual)));
    }

    /// What is said of a brush beforehand is what it paints.
    void widthsArePainted()
    {
        for (const char *name : {"round-wash", "gouache", "pen", "dry-brush", "flat-wash"}) {
            const Brush *found = findBrush(name);
            if (!found)
                continue;
            Brush brush = *found;
            brush.setSpread(20);
            brush.taper = {};
            brush.tip = {};
            for (const double speed : {0.0, 20.0, 60.0}) { // spreads a second
                constexpr int samples = 200;
                constexpr double interval = 0.008;
                const double length = std::max(speed, 1.0) * 20 * samples * interval;
                const StrokePtr stroke = buildStroke(brush, 1, line(length, samples, interval));
                double sum = 0, least = 1e9, most = 0;
                for (const Segment &s : stroke->segments) {
                    const double half = halfWidth(double(s.diffusion), double(s.density), double(s.maxAge),
                                                  visibleCut(stroke->style));
                    sum += half, least = std::min(least, half), most = std::max(most, half);
                }
                const double mean = sum / double(stroke->segments.size());
                const double said = halfWidthOf(brush, {.speed = std::max(speed, 1.0)});
                QVERIFY2(std::abs(said - mean) < 0.25 * mean + (most - least),
                         qPrintable(QStringLiteral("%1 at %2: %3, painted %4").arg(name).arg(speed).arg(said).arg(mean)));
            }
        }
        const Brush &first = firstBrush();
        QVERIFY(halfWidthOf(first, {.speed = 0.5 * double(first.fullSpeed)}) < 0.8 * halfWidthOf(first));
        QCOMPARE(halfWidthOf(first, {}), halfWidthOf(first));
        Brush random = first;
        random.setCurve(BrushQuantity::Size, BrushInput::StrokeRandom, {{{0, 0.2f}, {1, 1}}});
        QVERIFY(std::abs(spreadOf(random, {}) - 0.6 * spreadOf(first, {})) < 1e-3 * first.spread());
    }

    void deepZoomKeepsItsShape()
    {
        // The same stroke drawn at 1e6 times the zoom, far from the canvas' corner.
        Brush tiny;
        tiny.diffusion = 12.5e-12f;
        const Point at{512.123456789, 300.987654321};
        std::vector<PenSample> samples;
        for (int i = 0; i < 40; ++i)
            samples.push_back({at + 1e-6 * Point{3.0 * i, 10 * std::sin(0.3 * i)}, i * 8'000, 1});
        const StrokePtr stroke = buildStroke(tiny, 1, samples);
        QCOMPARE(problemOf(*stroke), QString());
        for (int i : {0, 39})
            QVERIFY(distanceTo(*stroke, samples[std::size_t(i)].position) < 1e-4 * tiny.spread());
    }
};

QTEST_GUILESS_MAIN(TestStrokeBuilder)
#include "test_stroke_builder.moc"
