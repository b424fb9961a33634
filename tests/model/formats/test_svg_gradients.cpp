// Gradients of drawings as fills: linear ones exactly, others as stacks or strips.
#include "model/area/area_sets.h"
#include "model/area/outline.h"
#include "model/formats/files.h"
#include "model/formats/svg/svg_painting.h"
#include "model/painting/ryb.h"

#include <QRegularExpression>
#include <QTest>

#include <numbers>
#include <set>

using namespace suffuse;
using test::svg;

namespace {

/// A fill between circles around (100, 100).
struct RoundFill {
    std::vector<double> radii; ///< of its chains
    Colour colour;
};

RoundFill roundFill(const Stroke &stroke)
{
    RoundFill fill{{}, stroke.fill->colour};
    for (std::size_t k = 0; k < stroke.segments.size(); ++k)
        if (stroke.beginsChain(k))
            fill.radii.push_back(length(stroke.cubicOf(stroke.segments[k]).p[0] - Point{100, 100}));
    return fill;
}

/// The colour at a radius, each sRGB-encoded channel multiplied by the opacity, which comes last. Where a fill ends it
/// covers the half.
std::array<double, 4> composed(const std::vector<RoundFill> &fills, double radius)
{
    std::array<double, 4> ryb{};
    for (const RoundFill &fill : fills) {
        int around = 0;
        bool isEdge = false;
        for (const double own : fill.radii)
            around += own > radius ? 1 : 0, isEdge = isEdge || std::abs(own - radius) < 1e-3;
        const Colour &c = fill.colour;
        const double covered = isEdge ? 0.5 : around % 2, opacity = covered * double(c.opacity);
        const std::array<double, 4> paint{double(c.red), double(c.yellow), double(c.blue), 1};
        for (std::size_t i = 0; i < 4; ++i)
            ryb[i] += opacity * (paint[i] - ryb[i]);
    }
    const double opacity = ryb[3], divisor = std::max(opacity, 1e-9);
    const std::array<double, 3> colour = srgbFromRyb(std::array{ryb[0] / divisor, ryb[1] / divisor, ryb[2] / divisor});
    return {opacity * colour[0], opacity * colour[1], opacity * colour[2], opacity};
}

/// What a gradient's stops say at an offset, in the same way.
std::array<double, 4> wantedColour(const QByteArray &stops, double opacity, double offset)
{
    static const QRegularExpression stop(QStringLiteral("<stop[^>]*>")), place(QStringLiteral(" offset='([^']*)'")),
        colour(QStringLiteral("stop-color='#(.)(.)(.)'")), share(QStringLiteral("stop-opacity='([^']*)'"));
    std::array<double, 4> result{};
    double before = -1;
    for (auto it = stop.globalMatch(QString::fromLatin1(stops)); it.hasNext();) {
        const QString text = it.next().captured();
        const double at = place.match(text).captured(1).toDouble();
        std::array<double, 4> own{0, 0, 0, 1};
        if (const auto match = colour.match(text); match.hasMatch())
            for (int c = 0; c < 3; ++c)
                own[std::size_t(c)] = match.captured(c + 1).toInt(nullptr, 16) / 15.0;
        if (const auto match = share.match(text); match.hasMatch())
            own[3] = match.captured(1).toDouble();
        const double way = before < 0 || at <= before ? 1 : std::clamp((offset - before) / (at - before), 0.0, 1.0);
        if (before < 0 || offset >= before)
            for (std::size_t c = 0; c < 4; ++c)
                result[c] = at <= offset || before >= 0 ? result[c] + way * (own[c] - result[c]) : own[c];
        if (at > offset)
            break;
        before = at;
    }
    result[3] *= opacity;
    for (std::size_t c = 0; c < 3; ++c)
        result[c] *= result[3];
    return result;
}

} // namespace

