#include "render/image_io/file_replacement.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QRandomGenerator>

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace suffuse {

FileReplacement::FileReplacement(const QString &target) : m_shown(target) {}

FileReplacement::~FileReplacement()
{
    discard();
}

void FileReplacement::discard()
{
    if (m_file >= 0)
        ::close(m_file);
    m_file = -1;
    if (!m_temporary.isEmpty())
        ::unlink(m_temporary.constData());
    m_temporary.clear();
}

QString FileReplacement::reason(const QString &shown, int code)
{
    switch (code) {
    case EACCES:
    case EPERM:
    case EROFS:
        return QCoreApplication::translate("FileReplacement", "%1: cannot be written (%2). Choose another folder, or "
                                                              "change its permissions.")
            .arg(shown, QString::fromLocal8Bit(std::strerror(code)));
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
        return QCoreApplication::translate("FileReplacement", "%1: the disk is full (%2). Free some space, or choose "
                                                              "another disk.")
            .arg(shown, QString::fromLocal8Bit(std::strerror(code)));
    default:
        return QCoreApplication::translate("FileReplacement", "%1: writing failed (%2). Choose another place.")
            .arg(shown, QString::fromLocal8Bit(std::strerror(code)));
    }
}

Result<void> FileReplacement::open()
{
    QFileInfo info(m_shown);
    for (int links = 0; info.isSymLink() && links < 40; ++links)
        info.setFile(info.symLinkTarget());
    if (info.isDir())
        return Error{QCoreApplication::translate("FileReplacement", "%1: is a folder. Give a file name.").arg(m_shown)};
    if (info.exists() && !info.isFile())
        return Error{QCoreApplication::translate("FileReplacement", "%1: is not a plain file. Choose another name.")
                         .arg(m_shown)};
    const QString folder = info.absolutePath();
    if (!QFileInfo(folder).isDir())
        return Error{QCoreApplication::translate("FileReplacement", "%1: the folder %2 does not exist. Create it, or "
                                                                    "choose another.")
                         .arg(m_shown, folder)};
    m_target = QFile::encodeName(info.absoluteFilePath());
    m_folder = QFile::encodeName(folder);
    if (info.exists() && ::access(m_target.constData(), W_OK) != 0)
        return Error{reason(errno)};
    for (int attempt = 0; attempt < 100 && m_file < 0; ++attempt) {
        m_temporary =
            m_folder + "/.suffuse-" + QByteArray::number(QRandomGenerator::system()->generate64(), 16) + ".tmp";
        m_file = ::open(m_temporary.constData(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (m_file < 0 && errno != EEXIST)
            break;
    }
    if (m_file < 0) {
        const int code = errno;
        m_temporary.clear();
        return Error{reason(code)};
    }
    struct stat old;
    if (info.exists() && ::stat(m_target.constData(), &old) == 0)
        (void)!::fchmod(m_file, old.st_mode & 07777);
    return {};
}

std::size_t FileReplacement::write(const void *from, std::size_t bytes, std::int64_t offset)
{
    std::size_t done = 0;
    while (done < bytes && !m_error) {
        const ssize_t n =
            ::pwrite(m_file, static_cast<const char *>(from) + done, bytes - done, offset + std::int64_t(done));
        if (n > 0)
            done += std::size_t(n);
        else if (n == 0)
            m_error = ENOSPC;
        else if (errno != EINTR)
            m_error = errno;
    }
    return done;
}

std::size_t FileReplacement::read(void *to, std::size_t bytes, std::int64_t offset) const
{
    std::size_t done = 0;
    while (done < bytes) {
        const ssize_t n = ::pread(m_file, static_cast<char *>(to) + done, bytes - done, offset + std::int64_t(done));
        if (n > 0)
            done += std::size_t(n);
        else if (n == 0 || errno != EINTR)
            break;
    }
    return done;
}

std::int64_t FileReplacement::size() const
{
    struct stat s;
    return ::fstat(m_file, &s) == 0 ? std::int64_t(s.st_size) : 0;
}

QString FileReplacement::problem() const
{
    return m_error ? reason(m_error) : QString();
}

Result<void> FileReplacement::commit(bool toDisk)
{
    if (!m_error && toDisk && ::fsync(m_file) != 0)
        m_error = errno;
    const int file = m_file;
    m_file = -1;
    if (::close(file) != 0 && !m_error)
        m_error = errno;
    if (!m_error && ::rename(m_temporary.constData(), m_target.constData()) != 0)
        m_error = errno;
    if (m_error) {
        const QString message = problem();
        discard();
        return Error{message};
    }
    m_temporary.clear();
    if (!toDisk)
        return {};
    // The new name is durable once the folder is synced. A folder that cannot be opened or synced is no reason to fail
    // now.
    const int folder = ::open(m_folder.constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder >= 0) {
        ::fsync(folder);
        ::close(folder);
    }
    return {};
}

} // namespace suffuse
