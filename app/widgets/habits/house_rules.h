// Rules that hold for every widget of the program.
#pragma once

namespace suffuse {

/// Installs the rules, in all windows. The wheel changes no value and no tab that lacks the keyboard focus, and gives
/// the focus to nothing; it scrolls the area around instead. Dialogs open in the middle of their window, wholly on its
/// screen (place_beside.h), where they scroll if it is too low (dialog_scroll.h), with the keyboard in their first field, and Return presses their button that has the
/// keyboard; the columns of file dialogs are as wide as what they show. Needs a QApplication; may be called again.
void installHouseRules();

} // namespace suffuse
