#include "model/formats/atomic_save.h"
#include "model/formats/files.h"
#include "model/formats/messages.h"

#include <QDir>
#include <QFileInfo>
#include <QSaveFile>

#ifdef Q_OS_UNIX
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace suffuse {

namespace {

/// Syncs a folder, without which a new name does not survive a power failure. Returns an empty text, or why it failed.
QString syncFolder(const QString &folder)
{
#ifdef Q_OS_UNIX
    const int fd = ::open(QFile::encodeName(folder).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd < 0)
        // A user may be allowed to write to the folder, but not to list it.
        return errno == EACCES ? QString() : QString::fromLocal8Bit(std::strerror(errno));
    const int result = ::fsync(fd);
    const int problem = errno;
    ::close(fd);
    // Some network and FUSE file systems have no such call for folders.
    if (result != 0 && problem != EINVAL && problem != ENOTSUP && problem != ENOSYS)
        return QString::fromLocal8Bit(std::strerror(problem));
#else
    Q_UNUSED(folder)
#endif
    return {};
}

/// Brings what was written to the disk. QSaveFile tries this, too, but does not tell whether it worked.
bool syncFile(QSaveFile &file)
{
#ifdef Q_OS_UNIX
    return ::fsync(file.handle()) == 0 || errno == EINVAL || errno == ENOTSUP;
#else
    Q_UNUSED(file)
    return true;
#endif
}

/// Gives the new file the owner of the old one. Returns false where that is not possible: saving would take the file
/// away from its owner.
bool keepOwner(QSaveFile &file, const QString &path)
{
#ifdef Q_OS_UNIX
    struct stat old {
    }, made{};
    if (::stat(QFile::encodeName(path).constData(), &old) != 0 || ::fstat(file.handle(), &made) != 0)
        return true;
    if (old.st_gid != made.st_gid && ::fchown(file.handle(), uid_t(-1), old.st_gid) != 0)
        old.st_gid = made.st_gid; // The user is not in that group. The owner matters more.
    return old.st_uid == made.st_uid || ::fchown(file.handle(), old.st_uid, old.st_gid) == 0;
#else
    Q_UNUSED(file)
    Q_UNUSED(path)
    return true;
#endif
}

/// Why `path` cannot be replaced, with the remedy. Empty if the attempt may be made.
QString obstacle(const QString &path)
{
    const QFileInfo info(path);
    if (info.isDir())
        return FileMessages::tr("is a folder; give a file name inside it");
    if (info.exists() && !info.isFile())
        return FileMessages::tr("is a device or a pipe, not a file; save to a file");
    const QFileInfo folder(info.absolutePath());
    if (info.exists() && !info.isWritable())
        return FileMessages::tr("is write-protected; save under another name or change its permissions");
    if (info.isSymLink())
        return {};
    if (!folder.exists())
        return FileMessages::tr("the folder %1 does not exist; create it or choose another one")
            .arg(QDir::toNativeSeparators(folder.filePath()));
    if (!folder.isDir())
        return FileMessages::tr("%1 is not a folder; choose another place")
            .arg(QDir::toNativeSeparators(folder.filePath()));
    if (!folder.isWritable())
        return FileMessages::tr("the folder %1 is read-only; choose another one or change its permissions")
            .arg(QDir::toNativeSeparators(folder.filePath()));
    return {};
}

} // namespace

Result<void> writeFileAtomically(const QString &path, const QByteArray &bytes)
{
    if (path.isEmpty())
        return Error{FileMessages::tr("The file has no name; choose one")};
    if (bytes.size() > largestFile)
        return fileError(path, FileMessages::tr("would have more than 2 GB; nothing was written"));
    if (const QString problem = obstacle(path); !problem.isEmpty())
        return fileError(path, problem);
    QSaveFile file(path);
    const auto failed = [&](const QString &what) {
        const QString why = file.error() == QFileDevice::NoError ? qt_error_string() : file.errorString();
        file.cancelWriting();
        return fileError(path,
                         FileMessages::tr("%1 (%2); the old file, if there was one, is as before. Free some space or "
                                          "choose another place")
                             .arg(what, why));
    };
    if (!file.open(QIODevice::WriteOnly))
        return fileError(path, FileMessages::tr("cannot be written (%1); choose another place").arg(file.errorString()));
    if (!keepOwner(file, path)) {
        file.cancelWriting();
        return fileError(path, FileMessages::tr("belongs to %1, and would not any more; save under another name")
                                   .arg(QFileInfo(path).owner()));
    }
    // QSaveFile forgets a short write when it commits, so the result of every step is checked.
    qint64 written = 0;
    while (written < bytes.size()) {
        const qint64 part = file.write(bytes.constData() + written, bytes.size() - written);
        if (part <= 0)
            return failed(FileMessages::tr("could not be written in full"));
        written += part;
    }
    if (!file.flush() || file.error() != QFileDevice::NoError || file.size() != bytes.size())
        return failed(FileMessages::tr("could not be written in full"));
    if (!syncFile(file))
        return failed(FileMessages::tr("could not be brought to the disk"));
    if (!file.commit())
        return failed(FileMessages::tr("could not be put in place"));
    const QFileInfo target(path);
    const QString folder = QFileInfo(target.canonicalFilePath()).absolutePath();
    if (const QString problem = syncFolder(folder); !problem.isEmpty())
        return fileError(
            path, FileMessages::tr("was written, but the folder could not be brought to the disk (%1); save once "
                                   "more before you switch off")
                      .arg(problem));
    return {};
}

} // namespace suffuse
