// What is shared by writing and reading a journal.
#pragma once

#include "model/document/order_difference.h"
#include "model/formats/suffuse/suffuse_layout.h"

namespace suffuse {

/// The first bytes of a journal. Line ends and chunks follow, as in a .suffuse file.
inline constexpr char journalName[] = "\x89SUFFJRN";
inline constexpr int journalVersion = 3;
/// A later record may bring what earlier readers do not know: those of version 1 chains and lifting segments, those of
/// version 2 segments that fade.
inline constexpr int journalLeastReader = 3;

/// Whether a difference only adds strokes on top of `before` others. That costs little, however many these are.
inline bool onlyOnTop(const OrderDifference &places, bool anyRemoved, std::size_t before)
{
    return !anyRemoved && (places.empty() || places.front().index >= before);
}

} // namespace suffuse
