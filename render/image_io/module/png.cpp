// Writes PNG by libdeflate. libpng and zlib would take three times as long.
#include "render/image_io/module/formats.h"

#include <libdeflate.h>

#include <chrono>
#include <cmath>
#include <future>
#include <memory>
#include <new>
#include <thread>
#include <vector>

namespace suffuse {

namespace {

using Byte = unsigned char;

/// Half of the bytes of 16 bit colours are noise, which a longer search does not make smaller.
int levelFor(const ImageModuleWrite &job)
{
    return job.depth == ModuleBits16 ? 1 : 6;
}

constexpr char averageFilter =
    3; // on soft paint nearly as small as the best of all filters, row by row, and far quicker

std::size_t pixelBytes(const ImageModuleWrite &job)
{
    return std::size_t(job.channels) * (job.depth == ModuleBits16 ? 2 : 1);
}

std::size_t strideOf(const ImageModuleWrite &job)
{
    return std::size_t(job.width) * pixelBytes(job);
}

void putRow(const ImageModuleWrite &job, const float *from, Byte *to)
{
    const std::size_t count = std::size_t(job.width) * std::size_t(job.channels);
    if (job.depth == ModuleBits8) {
        std::transform(from, from + count, to, [](float v) { return toWhole<Byte>(v, 255); });
        return;
    }
    for (std::size_t i = 0; i < count; ++i) { // the high byte first
        const auto v = toWhole<std::uint16_t>(from[i], 65535);
        to[2 * i] = Byte(v >> 8);
        to[2 * i + 1] = Byte(v);
    }
}

/// Filters a row: each byte is what it adds to the mean of its left neighbour and the byte above, as PNG defines it.
void filterRow(const Byte *row, const Byte *above, std::size_t stride, std::size_t pixel, Byte *to)
{
    for (std::size_t i = 0; i < pixel; ++i)
        to[i] = Byte(row[i] - above[i] / 2);
    for (std::size_t i = pixel; i < stride; ++i)
        to[i] = Byte(row[i] - (row[i - pixel] + above[i]) / 2);
}

/// The rows of the picture, each behind the number of its filter; empty once the writing was stopped.
std::vector<Byte> filteredRows(const ImageModuleWrite &job)
{
    const std::size_t stride = strideOf(job);
    std::vector<Byte> rows((stride + 1) * std::size_t(job.height));
    std::vector<Byte> row(stride), above(stride);
    Byte *to = rows.data();
    for (int y = 0; y < job.height; ++y, to += stride) {
        const float *from = job.row(job.context, y);
        if (!from)
            return {};
        putRow(job, from, row.data());
        *to++ = averageFilter;
        filterRow(row.data(), above.data(), stride, pixelBytes(job), to);
        row.swap(above);
    }
    return rows;
}

/// A file that grows chunk by chunk.
class Chunks {
public:
    explicit Chunks(const ImageModuleFile &file) : m_file(file) {}

