// Image files in and out of the program, good and hostile.
#include "render/image_io/image_io.h"
#include "render/scene/paper.h"
#include "tests/cli/image_bytes.h"
#include "tests/files.h"

#include <QFile>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QSize>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

#include <lcms2.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <memory>

using namespace suffuse;

namespace {

double distance(const FloatPicture &a, const FloatPicture &b, float leastAlpha)
{
    if (a.width != b.width || a.height != b.height)
        return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
        if (i % 4 == 3 || a.rgba[i | 3] >= leastAlpha)
            largest = std::max(largest, double(std::abs(a.rgba[i] - b.rgba[i])));
    return largest;
}

} // namespace

class TestImageFiles : public QObject {
    Q_OBJECT

private slots:
    void commonFormatsLoadNothingHeavy();
    void resolution_data();
    void resolution();
    void colourProfile();
    void bytesAreTheFile();
    void alphaRoundTrip_data();
    void alphaRoundTrip();
    void eightBitPng_data();
    void eightBitPng();
    void endingsAndMagic();
    void cancelledWritingLeavesNothing();
    void packingCanBeStopped();
    void declaredSizes_data();
    void declaredSizes();
    void tiles();
    void truncated_data();
    void truncated();
    void notANumber();
    void paper();

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }

    QTemporaryDir m_folder;
};

/// Comes first: OpenImageIO's 260 libraries take longer than a picture does, and stay once they are loaded.
void TestImageFiles::commonFormatsLoadNothingHeavy()
{
    const auto loaded = [](const char *library) { return bytesOf("/proc/self/maps").contains(library); };
    if (loaded("libOpenImageIO"))
        QSKIP("OpenImageIO is loaded already");
    for (const auto &[name, depth] :
         std::initializer_list<std::pair<const char *, ImageDepth>>{{"l.png", ImageDepth::Bits8},
                                                                    {"l.png", ImageDepth::Bits16},
                                                                    {"l.jpg", ImageDepth::Bits8},
                                                                    {"l.tif", ImageDepth::Bits8},
                                                                    {"l.tif", ImageDepth::Bits16},
                                                                    {"l.tif", ImageDepth::Half},
                                                                    {"l.tif", ImageDepth::Float},
                                                                    {"l.webp", ImageDepth::Bits8},
                                                                    {"l.pfm", ImageDepth::Float}}) {
        ImageOptions options;
        options.depth = depth;
        QVERIFY(writeImage(path(name), ramp(16, 16), options));
        QVERIFY2(!loaded("libOpenImageIO"), name);
    }
    QVERIFY(writeImage(path("l.exr"), ramp(16, 16), {}));
    QVERIFY(loaded("libOpenImageIO")); // so it would have been seen
}

void TestImageFiles::resolution_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("depth");
    QTest::addColumn<QByteArray>("says"); ///< 254 pixels an inch, 100 a centimetre
    const QByteArray png = bigEndian(9) + "pHYs" + bigEndian(10000) + bigEndian(10000) + '\1';
    QTest::newRow("PNG 8") << "r.png" << 0 << png;
    QTest::newRow("PNG 16") << "r.png" << 1 << png;
    QTest::newRow("JPEG") << "r.jpg" << 0 << QByteArray("JFIF\0\1\1\1\0\xFE\0\xFE", 12);
    QTest::newRow("TIFF 8") << "r.tif" << 0 << QByteArray("\x28\1\3\0\1\0\0\0\2\0", 10); // an inch is the unit
    QTest::newRow("EXR") << "r.exr" << 2 << QByteArray("xDensity\0float\0\4\0\0\0\0\0\x7E\x43", 22);
}

