// What is open, apart from how it is shown.
#pragma once

#include "app/editor.h"
#include "app/journal.h"
#include "app/playback.h"
#include "app/selection_order.h"

namespace suffuse {

/// A painting that is open, with all that must not be lost while a window around it makes way for another.
struct OpenPainting {
    Editor editor;
    Playback playback{editor};
    SelectionOrder selectionOrder{editor.document()};
    Journal journal{editor};
};

} // namespace suffuse
