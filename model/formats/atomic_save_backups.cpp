#include "model/formats/atomic_save.h"
#include "model/formats/messages.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>

#ifdef Q_OS_UNIX
#include <unistd.h>
#endif

namespace suffuse {

namespace {

/// Gives a file a second name, which costs nothing where the file system can do it: the file lives on under it when it
/// is replaced. Elsewhere the file is copied.
bool linkOrCopy(const QString &from, const QString &to)
{
#ifdef Q_OS_UNIX
    if (::link(QFile::encodeName(from).constData(), QFile::encodeName(to).constData()) == 0)
        return true;
#endif
    if (!QFile::copy(from, to))
        return false;
    QFile copy(to); // A backup has the time of what is in it.
    if (copy.open(QIODevice::ReadWrite))
        copy.setFileTime(QFileInfo(from).lastModified(), QFileDevice::FileModificationTime);
    return true;
}

bool haveSameBytes(const QString &a, const QString &b)
{
    return QFileInfo(a).size() == QFileInfo(b).size() && hashOfFile(a) && hashOfFile(a) == hashOfFile(b);
}

} // namespace

std::optional<QByteArray> hashOfFile(const QString &path)
{
    QFile file(path);
    // Opening a pipe would wait for a writer.
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly))
        return std::nullopt;
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (!hash.addData(&file))
        return std::nullopt;
    return hash.result();
}

QString backupName(const QString &path, int i)
{
    return path + QLatin1Char('~') + (i > 1 ? QString::number(i) : QString());
}

QString backedUpFile(const QString &path)
{
    static const QRegularExpression backup(QStringLiteral("^(.+)~([2-9]|[1-9][0-9])?$"),
                                           QRegularExpression::DotMatchesEverythingOption);
    const QRegularExpressionMatch match = backup.match(path);
    return match.hasMatch() && match.captured(2).toInt() <= mostBackups ? match.captured(1) : QString();
}

QStringList backupsOf(const QString &path)
{
    const QString canonical = QFileInfo(path).canonicalFilePath();
    QStringList files;
    for (int i = 1; i <= mostBackups; ++i)
        if (const QString name = backupName(canonical.isEmpty() ? path : canonical, i); QFileInfo(name).isFile())
            files << name;
    return files;
}

Result<void> keepBackups(const QString &path, int count)
{
    const QFileInfo info(path);
    const QString target = info.canonicalFilePath();
    if (count <= 0 || target.isEmpty() || !info.isFile())
        return {};
    count = std::min(count, mostBackups);
    const auto failed = [&](const QString &name) {
        return fileError(name, FileMessages::tr("the backup could not be made; check the folder"));
    };
    if (haveSameBytes(target, backupName(target, 1)))
        return {};
    QFile::remove(backupName(target, count));
    for (int i = count; i > 1; --i)
        if (QFileInfo::exists(backupName(target, i - 1)) &&
            !QFile::rename(backupName(target, i - 1), backupName(target, i)))
            return failed(backupName(target, i - 1));
    return linkOrCopy(target, backupName(target, 1)) ? Result<void>() : failed(backupName(target, 1));
}

} // namespace suffuse