/// Nothing is said unless it is asked for.
void TestImageFiles::resolution()
{
    QFETCH(QString, name);
    QFETCH(int, depth);
    QFETCH(QByteArray, says);
    ImageOptions options;
    options.depth = ImageDepth(depth);
    QVERIFY(writeImage(path(name), ramp(16, 16), options));
    QVERIFY(!bytesOf(path(name)).contains(says));
    options.dpi = 254;
    QVERIFY(writeImage(path(name), ramp(16, 16), options));
    const QByteArray bytes = bytesOf(path(name));
    QVERIFY(bytes.contains(says));
    if (name.endsWith("tif")) { // two rational numbers, wherever they lie
        const auto numberAt = [&](qsizetype at) {
            return quint32(uchar(bytes[at]) | uchar(bytes[at + 1]) << 8 | uchar(bytes[at + 2]) << 16 |
                           uchar(bytes[at + 3]) << 24);
        };
        for (const char *tag : {"\x1A\1\5\0\1\0\0\0", "\x1B\1\5\0\1\0\0\0"}) {
            const qsizetype entry = bytes.indexOf(QByteArray(tag, 8));
            QVERIFY(entry > 0);
            const qsizetype at = qsizetype(numberAt(entry + 8));
            QCOMPARE(double(numberAt(at)) / numberAt(at + 4), 254.0);
        }
    }
    const Result<FloatPicture> read = readImage(bytes, name);
    QVERIFY2(read, qPrintable(read.error()));
    QCOMPARE(read->width, 16);
}

/// What readers of colour profiles make of it, and always the same bytes, whatever the clock says.
void TestImageFiles::colourProfile()
{
    for (const char *name : {"icc.jpg", "icc.tif"}) {
        QVERIFY(writeImage(path(name), ramp(16, 16), {}));
        const QByteArray file = bytesOf(path(name));
        constexpr int signatureAt = 36;
        const qsizetype at = file.indexOf("acsp") - signatureAt;
        QVERIFY2(at >= 0, name);
        const auto size = qFromBigEndian<quint32>(file.constData() + at);
        QVERIFY2(at + qsizetype(size) <= file.size(), name);
        const auto open = [](cmsHPROFILE p) {
            return std::unique_ptr<void, cmsBool (*)(cmsHPROFILE)>(p, cmsCloseProfile);
        };
        const auto profile = open(cmsOpenProfileFromMem(file.constData() + at, size));
        QVERIFY2(profile, name);
        std::tm made{};
        QVERIFY(cmsGetHeaderCreationDateTime(profile.get(), &made));
        QCOMPARE(made.tm_year, 2024 - 1900);
        const auto xyz = open(cmsCreateXYZProfile());
        const std::unique_ptr<void, void (*)(cmsHTRANSFORM)> transform(
            cmsCreateTransform(profile.get(), TYPE_RGB_DBL, xyz.get(), TYPE_XYZ_DBL, INTENT_RELATIVE_COLORIMETRIC,
                               cmsFLAGS_NOOPTIMIZE),
            cmsDeleteTransform);
        QVERIFY2(transform, name);
        // IEC 61966-2-1 in numbers: luminances of white, of half grey, and of the primaries as D50 sees them.
        const double colours[][4] = {
            {1, 1, 1, 1}, {0.5, 0.5, 0.5, 0.21404}, {1, 0, 0, 0.2225}, {0, 1, 0, 0.7169}, {0, 0, 1, 0.0606}};
        for (const auto &colour : colours) {
            double found[3] = {};
            cmsDoTransform(transform.get(), colour, found, 1);
            QVERIFY2(std::abs(found[1] - colour[3]) < 2e-4, qPrintable(QString("%1: %2").arg(name).arg(found[1])));
        }
    }
}

/// Without the moment of writing, "2026:11:22 20:38:26", which EXR files hold: two that are written one after the other
/// may be of two seconds.
static QByteArray undated(const QByteArray &file)
{
    static const QRegularExpression moment("\\d{4}:\\d\\d:\\d\\d \\d\\d:\\d\\d:\\d\\d");
    return QString::fromLatin1(file).replace(moment, QString()).toLatin1();
}

void TestImageFiles::bytesAreTheFile()
{
    for (const QString &ending : imageEndings()) {
        const ImageFormat format = imageFormatForPath("b." + ending);
        const Result<QByteArray> bytes = encodeImage(format, ramp(50, 40), {}, "b");
        QVERIFY2(bytes, qPrintable(bytes.error()));
        QVERIFY(writeImage(path("b." + ending), ramp(50, 40), {}));
        QVERIFY2(undated(*bytes) == undated(bytesOf(path("b." + ending))), qPrintable(ending));
    }
    QVERIFY(!encodeImage(ImageFormat::Unknown, ramp(5, 5), {}, "b"));
    std::atomic<bool> cancel{true};
    ImageOptions options;
    options.cancel = &cancel;
    QVERIFY(!encodeImage(ImageFormat::Png, ramp(5, 5), options, "b"));
}

