// SVG drawings come in as strokes: where they lie, how large, how wide, in which colour.
#include "model/formats/files.h"
#include "model/formats/svg/svg_painting.h"
#include "model/paint/half_width.h"
#include "model/paint/seen_paint.h"
#include "model/painting/ryb.h"
#include "model/painting/validate.h"
#include "tests/model/formats/svg_text.h"

#include <QTest>

using namespace suffuse;
using test::svg;

namespace {

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
    /// A drawing that is 210 mm wide is so large on paper, where 96 units are an inch. Of one in pixels nobody knows.
    void theSizeOnPaperIsKept()
    {
        const auto unitsOfInch = [](const QByteArray &size) {
            const QByteArray bytes = "<svg xmlns=\"http://www.w3.org/2000/svg\" " + size + ">" + line + "</svg>";
            const Result<LoadedDocument> read = readDocument(bytes, QStringLiteral("a.svg"));
            return read ? read->extras.resolution : -1;
        };
        QCOMPARE(unitsOfInch("width=\"210mm\" height=\"148mm\" viewBox=\"0 0 210 148\""), 96.0);
        QCOMPARE(unitsOfInch("height=\"5in\" viewBox=\"0 0 10 10\""), 96.0);
        QCOMPARE(unitsOfInch("width=\"210\" height=\"148\""), 0.0);
        QCOMPARE(unitsOfInch("width=\"210px\" height=\"100%\" viewBox=\"0 0 210 148\""), 0.0);
        QCOMPARE(unitsOfInch("viewBox=\"0 0 210 148\""), 0.0);
    }

    void isFoundFromItsContent()
    {
        QCOMPARE(detectFormat(svg("", line)), FileFormat::Svg);
        QCOMPARE(detectFormat("<svg/>"), FileFormat::Svg);
        QCOMPARE(detectFormat("\xef\xbb\xbf\n<!-- " + QByteArray(20'000, '-') + " --><svg/>"), FileFormat::Svg);
        QCOMPARE(detectFormat("<curve_set/><!-- <svg/> -->"), FileFormat::DiffusionCurves);
        QCOMPARE(detectFormat("<html/>"), FileFormat::Unknown);
        QCOMPARE(formatForSaving("a.svg"), FileFormat::Unknown);
        QVERIFY(errorOf("<html/>").contains("SVG"));
        QVERIFY(errorOf("\x1f\x8b\x08").contains("Unpack"));
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
        QCOMPARE(leftOut("<g style=\"mix-blend-mode:plus-darker\">" + line + "</g>"),
                 QString("1 blend mode(s) were left out."));
        QCOMPARE(leftOut("<g style=\"mix-blend-mode:multiply\">" + line + "</g>"), QString());
        QCOMPARE(leftOut("<g style=\"mix-blend-mode:normal\">" + line + "</g>"), QString());
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
