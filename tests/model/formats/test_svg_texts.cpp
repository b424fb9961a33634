// Texts of drawings: which letter stands where, by a font of boxes; that what looks alike can be typed in again; and
// that what is lost is said.
#include "model/area/outline.h"
#include "model/formats/files.h"
#include "model/formats/svg/svg_painting.h"
#include "model/painting/ryb.h"
#include "model/painting/validate.h"
#include "tests/model/box_letters.h"

#include <QTest>

#include <numbers>

using namespace suffuse;

namespace {

QByteArray svg(const QByteArray &content)
{
    return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' viewBox='0 0 100 100' "
           "font-size='10' font-family='Boxes'>" +
           content + "</svg>";
}

SvgDrawing drawn(const QByteArray &content)
{
    Result<SvgDrawing> drawing = readSvgDrawing(svg(content));
    return drawing ? std::move(*drawing) : SvgDrawing();
}

/// Where the letters' cells begin on their baselines: the boxes' lower left corner less the room before it.
std::vector<Point> places(const QByteArray &content, double size = 10)
{
    std::vector<Point> at;
    for (const SvgPath &path : drawn(content).paths) {
        Rect box;
        for (const Cubic &curve : path.curves)
            box = box.united(curve.controlBox());
        at.push_back({box.left - BoxLetters::left * size, box.bottom});
    }
    return at;
}

bool areNear(const std::vector<Point> &a, const std::vector<Point> &b)
{
    const bool same =
        a.size() == b.size() && std::ranges::equal(a, b, [](Point p, Point q) { return length(p - q) < 1e-9; });
    if (!same)
        for (const Point p : a)
            qWarning("%.10g %.10g", p.x, p.y);
    return same;
}

SharedText textIn(const QByteArray &content)
{
    const SvgDrawing drawing = drawn(content);
    for (const SvgGroup &group : drawing.groups)
        if (group.text)
            return group.text;
    return {};
}

} // namespace

class TestSvgTexts : public QObject {
    Q_OBJECT

private slots:
    void lettersStandWhereTheyAreSaidTo()
    {
        BoxLetters font;
        QVERIFY(areNear(places("<text x='20' y='30'>ab c</text>"), {{20, 30}, {25, 30}, {35, 30}}));
        QVERIFY(areNear(places("<text x='20' y='30' dx='1 2' dy='0 3 -3'>abc</text>"), {{21, 30}, {28, 33}, {33, 30}}));
        QVERIFY(areNear(places("<text x='20,40 50' y='30 31'>abcd</text>"), {{20, 30}, {40, 31}, {50, 31}, {55, 31}}));
        // A place after a shift is that place.
        QVERIFY(areNear(places("<text x='20' dx='7' y='30'>a<tspan x='50'>b</tspan></text>"), {{27, 30}, {50, 30}}));
        QVERIFY(areNear(places("<text x='1em' y='10%'>a</text>"), {{10, 10}}));
        QVERIFY(areNear(places("<text x='20' y='30' transform='translate(5 6) scale(2)'>ab</text>", 20),
                        {{45, 66}, {55, 66}}));
        QVERIFY(
            areNear(places("<text x='20' y='30'>a<tspan dy='-2'>b</tspan>c</text>"), {{20, 30}, {25, 28}, {30, 28}}));
        // Lists of the outer element count for characters of the inner one, and the inner one's go before them.
        QVERIFY(
            areNear(places("<text x='10 20 30' y='5'>a<tspan x='50'>bc</tspan></text>"), {{10, 5}, {50, 5}, {30, 5}}));
        // A pair of surrogates is one character.
        QVERIFY(areNear(places("<text x='10 20 30' y='5'>\xf0\x9d\x94\xb8"
                               "bc</text>"),
                        {{10, 5}, {20, 5}, {30, 5}}));
        // The second character of a ligature has no place of its own.
        QCOMPARE(places("<text x='10' dx='0 9' y='5'>fix</text>").size(), std::size_t(2));
        QVERIFY(areNear(places("<defs><text id='t' x='1' y='2'>a</text></defs><use xlink:href='#t' x='10' y='20'/>"),
                        {{11, 22}}));
    }

