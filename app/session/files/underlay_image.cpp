#include "app/session/files/underlay_image.h"

#include "render/image_io/image_io.h"

#include <QCoreApplication>

#include <list>
#include <mutex>

namespace suffuse {

namespace {

/// Remembers an encoded picture and its decoded form, both by identity. A picture that nobody holds any more matches
/// nothing.
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

/// Converts straight RGBA in [0, 1] to premultiplied bytes.
void convertRow(const ImageRun &run, QImage &to)
{
    const auto byte = [](float v) { return int(v * 255 + 0.5f); };
    auto *pixels = reinterpret_cast<QRgb *>(to.bits());
    run.forEach([&, width = to.width()](int x, int y, const float *v) { // 4 bytes a pixel: no padding
        pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)] =
            qRgba(byte(v[0] * v[3]), byte(v[1] * v[3]), byte(v[2] * v[3]), byte(v[3]));
    });
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
    rows.row = [&](const ImageRun &run) {
        if (!picture.isNull())
            convertRow(run, picture);
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
