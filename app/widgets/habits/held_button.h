#pragma once

class QWidget;

namespace suffuse {

/// For a widget on which something is dragged from press to release. A dialog or a menu that opens meanwhile takes the
/// mouse, and the release never comes: the widget then gets a release where the pointer was last. It also gets one when
/// the pointer moves on without a button.
void endDragsWhenCovered(QWidget &dragged);

} // namespace suffuse
