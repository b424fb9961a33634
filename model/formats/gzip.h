// Files that are packed by gzip, as compressed SVG drawings are.
#pragma once

#include "model/result.h"

#include <QByteArray>

#include <atomic>

namespace suffuse {

/// What a file that is opened may have once it is unpacked, bytes.
inline constexpr qint64 largestUnpacked = qint64(256) << 20;

/// Whether bytes begin as a gzip file does.
bool isGzip(const QByteArray &bytes);
/// What is packed in a file, or the first `most` bytes of it. It fails if the file is damaged or has more than `most`
/// bytes, unless `begins` says that its beginning is enough.
Result<QByteArray> unpackedGzip(const QByteArray &bytes, qint64 most, bool begins = false);
/// Packs bytes. Empty if `cancel` has become true.
QByteArray packedGzip(const QByteArray &bytes, const std::atomic<bool> *cancel = nullptr);

} // namespace suffuse
