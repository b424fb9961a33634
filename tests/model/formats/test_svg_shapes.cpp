// Basic shapes and <use> of SVG as curves.
#include "model/formats/svg/paths/svg_paths.h"
#include "model/formats/svg/paths/svg_shapes.h"

#include <QTest>

using namespace suffuse;

namespace {

std::vector<SvgPath> read(const QByteArray &elements)
{
    const auto paths = readSvgPaths(
        "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' stroke-linecap='round' "
        "stroke-linejoin='round'>" +
        elements + "</svg>");
    return paths ? *paths : std::vector<SvgPath>();
}

/// The ends of a path's curves.
std::vector<Point> nodesOf(const SvgPath &path)
{
    std::vector<Point> nodes{path.curves.front().p[0]};
    for (const Cubic &curve : path.curves)
        nodes.push_back(curve.p[3]);
    return nodes;
}

bool near(Point a, Point b, double tolerance = 1e-9)
{
    return length(a - b) <= tolerance;
}

bool near(const std::vector<Point> &a, const std::vector<Point> &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](Point p, Point q) { return near(p, q); });
}

} // namespace

class TestSvgShapes : public QObject {
    Q_OBJECT

private slots:
    void linesAndPolygons()
    {
        const auto paths = read("<line x1='1' y1='2' x2='30' y2='4' stroke='red'/>"
                                "<polyline points='0,0 10,0 10 20' fill='none' stroke='red'/>"
                                "<polygon points='0,0 10,0 10 20'/>");
        QCOMPARE(paths.size(), std::size_t(3));
        QVERIFY(near(nodesOf(paths[0]), {{1, 2}, {30, 4}}));
        QVERIFY(near(nodesOf(paths[1]), {{0, 0}, {10, 0}, {10, 20}}));
        QVERIFY(near(nodesOf(paths[2]), {{0, 0}, {10, 0}, {10, 20}, {0, 0}}));
        QVERIFY(paths[0].stroke && !paths[2].stroke && paths[2].fill);
        const auto odd = read("<polygon points='0,0 10,0 10 20 7' fill='none' stroke='red'/>");
        QCOMPARE(odd.size(), std::size_t(1));
        QVERIFY(near(nodesOf(odd[0]), {{0, 0}, {10, 0}, {10, 20}, {0, 0}})); // closed all the same
    }

    void rectangles()
    {
        const auto paths =
            read("<rect x='10' y='20' width='30' height='40'/><rect width='5'/><rect width='-1' height='2'/>"
                 "<rect width='100' height='50' rx='10'/><rect width='100' height='50' rx='1e9' ry='5'/>"
                 "<rect width='1in' height='20mm'/>");
        QCOMPARE(paths.size(), std::size_t(4));
        QVERIFY(near(nodesOf(paths[0]), {{10, 20}, {40, 20}, {40, 60}, {10, 60}, {10, 20}}));
        const std::vector<Point> rounded = nodesOf(paths[1]);
        QVERIFY(near(rounded, {{10, 0}, {90, 0}, {100, 10}, {100, 40}, {90, 50}, {10, 50}, {0, 40}, {0, 10}, {10, 0}}));
        for (double p = 0; p <= 1; p += 0.125)
            QVERIFY(std::abs(length(paths[1].curves[1].at(p) - Point{90, 10}) - 10) < 0.01);
        QVERIFY(near(nodesOf(paths[2])[1], {100, 5})); // a radius of half the width: no straight top
        QVERIFY(near(nodesOf(paths[3])[2], {96, 20 * 96 / 25.4}));
    }

    void circlesAndEllipses()
    {
        const auto paths = read("<circle cx='5' cy='6' r='4'/><ellipse cx='5' cy='6' rx='4' ry='2'/><circle r='0'/>"
                                "<ellipse rx='4' ry='0'/><ellipse rx='3'/><ellipse rx='-1' ry='5'/>");
        QCOMPARE(paths.size(), std::size_t(4));
        QVERIFY(near(nodesOf(paths[0]), {{9, 6}, {5, 10}, {1, 6}, {5, 2}, {9, 6}}));
        for (const Cubic &curve : paths[0].curves)
            for (double p = 0; p <= 1; p += 0.125)
                QVERIFY(std::abs(length(curve.at(p) - Point{5, 6}) - 4) < 0.002);
        QVERIFY(near(nodesOf(paths[1]), {{9, 6}, {5, 8}, {1, 6}, {5, 4}, {9, 6}}));
        QVERIFY(near(nodesOf(paths[2])[1], {0, 3})); // one radius alone is both
        QVERIFY(near(nodesOf(paths[3])[0], {5, 0})); // one below 0 is none
    }

    void uses()
    {
        const auto paths =
            read("<defs><g id='pair' stroke='blue'><line id='one' x2='10'/><line y2='5'/></g>"
                 "<symbol id='sign'><circle r='2'/></symbol></defs>"
                 "<use href='#one' x='100' y='1' stroke='red'/>"
                 "<use xlink:href='#pair' transform='translate(0 50) scale(2)'/>"
                 "<g transform='translate(7 0)'><use href='#sign'/></g><use href='#nothing'/><use href='x'/>");
        QCOMPARE(paths.size(), std::size_t(4));
        QVERIFY(near(nodesOf(paths[0]), {{100, 1}, {110, 1}}));
        QCOMPARE((*paths[0].stroke)[0], 1.0);
        QVERIFY(near(nodesOf(paths[1]), {{0, 50}, {20, 50}}) && near(nodesOf(paths[2]), {{0, 50}, {0, 60}}));
        QCOMPARE((*paths[1].stroke)[2], 1.0);
        QVERIFY(near(nodesOf(paths[3])[0], {9, 0}));
    }

    /// What refers to itself, or to ever more, comes to an end.
    void hostileUses()
    {
        QVERIFY(read("<g id='a'><use href='#a'/></g>").empty());
        QByteArray doubling = "<g id='l0'><rect width='1' height='1'/></g>";
        for (int i = 1; i < 60; ++i)
            doubling += QStringLiteral("<defs><g id='l%1'><use href='#l%2'/><use href='#l%2'/></g></defs>")
                            .arg(i)
                            .arg(i - 1)
                            .toLatin1();
        const auto paths = read(doubling + "<use href='#l59'/>");
        QVERIFY(!paths.empty() && paths.size() < 200'000);
        QVERIFY(!read(QByteArray("<g>").repeated(5000) + "<rect width='1' height='1'/>" +
                      QByteArray("</g>").repeated(5000) + "<line x2='1' stroke='red'/>")
                     .empty());
    }

    void lengths()
    {
        QCOMPARE(svgLength("12"), std::optional(12.0));
        QCOMPARE(svgLength(" 1.5e1px "), std::optional(15.0));
        QCOMPARE(svgLength("3pt"), std::optional(4.0));
        QCOMPARE(svgLength("-2cm").value() * 2.54, -192.0);
        for (const char *text : {"", "50%", "x", "1e999", "12 px 3"})
            QVERIFY2(!svgLength(text), text);
    }
};

QTEST_APPLESS_MAIN(TestSvgShapes)
#include "test_svg_shapes.moc"
