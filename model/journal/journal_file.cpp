#include "model/journal/journal_file.h"

#include "model/formats/messages.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace suffuse {

namespace {

Error systemError(const QString &path, int problem)
{
    return fileError(
        path,
        FileMessages::tr("the journal cannot be written (%1)").arg(QString::fromLocal8Bit(std::strerror(problem))));
}

/// Makes a new file, or its new name, survive a power cut. On file systems that cannot do it, nothing is done.
void syncFolderOf(const QString &path)
{
    const QByteArray folder = QFile::encodeName(QFileInfo(path).absolutePath());
    const int fd = ::open(folder.constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd < 0)
        return;
    ::fsync(fd);
    ::close(fd);
}

bool makePrivateFolder(const QString &folder)
{
    if (QFileInfo(folder).isDir())
        return true;
    return QDir().mkpath(folder) &&
           QFile::setPermissions(folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
}

} // namespace

Result<std::unique_ptr<JournalFile>> JournalFile::create(const QString &path)
{
    makePrivateFolder(QFileInfo(path).absolutePath()); // If this fails, so does what follows.
    const int fd = ::open(QFile::encodeName(path).constData(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (fd < 0)
        return systemError(path, errno);
    std::unique_ptr<JournalFile> file(new JournalFile(path, fd, 0));
    // The call waits for a program that looks at the file in this very moment.
    while (::flock(fd, LOCK_EX) != 0)
        if (errno != EINTR)
            return systemError(path, errno);
    syncFolderOf(path);
    return file;
}

std::unique_ptr<JournalFile> JournalFile::openAbandoned(const QString &path)
{
    const int fd = ::open(QFile::encodeName(path).constData(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0)
        return nullptr;
    std::unique_ptr<JournalFile> file(new JournalFile(path, fd, 0));
    struct stat info {
    }, named{};
    if (::fstat(fd, &info) != 0 || !S_ISREG(info.st_mode) || ::flock(fd, LOCK_EX | LOCK_NB) != 0)
        return nullptr;
    // Since it was opened, its owner may have removed the file or put another one in its place.
    if (::stat(QFile::encodeName(path).constData(), &named) != 0 || named.st_ino != info.st_ino)
        return nullptr;
    file->m_size = info.st_size;
    return file;
}

JournalFile::~JournalFile()
{
    ::close(m_file);
}

QByteArray JournalFile::readAll() const
{
    QByteArray bytes(std::min(m_size, largestFile), Qt::Uninitialized);
    qint64 got = 0;
    while (got < bytes.size()) {
        const ssize_t part = ::pread(m_file, bytes.data() + got, std::size_t(bytes.size() - got), got);
        if (part < 0 && errno == EINTR)
            continue;
        if (part <= 0)
            break;
        got += part;
    }
    bytes.truncate(got);
    return bytes;
}

Result<void> JournalFile::append(const QByteArray &bytes)
{
    const auto failed = [&] {
        const int problem = errno;
        // If this fails as well, the next record is written over what is left.
        const int cut = ::ftruncate(m_file, m_size);
        Q_UNUSED(cut)
        return systemError(m_path, problem);
    };
    qint64 put = 0;
    while (put < bytes.size()) {
        const ssize_t part = ::pwrite(m_file, bytes.constData() + put, std::size_t(bytes.size() - put), m_size + put);
        if (part < 0 && errno == EINTR)
            continue;
        if (part <= 0)
            return failed();
        put += part;
    }
    if (::fdatasync(m_file) != 0)
        return failed();
    m_size += bytes.size();
    return {};
}

Result<void> JournalFile::renameTo(const QString &path)
{
    if (::rename(QFile::encodeName(m_path).constData(), QFile::encodeName(path).constData()) != 0)
        return systemError(path, errno);
    m_path = path;
    syncFolderOf(path);
    return {};
}

void JournalFile::remove()
{
    ::unlink(QFile::encodeName(m_path).constData());
}

} // namespace suffuse
