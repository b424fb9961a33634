#include "render/image_io/colour_conversion.h"
#include "render/image_io/declared_size.h"
#include "render/image_io/embedded_profile.h"
#include "render/image_io/image_io.h"
#include "render/image_io/image_module.h"
#include "render/image_io/orientation.h"
#include "render/image_io/srgb.h"
#include "render/image_io/strip_metadata.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace suffuse {

namespace {

/// Converts the rows of the module to straight sRGB-encoded RGBA.
struct RowConverter {
    const ImageRows &rows;
    Orientation orientation;
    ColourConversion colours; ///< from the profile of the file
    int width = 0;
    int height = 0;
    int channels = 0;
    bool linear = false;
    bool associated = false;
    std::vector<float> rgba;

    void begin(int w, int h, int c, bool isLinear, bool isAssociated)
    {
        width = w, height = h, channels = c, linear = isLinear, associated = isAssociated;
        rgba.resize(std::size_t(w) * 4);
        orientation.swapsSides() ? rows.begin(h, w) : rows.begin(w, h);
    }
    void row(int y, const float *values)
    {
        for (int x = 0; x < width; ++x)
            pixel(values + std::size_t(x) * channels, rgba.data() + std::size_t(x) * 4);
        convert();
        ImageRun run = orientation.run(y, width, height);
        run.rgba = rgba.data();
        rows.row(run);
    }
    /// A profile for grey says nothing of pixels that have colours.
    void convert()
    {
        if (colours.changesNothing() || (colours.isFromGrey() && channels > 2))
            return;
        colours.apply(rgba.data(), std::size_t(width));
        for (float &v : rgba)
            v = v > 0 ? std::min(v, 1.0f) : 0; // NaN becomes 0, too.
    }
    void pixel(const float *v, float *out) const
    {
        const bool grey = channels < 3;
        for (int c = 0; c < 3; ++c)
            out[c] = v[grey ? 0 : c];
        out[3] = channels == 2 ? v[1] : channels == 4 ? v[3] : 1;
        for (int c = 0; c < 4; ++c)
            if (!(out[c] >= 0)) // This is true of NaN, too.
                out[c] = 0;
        out[3] = std::min(out[3], 1.0f);
        for (int c = 0; c < 3; ++c) {
            if (associated && (channels == 2 || channels == 4))
                out[c] = out[3] > 0 ? out[c] / out[3] : 0;
            out[c] = std::min(linear ? srgbFromLinear(out[c]) : out[c], 1.0f);
        }
    }
};

/// What makes sRGB of the colours of a file. A profile that is broken, or for other colours than red, green and blue,
/// is as none.
ColourConversion conversionOf(const QByteArray &bytes, ImageFormat format)
{
    const QByteArray profile = embeddedProfile(bytes, format);
    if (profile.isEmpty())
        return {};
    const Result<ColourConversion> conversion = ColourConversion::between({profile, {}, {}});
    return conversion ? *conversion : ColourConversion();
}

Error tooLarge(const QString &name)
{
    return {QCoreApplication::translate("ImageReader", "%1: the image declares more than %2 × %2 or %3 million pixels. "
                                                       "Scale it down first.")
                .arg(name)
                .arg(maxImageSide)
                .arg(maxImagePixels / 1'000'000)};
}

} // namespace

Result<void> readImageRows(const QByteArray &bytes, const QString &name, const ImageRows &rows)
{
    const ImageFormat format = detectImageFormat(bytes);
    if (format == ImageFormat::Unknown)
        return Error{QCoreApplication::translate(
                         "ImageReader", "%1: is not a PNG, JPEG, TIFF, EXR or WebP image. Convert it to one of them.")
                         .arg(name)};
    if (declaresTooMuch(bytes, format))
        return tooLarge(name);
    const Result<ImageModule> &module = readingModule(format);
    if (!module)
        return Error{QCoreApplication::translate("ImageReader", "%1: cannot read %2: %3.")
                         .arg(name, nameOf(format), module.error())};
    RowConverter converter{rows, orientationOf(bytes, format), conversionOf(bytes, format), 0, 0, 0, false, false, {}};
    ImageModuleRead job{};
    job.format = imageModuleName(format);
    const QByteArray pixels = withoutMetadata(bytes, format);
    job.bytes = pixels.constData();
    job.size = std::size_t(pixels.size());
    job.maxSide = maxImageSide;
    job.maxPixels = maxImagePixels;
    job.context = &converter;
    job.begin = [](void *c, int w, int h, int channels, bool linear, bool associated) {
        static_cast<RowConverter *>(c)->begin(w, h, channels, linear, associated);
    };
    job.row = [](void *c, int y, const float *values) { static_cast<RowConverter *>(c)->row(y, values); };
    std::array<char, 512> error{};
    if (!module->read(&job, error.data(), error.size()))
        return Error{QCoreApplication::translate(
                         "ImageReader", "%1: the %2 image cannot be read (%3). It may be damaged, or too large "
                                        "(at most %4 pixels a side, %5 million in all).")
                         .arg(name, nameOf(format), QString::fromUtf8(error.data()).trimmed())
                         .arg(maxImageSide)
                         .arg(maxImagePixels / 1'000'000)};
    return {};
}

Result<FloatPicture> readImage(const QByteArray &bytes, const QString &name)
{
    FloatPicture picture;
    ImageRows rows;
    rows.begin = [&picture](int width, int height) { picture.resize(width, height); };
    rows.row = [&picture](const ImageRun &run) {
        run.forEach([&picture](int x, int y, const float *rgba) {
            std::copy_n(rgba, 4, picture.rgba.data() + (std::size_t(y) * picture.width + x) * 4);
        });
    };
    if (Result<void> read = readImageRows(bytes, name, rows); !read)
        return Error{read.error()};
    return picture;
}

} // namespace suffuse
