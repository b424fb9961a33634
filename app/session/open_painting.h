// What is open, apart from how it is shown.
#pragma once

#include "app/session/editor.h"
#include "app/session/files/journal.h"
#include "app/session/playback.h"
#include "app/session/selection_order.h"

namespace suffuse {

/// A painting that is open, with all that must not be lost while a window around it makes way for another.
struct OpenPainting {
    Editor editor;
    Playback playback{editor};
    SelectionOrder selectionOrder{editor.document()};
    Journal journal{editor};
};

} // namespace suffuse
