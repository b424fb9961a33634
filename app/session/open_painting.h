// A painting that is open, without the widgets that show it.
#pragma once

#include "app/session/editor.h"
#include "app/session/files/journal.h"
#include "app/session/playback.h"
#include "app/session/selection_order.h"

namespace suffuse {

/// Holds a painting that is open, and everything about it that must not be lost when another window takes the place of
/// the one that shows it.
struct OpenPainting {
    Editor editor;
    Playback playback{editor};
    SelectionOrder selectionOrder{editor.document()};
    Journal journal{editor};
};

} // namespace suffuse