void TestImageFiles::alphaRoundTrip_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("depth");
    QTest::addColumn<double>("tolerance");
    QTest::addColumn<float>("leastAlpha"); // associated half floats lose colour where nothing is covered
    QTest::newRow("PNG 8") << "a.png" << 0 << 0.5 / 255 + 1e-6 << 0.0f;
    QTest::newRow("PNG 16") << "a.png" << 1 << 0.5 / 65535 + 1e-6 << 0.0f;
    QTest::newRow("TIFF 8") << "a.tif" << 0 << 0.5 / 255 + 1e-6 << 0.0f;
    QTest::newRow("TIFF 16") << "a.tif" << 1 << 0.5 / 65535 + 1e-6 << 0.0f;
    QTest::newRow("TIFF half") << "a.tif" << 2 << 1.0 / 2048 << 0.0f;
    QTest::newRow("TIFF float") << "a.tif" << 3 << 0.0 << 0.0f;
    QTest::newRow("EXR half") << "a.exr" << 2 << 1.0 / 1024 << 0.01f;
    QTest::newRow("EXR float") << "a.exr" << 3 << 1e-6 << 0.01f;
    QTest::newRow("WebP, lossless") << "a.webp" << 0 << 0.5 / 255 + 1e-6 << 0.01f;
}

void TestImageFiles::alphaRoundTrip()
{
    QFETCH(QString, name);
    QFETCH(int, depth);
    QFETCH(double, tolerance);
    QFETCH(float, leastAlpha);
    const FloatPicture p = ramp(61, 37);
    ImageOptions options;
    options.depth = ImageDepth(depth);
    options.alpha = true;
    options.quality = 100;
    const Result<void> written = writeImage(path(name), p, options);
    QVERIFY2(written, qPrintable(written.error()));
    const Result<FloatPicture> read = readImage(bytesOf(path(name)), name);
    QVERIFY2(read, qPrintable(read.error()));
    const double d = distance(p, *read, leastAlpha);
    QVERIFY2(d <= tolerance, qPrintable(QString::number(d)));
}

void TestImageFiles::eightBitPng_data()
{
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    for (const QSize size : {QSize(1, 1), QSize(1, 5), QSize(7, 1), QSize(61, 37), QSize(700, 300)})
        QTest::addRow("%d x %d", size.width(), size.height()) << size.width() << size.height();
}

/// Every value comes back rounded to nearest, what is no colour as the nearest one; the picture says that it is sRGB.
void TestImageFiles::eightBitPng()
{
    QFETCH(int, width);
    QFETCH(int, height);
    FloatPicture p;
    p.resize(width, height);
    QRandomGenerator random(5);
    const auto isFlat = [&](std::size_t i) { return i / (4 * std::size_t(width)) % 5 < 2; };
    for (std::size_t i = 0; i < p.rgba.size(); ++i)
        p.rgba[i] = isFlat(i)     ? 0.25f
                    : i % 11 == 0 ? float(random.bounded(256)) / 255
                                  : float(random.bounded(1.2) - 0.1);
    p.rgba[0] = std::numeric_limits<float>::quiet_NaN();
    for (const bool alpha : {false, true})
        for (const bool quick : {false, true}) {
            ImageOptions options;
            options.alpha = alpha;
            options.quick = quick;
            QVERIFY(writeImage(path("eight.png"), p, options));
            const QByteArray bytes = bytesOf(path("eight.png"));
            QVERIFY(bytes.contains(QByteArray("sRGB\3", 5)) && bytes.contains("Suffuse"));
            const Result<FloatPicture> read = readImage(bytes, "eight.png");
            QVERIFY2(read, qPrintable(read.error()));
            QCOMPARE(QSize(read->width, read->height), QSize(width, height));
            for (std::size_t i = 0; i < p.rgba.size(); ++i) {
                const float v = std::isnan(p.rgba[i]) ? 0 : std::clamp(p.rgba[i], 0.0f, 1.0f);
                const long expected = alpha || i % 4 != 3 ? std::lround(255 * v) : 255;
                QCOMPARE(std::lround(255 * read->rgba[i]), expected);
            }
        }
}

