// The layers of Photoshop files: those that are written here come in as they look, and other ones as far as they go.
#include "tests/files.h"
#include "tests/render/files/locked_texts.h"
#include "tests/render/layers/grouped.h"

#include "model/formats/files.h"
#include "model/formats/psd/pack_bits.h"
#include "model/formats/psd/psd_channels.h"
#include "model/formats/psd/psd_layers.h"
#include "render/image_io/embedded_profile.h"
#include "render/layered/psd_file.h"
#include "render/scene/picture.h"
#include "tests/trials.h"

#include <QDataStream>
#include <QTemporaryDir>

using namespace suffuse;
using namespace suffuse::test;

namespace {

/// Parts of a file that others might have written.
struct OtherLayer {
    QByteArray name = "layer", mode = "norm";
    qint32 top = 0, left = 0, height = 2, width = 3;
    quint8 opacity = 255, clipping = 0, flags = 8;
    std::vector<std::pair<qint16, QByteArray>> channels{}; ///< ids, and what they have behind the packing's code
    quint16 packing = 0;
    QByteArray mask{};   ///< its description
    QByteArray blocks{}; ///< with their keys
};

QByteArray block(const char *key, const QByteArray &content)
{
    QByteArray out;
    QDataStream stream(&out, QIODevice::WriteOnly);
    stream.writeRawData("8BIM", 4), stream.writeRawData(key, 4);
    stream << quint32(content.size());
    return out + content + QByteArray(content.size() % 2, '\0');
}

QByteArray divider(quint32 kind, const char *mode)
{
    QByteArray out;
    QDataStream stream(&out, QIODevice::WriteOnly);
    stream << kind;
    return block("lsct", out + "8BIM" + mode);
}

QByteArray fileOf(const std::vector<OtherLayer> &layers, quint16 bits = 8, quint16 mode = 3,
                  const QByteArray &resources = {})
{
    QByteArray records, pixels;
    QDataStream r(&records, QIODevice::WriteOnly), p(&pixels, QIODevice::WriteOnly);
    const auto raw = [](QDataStream &stream, const QByteArray &bytes) {
        stream.writeRawData(bytes.constData(), int(bytes.size()));
    };
    r << qint16(-qint16(layers.size()));
    for (const OtherLayer &layer : layers) {
        r << layer.top << layer.left << layer.top + layer.height << layer.left + layer.width;
        r << quint16(layer.channels.size());
        for (const auto &[id, bytes] : layer.channels) {
            r << id << quint32(2 + bytes.size());
            p << layer.packing;
            raw(p, bytes);
        }
        raw(r, "8BIM" + layer.mode);
        r << layer.opacity << layer.clipping << layer.flags << quint8(0);
        const QByteArray name = layer.name.left(255);
        const qsizetype named = (1 + name.size() + 3) / 4 * 4;
        r << quint32(8 + layer.mask.size() + named + layer.blocks.size()) << quint32(layer.mask.size());
        raw(r, layer.mask);
        r << quint32(0) << quint8(name.size());
        raw(r, name + QByteArray(named - 1 - name.size(), '\0') + layer.blocks);
    }
    QByteArray out;
    QDataStream stream(&out, QIODevice::WriteOnly);
    raw(stream, "8BPS");
    stream << quint16(1);
    raw(stream, QByteArray(6, '\0'));
    stream << quint16(3) << quint32(8) << quint32(10) << bits << mode << quint32(0) << quint32(resources.size());
    raw(stream, resources);
    const QByteArray content = records + pixels;
    stream << quint32(content.size() + 8) << quint32(content.size());
    raw(stream, content);
    stream << quint32(0) << quint16(0);
    raw(stream, QByteArray(8 * 10 * 3 * (bits / 8), '\0'));
    return out;
}

std::vector<std::pair<qint16, QByteArray>> plain(quint8 red, quint8 alpha, qsizetype pixels = 6)
{
    return {{qint16(-1), QByteArray(pixels, char(alpha))},
            {qint16(0), QByteArray(pixels, char(red))},
            {qint16(1), QByteArray(pixels, '\0')},
            {qint16(2), QByteArray(pixels, '\0')}};
}

} // namespace