    void anchorsCountForEachChunk()
    {
        BoxLetters font;
        QVERIFY(areNear(places("<text x='50' y='30' text-anchor='middle'>abcd</text>"),
                        {{40, 30}, {45, 30}, {50, 30}, {55, 30}}));
        QVERIFY(areNear(places("<text x='50' y='30' style='text-anchor:end'>ab<tspan x='90'>cd</tspan></text>"),
                        {{40, 30}, {45, 30}, {80, 30}, {85, 30}}));
        QVERIFY(areNear(places("<text x='50' y='30' text-anchor='end'>a<tspan font-weight='bold'>b</tspan></text>"),
                        {{40, 30}, {45, 30}}));
        // Hebrew: the first letter stands on the right. What is the start is said by `direction` alone.
        QVERIFY(areNear(places("<text x='50' y='30'>\xd7\x90\xd7\x91</text>"), {{55, 30}, {50, 30}}));
        QVERIFY(areNear(places("<text x='50' y='30' direction='rtl'>\xd7\x90\xd7\x91</text>"), {{45, 30}, {40, 30}}));
    }

    void spacesAreCollapsed()
    {
        BoxLetters font;
        QVERIFY(areNear(places("<text x='20' y='30'>\n   a \n\t b\n</text>"), {{20, 30}, {30, 30}}));
        QVERIFY(areNear(places("<text x='20' y='30'>a <tspan> b</tspan></text>"), {{20, 30}, {30, 30}}));
        QVERIFY(areNear(places("<text x='20' y='30' xml:space='preserve'> a  b</text>"), {{25, 30}, {40, 30}}));
        QVERIFY(areNear(places("<text x='20' y='30' style='white-space:pre'> a</text>"), {{25, 30}}));
        // The space at the end takes no room.
        QVERIFY(areNear(places("<text x='20' y='30' text-anchor='end'>a </text>"), {{15, 30}}));
        QVERIFY(drawn("<text x='20'>  <!-- nothing --> </text>").paths.empty());
        QCOMPARE(drawn("<text x='20'>  </text>").losses.texts, 0);
    }

    void spacingLengthsAndTurns()
    {
        BoxLetters font;
        QVERIFY(areNear(places("<text y='30' letter-spacing='2'>abc</text>"), {{0, 30}, {7, 30}, {14, 30}}));
        QVERIFY(areNear(places("<text y='30' letter-spacing='.1em' word-spacing='3'>a b</text>"), {{0, 30}, {15, 30}}));
        QCOMPARE(places("<text letter-spacing='1'>fi</text>").size(), std::size_t(2)); // no ligature
        QVERIFY(areNear(places("<text x='10' y='30' textLength='35'>abc<tspan>d</tspan></text>"),
                        {{10, 30}, {20, 30}, {30, 30}, {40, 30}}));
        const SvgDrawing wide =
            drawn("<text x='10' y='30' textLength='40' lengthAdjust='spacingAndGlyphs'>abcd</text>");
        QCOMPARE(wide.paths.size(), std::size_t(4));
        Rect box;
        for (const Cubic &curve : wide.paths[3].curves)
            box = box.united(curve.controlBox());
        QVERIFY(std::abs(box.left - (40 + 2 * 0.5)) < 1e-9 && std::abs(box.width() - 8) < 1e-9 &&
                std::abs(box.height() - 7) < 1e-9);
        QVERIFY(areNear(places("<text x='10' y='30' textLength='20'><tspan>ab</tspan></text><text y='9'>c</text>"),
                        {{10, 30}, {25, 30}, {0, 9}}));

        // A quarter turn about where the letter begins: its box lies below that.
        const SvgDrawing turned = drawn("<text x='20' y='30' rotate='90 0'>abc</text>");
        Rect first, last;
        for (const Cubic &curve : turned.paths[0].curves)
            first = first.united(curve.controlBox());
        for (const Cubic &curve : turned.paths[2].curves)
            last = last.united(curve.controlBox());
        QVERIFY(std::abs(first.left - 20) < 1e-9 && std::abs(first.right - 27) < 1e-9 &&
                std::abs(first.top - 30.5) < 1e-9 && std::abs(first.bottom - 34.5) < 1e-9);
        QVERIFY(std::abs(last.left - 30.5) < 1e-9 && std::abs(last.bottom - 30) < 1e-9);
    }

