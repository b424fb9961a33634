// Colour profiles of images that come in and go out, beside what lcms2 makes of them by itself.
#include "render/image_io/colour_conversion.h"
#include "render/image_io/embedded_profile.h"
#include "render/image_io/image_io.h"
#include "render/image_io/strip_metadata.h"
#include "tests/cli/cli_process.h"

#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

#include <lcms2.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

using namespace suffuse;

namespace {

using Profile = std::unique_ptr<void, cmsBool (*)(cmsHPROFILE)>;
using Curve = std::unique_ptr<cmsToneCurve, void (*)(cmsToneCurve *)>;

QByteArray bytesOf(const Profile &profile)
{
    cmsUInt32Number size = 0;
    cmsSaveProfileToMem(profile.get(), nullptr, &size);
    QByteArray bytes(qsizetype(size), '\0');
    cmsSaveProfileToMem(profile.get(), bytes.data(), &size);
    return bytes;
}

/// Primaries and white by their chromaticities, and one gamma.
QByteArray rgbProfile(const cmsCIExyYTRIPLE &primaries, double gamma)
{
    const cmsCIExyY white{0.3127, 0.329, 1};
    const Curve curve(cmsBuildGamma(nullptr, gamma), cmsFreeToneCurve);
    cmsToneCurve *curves[] = {curve.get(), curve.get(), curve.get()};
    return bytesOf(Profile(cmsCreateRGBProfile(&white, &primaries, curves), cmsCloseProfile));
}

/// Made once: lcms2 dates a profile to the second.
QByteArray adobeRgb()
{
    static const QByteArray profile = rgbProfile({{0.64, 0.33, 1}, {0.21, 0.71, 1}, {0.15, 0.06, 1}}, 563.0 / 256);
    return profile;
}

QByteArray displayP3()
{
    return rgbProfile({{0.68, 0.32, 1}, {0.265, 0.69, 1}, {0.15, 0.06, 1}}, 2.2);
}

QByteArray greyProfile(double gamma)
{
    const Curve curve(cmsBuildGamma(nullptr, gamma), cmsFreeToneCurve);
    return bytesOf(Profile(cmsCreateGrayProfile(cmsD50_xyY(), curve.get()), cmsCloseProfile));
}

FloatPicture colours(int width, int height)
{
    FloatPicture p;
    p.resize(width, height);
    QRandomGenerator random(17);
    for (float &v : p.rgba)
        v = float(random.bounded(256)) / 255;
    for (std::size_t i = 3; i < p.rgba.size(); i += 4)
        p.rgba[i] = 1;
    return p;
}

/// What lcms2 makes of a colour between two profiles, in double precision.
class Judge {
public:
    Judge(const QByteArray &from, const QByteArray &to)
        : m_from(open(from)), m_to(open(to)), m_lab(cmsCreateLab4Profile(nullptr), cmsCloseProfile),
          m_convert(transform(m_from, TYPE_RGB_DBL, m_to, TYPE_RGB_DBL, cmsFLAGS_BLACKPOINTCOMPENSATION)),
          m_look(transform(m_to, TYPE_RGB_DBL, m_lab, TYPE_Lab_DBL, 0))
    {}
    /// ΔE2000 between what lcms2 makes of `from`, in whole levels if there are any, and `found`, as colours of `to`.
    double difference(const float *from, const float *found, double levels = 0) const
    {
        double in[3] = {from[0], from[1], from[2]}, expected[3];
        cmsDoTransform(m_convert.get(), in, expected, 1);
        for (double &v : expected)
            v = levels > 0 ? std::round(std::clamp(v, 0.0, 1.0) * levels) / levels : std::clamp(v, 0.0, 1.0);
        const double got[3] = {found[0], found[1], found[2]};
        cmsCIELab a, b;
        cmsDoTransform(m_look.get(), expected, &a, 1);
        cmsDoTransform(m_look.get(), got, &b, 1);
        return cmsCIE2000DeltaE(&a, &b, 1, 1, 1);
    }

private:
    using Transform = std::unique_ptr<void, void (*)(cmsHTRANSFORM)>;
    static Profile open(const QByteArray &bytes)
    {
        return {bytes.isEmpty() ? cmsCreate_sRGBProfile()
                                : cmsOpenProfileFromMem(bytes.constData(), cmsUInt32Number(bytes.size())),
                cmsCloseProfile};
    }
    static Transform transform(const Profile &a, cmsUInt32Number in, const Profile &b, cmsUInt32Number out,
                               cmsUInt32Number flags)
    {
        return {
            cmsCreateTransform(a.get(), in, b.get(), out, INTENT_RELATIVE_COLORIMETRIC, flags | cmsFLAGS_NOOPTIMIZE),
            cmsDeleteTransform};
    }
    Profile m_from, m_to, m_lab;
    Transform m_convert, m_look;
};

/// A grey picture of 8 bits, a row, with a profile.
QByteArray greyTiff(const QByteArray &row, const QByteArray &profile)
{
    const auto little = [](quint32 v, int bytes) {
        QByteArray out(4, '\0');
        qToLittleEndian(v, out.data());
        return out.left(bytes);
    };
    const QByteArray head = QByteArray("II*\0", 4) + little(8, 4);
    constexpr int entries = 10;
    const quint32 pixels = 8 + 2 + entries * 12 + 4, after = pixels + quint32(row.size());
    const quint32 shortType = 3, longType = 4, undefinedType = 7;
    QByteArray directory = little(entries, 2);
    const auto entry = [&](quint32 tag, quint32 type, quint32 count, quint32 value) {
        directory += little(tag, 2) + little(type, 2) + little(count, 4) + little(value, 4);
    };
    entry(256, shortType, 1, quint32(row.size()));
    entry(257, shortType, 1, 1);
    entry(258, shortType, 1, 8);
    entry(259, shortType, 1, 1);
    entry(262, shortType, 1, 1);
    entry(273, longType, 1, pixels);
    entry(277, shortType, 1, 1);
    entry(278, shortType, 1, 1);
    entry(279, longType, 1, quint32(row.size()));
    entry(34675, undefinedType, quint32(profile.size()), after);
    return head + directory + little(0, 4) + row + profile;
}

} // namespace

