// The parts of the module of the common formats.
#pragma once

#include "render/image_io/module/entry.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace suffuse {

/// An ICC profile of sRGB (version 4, parametric curves), which always has the same bytes.
const std::string &srgbProfile();

/// The profile of the colours of a picture that is written.
inline std::string_view profileOf(const ImageModuleWrite &job)
{
    return job.profile ? std::string_view(static_cast<const char *>(job.profile), job.profileSize)
                       : std::string_view(srgbProfile());
}

/// Appends a number with the highest byte first, as in PNG.
inline void put32(std::string &out, std::uint32_t v)
{
    for (int shift = 24; shift >= 0; shift -= 8)
        out.push_back(char(v >> shift));
}

/// The value as a whole number from 0 to `most`, rounded to nearest. What is no colour becomes the nearest one.
template <typename Number>
Number toWhole(float v, float most)
{
    return Number(most * (v > 0 ? std::min(v, 1.0f) : 0.0f) + 0.5f);
}

/// Packs bytes, at least one, as a zlib stream, quickly. `to` must have room for `packedRunsBound(size)`. Returns the
/// size.
std::size_t packRuns(const unsigned char *from, std::size_t size, unsigned char *to);
std::size_t packedRunsBound(std::size_t size);

/// These return false, with a message, if they fail.
bool writePng(const ImageModuleWrite &job, char *error, std::size_t size);
bool writeTiff(const ImageModuleWrite &job, char *error, std::size_t size);
bool writeJpeg(const ImageModuleWrite &job, char *error, std::size_t size);
bool writeWebP(const ImageModuleWrite &job, char *error, std::size_t size);
bool writeJpegTile(const ImageModuleTile &tile, char *error, std::size_t size);
bool readWebP(const ImageModuleRead &job, char *error, std::size_t size);

} // namespace suffuse