    void baselinesAndLines()
    {
        BoxLetters font;
        QVERIFY(areNear(places("<text y='30' dominant-baseline='middle'>a</text>"), {{0, 32.5}}));
        QVERIFY(areNear(places("<text y='30' dominant-baseline='central'>a</text>"), {{0, 33}}));
        QVERIFY(areNear(places("<text y='30' dominant-baseline='hanging'>a</text>"), {{0, 36.4}}));
        QVERIFY(areNear(places("<text y='30' dominant-baseline='text-after-edge'>a</text>"), {{0, 28}}));
        QVERIFY(
            areNear(places("<text y='30'>a<tspan baseline-shift='4'>b</tspan>c</text>"), {{0, 30}, {5, 26}, {10, 30}}));
        QVERIFY(areNear(places("<text y='30'>a<tspan baseline-shift='-20%'>b</tspan></text>"), {{0, 30}, {5, 32}}));
        const SvgDrawing under = drawn("<text x='20' y='30' text-decoration='underline'>a b</text>");
        QCOMPARE(under.paths.size(), std::size_t(3));
        Rect line;
        for (const Cubic &curve : under.paths[2].curves)
            line = line.united(curve.controlBox());
        QVERIFY(std::abs(line.left - 20) < 1e-9 && std::abs(line.right - 35) < 1e-9 &&
                std::abs(line.top - 30.8) < 1e-9 && std::abs(line.bottom - 31.2) < 1e-9);
        QVERIFY(under.groups.front().name == "a b" && !under.groups.front().text);
    }

    /// A group is called by its words, which are apart where they have places of their own.
    void namesHaveSpacesBetweenWords()
    {
        BoxLetters font;
        const auto name = [](const QByteArray &spans) { // underlined, so that it cannot be typed in again
            const SvgDrawing drawing = drawn("<text y='30' text-decoration='underline'>" + spans + "</text>");
            return drawing.groups.empty() ? QString() : drawing.groups.front().name;
        };
        QCOMPARE(name("<tspan x='0' y='20'>Hello</tspan><tspan x='0' y='40'>World</tspan>"), QString("Hello World"));
        QCOMPARE(name("<tspan x='0'>Hello</tspan><tspan x='0' dy='12'>World</tspan>"), QString("Hello World"));
        QCOMPARE(name("<tspan x='0'>Hello</tspan><tspan x='50'>World</tspan>"), QString("Hello World"));
        QCOMPARE(name("<tspan x='0' y='20'>A</tspan><tspan x='0' y='40'>B</tspan>"), QString("A B"));
        QCOMPARE(name("Hel<tspan fill='red'>lo</tspan>"), QString("Hello"));
        QCOMPARE(name("<tspan x='0 5 10 15 20' y='30 30 30 30 30'>Hello</tspan>"), QString("Hello"));
    }