class TestPsdLayers : public QObject {
    Q_OBJECT

    std::unique_ptr<Renderer> m_cpu = make(Backend::Cpu);
    QTemporaryDir m_folder;

    QString path(const QString &name) const { return m_folder.filePath(name); }

    void compare(const PaintingPtr &painting, const View &view, int bits, const QString &name, double levels)
    {
        const auto renderer = make(Backend::Cpu), groups = make(Backend::Cpu);
        LayeredRequest request;
        request.painting = painting, request.time = painting->end(), request.view = view, request.bits = bits;
        const auto written = writePsd(path("a.psd"), request, *renderer, *groups);
        QVERIFY2(written, qPrintable(written ? QString() : written.error()));
        const FloatPicture expected = test::render(*m_cpu, painting, view);
        const Result<LoadedDocument> read = loadDocument(path("a.psd"));
        QVERIFY2(read, qPrintable(read ? QString() : read.error()));
        QCOMPARE(read->format, FileFormat::Photoshop);
        QCOMPARE(read->leftOut, QString());
        for (const StrokePtr &stroke : read->painting.strokes) {
            const auto shown = pictureLevels(*stroke->picture, name);
            QVERIFY2(shown, qPrintable(shown ? QString() : shown.error()));
        }
        const auto layers = std::make_shared<const Painting>(read->painting);
        QCOMPARE(layers->canvas.area(), Rect::of(0, 0, view.width, view.height));
        const FloatPicture got =
            test::render(*m_cpu, layers, View::ofArea(layers->canvas.area(), view.width, view.height));
        double greatest = 0;
        for (std::size_t i = 0; i < got.rgba.size(); ++i)
            greatest = std::max(greatest, std::abs(double(got.rgba[i]) - double(expected.rgba[i])));
        QVERIFY2(greatest <= (bits == 8 ? levels / 255 : 1.0 / 4096),
                 qPrintable(QStringLiteral("%1, %2 bits: %3 levels").arg(name).arg(bits).arg(255 * greatest)));
    }

private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }

    void packing()
    {
        std::mt19937_64 random(7);
        for (int i = 0; i < 2000; ++i) {
            QByteArray row(qsizetype(random() % 700), Qt::Uninitialized);
            const std::uint64_t colours = 1 + random() % 4;
            for (char &byte : row)
                byte = random() % 3 && &byte > row.data() ? *(&byte - 1) : char(random() % colours);
            QByteArray packed;
            packBits(reinterpret_cast<const std::uint8_t *>(row.constData()), std::size_t(row.size()), packed);
            QVERIFY(packed.size() <= row.size() + (row.size() + 127) / 128);
            QByteArray back(row.size(), Qt::Uninitialized);
            const auto unpack = [&](qsizetype size, qsizetype bytes) {
                return unpackBits(reinterpret_cast<const std::uint8_t *>(packed.constData()), std::size_t(size),
                                  reinterpret_cast<std::uint8_t *>(back.data()), std::size_t(bytes));
            };
            QVERIFY(unpack(packed.size(), row.size()));
            QCOMPARE(back, row);
            if (!row.isEmpty()) {
                QVERIFY(!unpack(packed.size() - 1, row.size()));
                QVERIFY(!unpack(packed.size(), row.size() - 1));
            }
        }
    }

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
            std::mt19937_64 random(firstSeed() + unsigned(i) + 1300);
            auto p = std::make_shared<Painting>(*grouped(painting(randomStrokes(random, 10, 64, 48), 64, 48), random));
            for (Group &g : p->groups)
                g.clips = g.mask = false;
            p->canvas.background.opacity = 1;
            compare(p, View::ofArea(p->canvas.area(), 64, 48), i % 2 ? 8 : 16, QStringLiteral("tree %1").arg(i), 2);
        }
    }

    /// Names, folders, modes, opacities and masks of files that other programs wrote.
    void textsAndLocksComeBack()
    {
        compare(lockedTexts(), View::ofArea(Rect::of(0, 0, 64, 48), 64, 48), 8, "texts", 1);
        const Result<LoadedDocument> read = loadDocument(path("a.psd"));
        QVERIFY(read);
        QCOMPARE(namesAndLocks(read->painting.groups), lockedTextsInFiles);
    }

    void attributes()
    {
        QByteArray unicode;
        QDataStream stream(&unicode, QIODevice::WriteOnly);
        stream << quint32(2) << quint16(u'水') << quint16(u'墨');
        QByteArray mask;
        QDataStream from(&mask, QIODevice::WriteOnly);
        from << qint32(0) << qint32(0) << qint32(2) << qint32(1) << quint8(0) << quint8(0) << quint16(0); // one column
        auto masked = plain(255, 255);
        masked.emplace_back(qint16(-2), QByteArray("\xff\x80", 2));
        const std::vector<OtherLayer> layers{
            {.name = "lowest", .channels = plain(200, 255), .blocks = block("luni", unicode)},
            {.height = 0, .width = 0, .blocks = divider(3, "norm")},
            {.name = "in it",
             .mode = "mul ",
             .top = 3,
             .left = -1,
             .opacity = 51,
             .clipping = 1,
             .flags = 10,
             .channels = plain(9, 128)},
            {.name = "folder", .height = 0, .width = 0, .opacity = 128, .blocks = divider(1, "scrn")},
            {.name = "strange", .mode = "diss", .channels = masked, .mask = mask},
            {.name = "levels", .height = 0, .width = 0, .blocks = block("levl", "1234")},
            {.name = "lit", .channels = plain(1, 1), .blocks = block("lfx2", "1234")},
        };
        const Result<LoadedDocument> read = readDocument(fileOf(layers), "a.psd");
        QVERIFY2(read, qPrintable(read ? QString() : read.error()));
        const Painting &p = read->painting;
        QCOMPARE(p.canvas.area(), Rect::of(0, 0, 10, 8));
        QCOMPARE(p.strokes.size(), std::size_t(4));
        const auto groupOf = [&](std::size_t stroke) {
            return *std::ranges::find(p.groups, p.strokes[stroke]->group, &Group::id);
        };
        QCOMPARE(groupOf(0).name, QStringLiteral("水墨"));
        const Group in = groupOf(1);
        QCOMPARE(in.name, QString("in it"));
        QCOMPARE(in.blend, BlendMode::Multiply);
        QCOMPARE(in.opacity, 0.2f);
        QVERIFY(in.clips && !in.visible && in.isolated);
        QCOMPARE(p.strokes[1]->origin, (Point{-1, 3}));
        const Group folder = *std::ranges::find(p.groups, in.parent, &Group::id);
        QCOMPARE(folder.name, QString("folder"));
        QCOMPARE(folder.blend, BlendMode::Screen);
        QCOMPARE(folder.opacity, 128 / 255.0f);
        QVERIFY(folder.isolated && folder.visible && folder.parent == 0);
        QCOMPARE(groupOf(2).blend, BlendMode::Normal);
        for (const char *told : {"mode(s) of 1 layer", "1 adjustment", "effects of 1 layer"})
            QVERIFY2(read->leftOut.contains(told), qPrintable(read->leftOut));
        const Result<PictureLevelsPtr> shown = pictureLevels(*p.strokes[2]->picture, "a.psd");
        QVERIFY2(shown, qPrintable(shown ? QString() : shown.error()));
        const std::uint16_t *rgba = (*shown)->level(0).rgba;
        QCOMPARE(int(rgba[3]), 65535); // the mask's two pixels
        QCOMPARE(int(rgba[3 + 4 * 3]), 128 * 257);
        QCOMPARE(int(rgba[3 + 4]), 0); // beyond it
        const Result<Painting> again = readPainting(writePainting(p, FileFormat::Suffuse), "a.suffuse");
        QVERIFY(again && *again == p);
    }

    /// Each way of packing gives the same pixels.
    void packings()
    {
        const QByteArray rows("\x01\x05\x02\x07\x07\x03", 6), differences("\x01\x04\xfd\x07\x00\xfc", 6);
        const psd::ChannelShape shape{3, 2, 8};
        const QByteArray packed = psd::packRows(rows, shape).bytes;
        const auto stored = [](char code, const QByteArray &content) { return QByteArray(1, '\0') + code + content; };
        for (const QByteArray &way : {stored(0, rows), stored(1, QByteArray("\0\4\0\4", 4) + packed),
                                      stored(2, qCompress(rows).mid(4)), stored(3, qCompress(differences).mid(4))}) {
            const std::optional<PackedRows> got = psd::packedRows(way, shape);
            QVERIFY2(got, way.toHex().constData());
            QCOMPARE(psd::unpackedRows(*got, shape), rows);
        }
        const QByteArray steps("\x01\x00\xff\xff\xfe\xff", 6);
        const auto got = psd::packedRows(stored(3, qCompress(steps).mid(4)), {3, 1, 16});
        QVERIFY(got);
        QCOMPARE(psd::unpackedRows(*got, {3, 1, 16}).toHex(), QByteArray("010000fffffe"));
        for (const QByteArray &bad : {stored(0, rows.left(5)), stored(1, QByteArray("\0\4\0\3", 4) + packed),
                                      stored(2, qCompress(rows.left(5)).mid(4)), stored(2, "nothing"), stored(9, rows)})
            QVERIFY2(!psd::packedRows(bad, shape), bad.toHex().constData());
    }

    void flatFiles()
    {
        const Result<LoadedDocument> read = readDocument(fileOf({}), "flat.psd");
        QVERIFY2(read, qPrintable(read ? QString() : read.error()));
        QCOMPARE(read->painting.strokes.size(), std::size_t(1));
        QCOMPARE(read->painting.strokes[0]->picture->width, 10u);
        QCOMPARE(read->painting.strokes[0]->picture->height, 8u);
    }

    /// The profile of the file is that of each layer's image, wherever it stands among the resources.
    void profile()
    {
        const auto resource = [](quint16 id, const QByteArray &name, const QByteArray &content) {
            QByteArray out("8BIM");
            QDataStream stream(&out, QIODevice::WriteOnly | QIODevice::Append);
            stream << id << quint8(name.size());
            out += name + QByteArray((name.size() + 1) % 2, '\0');
            QDataStream rest(&out, QIODevice::WriteOnly | QIODevice::Append);
            rest << quint32(content.size());
            return out + content + QByteArray(content.size() % 2, '\0');
        };
        const QByteArray icc = "what this profile says";
        const QByteArray resources =
            resource(1005, "ab", "odd") + resource(1039, "c", icc) + resource(1060, {}, "behind");
        for (const std::vector<OtherLayer> &layers : {std::vector<OtherLayer>{{.channels = plain(200, 255)}}, {}}) {
            const Result<LoadedDocument> read = readDocument(fileOf(layers, 8, 3, resources), "p.psd");
            QVERIFY2(read, qPrintable(read ? QString() : read.error()));
            QCOMPARE(read->painting.strokes.size(), std::size_t(1));
            QCOMPARE(embeddedProfile(*read->painting.strokes[0]->picture->image, ImageFormat::Tiff), icc);
        }
        const QByteArray torn = resource(1039, {}, icc).left(20);
        const Result<LoadedDocument> read = readDocument(fileOf({}, 8, 3, torn), "torn.psd");
        QVERIFY2(read, qPrintable(read ? QString() : read.error()));
        QVERIFY(embeddedProfile(*read->painting.strokes[0]->picture->image, ImageFormat::Tiff).isEmpty());
    }

    void badFiles()
    {
        QByteArray psb = fileOf({});
        psb[5] = 2;
        const OtherLayer end{.height = 0, .width = 0, .blocks = divider(3, "norm")};
        const OtherLayer open{.height = 0, .width = 0, .blocks = divider(1, "norm")};
        const std::pair<QByteArray, const char *> bad[] = {{psb, "PSB"},
                                                           {fileOf({}, 8, 4), "RGB"},
                                                           {fileOf({}, 32), "RGB"},
                                                           {fileOf({open}), "damaged"},
                                                           {fileOf({end}), "damaged"},
                                                           {fileOf(std::vector<OtherLayer>(200, end)), "damaged"},
                                                           {fileOf({{.channels = plain(1, 1)}}).left(150), "damaged"},
                                                           {QByteArray("8BPS") + QByteArray(40, '\xff'), "PSB"}};
        for (const auto &[bytes, word] : bad) {
            const Result<LoadedDocument> refused = readDocument(bytes, "b.psd");
            QVERIFY2(!refused, word);
            QVERIFY2(refused.error().startsWith("b.psd: ") && refused.error().contains(word),
                     qPrintable(refused.error()));
        }
        // A layer that cannot be read is told, and the others stay.
        const Result<LoadedDocument> some = readDocument(
            fileOf({{.channels = plain(1, 1, 5)}, {.height = 1 << 20, .width = 1 << 20}, {.channels = plain(1, 1)}}),
            "c.psd");
        QVERIFY2(some, qPrintable(some ? QString() : some.error()));
        QCOMPARE(some->painting.strokes.size(), std::size_t(1));
        QVERIFY2(some->leftOut.contains("2 layer"), qPrintable(some->leftOut));
    }

    void damagedFiles()
    {
        const QByteArray whole = fileOf({{.channels = plain(200, 255)},
                                         {.height = 0, .width = 0, .blocks = divider(3, "norm")},
                                         {.mode = "mul ", .channels = plain(9, 128)},
                                         {.height = 0, .width = 0, .blocks = divider(1, "scrn")}});
        int refused = 0, told = 0;
        for (int i = 0; i < trials(1000, 4000); ++i) {
            std::mt19937_64 random(firstSeed() + unsigned(i));
            QByteArray bytes = whole;
            for (std::uint64_t n = 1 + random() % 4; n > 0; --n)
                bytes[qsizetype(4 + random() % std::uint64_t(bytes.size() - 4))] = char(random());
            if (random() % 4 == 0)
                bytes.truncate(qsizetype(random() % std::uint64_t(bytes.size())));
            const Result<LoadedDocument> document = readDocument(bytes, "damaged.psd");
            refused += !document;
            told += document && !document->leftOut.isEmpty();
            QVERIFY(document || !document.error().isEmpty());
        }
        QVERIFY2(refused > 10 && told > 0, qPrintable(QStringLiteral("%1, %2").arg(refused).arg(told)));
    }

    void stoppedAndRefused()
    {
        const auto renderer = make(Backend::Cpu), groups = make(Backend::Cpu);
        Result<Painting> sample = loadPainting(SUFFUSE_SOURCE_DIR "/packaging/samples/lanterns.suffuse");
        QVERIFY(sample);
        std::atomic<bool> cancel{false};
        LayeredRequest request;
        request.painting = std::make_shared<const Painting>(std::move(*sample));
        request.time = request.painting->end();
        request.view = View::ofArea(request.painting->canvas.area(), 120, 160);
        request.cancel = &cancel;
        request.progress = [&](std::size_t done, std::size_t) { cancel = done >= 5; };
        const QStringList before = QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden);
        const auto stopped = writePsd(path("stopped.psd"), request, *renderer, *groups);
        QVERIFY(!stopped && stopped.error().contains("nothing"));
        QCOMPARE(QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden), before);
        request.view.width = 40'000;
        const auto tooWide = writePsd(path("wide.psd"), request, *renderer, *groups);
        QVERIFY(!tooWide && tooWide.error().contains("30000"));
    }
};

QTEST_GUILESS_MAIN(TestPsdLayers)
#include "test_psd_layers.moc"
