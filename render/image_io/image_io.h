// Writes pictures to image files, and reads images. Everything except PFM goes through modules, which are loaded on
// first use.
#pragma once

#include "model/result.h"
#include "render/target.h"

#include <QByteArray>
#include <QString>

#include <atomic>
#include <functional>
#include <optional>
#include <utility>

namespace suffuse {

enum class ImageFormat { Unknown, Png, Tiff, Exr, Jpeg, WebP, Pfm };

/// The bits of a channel: whole numbers of 8 or 16 bits, or floating point of 16 (half) or 32 bits.
enum class ImageDepth { Bits8, Bits16, Half, Float };

/// How a picture is stored. PNG, TIFF, JPEG, WebP and PFM store sRGB-encoded values as they are. EXR stores linear
/// light with associated (premultiplied) alpha, as OpenEXR demands; the others store straight alpha.
struct ImageOptions {
    std::optional<ImageDepth> depth; ///< no value: the usual depth of the format (`usualDepth`)
    bool alpha = false;              ///< whether there are four channels instead of three
    int quality = 92;                ///< JPEG and WebP, 1 … 100; 100 is lossless in WebP
    /// The ICC profile of the colours that are written, and that the file says (`hasProfile`); empty: sRGB.
    QByteArray profile;
    double dpi = 0; ///< pixels an inch, 1 … 10,000, if the format can say it; 0: not said
    /// whether a PNG of 8 bits is written in a quarter of the time, a fifteenth larger
    bool quick = false;
    const std::atomic<bool> *cancel = nullptr; ///< when it becomes true, writing stops soon and leaves nothing behind
    std::function<void(int done, int rows)> progress; ///< called after each row
};

/// The format by the ending of a path, in upper or lower case; Unknown for other endings.
ImageFormat imageFormatForPath(const QString &path);
/// PNG, JPEG, TIFF, EXR or WebP by the first bytes, never by a name; Unknown for anything else.
ImageFormat detectImageFormat(const QByteArray &bytes);
QString nameOf(ImageFormat format); ///< a name such as "PNG"
QString nameOf(ImageDepth depth);   ///< "8", "16", "half" or "float", as on the command line
ImageDepth usualDepth(ImageFormat format);
/// The endings of files that can be written, for messages and file dialogs: "png", "tiff", "tif", "exr", "jpg", "jpeg",
/// "webp", "pfm".
QStringList imageEndings();
/// Whether files of a format can say how many pixels an inch has.
bool hasResolution(ImageFormat format);
/// Whether files of a format can say in which ICC profile their colours are.
bool hasProfile(ImageFormat format);
/// Whether `ImageOptions::quality` has a meaning for a format.
bool hasQuality(ImageFormat format);

/// The largest picture that is drawn and written, in pixels, each of which takes 16 bytes in memory.
inline constexpr qint64 maxPicturePixels = qint64(1) << 28;
/// The greatest number of pixels along a side that a format can store.
int maxSideOf(ImageFormat format);

/// Empty if a format can store such a picture. Otherwise it says why not, and what to choose instead (depth, alpha,
/// size).
QString problemOf(ImageFormat format, const ImageOptions &options, int width, int height);

/// A picture whose rows are asked for one after another while it is written, from the top (PFM: from the bottom).
struct PictureRows {
    PictureRows(int width, int height, std::function<const float *(int y)> row)
        : width(width), height(height), row(std::move(row))
    {}
    /// The rows of a picture in memory, which outlives them.
    PictureRows(const FloatPicture &picture) // NOLINT(google-explicit-constructor)
        : PictureRows(picture.width, picture.height, [&picture](int y) { return picture.at(0, y); })
    {}

    int width, height;
    std::function<const float *(int y)> row; ///< width straight RGBA pixels, valid until the next call
};

/// Writes a picture in the format of the path's ending. The target is replaced when the whole picture is on disk, or
/// left as it was: rows are streamed to a temporary file beside it. Errors name the file and the remedy. It may be
/// called on any thread.
Result<void> writeImage(const QString &path, const PictureRows &picture, const ImageOptions &options);
/// Returns the same as the bytes of a file. `name` is used in messages.
Result<QByteArray> encodeImage(ImageFormat format, const PictureRows &picture, const ImageOptions &options,
                               const QString &name);

/// The largest image that is read: its sides, and its pixels (256 MB as 8 bit RGBA). Declared sizes are checked before
/// decoding.
inline constexpr int maxImageSide = 16384;
inline constexpr qint64 maxImagePixels = qint64(1) << 26;

/// Decodes PNG, JPEG, TIFF, EXR or WebP to sRGB-encoded values in [0, 1] (NaN becomes 0) with straight alpha, upright
/// as the file's Exif data say. Colours are converted from the file's ICC profile (relative colorimetric, with black
/// points); without one, and where its profile is sRGB to half a 255th, its values are taken as they are. `name` is
/// used in messages. It may be called on any thread.
Result<FloatPicture> readImage(const QByteArray &bytes, const QString &name);

/// Pixels of an image that follow each other: pixel i lies at (x + i·dx, y + i·dy). (dx, dy) is a step along a row or a
/// column of the upright image, in either direction.
struct ImageRun {
    int x = 0, y = 0;
    int dx = 1, dy = 0;
    const float *rgba = nullptr; ///< `count` straight RGBA pixels
    int count = 0;

    /// Calls put(x, y, rgba) for each pixel.
    template <typename Put>
    void forEach(const Put &put) const
    {
        for (int i = 0; i < count; ++i)
            put(x + i * dx, y + i * dy, rgba + std::size_t(i) * 4);
    }
};

/// Receives an image while it is decoded: first its upright size, then each row of the file, with its place in the
/// image.
struct ImageRows {
    std::function<void(int width, int height)> begin;
    std::function<void(const ImageRun &run)> row;
};
/// Does what `readImage` does, without keeping the picture.
Result<void> readImageRows(const QByteArray &bytes, const QString &name, const ImageRows &rows);

/// The ICC profile of sRGB, by which other programs know what the values of a file mean. It is always the same.
Result<QByteArray> srgbIccProfile();

/// Empty if the modules can be loaded. Otherwise it says why not, with the remedy.
QString imageModuleProblem();

} // namespace suffuse
