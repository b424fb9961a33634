#include "model/formats/embedded_image.h"

#include "model/formats/messages.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

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
