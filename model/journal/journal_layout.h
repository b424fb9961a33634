// What writing and reading a journal share.
#pragma once

#include "model/document/order_difference.h"
#include "model/formats/suffuse/suffuse_layout.h"

namespace suffuse {

/// Its first bytes; then come line ends and chunks as in a .suffuse file.
inline constexpr char journalName[] = "\x89SUFFJRN";
inline constexpr int journalVersion = 2;
/// Readers of version 1 know no chains and no lifting segments, which a later record may bring.
inline constexpr int journalLeastReader = 2;

/// Whether the difference only adds strokes on top of `before` others: that is cheap, however many there are.
inline bool onlyOnTop(const OrderDifference &places, bool anyRemoved, std::size_t before)
{
    return !anyRemoved && (places.empty() || places.front().index >= before);
}

} // namespace suffuse