    bool isWhole() const { return m_whole; }
    void put(const void *bytes, std::size_t size)
    {
        m_whole = m_whole && m_file.write(m_file.context, bytes, size, m_at) == size;
        m_at += std::int64_t(size);
    }
    void chunk(const std::string &type, const void *content, std::size_t size)
    {
        std::string head, tail;
        put32(head, std::uint32_t(size));
        head += type;
        put32(tail, libdeflate_crc32(libdeflate_crc32(0, type.data(), type.size()), content, size));
        put(head.data(), head.size());
        put(content, size);
        put(tail.data(), tail.size());
    }
    void chunk(const std::string &type, const std::string &content) { chunk(type, content.data(), content.size()); }

private:
    const ImageModuleFile &m_file;
    std::int64_t m_at = 0;
    bool m_whole = true;
};

std::string numbers(std::initializer_list<std::uint32_t> values)
{
    std::string out;
    for (const std::uint32_t v : values)
        put32(out, v);
    return out;
}

/// Says what the values mean: by the profile, or that they are sRGB and, for readers that do not know that chunk, by
/// gamma and primaries. Returns false if there is not enough memory.
bool putColours(Chunks &out, const ImageModuleWrite &job)
{
    constexpr char absoluteColorimetric = 3;
    if (!job.profile) {
        out.chunk("gAMA", numbers({45455}));
        out.chunk("sRGB", {absoluteColorimetric});
        out.chunk("cHRM", numbers({31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000}));
        return true;
    }
    const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor *)> compressor(
        libdeflate_alloc_compressor(6), libdeflate_free_compressor);
    if (!compressor)
        return false;
    constexpr char name[] = "ICC profile\0"; // its name, a zero, and the number of zlib's packing
    std::string chunk(name, sizeof name);
    const std::size_t head = chunk.size();
    chunk.resize(head + libdeflate_zlib_compress_bound(compressor.get(), job.profileSize));
    chunk.resize(head + libdeflate_zlib_compress(compressor.get(), job.profile, job.profileSize, chunk.data() + head,
                                                 chunk.size() - head));
    out.chunk("iCCP", chunk);
    return true;
}

/// Writes what comes before the pixels. Returns false if there is not enough memory.
bool putHead(Chunks &out, const ImageModuleWrite &job)
{
    constexpr char rgb = 2, rgba = 6, metre = 1;
    const char layout[] = {char(job.depth == ModuleBits16 ? 16 : 8), job.channels == 4 ? rgba : rgb, 0, 0, 0};
    constexpr char software[] = "Software\0Suffuse " SUFFUSE_VERSION;
    out.put("\x89PNG\r\n\x1a\n", 8);
    out.chunk("IHDR", numbers({std::uint32_t(job.width), std::uint32_t(job.height)}) + std::string(layout, 5));
    if (!putColours(out, job))
        return false;
    if (job.dpi > 0) {
        const auto perMetre = std::uint32_t(std::lround(job.dpi / 0.0254));
        out.chunk("pHYs", numbers({perMetre, perMetre}) + metre);
    }
    out.chunk("tEXt", std::string(software, sizeof software - 1));
    return true;
}

/// Rows on their way into a zlib stream.
struct Packing {
    std::vector<Byte> rows;
    bool quick = false;
    int level = 0;
    std::unique_ptr<Byte[]> packed; ///< It need not be set to 0 first.
    std::size_t size = 0;           ///< 0: there is not enough memory

    void run()
    {
        if (quick) {
            packed.reset(new (std::nothrow) Byte[packedRunsBound(rows.size())]);
            size = packed ? packRuns(rows.data(), rows.size(), packed.get()) : 0;
            return;
        }
        const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor *)> compressor(
            libdeflate_alloc_compressor(level), libdeflate_free_compressor);
        const std::size_t most = compressor ? libdeflate_zlib_compress_bound(compressor.get(), rows.size()) : 0;
        packed.reset(most ? new (std::nothrow) Byte[most] : nullptr);
        size = packed ? libdeflate_zlib_compress(compressor.get(), rows.data(), rows.size(), packed.get(), most) : 0;
    }
};

/// Packs rows. Large pictures take seconds, and the libraries do not let themselves be stopped: so it is done on a
/// thread of its own, which is left to itself when nobody wants the picture any more. Null then.
std::shared_ptr<Packing> packedRows(std::vector<Byte> rows, const ImageModuleWrite &job)
{
    constexpr std::size_t large = std::size_t(8) << 20;
    constexpr std::chrono::milliseconds pause{10};
    const auto packing = std::make_shared<Packing>();
    packing->rows = std::move(rows);
    packing->quick = job.quick && job.depth == ModuleBits8;
    packing->level = levelFor(job);
    if (packing->rows.size() < large) {
        packing->run();
        return packing;
    }
    std::promise<void> done;
    const std::future<void> end = done.get_future();
    std::thread([packing, done = std::move(done)]() mutable {
        packing->run();
        done.set_value();
    }).detach();
    do { // Asks before it waits: whoever stops the writing in time is heard, however quick the packing is.
        if (job.stopped(job.context))
            return nullptr;
    } while (end.wait_for(pause) != std::future_status::ready);
    return packing;
}

} // namespace

bool writePng(const ImageModuleWrite &job, char *error, std::size_t size)
{
    std::vector<Byte> rows = filteredRows(job);
    const std::shared_ptr<Packing> packing = rows.empty() ? nullptr : packedRows(std::move(rows), job);
    if (!packing)
        return fail(error, size, "stopped");
    Chunks out(job.file);
    if (packing->size == 0 || !putHead(out, job))
        return fail(error, size, "there is not enough memory");
    out.chunk("IDAT", packing->packed.get(), packing->size);
    out.chunk("IEND", {});
    return out.isWhole() || fail(error, size, "the file could not be written");
}

} // namespace suffuse