class TestColourProfiles : public QObject {
    Q_OBJECT

private slots:
    void writtenAndRead_data();
    void writtenAndRead();
    void srgbChangesNoBit();
    void grey();
    void brokenProfiles();
    void whatCannotBe();
    void proofs();
    void byTheCommandLine();
};

void TestColourProfiles::writtenAndRead_data()
{
    QTest::addColumn<ImageFormat>("format");
    QTest::addColumn<ImageDepth>("depth");
    QTest::addColumn<QByteArray>("profile");
    QTest::addColumn<double>("most"); // in ΔE2000; JPEG loses something
    const struct {
        const char *name;
        ImageFormat format;
        ImageDepth depth;
        double most;
    } kinds[] = {{"PNG 8", ImageFormat::Png, ImageDepth::Bits8, 0.5},
                 {"PNG 16", ImageFormat::Png, ImageDepth::Bits16, 0.01},
                 {"TIFF 8", ImageFormat::Tiff, ImageDepth::Bits8, 0.5},
                 {"TIFF float", ImageFormat::Tiff, ImageDepth::Float, 0.01},
                 {"JPEG", ImageFormat::Jpeg, ImageDepth::Bits8, 2},
                 {"WebP", ImageFormat::WebP, ImageDepth::Bits8, 0.5}};
    for (const auto &kind : kinds) {
        QTest::addRow("%s, Adobe RGB", kind.name) << kind.format << kind.depth << adobeRgb() << kind.most;
        QTest::addRow("%s, Display P3", kind.name) << kind.format << kind.depth << displayP3() << kind.most;
    }
}

/// What is in the file are the colours of the profile, as lcms2 computes them, and they come back as they were.
void TestColourProfiles::writtenAndRead()
{
    QFETCH(ImageFormat, format);
    QFETCH(ImageDepth, depth);
    QFETCH(QByteArray, profile);
    QFETCH(double, most);
    FloatPicture picture = colours(64, 48);
    if (format == ImageFormat::Jpeg) // It would smear what differs from pixel to pixel.
        for (int i = 0; i < 64 * 48; ++i)
            std::copy_n(picture.at(i % 64 / 16 * 16, i / 64 / 16 * 16), 4, picture.rgba.data() + 4 * i);
    ImageOptions options;
    options.depth = depth;
    options.profile = profile;
    options.quality = 100;
    const Result<QByteArray> bytes = encodeImage(format, picture, options, "p");
    QVERIFY2(bytes, qPrintable(bytes.error()));
    QVERIFY(embeddedProfile(*bytes, format) == profile);

    QByteArray bare = withoutMetadata(*bytes, format);
    if (format == ImageFormat::WebP) // it has no other way to be read without
        bare.replace("ICCP", "XXXX");
    const Result<FloatPicture> raw = readImage(bare, "bare"), read = readImage(*bytes, "p");
    QVERIFY2(raw && read, qPrintable(raw ? read.error() : raw.error()));
    const Judge writing({}, profile), reading(profile, {});
    const double levels = depth == ImageDepth::Float ? 0 : depth == ImageDepth::Bits16 ? 65535 : 255;
    double stored = 0, back = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
        stored = std::max(stored, writing.difference(&picture.rgba[i], &raw->rgba[i], levels));
        back = std::max(back, reading.difference(&raw->rgba[i], &read->rgba[i]));
    }
    QVERIFY2(stored <= most, qPrintable(QString::number(stored)));
    QVERIFY2(back <= 0.01, qPrintable(QString::number(back)));
    QVERIFY2(raw->rgba != read->rgba, "the profile is heeded");
}

