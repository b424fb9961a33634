#include "render/layered/zip_writer.h"

#include <QCoreApplication>

#include <minizip/zip.h>

#include <algorithm>

namespace suffuse {

/// The file as minizip sees it.
struct ZipWriter::Access {
    FileReplacement &file;
    std::int64_t at = 0;
    zipFile zip = nullptr;

    static Access &of(void *access) { return *static_cast<Access *>(access); }
};

ZipWriter::ZipWriter(FileReplacement &file) : m_access(new Access{file})
{
    zlib_filefunc64_def calls{};
    calls.opaque = m_access.get();
    calls.zopen64_file = [](void *access, const void *, int) { return access; };
    calls.zread_file = [](void *access, void *, void *to, uLong bytes) {
        Access &a = Access::of(access);
        const std::size_t there = a.file.read(to, bytes, a.at);
        a.at += std::int64_t(there);
        return uLong(there);
    };
    calls.zwrite_file = [](void *access, void *, const void *from, uLong bytes) {
        Access &a = Access::of(access);
        const std::size_t written = a.file.write(from, bytes, a.at);
        a.at += std::int64_t(written);
        return uLong(written);
    };
    calls.ztell64_file = [](void *access, void *) { return ZPOS64_T(Access::of(access).at); };
    calls.zseek64_file = [](void *access, void *, ZPOS64_T offset, int origin) {
        Access &a = Access::of(access);
        const std::int64_t from = origin == ZLIB_FILEFUNC_SEEK_CUR   ? a.at
                                  : origin == ZLIB_FILEFUNC_SEEK_END ? a.file.size()
                                                                     : 0;
        a.at = from + std::int64_t(offset);
        return 0L;
    };
    calls.zclose_file = [](void *, void *) { return 0; };
    calls.zerror_file = [](void *, void *) { return 0; };
    m_access->zip = zipOpen2_64("", APPEND_STATUS_CREATE, nullptr, &calls);
}

ZipWriter::~ZipWriter()
{
    if (m_access->zip)
        zipClose(m_access->zip, nullptr);
}

QString ZipWriter::problem() const
{
    const QString problem = m_access->file.problem();
    return problem.isEmpty() ? QCoreApplication::translate("LayeredFile", "The file could not be packed.") : problem;
}

Result<void> ZipWriter::add(const QString &name, const QByteArray &bytes, bool compress)
{
    zip_fileinfo info{};
    info.tmz_date = {0, 0, 0, 1, 0, 1980}; // The same painting makes the same bytes.
    constexpr int utf8Names = 1 << 11;
    const bool opened =
        m_access->zip &&
        zipOpenNewFileInZip4_64(m_access->zip, name.toUtf8().constData(), &info, nullptr, 0, nullptr, 0, nullptr,
                                compress ? Z_DEFLATED : 0, compress ? 6 : 0, 0, -MAX_WBITS, DEF_MEM_LEVEL,
                                Z_DEFAULT_STRATEGY, nullptr, 0, 0, utf8Names, bytes.size() >= 0xffffffff) == ZIP_OK;
    bool written = opened;
    constexpr qsizetype atOnce = qsizetype(1) << 26;
    for (qsizetype at = 0; at < bytes.size() && written; at += atOnce)
        written = zipWriteInFileInZip(m_access->zip, bytes.constData() + at,
                                      unsigned(std::min(atOnce, bytes.size() - at))) == ZIP_OK;
    if (opened)
        written = zipCloseFileInZip(m_access->zip) == ZIP_OK && written;
    return written ? Result<void>() : Error{problem()};
}

Result<void> ZipWriter::finish()
{
    const bool closed = m_access->zip && zipClose(std::exchange(m_access->zip, nullptr), nullptr) == ZIP_OK;
    return closed ? Result<void>() : Error{problem()};
}

} // namespace suffuse