class TestSvgGradients : public QObject {
    Q_OBJECT

private slots:
    void linearGradientsAreGradients()
    {
        const auto read = [](const QByteArray &attributes, const QByteArray &stops, const QByteArray &shape) {
            const Result<Painting> painting =
                readPainting(svg("viewBox=\"0 0 100 100\"",
                                 "<linearGradient id='g' " + attributes + ">" + stops + "</linearGradient>" + shape),
                             "a.svg");
            return painting ? *painting : Painting();
        };
        const QByteArray greys = "<stop stop-color='#888'/><stop offset='1' stop-color='#999'/>";
        const QByteArray box = "<rect x='20' y='10' width='60' height='80' fill='url(#g)'/>";
        const auto places = [](const Stroke &stroke) {
            const Gradient &g = *stroke.fill->gradient;
            return std::array{stroke.origin + g.from, stroke.origin + g.to};
        };
        const auto near = [](Point a, Point b) { return length(a - b) < 1e-4; };
        const Painting across = read("", greys, box);
        QCOMPARE(across.strokes.size(), std::size_t(1));
        QCOMPARE(across.strokes[0]->fill->colour, rybFromSrgb(0x88 / 255.0, 0x88 / 255.0, 0x88 / 255.0));
        QVERIFY(near(places(*across.strokes[0])[0], {20, 10}) && near(places(*across.strokes[0])[1], {80, 10}));
        const Painting own = read("gradientUnits='userSpaceOnUse' x1='30' y1='40' x2='50%' y2='40'", greys, box);
        QVERIFY(near(places(*own.strokes[0])[0], {30, 40}) && near(places(*own.strokes[0])[1], {50, 40}));
        const Painting turned = read("gradientTransform='rotate(90)'", greys, box); // downwards, as long as it is high
        QVERIFY(near(places(*turned.strokes[0])[0], {20, 10}) && near(places(*turned.strokes[0])[1], {20, 90}));
        // A shear keeps lines of one colour upright lines, along which they are moved.
        const Painting sheared = read(
            "gradientUnits='userSpaceOnUse' x1='0' y1='0' x2='10' y2='0' gradientTransform='skewX(45)'", greys, box);
        const std::array<Point, 2> slanted = places(*sheared.strokes[0]);
        QVERIFY(near(slanted[0], {0, 0}) && near(slanted[1], {5, -5}));

        const Painting many = read("",
                                   "<stop stop-color='red'/><stop offset='.5' stop-color='yellow'/>"
                                   "<stop offset='1' stop-color='blue'/>",
                                   box);
        QVERIFY(many.strokes.size() >= 2); // over each other, in a group
        QCOMPARE(many.groups.size(), std::size_t(1));
        QCOMPARE(many.strokes[1]->fill->colour.opacity, 0.0f);
        QCOMPARE(many.strokes[1]->fill->gradient->colour.opacity, 1.0f);
        const Painting one = read("", "<stop stop-color='red'/>", box);
        QCOMPARE(one.strokes.size(), std::size_t(1));
        QVERIFY(!one.strokes[0]->fill->gradient);
    }