/// Files of our own name the profile of sRGB, and others' profiles of it differ from it by less than anybody sees.
void TestColourProfiles::srgbChangesNoBit()
{
    const QByteArray ours = *srgbIccProfile();
    const Profile made(cmsCreate_sRGBProfile(), cmsCloseProfile);
    for (const QByteArray &profile : {ours, bytesOf(made)}) {
        const Result<ColourConversion> conversion = ColourConversion::between({profile, {}, {}});
        QVERIFY2(conversion, qPrintable(conversion.error()));
        QVERIFY(conversion->changesNothing());
    }
    const FloatPicture picture = colours(40, 30);
    const QByteArray bytes = *encodeImage(ImageFormat::Tiff, picture, {}, "s");
    QVERIFY(embeddedProfile(bytes, ImageFormat::Tiff) == ours);
    QVERIFY(readImage(bytes, "s")->rgba == readImage(withoutMetadata(bytes, ImageFormat::Tiff), "s")->rgba);
}

/// The values of a grey scan of gamma 1.8 are those of sRGB's curve that are as light.
void TestColourProfiles::grey()
{
    QByteArray row;
    for (int v = 0; v < 256; ++v)
        row += char(v);
    const QByteArray file = greyTiff(row, greyProfile(1.8));
    const Result<FloatPicture> read = readImage(file, "grey");
    QVERIFY2(read, qPrintable(read.error()));
    for (int v = 0; v < 256; ++v) {
        const double light = std::pow(v / 255.0, 1.8);
        const double expected = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
        for (int c = 0; c < 3; ++c)
            QVERIFY2(std::abs(read->rgba[std::size_t(4 * v + c)] - expected) < 0.002, qPrintable(QString::number(v)));
    }
    // A profile for colours of a picture that is grey holds as well.
    const Result<FloatPicture> coloured = readImage(greyTiff(row, adobeRgb()), "grey");
    QVERIFY2(coloured, qPrintable(coloured.error()));
    QVERIFY(coloured->rgba != readImage(greyTiff(row, "none"), "grey")->rgba);
}

/// A picture is shown, whatever became of its profile.
void TestColourProfiles::brokenProfiles()
{
    const FloatPicture picture = colours(8, 8);
    ImageOptions options;
    options.profile = adobeRgb();
    for (const ImageFormat format : {ImageFormat::Jpeg, ImageFormat::Tiff, ImageFormat::WebP, ImageFormat::Png}) {
        const QByteArray file = *encodeImage(format, picture, options, "p");
        QByteArray torn = file;
        const qsizetype at = torn.indexOf(format == ImageFormat::Png ? "iCCP" : "acsp");
        QVERIFY(at > 0);
        torn.replace(at, 4, "none");
        const Result<FloatPicture> plain = readImage(torn, "torn");
        QVERIFY2(plain, qPrintable(plain.error()));
        QVERIFY(plain->rgba != readImage(file, "p")->rgba);
        QVERIFY(format == ImageFormat::WebP || plain->rgba == readImage(withoutMetadata(file, format), "bare")->rgba);
    }
    QRandomGenerator random(3);
    const QByteArray profile = adobeRgb();
    for (int trial = 0; trial < 2000; ++trial) {
        QByteArray damaged = profile.left(trial % 4 ? profile.size() : random.bounded(int(profile.size())));
        for (int i = 0; i < 1 + trial % 5 && !damaged.isEmpty(); ++i)
            damaged[random.bounded(int(damaged.size()))] = char(random.bounded(256));
        const Result<ColourConversion> conversion = ColourConversion::between({damaged, {}, {}});
        if (!conversion) {
            QVERIFY(!conversion.error().isEmpty());
            continue;
        }
        float pixel[4] = {0.2f, 0.5f, 0.8f, 0.5f};
        conversion->apply(pixel, 1);
        QCOMPARE(pixel[3], 0.5f);
    }
    QVERIFY(embeddedProfile(QByteArray("\x89PNG\r\n\x1a\n\xff\xff\xff\xffiCCP", 16), ImageFormat::Png).isEmpty());
}

