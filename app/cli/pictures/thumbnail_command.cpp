// The thumbnail of a painting for a file manager: its preview, if it has one. It takes a few milliseconds, reads no
// settings, and starts no device.
#include "app/cli/options.h"
#include "model/formats/files.h"
#include "model/formats/suffuse/suffuse_preview.h"
#include "render/backends.h"
#include "render/fitting/fit_picture.h"
#include "render/image_io/plain_png.h"

#include <QCoreApplication>
#include <QFile>

#include <algorithm>
#include <cmath>

namespace suffuse::cli {

namespace {

/// The largest thumbnail that desktops have ("xx-large").
constexpr int largestThumbnail = 1024;

/// The sides of a picture of this shape, of which the longer one has `side` pixels.
std::pair<int, int> fitted(double width, double height, int side)
{
    const double scale = side / std::max(width, height);
    return {std::max(1, int(std::lround(width * scale))), std::max(1, int(std::lround(height * scale)))};
}

/// Each pixel is the mean of the area that it covers.
FloatPicture shrunk(const FloatPicture &picture, int width, int height)
{
    fitting::FitPicture all(picture.width, picture.height, 4);
    for (std::size_t i = 0; i < all.values.size(); i += 4) {
        const float *rgba = picture.rgba.data() + i;
        for (std::size_t c = 0; c < 3; ++c)
            all.values[i + c] = rgba[c] * rgba[3];
        all.values[i + 3] = rgba[3];
    }
    const fitting::FitPicture means = fitting::averaged(all, width, height);
    FloatPicture out;
    out.resize(width, height);
    for (std::size_t i = 0; i < means.values.size(); i += 4) {
        const float alpha = std::clamp(means.values[i + 3], 0.0f, 1.0f);
        for (std::size_t c = 0; c < 3; ++c)
            out.rgba.data()[i + c] = alpha > 0 ? std::clamp(means.values[i + c] / alpha, 0.0f, 1.0f) : 0;
        out.rgba.data()[i + 3] = alpha;
    }
    return out;
}

Result<QByteArray> pngOf(const FloatPicture &picture, const QString &name)
{
    ImageOptions options;
    options.quick = true;
    for (std::size_t i = 3; i < std::size_t(picture.width) * picture.height * 4 && !options.alpha; i += 4)
        options.alpha = picture.rgba.data()[i] < 1;
    return encodeImage(ImageFormat::Png, picture, options, name);
}

/// The preview at no more than `side` pixels a side; as it is, where it is not larger. Empty if it is no picture.
QByteArray thumbnailOf(const QByteArray &preview, int side, const QString &name)
{
    std::optional<FloatPicture> picture = readPlainPng(preview, largestThumbnail);
    if (!picture) {
        Result<FloatPicture> read = readImage(preview, name);
        if (!read)
            return {};
        picture = std::move(*read);
    }
    if (std::max(picture->width, picture->height) <= side)
        return preview;
    const auto [width, height] = fitted(picture->width, picture->height, side);
    const Result<QByteArray> png = pngOf(shrunk(*picture, width, height), name);
    return png ? *png : QByteArray();
}

/// A painting without a preview is drawn, at the end of its time.
Result<QByteArray> drawnThumbnail(const QString &path, int side)
{
    Result<Painting> painting = paintingOf(path);
    if (!painting)
        return Error{painting.error()};
    const auto [width, height] = fitted(painting->canvas.width, painting->canvas.height, side);
    RenderRequest request;
    request.time = painting->end();
    request.view = View::ofArea(painting->canvas.area(), width, height);
    request.painting = std::make_shared<const Painting>(std::move(*painting));
    const Result<std::unique_ptr<Renderer>> renderer = makeRenderer({.backend = Backend::Cpu});
    if (!renderer)
        return Error{renderer.error()};
    FloatPicture picture;
    if (const Result<RenderStats> stats = renderPicture(**renderer, request, picture); !stats)
        return Error{QStringLiteral("%1: %2").arg(path, stats.error())};
    return pngOf(picture, path);
}

/// What of a file may have its preview; empty where it cannot be read, of which the loader of paintings knows why.
QByteArray startOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.read(previewReach) : QByteArray();
}

} // namespace

int thumbnailCommand(const QStringList &arguments)
{
    CommandLine line("thumbnail",
                     QCoreApplication::translate("Cli", "Writes a small picture of a painting as a PNG file: the preview "
                                                        "in the file, if it has one. File managers call this."),
                     {"FILE", "PNG", "SIDE"});
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    const QString in = line.argument(0), out = line.argument(1);
    const std::optional<double> side = toNumber(line.argument(2));
    if (!side || *side != std::floor(*side) || *side < 1 || *side > largestThumbnail)
        return failUsage("thumbnail", QCoreApplication::translate("Cli", "%1: give SIDE as a whole number of pixels "
                                                                         "from 1 to %2")
                                          .arg(line.argument(2))
                                          .arg(largestThumbnail));
    if (isSameFile(in, out))
        return failUsage("thumbnail", inputWouldBeLost(out));
    QByteArray png;
    if (const QByteArray preview = previewIn(startOf(in)); !preview.isEmpty())
        png = thumbnailOf(preview, int(*side), in);
    if (png.isEmpty()) {
        const Result<QByteArray> drawn = drawnThumbnail(in, int(*side));
        if (!drawn)
            return fail(drawn.error());
        png = *drawn;
    }
    if (out == "-")
        return printBytes(png);
    const Result<void> written = writeFileAtomically(out, png);
    return written ? int(Done) : fail(written.error());
}

} // namespace suffuse::cli
