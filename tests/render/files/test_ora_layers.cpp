// The layers of OpenRaster files: they come in as groups with a picture each, and show what the file shows.
#include "tests/files.h"
#include "tests/render/files/locked_texts.h"
#include "tests/render/layers/grouped.h"

#include "model/formats/files.h"
#include "model/formats/ora/composite_op.h"
#include "model/formats/ora/ora_layers.h"
#include "render/layered/ora_file.h"
#include "render/layered/zip_writer.h"
#include "tests/trials.h"

#include <QTemporaryDir>

using namespace suffuse;
using namespace suffuse::test;

namespace {

/// A picture of one colour as the bytes of a PNG.
QByteArray png(int width, int height, float red, float green, float blue, float alpha)
{
    FloatPicture picture;
    picture.resize(width, height);
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        picture.rgba[i] = red, picture.rgba[i + 1] = green, picture.rgba[i + 2] = blue, picture.rgba[i + 3] = alpha;
    ImageOptions options;
    options.alpha = true;
    const Result<QByteArray> bytes = encodeImage(ImageFormat::Png, picture, options, QStringLiteral("test"));
    return bytes ? *bytes : QByteArray();
}

} // namespace

class TestOraLayers : public QObject {
    Q_OBJECT

    std::unique_ptr<Renderer> m_cpu = make(Backend::Cpu);
    QTemporaryDir m_folder;

    QString path(const QString &name) const { return m_folder.filePath(name); }

    /// An OpenRaster file with a stack and some parts.
    QByteArray file(const QByteArray &stack, const std::vector<std::pair<QString, QByteArray>> &parts)
    {
        FileReplacement replaced(path("made.ora"));
        if (!replaced.open())
            return {};
        ZipWriter zip(replaced);
        bool whole = bool(zip.add("mimetype", "image/openraster", false));
        for (const auto &[name, bytes] : parts)
            whole &= bool(zip.add(name, bytes, false));
        whole &= bool(zip.add("stack.xml", stack, true)) && zip.finish() && replaced.commit();
        return whole ? bytesOf(path("made.ora")) : QByteArray();
    }

    /// What the painting's own export looks like to a program that knows nothing of the painting in it.
    Result<Painting> layersOf(const PaintingPtr &painting, const View &view, int bits, FloatPicture &picture)
    {
        const auto renderer = make(Backend::Cpu), groups = make(Backend::Cpu);
        LayeredRequest request;
        request.painting = painting, request.time = painting->end(), request.view = view, request.bits = bits;
        if (const auto written = writeOpenRaster(path("a.ora"), request, *renderer, *groups); !written)
            return Error{written.error()};
        picture = test::render(*m_cpu, painting, view);
        QString leftOut;
        Result<Painting> layers = ora::readLayers(bytesOf(path("a.ora")), leftOut);
        return leftOut.isEmpty() ? std::move(layers) : Result<Painting>(Error{leftOut});
    }

