// Putting bytes in a file's place, and what is asked before and kept after.
#pragma once

#include "model/result.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>

namespace suffuse {

/// SHA-256 of a file's bytes; none where there is no such file or it cannot be read.
std::optional<QByteArray> hashOfFile(const QString &path);

/// Most versions that are kept.
inline constexpr int mostBackups = 20;
/// Name of the i-th backup, 1 the newest: "a.suffuse~", "a.suffuse~2", …
QString backupName(const QString &path, int i);
/// The file whose backup has this name; empty for other names.
QString backedUpFile(const QString &path);
/// The backups that there are, the newest first. Links are followed; the file itself may be gone.
QStringList backupsOf(const QString &path);
/// Keeps the file that is about to be replaced, and the count − 1 versions before it. The file itself stays. One whose
/// bytes the newest backup has is kept already.
Result<void> keepBackups(const QString &path, int count);

} // namespace suffuse
