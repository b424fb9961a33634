// Paintings as SVG drawings: what other programs see, what comes back, and that nothing is left half done.
#include "render/drawing/drawing_file.h"

#include "model/formats/files.h"
#include "model/formats/gzip.h"
#include "render/drawing/drawing_svg.h"
#include "render/drawing/path_coverage.h"
#include "render/image_io/image_io.h"
#include "tests/model/random_paintings.h"
#include "tests/render/files/bounded_groups.h"
#include "tests/render/files/picture_difference.h"
#include "tests/render/filled.h"
#include "tests/render/layers/pictured.h"
#include "tests/render/paintings.h"
#include "tests/trials.h"

#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

using namespace suffuse;
using namespace suffuse::test;

namespace {

std::unique_ptr<Renderer> cpu()
{
    Result<std::unique_ptr<Renderer>> renderer = makeRenderer({Backend::Cpu});
    return renderer ? std::move(*renderer) : nullptr;
}

DrawingOptions optionsOf(DrawingKind kind, const Painting &painting, int bands = 16)
{
    DrawingOptions options;
    options.kind = kind;
    options.bands = bands;
    options.time = painting.end();
    return options;
}

QByteArray drawingBytes(const PaintingPtr &painting, DrawingKind kind, int bands = 16)
{
    const Result<PreparedDrawing> prepared = prepareDrawing(painting, optionsOf(kind, *painting, bands), *cpu());
    return prepared ? *bytesOf(*prepared, *painting, "a.svg") : QByteArray();
}

/// The picture with so many pixels a unit.
FloatPicture exactPicture(const PaintingPtr &painting, int scale = 1)
{
    RenderRequest request;
    request.painting = painting;
    request.time = painting->end();
    const Rect area = painting->canvas.area();
    request.view = View::ofArea(area, scale * int(area.width()), scale * int(area.height()));
    FloatPicture picture;
    return cpu()->render(request, picture) ? std::move(picture) : FloatPicture();
}

/// What librsvg shows of a drawing, with so many pixels a unit; empty where it cannot be asked.
std::optional<FloatPicture> shownByLibrsvg(const QByteArray &svg, int scale = 1)
{
    const QString program = QStandardPaths::findExecutable("rsvg-convert");
    if (program.isEmpty())
        return {};
    QProcess process;
    process.start(program, {"--unlimited", "-f", "png", "-z", QString::number(scale)});
    process.write(svg);
    process.closeWriteChannel();
    if (!process.waitForFinished(120'000) || process.exitCode() != 0)
        return {};
    Result<FloatPicture> picture = readImage(process.readAllStandardOutput(), "librsvg");
    return picture ? std::optional(std::move(*picture)) : std::nullopt;
}

PaintingPtr oneStroke(StyleKind kind)
{
    Stroke s = stroke(1, Shape::Curved, {150, 100}, 90, 10, test::styleOf(kind));
    s.name = "A <wash> & \"more\"";
    return painting({s}, 300, 200);
}

QStringList namesIn(const QByteArray &svg)
{
    QStringList names;
    QXmlStreamReader xml(svg);
    while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == QLatin1String("title"))
            names << xml.readElementText();
    return xml.hasError() ? QStringList{xml.errorString()} : names;
}

} // namespace

class TestPathDrawing : public QObject {
    Q_OBJECT

private slots:
    void coverageIsExact()
    {
        // A circle of radius 7.3: each row's sum is its area there.
        constexpr double r = 7.3, k = 0.5522847498307936 * r;
        const Point c{20.4, 15.7};
        const auto at = [&](double x, double y) { return c + Point{x, y}; };
        PathCoverage coverage(40, 0, 30);
        coverage.add({{at(r, 0), at(r, k), at(k, r), at(0, r)}});
        coverage.add({{at(0, r), at(-k, r), at(-r, k), at(-r, 0)}});
        coverage.add({{at(-r, 0), at(-r, -k), at(-k, -r), at(0, -r)}});
        coverage.add({{at(0, -r), at(k, -r), at(r, -k), at(r, 0)}});
        double area = 0;
        std::vector<float> row;
        for (int y = 0; y < 30; ++y) {
            coverage.takeRow(y, row);
            double sum = 0;
            for (int x = coverage.first(); x < coverage.last(); ++x)
                sum += double(row[std::size_t(x)]);
            if (y == 15)
                QVERIFY(std::abs(sum - 2 * r) < 0.1);
            area += sum;
        }
        QVERIFY(std::abs(area - std::numbers::pi * r * r) < 0.1);
    }

