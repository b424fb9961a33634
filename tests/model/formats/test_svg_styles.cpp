// Style sheets in SVG drawings: which rule reaches which element, and which of them wins.
#include "model/formats/svg/css/css_sheet.h"
#include "model/formats/svg/paths/svg_paths.h"

#include <QTest>

using namespace suffuse;

namespace {

/// With round pens, so that strokes stay lines.
QByteArray svg(const QByteArray &content)
{
    return "<svg xmlns='http://www.w3.org/2000/svg' stroke-linecap='round' stroke-linejoin='round'>" + content +
           "</svg>";
}

/// "#e30613 3" of the only path's stroke, or "none".
QString strokeOf(const QByteArray &content)
{
    const Result<SvgDrawing> drawing = readSvgDrawing(svg(content));
    if (drawing && drawing->paths.empty()) // lines without a stroke enclose nothing
        return QStringLiteral("none");
    if (!drawing || drawing->paths.size() != 1)
        return drawing ? QStringLiteral("%1 paths").arg(drawing->paths.size()) : drawing.error();
    const SvgPath &path = drawing->paths[0];
    if (!path.stroke)
        return QStringLiteral("none");
    const auto byte = [&path](std::size_t i) { return int(std::lround((*path.stroke)[i] * 255)); };
    return QString::asprintf("#%02x%02x%02x %g", byte(0), byte(1), byte(2), path.strokeWidth);
}

} // namespace

