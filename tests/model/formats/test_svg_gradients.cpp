// Gradients of drawings as fills: linear ones exactly, others as stacks or strips.
#include "model/area/area_sets.h"
#include "model/area/outline.h"
#include "model/formats/files.h"
#include "model/formats/svg/svg_painting.h"
#include "model/painting/ryb.h"

#include <QTest>

#include <numbers>

using namespace suffuse;

namespace {

QByteArray svg(const QByteArray &root, const QByteArray &content)
{
    return "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" " + root + ">" + content + "</svg>";
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
        // Rings beside each other where paint lets through, of which none lies over another.
        const Painting rings = read("", "<stop stop-color='#000' stop-opacity='0'/><stop offset='1'/>", box);
        double sum = 0;
        for (const StrokePtr &stroke : rings.strokes)
            sum += sizeOf(areaOf(closedOutline(*stroke), stroke->fill->rule));
        QVERIFY2(rings.strokes.size() >= 30 && std::abs(sum - 3600) < 0.5, qPrintable(QString::number(sum)));
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