    void shapesMayBeWiderThanTheWindow()
    {
        PathCoverage coverage(40, 0, 30);
        const auto line = [&](Point a, Point b) { coverage.add({{a, a, b, b}}); };
        const Point corners[] = {{-10, -10}, {60, -10}, {60, 50}, {-10, 50}};
        for (std::size_t k = 0; k < 4; ++k)
            line(corners[k], corners[(k + 1) % 4]);
        QCOMPARE(coverage.first(), 0);
        QCOMPARE(coverage.last(), 40);
        std::vector<float> row;
        for (int y = 0; y < 30; ++y) {
            coverage.takeRow(y, row);
            QVERIFY(std::ranges::all_of(row, [](float value) { return value > 0.9999f; }));
        }
    }

    void bandsLookLikeTheStroke_data()
    {
        QTest::addColumn<int>("kind");
        for (const StyleKind kind : styleKinds)
            if (isTried(int(kind)))
                QTest::addRow("%d", int(kind)) << int(kind);
    }
    void bandsLookLikeTheStroke()
    {
        QFETCH(int, kind);
        const PaintingPtr p = oneStroke(StyleKind(kind));
        const Result<PreparedDrawing> prepared = prepareDrawing(p, optionsOf(DrawingKind::Bands, *p, 64), *cpu());
        QVERIFY(bool(prepared));
        constexpr double allowed = 1.0 / 128 + 2.0 / 255;
        // The picture takes a pixel for as wide as it is high in any direction, which shows where paint ends in a jump
        // (docs/exchange.md, "Bands"). The means of finer pixels are what paths cover.
        const bool jumps = StyleKind(kind) == StyleKind::Edge;
        const FloatPicture exact = exactPicture(p), fine = meansOf(exactPicture(p, 8), 8);
        const Rect area = p->canvas.area();
        const View view = View::ofArea(area, int(area.width()), int(area.height()));
        const double own = largestDifference(pictureOf(prepared->drawing, view), fine);
        QVERIFY2(own <= allowed, qPrintable(QString::number(255 * own)));
        QVERIFY(jumps || prepared->difference.largest <= allowed);
        const QByteArray svg = *bytesOf(*prepared, *p, "a.svg");
        const std::optional<FloatPicture> shown = shownByLibrsvg(svg), large = shownByLibrsvg(svg, 8);
        if (!shown || !large)
            QSKIP("rsvg-convert is not installed");
        const double fromPicture = largestDifference(*shown, exact), fromFine = largestDifference(*shown, fine),
                     largeFromFine = largestDifference(meansOf(*large, 8), fine);
        qInfo("our own count: %.2f of 255, %.2f from finer pixels. librsvg: %.2f, %.2f, and %.2f where it draws those. "
              "They are %.2f from the picture.",
              255 * prepared->difference.largest, 255 * own, 255 * fromPicture, 255 * fromFine, 255 * largeFromFine,
              255 * largestDifference(exact, fine));
        QVERIFY(largeFromFine <= allowed);
        QVERIFY(jumps || fromPicture <= allowed);
        // Of a pixel at a level edge librsvg knows no more than fifteen rows.
        QVERIFY(fromFine <= allowed + (jumps ? 1.0 / 30 : 0));
    }

    void hybridIsThePicture()
    {
        std::mt19937_64 random(3);
        const PaintingPtr p =
            mixedFills(random, 6, isTried(1) ? 200 : 60, isTried(1) ? 150 : 45, PaperKind::Procedural);
        const QByteArray svg = drawingBytes(p, DrawingKind::Hybrid);
        const std::optional<FloatPicture> shown = shownByLibrsvg(svg);
        if (!shown)
            QSKIP("rsvg-convert is not installed");
        QVERIFY(largestDifference(*shown, exactPicture(p)) <= 1.0 / 255);
    }

