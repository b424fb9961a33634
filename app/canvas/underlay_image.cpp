#include "app/canvas/underlay_image.h"

#include "render/image_io/image_io.h"

#include <QCoreApplication>

#include <list>
#include <mutex>

namespace suffuse {

namespace {

/// Both by identity; what nobody holds any more matches nothing.
struct Decoded {
    std::weak_ptr<const QByteArray> encoded;
    std::weak_ptr<const UnderlayImage> image;
};

std::mutex mutex;
std::list<Decoded> inUse;

void remember(const EncodedImage &encoded, const UnderlayImagePtr &image)
{
    const std::lock_guard lock(mutex);
    inUse.remove_if([](const Decoded &d) { return d.image.expired() || d.encoded.expired(); });
    inUse.push_back({encoded, image});
}

/// Straight RGBA in [0, 1] to premultiplied bytes.
void convertRow(const float *from, QRgb *to, int width)
{
    const auto byte = [](float v) { return int(v * 255 + 0.5f); };
    for (int x = 0; x < width; ++x, from += 4)
        to[x] = qRgba(byte(from[0] * from[3]), byte(from[1] * from[3]), byte(from[2] * from[3]), byte(from[3]));
}

void addLevels(std::vector<QImage> &levels)
{
    while (levels.back().width() > 1 || levels.back().height() > 1) {
        const QImage &last = levels.back();
        levels.push_back(last.scaled(std::max(1, last.width() / 2), std::max(1, last.height() / 2),
                                     Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    }
}

} // namespace

UnderlayImagePtr decodedUnderlay(const EncodedImage &encoded)
{
    const std::lock_guard lock(mutex);
    for (const Decoded &d : inUse)
        if (encoded && d.encoded.lock() == encoded)
            return d.image.lock();
    return {};
}

Result<UnderlayImagePtr> decodeUnderlay(const EncodedImage &encoded, const QString &name)
{
    if (UnderlayImagePtr known = decodedUnderlay(encoded))
        return known;
    QImage picture;
    ImageRows rows;
    rows.begin = [&](int width, int height) { picture = QImage(width, height, QImage::Format_ARGB32_Premultiplied); };
    rows.row = [&](int y, const float *rgba) {
        if (!picture.isNull())
            convertRow(rgba, reinterpret_cast<QRgb *>(picture.scanLine(y)), picture.width());
    };
    if (const Result<void> read = readImageRows(encoded ? *encoded : QByteArray(), name, rows); !read)
        return Error{read.error()};
    if (picture.isNull())
        return Error{QCoreApplication::translate("Underlay", "%1: there is not enough memory for it.").arg(name)};
    auto image = std::make_shared<UnderlayImage>();
    image->levels.push_back(std::move(picture));
    addLevels(image->levels);
    remember(encoded, image);
    return UnderlayImagePtr(image);
}

} // namespace suffuse
