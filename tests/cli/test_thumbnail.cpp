// suffuse-cli thumbnail: the preview of a document, or a small picture that is drawn.
#include "cli_pictures.h"

#include "model/formats/files.h"
#include "model/formats/suffuse/suffuse_preview.h"
#include "render/image_io/plain_png.h"

#include <QtEndian>

#include <zlib.h>

#include <cmath>

using namespace suffuse;

namespace {

/// A picture that no small error leaves as it is.
FloatPicture gradient(int width, int height)
{
    FloatPicture picture;
    picture.resize(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            float *rgba = picture.rgba.data() + (std::size_t(y) * width + x) * 4;
            const int values[] = {x * 7 + y, y * 5, x * y, 255 - x};
            for (int c = 0; c < 4; ++c)
                rgba[c] = float(values[c] % 256) / 255.0f;
        }
    return picture;
}

float largestDifference(const FloatPicture &a, const FloatPicture &b, int channels)
{
    float most = a.width == b.width && a.height == b.height ? 0 : INFINITY;
    for (std::size_t i = 0; most < INFINITY && i < std::size_t(a.width) * a.height * 4; ++i)
        if (int(i % 4) < channels)
            most = std::max(most, std::abs(a.rgba.data()[i] - b.rgba.data()[i]));
    return most;
}

/// A PNG of one RGB pixel a row, whose rows use the five filters.
QByteArray filteredPng()
{
    const QByteArray rows("\0\x10\x20\x30\1\x01\x02\x03\2\x01\x01\x01\3\x05\x05\x05\4\x02\x02\x02", 20);
    QByteArray packed(100, '\0');
    uLongf size = 100;
    compress(reinterpret_cast<Bytef *>(packed.data()), &size, reinterpret_cast<const Bytef *>(rows.constData()), 20);
    packed.resize(qsizetype(size));
    const auto chunk = [](const QByteArray &type, const QByteArray &payload) {
        const auto number = [](quint32 n) {
            const quint32 big = qToBigEndian(n);
            return QByteArray(reinterpret_cast<const char *>(&big), 4);
        };
        const QByteArray body = type + payload;
        return number(quint32(payload.size())) + body +
               number(quint32(crc32(0, reinterpret_cast<const Bytef *>(body.constData()), uInt(body.size()))));
    };
    return QByteArray("\x89PNG\r\n\x1a\n") +
           chunk("IHDR", QByteArray("\0\0\0\1\0\0\0\5\x08\2\0\0\0", 13)) + chunk("IDAT", packed) + chunk("IEND", {});
}

} // namespace

