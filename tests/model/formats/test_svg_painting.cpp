// SVG drawings come in as strokes: where they lie, how large, how wide, in which colour.
#include "model/area/area_sets.h"
#include "model/area/outline.h"
#include "model/formats/files.h"
#include "model/formats/svg/svg_painting.h"
#include "model/paint/half_width.h"
#include "model/paint/seen_paint.h"
#include "model/painting/ryb.h"
#include "model/painting/validate.h"

#include <QTest>

#include <numbers>

using namespace suffuse;

namespace {

QByteArray svg(const QByteArray &root, const QByteArray &content)
{
    return "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" " + root + ">" + content + "</svg>";
}

QString errorOf(const QByteArray &bytes)
{
    const Result<Painting> painting = readPainting(bytes, QStringLiteral("folder/a.svg"));
    return painting ? QString() : painting.error();
}

Point startOf(const Stroke &stroke)
{
    return stroke.origin + stroke.segments.front().bezier[0];
}

double widthOf(const Stroke &stroke)
{
    const Segment &s = stroke.segments.front();
    return 2 * halfWidth(double(s.diffusion), double(s.density), double(s.maxAge), visibleCut(stroke.style));
}

const QByteArray line = "<path d=\"M20 30h40\" fill=\"none\" stroke=\"#ff0000\" stroke-width=\"8\" "
                        "stroke-linecap=\"round\"/>";

} // namespace