    /// Pictures are images behind masks and clip paths, each of them once.
    void picturesAreImages()
    {
        FloatPicture image; // Programs scale sharp pixels in ways of their own.
        image.resize(60, 40);
        for (int i = 0; i < 60 * 40; ++i)
            for (int c = 0; c < 4; ++c)
                image.rgba.data()[4 * i + c] =
                    c < 3 ? float(0.5 + 0.4 * std::sin(c + 0.1 * (i % 60)) * std::cos(0.1 * (i / 60))) : 1;
        const Result<QByteArray> png = encodeImage(ImageFormat::Png, image, {}, QStringLiteral("test"));
        QVERIFY(bool(png));
        const Picture picture = embeddedPicture(std::make_shared<const QByteArray>(*png), 60, 40);
        Stroke alone = pictureStroke(picture, Rect::of(20, 30, 60, 40), 0);
        alone.id = 1;
        Stroke soft = stroke(2, Shape::Curved, {200, 100}, 70, 10, test::styleOf(StyleKind::Feathering));
        Picture large = picture;
        const auto at = [&](double x, double y) { return toOffset({x, y}, soft.origin); };
        large.corner = at(100, 10), large.right = at(310, 15), large.down = at(95, 190);
        soft.picture = large;
        const PaintingPtr p = painting({alone, soft}, 300, 200);
        for (const DrawingKind kind : {DrawingKind::Bands, DrawingKind::Outlines}) {
            const Result<PreparedDrawing> prepared = prepareDrawing(p, optionsOf(kind, *p, 64), *cpu());
            QVERIFY(bool(prepared));
            const QByteArray svg = *bytesOf(*prepared, *p, "a.svg");
            QCOMPARE(svg.count("<image"), 1);
            QCOMPARE(svg.count("<use"), 1);
            if (kind == DrawingKind::Bands)
                QVERIFY2(prepared->difference.largest <= 1.0 / 128 + 2.0 / 255,
                         qPrintable(QString::number(255 * prepared->difference.largest)));
            const std::optional<FloatPicture> shown = shownByLibrsvg(svg);
            if (!shown)
                QSKIP("rsvg-convert is not installed");
            const View view = View::ofArea(p->canvas.area(), 300, 200);
            const double largest = largestDifference(*shown, pictureOf(prepared->drawing, view));
            // Curves are lines to librsvg within a tenth of a pixel.
            const double allowed = kind == DrawingKind::Outlines ? 0.1 : 1.0 / 128 + 2.0 / 255;
            QVERIFY2(largest <= allowed, qPrintable(QString::number(255 * largest)));
        }
        // A picture that is missing is not seen, and no stroke without a path.
        large.image = {};
        soft.picture = large;
        const PaintingPtr missing = painting({soft}, 300, 200);
        const Result<PreparedDrawing> prepared =
            prepareDrawing(missing, optionsOf(DrawingKind::Bands, *missing), *cpu());
        QVERIFY(bool(prepared));
        QVERIFY(prepared->drawing.strokes.empty());
        QCOMPARE(prepared->drawing.thin, 0);
        QCOMPARE(prepared->difference.largest, 0.0);
    }

    void draftsAreLeftOut()
    {
        auto p = std::make_shared<Painting>(*oneStroke(StyleKind::Uniform));
        p->groups = {{1, "Sketch"}};
        p->groups[0].draft = true;
        Stroke s = *p->strokes[0];
        s.id = 7, s.name = "draft", s.group = 1;
        p->strokes.push_back(std::make_shared<Stroke>(s));
        for (const DrawingKind kind : {DrawingKind::Outlines, DrawingKind::Bands, DrawingKind::Hybrid}) {
            const Result<PreparedDrawing> prepared = prepareDrawing(p, optionsOf(kind, *p), *cpu());
            QVERIFY(bool(prepared));
            const QByteArray svg = *bytesOf(*prepared, *p, "a.svg");
            QVERIFY(!svg.contains("draft") && !svg.contains("Sketch"));
            const Result<Painting> back = readPainting(svg, "a.svg");
            QVERIFY(bool(back) && *back == *p);
        }
    }

