// Strokes as SVG for other programs, and what their paths say when they come in again.
#include "app/session/files/svg_strokes.h"
#include "model/area/outline.h"
#include "model/brush/brush.h"
#include "model/formats/svg/svg_painting.h"
#include "model/paint/derived_figures.h"
#include "tests/app/panel_bench.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>
#include <functional>
#include <set>

using namespace suffuse;

namespace {

bool near(Point a, Point b, double tolerance = 1e-9)
{
    return length(a - b) <= tolerance;
}

} // namespace

class TestSvgStrokes : public QObject {
    Q_OBJECT

private slots:
    /// Paint adds up: rows whose paint is one area in the middle between them touch as lines, too; others keep their
    /// width.
    void hatchRowsTouch()
    {
        Painting painting;
        for (int i = 0; i < 3; ++i) {
            Stroke stroke = *makeStroke(StrokeId(i + 1), 4, 10);
            for (Segment &segment : stroke.segments)
                segment.density = 30;
            painting.strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        const Stroke first = *painting.strokes.front();
        const DerivedFigures figures = derivedFigures(first.segments[0], first.styleOf(first.segments[0]));
        const double alone = figures.halfWidth;
        const double together = std::sqrt(alone * alone + figures.spread * figures.spread * std::log(2.0));
        QVERIFY(alone > 0 && together > 1.05 * alone);
        const auto widths = [&](double distance) {
            Painting rows;
            for (const StrokePtr &row : painting.strokes) {
                Stroke stroke = *row;
                stroke.origin = {50, 100 + distance * double(rows.strokes.size())};
                rows.strokes.push_back(std::make_shared<const Stroke>(stroke));
            }
            static const QRegularExpression width("stroke-width=\"([^\"]+)\"");
            std::set<double> found;
            for (auto it = width.globalMatch(QString::fromUtf8(svgOf(rows).bytes)); it.hasNext();)
                found.insert(it.next().captured(1).toDouble());
            return found;
        };
        const double joins = alone + together; // between twice the one and twice the other
        for (const double width : widths(joins))
            QVERIFY2(width >= joins - 0.01, qPrintable(QString::number(width)));
        for (const double apart : {2.1 * together, 1.0 * alone})
            for (const double width : widths(apart))
                QVERIFY2(std::abs(width - 2 * alone) < 0.011, qPrintable(QString::number(width)));
    }

    void comesBackAsItWas()
    {
        Painting painting;
        Stroke stroke = *makeStroke(1, 3, 25);
        stroke.name = "A & B";
        for (Segment &s : stroke.segments)
            s.density = 20, s.colour = {1, 0, 0, 0.5f};
        stroke.segments[2].colour = {0, 0, 1, 1};
        painting.strokes = {std::make_shared<const Stroke>(stroke)};
        const QByteArray svg = svgOf(painting).bytes;
        QVERIFY(svg.contains("A &amp; B"));
        const auto paths = readSvgPaths(svg);
        QVERIFY2(bool(paths), qPrintable(paths.error()));
        QCOMPARE(paths->size(), std::size_t(2)); // two looks
        QCOMPARE((*paths)[0].curves.size(), std::size_t(2));
        QVERIFY(std::abs((*(*paths)[0].stroke)[3] - 0.5) < 0.01);
        QVERIFY((*(*paths)[0].stroke)[0] > 0.99 && (*(*paths)[1].stroke)[2] > 0.99);
        QVERIFY(!(*paths)[0].fill);
        const double half = derivedFigures(stroke.segments[0], stroke.style).halfWidth;
        QVERIFY(std::abs((*paths)[0].strokeWidth - 2 * half) < 0.01);
        for (std::size_t k = 0; k < 2; ++k)
            for (std::size_t i = 0; i < 4; ++i)
                QVERIFY(near((*paths)[0].curves[k].p[i], stroke.cubicOf(stroke.segments[k]).p[i], 1e-5));

        // Pasted again it is as wide, in the same colour, along the same curve.
        Brush brush = builtinBrushes().front();
        SvgDrawing drawing;
        drawing.paths = *paths;
        drawing.area = Rect::of(0, 0, 1, 1);
        std::vector<Stroke> back;
        for (const StrokePtr &pasted : paintingAlong(drawing, brush, 3'000'000).strokes)
            back.push_back(*pasted);
        QCOMPARE(back.size(), std::size_t(2));
        const double again = derivedFigures(back[0].segments[0], back[0].style).halfWidth;
        QVERIFY(std::abs(again - half) < 0.01);
        QVERIFY(near(back[0].cubicOf(back[0].segments[1]).p[3], stroke.cubicOf(stroke.segments[1]).p[3], 1e-4));
        QVERIFY(std::abs(back[0].segments[0].colour.red - 1) < 0.01 && back[0].segments[0].colour.yellow < 0.01);
        QVERIFY(std::abs(back[0].segments[0].colour.opacity - 0.5f) < 0.01f);
        QCOMPARE(back[0].segments[0].born, Microseconds(3'000'000));
    }

    /// What fills is written so that it comes in again as it was.
    void fills()
    {
        const QByteArray drawing =
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 200 100'><defs><linearGradient id='g' "
            "gradientUnits='userSpaceOnUse' x1='10' y1='20' x2='80' y2='30'><stop offset='0' stop-color='#202020'/>"
            "<stop offset='1' stop-color='#c0c0c0' stop-opacity='0.5'/></linearGradient></defs><g><title>pair</title>"
            "<path d='M0 0H100V80H0Z M20 20H60V60H20Z' fill='#e0a030' fill-opacity='0.5' fill-rule='evenodd'>"
            "<title>frame</title></path><path d='M5 5C50 0 90 50 10 90Z' fill='url(#g)'/></g>"
            "<path d='M5 5H50V50Z' fill='#00ff00' stroke='#ff0000' stroke-width='4' stroke-linejoin='round'/></svg>";
        const auto read = [](const QByteArray &bytes) { return readSvg(bytes, "a.svg", builtinBrushes().front()); };
        const auto before = read(drawing);
        QVERIFY(bool(before));
        const QByteArray written = svgOf(*before).bytes;
        QVERIFY(!written.contains("stroke-opacity=\"0\""));
        const auto after = read(written);
        QVERIFY2(bool(after), qPrintable(after.error()));
        QCOMPARE(after->strokes.size(), before->strokes.size());
        QCOMPARE(after->groups.front().name, QString("pair"));
        // The drawing's corner is another one: what is drawn has moved as a whole.
        const Point moved = after->strokes[0]->cubicOf(after->strokes[0]->segments[0]).p[0] -
                            before->strokes[0]->cubicOf(before->strokes[0]->segments[0]).p[0];
        int fills = 0;
        for (std::size_t i = 0; i < before->strokes.size(); ++i) {
            const Stroke &was = *before->strokes[i], &is = *after->strokes[i];
            QCOMPARE(is.name, was.name);
            QCOMPARE(bool(is.fill), bool(was.fill));
            if (!was.fill)
                continue;
            ++fills;
            QCOMPARE(is.fill->rule, was.fill->rule);
            const auto alike = [](const Colour &a, const Colour &b) {
                return std::abs(a.red - b.red) + std::abs(a.yellow - b.yellow) + std::abs(a.blue - b.blue) +
                           std::abs(a.opacity - b.opacity) <
                       0.02f;
            };
            QVERIFY(alike(is.fill->colour, was.fill->colour));
            QCOMPARE(bool(is.fill->gradient), bool(was.fill->gradient));
            if (was.fill->gradient) {
                QVERIFY(alike(is.fill->gradient->colour, was.fill->gradient->colour));
                QVERIFY(near(is.origin + is.fill->gradient->from, was.origin + was.fill->gradient->from + moved, 1e-3));
                QVERIFY(near(is.origin + is.fill->gradient->to, was.origin + was.fill->gradient->to + moved, 1e-3));
            }
            const auto loops = closedOutline(was), again = closedOutline(is);
            QCOMPARE(again.size(), loops.size());
            for (std::size_t l = 0; l < loops.size(); ++l)
                for (std::size_t k = 0; k < loops[l].size(); ++k)
                    QVERIFY(near(is.origin + again[l][k].p[1], was.origin + loops[l][k].p[1] + moved, 1e-3));
        }
        QCOMPARE(fills, 3);
    }

    /// Groups blend in CSS as they do here; what it has no word for is counted.
    void groupsThatBlend()
    {
        Painting painting;
        painting.strokes = {makeStroke(1, 3, 25)};
        Stroke stroke = *painting.strokes[0];
        stroke.group = 1;
        painting.strokes[0] = std::make_shared<const Stroke>(stroke);
        Group group;
        group.id = 1;
        const auto written = [&] {
            painting.groups = {group};
            return QString::fromUtf8(svgOf(painting).bytes);
        };
        QVERIFY(written().contains("<g>"));
        group.isolated = true;
        QVERIFY(written().contains("<g style=\"isolation:isolate\">"));
        group.opacity = 0.5f, group.blend = BlendMode::ColourDodge;
        QVERIFY(written().contains("<g opacity=\"0.5\" style=\"mix-blend-mode:color-dodge;isolation:isolate\">"));
        group.blend = BlendMode::Plus;
        QVERIFY(written().contains("mix-blend-mode:plus-lighter"));
        QCOMPARE(leftOutOf(svgOf(painting)), QString());
        group.blend = BlendMode::DestinationIn;
        QVERIFY(!written().contains("mix-blend-mode"));
        QVERIFY2(leftOutOf(svgOf(painting)).contains("1 group"), qPrintable(leftOutOf(svgOf(painting))));
        // Groups become plain that SVG has nothing for; of what is not written nothing is lost.
        const auto lost = [&](const std::function<void(Group &)> &change) {
            group = {};
            group.id = 1;
            change(group);
            painting.groups = {group};
            const SvgStrokes svg = svgOf(painting);
            return std::pair(svg.masks, svg.washes);
        };
        QCOMPARE(lost([](Group &g) { g.clips = true; }), std::pair(1, 0));
        QCOMPARE(lost([](Group &g) { g.mask = true; }), std::pair(1, 0));
        QCOMPARE(lost([](Group &g) { g.wash = Wash(); }), std::pair(0, 1));
        QVERIFY(leftOutOf(svgOf(painting)).contains("washes"));
        QCOMPARE(lost([](Group &g) { g.wash = Wash(), g.clips = true, g.visible = false; }), std::pair(0, 0));
        QCOMPARE(lost([](Group &g) { g.solo = true, g.tag = GroupTag::Red; }), std::pair(0, 0));
    }

    /// What is beside a solo group is not seen, and not written.
    void soloGroupsAreWrittenAlone()
    {
        Painting painting;
        Stroke inside = *makeStroke(1, 3, 25), beside = *makeStroke(2, 3, 25);
        inside.group = 1, inside.name = "inside", beside.name = "beside";
        painting.strokes = {std::make_shared<const Stroke>(inside), std::make_shared<const Stroke>(beside)};
        Group group;
        group.id = 1;
        for (const bool solo : {false, true}) {
            group.solo = solo;
            painting.groups = {group};
            const QByteArray svg = svgOf(painting).bytes;
            QVERIFY(svg.contains("inside"));
            QCOMPARE(svg.contains("beside"), !solo);
        }
    }

    void groupsThatBlendComeBack()
    {
        for (int mode = 0; mode <= int(BlendMode::Plus); ++mode)
            for (const float opacity : {1.0f, 0.37f, 0.1f, 0.0f})
                for (const bool isolated : {false, true}) {
                    Painting painting;
                    Group outer, inner;
                    outer.id = 1, inner.id = 2, inner.parent = 1;
                    outer.name = "outer", inner.name = "inner";
                    outer.opacity = opacity, outer.blend = BlendMode(mode), outer.isolated = isolated;
                    inner.opacity = 0.5f, inner.blend = BlendMode::Screen;
                    painting.groups = {outer, inner};
                    for (StrokeId id = 1; id <= 3; ++id) {
                        Stroke stroke = *makeStroke(id, 3, 25);
                        stroke.group = id < 3 ? 1 : 2;
                        painting.strokes.push_back(std::make_shared<const Stroke>(stroke));
                    }
                    const auto back = readSvg(svgOf(painting).bytes, "a.svg", builtinBrushes().front());
                    QVERIFY2(bool(back), qPrintable(back.error()));
                    QCOMPARE(back->groups, painting.groups);
                    QCOMPARE(back->strokes.size(), painting.strokes.size());
                    for (std::size_t i = 0; i < 3; ++i) {
                        QCOMPARE(back->strokes[i]->group, painting.strokes[i]->group);
                        QCOMPARE(back->strokes[i]->segments[0].colour.opacity, 1.0f);
                    }
                }
    }

    void pathData()
    {
        const auto ends = [](const char *d) {
            QStringList result;
            for (const auto &curves : parsePathData(d))
                for (const Cubic &c : curves)
                    result << QString("%1,%2").arg(c.p[3].x).arg(c.p[3].y);
            return result.join(' ');
        };
        QCOMPARE(ends("M10 20L30 40h5v-5H0V0z"), QString("30,40 35,40 35,35 0,35 0,0 10,20"));
        QCOMPARE(ends("m10-20 5 5.5.5-5"), QString("15,-14.5 15.5,-19.5"));
        QCOMPARE(ends("M0,0 c1 2 3 4 5 6 s 1 1 2 2 q 1 1 2 0 t 2 0"), QString("5,6 7,8 9,8 11,8"));
        QCOMPARE(ends("M1e1 0L2E+1.5 3"), QString("20,0.5"));
        QCOMPARE(ends("M0 0L10 0 oops L20 0"), QString("10,0"));
        QCOMPARE(ends("L10 0"), QString());
        QCOMPARE(ends("M5 5L5 5"), QString());
        QCOMPARE(parsePathData("M0 0h1M5 5h1zh2").size(), std::size_t(3));
        const auto smooth = parsePathData("M0 0C0 0 1 5 2 5S4 0 4 0").front();
        QVERIFY(near(smooth[1].p[1], {3, 5}));
        const auto quadratic = parsePathData("M0 0Q3 6 6 0T12 0").front();
        QVERIFY(near(quadratic[0].p[1], {2, 4}) && near(quadratic[1].p[1], {8, -4}));
    }

    void arcsAreEllipses()
    {
        // Half a circle about (10, 0), radius 10, in flags without spaces; sagitta and radius all along.
        const auto curves = parsePathData("M0 0A10 10 0 0120 0").front();
        QCOMPARE(curves.size(), std::size_t(2));
        for (const Cubic &c : curves)
            for (double t = 0; t <= 1; t += 0.125)
                QVERIFY(std::abs(length(c.at(t) - Point{10, 0}) - 10) < 0.01);
        QVERIFY(near(curves.back().p[3], {20, 0}));
        QVERIFY(near(curves[0].p[3], {10, -10}, 1e-6)); // sweep: clockwise on screen
        const auto large = parsePathData("M0 0A5 3 30 1 0 4 1").front();
        QVERIFY(large.size() >= 3);
        const auto tooSmall = parsePathData("M0 0A1 1 0 0 1 20 0").front(); // grows to reach
        QVERIFY(near(tooSmall[0].p[3], {10, -10}, 1e-6));
        QCOMPARE(parsePathData("M0 0A0 5 0 0 1 9 0").front().size(), std::size_t(1)); // a line
    }

    void stylesAndTransforms()
    {
        const QByteArray svg =
            "<svg xmlns='http://www.w3.org/2000/svg'><defs><path d='M0 0h1' stroke='red'/></defs>"
            "<g transform='translate(10 20) scale(2)' stroke='#0000ff' stroke-width='3' "
            "stroke-linecap='round' opacity='.5'>"
            "<path d='M0 0L10 0' style='fill:none; stroke-opacity: 50%'/>"
            "<path d='M0 0L10 0L10 1' style='stroke:none' fill='rgb(255,0,0)' transform='translate(0 9) rotate(90)'/>"
            "<path d='M0 0L10 0' display='none'/><path d='M0 0L10 0' fill='none' style='stroke:none'/></g></svg>";
        const auto drawing = readSvgDrawing(svg);
        QVERIFY2(bool(drawing), qPrintable(drawing.error()));
        QCOMPARE(drawing->paths.size(), std::size_t(2));
        QCOMPARE(drawing->groups.size(), std::size_t(1));
        QCOMPARE(drawing->groups[0].opacity, 0.5f);
        const SvgPath &line = drawing->paths[0], &filled = drawing->paths[1];
        QVERIFY(near(line.curves[0].p[0], {10, 20}) && near(line.curves[0].p[3], {30, 20}));
        QCOMPARE(line.strokeWidth, 6.0);
        QVERIFY(!line.fill && line.stroke && std::abs((*line.stroke)[3] - 0.5) < 1e-12 && (*line.stroke)[2] == 1);
        QVERIFY(near(filled.curves[0].p[3], {10, 58}));
        QVERIFY(!filled.stroke && filled.fill && (*filled.fill)[0] == 1);
        const auto broken = readSvgPaths("<svg><path d='M0 0h1'>\n</svg>");
        QVERIFY(!broken && broken.error().contains('2'));
        QVERIFY(readSvgPaths("<svg/>")->empty());
    }
};

QTEST_GUILESS_MAIN(TestSvgStrokes)
#include "test_svg_strokes.moc"