    /// Paint goes where the colours of a screen go, through greys, too, where it would make a detour by itself.
    void gradientsOfAnyTwoColours()
    {
        const std::pair<const char *, const char *> pairs[] = {{"#ff8800", "#0088ff"}, {"#ff0000", "#00ffff"},
                                                               {"#00ff00", "#ff00ff"}, {"#000000", "#ffffff"},
                                                               {"#ffff00", "#0000ff"}, {"#12a4c0", "#fe3080"}};
        for (const auto &[from, to] : pairs) {
            const Result<Painting> painting = readPainting(
                svg("viewBox='0 0 100 100'", QByteArray("<linearGradient id='g'><stop stop-color='") + from +
                                                 "'/><stop offset='1' stop-color='" + to +
                                                 "'/></linearGradient><rect width='100' height='100' fill='url(#g)'/>"),
                "a.svg");
            QVERIFY(painting && !painting->strokes.empty());
            const auto channel = [](const char *hex, int i) {
                return QByteArray(hex + 1 + 2 * i, 2).toInt(nullptr, 16) / 255.0;
            };
            for (int x = 0; x <= 100; ++x) {
                std::array<double, 3> ryb{};
                for (const StrokePtr &stroke : painting->strokes) {
                    const Fill &fill = *stroke->fill;
                    Colour c = fill.colour;
                    if (fill.gradient) {
                        const Point begin = stroke->origin + fill.gradient->from,
                                    end = stroke->origin + fill.gradient->to;
                        const auto t = float(std::clamp((x - begin.x) / (end.x - begin.x), 0.0, 1.0));
                        const auto mix = [t](float a, float b) { return a + t * (b - a); };
                        const Colour &other = fill.gradient->colour;
                        c = {mix(c.red, other.red), mix(c.yellow, other.yellow), mix(c.blue, other.blue),
                             mix(c.opacity, other.opacity)};
                    }
                    const float paint[] = {c.red, c.yellow, c.blue};
                    for (std::size_t i = 0; i < 3; ++i)
                        ryb[i] += double(c.opacity) * (double(paint[i]) - ryb[i]);
                }
                const std::array<double, 3> shown = srgbFromRyb(ryb);
                for (int i = 0; i < 3; ++i) {
                    const double wanted = channel(from, i) + x / 100.0 * (channel(to, i) - channel(from, i));
                    QVERIFY2(std::abs(shown[std::size_t(i)] - wanted) <= 1.0 / 64,
                             qPrintable(QStringLiteral("%1 to %2 at %3 %: %4, not %5")
                                            .arg(QLatin1String(from), QLatin1String(to))
                                            .arg(x)
                                            .arg(shown[std::size_t(i)])
                                            .arg(wanted)));
                }
            }
        }
    }

    /// Around a point colours change in steps that are no higher than 1/32, so that none is off by more than 1/64.
    void radialGradientsAreStacks()
    {
        const auto read = [](const QByteArray &attributes, const QByteArray &stops, const QByteArray &shape) {
            const Result<LoadedDocument> read =
                readDocument(svg("viewBox='0 0 100 100'",
                                 "<radialGradient id='g' " + attributes + ">" + stops + "</radialGradient>" + shape),
                             "a.svg");
            return read && read->leftOut.isEmpty() ? read->painting : Painting();
        };
        const QByteArray greys = "<stop stop-color='#000'/><stop offset='1' stop-color='#fff'/>";
        const QByteArray box = "<rect x='20' y='20' width='60' height='60' fill='url(#g)'/>";
        const Painting stack = read("", greys, box);
        QVERIFY2(stack.strokes.size() >= 32 && stack.strokes.size() < 40,
                 qPrintable(QString::number(stack.strokes.size())));
        QCOMPARE(stack.groups.size(), std::size_t(1));
        // From the largest to the smallest, each a circle as far as the shape shows it, and brighter outside.
        double size = 1e9;
        const auto brightness = [](const Stroke &stroke) {
            const Colour &c = stroke.fill->colour;
            return srgbFromRyb(std::array{double(c.red), double(c.yellow), double(c.blue)})[1];
        };
        double before = 2;
        for (const StrokePtr &stroke : stack.strokes) {
            const double own = sizeOf(areaOf(closedOutline(*stroke), stroke->fill->rule));
            QVERIFY(own <= size);
            size = own;
            const double bright = brightness(*stroke);
            QVERIFY(bright < before && (before == 2 || before - bright < 1.0 / 31));
            before = bright;
            if (own < 0.7 * 3600) {
                const double radius = std::sqrt(own / std::numbers::pi);
                QVERIFY2(std::abs(bright - (radius / 30 - 1.0 / 64)) < 0.005,
                         qPrintable(QStringLiteral("%1 at %2").arg(bright).arg(radius)));
            }
        }
        // A focus, a transform, repetition, units of the document.
        QVERIFY(read("fx='0.3' fy='0.4'", greys, box).strokes.size() >= 32);
        QVERIFY(read("spreadMethod='repeat' r='0.2'", greys, box).strokes.size() > 100);
        QVERIFY(read("spreadMethod='reflect' r='20%' gradientTransform='rotate(20) scale(1 2)'", greys, box)
                    .strokes.size() > 50);
        const Painting own = read("gradientUnits='userSpaceOnUse' cx='50' cy='50' r='10'", greys, box);
        QCOMPARE(brightness(*own.strokes.front()), 1.0);
        QVERIFY(brightness(*own.strokes.back()) < 0.02);
        // Without a radius there is the last colour alone; a box without height has no shares.
        QCOMPARE(read("r='0'", greys, box).strokes.size(), std::size_t(1));
        QCOMPARE(read("", greys, "<path d='M0 50h99' stroke='url(#g)'/>" + box).strokes.size(), stack.strokes.size());
    }