    void theDifferenceIsTold()
    {
        // Pigment over another colour is not what a screen makes of it.
        Stroke below =
            stroke(1, Shape::Curved, {150, 100}, 90, 20, test::styleOf(StyleKind::Uniform), {}, {0, 1, 0, 1});
        Stroke above = below;
        above.id = 2;
        for (Segment &s : above.segments)
            s.colour = {0, 0, 1, 0.5f};
        const PaintingPtr p = painting({below, above}, 300, 200);
        const Result<PreparedDrawing> prepared = prepareDrawing(p, optionsOf(DrawingKind::Bands, *p), *cpu());
        QVERIFY(bool(prepared));
        const std::optional<FloatPicture> shown = shownByLibrsvg(*bytesOf(*prepared, *p, "a.svg"));
        if (!shown)
            QSKIP("rsvg-convert is not installed");
        const double largest = largestDifference(*shown, exactPicture(p));
        QVERIFY(largest > 0.02);
        QVERIFY2(std::abs(largest - prepared->difference.largest) < 3.0 / 255,
                 qPrintable(QString("%1, %2").arg(255 * largest).arg(255 * prepared->difference.largest)));
    }

    void comesBackBitForBit_data()
    {
        QTest::addColumn<int>("kind");
        for (const DrawingKind kind : {DrawingKind::Outlines, DrawingKind::Bands, DrawingKind::Hybrid})
            QTest::addRow("%d", int(kind)) << int(kind);
    }
    void comesBackBitForBit()
    {
        QFETCH(int, kind);
        std::mt19937_64 random(11);
        for (int i = 0; i < trials(1, 30); ++i) {
            const PaintingPtr p = mixedFills(random, 3, 60, 46, PaperKind::Procedural);
            const Result<PreparedDrawing> prepared = prepareDrawing(p, optionsOf(DrawingKind(kind), *p, 8), *cpu());
            QVERIFY(bool(prepared));
            for (const char *name : {"a.svg", "a.svgz"}) {
                const QByteArray bytes = *bytesOf(*prepared, *p, name);
                QCOMPARE(isGzip(bytes), QString(name).endsWith('z'));
                QCOMPARE(detectFormat(bytes), FileFormat::Svg);
                const Result<LoadedDocument> back = readDocument(bytes, name);
                QVERIFY(bool(back));
                QVERIFY(back->painting == *p);
                QCOMPARE(writeSuffuseFile(back->painting), writeSuffuseFile(*p));
                QVERIFY(back->leftOut.isEmpty());
            }
        }
    }

    void changedDrawingsAreWhatIsDrawn()
    {
        const PaintingPtr p = oneStroke(StyleKind::Uniform);
        QByteArray svg = drawingBytes(p, DrawingKind::Outlines);
        svg.replace("id=\"background\"", "id=\"background\" class=\"x\"");
        const Result<LoadedDocument> back = readDocument(svg, "a.svg");
        QVERIFY(bool(back));
        QVERIFY(!(back->painting == *p));
        QCOMPARE(back->painting.strokes.size(), 1u);
        QVERIFY(back->leftOut.contains("changed"));
        // So is one whose painting is damaged.
        QByteArray damaged = drawingBytes(p, DrawingKind::Outlines);
        const qsizetype at = damaged.indexOf("\">", damaged.indexOf("drawing=\"")) + 40;
        damaged[at] = damaged[at] == 'A' ? 'B' : 'A';
        const Result<LoadedDocument> drawn = readDocument(damaged, "a.svg");
        QVERIFY(bool(drawn));
        QVERIFY(!(drawn->painting == *p));
    }

    void namesAndLayersAreKept()
    {
        auto p = std::make_shared<Painting>(*oneStroke(StyleKind::Uniform));
        p->groups = {{1, "Sky < \"far\" & near"}, {2, "", 1}};
        p->groups[0].opacity = 0.5f;
        p->groups[0].blend = BlendMode::Multiply;
        p->groups[1].isolated = true;
        Stroke s = *p->strokes[0];
        s.group = 2;
        Stroke hidden = s;
        hidden.id = 7, hidden.visible = false, hidden.name = "hidden", hidden.group = 0;
        p->strokes.clear();
        p->strokes.push_back(std::make_shared<Stroke>(s));
        p->strokes.push_back(std::make_shared<Stroke>(hidden));
        for (const DrawingKind kind : {DrawingKind::Outlines, DrawingKind::Bands, DrawingKind::Hybrid}) {
            const QByteArray svg = drawingBytes(p, kind);
            QCOMPARE(namesIn(svg), (QStringList{"Sky < \"far\" & near", "A <wash> & \"more\""}));
            QVERIFY(svg.contains("inkscape:groupmode=\"layer\""));
            QVERIFY(svg.contains("opacity=\"0.5\""));
            QVERIFY(svg.contains("mix-blend-mode:multiply"));
            QVERIFY(svg.contains("isolation:isolate"));
            QVERIFY(!svg.contains("hidden"));
        }
    }

