#include "render/drawing/drawn_picture.h"

#include "render/image_io/orientation.h"
#include "render/image_io/strip_metadata.h"

// It has templates over the numbers of scalar.h.
#include "render/math/picture.h"

#include <algorithm>

namespace suffuse {

namespace {

/// The image itself as an 8-bit PNG.
Result<QByteArray> encoded(const PictureLevel &level, const std::atomic<bool> *cancel)
{
    constexpr float most = 65535;
    std::vector<float> row(4 * std::size_t(level.width));
    const PictureRows rows(level.width, level.height, [&](int y) {
        const std::uint16_t *from = level.rgba + row.size() * std::size_t(y);
        for (std::size_t i = 0; i < row.size(); i += 4) {
            for (std::size_t c = 0; c < 3; ++c)
                row[i + c] = std::min(1.0f, float(from[i + c]) / std::max(1.0f, float(from[i + 3])));
            row[i + 3] = float(from[i + 3]) / most;
        }
        return row.data();
    });
    ImageOptions options;
    options.alpha = true;
    options.quick = true;
    options.cancel = cancel;
    return encodeImage(ImageFormat::Png, rows, options, QStringLiteral("PNG"));
}

} // namespace

Result<DrawnImage> drawnImage(const Picture &picture, const std::atomic<bool> *cancel)
{
    const ImageFormat format = detectImageFormat(*picture.image);
    const bool isKnown = format == ImageFormat::Png || format == ImageFormat::Jpeg;
    if (isKnown && orientationOf(*picture.image, format).exif() == 1)
        return DrawnImage{withoutMetadata(*picture.image, format),
                          format == ImageFormat::Png ? "image/png" : "image/jpeg"};
    const Result<PictureLevelsPtr> levels = pictureLevels(picture);
    if (!levels)
        return Error{levels.error()};
    Result<QByteArray> bytes = encoded((*levels)->level(0), cancel);
    if (!bytes)
        return Error{bytes.error()};
    return DrawnImage{std::move(*bytes)};
}

DrawnColour colourAt(const ScenePicture &picture, int x, int y)
{
    const PictureView &view = picture.view;
    const double u = view.u + view.ux * (x + 0.5) + view.uy * (y + 0.5);
    const double v = view.v + view.vx * (x + 0.5) + view.vy * (y + 0.5);
    if (!(u >= 0 && v >= 0 && u <= view.finer.width && v <= view.finer.height))
        return {};
    math::PictureSum sum;
    math::addLevel(view.finer, u, v, 1 - view.share, sum);
    if (view.share > 0)
        math::addLevel(view.coarser, 0.5 * u, 0.5 * v, view.share, sum);
    const double alpha = double(sum.c[3]);
    DrawnColour colour{0, 0, 0, std::min(1.0, alpha / 65535)};
    for (std::size_t c = 0; c < 3 && alpha > 0; ++c)
        colour[c] = std::min(1.0, double(sum.c[c]) / alpha);
    return colour;
}

} // namespace suffuse