class TestSvgPainting : public QObject {
    Q_OBJECT

private slots:
    void isFoundFromItsContent()
    {
        QCOMPARE(detectFormat(svg("", line)), FileFormat::Svg);
        QCOMPARE(detectFormat("<svg/>"), FileFormat::Svg);
        QCOMPARE(detectFormat("\xef\xbb\xbf\n<!-- " + QByteArray(20'000, '-') + " --><svg/>"), FileFormat::Svg);
        QCOMPARE(detectFormat("<curve_set/><!-- <svg/> -->"), FileFormat::DiffusionCurves);
        QCOMPARE(detectFormat("<html/>"), FileFormat::Unknown);
        QCOMPARE(formatForSaving("a.svg"), FileFormat::Unknown);
        QVERIFY(errorOf("<html/>").contains("SVG"));
        QVERIFY(errorOf("\x1f\x8b\x08").contains("unpack"));
    }

    void sizes_data()
    {
        QTest::addColumn<QByteArray>("root");
        QTest::addColumn<QSizeF>("canvas");
        QTest::addColumn<QPointF>("start"); ///< of the line at (20, 30)
        QTest::addColumn<double>("width");
        QTest::newRow("width and height")
            << QByteArray("width=\"100\" height=\"80px\"") << QSizeF(100, 80) << QPointF(20, 30) << 8.0;
        QTest::newRow("view box") << QByteArray("viewBox=\"10 20 100 80\"") << QSizeF(100, 80) << QPointF(10, 10)
                                  << 8.0;
        QTest::newRow("scaled") << QByteArray("viewBox=\"10,20,100,80\" width=\"200\" height=\"160\"")
                                << QSizeF(200, 160) << QPointF(20, 20) << 16.0;
        QTest::newRow("by its width") << QByteArray("viewBox=\"0 0 100 80\" width=\"50\"") << QSizeF(50, 40)
                                      << QPointF(10, 15) << 4.0;
        QTest::newRow("in the middle") << QByteArray("viewBox=\"0 0 100 80\" width=\"900\" height=\"160\"")
                                       << QSizeF(900, 160) << QPointF(390, 60) << 16.0;
        QTest::newRow("a slice") << QByteArray("viewBox=\"0 0 100 80\" width=\"200\" height=\"80\" "
                                               "preserveAspectRatio=\"xMidYMax slice\"")
                                 << QSizeF(200, 80) << QPointF(40, -20) << 16.0;
        QTest::newRow("stretched") << QByteArray("viewBox=\"0 0 100 80\" width=\"900\" height=\"160\" "
                                                 "preserveAspectRatio=\"none\"")
                                   << QSizeF(200, 160) << QPointF(40, 60) << 16.0;
        QTest::newRow("per cents") << QByteArray("viewBox=\"0 0 100 80\" width=\"100%\" height=\"100%\"")
                                   << QSizeF(100, 80) << QPointF(20, 30) << 8.0;
        QTest::newRow("millimetres") << QByteArray("viewBox=\"0 0 96 96\" width=\"25.4mm\" height=\"25.4mm\"")
                                     << QSizeF(96, 96) << QPointF(20, 30) << 8.0;
        QTest::newRow("between units") << QByteArray("width=\"99.5\" height=\"0.25\"") << QSizeF(100, 1)
                                       << QPointF(20, 30) << 8.0;
    }
    void sizes()
    {
        QFETCH(const QByteArray, root);
        QFETCH(const QSizeF, canvas);
        QFETCH(const QPointF, start);
        QFETCH(const double, width);
        const Result<Painting> painting = readPainting(svg(root, line), "a.svg");
        QVERIFY2(painting, qPrintable(painting.error()));
        QCOMPARE(problemOf(*painting), QString());
        QCOMPARE(QSizeF(painting->canvas.width, painting->canvas.height), canvas);
        QCOMPARE(painting->strokes.size(), std::size_t(1));
        const Stroke &stroke = *painting->strokes[0];
        QVERIFY(std::abs(startOf(stroke).x - start.x()) < 1e-4 && std::abs(startOf(stroke).y - start.y()) < 1e-4);
        QVERIFY2(std::abs(widthOf(stroke) - width) < 1e-3, qPrintable(QString::number(widthOf(stroke))));
    }

    void withoutASizeTheCanvasIsAroundWhatIsDrawn()
    {
        const Brush brush = svgPen();
        for (const QByteArray root :
             {"", "width=\"100\"", "viewBox=\"0 0 0 0\"", "viewBox=\"0 0 1\"", "width=\"-3\""}) {
            const Result<Painting> painting = readPainting(svg(root, line), "a.svg");
            QVERIFY2(painting, qPrintable(painting.error()));
            const double margin = 2 * brush.spread();
            QCOMPARE(painting->canvas.width, std::ceil(40 + 2 * margin));
            QCOMPARE(painting->canvas.height, std::ceil(2 * margin));
            QVERIFY(std::abs(startOf(*painting->strokes[0]).x - margin) < 1e-3);
        }
    }

    void strokesStandInTheirOrderAndColours()
    {
        const Brush &brush = builtinBrushes().back();
        const Result<Painting> painting = readPainting(
            svg("viewBox=\"0 0 100 100\"", line + "<rect x=\"10\" y=\"10\" width=\"20\" height=\"20\" fill=\"#00f\"/>" +
                                               "<text x=\"1\" y=\"9\">words</text><path d=\"M1 1h0\"/>"),
            "a.svg", &brush);
        QVERIFY2(painting, qPrintable(painting.error()));
        QCOMPARE(painting->strokes.size(), std::size_t(2));
        QCOMPARE(painting->strokes[0]->segments.size(), std::size_t(1));
        QCOMPARE(painting->strokes[1]->segments.size(), std::size_t(4));
        QCOMPARE(painting->strokes[0]->segments[0].colour, rybFromSrgb(1, 0, 0));
        QCOMPARE(painting->strokes[1]->fill->colour, rybFromSrgb(0, 0, 1));
        QCOMPARE(painting->strokes[0]->brush, brush.name);
        QVERIFY(!painting->strokes[0]->fill);
        for (std::size_t i = 0; i < 2; ++i) {
            QCOMPARE(painting->strokes[i]->id, StrokeId(i + 1));
            QCOMPARE(painting->strokes[i]->segments[0].born, Microseconds(0));
        }
    }

    void textIsLeftOutWithAMessage()
    {
        const auto leftOut = [](const QByteArray &content) {
            const Result<LoadedDocument> document = readDocument(svg("", line + content), "a.svg");
            return document ? document->leftOut : document.error();
        };
        QCOMPARE(leftOut(""), QString());
        QCOMPARE(leftOut("<text>words</text><text>more</text>"), QString("2 text(s) were left out."));
        QCOMPARE(leftOut("<g><image width=\"9\" height=\"9\"/></g>"), QString("1 image(s) were left out."));
        QCOMPARE(leftOut("<text display=\"none\">words</text><defs><text>words</text></defs>"), QString());
    }

    void whatIsLeftOutIsCountedAndNamedOnce()
    {
        const auto leftOut = [](const QByteArray &content) {
            const Result<LoadedDocument> document = readDocument(svg("", content), "a.svg");
            return document ? document->leftOut : document.error();
        };
        for (const char *unfilled :
             {"<circle r=\"9\" fill=\"none\" stroke=\"red\"/>",
              "<style>circle{fill:none;stroke:red}</style><circle r=\"9\"/>",
              "<rect width=\"9\" height=\"9\" fill-opacity=\"0\" stroke=\"red\"/>",
              "<rect width=\"9\" height=\"9\" fill=\"url(#none) none\" stroke=\"red\"/>",
              "<line x2=\"9\" y2=\"4\" stroke=\"red\"/>", "<path d=\"M3 3l0.1 0.3l0.2 0.6\" stroke=\"red\"/>"})
            QCOMPARE(leftOut(unfilled), QString());
        const QByteArray definitions =
            "<defs><linearGradient id=\"g\"><stop stop-color=\"red\"/><stop offset=\"1\" stop-color=\"blue\"/>"
            "</linearGradient><linearGradient id=\"one\"><stop stop-color=\"red\"/></linearGradient>"
            "<radialGradient id=\"h\" href=\"#g\"/><clipPath id=\"c\"><path d=\"M0 0h9v9h-9z\"/></clipPath>"
            "<marker id=\"m\"><path d=\"M0 0h9\"/></marker><mask id=\"k\"/><filter id=\"f\"/><pattern id=\"p\"/>"
            "</defs><style>.d{fill:none;stroke:red;stroke-dasharray:4 2}</style>";
        QCOMPARE(leftOut(definitions + line), QString());
        QCOMPARE(leftOut(definitions + "<path class=\"d\" d=\"M0 0h9\"/><path class=\"d\" d=\"M0 0h9\"/>"
                                       "<g clip-path=\"url(#c)\"><rect width=\"9\" height=\"9\" fill=\"url(#g)\"/>"
                                       "<rect width=\"9\" height=\"9\" fill=\"url('#g') red\" clip-path=\"url(#c)\"/>"
                                       "<rect width=\"9\" height=\"9\" fill=\"url(#h)\"/></g>"),
                 QString());
        QCOMPARE(leftOut(definitions + "<g marker=\"url(#m)\" mask=\"url(#k)\" style=\"filter:url(#f)\">" + line +
                         "<text>words</text></g><path d=\"M0 0h9\" stroke=\"url(#p)\"/>"),
                 QString("1 pattern(s), 1 mask(s), 1 filter(s), 1 text(s) were left out."));
        // What does not show is not lost, nor are gradients of one colour.
        QCOMPARE(leftOut(definitions + line +
                         "<g display=\"none\" clip-path=\"url(#c)\"><path class=\"d\" d=\"M0 0h9\"/></g>"
                         "<path d=\"M0 0h9\" stroke=\"url(#one)\" stroke-dasharray=\"0,0\"/>"
                         "<path d=\"M0 0h9\" stroke=\"red\" style=\"stroke-dasharray:-1 4\"/>"
                         "<path class=\"d\" d=\"M0 0h9\" style=\"stroke-dasharray:none\"/>"),
                 QString());
        QCOMPARE(leftOut("<style>path[d]{stroke:red} @import 'a.css'; path:hover{stroke:blue}</style>" + line),
                 QString("2 style rule(s) were left out."));
    }

    /// What lies under everything is the canvas; what only looks a little like that is a fill.
    void theBackgroundIsTheCanvas()
    {
        const auto read = [](const QByteArray &content) {
            const Result<Painting> painting =
                readPainting(svg("width=\"200\" height=\"100\" viewBox=\"0 0 100 50\"", content), "a.svg");
            return painting ? *painting : Painting();
        };
        const Painting cream = read("<rect id='background' width='100' height='50' fill='#fdf6e3'/>" + line);
        QCOMPARE(cream.strokes.size(), std::size_t(1));
        QVERIFY(!cream.strokes[0]->fill);
        const auto rgb = srgbFromRyb(cream.canvas.background);
        const std::array<double, 3> wanted{0xfd / 255.0, 0xf6 / 255.0, 0xe3 / 255.0};
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(std::abs(double(rgb[i]) - wanted[i]) < 0.003);
        QCOMPARE(cream.canvas.background.opacity, 1.0f);
        for (const QByteArray &other :
             {QByteArray("<rect id='ground' width='100' height='50' fill='#fdf6e3'/>"),
              QByteArray("<rect id='background' width='90' height='50' fill='#fdf6e3'/>"),
              QByteArray("<rect id='background' width='100' height='50' fill='#fdf6e3' fill-opacity='.5'/>"),
              QByteArray("<path id='background' d='M0 0H100V50z' fill='#fdf6e3'/>")}) {
            const Painting painting = read(other + line);
            QVERIFY2(painting.strokes.size() == 2 && painting.strokes[0]->fill, other.constData());
            QCOMPARE(painting.canvas.background, Canvas().background);
        }
        // It has to lie under something, and under everything.
        QCOMPARE(read("<rect id='background' width='100' height='50'/>").strokes.size(), std::size_t(1));
        QCOMPARE(read(line + "<rect id='background' width='100' height='50'/>").strokes.size(), std::size_t(2));
    }

    /// A pattern is not black: nothing takes its place but the colour that the drawing names for that.
    void patternsAreLeftOut()
    {
        const QByteArray pattern = "<pattern id='p'/>";
        const auto count = [&](const QByteArray &paint) {
            const auto painting = readPainting(
                svg("viewBox='0 0 100 100'", pattern + line + "<rect width='9' height='9' " + paint + "/>"), "a.svg");
            return painting ? int(painting->strokes.size()) - 1 : -1;
        };
        QCOMPARE(count("fill='url(#p)'"), 0);
        QCOMPARE(count("fill='url(#p) none'"), 0);
        QCOMPARE(count("fill='none' stroke='url(#p)'"), 0);
        QCOMPARE(count("fill='url(#p)' stroke='red' stroke-linecap='round' stroke-linejoin='round'"), 1);
        QCOMPARE(count("fill='url(#p) #00ff00'"), 1);
        QCOMPARE(count("color='blue' fill='url(#p) currentColor'"), 1);
        QString said;
        const Brush &brush = builtinBrushes().front();
        QVERIFY(
            readSvg(svg("", pattern + line + "<rect width='9' height='9' fill='url(#p)'/>"), "a.svg", brush, &said));
        QCOMPARE(said, QString("1 pattern(s) were left out."));
    }

    void areasAreFills()
    {
        const auto read = [](const QByteArray &content) {
            const Result<Painting> painting = readPainting(svg("viewBox=\"0 0 100 100\"", content), "a.svg");
            return painting ? painting->strokes : StrokeList();
        };
        const StrokeList both = read("<path d='M10 10h30v30zM50 10h30v30' fill='#0f0' fill-opacity='.5' stroke='red' "
                                     "stroke-linecap='round' stroke-linejoin='round'/>");
        QCOMPARE(both.size(), std::size_t(3)); // the area below, then a line along each subpath
        const Stroke &area = *both[0];
        QCOMPARE(area.fill->colour, rybFromSrgb(0, 1, 0, 0.5));
        QCOMPARE(area.fill->rule, FillRule::NonZero);
        QCOMPARE(area.segments.size(), std::size_t(5)); // an open subpath is closed by the fill itself
        QVERIFY(area.segments[3].start && !area.segments[0].start);
        for (const Segment &segment : area.segments)
            QCOMPARE(segment.density, 0.0f); // only the area has paint
        QVERIFY(!both[1]->fill && !both[2]->fill && both[1]->segments[0].density > 0);

        const StrokeList odd = read("<g fill-rule='evenodd'><path d='M0 0h9v9h-9z'/></g>"
                                    "<path style='fill-rule:evenodd' fill-rule='nonzero' d='M0 0h9v9z'/>");
        QCOMPARE(odd.size(), std::size_t(2));
        QCOMPARE(odd[0]->fill->rule, FillRule::EvenOdd);
        QCOMPARE(odd[1]->fill->rule, FillRule::EvenOdd);
    }

    /// What has an opacity as a whole shows nothing of what it covers.
    void cornersComeInAsCorners()
    {
        const Result<Painting> painting = readPainting(
            svg("viewBox=\"0 0 100 100\"", "<rect width=\"60\" height=\"40\"/><ellipse rx=\"30\" ry=\"20\"/>"
                                           "<path d=\"M0 0h30q20 0 20 20v30l-50 50z\"/>"),
            QStringLiteral("a.svg"));
        QVERIFY(bool(painting));
        const auto kindsOf = [&](std::size_t k) {
            std::vector<NodeKind> kinds;
            for (const Segment &segment : painting->strokes[k]->segments)
                kinds.push_back(segment.node);
            return std::vector<NodeKind>(kinds.begin() + 1, kinds.end()); // The first one is an end.
        };
        constexpr NodeKind corner = NodeKind::Corner, smooth = NodeKind::Smooth;
        QCOMPARE(kindsOf(0), (std::vector{corner, corner, corner}));
        QCOMPARE(kindsOf(1), (std::vector{smooth, smooth, smooth}));
        QCOMPARE(kindsOf(2), (std::vector{smooth, smooth, corner, corner}));
    }

    void opacityIsThatOfTheWhole_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<std::vector<double>>("sizes"); ///< by opacity: from thin to strong
        QTest::addColumn<std::vector<double>>("opacities");
        using Row = std::vector<double>;
        const QByteArray a = "<rect width='10' height='10'/>", b = "<rect x='5' width='10' height='10'/>";
        QTest::newRow("two opaque areas") << "<g opacity='.5'>" + a + b + "</g>" << Row{50, 100} << Row{.5, .5};
        QTest::newRow("beside each other")
            << "<g opacity='.5'>" + a + "<rect x='10' width='9' height='10'/></g>" << Row{100, 90} << Row{.5, .5};
        // Where the upper one lets half through: 1 − (1 − .25)(1 − x) = .5 · (1 − .5 · 0)
        QTest::newRow("an upper one that lets through") << "<g opacity='.5'>" + a + "<g opacity='.5'>" + b + "</g></g>"
                                                        << Row{50, 50, 100} << Row{.5, .5 * .5 / (1 - .25), .25};
        QTest::newRow("a fill below its stroke")
            << QByteArray("<rect x='10' y='10' width='10' height='10' opacity='.5' stroke='red' stroke-width='2'/>")
            << Row{64, 12 * 12 - 64} << Row{.5, .5};
        QTest::newRow("a round stroke over a fill")
            << QByteArray("<g opacity='.5'><path d='M10 15h10' stroke='red' stroke-linecap='round' stroke-width='4'/>"
                          "<rect x='10' y='10' width='10' height='10'/></g>")
            << Row{4 * std::numbers::pi, 100} << Row{.5, .5};
        QTest::newRow("nothing") << "<g opacity='0'>" + a + "</g>" + b << Row{100} << Row{1};
    }
    void opacityIsThatOfTheWhole()
    {
        QFETCH(const QByteArray, content);
        QFETCH(const std::vector<double>, sizes);
        QFETCH(const std::vector<double>, opacities);
        const Result<Painting> painting = readPainting(svg("viewBox='0 0 100 100'", content), "a.svg");
        QVERIFY2(painting, qPrintable(painting.error()));
        QCOMPARE(painting->strokes.size(), sizes.size());
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            const Stroke &stroke = *painting->strokes[i];
            const double size = sizeOf(areaOf(closedOutline(stroke), stroke.fill->rule));
            QVERIFY2(std::abs(size - sizes[i]) < 0.01, qPrintable(QStringLiteral("%1: %2").arg(i).arg(size)));
            QVERIFY(std::abs(double(stroke.fill->colour.opacity) - opacities[i]) < 1e-6);
        }
    }

    /// Where no brush was chosen, a stroke covers what a round pen of its width does, crisp at its edges, ends and
    /// bends.
    void strokesLookLikeThoseOfARoundPen()
    {
        const Result<Painting> painting = readPainting(
            svg("viewBox='0 0 100 100'", "<g fill='none' stroke='red' stroke-width='10' stroke-linecap='round' "
                                         "stroke-linejoin='round'><path d='M20 30h60l-30 40'/></g>"),
            "a.svg");
        QVERIFY2(painting && painting->strokes.size() == 1, qPrintable(painting ? "" : painting.error()));
        const Stroke &stroke = *painting->strokes[0];
        QVERIFY(!stroke.fill);
        const PaintSight sight(stroke, stroke.driesAt());
        const auto near = [](Point p, Point a, Point b) {
            const Point along = b - a;
            return length(p - (a + std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0) * along));
        };
        for (double x = 5; x < 95; x += 1.7)
            for (double y = 15; y < 85; y += 1.7) {
                const double distance = std::min(near({x, y}, {20, 30}, {80, 30}), near({x, y}, {80, 30}, {50, 70}));
                if (std::abs(distance - 5) < 0.6)
                    continue;
                const double opacity = sight.at({x, y}).opacity;
                QVERIFY2(distance < 5 ? opacity > 0.99 : opacity < 0.01,
                         qPrintable(QStringLiteral("%1 at (%2, %3)").arg(opacity).arg(x).arg(y)));
            }
        // So much paint takes long to draw where lines lie over each other again and again.
        const Result<Painting> crowded =
            readPainting(svg("viewBox='0 0 100 100'", "<g stroke-width='10' stroke-linecap='round' stroke='red'>" +
                                                          QByteArray("<path d='M0 50h100'/>").repeated(50) + "</g>"),
                         "a.svg");
        QVERIFY(crowded && crowded->strokes[0]->style == builtinBrushes().front().style);
        // A brush that was chosen paints as it does elsewhere.
        const Brush brush = builtinBrushes().front();
        const Result<Painting> brushed = readPainting(svg("viewBox='0 0 100 100'", line), "a.svg", &brush);
        QVERIFY(brushed && brushed->strokes[0]->style == brush.style && brushed->strokes[0]->brush == brush.name);
    }