    /// Groups are seen through masks and what they are clipped to, and masks are not seen themselves.
    void boundedGroupsAreShown()
    {
        constexpr double allowed = 1.0 / 128 + 2.0 / 255;
        for (const auto &[name, p] : boundedGroups()) {
            const Result<PreparedDrawing> prepared = prepareDrawing(p, optionsOf(DrawingKind::Bands, *p, 64), *cpu());
            QVERIFY(bool(prepared));
            QCOMPARE(prepared->drawing.plain, 0);
            QVERIFY2(prepared->difference.largest <= allowed,
                     qPrintable(QString("%1: %2").arg(name).arg(255 * prepared->difference.largest)));
            const std::optional<FloatPicture> shown = shownByLibrsvg(*bytesOf(*prepared, *p, "a.svg"));
            if (!shown)
                QSKIP("rsvg-convert is not installed");
            // librsvg rounds what lies on masks to 8 bits once more.
            const double largest = largestDifference(*shown, exactPicture(p));
            QVERIFY2(largest <= allowed + 1.0 / 255, qPrintable(QString("%1: %2").arg(name).arg(255 * largest)));
        }
    }

    void whatHasNoPathIsTold()
    {
        Stroke faint = stroke(1, Shape::Curved, {150, 100}, 90, 10, test::styleOf(StyleKind::Uniform));
        for (Segment &s : faint.segments)
            s.density *= 0.1f;
        const PaintingPtr p = painting({faint}, 300, 200);
        const Result<PreparedDrawing> prepared = prepareDrawing(p, optionsOf(DrawingKind::Outlines, *p), *cpu());
        QVERIFY(bool(prepared));
        QCOMPARE(prepared->drawing.thin, 1);
        QVERIFY(leftOutOf(*prepared).contains('1'));
    }

    void emptyPaintingsAreDrawings()
    {
        const PaintingPtr p = painting({}, 300, 200);
        for (const DrawingKind kind : {DrawingKind::Outlines, DrawingKind::Bands, DrawingKind::Hybrid}) {
            const QByteArray svg = drawingBytes(p, kind);
            QVERIFY(!svg.isEmpty());
            const Result<Painting> back = readPainting(svg, "a.svg");
            QVERIFY(bool(back));
            QVERIFY(*back == *p);
        }
    }

    void cancelledWorkLeavesNothing()
    {
        const PaintingPtr p = oneStroke(StyleKind::Uniform);
        const Result<PreparedDrawing> prepared = prepareDrawing(p, optionsOf(DrawingKind::Bands, *p), *cpu());
        QVERIFY(bool(prepared));
        const std::atomic<bool> cancel = true;
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.svgz");
        QVERIFY(!saveDrawing(*prepared, *p, path, &cancel));
        QVERIFY(QDir(folder.path()).isEmpty());
        DrawingOptions options = optionsOf(DrawingKind::Bands, *p);
        options.cancel = &cancel;
        QVERIFY(!prepareDrawing(p, options, *cpu()));
        QVERIFY(bool(saveDrawing(*prepared, *p, path)));
        QVERIFY(bool(loadDocument(path)));
    }

    void packsAndUnpacks()
    {
        QByteArray bytes;
        for (int i = 0; i < 200'000; ++i)
            bytes += char(unsigned(i) * unsigned(i) >> 7);
        const Result<QByteArray> back = unpackedGzip(packedGzip(bytes), 1 << 20);
        QVERIFY(bool(back));
        QCOMPARE(*back, bytes);
        QCOMPARE(*unpackedGzip(packedGzip({}), 1), QByteArray());
        QVERIFY(!unpackedGzip(packedGzip(bytes), 1000));
        QVERIFY(!unpackedGzip(packedGzip(bytes).chopped(20), 1 << 20));
        QCOMPARE(unpackedGzip(packedGzip(bytes), 1000, true)->size(), 1000);
    }
};

QTEST_GUILESS_MAIN(TestPathDrawing)
#include "test_path_drawing.moc"
