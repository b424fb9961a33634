// What writing and reading a journal share.
#pragma once

#include "model/formats/suffuse/suffuse_layout.h"
#include "model/document/order_difference.h"

namespace suffuse {

/// Its first bytes; then come line ends and chunks as in a .suffuse file.
inline constexpr char journalName[] = "\x89SUFFJRN";
inline constexpr int journalVersion = 1;
inline constexpr int journalLeastReader = 1;

/// Whether the difference only adds strokes on top of `before` others: that is cheap, however many there are.
inline bool onlyOnTop(const OrderDifference &places, bool anyRemoved, std::size_t before)
{
    return !anyRemoved && (places.empty() || places.front().index >= before);
}

} // namespace suffuse
