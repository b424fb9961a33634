// The module of the other formats, which is the only place that knows OpenImageIO.
#include "render/image_io/module/proxy.h"

#include <OpenImageIO/imageio.h>

#include <string>
#include <vector>

namespace suffuse {

namespace {

using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

TypeDesc typeOf(int depth)
{
    switch (depth) {
    case ModuleBits16:
        return TypeDesc::UINT16;
    case ModuleHalf:
        return TypeDesc::HALF;
    case ModuleFloat:
        return TypeDesc::FLOAT;
    default:
        return TypeDesc::UINT8;
    }
}

ImageSpec specOf(const ImageModuleWrite &job)
{
    ImageSpec spec(job.width, job.height, job.channels, typeOf(job.depth));
    const std::string format = job.format;
    spec.attribute("Software", "Suffuse " SUFFUSE_VERSION);
    spec.attribute("oiio:ColorSpace", job.linear ? "Linear" : "sRGB");
    if (job.channels == 4 && !job.associated)
        spec.attribute("oiio:UnassociatedAlpha", 1);
    if (format == "openexr")
        spec.attribute("compression", "zip");
    if (job.profile)
        spec.attribute("ICCProfile", TypeDesc(TypeDesc::UINT8, int(job.profileSize)), job.profile);
    if (job.dpi > 0) {
        spec.attribute("XResolution", float(job.dpi));
        spec.attribute("YResolution", float(job.dpi));
        spec.attribute("ResolutionUnit", "in");
    }
    return spec;
}

bool writeRows(const ImageModuleWrite &job, char *error, std::size_t size)
{
    ModuleProxy proxy(job.file); // It must outlive `out`, whose destructor may write.
    auto out = ImageOutput::create(job.format);
    if (!out)
        return fail(error, size, OIIO::geterror());
    if (!out->set_ioproxy(&proxy) || !out->open(std::string("picture.") + job.format, specOf(job)))
        return fail(error, size, out->geterror());
    for (int y = 0; y < job.height; ++y) {
        const float *row = job.row(job.context, y);
        if (!row)
            return fail(error, size, "stopped");
        if (!out->write_scanline(y, 0, TypeDesc::FLOAT, row))
            return fail(error, size, out->geterror());
        if (proxy.failed())
            return fail(error, size, "the file could not be written");
    }
    if (!out->close())
        return fail(error, size, out->geterror());
    return !proxy.failed() || fail(error, size, "the file could not be written");
}

/// Empty if what the file declares may be decoded.
std::string problemOf(const ImageSpec &spec, const ImageModuleRead &job)
{
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.deep)
        return "it is not a plain picture";
    if (spec.width > job.maxSide || spec.height > job.maxSide || std::int64_t(spec.width) * spec.height > job.maxPixels)
        return "it declares " + std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels";
    if (spec.nchannels < 1 || spec.nchannels > 16)
        return "it declares " + std::to_string(spec.nchannels) + " channels";
    if (spec.get_int_attribute("tiff:RowsPerStrip", 1) < 1) // The library divides by it.
        return "its strips have no rows";
    if (spec.tile_width > 0) { // A row of tiles is decoded at a time.
        const std::int64_t across =
            (spec.width + std::int64_t(spec.tile_width) - 1) / spec.tile_width * spec.tile_width;
        if (spec.tile_height < 1 || spec.tile_depth > 1 || across > 2 * std::int64_t(job.maxSide) ||
            across * spec.tile_height > job.maxPixels)
            return "its tiles are too large";
    }
    return {};
}

bool readRows(const ImageModuleRead &job, char *error, std::size_t size)
{
    OIIO::Filesystem::IOMemReader proxy(const_cast<void *>(job.bytes), job.size); // JPEG accepts only this kind.
    auto in = ImageInput::create(job.format);
    if (!in)
        return fail(error, size, OIIO::geterror());
    ImageSpec spec, wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);
    if (!in->set_ioproxy(&proxy) || !in->open(std::string("image.") + job.format, spec, wish))
        return fail(error, size, in->geterror());
    const std::string problem = problemOf(spec, job);
    if (!problem.empty())
        return fail(error, size, problem);

    const int channels = std::min(spec.nchannels, 4);
    const bool linear = std::string(job.format) == "openexr";
    const bool associated = linear || (spec.alpha_channel >= 0 && !spec.get_int_attribute("oiio:UnassociatedAlpha"));
    job.begin(job.context, spec.width, spec.height, channels, linear, associated);
    // A strip is read at a time, since some readers decode a whole row of tiles or a strip for each call.
    const int strip = spec.tile_height > 1 ? spec.tile_height : 16;
    std::vector<float> values(std::size_t(spec.width) * channels * std::min(strip, spec.height));
    for (int y = 0; y < spec.height; y += strip) {
        const int end = std::min(y + strip, spec.height);
        // For tiles some readers divide by the height of a strip, which is 0 then.
        const bool isRead =
            spec.tile_width > 0
                ? in->read_tiles(0, 0, spec.x, spec.x + spec.width, spec.y + y, spec.y + end, spec.z, spec.z + 1, 0,
                                 channels, TypeDesc::FLOAT, values.data())
                : in->read_scanlines(0, 0, spec.y + y, spec.y + end, 0, 0, channels, TypeDesc::FLOAT, values.data());
        if (!isRead)
            return fail(error, size, in->geterror());
        for (int row = y; row < end; ++row)
            job.row(job.context, row, values.data() + std::size_t(row - y) * spec.width * channels);
    }
    return true;
}

} // namespace

} // namespace suffuse

SUFFUSE_IMAGE_MODULE(suffuse::writeRows, suffuse::readRows)