class TestThumbnail : public CliPictures {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        prepare();
        if (QTest::currentTestFailed())
            return;
        ImageOptions options;
        const Result<QByteArray> png = encodeImage(ImageFormat::Png, gradient(256, 64), options, "preview");
        QVERIFY2(png, qPrintable(png.error()));
        m_preview = *png;
        const Result<Painting> painting = loadPainting(path("a.json"));
        QVERIFY2(painting, qPrintable(painting.error()));
        DocumentExtras extras;
        extras.preview = m_preview;
        QVERIFY(saveDocument(*painting, extras, path("with.suffuse")));
        QVERIFY(savePainting(*painting, path("without.suffuse")));
    }

    /// Without any module, a display or a home: nothing but the file is read.
    void aPreviewIsTakenAsItIs()
    {
        QVERIFY(QDir().mkpath(path("home")));
        const QStringList bare{"SUFFUSE_MODULE_DIR=" + path("none"), "HOME=" + path("home"),
                               "XDG_CONFIG_HOME=" + path("home/config"), "SUFFUSE_SETTINGS=" + path("home/settings")};
        const CliOutcome outcome = runCli({"thumbnail", path("with.suffuse"), path("large.png"), "256"}, {}, bare);
        QVERIFY2(outcome.code == 0 && outcome.err.isEmpty(), qPrintable(outcome.text()));
        QCOMPARE(readFile(path("large.png")), m_preview);
        const CliOutcome larger = runCli({"thumbnail", path("with.suffuse"), "-", "1024"}, {}, bare);
        QCOMPARE(larger.out, m_preview);
        QCOMPARE(filesIn(path("home")), QStringList());
    }

    void aSmallerOneIsAveraged()
    {
        const CliOutcome outcome = runCli({"thumbnail", path("with.suffuse"), path("small.png"), "128"});
        QVERIFY2(outcome.code == 0, qPrintable(outcome.text()));
        const FloatPicture small = picture("small.png"), large = gradient(256, 64);
        QCOMPARE(small.width, 128);
        QCOMPARE(small.height, 32);
        for (const int x : {0, 31, 127}) {
            const float mean = (large.at(2 * x, 20)[0] + large.at(2 * x + 1, 20)[0] + large.at(2 * x, 21)[0] +
                                large.at(2 * x + 1, 21)[0]) /
                               4;
            QVERIFY(std::abs(small.at(x, 10)[0] - mean) < 0.003f);
        }
    }

    void othersAreDrawn()
    {
        for (const char *name : {"without.suffuse", "a.json"}) {
            const CliOutcome outcome = runCli({"thumbnail", path(name), path("drawn.png"), "20"});
            QVERIFY2(outcome.code == 0, qPrintable(outcome.text()));
            QCOMPARE(largestDifference(picture("drawn.png"), rendered({"--size", "20x15"}, "same.png"), 3), 0.0f);
        }
    }

    /// What is whole at the start is enough, as long as the preview is.
    void damagedFiles()
    {
        const QByteArray whole = readFile(path("with.suffuse"));
        QCOMPARE(previewIn(whole), m_preview);
        const qsizetype at = whole.indexOf(m_preview);
        QVERIFY(at > 0);
        QVERIFY(writeFile(path("short.suffuse"), whole.first(at + m_preview.size() + 4)));
        QCOMPARE(runCli({"thumbnail", path("short.suffuse"), "-", "512"}).out, m_preview);
        for (qsizetype size = 0; size < at + m_preview.size() + 4; size += 7)
            QVERIFY(previewIn(whole.first(size)).isEmpty());
        QByteArray broken = whole;
        broken[at + 100] = char(broken[at + 100] ^ 1);
        QVERIFY(previewIn(broken).isEmpty());
        QVERIFY(writeFile(path("broken.suffuse"), broken.first(at + m_preview.size() + 4)));
        const CliOutcome outcome = runCli({"thumbnail", path("broken.suffuse"), path("broken.png"), "128"});
        QCOMPARE(outcome.code, 1);
        QVERIFY(outcome.err.contains("broken.suffuse"));
        QVERIFY(!QFile::exists(path("broken.png")));
    }

    void wrongUse()
    {
        for (const char *side : {"0", "1025", "2.5", "large", "-3"})
            QCOMPARE(runCli({"thumbnail", path("with.suffuse"), path("x.png"), side}).code, 2);
        QCOMPARE(runCli({"thumbnail", path("with.suffuse"), path("x.png")}).code, 2);
        QCOMPARE(runCli({"thumbnail", path("nothing.suffuse"), path("x.png"), "128"}).code, 1);
        QCOMPARE(runCli({"thumbnail", path("with.suffuse"), path("no/x.png"), "256"}).code, 1);
        QVERIFY(!QFile::exists(path("x.png")));
    }

    void plainPictures()
    {
        const FloatPicture made = gradient(37, 23);
        for (const bool alpha : {false, true}) {
            ImageOptions options;
            options.alpha = alpha;
            const Result<QByteArray> png = encodeImage(ImageFormat::Png, made, options, "plain");
            QVERIFY2(png, qPrintable(png.error()));
            const std::optional<FloatPicture> read = readPlainPng(*png, 64);
            QVERIFY(read);
            QVERIFY(largestDifference(*read, made, alpha ? 4 : 3) < 1e-6f);
            QVERIFY(!readPlainPng(*png, 36));
            for (qsizetype size = 0; size < png->size() - 12; size += 11)
                QVERIFY(!readPlainPng(png->first(size), 64));
            options.depth = ImageDepth::Bits16;
            QVERIFY(!readPlainPng(*encodeImage(ImageFormat::Png, made, options, "deep"), 64));
        }
        const std::optional<FloatPicture> filtered = readPlainPng(filteredPng(), 8);
        QVERIFY(filtered);
        const int expected[][3] = {{0x10, 0x20, 0x30}, {1, 2, 3}, {2, 3, 4}, {6, 6, 7}, {8, 8, 9}};
        for (int y = 0; y < 5; ++y)
            for (int c = 0; c < 3; ++c)
                QCOMPARE(int(std::lround(filtered->at(0, y)[c] * 255)), expected[y][c]);
    }

private:
    QByteArray m_preview;
};

QTEST_GUILESS_MAIN(TestThumbnail)
#include "test_thumbnail.moc"
