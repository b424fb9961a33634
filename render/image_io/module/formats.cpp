// The module of the common formats. What it links is small, so that a picture is written without a wait.
#include "render/image_io/module/formats.h"

namespace suffuse {

namespace {

bool writeRows(const ImageModuleWrite &job, char *error, std::size_t size)
{
    const std::string format = job.format;
    if (format == "png")
        return writePng(job, error, size);
    if (format == "tiff")
        return writeTiff(job, error, size);
    if (format == "jpeg")
        return writeJpeg(job, error, size);
    if (format == "webp")
        return writeWebP(job, error, size);
    return fail(error, size, "this module does not write " + format);
}

bool readRows(const ImageModuleRead &job, char *error, std::size_t size)
{
    return std::string(job.format) == "webp" ? readWebP(job, error, size)
                                             : fail(error, size, "this module does not read it");
}

} // namespace

} // namespace suffuse

SUFFUSE_IMAGE_MODULE(suffuse::writeRows, suffuse::readRows)