void TestImageFiles::endingsAndMagic()
{
    QCOMPARE(imageFormatForPath("a/B.PNG"), ImageFormat::Png);
    QCOMPARE(imageFormatForPath("a.tif"), ImageFormat::Tiff);
    QCOMPARE(imageFormatForPath("png"), ImageFormat::Unknown);
    QCOMPARE(imageFormatForPath("a.png.txt"), ImageFormat::Unknown);
    const FloatPicture p = ramp(8, 8);
    for (const QString &ending : imageEndings()) {
        QVERIFY(writeImage(path("m." + ending), p, {}));
        const ImageFormat expected = ending == "pfm" ? ImageFormat::Unknown : imageFormatForPath("m." + ending);
        QCOMPARE(detectImageFormat(bytesOf(path("m." + ending))), expected);
    }
    QVERIFY(!problemOf(ImageFormat::WebP, {}, 20000, 10).isEmpty());
    QVERIFY(problemOf(ImageFormat::Png, {}, 20000, 10).isEmpty());
    QVERIFY(problemOf(ImageFormat::Png, {}, 16384, 16384).isEmpty());
    QVERIFY(problemOf(ImageFormat::Png, {}, 16385, 16384).contains("268 million"));
    QVERIFY(!readImage("GIF89a", "a.gif"));
    QVERIFY(!readImage({}, "empty.png"));
}

void TestImageFiles::cancelledWritingLeavesNothing()
{
    QTemporaryDir folder;
    for (const char *name : {"c.png", "c.tif", "c.exr", "c.jpg", "c.webp", "c.pfm"}) {
        std::atomic<bool> cancel{false};
        ImageOptions options;
        options.cancel = &cancel;
        options.progress = [&cancel](int done, int) { cancel = done == 5; };
        QVERIFY2(!writeImage(folder.filePath(name), ramp(64, 64), options), name);
    }
    QVERIFY(QDir(folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).isEmpty());
}

/// Once all rows are there a large picture takes seconds to be packed, and nobody has to wait for that.
void TestImageFiles::packingCanBeStopped()
{
    QTemporaryDir folder;
    FloatPicture p;
    p.resize(2048, 1600);
    std::atomic<bool> cancel{false};
    ImageOptions options;
    options.progress = [&cancel](int done, int rows) { cancel = done == rows; };
    options.cancel = &cancel;
    const Result<void> written = writeImage(folder.filePath("large.png"), p, options);
    QVERIFY(!written);
    QVERIFY2(written.error().contains("cancelled"), qPrintable(written.error()));
    QVERIFY(QDir(folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).isEmpty());
}

void TestImageFiles::declaredSizes_data()
{
    QTest::addColumn<QByteArray>("bytes");
    const QByteArray png = QByteArray("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
    QTest::newRow("PNG of 14 GB") << png + bigEndian(60000) + bigEndian(60000) + QByteArray("\x08\x06\0\0\0", 5);
    QTest::newRow("PNG one line too wide") << png + bigEndian(16385) + bigEndian(1) + QByteArray("\x08\x06\0\0\0", 5);
    QTest::newRow("PNG of negative size")
        << png + bigEndian(0xFFFFFFFF) + bigEndian(1) + QByteArray("\x08\x06\0\0\0", 5);
    QTest::newRow("WebP, extended") << QByteArray("RIFF\x20\0\0\0WEBPVP8X\x0a\0\0\0\0\0\0\0\xff\xff\xff\xff\xff\xff",
                                                  30);
    const QString seeds = QStringLiteral(SUFFUSE_SOURCE_DIR "/tests/fuzz/seeds/image/");
    QTest::newRow("EXR, text of 2 GB") << bytesOf(seeds + "string-of-2-gb.exr");
    QTest::newRow("EXR, channels that end before their size") << bytesOf(seeds + "channels-end-early.exr");
    QByteArray exr = bytesOf(seeds + "half.exr");
    const qsizetype window =
        exr.indexOf("dataWindow") + 11 + 6 + 4; // name, "box2i", size; then left, top, right, bottom
    QTest::newRow("EXR of 2 billion lines") << exr.replace(window + 12, 4, QByteArray("\xff\xff\xff\x7f", 4));
    QTest::newRow("WebP, lossless") << QByteArray("RIFF\x20\0\0\0WEBPVP8L\x0a\0\0\0\x2f\xff\xff\xff\x0f\0\0\0\0\0", 30);
}

void TestImageFiles::declaredSizes()
{
    QFETCH(QByteArray, bytes);
    const Result<FloatPicture> read = readImage(bytes, "huge");
    QVERIFY(!read);
    QVERIFY2(read.error().startsWith("huge: ") && read.error().contains("declares"), qPrintable(read.error()));
}

/// 16 × 16 pixels in one tile, squares of two pixels, black first.
void TestImageFiles::tiles()
{
    const QByteArray bytes = bytesOf(QStringLiteral(SUFFUSE_SOURCE_DIR "/tests/fuzz/seeds/image/tiled.tif"));
    const Result<FloatPicture> picture = readImage(bytes, QStringLiteral("tiled.tif"));
    QVERIFY2(picture, picture ? "" : qPrintable(picture.error()));
    QCOMPARE(QSize(picture->width, picture->height), QSize(16, 16));
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            QCOMPARE(picture->rgba[std::size_t(4 * (16 * y + x))], (x / 2 + y / 2) % 2 ? 1.0f : 0.0f);
}

void TestImageFiles::truncated_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"t.png", "t.tif", "t.exr", "t.jpg", "t.webp"})
        QTest::newRow(name) << QString(name);
}

