// Writes TIFF by libtiff, in strips that are packed as they come.
#include "render/image_io/module/formats.h"

#define IMATH_HALF_NO_LOOKUP_TABLE // it is for the way back, and a library of its own
#include <Imath/half.h>
#include <tiffio.h>

#include <cstdio>
#include <memory>
#include <vector>

namespace suffuse {

namespace {

/// offsets have 32 bits, and packed rows may grow a little
constexpr std::int64_t mostClassicBytes = std::int64_t(3) << 30;
constexpr std::size_t stripBytes = 1 << 18;

/// libtiff's view of the file, and the first thing that went wrong.
struct TiffFile {
    const ImageModuleFile &file;
    std::int64_t at = 0;
    bool whole = true;
    std::string problem;

    static TiffFile &of(thandle_t handle) { return *static_cast<TiffFile *>(handle); }
    static tmsize_t read(thandle_t handle, void *to, tmsize_t bytes)
    {
        TiffFile &f = of(handle);
        const std::size_t n = f.file.read(f.file.context, to, std::size_t(bytes), f.at);
        f.at += std::int64_t(n);
        return tmsize_t(n);
    }
    static tmsize_t write(thandle_t handle, void *from, tmsize_t bytes)
    {
        TiffFile &f = of(handle);
        const std::size_t n = f.file.write(f.file.context, from, std::size_t(bytes), f.at);
        f.whole = f.whole && n == std::size_t(bytes);
        f.at += std::int64_t(n);
        return tmsize_t(n);
    }
    static toff_t seek(thandle_t handle, toff_t offset, int from)
    {
        TiffFile &f = of(handle);
        f.at = (from == SEEK_SET ? 0 : from == SEEK_CUR ? f.at : f.file.size(f.file.context)) + std::int64_t(offset);
        return toff_t(f.at);
    }
    static int close(thandle_t) { return 0; }
    static toff_t size(thandle_t handle) { return toff_t(of(handle).file.size(of(handle).file.context)); }
    static int fail(TIFF *, void *to, const char *, const char *format, va_list arguments)
    {
        char text[256];
        std::vsnprintf(text, sizeof text, format, arguments);
        auto &problem = static_cast<TiffFile *>(to)->problem;
        if (problem.empty())
            problem = text;
        return 1; // The message is ours.
    }
};

int bitsOf(int depth)
{
    return depth == ModuleBits8 ? 8 : depth == ModuleFloat ? 32 : 16;
}

std::size_t rowBytes(const ImageModuleWrite &job)
{
    return std::size_t(job.width) * std::size_t(job.channels) * std::size_t(bitsOf(job.depth) / 8);
}

using Tiff = std::unique_ptr<TIFF, void (*)(TIFF *)>;

Tiff open(TiffFile &file, bool big)
{
    const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions *)> options(TIFFOpenOptionsAlloc(),
                                                                                TIFFOpenOptionsFree);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), TiffFile::fail, &file);
    return Tiff(TIFFClientOpenExt("picture.tiff", big ? "w8" : "w", &file, TiffFile::read, TiffFile::write,
                                  TiffFile::seek, TiffFile::close, TiffFile::size, nullptr, nullptr, options.get()),
                TIFFClose);
}

void describe(TIFF *tiff, const ImageModuleWrite &job, std::uint32_t stripRows)
{
    const bool whole = job.depth == ModuleBits8 || job.depth == ModuleBits16;
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, std::uint32_t(job.width));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, std::uint32_t(job.height));
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, job.channels);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bitsOf(job.depth));
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, whole ? SAMPLEFORMAT_UINT : SAMPLEFORMAT_IEEEFP);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, stripRows);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
    TIFFSetField(tiff, TIFFTAG_PREDICTOR, whole ? PREDICTOR_HORIZONTAL : PREDICTOR_FLOATINGPOINT);
    // Half of the bytes of deeper pictures are noise, which a longer search does not make smaller.
    TIFFSetField(tiff, TIFFTAG_ZIPQUALITY, job.depth == ModuleBits8 ? 4 : 1);
    TIFFSetField(tiff, TIFFTAG_SOFTWARE, "Suffuse " SUFFUSE_VERSION);
    if (job.channels == 4) {
        const std::uint16_t alpha[] = {EXTRASAMPLE_UNASSALPHA};
        TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, alpha);
    }
    if (job.dpi > 0) {
        TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
        TIFFSetField(tiff, TIFFTAG_XRESOLUTION, job.dpi);
        TIFFSetField(tiff, TIFFTAG_YRESOLUTION, job.dpi);
    }
    const std::string_view profile = profileOf(job);
    TIFFSetField(tiff, TIFFTAG_ICCPROFILE, std::uint32_t(profile.size()), profile.data());
}

template <typename Value, typename Convert>
void convertRow(const float *from, std::size_t count, unsigned char *to, const Convert &convert)
{
    auto *values = reinterpret_cast<Value *>(to);
    std::transform(from, from + count, values, convert);
}

void putRow(const ImageModuleWrite &job, const float *from, unsigned char *to)
{
    const std::size_t count = std::size_t(job.width) * std::size_t(job.channels);
    switch (job.depth) {
    case ModuleBits8:
        convertRow<std::uint8_t>(from, count, to, [](float v) { return toWhole<std::uint8_t>(v, 255); });
        break;
    case ModuleBits16:
        convertRow<std::uint16_t>(from, count, to, [](float v) { return toWhole<std::uint16_t>(v, 65535); });
        break;
    case ModuleHalf:
        convertRow<std::uint16_t>(from, count, to, [](float v) { return imath_float_to_half(v); });
        break;
    default:
        std::memcpy(to, from, count * sizeof(float));
    }
}

} // namespace

bool writeTiff(const ImageModuleWrite &job, char *error, std::size_t size)
{
    TiffFile file{job.file, 0, true, {}};
    const auto failed = [&] {
        return fail(error, size, file.whole ? file.problem : std::string("the file could not be written"));
    };
    const std::size_t stride = rowBytes(job);
    const auto stripRows = std::uint32_t(std::clamp<std::size_t>(stripBytes / stride, 1, std::size_t(job.height)));
    Tiff tiff = open(file, std::int64_t(stride) * job.height > mostClassicBytes);
    if (!tiff)
        return failed();
    describe(tiff.get(), job, stripRows);
    std::vector<unsigned char> strip(stride * stripRows); // operator new aligns it for every depth
    for (int y = 0; y < job.height; y += int(stripRows)) {
        const int rows = std::min(int(stripRows), job.height - y);
        for (int i = 0; i < rows; ++i) {
            const float *row = job.row(job.context, y + i);
            if (!row)
                return fail(error, size, "stopped");
            putRow(job, row, strip.data() + std::size_t(i) * stride);
        }
        if (TIFFWriteEncodedStrip(tiff.get(), std::uint32_t(y) / stripRows, strip.data(),
                                  tmsize_t(stride * std::size_t(rows))) < 0 ||
            !file.whole)
            return failed();
    }
    if (!TIFFWriteDirectory(tiff.get()))
        return failed();
    tiff.reset(); // This writes what is left.
    return file.whole && file.problem.empty() ? true : failed();
}

} // namespace suffuse
