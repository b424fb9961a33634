#pragma once

#include "render/image_io/module/entry.h"

#include <OpenImageIO/filesystem.h>

namespace suffuse {

/// OpenImageIO's view of the file that the program writes. It remembers a failed transfer, which some of its writers do
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

} // namespace suffuse
