// Writes JPEG by libjpeg.
#include "render/image_io/module/formats.h"

#include <cstdio> // jpeglib.h needs it

#include <jpeglib.h>

#include <bit>
#include <cmath>
#include <csetjmp>
#include <vector>

namespace suffuse {

namespace {

constexpr int leastQualityOfFullColour = 90; ///< Below this quality colour is stored at half the resolution.

/// Where the bytes go, and where libjpeg jumps to when something goes wrong.
struct JpegFile {
    jpeg_destination_mgr destination{};
    jpeg_error_mgr errors{};
    const ImageModuleFile *file = nullptr;
    std::int64_t at = 0;
    bool whole = true;
    unsigned char bytes[1 << 16];
    char message[JMSG_LENGTH_MAX] = "";
    std::jmp_buf escape;

    static JpegFile &of(j_common_ptr jpeg) { return *static_cast<JpegFile *>(jpeg->client_data); }
    void put(std::size_t count)
    {
        whole = whole && file->write(file->context, bytes, count, at) == count;
        at += std::int64_t(count);
        destination.next_output_byte = bytes;
        destination.free_in_buffer = sizeof bytes;
    }
    void connect(jpeg_compress_struct &jpeg)
    {
        jpeg.dest = &destination;
        destination.init_destination = [](j_compress_ptr j) { of(j_common_ptr(j)).put(0); };
        destination.empty_output_buffer = [](j_compress_ptr j) -> boolean {
            of(j_common_ptr(j)).put(sizeof bytes);
            return TRUE;
        };
        destination.term_destination = [](j_compress_ptr j) {
            JpegFile &f = of(j_common_ptr(j));
            f.put(sizeof f.bytes - f.destination.free_in_buffer);
        };
    }
};

/// `argb`: pixels come as 0xAARRGGBB instead of red, green and blue.
void describe(jpeg_compress_struct &jpeg, const ImageModuleWrite &job, bool argb = false)
{
    static_assert(std::endian::native == std::endian::little, "else they are JCS_EXT_XRGB");
    jpeg.image_width = JDIMENSION(job.width);
    jpeg.image_height = JDIMENSION(job.height);
    jpeg.input_components = argb ? 4 : 3;
    jpeg.in_color_space = argb ? JCS_EXT_BGRX : JCS_RGB;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, job.quality, TRUE);
    if (job.quality >= leastQualityOfFullColour)
        jpeg.comp_info[0].h_samp_factor = jpeg.comp_info[0].v_samp_factor = 1;
    if (job.dpi > 0) {
        constexpr int dotsPerInch = 1;
        jpeg.density_unit = dotsPerInch;
        jpeg.X_density = jpeg.Y_density = UINT16(std::lround(job.dpi));
    }
}

/// Compresses the picture. If it returns false, libjpeg has given up, and `file` says why. Nothing in here has a
/// destructor, which libjpeg's jump would skip. The pixels are those of the job's rows, for which `row` has room, or of
/// the tile.
bool compress(jpeg_compress_struct &jpeg, JpegFile &file, const ImageModuleWrite &job, unsigned char *row,
              const ImageModuleTile *tile)
{
    if (setjmp(file.escape))
        return false;
    jpeg_create_compress(&jpeg);
    file.connect(jpeg);
    describe(jpeg, job, tile != nullptr);
    jpeg_start_compress(&jpeg, TRUE);
    constexpr char software[] = "Suffuse " SUFFUSE_VERSION;
    jpeg_write_marker(&jpeg, JPEG_COM, reinterpret_cast<const JOCTET *>(software), sizeof software - 1);
    const std::string_view profile = profileOf(job);
    jpeg_write_icc_profile(&jpeg, reinterpret_cast<const JOCTET *>(profile.data()), unsigned(profile.size()));
    for (int y = 0; y < job.height && file.whole && !row; ++y) {
        JSAMPROW pixels =
            reinterpret_cast<JSAMPROW>(const_cast<std::uint32_t *>(tile->argb + std::size_t(y) * tile->stride));
        jpeg_write_scanlines(&jpeg, &pixels, 1);
    }
    for (int y = 0; y < job.height && file.whole && row; ++y) {
        const float *from = job.row(job.context, y);
        if (!from) {
            std::strcpy(file.message, "stopped");
            return false;
        }
        for (int i = 0; i < 3 * job.width; ++i)
            row[i] = toWhole<unsigned char>(from[i], 255);
        jpeg_write_scanlines(&jpeg, &row, 1);
    }
    if (file.whole)
        jpeg_finish_compress(&jpeg);
    return file.whole;
}

bool write(const ImageModuleWrite &job, unsigned char *row, const ImageModuleTile *tile, char *error, std::size_t size)
{
    jpeg_compress_struct jpeg{};
    JpegFile file;
    file.file = &job.file;
    jpeg.err = jpeg_std_error(&file.errors);
    jpeg.client_data = &file;
    file.errors.output_message = [](j_common_ptr) {};
    file.errors.error_exit = [](j_common_ptr j) {
        (*j->err->format_message)(j, JpegFile::of(j).message);
        std::longjmp(JpegFile::of(j).escape, 1);
    };
    const bool done = compress(jpeg, file, job, row, tile);
    jpeg_destroy_compress(&jpeg);
    if (done)
        return true;
    return fail(error, size, file.whole ? file.message : "the file could not be written");
}

} // namespace

bool writeJpeg(const ImageModuleWrite &job, char *error, std::size_t size)
{
    if (job.channels != 3)
        return fail(error, size, "JPEG holds no transparency");
    std::vector<unsigned char> row(3 * std::size_t(job.width));
    return write(job, row.data(), nullptr, error, size);
}

bool writeJpegTile(const ImageModuleTile &tile, char *error, std::size_t size)
{
    ImageModuleWrite job{};
    job.file = tile.file;
    job.width = tile.width;
    job.height = tile.height;
    job.channels = 3;
    job.quality = tile.quality;
    job.profile = tile.profile;
    job.profileSize = tile.profileSize;
    return write(job, nullptr, &tile, error, size);
}

} // namespace suffuse
