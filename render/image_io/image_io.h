// Image files: pictures out, images in. Everything but PFM goes through modules that are loaded on first use.
#pragma once

#include "model/result.h"
#include "render/target.h"

#include <QByteArray>
#include <QString>

#include <atomic>
#include <functional>
#include <optional>

namespace suffuse {

enum class ImageFormat { Unknown, Png, Tiff, Exr, Jpeg, WebP, Pfm };

/// Bits of a channel: 8 or 16 bit whole numbers, 16 bit (half) or 32 bit floating point.
enum class ImageDepth { Bits8, Bits16, Half, Float };

/// How a picture is stored. PNG, TIFF, JPEG, WebP and PFM hold sRGB-encoded values as they are; EXR holds linear light
/// with associated (premultiplied) alpha, as OpenEXR has it; the others hold straight alpha.
struct ImageOptions {
    std::optional<ImageDepth> depth;           ///< none: the format's usual one (`usualDepth`)
    bool alpha = false;                        ///< four channels instead of three
    int quality = 92;                          ///< JPEG and WebP, 1 … 100; 100 is lossless in WebP
    double dpi = 0;                            ///< pixels an inch, 1 … 10,000, where the format says it; 0: none
    bool quick = false;                        ///< PNG of 8 bits: in a quarter of the time, a fifteenth larger
    const std::atomic<bool> *cancel = nullptr; ///< becomes true: stop soon, leave nothing behind
    std::function<void(int done, int rows)> progress; ///< called after each row
};

/// From the file's ending, whatever its case; Unknown for others.
ImageFormat imageFormatForPath(const QString &path);
/// PNG, JPEG, TIFF, EXR or WebP by the first bytes, never by name; Unknown for anything else.
ImageFormat detectImageFormat(const QByteArray &bytes);
QString nameOf(ImageFormat format); ///< "PNG" …
QString nameOf(ImageDepth depth);   ///< "8", "16", "half", "float": as the command line spells them
ImageDepth usualDepth(ImageFormat format);
/// The endings that can be written, for messages and file dialogs: "png", "tiff", "tif", "exr", "jpg", "jpeg", "webp",
/// "pfm".
QStringList imageEndings();
/// Whether the format's files can say how many pixels an inch has.
bool hasResolution(ImageFormat format);
/// Whether `ImageOptions::quality` means something to it.
bool hasQuality(ImageFormat format);

/// Largest picture that is drawn and written: pixels, at 16 bytes each in memory.
inline constexpr qint64 maxPicturePixels = qint64(1) << 28;
/// Pixels a side that the format holds.
int maxSideOf(ImageFormat format);

/// Empty if the format can hold such a picture, else why not and what to choose instead (depth, alpha, size).
QString problemOf(ImageFormat format, const ImageOptions &options, int width, int height);

/// Writes the picture in the format of the path's ending. The target is replaced when the whole picture is on disk, or
/// left as it was: rows are streamed to a temporary file beside it. Errors name the file and the remedy. Any thread.
Result<void> writeImage(const QString &path, const FloatPicture &picture, const ImageOptions &options);
/// The same as the bytes of a file. `name` stands in messages.
Result<QByteArray> encodeImage(ImageFormat format, const FloatPicture &picture, const ImageOptions &options,
                               const QString &name);

/// Largest image that is read: sides, and pixels (256 MB as 8 bit RGBA). Declared sizes are checked before decoding.
inline constexpr int maxImageSide = 16384;
inline constexpr qint64 maxImagePixels = qint64(1) << 26;

/// Decodes PNG, JPEG, TIFF, EXR or WebP: sRGB-encoded, straight alpha, values in [0, 1] (NaN becomes 0), upright as the
/// file's Exif data say. `name` stands in messages. Any thread.
Result<FloatPicture> readImage(const QByteArray &bytes, const QString &name);

/// Pixels of an image that follow each other: pixel i lies at (x + i·dx, y + i·dy). (dx, dy) is a step along a row or a
/// column of the upright image, in either direction.
struct ImageRun {
    int x = 0, y = 0;
    int dx = 1, dy = 0;
    const float *rgba = nullptr; ///< count straight RGBA pixels
    int count = 0;

    /// Calls put(x, y, rgba) for each.
    template <typename Put>
    void forEach(const Put &put) const
    {
        for (int i = 0; i < count; ++i)
            put(x + i * dx, y + i * dy, rgba + std::size_t(i) * 4);
    }
};

/// Receives an image while it is decoded: its size, upright, then a row of the file at a time, where that lies.
struct ImageRows {
    std::function<void(int width, int height)> begin;
    std::function<void(const ImageRun &run)> row;
};
/// As `readImage`, without holding the picture.
Result<void> readImageRows(const QByteArray &bytes, const QString &name, const ImageRows &rows);

/// Empty if the modules can be loaded, else why not, with the remedy.
QString imageModuleProblem();

} // namespace suffuse