    void lettersFollowLines()
    {
        BoxLetters font;
        const QByteArray path = "<defs><path id='p' d='M10 50H30V90'/></defs>"; // 20 to the right, then 40 down
        // The middle of each letter decides: 2.5 and 7.5 along, then 22.5, which is 2.5 below the corner.
        QVERIFY(areNear(places(path + "<text><textPath href='#p'>ab</textPath></text>"), {{10, 50}, {15, 50}}));
        const SvgDrawing down = drawn(path + "<text><textPath xlink:href='#p' startOffset='50%'>a</textPath></text>");
        Rect box;
        for (const Cubic &curve : down.paths.front().curves)
            box = box.united(curve.controlBox());
        QVERIFY(std::abs(box.left - 30) < 1e-6 && std::abs(box.right - 37) < 1e-6 && // on its right side: y is down
                std::abs(box.top - 60.5) < 1e-6 && std::abs(box.bottom - 64.5) < 1e-6);
        // What does not fit on the line is not seen, and what refers to nothing neither.
        QCOMPARE(places(path + "<text><textPath href='#p' startOffset='54'>abc</textPath></text>").size(),
                 std::size_t(1));
        QVERIFY(places("<text><textPath href='#none'>ab</textPath></text>").empty());
        QVERIFY(areNear(places(path + "<text text-anchor='middle'><textPath href='#p' startOffset='10'>ab"
                                      "</textPath></text>"),
                        {{15, 50}, {20, 50}}));
        const SharedText text = textIn(path + "<text><textPath href='#p'>ab</textPath></text>");
        QVERIFY(text && text->curve.size() == 2 && text->string == "ab");
        // Where it starts elsewhere, it stands on the part of the line that begins there, ends there or has its middle
        // there.
        const auto curveOf = [&](const QByteArray &attributes, const QByteArray &offset) {
            const SharedText set = textIn(path + "<text " + attributes + "><textPath href='#p' startOffset='" + offset +
                                          "'>ab</textPath></text>");
            return set && !set->curve.empty() ? std::pair(set->curve.front().p[0], set->curve.back().p[3])
                                              : std::pair(Point{-1, -1}, Point{-1, -1});
        };
        const auto isFromTo = [](const std::pair<Point, Point> &ends, Point from, Point to) {
            return length(ends.first - from) < 1e-6 && length(ends.second - to) < 1e-6;
        };
        QVERIFY(isFromTo(curveOf("", "5"), {15, 50}, {30, 90}));
        QVERIFY(isFromTo(curveOf("", "25%"), {25, 50}, {30, 90}));
        QVERIFY(isFromTo(curveOf("text-anchor='middle'", "15"), {10, 50}, {30, 60}));
        QVERIFY(isFromTo(curveOf("text-anchor='middle'", "45"), {30, 60}, {30, 90}));
        QVERIFY(isFromTo(curveOf("text-anchor='end'", "20"), {10, 50}, {30, 50}));
        QVERIFY(isFromTo(curveOf("x='5'", "0"), {15, 50}, {30, 90}));
        QVERIFY(!textIn(path + "<text><textPath href='#p' startOffset='-2'>ab</textPath></text>"));
        QVERIFY(!textIn(path + "<text><textPath href='#p' startOffset='54'>abc</textPath></text>"));
    }

    void plainTextsCanBeTypedInAgain()
    {
        BoxLetters font;
        const SharedText one = textIn("<g transform='translate(3 4)'><text id='title' x='20' y='30' font-weight='bold' "
                                      "font-style='italic' text-anchor='middle' letter-spacing='2'>ab</text></g>");
        QVERIFY(one);
        QCOMPARE(one->string, QString("ab"));
        QCOMPARE(one->family, QString("Boxes"));
        QVERIFY(one->weight == 700 && one->italic && one->size == 10 && one->letterSpacing == 0.2f);
        QVERIFY(one->alignment == TextAlignment::Centre && one->place == Affine::translation({23, 34}));
        // As Inkscape writes lines, an empty one among them.
        const SharedText lines = textIn("<text xml:space='preserve' x='20' y='30'><tspan x='20' y='30'>ab</tspan>"
                                        "<tspan x='20' y='42.5'>cd</tspan><tspan x='20' y='67.5'>e</tspan></text>");
        QVERIFY(lines);
        QCOMPARE(lines->string, QString("ab\ncd\n\ne"));
        QCOMPARE(lines->lineHeight, 1.25f);
        // Writing from the right to the left begins at its place if the drawing says so, else ends there.
        QVERIFY(textIn("<text x='9'>\xd7\x90</text>")->alignment == TextAlignment::End);
        QVERIFY(textIn("<text x='9' direction='rtl'>\xd7\x90</text>")->alignment == TextAlignment::Start);

        for (const char *other :
             {"<text>a<tspan fill='red'>b</tspan></text>", "<text dx='0 1'>ab</text>", "<text rotate='5'>ab</text>",
              "<text stroke='red'>ab</text>", "<text textLength='50'>ab</text>", "<text x='0 9'>ab</text>",
              "<text>ab<tspan x='20' y='30'>cd</tspan></text>", "<text text-decoration='underline'>ab</text>",
              "<text word-spacing='3'>a b</text>", "<text fill='none' stroke='red'>ab</text>",
              "<text opacity='.5' letter-spacing='-3'>ab</text>",
              "<clipPath id='c'><circle r='9'/></clipPath><text clip-path='url(#c)' y='5'>ab</text>",
              "<linearGradient id='g'><stop stop-color='red'/><stop offset='1'/></linearGradient>"
              "<text fill='url(#g)'>ab</text>",
              "<text font-variant='small-caps'>ab</text>"})
            QVERIFY2(!textIn(other) && !drawn(other).paths.empty(), other);
        // What is said twice alike is one look.
        QVERIFY(textIn("<text fill='red'>a<tspan fill='red'>b</tspan></text>"));
    }

