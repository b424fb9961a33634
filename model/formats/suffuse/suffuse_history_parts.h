// What writing and reading an undo history share: its numbers, and how strokes and CBOR lie in its chunk.
#pragma once

#include "model/formats/suffuse/suffuse_strokes.h"

namespace suffuse {

enum HistoryPart { CanvasPart = 1, GroupsPart = 2, SwatchesPart = 4, UnderlayPart = 8 };

/// How a step names the state of a stroke: it is not there; that of the painting; a stored one, from 0.
enum StrokeReference { AbsentStroke, OwnStroke, FirstStored };

/// More CBOR is neither written nor read.
inline constexpr std::uint64_t mostHistoryCbor = 8 << 20;

/// Empty where the CBOR is too long.
QByteArray packHistory(const std::vector<StrokePtr> &strokes, const QByteArray &cbor);
/// False where the bytes are not what `packHistory` makes.
bool unpackHistory(const QByteArray &bytes, std::vector<StrokePtr> &strokes, QByteArray &cbor);

} // namespace suffuse
