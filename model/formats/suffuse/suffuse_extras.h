// The chunks that a reader may skip: what belongs to a document, but not to its picture.
#pragma once

#include "model/formats/files.h"
#include "model/formats/suffuse/suffuse_layout.h"

namespace suffuse {

inline constexpr char previewType[] = "prev";
inline constexpr char viewType[] = "view";
inline constexpr char historyType[] = "hist";
inline constexpr char profileType[] = "prof";
inline constexpr char resolutionType[] = "inch";
/// The largest preview that is kept, bytes.
inline constexpr qsizetype largestPreview = 1 << 20;

/// Whether a chunk may be skipped: its type begins with a small letter.
bool isAncillary(const Chunk &chunk);
/// What a chunk of a known type is, for people; empty for other types.
QString partBeside(const QByteArray &type);
/// Keeps a chunk that may be skipped in `extras`. A known one that makes no sense is left out. Of several of one type
/// the first counts.
void readExtra(const Chunk &chunk, DocumentExtras &extras);

/// Append the chunks that stand before the picture, for programs that only read the start of a file, and those behind
/// it.
void appendFirstExtras(QByteArray &out, const DocumentExtras &extras);
void appendLastExtras(QByteArray &out, const DocumentExtras &extras);

} // namespace suffuse
