// The border between the program and the image modules. It has plain C types, so that a module needs nothing of the
// program.
#pragma once

#include <cstddef>
#include <cstdint>

namespace suffuse {

/// Both sides must have the same number. Raise it with every change below.
inline constexpr int imageModuleVersion = 9;

/// The codes for `ImageDepth` and `ImageFormat` on the border.
enum ImageModuleDepth { ModuleBits8, ModuleBits16, ModuleHalf, ModuleFloat };

/// A file to be written, as the module sees it. Offsets are in bytes. A count that is too small means that the transfer
/// failed.
struct ImageModuleFile {
    void *context;
    std::size_t (*read)(void *context, void *to, std::size_t bytes, std::int64_t offset);
    std::size_t (*write)(void *context, const void *from, std::size_t bytes, std::int64_t offset);
    std::int64_t (*size)(void *context);
};

struct ImageModuleWrite {
    const char *format; ///< OpenImageIO's name: "png", "tiff", "openexr", "jpeg", "webp"
    ImageModuleFile file;
    int width;
    int height;
    int channels; ///< 3, or 4 with alpha
    int depth;    ///< ImageModuleDepth
    bool linear;  ///< whether values are linear light instead of sRGB
    bool associated;
    int quality; ///< 1 … 100
    bool quick;  ///< whether a PNG of 8 bits is compressed less
    double dpi;  ///< pixels an inch; 0: not said
    /// the ICC profile that says what the values mean; null: they are sRGB. EXR has none.
    const void *profile;
    std::size_t profileSize;
    void *context;
    /// returns width·channels floats, which are valid until the next call; null: stop
    const float *(*row)(void *context, int y);
    bool (*stopped)(void *context); ///< whether writing is to stop; may be called on any thread
};

/// What a tile becomes: a JPEG file, or a tile of a TIFF file that is packed by deflate, of which the file is written
/// by the program.
enum ImageModuleTileKind { ModuleTileJpeg, ModuleTileTiff };

/// A tile that is cut out of a picture in memory.
struct ImageModuleTile {
    int kind; ///< ImageModuleTileKind
    ImageModuleFile file;
    int width, height;
    int side;     ///< of a tile of a TIFF file, which is square: what lies beyond width and height is 0
    int channels; ///< 3, or 4 with alpha
    int depth;    ///< ModuleBits8: `argb` is set; ModuleBits16: `rgba` is set
    const std::uint32_t *argb;
    const float *rgba;
    std::size_t stride; ///< pixels from row to row
    int quality;        ///< 1 … 100, of JPEG
    const void *profile;
    std::size_t profileSize;
};

struct ImageModuleRead {
    const char *format;
    const void *bytes;
    std::size_t size;
    int maxSide;
    std::int64_t maxPixels;
    void *context;
    void (*begin)(void *context, int width, int height, int channels, bool linear, bool associated);
    void (*row)(void *context, int y, const float *values); ///< width·channels floats, 1 … 4 channels
};

/// An animated WebP that is being made.
struct ImageModuleFilm {
    int width;
    int height;
    int channels; ///< 3, or 4 with alpha
    int quality;  ///< 1 … 100
    bool loops;
    std::int64_t bytes; ///< set by the module: the size of the file so far
    void *work;         ///< belongs to the module; null at first and after the end
};

/// What colours are to become: those of one ICC profile colours of another one, and on the way, if that is asked for,
/// what a third one can show of them. A profile without bytes is sRGB.
struct ImageModuleColours {
    const void *from;
    std::size_t fromSize;
    const void *to;
    std::size_t toSize;
    const void *proof; ///< null: none
    std::size_t proofSize;
    int intent;       ///< of ICC: 0 perceptual, 1 relative colorimetric, 2 saturation, 3 absolute colorimetric
    bool blackPoints; ///< whether the darkest colour of one becomes the darkest of the other
    bool marksGamut;  ///< whether colours that `proof` has not are marked: their channels become -1
    bool isGrey;      ///< set by the module: whether `from` is for grey, of which the first channel is taken
    bool isSame;      ///< set by the module: whether no channel changes by half of a 255th (and nothing is marked)
};

/// The entry points of a module (C linkage): `suffuse_image_module_version`, `suffuse_image_write`,
/// `suffuse_image_read`, and in the small module `suffuse_image_film_add`, `suffuse_image_film_end`,
/// `suffuse_image_profile`, `suffuse_image_tile`, `suffuse_colours_name`, `suffuse_colours_open`,
/// `suffuse_colours_apply` and `suffuse_colours_close`. Those that return a bool return false if they fail, and put a
/// message (UTF-8, cut to `size` bytes) into `error`.
using ImageModuleVersionFunction = int (*)();
using ImageModuleWriteFunction = bool (*)(const ImageModuleWrite *job, char *error, std::size_t size);
using ImageModuleTileFunction = bool (*)(const ImageModuleTile *tile, char *error, std::size_t size);
using ImageModuleReadFunction = bool (*)(const ImageModuleRead *job, char *error, std::size_t size);
/// Shows a picture of width·height·channels bytes from so many milliseconds after the start of the film.
using ImageModuleFilmAddFunction = bool (*)(ImageModuleFilm *film, const std::uint8_t *pixels,
                                            std::int64_t milliseconds, char *error, std::size_t size);
/// Writes the film, which lasts so many milliseconds, to the file. Without a file it is given up. `work` is freed in
/// any case.
using ImageModuleFilmEndFunction = bool (*)(ImageModuleFilm *film, const ImageModuleFile *file,
                                            std::int64_t milliseconds, char *error, std::size_t size);
/// The ICC profile of sRGB, which lives as long as the module; null if there is no memory for it.
using ImageModuleProfileFunction = const char *(*)(std::size_t *size);
/// The colours of a profile.
enum ImageModuleSpace { ModuleNoSpace, ModuleRgb, ModuleGrey, ModuleCmyk };
/// Puts what a profile calls itself (at most `size` characters with the zero at its end) into `name`, and returns its
/// colours: none if it is no profile, or for others.
using ImageModuleColoursNameFunction = ImageModuleSpace (*)(const void *profile, std::size_t profileSize, wchar_t *name,
                                                            std::size_t size);
/// Prepares a conversion, which is closed in the end; null, with a message, if a profile cannot be used so.
using ImageModuleColoursOpenFunction = void *(*)(ImageModuleColours *colours, char *error, std::size_t size);
/// Converts pixels of four floats in place; the fourth one, alpha, stays. Several threads may do so at once.
using ImageModuleColoursApplyFunction = void (*)(void *conversion, float *rgba, std::size_t pixels);
using ImageModuleColoursCloseFunction = void (*)(void *conversion);

} // namespace suffuse
