// Chunks that a reader may skip: what belongs to a document, but not to its picture.
#pragma once

#include "model/formats/files.h"
#include "model/formats/suffuse/suffuse_layout.h"

namespace suffuse {

inline constexpr char previewType[] = "prev";
inline constexpr char viewType[] = "view";
inline constexpr char historyType[] = "hist";
/// Largest preview that is kept, bytes.
inline constexpr qsizetype largestPreview = 1 << 20;

/// A type whose first letter is small.
bool isAncillary(const Chunk &chunk);
/// What a known one is, for people; empty for other types.
QString partBeside(const QByteArray &type);
/// Keeps an ancillary chunk in `extras`; what is known but makes no sense is left out. The first of a kind counts.
void readExtra(const Chunk &chunk, DocumentExtras &extras);

/// The chunks that stand before the picture, for programs that read the start of a file only; and those behind it.
void appendFirstExtras(QByteArray &out, const DocumentExtras &extras);
void appendLastExtras(QByteArray &out, const DocumentExtras &extras);

} // namespace suffuse
