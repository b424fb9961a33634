// Putting bytes in a file's place, and what is asked before and kept after.
#pragma once

#include "model/result.h"

#include <QByteArray>
#include <QString>

#include <optional>

namespace suffuse {

/// SHA-256 of a file's bytes; none where there is no such file or it cannot be read.
std::optional<QByteArray> hashOfFile(const QString &path);

/// Most versions that are kept.
inline constexpr int mostBackups = 20;
/// Name of the i-th backup, 1 the newest: "a.suffuse~", "a.suffuse~2", …
QString backupName(const QString &path, int i);
/// Keeps the file that is about to be replaced, and the count − 1 versions before it. The file itself stays.
Result<void> keepBackups(const QString &path, int count);

} // namespace suffuse
