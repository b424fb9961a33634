// Files that are packed by gzip, as compressed SVG drawings are, and streams of zlib within files.
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
/// The same of a zlib stream, which has no name and no date before it, as parts of PNG and PSD files are.
Result<QByteArray> unpackedZlib(const QByteArray &bytes, qint64 most);
/// Packs bytes. Empty if `cancel` has become true.
QByteArray packedGzip(const QByteArray &bytes, const std::atomic<bool> *cancel = nullptr);

} // namespace suffuse
