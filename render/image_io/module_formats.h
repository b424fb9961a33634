// What the module of the common formats is made of.
#pragma once

#include "render/image_io/module_entry.h"

#include <cstdint>
#include <string>

namespace suffuse {

/// An sRGB ICC profile (version 4, parametric curves), always the same bytes.
const std::string &srgbProfile();

/// Appends the number, the highest byte first, as PNG has it.
inline void put32(std::string &out, std::uint32_t v)
{
    for (int shift = 24; shift >= 0; shift -= 8)
        out.push_back(char(v >> shift));
}

/// The value as a whole number from 0 to `most`, rounded to nearest; what is no colour as the nearest one.
template <typename Number>
Number toWhole(float v, float most)
{
    return Number(most * (v > 0 ? std::min(v, 1.0f) : 0.0f) + 0.5f);
}

/// Packs bytes, at least one, as a zlib stream, quickly: `to` has room for `packedRunsBound(size)`. Returns the size.
std::size_t packRuns(const unsigned char *from, std::size_t size, unsigned char *to);
std::size_t packedRunsBound(std::size_t size);

/// Each returns false, with a message, where it fails.
bool writePng(const ImageModuleWrite &job, char *error, std::size_t size);
bool writeTiff(const ImageModuleWrite &job, char *error, std::size_t size);
bool writeJpeg(const ImageModuleWrite &job, char *error, std::size_t size);
bool writeWebP(const ImageModuleWrite &job, char *error, std::size_t size);
bool readWebP(const ImageModuleRead &job, char *error, std::size_t size);

} // namespace suffuse
