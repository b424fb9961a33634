// The preview of a document, without reading the document.
#pragma once

#include <QByteArray>

namespace suffuse {

/// So much of the beginning of a file has its preview, if it has one: HEAD is small, and the preview stands behind it.
inline constexpr qsizetype previewReach = (1 << 20) + (1 << 16);

/// The preview in the first `previewReach` bytes of a .suffuse file (all of it, where it is smaller): a PNG. It is empty
/// where there is none, where it is damaged, and for files of other formats.
QByteArray previewIn(const QByteArray &start);

} // namespace suffuse
