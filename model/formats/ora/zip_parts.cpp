#include "model/formats/ora/zip_parts.h"

#include <minizip/unzip.h>

#include <algorithm>
#include <cstring>

namespace suffuse {

/// The bytes as minizip sees them.
struct ZipParts::Memory {
    QByteArray bytes;
    std::int64_t at = 0;

    static Memory &of(void *memory) { return *static_cast<Memory *>(memory); }
    static unzFile open(Memory &memory)
    {
        zlib_filefunc64_def calls{};
        calls.opaque = &memory;
        calls.zopen64_file = [](void *m, const void *, int) { return m; };
        calls.zread_file = [](void *m, void *, void *to, uLong bytes) {
            Memory &from = of(m);
            const std::int64_t left = std::max<std::int64_t>(0, from.bytes.size() - from.at);
            const auto there = std::size_t(std::min(std::int64_t(bytes), left));
            if (there > 0)
                std::memcpy(to, from.bytes.constData() + from.at, there);
            from.at += std::int64_t(there);
            return uLong(there);
        };
        calls.zwrite_file = [](void *, void *, const void *, uLong) { return uLong(0); };
        calls.ztell64_file = [](void *m, void *) { return ZPOS64_T(of(m).at); };
        calls.zseek64_file = [](void *m, void *, ZPOS64_T offset, int origin) {
            Memory &from = of(m);
            const std::int64_t base = origin == ZLIB_FILEFUNC_SEEK_CUR   ? from.at
                                      : origin == ZLIB_FILEFUNC_SEEK_END ? std::int64_t(from.bytes.size())
                                                                         : 0;
            if (offset > ZPOS64_T(from.bytes.size()) || base + std::int64_t(offset) > from.bytes.size())
                return -1L;
            from.at = base + std::int64_t(offset);
            return 0L;
        };
        calls.zclose_file = [](void *, void *) { return 0; };
        calls.zerror_file = [](void *, void *) { return 0; };
        return unzOpen2_64("", &calls);
    }
};

ZipParts::ZipParts(QByteArray bytes) : m_memory(std::make_unique<Memory>(Memory{std::move(bytes)}))
{
    m_zip = Memory::open(*m_memory);
}

ZipParts::~ZipParts()
{
    if (m_zip)
        unzClose(m_zip);
}

bool ZipParts::isOpen() const
{
    return m_zip != nullptr;
}

std::optional<QByteArray> ZipParts::part(const QString &name, qint64 most) const
{
    constexpr int exactCase = 1;
    unz_file_info64 info{};
    if (!m_zip || unzLocateFile(m_zip, name.toUtf8().constData(), exactCase) != UNZ_OK ||
        unzGetCurrentFileInfo64(m_zip, &info, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK ||
        info.uncompressed_size > ZPOS64_T(most) || unzOpenCurrentFile(m_zip) != UNZ_OK)
        return {};
    // The size is what the file says: memory is taken as it fills.
    QByteArray out;
    constexpr qsizetype atOnce = qsizetype(1) << 20;
    int taken = 1;
    while (taken > 0 && out.size() <= qsizetype(most)) {
        const qsizetype before = out.size();
        out.resize(before + atOnce);
        taken = unzReadCurrentFile(m_zip, out.data() + before, unsigned(atOnce));
        out.resize(before + std::max(taken, 0));
    }
    const bool whole = unzCloseCurrentFile(m_zip) == UNZ_OK && taken == 0;
    return whole ? std::optional(out) : std::nullopt;
}

} // namespace suffuse