class TestSvgStyles : public QObject {
    Q_OBJECT

private slots:
    void rules_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("stroke");
        const auto row = [](const char *name, const QByteArray &sheet, const QByteArray &body, const char *stroke) {
            QTest::newRow(name) << "<style>" + sheet + "</style>" + body << QString(stroke);
        };
        const QByteArray a = "<path class='a' d='M0 0h9'/>", plain = "<path d='M0 0h9'/>";
        row("Illustrator's", ".cls-1{fill:none;stroke:#e30613;stroke-miterlimit:10;stroke-width:3px}",
            "<path class='cls-1' d='M0 0h9'/>", "#e30613 3");
        row("type", "path { stroke : red }", plain, "#ff0000 1");
        row("of another type", "rect{stroke:blue}", plain, "none");
        row("any", "*{stroke:red}", plain, "#ff0000 1");
        row("id", "#p{stroke:red}", "<path id='p' d='M0 0h9'/>", "#ff0000 1");
        row("list", ".x,\n .a , .y{stroke:red}", a, "#ff0000 1");
        row("two classes", ".a.b{stroke:red}", "<path class=' b  a ' d='M0 0h9'/>", "#ff0000 1");
        row("not both classes", ".a.b{stroke:red}", a, "none");
        row("descendant", "g .a{stroke:red}", "<g><g>" + a + "</g></g>", "#ff0000 1");
        row("no descendant", "g .a{stroke:red}", a, "none");
        row("child", "#g>path{stroke:red}", "<g id='g'>" + a + "</g>", "#ff0000 1");
        row("no child", "#g > path{stroke:red}", "<g id='g'><g>" + a + "</g></g>", "none");
        row("child of a farther one", ".o > .i path{stroke:red}",
            "<g class='o'><g class='i'><g class='i'>" + a + "</g></g></g>", "#ff0000 1");
        row("inherited", ".o{stroke:red;stroke-width:4}", "<g class='o'>" + plain + "</g>", "#ff0000 4");
        row("the later one", ".a{stroke:red}.a{stroke:blue}", a, "#0000ff 1");
        row("class before type", ".a{stroke:red}path{stroke:blue}", a, "#ff0000 1");
        row("id before classes", "#p{stroke:red}.a.b.c{stroke:blue}", "<path id='p' class='a b c' d='M0 0h9'/>",
            "#ff0000 1");
        row("important", ".a{stroke:red ! important}.a{stroke:blue}", a, "#ff0000 1");
        row("sheet before attribute", ".a{stroke:red}", "<path class='a' stroke='blue' d='M0 0h9'/>", "#ff0000 1");
        row("style before sheet", "#p{stroke:red}", "<path id='p' style='stroke:blue' d='M0 0h9'/>", "#0000ff 1");
        row("important before style", ".a{stroke:red!important}", "<path class='a' style='stroke:blue' d='M0 0h9'/>",
            "#ff0000 1");
        row("important style", ".a{stroke:red!important}", "<path class='a' style='stroke:blue!important' d='M0 0h9'/>",
            "#0000ff 1");
        row("mistakes are passed over", ".a{stroke:red;stroke:#12;stroke-width:wide;;:;}", a, "#ff0000 1");
        row("comments", "/* .a{stroke:blue} */.a/**/{/*;*/stroke:/*blue*/red}", a, "#ff0000 1");
        row("CDATA", "<![CDATA[ .a > .b, .a{stroke:red} ]]>", a, "#ff0000 1");
        row("HTML's comments", "<![CDATA[<!-- .a{stroke:red} -->]]>", a, "#ff0000 1");
        row("for screens", "@media screen{.a{stroke:red}}@media print{.a{stroke:blue}}", a, "#ff0000 1");
        row("other blocks", "@font-face{font-family:'a;}';src:url(data:a;b)}.a{stroke:red}", a, "#ff0000 1");
        row("after a state", ".a:hover{stroke:blue}.a{stroke:red}", a, "#ff0000 1");
        row("with what is unknown", ".a[d],.a+.a,.a{stroke:red}", a, "#ff0000 1");
        row("after its use", "", a + "<style type='text/css'>.a{stroke:red}</style>", "#ff0000 1");
        row("of another kind", "", a + "<style type='text/less'>.a{stroke:red}</style>", "none");
        row("a used element's own place", "defs .a{stroke:red}",
            "<defs><path id='p' class='a' d='M0 0h9'/></defs>"
            "<use href='#p'/>",
            "#ff0000 1");
        row("current colour", ".a{color:red;stroke:currentColor}", a, "#ff0000 1");
        row("inherit", ".a{stroke:inherit}", "<g stroke='red'><path class='a' stroke='blue' d='M0 0h9'/></g>",
            "#ff0000 1");
        row("hidden", ".a{display:none}", a + "<path d='M0 0h9' stroke='red'/>", "#ff0000 1");
        row("escapes", ".\\31 a\\:b{stroke:red}", "<path class='1a:b' d='M0 0h9'/>", "#ff0000 1");
        row("a width that does not scale", ".a{stroke:red;vector-effect:non-scaling-stroke;transform:scale(4)}", a,
            "#ff0000 1");
        row("one opacity", ".a{stroke:red;opacity:.5}", "<path class='a' opacity='.5' d='M0 0h9'/>", "#ff0000 1");
    }
    void rules()
    {
        QFETCH(const QByteArray, content);
        QFETCH(const QString, stroke);
        QCOMPARE(strokeOf(content), stroke);
    }

    void opacityCountsOnce()
    {
        const auto drawing =
            readSvgDrawing(svg("<style>.a{stroke:red;opacity:.5}</style><path class='a' opacity='.5' d='M0 0h9'/>"));
        QVERIFY(drawing && drawing->paths.size() == 1);
        QCOMPARE((*drawing->paths[0].stroke)[3], 0.5);
    }

    /// What any text does: nothing but take little time and memory.
    void damagedSheets()
    {
        const QByteArray whole = "g > .a, #b *{fill:none!important;stroke:url('#x;}')}/* */@media all{.c{stroke:red}}";
        for (qsizetype cut = 0; cut <= whole.size(); ++cut) {
            QVERIFY(readSvgDrawing(svg("<style><![CDATA[" + whole.left(cut) + "]]></style><path d='M0 0h9'/>")));
            CssSheet sheet;
            sheet.add(QString::fromLatin1(whole.mid(cut)));
            cssDeclarations(QString::fromLatin1(whole.mid(cut)));
        }
    }

    /// Rules that every element asks again, deep and wide: matching ends. (How fast a usual file opens is measured by
    /// bench_files.)
    void hostileSheets()
    {
        QByteArray sheet;
        for (int i = 0; i < 3000; ++i)
            sheet += "g g g g g g g g * * * * .a" + QByteArray::number(i % 7) + "{stroke:red}";
        QByteArray body;
        for (int i = 0; i < 200; ++i)
            body += "<g class='x" + QByteArray::number(i) + "'>";
        for (int i = 0; i < 4000; ++i)
            body += "<path class='a" + QByteArray::number(i % 7) + " b" + QByteArray::number(i) +
                    "' fill='none' stroke='blue' d='M0 0h9'/>";
        body += QByteArray("</g>").repeated(200);
        const auto drawing = readSvgDrawing(svg("<style>" + sheet + "</style>" + body));
        QVERIFY(drawing && drawing->paths.size() == 4000);
        QVERIFY(drawing->losses.rules > 0); // and says so
    }

    void manyElementsAndRules()
    {
        QByteArray sheet, body;
        for (int i = 0; i < 2000; ++i)
            sheet += QStringLiteral(".c%1{stroke:#%2;stroke-width:%3} g .c%1 .d{stroke:red}")
                         .arg(i)
                         .arg(i, 6, 16, QLatin1Char('0'))
                         .arg(1 + i % 5)
                         .toLatin1();
        for (int i = 0; i < 40'000; ++i)
            body += QStringLiteral("<g><path id='p%1' class='c%2 d' d='M%3 0h9'/></g>")
                        .arg(i)
                        .arg(i % 2000)
                        .arg(i)
                        .toLatin1();
        const auto drawing = readSvgDrawing(svg("<style>" + sheet + "</style>" + body));
        QVERIFY(drawing && drawing->paths.size() == 40'000);
        QCOMPARE(drawing->paths[39'999].strokeWidth, 5.0);
        QCOMPARE(drawing->losses.rules, 0);
    }
};

QTEST_GUILESS_MAIN(TestSvgStyles)
#include "test_svg_styles.moc"
