// What holds for every widget of the program, whoever made it.
#pragma once

namespace suffuse {

/// From now on, in all windows: the wheel changes no value and no tab that lacks the keyboard focus, and gives the
/// focus to nothing; it scrolls what lies around instead. And dialogs open in the middle of their window, wholly on its
/// screen (place_beside.h), with the keyboard in their first field. Needs a QApplication; may be called again.
void installHouseRules();

} // namespace suffuse
