#pragma once

#include "render/image_io/module_api.h"

#include <OpenImageIO/filesystem.h>

#include <string>

namespace suffuse {

/// OpenImageIO's view of the file that the program writes. Remembers a failed transfer, which some of its writers do
/// not report.
class ModuleProxy : public OIIO::Filesystem::IOProxy {
public:
    explicit ModuleProxy(const ImageModuleFile &file) : IOProxy("", Write), m_file(file) {}

    const char *proxytype() const override { return "suffuse"; }
    void close() override { m_mode = Closed; }
    std::size_t read(void *to, std::size_t bytes) override
    {
        const std::size_t n = pread(to, bytes, m_pos);
        m_pos += std::int64_t(n);
        return n;
    }
    std::size_t write(const void *from, std::size_t bytes) override
    {
        const std::size_t n = pwrite(from, bytes, m_pos);
        m_pos += std::int64_t(n);
        return n;
    }
    std::size_t pread(void *to, std::size_t bytes, std::int64_t offset) override
    {
        return m_file.read(m_file.context, to, bytes, offset);
    }
    std::size_t pwrite(const void *from, std::size_t bytes, std::int64_t offset) override
    {
        const std::size_t n = m_file.write(m_file.context, from, bytes, offset);
        m_failed = m_failed || n != bytes;
        return n;
    }
    std::size_t size() const override { return std::size_t(m_file.size(m_file.context)); }
    bool failed() const { return m_failed; }

private:
    ImageModuleFile m_file;
    bool m_failed = false;
};

/// An sRGB ICC profile (version 4, parametric curves), written by us: `srgbProfile(size)` points at static bytes.
const unsigned char *srgbProfile(std::size_t &size);

/// Puts the message into `error` (cut to `size` bytes) and returns false.
bool fail(char *error, std::size_t size, const std::string &message);

/// Appends the number, the highest byte first, as PNG and ICC profiles have it.
inline void put32(std::string &out, std::uint32_t v)
{
    for (int shift = 24; shift >= 0; shift -= 8)
        out.push_back(char(v >> shift));
}

/// PNG of 8 bits, made as a whole: pictures of up to 256 MB of pixels.
bool fitsWritePng(const ImageModuleWrite &job);
bool writePng(const ImageModuleWrite &job, char *error, std::size_t size);

/// Packs bytes, at least one, as a zlib stream, quickly: `to` has room for `packedRunsBound(size)`. Returns the size.
std::size_t packRuns(const unsigned char *from, std::size_t size, unsigned char *to);
std::size_t packedRunsBound(std::size_t size);

/// WebP goes to libwebp itself: OpenImageIO 2.4 stores straight colours wrong (it divides them by alpha again) and its
/// lossless mode is not.
bool writeWebP(const ImageModuleWrite &job, char *error, std::size_t size);
bool readWebP(const ImageModuleRead &job, char *error, std::size_t size);

} // namespace suffuse
