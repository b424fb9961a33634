// What writing and reading an undo history share: its numbers, and how strokes and CBOR are arranged in its chunk.
#pragma once

#include "model/formats/suffuse/suffuse_strokes.h"

namespace suffuse {

enum HistoryPart { CanvasPart = 1, GroupsPart = 2, SwatchesPart = 4, UnderlayPart = 8 };

/// How a step names the state of a stroke: the stroke does not exist, the state is that of the painting, or it is a
/// stored one, counted from 0.
enum StrokeReference { AbsentStroke, OwnStroke, FirstStored };

/// No more bytes of CBOR are written or read.
inline constexpr std::uint64_t mostHistoryCbor = 8 << 20;

/// Packs strokes and CBOR. Returns an empty array if the CBOR is too long.
QByteArray packHistory(const std::vector<StrokePtr> &strokes, const QByteArray &cbor);
/// Unpacks them. Returns false if the bytes are not what `packHistory` makes.
bool unpackHistory(const QByteArray &bytes, std::vector<StrokePtr> &strokes, QByteArray &cbor);

} // namespace suffuse