    /// What a pen with corners, flat ends or dashes covers is an area, whose outline is exact.
    void strokesThatAreNotRoundAreAreas_data()
    {
        QTest::addColumn<QByteArray>("element");
        QTest::addColumn<double>("size"); ///< of the area, square units; 0: it is a stroke
        QTest::addColumn<QRectF>("box");
        const auto row = [](const char *name, const QByteArray &element, double size, const QRectF &box) {
            QTest::newRow(name) << element << size << box;
        };
        const double pi = std::numbers::pi;
        row("flat ends", "<path d='M20 50h40' stroke='red' stroke-width='8'/>", 320, {20, 46, 40, 8});
        row("square ends", "<path d='M20 50h40' stroke='red' stroke-width='8' stroke-linecap='square'/>", 384,
            {16, 46, 48, 8});
        row("round ends", "<path d='M20 50h40' stroke='red' stroke-width='8' stroke-linecap='round'/>", 0, {});
        row("a rectangle", "<rect x='20' y='20' width='40' height='30' fill='none' stroke='red' stroke-width='8'/>",
            48 * 38 - 32 * 22, {16, 16, 48, 38});
        row("bevels",
            "<rect x='20' y='20' width='40' height='30' fill='none' stroke='red' stroke-width='8' "
            "stroke-linejoin='bevel'/>",
            48 * 38 - 32 * 22 - 4 * 8, {16, 16, 48, 38});
        row("a circle", "<circle cx='50' cy='50' r='20' fill='none' stroke='red' stroke-width='8'/>", 0, {});
        row("an open corner", "<path d='M20 20h30v30' fill='none' stroke='red' stroke-width='4'/>", 240,
            {20, 18, 32, 32});
        row("a corner that is open though it returns",
            "<path d='M20 20h30v30h-30v-30' fill='none' stroke='red' stroke-width='4'/>", 34 * 34 - 26 * 26 - 4,
            {18, 18, 34, 34});
        row("dashes", "<path d='M20 50h40' stroke='red' stroke-width='8' stroke-dasharray='5 10'/>", 3 * 5 * 8,
            {20, 46, 35, 8});
        row("shifted dashes",
            "<path d='M20 50h40' stroke='red' stroke-width='8' stroke-dasharray='5 10' stroke-dashoffset='10'/>",
            2 * 5 * 8 + 5 * 8, {25, 46, 35, 8});
        row("dashes in em and per cent",
            "<path font-size='5' d='M20 50h40' stroke='red' stroke-width='8' stroke-dasharray='1em 10%'/>", 3 * 5 * 8,
            {20, 46, 35, 8});
        row("dashes that sum up to nothing",
            "<path d='M20 50h40' stroke='red' stroke-width='8' stroke-dasharray='0 0' stroke-linecap='round'/>", 0, {});
        row("round dashes that are negative",
            "<path d='M20 50h40' stroke='red' stroke-linecap='round' stroke-dasharray='-1 4'/>", 0, {});
        row("a dot", "<path d='M50 50z' stroke='red' stroke-width='8' stroke-linecap='square'/>", 64, {46, 46, 8, 8});
        row("a round dot", "<path d='M50 50h0' stroke='red' stroke-width='8' stroke-linecap='round'/>", 16 * pi,
            {46, 46, 8, 8});
        row("a stretched pen",
            "<path transform='scale(2 1)' d='M10 50h20' stroke='red' stroke-width='8' stroke-linecap='round'/>",
            320 + 2 * 16 * pi, {12, 46, 56, 8});
        row("a pen that does not stretch",
            "<path transform='scale(2 1)' d='M10 50h20' stroke='red' stroke-width='8' "
            "vector-effect='non-scaling-stroke'/>",
            320, {20, 46, 40, 8});
        row("a mirror", "<path transform='translate(80) scale(-1 1)' d='M20 50h40' stroke='red' stroke-width='8'/>",
            320, {20, 46, 40, 8});
    }
    void strokesThatAreNotRoundAreAreas()
    {
        QFETCH(const QByteArray, element);
        QFETCH(const double, size);
        QFETCH(const QRectF, box);
        const Result<Painting> painting = readPainting(svg("viewBox='0 0 100 100'", element), "a.svg");
        QVERIFY2(painting, qPrintable(painting.error()));
        QCOMPARE(painting->strokes.size(), std::size_t(1));
        const Stroke &stroke = *painting->strokes[0];
        QCOMPARE(bool(stroke.fill), size > 0);
        if (!stroke.fill)
            return;
        QCOMPARE(stroke.fill->colour, rybFromSrgb(1, 0, 0));
        const Area area = areaOf(closedOutline(stroke), stroke.fill->rule);
        QVERIFY2(std::abs(sizeOf(area) - size) < 0.1, qPrintable(QString::number(sizeOf(area))));
        const Rect is = area.box();
        QVERIFY2(std::abs(stroke.origin.x + is.left - box.left()) < 0.01 &&
                     std::abs(stroke.origin.y + is.top - box.top()) < 0.01 &&
                     std::abs(is.width() - box.width()) < 0.01 && std::abs(is.height() - box.height()) < 0.01,
                 qPrintable(QStringLiteral("%1 %2, %3 x %4")
                                .arg(stroke.origin.x + is.left)
                                .arg(stroke.origin.y + is.top)
                                .arg(is.width())
                                .arg(is.height())));
    }

