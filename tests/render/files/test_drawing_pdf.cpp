// Paintings as PDF files: what other programs read in them and show of them, and that nothing is left half done.
#define POINTERHOLDER_TRANSITION 4
#include "render/drawing/drawing_file.h"

#include "model/formats/files.h"
#include "tests/model/random_paintings.h"
#include "tests/render/files/bounded_groups.h"
#include "tests/render/files/picture_difference.h"
#include "tests/render/filled.h"
#include "tests/render/layers/pictured.h"
#include "tests/render/paintings.h"
#include "tests/trials.h"
#include "tests/wide_profile.h"

#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFWriter.hh>

using namespace suffuse;
using namespace suffuse::test;

namespace {

DrawingOptions optionsOf(DrawingKind kind, const Painting &painting, int bands = 16)
{
    DrawingOptions options;
    options.kind = kind;
    options.format = DrawingFormat::Pdf;
    options.bands = bands;
    options.time = painting.end();
    return options;
}

Result<PreparedDrawing> prepared(const PaintingPtr &painting, DrawingKind kind, int bands = 16)
{
    const Result<std::unique_ptr<Renderer>> renderer = makeRenderer({Backend::Cpu});
    return prepareDrawing(painting, optionsOf(kind, *painting, bands), **renderer);
}

QByteArray pdfOf(const PaintingPtr &painting, DrawingKind kind, int bands = 16)
{
    const Result<PreparedDrawing> drawing = prepared(painting, kind, bands);
    return drawing ? *bytesOf(*drawing, *painting, "a.pdf") : QByteArray();
}

/// The picture with so many pixels a unit.
FloatPicture exactPicture(const PaintingPtr &painting, int scale = 1)
{
    RenderRequest request;
    request.painting = painting;
    request.time = painting->end();
    const Rect area = painting->canvas.area();
    request.view = View::ofArea(area, scale * int(area.width()), scale * int(area.height()));
    request.transparent = painting->canvas.background.opacity < 1;
    FloatPicture picture;
    const Result<std::unique_ptr<Renderer>> renderer = makeRenderer({Backend::Cpu});
    return (*renderer)->render(request, picture) ? std::move(picture) : FloatPicture();
}

/// What poppler shows of a page of its own size with so many pixels a unit; empty where it cannot be asked.
std::optional<FloatPicture> shownByPoppler(const QByteArray &pdf, int scale = 1)
{
    const QString program = QStandardPaths::findExecutable("pdftoppm");
    const QTemporaryDir folder;
    QFile file(folder.filePath("a.pdf"));
    if (program.isEmpty() || !file.open(QIODevice::WriteOnly) || file.write(pdf) != pdf.size())
        return {};
    file.close();
    QProcess process;
    process.start(program, {"-r", QString::number(96 * scale), "-png", file.fileName()});
    if (!process.waitForFinished(120'000) || process.exitCode() != 0)
        return {};
    Result<FloatPicture> picture = readImage(process.readAllStandardOutput(), "poppler");
    return picture ? std::optional(std::move(*picture)) : std::nullopt;
}

/// A file as libqpdf reads it; null if anything in it is wrong.
std::unique_ptr<QPDF> readBack(const QByteArray &pdf)
{
    auto file = std::make_unique<QPDF>();
    try {
        file->setAttemptRecovery(false);
        file->processMemoryFile("test", pdf.constData(), std::size_t(pdf.size()));
        for (QPDFObjectHandle &object : file->getAllObjects()) // Reads all of it.
            if (object.isStream())
                object.getStreamData(qpdf_dl_generalized);
    } catch (const std::exception &e) {
        qWarning("%s", e.what());
        return {};
    }
    return file->anyWarnings() ? nullptr : std::move(file);
}

QPDFObjectHandle pageOf(QPDF &file, std::size_t page = 0)
{
    return file.getAllPages().at(page);
}

QByteArray contentOf(QPDF &file)
{
    const auto data = pageOf(file).getKey("/Contents").getStreamData();
    return {reinterpret_cast<const char *>(data->getBuffer()), qsizetype(data->getSize())};
}

/// How many streams of a kind there are: "/Image", "/Form".
int countOf(QPDF &file, const std::string &subtype)
{
    int count = 0;
    for (QPDFObjectHandle &object : file.getAllObjects())
        count += object.isStream() && object.getDict().getKey("/Subtype").isNameAndEquals(subtype);
    return count;
}

/// The numbers of an array.
std::vector<double> numbersOf(const QPDFObjectHandle &array)
{
    std::vector<double> numbers;
    for (QPDFObjectHandle &item : QPDFObjectHandle(array).getArrayAsVector())
        numbers.push_back(item.getNumericValue());
    return numbers;
}

PaintingPtr oneStroke(StyleKind kind = StyleKind::Uniform)
{
    Stroke s = stroke(1, Shape::Curved, {150, 100}, 90, 10, test::styleOf(kind));
    return painting({s}, 300, 200);
}

/// Two groups, one in the other, with a stroke in each.
std::shared_ptr<Painting> grouped()
{
    auto p = std::make_shared<Painting>(*oneStroke());
    p->groups = {{1, "Sky (far)"}, {2, "", 1}};
    p->groups[0].opacity = 0.5f;
    p->groups[0].blend = BlendMode::Multiply;
    p->groups[1].isolated = true;
    Stroke below = stroke(7, Shape::Straight, {150, 100}, 90, 20, test::styleOf(StyleKind::Uniform));
    Stroke above = *p->strokes[0];
    below.group = 1, above.group = 2;
    p->strokes = {std::make_shared<Stroke>(below), std::make_shared<Stroke>(above)};
    return p;
}

} // namespace

class TestDrawingPdf : public QObject {
    Q_OBJECT

private slots:
    void filesAreSound_data()
    {
        QTest::addColumn<int>("kind");
        for (const DrawingKind kind : {DrawingKind::Outlines, DrawingKind::Bands, DrawingKind::Hybrid})
            QTest::addRow("%d", int(kind)) << int(kind);
    }
    void filesAreSound()
    {
        QFETCH(int, kind);
        const PaintingPtr p = grouped();
        Result<PreparedDrawing> drawing = prepared(p, DrawingKind(kind));
        QVERIFY(bool(drawing));
        drawing->about.title = "Ein Blatt — 纸";
        const QByteArray pdf = *bytesOf(*drawing, *p, "a.pdf");
        const std::unique_ptr<QPDF> file = readBack(pdf);
        QVERIFY(file);
        QCOMPARE(file->getAllPages().size(), 1u);
        QCOMPARE(QString::fromStdString(file->getTrailer().getKey("/Info").getKey("/Title").getUTF8Value()),
                 drawing->about.title);
        const bool isHybrid = DrawingKind(kind) == DrawingKind::Hybrid,
                   isBands = DrawingKind(kind) == DrawingKind::Bands;
        // A form for each group, and for each mask.
        QCOMPARE(countOf(*file, "/Form"), isHybrid ? 0 : (isBands ? 4 : 2));
        QCOMPARE(countOf(*file, "/Image"), isHybrid ? 1 : 0);
        QPDFObjectHandle layers = file->getRoot().getKey("/OCProperties");
        QCOMPARE(layers.getKey("/OCGs").getArrayNItems(), isHybrid ? 2 : 1);
        QCOMPARE(layers.getKey("/D").getKey("/OFF").getArrayNItems(), isHybrid ? 1 : 0);
        QPDFObjectHandle intent = file->getRoot().getKey("/OutputIntents").getArrayItem(0);
        QVERIFY(intent.getKey("/DestOutputProfile").isStream());
        // The same each time.
        QCOMPARE(*bytesOf(*drawing, *p, "a.pdf"), pdf);
        QCOMPARE(pdfOf(p, DrawingKind(kind)), pdfOf(p, DrawingKind(kind)));
    }

    void outlinesArePaths()
    {
        std::vector<Stroke> strokes;
        for (StrokeId id = 1; id <= 5; ++id)
            strokes.push_back(
                stroke(id, Shape::Curved, {60.0 + 40.0 * double(id), 100}, 30, 6, test::styleOf(StyleKind::Uniform)));
        const std::unique_ptr<QPDF> file = readBack(pdfOf(painting(strokes, 300, 200), DrawingKind::Outlines));
        QVERIFY(file);
        const QByteArray content = contentOf(*file);
        QCOMPARE(content.count("\nf\n"), 5);
        QVERIFY(content.count(" c\n") > 5 * 4);
        QCOMPARE(content.count("q\n"), content.count("Q\n"));
    }

    void pagesHaveTheirSize_data()
    {
        QTest::addColumn<QString>("paper");
        QTest::addColumn<QSizeF>("size");  // points
        QTest::addColumn<double>("scale"); // points a unit
        QTest::addColumn<double>("resolution");
        QTest::newRow("own") << QString() << QSizeF(225, 150) << 0.75 << 0.0;
        QTest::newRow("on paper") << QString() << QSizeF(50.8, 50.8 / 1.5) * 72 / 25.4 << 72.0 / 150 << 150.0;
        QTest::newRow("A4") << "a4" << QSizeF(297, 210) * 72 / 25.4 << 297 * 72 / 25.4 / 300 << 150.0;
        QTest::newRow("Letter") << "Letter" << QSizeF(792, 612) << 792.0 / 300 << 0.0;
        QTest::newRow("mm") << "100x200mm" << QSizeF(100, 200) * 72 / 25.4 << 100 * 72 / 25.4 / 300 << 0.0;
        QTest::newRow("in") << "8.5x2in" << QSizeF(612, 144) << 144.0 / 200 << 0.0;
    }
    void pagesHaveTheirSize()
    {
        QFETCH(QString, paper);
        QFETCH(QSizeF, size);
        QFETCH(double, scale);
        QFETCH(double, resolution);
        const PaintingPtr p = oneStroke();
        Result<PreparedDrawing> drawing = prepared(p, DrawingKind::Outlines);
        QVERIFY(bool(drawing));
        drawing->paper = pageSizeFrom(paper);
        drawing->resolution = resolution;
        const std::unique_ptr<QPDF> file = readBack(*bytesOf(*drawing, *p, "a.pdf"));
        QVERIFY(file);
        const std::vector<double> box = numbersOf(pageOf(*file).getKey("/MediaBox"));
        QVERIFY(std::abs(box[2] - size.width()) < 1e-3 && std::abs(box[3] - size.height()) < 1e-3);
        // The sheet lies in the middle.
        const QByteArray content = contentOf(*file);
        const QList<QByteArray> matrix = content.mid(2, content.indexOf(" cm") - 2).split(' ');
        const auto isAt = [&](int k, double value) { return std::abs(matrix[k].toDouble() - value) < 1e-3; };
        QVERIFY2(isAt(0, scale) && isAt(3, -scale) && isAt(4, (size.width() - 300 * scale) / 2) &&
                     isAt(5, (size.height() + 200 * scale) / 2),
                 content.left(80).constData());
    }

    void sizesAreUnderstood()
    {
        QVERIFY(pageSizeFrom("A5")->turns);
        QVERIFY(!pageSizeFrom("210x297mm")->turns);
        QVERIFY(std::abs(pageSizeFrom("25.4X50.8MM")->height - 144) < 1e-9);
        for (const char *text :
             {"", "A", "A4x", "0x10mm", "10x10", "10x10cm", "-1x10mm", "1e9x1mm", "200000x10mm", "x"})
            QVERIFY2(!pageSizeFrom(text), text);
        // Large sheets have larger units.
        Painting large = *oneStroke();
        large.canvas.width = 100'000, large.canvas.height = 50'000;
        const std::unique_ptr<QPDF> file = readBack(pdfOf(std::make_shared<Painting>(large), DrawingKind::Outlines));
        QVERIFY(file);
        QPDFObjectHandle page = pageOf(*file);
        const double unit = page.getKey("/UserUnit").getNumericValue();
        QVERIFY(std::abs(unit * numbersOf(page.getKey("/MediaBox"))[2] - 75'000) < 0.1);
    }

    void hybridIsThePicture()
    {
        std::mt19937_64 random(3);
        const PaintingPtr p = mixedFills(random, 6, 200, 150, PaperKind::Procedural);
        auto clear = std::make_shared<Painting>(*p);
        clear->canvas.background.opacity = 0.25f;
        for (const PaintingPtr &one : {p, PaintingPtr(clear)}) {
            const std::optional<FloatPicture> shown = shownByPoppler(pdfOf(one, DrawingKind::Hybrid));
            if (!shown)
                QSKIP("pdftoppm is not installed");
            FloatPicture exact = exactPicture(one);
            for (std::size_t i = 0; i < exact.rgba.size(); ++i) // over white
                if (i % 4 != 3)
                    exact.rgba.data()[i] = 1 + exact.rgba.data()[i / 4 * 4 + 3] * (exact.rgba.data()[i] - 1);
            const double largest = largestDifference(*shown, exact);
            // Where the canvas is not opaque, colour, alpha and what comes of both are rounded, each by half a level.
            QVERIFY2(
                largest <= (one == p ? 1.0 : 1.5) / 255,
                qPrintable(
                    QString("%1 of 255, opacity %2").arg(255 * largest).arg(double(one->canvas.background.opacity))));
        }
    }

    /// poppler makes edges lighter than what they cover of a pixel, the more the fewer pixels there are.
    void bandsLookLikeTheStroke()
    {
        for (const StyleKind kind : {StyleKind::Uniform, StyleKind::Feathering}) {
            const PaintingPtr p = oneStroke(kind);
            const QByteArray pdf = pdfOf(p, DrawingKind::Bands, 64);
            const std::optional<FloatPicture> shown = shownByPoppler(pdf), large = shownByPoppler(pdf, 8);
            if (!shown || !large)
                QSKIP("pdftoppm is not installed");
            const double largest = largestDifference(meansOf(*large, 8), meansOf(exactPicture(p, 8), 8));
            qInfo("poppler: %.2f of 255 from the picture, %.2f where it draws finer pixels",
                  255 * largestDifference(*shown, exactPicture(p)), 255 * largest);
            QVERIFY2(largest <= 1.0 / 128 + 2.0 / 255, qPrintable(QString::number(255 * largest)));
        }
    }

    /// What is said of the drawing is what another program shows: groups, modes, masks, gradients, pictures.
    void groupsAndPaintsAreShown()
    {
        std::mt19937_64 random(5);
        FloatPicture image;
        image.resize(60, 40);
        for (int i = 0; i < 60 * 40; ++i)
            for (int c = 0; c < 4; ++c)
                image.rgba.data()[4 * i + c] =
                    c < 3 ? float(0.5 + 0.4 * std::sin(c + 0.1 * (i % 60)) * std::cos(0.1 * (i / 60))) : 0.75f;
        ImageOptions options;
        options.alpha = true;
        const Result<QByteArray> png = encodeImage(ImageFormat::Png, image, options, QStringLiteral("test"));
        QVERIFY(bool(png));
        const Picture picture = embeddedPicture(std::make_shared<const QByteArray>(*png), 60, 40);
        Stroke pictured = pictureStroke(picture, Rect::of(20, 30, 120, 80), 0);
        pictured.id = 1;
        std::vector<PaintingPtr> paintings{grouped(), painting({pictured}, 300, 200)};
        for (const auto &[name, p] : boundedGroups())
            paintings.push_back(p);
        for (const PaintingPtr &p : paintings)
            for (const DrawingKind kind : {DrawingKind::Outlines, DrawingKind::Bands}) {
                const Result<PreparedDrawing> drawing = prepared(p, kind, 64);
                QVERIFY(bool(drawing));
                const std::optional<FloatPicture> shown = shownByPoppler(*bytesOf(*drawing, *p, "a.pdf"));
                if (!shown)
                    QSKIP("pdftoppm is not installed");
                const FloatPicture own = pictureOf(drawing->drawing, View::ofArea(p->canvas.area(), 300, 200));
                double sum = 0;
                for (std::size_t i = 0; i < own.rgba.size(); ++i)
                    sum += i % 4 == 3 ? 0 : double(std::abs(own.rgba.data()[i] - shown->rgba.data()[i]));
                const double mean = sum / (0.75 * double(own.rgba.size()));
                QVERIFY2(mean < 0.5 / 255, qPrintable(QString::number(255 * mean)));
            }
    }

    void comesBackBitForBit_data() { filesAreSound_data(); }
    void comesBackBitForBit()
    {
        QFETCH(int, kind);
        std::mt19937_64 random(11);
        for (int i = 0; i < trials(1, 30); ++i) {
            const PaintingPtr p = mixedFills(random, 3, 60, 46, PaperKind::Procedural);
            const QByteArray pdf = pdfOf(p, DrawingKind(kind), 8);
            QCOMPARE(detectFormat(pdf), FileFormat::Pdf);
            const Result<LoadedDocument> back = readDocument(pdf, "a.pdf");
            QVERIFY2(bool(back), qPrintable(back.error()));
            QVERIFY(back->painting == *p);
            QCOMPARE(writeSuffuseFile(back->painting), writeSuffuseFile(*p));
            QVERIFY2(back->leftOut.isEmpty(), qPrintable(back->leftOut));
        }
    }

    void severalPaintingsArePages()
    {
        std::vector<PreparedDrawing> drawings;
        std::vector<Painting> paintings;
        for (const PaintingPtr &p : {oneStroke(), PaintingPtr(grouped()), oneStroke(StyleKind::Edge)}) {
            Result<PreparedDrawing> drawing = prepared(p, DrawingKind::Hybrid);
            QVERIFY(bool(drawing));
            drawings.push_back(std::move(*drawing));
            paintings.push_back(*p);
        }
        drawings[1].paper = pageSizeFrom("A5");
        const QByteArray pdf = *bytesOf(drawings, paintings, "a.pdf");
        const std::unique_ptr<QPDF> file = readBack(pdf);
        QVERIFY(file);
        QCOMPARE(file->getAllPages().size(), 3u);
        QVERIFY(std::abs(numbersOf(pageOf(*file, 1).getKey("/MediaBox"))[2] - 210 * 72 / 25.4) < 1e-3);
        // The outlines of each page, and the group.
        QCOMPARE(file->getRoot().getKey("/OCProperties").getKey("/OCGs").getArrayNItems(), 4);
        const Result<LoadedDocument> back = readDocument(pdf, "a.pdf");
        QVERIFY(bool(back));
        QVERIFY(back->painting == paintings[0]);
        QVERIFY2(back->leftOut.contains('3'), qPrintable(back->leftOut));
    }

    void changedAndForeignFilesAreTold()
    {
        const PaintingPtr p = oneStroke();
        const QByteArray pdf = pdfOf(p, DrawingKind::Outlines);
        const std::unique_ptr<QPDF> file = readBack(pdf);
        QVERIFY(file);
        // Another program writes it again: the painting is in it still.
        QPDFWriter writer(*file);
        writer.setOutputMemory();
        writer.write();
        const auto again = writer.getBufferSharedPointer();
        const QByteArray changed(reinterpret_cast<const char *>(again->getBuffer()), qsizetype(again->getSize()));
        const Result<LoadedDocument> back = readDocument(changed, "a.pdf");
        QVERIFY(bool(back));
        QVERIFY(back->painting == *p);
        QVERIFY(back->leftOut.contains("changed"));
        // One without a painting.
        file->getRoot().removeKey("/Names");
        QPDFWriter bare(*file);
        bare.setOutputMemory();
        bare.write();
        const auto rest = bare.getBufferSharedPointer();
        const QByteArray foreign(reinterpret_cast<const char *>(rest->getBuffer()), qsizetype(rest->getSize()));
        const Result<LoadedDocument> none = readDocument(foreign, "a.pdf");
        QVERIFY2(!none && none.error().startsWith("a.pdf: This PDF file holds no painting"), qPrintable(none.error()));
        const Result<LoadedDocument> broken = readDocument("%PDF-1.7\nnothing", "a.pdf");
        QVERIFY2(!broken && broken.error().startsWith("a.pdf: This PDF file is damaged"), qPrintable(broken.error()));
    }

    void profilesAreIntents()
    {
        const PaintingPtr p = oneStroke();
        Result<PreparedDrawing> drawing = prepared(p, DrawingKind::Outlines);
        QVERIFY(bool(drawing));
        drawing->about.profile = wideProfile();
        QVERIFY(!drawing->about.profile.isEmpty());
        const std::unique_ptr<QPDF> file = readBack(*bytesOf(*drawing, *p, "a.pdf"));
        QVERIFY(file);
        const auto data =
            file->getRoot().getKey("/OutputIntents").getArrayItem(0).getKey("/DestOutputProfile").getStreamData();
        QVERIFY(QByteArray(reinterpret_cast<const char *>(data->getBuffer()), qsizetype(data->getSize())) ==
                drawing->about.profile);
        // Numbers stay those of sRGB, and say so.
        QPDFObjectHandle spaces = pageOf(*file).getKey("/Resources").getKey("/ColorSpace");
        QVERIFY(spaces.getKey("/DefaultRGB").getArrayItem(0).isNameAndEquals("/ICCBased"));
    }

    void addingGroupsAreTold()
    {
        const std::shared_ptr<Painting> p = grouped();
        QVERIFY(leftOutOf(*prepared(p, DrawingKind::Outlines)).isEmpty());
        p->groups[0].blend = BlendMode::Plus;
        const Result<PreparedDrawing> drawing = prepared(p, DrawingKind::Outlines);
        QVERIFY(bool(drawing));
        QVERIFY2(leftOutOf(*drawing).contains("PDF") && leftOutOf(*drawing).contains('1'),
                 qPrintable(leftOutOf(*drawing)));
        QVERIFY(readBack(*bytesOf(*drawing, *p, "a.pdf")));
    }

    void cancelledWorkLeavesNothing()
    {
        const PaintingPtr p = oneStroke();
        const Result<PreparedDrawing> drawing = prepared(p, DrawingKind::Bands);
        QVERIFY(bool(drawing));
        const std::atomic<bool> cancel = true;
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.pdf");
        const Result<void> saved = saveDrawing(*drawing, *p, path, &cancel);
        QVERIFY(!saved && saved.error().contains("interrupted"));
        QVERIFY(QDir(folder.path()).isEmpty());
        QVERIFY(bool(saveDrawing(*drawing, *p, path)));
        QVERIFY(QFileInfo(path).size() > 1000);
    }
};

QTEST_GUILESS_MAIN(TestDrawingPdf)
#include "test_drawing_pdf.moc"
