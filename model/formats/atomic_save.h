// Replaces a file's content, with what must be checked before and kept afterwards.
#pragma once

#include "model/result.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>

namespace suffuse {

/// SHA-256 of a file's bytes; no value where there is no such file or it cannot be read.
std::optional<QByteArray> hashOfFile(const QString &path);

/// At most so many versions of a file are kept.
inline constexpr int mostBackups = 20;
/// The name of the i-th backup, where 1 is the newest: "a.suffuse~", "a.suffuse~2", …
QString backupName(const QString &path, int i);
/// The file whose backup has a name; empty for other names.
QString backedUpFile(const QString &path);
/// The backups that exist, the newest first. Links are followed. The file itself need not exist.
QStringList backupsOf(const QString &path);
/// Keeps the file that is about to be replaced, and the count − 1 versions before it. The file itself stays. If the
/// newest backup has the same bytes, nothing is done.
Result<void> keepBackups(const QString &path, int count);

} // namespace suffuse
