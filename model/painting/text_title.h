// What a text is called that has no other name.
#pragma once

#include "model/painting/text.h"

namespace suffuse {

/// What it says: its first letters, in one line.
inline QString titleOf(const Text &text)
{
    constexpr int mostShown = 60;
    return text.string.simplified().left(mostShown);
}

} // namespace suffuse