void TestImageFiles::truncated()
{
    QFETCH(QString, name);
    QVERIFY(writeImage(path(name), ramp(64, 48), {}));
    const QByteArray whole = bytesOf(path(name));
    int refused = 0;
    for (int part = 0; part < 40; ++part) {
        const Result<FloatPicture> read = readImage(whole.left(whole.size() * part / 40), name);
        if (!read) {
            QVERIFY2(read.error().startsWith(name + ": "), qPrintable(read.error()));
            ++refused;
        } else // some decoders fill in what is missing: the picture has its size and is made of numbers
            QVERIFY(read->width == 64 &&
                    std::all_of(read->rgba.begin(), read->rgba.end(), [](float v) { return v >= 0 && v <= 1; }));
    }
    QVERIFY2(refused >= 2, qPrintable(QString::number(refused)));
    for (int flip = 0; flip < 1000; ++flip) { // no crash and no wild values, whatever a damaged file decodes to
        QByteArray damaged = whole;
        const qsizetype at = 8 + flip * (whole.size() - 8) / 1000;
        damaged[at] = char(damaged[at] ^ (1 << flip % 8));
        const Result<FloatPicture> read = readImage(damaged, name);
        QVERIFY(!read || std::all_of(read->rgba.begin(), read->rgba.end(), [](float v) { return v >= 0 && v <= 1; }));
    }
}

void TestImageFiles::notANumber()
{
    FloatPicture p = ramp(8, 8);
    p.rgba[0] = std::numeric_limits<float>::quiet_NaN();
    p.rgba[1] = std::numeric_limits<float>::infinity();
    p.rgba[2] = -3;
    ImageOptions options;
    options.depth = ImageDepth::Float;
    QVERIFY(writeImage(path("n.tif"), p, options));
    const Result<FloatPicture> read = readImage(bytesOf(path("n.tif")), "n.tif");
    QVERIFY(read);
    QCOMPARE(read->rgba[0], 0.0f);
    QCOMPARE(read->rgba[1], 1.0f);
    QCOMPARE(read->rgba[2], 0.0f);
}

void TestImageFiles::paper()
{
    Paper none;
    const auto nothing = paperTexture(none);
    QVERIFY(nothing && !*nothing);
    FloatPicture p = ramp(9, 7);
    ImageOptions options;
    options.depth = ImageDepth::Bits16;
    options.alpha = true; // and ignored
    QVERIFY(writeImage(path("paper.png"), p, options));
    Paper paper;
    paper.kind = PaperKind::Image;
    QVERIFY(!paperTexture(paper));
    paper.image = std::make_shared<const QByteArray>(bytesOf(path("paper.png")));
    const auto texture = paperTexture(paper);
    QVERIFY2(texture, qPrintable(texture.error()));
    QCOMPARE((*texture)->width, 9);
    QCOMPARE((*texture)->height, 7);
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 9; ++x) {
            const float *v = p.at(x, y);
            const double grey = 0.2126 * v[0] + 0.7152 * v[1] + 0.0722 * v[2];
            QVERIFY(std::abs((*texture)->grey[std::size_t(y * 9 + x)] - grey) < 1e-5);
        }
    QVERIFY(*paperTexture(paper) == *texture); // decoded once
    Paper other = paper;
    other.image = std::make_shared<const QByteArray>("no image");
    QVERIFY(!paperTexture(other));
}

QTEST_GUILESS_MAIN(TestImageFiles)
#include "test_image_files.moc"
