#include "render/image_io/image_io.h"

#include "render/image_io/image_module.h"

#include <QCoreApplication>

#include <algorithm>

namespace suffuse {

namespace {

struct FormatRow {
    ImageFormat format;
    const char *name;
    std::vector<const char *> endings;
    std::vector<ImageDepth> depths; ///< the first is the usual one
    bool alpha;
    bool quality;
    bool resolution;
    bool profile;
    int maxSide;
};

const std::vector<FormatRow> &formats()
{
    using enum ImageDepth;
    static const std::vector<FormatRow> rows = {
        {ImageFormat::Png, "PNG", {"png"}, {Bits8, Bits16}, true, false, true, true, 1 << 20},
        {ImageFormat::Tiff, "TIFF", {"tiff", "tif"}, {Bits8, Bits16, Half, Float}, true, false, true, true, 1 << 20},
        {ImageFormat::Exr, "EXR", {"exr"}, {Half, Float}, true, false, true, false, 1 << 20},
        {ImageFormat::Jpeg, "JPEG", {"jpg", "jpeg"}, {Bits8}, false, true, true, true, 65500},
        {ImageFormat::WebP, "WebP", {"webp"}, {Bits8}, true, true, false, true, 16383},
        {ImageFormat::Pfm, "PFM", {"pfm"}, {Float}, false, false, false, false, 1 << 20},
    };
    return rows;
}

const FormatRow *rowOf(ImageFormat format)
{
    const auto it = std::ranges::find(formats(), format, &FormatRow::format);
    return it == formats().end() ? nullptr : &*it;
}

} // namespace

ImageFormat imageFormatForPath(const QString &path)
{
    for (const FormatRow &row : formats())
        for (const char *ending : row.endings)
            if (path.endsWith(QLatin1Char('.') + QLatin1String(ending), Qt::CaseInsensitive))
                return row.format;
    return ImageFormat::Unknown;
}

ImageFormat detectImageFormat(const QByteArray &bytes)
{
    if (bytes.startsWith(QByteArray("\x89PNG\r\n\x1a\n", 8)))
        return ImageFormat::Png;
    if (bytes.startsWith("\xFF\xD8\xFF"))
        return ImageFormat::Jpeg;
    // Classic TIFF and BigTIFF, in either byte order.
    for (const char *magic : {"II*\0", "MM\0*", "II+\0", "MM\0+"})
        if (bytes.startsWith(QByteArray(magic, 4)))
            return ImageFormat::Tiff;
    if (bytes.startsWith("\x76\x2f\x31\x01"))
        return ImageFormat::Exr;
    if (bytes.startsWith("RIFF") && bytes.mid(8, 4) == "WEBP")
        return ImageFormat::WebP;
    return ImageFormat::Unknown;
}

QString nameOf(ImageFormat format)
{
    const FormatRow *row = rowOf(format);
    return row ? QString::fromLatin1(row->name) : QString();
}

QString nameOf(ImageDepth depth)
{
    switch (depth) {
    case ImageDepth::Bits8:
        return QStringLiteral("8");
    case ImageDepth::Bits16:
        return QStringLiteral("16");
    case ImageDepth::Half:
        return QStringLiteral("half");
    case ImageDepth::Float:
        return QStringLiteral("float");
    }
    return {};
}

ImageDepth usualDepth(ImageFormat format)
{
    const FormatRow *row = rowOf(format);
    return row ? row->depths.front() : ImageDepth::Bits8;
}

QStringList imageEndings()
{
    QStringList all;
    for (const FormatRow &row : formats())
        for (const char *ending : row.endings)
            all.append(QString::fromLatin1(ending));
    return all;
}

bool hasResolution(ImageFormat format)
{
    const FormatRow *row = rowOf(format);
    return row && row->resolution;
}

bool hasProfile(ImageFormat format)
{
    const FormatRow *row = rowOf(format);
    return row && row->profile;
}

bool hasQuality(ImageFormat format)
{
    const FormatRow *row = rowOf(format);
    return row && row->quality;
}

int maxSideOf(ImageFormat format)
{
    const FormatRow *row = rowOf(format);
    return row ? row->maxSide : 0;
}

QString problemOf(ImageFormat format, const ImageOptions &options, int width, int height)
{
    const FormatRow *row = rowOf(format);
    if (!row)
        return QCoreApplication::translate("ImageFormat",
                                           "This is no image format that can be written. Use one of these endings: %1.")
            .arg(imageEndings().join(QStringLiteral(", ")));
    const ImageDepth depth = options.depth.value_or(usualDepth(format));
    if (std::ranges::find(row->depths, depth) == row->depths.end()) {
        QStringList have;
        for (ImageDepth d : row->depths)
            have.append(nameOf(d));
        return QCoreApplication::translate("ImageFormat", "%1 cannot hold depth %2. Choose %3, or another format.")
            .arg(nameOf(format), nameOf(depth), have.join(QStringLiteral(", ")));
    }
    if (!options.profile.isEmpty() && !row->profile)
        return QCoreApplication::translate(
                   "ImageFormat", "%1 cannot hold a colour profile. Use PNG, TIFF, JPEG or WebP, or export in sRGB.")
            .arg(nameOf(format));
    if (options.alpha && !row->alpha)
        return QCoreApplication::translate(
                   "ImageFormat",
                   "%1 cannot hold transparency. Use PNG, TIFF, EXR or WebP, or export with the background.")
            .arg(nameOf(format));
    if (width < 1 || height < 1 || width > row->maxSide || height > row->maxSide)
        return QCoreApplication::translate(
                   "ImageFormat", "%1 holds 1 to %2 pixels a side, not %3 × %4. Choose another size or format.")
            .arg(nameOf(format))
            .arg(row->maxSide)
            .arg(width)
            .arg(height);
    if (qint64(width) * height > maxPicturePixels)
        return QCoreApplication::translate("ImageFormat",
                                           "A picture of %1 × %2 pixels is too large: at most %3 million "
                                           "pixels can be drawn. Choose a smaller size.")
            .arg(width)
            .arg(height)
            .arg(maxPicturePixels / 1'000'000);
    return {};
}

Result<QByteArray> srgbIccProfile()
{
    const Result<ImageModule> &module = writingModule(ImageFormat::Tiff, 0);
    if (!module)
        return Error{module.error()};
    std::size_t size = 0;
    const char *bytes = module->profile ? module->profile(&size) : nullptr;
    return bytes ? QByteArray(bytes, qsizetype(size)) : QByteArray();
}

QString imageModuleProblem()
{
    for (const Result<ImageModule> &module : {readingModule(ImageFormat::WebP), readingModule(ImageFormat::Png)})
        if (!module)
            return module.error();
    return {};
}

} // namespace suffuse