    void paintingsKnowTheirTexts()
    {
        BoxLetters font;
        const Result<Painting> painting =
            readPainting("<svg xmlns='http://www.w3.org/2000/svg' width='200' viewBox='10 20 100 100' font-size='10'>"
                         "<text x='20' y='30' fill='#123'>a b</text><text x='60' y='60'>c</text></svg>",
                         "a.svg");
        QVERIFY2(painting, qPrintable(painting ? QString() : painting.error()));
        QCOMPARE(painting->strokes.size(), std::size_t(3));
        QCOMPARE(painting->groups.size(), std::size_t(2));
        const Group &group = painting->groups.front();
        QVERIFY(group.text && painting->groups[1].text);
        QCOMPARE(group.text->place, Affine::scaling({}, 2, 2) * Affine::translation({10, 10}));
        QCOMPARE(group.text->string, QString("a b"));
        QCOMPARE(painting->strokes[0]->name, QString("a"));
        QCOMPARE(painting->strokes[1]->group, group.id);
        QCOMPARE(painting->strokes[0]->fill->colour, rybFromSrgb(0x11 / 255.0, 0x22 / 255.0, 0x33 / 255.0));
        QVERIFY(painting->strokes[0]->fill->diffusion == 0);
        QCOMPARE(problemOf(*painting), QString());
    }

    void fontsAreChosen()
    {
        BoxLetters font;
        const auto asked = [&](const QByteArray &attributes) {
            font.faces.clear();
            const SvgDrawing drawing = drawn("<text " + attributes + ">a</text>");
            return std::pair(font.faces.front(), drawing.losses.fonts);
        };
        QCOMPARE(asked("font-family='Crates'").first.family, QString("Crates"));
        QCOMPARE(asked("font-family=\"'Crates', serif\"").first.family, QString("Crates"));
        QVERIFY(asked("font-family='Crates'").second.isEmpty());
        QCOMPARE(asked("font-family='Nothing, Crates'"),
                 std::pair(asked("font-family='Crates'").first, QStringList{"Nothing"}));
        QCOMPARE(asked("font-family='sans-serif'").first.family, QString("Boxes"));
        QVERIFY(asked("font-family='sans-serif'").second.isEmpty());
        QCOMPARE(asked("style='font: italic 600 12px/1.5 Crates, serif'").first,
                 (Face{QStringLiteral("Crates"), 600, true, false}));
        QCOMPARE(asked("font-family='Boxes' font-stretch='condensed'").first.family, QString("Boxes Condensed"));
        QCOMPARE(asked("font-family='Boxes' style='font-stretch:75%'").first.family, QString("Boxes Condensed"));
        QCOMPARE(asked("font-family='Boxes' font-stretch='expanded'").first.family, QString("Boxes"));
        QCOMPARE(asked("font-family='Crates' font-stretch='condensed'").first.family, QString("Crates"));
        QVERIFY(asked("font-family='Crates' font-stretch='condensed'").second.isEmpty());
        QVERIFY(asked("font-variant='small-caps'").first.hasSmallCaps);
        QVERIFY(!asked("font-variant='small-caps' style='font-variant: normal'").first.hasSmallCaps);
        QCOMPARE(asked("style='font: small-caps condensed 12px Boxes'").first,
                 (Face{QStringLiteral("Boxes Condensed"), 400, false, false, false, true}));
        QVERIFY(!asked("font-variant='small-caps' style='font: 12px Boxes'").first.hasSmallCaps);
        QCOMPARE(asked("style='font-weight:bolder'").first.weight, 700.f);
        QCOMPARE(places("<text style='font: 20px Boxes' x='1' y='9'>ab</text>", 20)[1], (Point{11, 9}));
        QCOMPARE(leftOutOf(drawn("<text font-family='Nothing'>a</text>")),
                 QString("Other fonts stand in for those that are not installed: Nothing."));
    }

