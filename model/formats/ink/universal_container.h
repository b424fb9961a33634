// Universal Ink files (.uim): RIFF with messages of Protocol Buffers.
#pragma once

#include "model/result.h"

#include <QByteArray>
#include <QJsonObject>

namespace suffuse {

/// Whether bytes begin as such a file.
bool isUniversalContainer(const QByteArray &bytes);
/// What is in a file of version 3.0 or 3.1, as Universal Ink's JSON, which is that of version 3.0, has it. The error
/// says what is wrong, without the file's name.
Result<QJsonObject> unpackedUniversal(const QByteArray &bytes);

} // namespace suffuse
