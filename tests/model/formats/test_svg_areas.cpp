// What covers areas in SVG drawings comes in as fills: shapes, pens that are not round, markers; and what clips them.
#include "model/area/area_sets.h"
#include "model/area/outline.h"
#include "model/formats/files.h"
#include "model/formats/svg/svg_painting.h"
#include "model/painting/ryb.h"
#include "tests/model/formats/svg_text.h"

#include <QTest>

#include <numbers>

using namespace suffuse;
using test::svg;

class TestSvgAreas : public QObject {
    Q_OBJECT

private slots:
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

    void opacityIsThatOfTheWhole_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<std::vector<double>>("sizes"); ///< by opacity: from thin to strong
        QTest::addColumn<std::vector<double>>("opacities");
        using Row = std::vector<double>;
        const QByteArray a = "<rect width='10' height='10'/>";
        // Where the upper one lets half through: 1 − (1 − .25)(1 − x) = .5 · (1 − .5 · 0)
        QTest::newRow("an outline that lets through")
            << QByteArray("<rect x='10' y='10' width='10' height='10' opacity='.5' stroke='red' stroke-width='2' "
                          "stroke-opacity='.5'/>")
            << Row{64, 36, 12 * 12 - 64} << Row{.5, .5 * .5 / (1 - .25), .25};
        QTest::newRow("a fill below its stroke")
            << QByteArray("<rect x='10' y='10' width='10' height='10' opacity='.5' stroke='red' stroke-width='2'/>")
            << Row{64, 12 * 12 - 64} << Row{.5, .5};
        QTest::newRow("a round stroke over a fill")
            << QByteArray("<rect x='10' y='10' width='10' height='10' opacity='.5' stroke='red' stroke-width='2' "
                          "stroke-linecap='round' stroke-linejoin='round' paint-order='stroke'/>")
            << Row{40 + std::numbers::pi, 100} << Row{.5, .5};
        QTest::newRow("nothing") << "<rect width='9' height='9' stroke='red' opacity='0'/>" + a << Row{100} << Row{1};
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

    /// Opacity, mode and isolation of a <g> are those of its group, and divide nothing.
    void groupsBlend()
    {
        const auto read = [](const QByteArray &content, QString *leftOut = nullptr) {
            const Result<Painting> painting = readSvg(svg("viewBox='0 0 100 100'", content), "a.svg", nullptr, leftOut);
            return painting ? *painting : Painting();
        };
        const auto opacitiesOf = [](const Painting &painting) {
            std::vector<float> opacities;
            for (const StrokePtr &stroke : painting.strokes)
                opacities.push_back(stroke->fill->colour.opacity);
            return opacities;
        };
        const auto isPut = [](const Group &group, float opacity, BlendMode mode, bool isolated = false) {
            return group.opacity == opacity && group.blend == mode && group.isolated == isolated;
        };
        const QByteArray a = "<rect width='10' height='10'/>", b = "<rect x='5' width='10' height='10'/>";
        using enum BlendMode;
        const Painting both = read("<g opacity='.5' style='mix-blend-mode:multiply;isolation:isolate'>" + a + b +
                                   "</g><a mix-blend-mode='Color-Burn'>" + a + b + "</a>");
        QCOMPARE(opacitiesOf(both), (std::vector<float>{1, 1, 1, 1}));
        QCOMPARE(both.groups.size(), std::size_t(2));
        QVERIFY(isPut(both.groups[0], 0.5f, Multiply, true) && isPut(both.groups[1], 1, ColourBurn));
        // A group that blends is one with a single thing in it, too.
        const Painting single = read("<g opacity='0'>" + a + "</g><g style='isolation:isolate'>" + a + "</g><g>" + a +
                                     "</g><g style='mix-blend-mode:normal;isolation:auto'>" + a + "</g>");
        QCOMPARE(single.strokes.size(), std::size_t(4));
        QCOMPARE(single.groups.size(), std::size_t(2));
        QVERIFY(isPut(single.groups[0], 0, Normal) && isPut(single.groups[1], 1, Normal, true));
        QCOMPARE(single.strokes[2]->group, GroupId(0));
        // One that is not displayed is hidden; single things that are not are left out.
        const Painting hidden = read("<g display='none'>" + a + "</g><g style='display:none'>" + a + b +
                                     "</g><rect display='none' width='9' height='9'/>" + a);
        QCOMPARE(hidden.strokes.size(), std::size_t(4));
        QCOMPARE(hidden.groups.size(), std::size_t(2));
        QVERIFY(std::ranges::none_of(hidden.groups, &Group::visible));
        QVERIFY(hidden.isVisible(*hidden.strokes[3]) && !hidden.isVisible(*hidden.strokes[1]));
        // Neither is inherited, and each counts where it stands.
        const Painting nested = read("<g opacity='.5'>" + a + "<svg opacity='.25'>" + a + b + "</svg></g>");
        QCOMPARE(nested.groups.size(), std::size_t(2));
        QVERIFY(isPut(nested.groups[0], 0.5f, Normal) && isPut(nested.groups[1], 0.25f, Normal));
        QCOMPARE(nested.groups[1].parent, nested.groups[0].id);
        QCOMPARE(opacitiesOf(nested), (std::vector<float>{1, 1, 1}));
        // What repeats a group, and a shape with a mode, gets one around it. A single path has an opacity itself.
        const Painting used = read("<g id='u'>" + a + b + "</g><use href='#u' x='20' opacity='.5'/>");
        QCOMPARE(opacitiesOf(used), (std::vector<float>{1, 1, 1, 1}));
        QCOMPARE(used.groups.size(), std::size_t(3));
        QVERIFY(isPut(used.groups[1], 0.5f, Normal) && used.groups[2].parent == used.groups[1].id);
        const Painting one = read("<defs><rect id='r' width='9' height='9'/></defs><use href='#r' opacity='.5'/>");
        QVERIFY(one.groups.empty());
        QCOMPARE(opacitiesOf(one), std::vector<float>{0.5f});
        const Painting shape =
            read("<rect width='9' height='9' opacity='.5' style='mix-blend-mode:plus-lighter'/>" + a);
        QCOMPARE(shape.groups.size(), std::size_t(1));
        QVERIFY(isPut(shape.groups[0], 1, Plus));
        QCOMPARE(opacitiesOf(shape), (std::vector<float>{0.5f, 1}));
        // Where groups are too deep within each other, what can be is done without one, and the rest is counted.
        QString leftOut;
        const Painting deep = read(QByteArray("<g>").repeated(40) + "<g opacity='.5' style='mix-blend-mode:hue'>" + a +
                                       b + "</g>" + QByteArray("</g>").repeated(40),
                                   &leftOut);
        QCOMPARE(opacitiesOf(deep), (std::vector<float>{0.5f, 0.5f}));
        QCOMPARE(leftOut, QString("1 blend mode(s) were left out."));
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
};

QTEST_GUILESS_MAIN(TestSvgAreas)
#include "test_svg_areas.moc"