    /// Where a gradient around a point lets through, it has its colours at each radius, and no seams between its steps.
    void radialGradientsThatLetThrough_data()
    {
        QTest::addColumn<QByteArray>("stops");
        QTest::addColumn<double>("opacity");
        QTest::newRow("glow") << QByteArray("<stop stop-color='#fd8'/><stop offset='1' stop-color='#fd8' "
                                            "stop-opacity='0'/>")
                              << 1.0;
        QTest::newRow("hole") << QByteArray("<stop stop-opacity='0'/><stop offset='1'/>") << 1.0;
        QTest::newRow("three") << QByteArray("<stop stop-color='#444' stop-opacity='.9'/><stop offset='.4' "
                                             "stop-color='#999' stop-opacity='.2'/><stop offset='1' stop-color='#ccc' "
                                             "stop-opacity='.7'/>")
                               << 1.0;
        QTest::newRow("jump") << QByteArray("<stop stop-color='#888'/><stop offset='.5' stop-color='#888'/><stop "
                                            "offset='.5' stop-color='#eee' stop-opacity='.3'/><stop offset='1' "
                                            "stop-color='#eee' stop-opacity='.1'/>")
                              << 1.0;
        QTest::newRow("veil") << QByteArray("<stop stop-color='#000'/><stop offset='1' stop-color='#fff'/>") << 0.5;
        QTest::newRow("thick veil") << QByteArray("<stop stop-color='#000'/><stop offset='1' stop-color='#fff'/>")
                                    << 0.9;
    }
    void radialGradientsThatLetThrough()
    {
        QFETCH(const QByteArray, stops);
        QFETCH(const double, opacity);
        // The opacity of a shape that paints once is that of its paint.
        for (const QByteArray &attribute : {QByteArray("fill-opacity"), QByteArray("opacity")}) {
            const Result<LoadedDocument> read =
                readDocument(svg("viewBox='0 0 200 200'",
                                 "<radialGradient id='g' gradientUnits='userSpaceOnUse' cx='100' cy='100' r='80'>" +
                                     stops + "</radialGradient><circle cx='100' cy='100' r='90' fill='url(#g)' " +
                                     attribute + "='" + QByteArray::number(opacity) + "'/>"),
                             "a.svg");
            QVERIFY(read && read->leftOut.isEmpty());
            std::vector<RoundFill> fills;
            for (const StrokePtr &stroke : read->painting.strokes)
                fills.push_back(roundFill(*stroke));
            std::set<double> edges;
            for (const RoundFill &fill : fills)
                edges.insert(fill.radii.begin(), fill.radii.end());
            for (double radius = 0.1; radius < 88; radius += 0.1) {
                const auto edge = edges.lower_bound(radius - 0.01);
                if (edge != edges.end() && *edge < radius + 0.01)
                    continue;
                const std::array<double, 4> shown = composed(fills, radius),
                                            wanted = wantedColour(stops, opacity, radius / 80);
                for (std::size_t c = 0; c < 4; ++c)
                    QVERIFY2(std::abs(shown[c] - wanted[c]) <= 1.0 / 64,
                             qPrintable(QStringLiteral("channel %1 at %2: %3, not %4")
                                            .arg(c)
                                            .arg(radius)
                                            .arg(shown[c])
                                            .arg(wanted[c])));
            }
            for (const double edge : edges) { // A pixel there is half covered by what ends and by what begins.
                if (!(edge > 0.2 && edge < 89) || std::abs(edge - 40) < 0.01) // the jump is an edge of the drawing
                    continue;
                const double beside = 0.5 * (composed(fills, edge - 0.05)[3] + composed(fills, edge + 0.05)[3]);
                const double shown = composed(fills, edge)[3];
                QVERIFY2(std::abs(shown - beside) <= 1.0 / 128,
                         qPrintable(QStringLiteral("seam at %1: %2, not %3").arg(edge).arg(shown).arg(beside)));
            }
        }
    }

