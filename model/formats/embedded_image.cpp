#include "model/formats/embedded_image.h"

#include "model/formats/messages.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QtEndian>

namespace suffuse {

QString imageMediaType(const QByteArray &bytes)
{
    if (bytes.startsWith("\x89PNG\r\n\x1a\n"))
        return QStringLiteral("image/png");
    if (bytes.startsWith("\xff\xd8\xff"))
        return QStringLiteral("image/jpeg");
    const QByteArray four = bytes.left(4);
    if (four == QByteArray("II*\0", 4) || four == QByteArray("MM\0*", 4) || four == QByteArray("II+\0", 4) ||
        four == QByteArray("MM\0+", 4))
        return QStringLiteral("image/tiff");
    if (four == "RIFF" && bytes.mid(8, 4) == "WEBP")
        return QStringLiteral("image/webp");
    if (bytes.startsWith("\x76\x2f\x31\x01"))
        return QStringLiteral("image/x-exr");
    return {};
}

Result<EncodedImage> checkedImage(const QByteArray &bytes)
{
    if (bytes.size() > largestImage)
        return Error{FileMessages::tr("the image has %1 MB; at most 64 MB are possible, make it smaller")
                         .arg(bytes.size() >> 20)};
    if (imageMediaType(bytes).isEmpty())
        return Error{FileMessages::tr("is not a PNG, JPEG, TIFF, WebP or EXR image; convert it to one of them")};
    return std::make_shared<const QByteArray>(bytes);
}

namespace {

std::optional<std::pair<int, int>> fitting(std::uint32_t width, std::uint32_t height)
{
    const auto fits = [](std::uint32_t side) { return side > 0 && side <= std::uint32_t(Picture::mostSide); };
    if (!fits(width) || !fits(height) || std::uint64_t(width) * height > Picture::mostPixels)
        return {};
    return std::pair(int(width), int(height));
}

/// Walks over the segments of a JPEG up to its frame. Those with Exif may be turned.
std::optional<std::pair<int, int>> pixelsOfJpeg(const QByteArray &jpeg)
{
    const auto number = [&](qsizetype at) { return qFromBigEndian<std::uint16_t>(jpeg.constData() + at); };
    for (qsizetype at = 2; at + 9 < jpeg.size() && std::uint8_t(jpeg[at]) == 0xff; at += 2 + number(at + 2)) {
        const int marker = std::uint8_t(jpeg[at + 1]);
        if (marker == 0xe1 && jpeg.mid(at + 4, 4) == "Exif")
            return {};
        if (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc)
            return fitting(number(at + 7), number(at + 5));
    }
    return {};
}

} // namespace

std::optional<std::pair<int, int>> pixelsOf(const QByteArray &image)
{
    constexpr qsizetype head = 24; // the signature, and the first chunk up to the size
    if (image.size() >= head && image.startsWith("\x89PNG\r\n\x1a\n") && image.mid(12, 4) == "IHDR")
        return fitting(qFromBigEndian<std::uint32_t>(image.constData() + 16),
                       qFromBigEndian<std::uint32_t>(image.constData() + 20));
    return image.startsWith("\xff\xd8\xff") ? pixelsOfJpeg(image) : std::nullopt;
}

namespace {

Result<EncodedImage> imageBeside(const QString &path, const QString &fileName)
{
    const QFileInfo info(QFileInfo(fileName).absoluteDir(), path);
    const QString shown = QDir::toNativeSeparators(info.filePath());
    if (path.isEmpty())
        return Error{FileMessages::tr("is empty; give a data: URL or the path of an image file")};
    if (!info.exists())
        return Error{FileMessages::tr("the image file %1 is missing; put it there or correct the path").arg(shown)};
    if (!info.isFile())
        return Error{FileMessages::tr("%1 is not a file").arg(shown)};
    if (info.size() > largestImage)
        return Error{FileMessages::tr("the image file %1 has %2 MB; at most 64 MB are possible")
                         .arg(shown)
                         .arg(info.size() >> 20)};
    QFile file(info.filePath());
    if (!file.open(QIODevice::ReadOnly))
        return Error{FileMessages::tr("the image file %1 cannot be read: %2").arg(shown, file.errorString())};
    auto image = checkedImage(file.read(largestImage + 1));
    if (!image)
        return Error{shown + QLatin1Char(' ') + image.error()};
    return image;
}

} // namespace

Result<EncodedImage> imageFromText(const QString &text, const QString &fileName)
{
    if (!text.startsWith(QLatin1String("data:")))
        return imageBeside(text, fileName);
    const qsizetype comma = text.indexOf(QLatin1Char(','));
    if (comma < 0 || !QStringView(text).left(comma).endsWith(QLatin1String(";base64")))
        return Error{FileMessages::tr("is not a data:…;base64,… URL")};
    if (text.size() - comma > largestImage / 3 * 4 + 8)
        return Error{FileMessages::tr("the image is too large; at most 64 MB are possible")};
    const auto decoded = QByteArray::fromBase64Encoding(QStringView(text).mid(comma + 1).toLatin1(),
                                                        QByteArray::AbortOnBase64DecodingErrors);
    if (!decoded)
        return Error{FileMessages::tr("the base64 data of the image are damaged")};
    return checkedImage(*decoded);
}

QByteArray imageToText(const QByteArray &bytes)
{
    return "data:" + imageMediaType(bytes).toLatin1() + ";base64," + bytes.toBase64();
}

} // namespace suffuse