    /// Clip paths and viewports cut areas, and strokes as far as they reach beyond.
    void clips_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<double>("size"); ///< of all areas, square units
        QTest::addColumn<int>("strokes");
        const auto row = [](const char *name, const QByteArray &content, double size, int strokes = 1) {
            QTest::newRow(name) << content << size << strokes;
        };
        const double pi = std::numbers::pi;
        const QByteArray disc = "<clipPath id='c'><circle cx='50' cy='50' r='10'/></clipPath>";
        const QByteArray rect = "<rect x='50' y='20' width='40' height='60' clip-path='url(#c)'/>";
        row("an area", disc + rect, 50 * pi);
        row("what lies within stays", disc + "<rect x='45' y='45' width='10' height='10' clip-path='url(#c)'/>", 100);
        row("what lies without goes", disc + "<rect width='9' height='9' clip-path='url(#c)'/>" + rect, 50 * pi);
        row("a group",
            disc + "<g clip-path='url(#c)'>" + QByteArray(rect).replace(" clip-path='url(#c)'", "") +
                "<rect x='10' y='20' width='40' height='60'/></g>",
            100 * pi, 2);
        row("a clip within a clip",
            disc + "<g clip-path='url(#c)'><g clip-path='url(#d)'>" + rect + "</g></g>" +
                "<clipPath id='d'><rect width='99' height='50'/></clipPath>",
            25 * pi);
        row("a clip that is clipped",
            "<clipPath id='d'><rect width='99' height='50'/></clipPath>" +
                QByteArray(disc).replace("<clipPath", "<clipPath clip-path='url(#d)'") + rect,
            25 * pi);
        row("a shape of a clip that is clipped",
            "<clipPath id='d'><rect width='99' height='50'/></clipPath>" +
                QByteArray(disc).replace("<circle", "<circle clip-path='url(#d)'") + rect,
            25 * pi);
        row("two shapes",
            "<clipPath id='c'><rect x='50' y='20' width='10' height='10'/><rect x='55' y='20' width='10' "
            "height='10'/></clipPath>" +
                rect,
            150);
        row("with holes",
            "<clipPath id='c'><path clip-rule='evenodd' d='M50 20h20v20h-20zM55 25h10v10h-10z'/></clipPath>" + rect,
            300);
        row("a share of the box",
            "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='.5' height='.25'/></clipPath>" + rect,
            300);
        row("a share of a group's box",
            "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='.5' height='.25'/></clipPath>"
            "<g clip-path='url(#c)'><path d='M10 20h20v40h-20z'/><path d='M60 60h20v40h-20z'/></g>",
            20 * 20);
        row("moved with what is clipped",
            disc + "<g transform='scale(2)'><rect x='25' width='40' height='60' "
                   "transform='translate(0 20)' clip-path='url(#c)'/></g>",
            4 * 100 * pi);
        row("through a use",
            "<defs><circle id='o' r='10'/></defs><clipPath id='c'><use href='#o' x='50' y='50'/>"
            "</clipPath>" +
                rect,
            50 * pi);
        row("hidden shapes",
            "<clipPath id='c'><circle cx='50' cy='50' r='10'/><rect width='99' height='99' "
            "visibility='hidden'/><rect width='99' height='99' display='none'/></clipPath>" +
                rect,
            50 * pi);
        row("no clip path at all", rect, 2400);
        row("a stroke",
            disc + "<path d='M0 50h99' stroke='red' stroke-linecap='round' stroke-width='2' "
                   "clip-path='url(#c)'/>",
            2 * 20 - 0.067);
        row("a nested drawing", "<svg x='10' y='10' width='20' height='20'><rect width='30' height='10'/></svg>", 200);
        row("that overflows",
            "<svg x='10' y='10' width='20' height='20' overflow='visible'><rect width='30' height='10'/></svg>", 300);
        row("a nested view box",
            "<svg x='10' y='10' width='20' height='20' viewBox='0 0 10 5'>"
            "<rect x='5' y='-50' width='50' height='500'/></svg>",
            10 * 20);
        row("a symbol",
            "<symbol id='s'><rect width='30' height='10'/></symbol>"
            "<use href='#s' x='5' width='20' height='20'/>",
            200);
        row("a drawing that is used",
            "<defs><svg id='s' width='7' height='7'><rect width='30' height='10'/></svg>"
            "</defs><use href='#s' x='5' width='20' height='20'/>",
            200);
    }
    void clips()
    {
        QFETCH(const QByteArray, content);
        QFETCH(const double, size);
        QFETCH(const int, strokes);
        const Result<LoadedDocument> read = readDocument(svg("viewBox='0 0 100 100'", content), "a.svg");
        QVERIFY2(read, qPrintable(read.error()));
        QCOMPARE(read->leftOut, QString());
        QCOMPARE(int(read->painting.strokes.size()), strokes);
        double all = 0;
        for (const StrokePtr &stroke : read->painting.strokes)
            all += stroke->fill ? sizeOf(areaOf(closedOutline(*stroke), stroke->fill->rule)) : 0;
        QVERIFY2(std::abs(all - size) < 0.002 * size + 0.02, qPrintable(QString::number(all)));
    }

    /// Markers stand at the nodes of lines: where, which way, how large, and in which colours.
    void markers_data()
    {
        QTest::addColumn<QByteArray>("marker");
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<std::vector<QRectF>>("boxes"); ///< of the markers' areas
        using Boxes = std::vector<QRectF>;
        const QByteArray box = "<rect x='0' y='-1' width='2' height='2'/>";
        const auto marker = [&](const QByteArray &attributes) {
            return "<marker id='m' overflow='visible' " + attributes + ">" + box + "</marker>";
        };
        const QByteArray path = "<path d='M10 10h20v20' fill='none' ";
        QTest::newRow("the start") << marker("") << path + "marker-start='url(#m)'/>" << Boxes{{10, 9, 2, 2}};
        QTest::newRow("the middle") << marker("") << path + "marker-mid='url(#m)'/>" << Boxes{{30, 9, 2, 2}};
        QTest::newRow("all") << marker("") << path + "marker='url(#m)'/>"
                             << Boxes{{10, 9, 2, 2}, {30, 9, 2, 2}, {30, 29, 2, 2}};
        QTest::newRow("as wide as the stroke")
            << marker("") << path + "stroke-width='3' marker-end='url(#m)'/>" << Boxes{{30, 27, 6, 6}};
        QTest::newRow("as large as it says")
            << marker("markerUnits='userSpaceOnUse'") << path + "stroke-width='3' marker-end='url(#m)'/>"
            << Boxes{{30, 29, 2, 2}};
        QTest::newRow("along the line") << marker("orient='auto'") << path + "marker-end='url(#m)'/>"
                                        << Boxes{{29, 30, 2, 2}};
        QTest::newRow("against it") << marker("orient='auto-start-reverse'") << path + "marker-start='url(#m)'/>"
                                    << Boxes{{8, 9, 2, 2}};
        QTest::newRow("turned") << marker("orient='90'") << path + "marker-start='url(#m)'/>" << Boxes{{9, 10, 2, 2}};
        QTest::newRow("its own point") << marker("refX='2' refY='1'") << path + "marker-start='url(#m)'/>"
                                       << Boxes{{8, 8, 2, 2}};
        QTest::newRow("its own units") << marker("viewBox='0 0 4 4' markerWidth='2' markerHeight='2' refX='2'")
                                       << path + "marker-start='url(#m)'/>" << Boxes{{9, 9.5, 1, 1}};
        QTest::newRow("cut off") << QByteArray("<marker id='m'>") + box + "</marker>"
                                 << path + "marker-start='url(#m)'/>" << Boxes{{10, 10, 2, 1}};
        QTest::newRow("nodes of a polygon") << marker("")
                                            << QByteArray("<polygon points='10,10 30,10 30,30' fill='none' "
                                                          "marker-end='url(#m)'/>")
                                            << Boxes{{10, 9, 2, 2}};
        QTest::newRow("none on other shapes")
            << marker("") << QByteArray("<rect width='9' height='9' marker-end='url(#m)'/>") << Boxes{{0, 0, 9, 9}};
    }
    void markers()
    {
        QFETCH(const QByteArray, marker);
        QFETCH(const QByteArray, line);
        QFETCH(const std::vector<QRectF>, boxes);
        const Result<LoadedDocument> read = readDocument(svg("viewBox='0 0 100 100'", marker + line), "a.svg");
        QVERIFY2(read, qPrintable(read.error()));
        QCOMPARE(read->leftOut, QString());
        QCOMPARE(read->painting.strokes.size(), boxes.size());
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const Stroke &stroke = *read->painting.strokes[i];
            const Rect box = areaOf(closedOutline(stroke), stroke.fill->rule).box();
            const QRectF is(stroke.origin.x + box.left, stroke.origin.y + box.top, box.width(), box.height());
            const QRectF &wanted = boxes[i];
            QVERIFY2(
                std::abs(is.x() - wanted.x()) + std::abs(is.y() - wanted.y()) + std::abs(is.width() - wanted.width()) +
                        std::abs(is.height() - wanted.height()) <
                    1e-3,
                qPrintable(QStringLiteral("%1, %2; %3 x %4").arg(is.x()).arg(is.y()).arg(is.width()).arg(is.height())));
        }
    }

    void paintsOfTheContextAndTheirOrder()
    {
        const auto read = [](const QByteArray &content) {
            const Result<Painting> painting = readPainting(svg("viewBox='0 0 100 100'", content), "a.svg");
            return painting ? painting->strokes : StrokeList();
        };
        const StrokeList used = read("<defs><rect id='r' width='9' height='9' fill='context-stroke'/></defs>"
                                     "<use href='#r' stroke='red'/>");
        QVERIFY(!used.empty());
        QCOMPARE(used[0]->fill->colour, rybFromSrgb(1, 0, 0));
        const StrokeList marked = read("<marker id='m'><rect width='2' height='2' fill='context-stroke'/></marker>"
                                       "<path d='M9 9h9' stroke='blue' stroke-linecap='round' marker-end='url(#m)'/>");
        QCOMPARE(marked.size(), std::size_t(2));
        QCOMPARE(marked[1]->fill->colour, rybFromSrgb(0, 0, 1));
        QVERIFY(read("<rect width='9' height='9' fill='context-fill'/>").empty()); // There is no context.
        for (const auto &[order, first] : {std::pair("normal", rybFromSrgb(0, 1, 0)),
                                           {"stroke", rybFromSrgb(1, 0, 0)},
                                           {"markers stroke fill", rybFromSrgb(1, 0, 0)},
                                           {"fill stroke", rybFromSrgb(0, 1, 0)}}) {
            const StrokeList ordered =
                read(QByteArray("<rect width='9' height='9' fill='#0f0' stroke='red' paint-order='") + order + "'/>");
            QCOMPARE(ordered.size(), std::size_t(2));
            QCOMPARE(ordered[0]->fill->colour, first);
        }
    }

    /// Of a <switch> the first child that can be drawn is.
    void switches()
    {
        const auto names = [](const QByteArray &content) {
            const Result<LoadedDocument> read = readDocument(svg("viewBox='0 0 100 100'", content), "a.svg");
            QStringList names;
            if (read)
                for (const StrokePtr &stroke : read->painting.strokes)
                    names << stroke->name;
            return names.join(' ') + (read ? read->leftOut : read.error());
        };
        const auto rect = [](const QByteArray &attributes) {
            return "<rect width='9' height='9' " + attributes + "/>";
        };
        QCOMPARE(names("<switch><foreignObject requiredExtensions='http://ns.adobe.com/'/>" + rect("id='a'") +
                       rect("id='b'") + "</switch>"),
                 QString("a"));
        QCOMPARE(names("<switch>" + rect("id='a' systemLanguage='de, is'") + rect("id='b' systemLanguage='de, en-GB'") +
                       rect("id='c'") + "</switch>"),
                 QString("b"));
        QCOMPARE(names("<g>" + rect("id='a' systemLanguage='de'") + rect("id='b' systemLanguage='en'") + "</g>"),
                 QString("b"));
    }

    void clippingStopsWhereItMust()
    {
        // A clip path that clips itself shows nothing; a stroke that is whole within its clip stays a stroke.
        const QByteArray disc = "<clipPath id='c'><circle cx='50' cy='50' r='30'/></clipPath>";
        const auto read = [](const QByteArray &content) {
            return readPainting(svg("viewBox='0 0 100 100'", content), "a.svg");
        };
        QVERIFY(!read("<clipPath id='c' clip-path='url(#c)'><rect width='9' height='9'/></clipPath>"
                      "<rect width='9' height='9' clip-path='url(#c)'/>"));
        const Result<Painting> whole = read(disc + "<path d='M40 50h20' stroke='red' stroke-linecap='round' "
                                                   "stroke-width='4' clip-path='url(#c)'/>");
        QVERIFY(whole && whole->strokes.size() == 1 && !whole->strokes[0]->fill);
        QCOMPARE(whole->strokes[0]->segments.size(), std::size_t(1));
    }

    void groupsAndNamesComeAlong()
    {
        const Result<Painting> painting =
            readPainting(svg("stroke-linecap=\"round\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"",
                             "<g id=\"layer1\" inkscape:label=\"Trees\"><path id=\"oak\" d=\"M0 0h9\" stroke=\"red\"/>"
                             "<g id=\"Two_x20_birches\"><g><path id=\"path7\" d=\"M0 0h9\" "
                             "stroke=\"red\"><title>left\n one</title></path>"
                             "</g><path data-name=\"right one\" id=\"a\" d=\"M0 0h9M0 9h9\" stroke=\"red\"/></g></g>"
                             "<g id=\"empty\"/><g id=\"alone\"><g><line x2=\"9\" stroke=\"red\"/></g></g>"
                             "<g id=\"used\"><use id=\"copy\" href=\"#layer1\"/></g>"),
                         "a.svg");
        QVERIFY2(painting, qPrintable(painting.error()));
        QCOMPARE(problemOf(*painting), QString());
        QStringList names, groups;
        for (const StrokePtr &stroke : painting->strokes)
            names << stroke->name;
        for (const Group &group : painting->groups)
            groups << group.name +
                          (group.parent ? " in " + painting->groups[std::size_t(group.parent - 1)].name : QString());
        const QStringList four{"oak", "left one", "right one", "right one"};
        QCOMPARE(names, four + QStringList{"alone"} + four);
        QCOMPARE(groups, QStringList({"Trees", "Two birches in Trees", "right one in Two birches", "copy",
                                      "Two birches in copy", "right one in Two birches"}));
        QCOMPARE(painting->strokes[0]->group, GroupId(1));
        QCOMPARE(painting->strokes[1]->group, GroupId(2));
        QCOMPARE(painting->strokes[2]->group, GroupId(3));
        QCOMPARE(painting->strokes[4]->group, GroupId(0));
        QCOMPARE(painting->strokes[8]->group, GroupId(6));
    }

    /// What a shape fills and its outline are taken as one thing.
    void fillAndStrokeOfAShapeAreAGroup()
    {
        const auto read = [](const QByteArray &shapes) {
            const Result<Painting> painting = readPainting(svg("viewBox='0 0 99 99'", shapes), "a.svg");
            return painting ? *painting : Painting();
        };
        const Painting both = read("<g id='sea'><circle id='buoy' r='9' fill='#fc0' stroke='red'/>"
                                   "<circle id='moon' r='9' fill='#ccc'/></g>");
        QCOMPARE(both.strokes.size(), std::size_t(3));
        QCOMPARE(both.groups.size(), std::size_t(2));
        QCOMPARE(both.groups[1].name, QString("buoy"));
        QCOMPARE(both.groups[1].parent, both.groups[0].id);
        QVERIFY(both.strokes[0]->fill && !both.strokes[1]->fill);
        QVERIFY(both.strokes[0]->group == both.groups[1].id && both.strokes[1]->group == both.groups[1].id);
        QCOMPARE(both.strokes[2]->group, both.groups[0].id);
        const Painting one = read("<circle id='moon' r='9' fill='#ccc'/>");
        QVERIFY(one.strokes.size() == 1 && one.groups.empty());
        // The stack of a gradient is a group within that of the shape.
        const Painting ball = read("<radialGradient id='g'><stop/><stop offset='1' stop-color='#fff'/></radialGradient>"
                                   "<circle id='ball' r='9' fill='url(#g)' stroke='red'/>");
        QCOMPARE(ball.groups.size(), std::size_t(2));
        QCOMPARE(ball.groups[1].parent, ball.groups[0].id);
        QCOMPARE(ball.strokes.front()->group, ball.groups[1].id);
        QCOMPARE(ball.strokes.back()->group, ball.groups[0].id);
        // A group's opacity divides the fill below the outline, which stays in the group.
        const Painting faded = read("<circle id='buoy' r='9' fill='#fc0' stroke='red' opacity='0.5'/>");
        QCOMPARE(faded.groups.size(), std::size_t(1));
        for (const StrokePtr &stroke : faded.strokes)
            QCOMPARE(stroke->group, faded.groups[0].id);
    }

    void whatUsesItselfIsLeftOut()
    {
        // Each <use> that would lead back to itself is left out wherever it stands; all else is drawn once.
        QByteArray rings;
        for (int i = 0; i < 10; ++i) {
            rings += "<g id=\"g" + QByteArray::number(i) + "\">" + line;
            for (int k = 0; k < 10; ++k)
                rings += "<use href=\"#g" + QByteArray::number(k) + "\" x=\"1\"/>";
            rings += "</g>";
        }
        const Result<LoadedDocument> document = readDocument(svg("", rings), "a.svg");
        QVERIFY2(document, qPrintable(document.error()));
        QCOMPARE(document->painting.strokes.size(), std::size_t(10));
        QCOMPARE(document->leftOut, QString("100 <use> of itself were left out."));

        const Result<LoadedDocument> harmless =
            readDocument(svg("", "<defs><g id=\"a\">" + line + "<use href=\"#b\"/></g></defs><g id=\"b\">" + line +
                                     "</g><use href=\"#a\"/>"),
                         "a.svg");
        QVERIFY2(harmless, qPrintable(harmless.error()));
        QCOMPARE(harmless->painting.strokes.size(), std::size_t(3));
        QCOMPARE(harmless->leftOut, QString());

        QByteArray doubling = "<defs><g id=\"a0\">" + line + "</g>";
        for (int i = 1; i <= 40; ++i)
            doubling +=
                QStringLiteral("<g id='a%1'><use href='#a%2'/><use href='#a%2'/></g>").arg(i).arg(i - 1).toLatin1();
        const Result<LoadedDocument> cut = readDocument(svg("", doubling + "</defs><use href=\"#a40\"/>"), "a.svg");
        QVERIFY2(cut, qPrintable(cut.error()));
        QVERIFY(cut->painting.strokes.size() < 50'000);
        QVERIFY2(cut->leftOut.startsWith("There is more in the drawing"), qPrintable(cut->leftOut));
    }

    void mistakesAreNamed()
    {
        QCOMPARE(errorOf("<svg>\n<path").left(26), QString("folder/a.svg: SVG, line 2:"));
        QVERIFY(errorOf(svg("", "<text>words</text>")).startsWith("folder/a.svg: holds no paths"));
        QVERIFY(errorOf(svg("width=\"2000000\" height=\"9\"", line)).contains("at most 1e6"));
        QVERIFY(errorOf(svg("viewBox=\"0 0 1e308 1e308\" width=\"1\"", line))
                    .startsWith("folder/a.svg: holds no paths")); // a point
        QVERIFY(errorOf(svg("viewBox=\"-1e308 0 1e308 1\"", line)).startsWith("folder/a.svg: "));
        QVERIFY(errorOf("<svg>" + QByteArray(65 << 20, ' ') + "</svg>").contains("64 MB"));
    }
};

QTEST_GUILESS_MAIN(TestSvgPainting)
#include "test_svg_painting.moc"