    void lettersClipAndTakeGradientsAsOne()
    {
        BoxLetters font;
        // A letter as a clip: of the square its box is left.
        const SvgDrawing clipped = drawn("<clipPath id='c'><text x='20' y='30'>a</text></clipPath>"
                                         "<rect width='99' height='99' clip-path='url(#c)'/>");
        QCOMPARE(clipped.paths.size(), std::size_t(1));
        Rect box;
        for (const Cubic &curve : clipped.paths.front().curves)
            box = box.united(curve.controlBox());
        QVERIFY(std::abs(box.left - 20.5) < 1e-6 && std::abs(box.right - 24.5) < 1e-6 &&
                std::abs(box.top - 23) < 1e-6 && std::abs(box.bottom - 30) < 1e-6);
        // The gradient runs over the whole text, from its first cell to its last.
        const SvgDrawing shaded =
            drawn("<linearGradient id='g'><stop stop-color='#888'/><stop offset='1' stop-color='#999'/>"
                  "</linearGradient><text x='20' y='30' fill='url(#g)'>abcd</text>");
        QCOMPARE(shaded.paths.size(), std::size_t(4));
        for (const SvgPath &path : shaded.paths)
            QVERIFY(path.shade && std::abs(path.shade->from.x - 20) < 1e-9 && std::abs(path.shade->to.x - 40) < 1e-9);
    }

    void whatIsLostIsSaid()
    {
        const QByteArray text = "<text x='1' y='9'>a</text><path d='M0 0h9v9z'/>";
        QCOMPARE(drawn(text).losses.texts, 1); // Nobody knows fonts.
        QCOMPARE(drawn(text).paths.size(), std::size_t(1));
        BoxLetters font;
        QCOMPARE(drawn(text).losses.texts, 0);
        QCOMPARE(drawn(text).paths.size(), std::size_t(2));
        QCOMPARE(drawn("<text writing-mode='tb'>a</text>").losses.texts, 1);
        QCOMPARE(drawn("<text display='none' writing-mode='tb'>a</text>").losses.texts, 0);
        QVERIFY(drawn("<text display='none'>a</text><text visibility='hidden'>b</text>").paths.empty());
        QCOMPARE(
            drawn("<text>a<tspan display='none'>b</tspan><tspan visibility='hidden'>c</tspan>d</text>").paths.size(),
            std::size_t(2));
    }

    /// A text of many characters, of many spans, and deep ones: bounded, and said where it is.
    void longTextsAreBounded()
    {
        BoxLetters font;
        const SvgDrawing drawing = drawn("<text>" + QByteArray(150'000, 'a') + "</text>");
        QCOMPARE(drawing.paths.size(), std::size_t(100'000));
        QVERIFY(drawing.losses.isCut);
        QByteArray spans = "<text>";
        for (int i = 0; i < 20'000; ++i)
            spans += i % 2 ? "<tspan dx='1' fill='red'>a</tspan>" : "<tspan fill='blue' rotate='5'>b</tspan>";
        QCOMPARE(drawn(spans + "</text>").paths.size(), std::size_t(20'000));
        QByteArray deep = "<text>";
        for (int i = 0; i < 240; ++i)
            deep += "<tspan x='1 2 3' rotate='1'>a";
        for (int i = 0; i < 240; ++i)
            deep += "</tspan>";
        QCOMPARE(drawn(deep + "</text>").paths.size(), std::size_t(240));
        for (const QByteArray &odd :
             {QByteArray("<text x='1e400 nan' y='-1e308' font-size='1e-300'>ab</text>"),
              QByteArray("<text font-size='1e300' textLength='1e300'>ab</text>"),
              QByteArray("<text textLength='-5' rotate='1e300' dx='1e308 1e308'>abc</text>"),
              QByteArray("<text id='t'><textPath href='#t'>ab</textPath></text>"),
              QByteArray("<text><text>ab</text><textPath><textPath>a</textPath></textPath></text>")}) {
            const Result<Painting> painting = readPainting(svg(odd + "<path d='M0 0h9v9z'/>"), "a.svg");
            QVERIFY2(!painting || problemOf(*painting).isEmpty(), odd.constData());
        }
    }
};

QTEST_GUILESS_MAIN(TestSvgTexts)
#include "test_svg_texts.moc"