void TestColourProfiles::whatCannotBe()
{
    ImageOptions options;
    options.profile = adobeRgb();
    for (const ImageFormat format : {ImageFormat::Exr, ImageFormat::Pfm})
        QVERIFY(problemOf(format, options, 5, 5).contains("profile"));
    for (const QByteArray &wrong : {greyProfile(2.2), QByteArray("no profile")}) {
        options.profile = wrong;
        const Result<QByteArray> written = encodeImage(ImageFormat::Png, colours(4, 4), options, "w.png");
        QVERIFY(!written);
        QVERIFY2(written.error().contains("w.png") && written.error().contains("profile"), qPrintable(written.error()));
    }
}

/// A proof shows what a smaller gamut leaves of colours, and marks those that it has not.
void TestColourProfiles::proofs()
{
    ColourProfiles profiles;
    profiles.from = displayP3();
    profiles.to = displayP3();
    profiles.proof = *srgbIccProfile();
    const Result<ColourConversion> seen = ColourConversion::between(profiles);
    QVERIFY2(seen, qPrintable(seen.error()));
    profiles.marksGamut = true;
    const Result<ColourConversion> marked = ColourConversion::between(profiles);
    QVERIFY2(marked, qPrintable(marked.error()));
    const float green[4] = {0, 1, 0, 1}, dull[4] = {0.5f, 0.45f, 0.4f, 1};
    float pixel[4];
    std::copy_n(green, 4, pixel);
    seen->apply(pixel, 1);
    QVERIFY2(pixel[0] > 0.2f, "the greenest green of sRGB has some red there");
    std::copy_n(green, 4, pixel);
    marked->apply(pixel, 1);
    QVERIFY(pixel[0] < -0.5f && pixel[1] < -0.5f && pixel[2] < -0.5f);
    std::copy_n(dull, 4, pixel);
    marked->apply(pixel, 1);
    for (int c = 0; c < 3; ++c)
        QVERIFY2(std::abs(pixel[c] - dull[c]) < 0.004f, qPrintable(QString::number(pixel[c])));
}

void TestColourProfiles::byTheCommandLine()
{
    QTemporaryDir folder;
    const auto path = [&](const char *name) { return folder.filePath(QLatin1String(name)); };
    QVERIFY(writeFile(path("a.json"), smallPainting()) && writeFile(path("p.icc"), adobeRgb()) &&
            writeFile(path("grey.icc"), greyProfile(2.2)));
    const QStringList render = {"render", path("a.json"), "-o"};
    CliOutcome done = runCli(render + QStringList{path("s.png")});
    QVERIFY2(done.code == 0, qPrintable(done.text()));
    done = runCli(render + QStringList{path("p.png"), "--profile", path("p.icc")});
    QVERIFY2(done.code == 0, qPrintable(done.text()));
    const QByteArray file = readFile(path("p.png"));
    QVERIFY(embeddedProfile(file, ImageFormat::Png) == adobeRgb());
    const FloatPicture plain = *readImage(readFile(path("s.png")), "s"), back = *readImage(file, "p");
    for (std::size_t i = 0; i < plain.rgba.size(); ++i) // Near black a level of gamma 2.2 is two of sRGB.
        QVERIFY(std::abs(plain.rgba[i] - back.rgba[i]) < 3.0 / 255);
    for (const QStringList &wrong : {QStringList{path("w.png"), "--profile", path("grey.icc")},
                                     QStringList{path("w.png"), "--profile", path("none.icc")},
                                     QStringList{path("w.exr"), "--profile", path("p.icc")}}) {
        done = runCli(render + wrong);
        QVERIFY2(done.code == 2 && done.err.contains("profile"), qPrintable(done.text()));
        QVERIFY(!QFile::exists(wrong.front()));
    }
}

QTEST_GUILESS_MAIN(TestColourProfiles)
#include "test_colour_profiles.moc"