    /// Of very many gradients none is left out.
    void manyGradientsComeAll()
    {
        QByteArray shapes;
        for (int i = 0; i < 200; ++i)
            shapes += QStringLiteral("<path d='M%1 %2q50 -40 80 10t-30 60z' fill='url(#g)'/>")
                          .arg(37 * i % 900)
                          .arg(211 * i % 900)
                          .toLatin1();
        const Result<LoadedDocument> read =
            readDocument(svg("viewBox='0 0 1000 1000'", "<radialGradient id='g'><stop stop-color='#fd8'/><stop "
                                                        "offset='1' stop-color='#08f' stop-opacity='0'/>"
                                                        "</radialGradient>" +
                                                            shapes),
                         "a.svg");
        QVERIFY(read);
        QCOMPARE(read->leftOut, QString());
        QCOMPARE(read->painting.groups.size(), std::size_t(200));
    }

    /// Where colours let through, or repeat, strips lie beside each other.
    void linearGradientsMayBeStrips()
    {
        const auto read = [](const QByteArray &attributes, const QByteArray &stops) {
            const Result<LoadedDocument> read = readDocument(
                svg("viewBox='0 0 100 100'", "<linearGradient id='g' " + attributes + ">" + stops +
                                                 "</linearGradient><rect x='20' y='20' width='60' height='60' "
                                                 "fill='url(#g)'/>"),
                "a.svg");
            return read && read->leftOut.isEmpty() ? read->painting : Painting();
        };
        const auto sum = [](const Painting &painting) {
            double sum = 0;
            for (const StrokePtr &stroke : painting.strokes)
                sum += sizeOf(areaOf(closedOutline(*stroke), stroke->fill->rule));
            return sum;
        };
        const Painting three = read("gradientTransform='rotate(30)'",
                                    "<stop offset='.2'/><stop offset='.5' stop-opacity='.2'/><stop offset='.8'/>");
        QCOMPARE(three.strokes.size(), std::size_t(4)); // before, two shades, behind
        QVERIFY2(std::abs(sum(three) - 3600) < 0.1, qPrintable(QString::number(sum(three))));
        const Painting repeated = read("spreadMethod='repeat' x2='.25'", "<stop stop-color='#888'/>"
                                                                         "<stop offset='1' stop-color='#999'/>");
        QVERIFY2(repeated.strokes.size() >= 4 && repeated.strokes.size() < 20,
                 qPrintable(QString::number(repeated.strokes.size())));
    }

    void gradientsOfStrokesAreGradients()
    {
        const Result<Painting> painting = readPainting(
            svg("", "<linearGradient id='g' gradientUnits='userSpaceOnUse' x2='9'><stop stop-color='#888'/>"
                    "<stop offset='1' stop-color='#999'/></linearGradient>"
                    "<path d='M0 0h9' stroke='url(#g)' stroke-linecap='round'/>"),
            "a.svg");
        QVERIFY2(painting, qPrintable(painting.error()));
        QCOMPARE(painting->strokes.size(), std::size_t(1));
        QVERIFY(painting->strokes[0]->fill && painting->strokes[0]->fill->gradient);
    }
};

QTEST_GUILESS_MAIN(TestSvgGradients)
#include "test_svg_gradients.moc"
#include "tests/model/formats/svg_text.h"