    void compare(const PaintingPtr &painting, const View &view, int bits, const QString &name, double levels)
    {
        FloatPicture expected;
        const Result<Painting> layers = layersOf(painting, view, bits, expected);
        QVERIFY2(layers, qPrintable(name + (layers ? QString() : layers.error())));
        QCOMPARE(layers->canvas.area(), Rect::of(0, 0, view.width, view.height));
        const auto shown = std::make_shared<const Painting>(*layers);
        const FloatPicture got =
            test::render(*m_cpu, shown, View::ofArea(shown->canvas.area(), view.width, view.height));
        double greatest = 0;
        for (std::size_t i = 0; i < got.rgba.size(); ++i)
            greatest = std::max(greatest, std::abs(double(got.rgba[i]) - double(expected.rgba[i])));
        // Levels of 8 bits; this program rounds nothing between the layers.
        QVERIFY2(greatest <= (bits == 8 ? levels / 255 : 1.0 / 4096),
                 qPrintable(QStringLiteral("%1, %2 bits: %3 levels").arg(name).arg(bits).arg(255 * greatest)));
    }

private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }

    void exportedSamplesComeInAsTheyLook()
    {
        for (const char *name : {"flat", "lanterns", "still-life"})
            for (const int bits : {8, 16}) {
                Result<Painting> sample =
                    loadPainting(QStringLiteral(SUFFUSE_SOURCE_DIR "/packaging/samples/%1.suffuse").arg(name));
                QVERIFY(sample);
                const Rect area = sample->canvas.area();
                compare(std::make_shared<const Painting>(std::move(*sample)),
                        View::ofArea(area, 160, int(std::lround(160 * area.height() / area.width()))), bits, name, 1);
            }
    }

    void exportedTreesComeInAsTheyLook()
    {
        for (int i = 0; i < trials(30, 500); ++i) {
            std::mt19937_64 random(firstSeed() + unsigned(i) + 900);
            auto p = std::make_shared<Painting>(*grouped(painting(randomStrokes(random, 10, 64, 48), 64, 48), random));
            for (Group &g : p->groups)
                g.clips = g.mask = false;
            p->canvas.background.opacity = 1;
            compare(p, View::ofArea(p->canvas.area(), 64, 48), i % 2 ? 8 : 16, QStringLiteral("tree %1").arg(i), 2);
        }
    }

    void attributesAndPlaces()
    {
        const QByteArray bytes =
            file(R"(<?xml version="1.0"?><image version="0.0.5" w="40" h="30"><stack>
            <layer name="a &amp; b" src="data/1.png" x="-3" y="4" opacity="0.25" composite-op="svg:multiply"
                edit-locked="true"/>
            <stack name="folder" x="10" y="1" isolation="isolate" visibility="hidden">
                <layer name="in it" src="data/2.png" x="2" y="3"/>
                <stack name="inner" opacity="0.5"><layer src="data/1.png"/></stack>
            </stack>
            <layer name="lowest" src="data/2.png" composite-op="krita:hard_mix"/>
        </stack></image>)",
                 {{"data/1.png", png(8, 6, 1, 0, 0, 0.5f)}, {"data/2.png", png(5, 7, 0, 0, 1, 1)}});
        QVERIFY(!bytes.isEmpty());
        QCOMPARE(detectFormat(bytes), FileFormat::OpenRaster);
        const Result<LoadedDocument> read = readDocument(bytes, "a.ora");
        QVERIFY2(read, qPrintable(read ? QString() : read.error()));
        const Painting &p = read->painting;
        QVERIFY2(read->leftOut.contains("mode"), qPrintable(read->leftOut));
        QCOMPARE(p.canvas.background.opacity, 0.0f);
        QCOMPARE(p.strokes.size(), std::size_t(4));
        QCOMPARE(p.groups.size(), std::size_t(6));
        const auto groupOf = [&](std::size_t stroke) {
            return *std::ranges::find(p.groups, p.strokes[stroke]->group, &Group::id);
        };
        const auto parentOf = [&](const Group &g) { return *std::ranges::find(p.groups, g.parent, &Group::id); };
        QCOMPARE(groupOf(0).name, QString("lowest"));
        QCOMPARE(groupOf(0).blend, BlendMode::Normal);
        QCOMPARE(parentOf(groupOf(1)).name, QString("inner"));
        QCOMPARE(parentOf(groupOf(1)).opacity, 0.5f);
        QCOMPARE(parentOf(parentOf(groupOf(1))).name, QString("folder"));
        QVERIFY(parentOf(parentOf(groupOf(1))).isolated && !parentOf(parentOf(groupOf(1))).visible);
        QCOMPARE(groupOf(2).name, QString("in it"));
        const Group top = groupOf(3);
        QCOMPARE(top.name, QString("a & b"));
        QCOMPARE(top.opacity, 0.25f);
        QCOMPARE(top.blend, BlendMode::Multiply);
        QVERIFY(top.locked && top.visible && top.isolated && top.parent == 0);
        QCOMPARE(p.strokes[3]->origin, (Point{-3, 4}));
        QCOMPARE(p.strokes[2]->origin, (Point{12, 4}));
        QCOMPARE(p.strokes[1]->origin, (Point{10, 1}));
        // What is in the file twice is in the painting once.
        QCOMPARE(p.strokes[0]->picture->image, p.strokes[2]->picture->image);
        QCOMPARE(p.strokes[0]->picture->width, 5u);
        QCOMPARE(p.strokes[0]->picture->height, 7u);
        // It is kept as any painting is.
        const Result<Painting> again = readPainting(writePainting(p, FileFormat::Suffuse), "a.suffuse");
        QVERIFY(again && *again == p);
    }

    void textsAndLocksComeBack()
    {
        FloatPicture picture;
        const Result<Painting> layers =
            layersOf(lockedTexts(), View::ofArea(Rect::of(0, 0, 64, 48), 64, 48), 8, picture);
        QVERIFY2(layers, qPrintable(layers ? QString() : layers.error()));
        QCOMPARE(namesAndLocks(layers->groups), lockedTextsInFiles);
    }

    void everyModeComesBack()
    {
        for (int mode = 0; mode < blendModes; ++mode) {
            if (BlendMode(mode) != BlendMode::Exclusion)
                QCOMPARE(ora::blendModeFrom(ora::compositeOp(BlendMode(mode))), BlendMode(mode));
        }
        QCOMPARE(ora::compositeOp(BlendMode::Exclusion), QString("svg:src-over"));
        QCOMPARE(ora::blendModeFrom("krita:exclusion"), BlendMode::Exclusion);
        QVERIFY(!ora::blendModeFrom("svg:"));
    }

    /// What is missing is counted, and what cannot be a stack is refused in words.
    void badFiles()
    {
        const auto picture = png(4, 4, 0, 1, 0, 1);
        QByteArray huge = picture;
        huge.replace(16, 8, QByteArray("\x00\x01\x00\x00\x00\x01\x00\x00", 8));
        const QByteArray some = file(
            R"(<image w="9" h="9"><stack><layer src="no"/><layer src="huge"/><layer src="text"/><layer/>
               <layer src="data" x="nan" y="1e300"/></stack></image>)",
            {{"huge", huge}, {"text", "no picture"}, {"data", picture}});
        const Result<LoadedDocument> read = readDocument(some, "a.ora");
        QVERIFY(read);
        QCOMPARE(read->painting.strokes.size(), std::size_t(1));
        QCOMPARE(read->painting.strokes[0]->origin, Point());
        QVERIFY2(read->leftOut.contains("4 layer"), qPrintable(read->leftOut));

        QByteArray deep = "<image w=\"9\" h=\"9\">";
        for (int i = 0; i < 1000; ++i)
            deep += "<stack>";
        for (int i = 0; i < 1000; ++i)
            deep += "</stack>";
        QByteArray many = "<image w=\"9\" h=\"9\"><stack>";
        for (int i = 0; i < 20'000; ++i)
            many += "<layer src=\"data\"/>";
        for (const QByteArray &stack :
             {deep + "</image>", many + "</stack></image>", QByteArray("<image><stack/></image>"),
              QByteArray("<image w=\"-1\" h=\"5\"><stack/></image>"), QByteArray("<image w=\"9\" h=\"nan\"/>"),
              QByteArray("<image w=\"9\" h=\"9e9\"/>"), QByteArray("<image w=\"9\" h=\"9\"><stack>"),
              QByteArray("no xml"), QByteArray()}) {
            const Result<LoadedDocument> refused = readDocument(file(stack, {{"data", picture}}), "b.ora");
            QVERIFY2(!refused, stack.left(60).constData());
            QVERIFY2(refused.error().startsWith("b.ora: ") && refused.error().contains("list of layers"),
                     qPrintable(refused.error()));
        }
    }

    void damagedFiles()
    {
        const QByteArray whole = file(
            R"(<image w="9" h="9"><stack><layer src="a"/><stack><layer src="b" opacity="0.5"/></stack></stack></image>)",
            {{"a", png(4, 4, 0, 1, 0, 1)}, {"b", png(5, 4, 0, 1, 1, 0.5f)}});
        QVERIFY(!whole.isEmpty());
        int refused = 0, told = 0;
        for (int i = 0; i < trials(500, 2000); ++i) {
            std::mt19937_64 random(firstSeed() + unsigned(i));
            QByteArray bytes = whole;
            for (std::uint64_t n = 1 + random() % 4; n > 0; --n)
                bytes[qsizetype(random() % std::uint64_t(bytes.size()))] = char(random());
            const Result<LoadedDocument> document = readDocument(bytes, "damaged.ora");
            refused += !document;
            told += document && !document->leftOut.isEmpty();
            QVERIFY(document || !document.error().isEmpty());
        }
        QVERIFY2(refused > 10 && told > 0, qPrintable(QStringLiteral("%1, %2").arg(refused).arg(told)));
    }
};

QTEST_GUILESS_MAIN(TestOraLayers)
#include "test_ora_layers.moc"
