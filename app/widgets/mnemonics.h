// Keys to the fields of a dialog.
#pragma once

class QWidget;

namespace suffuse {

/// Gives each label with a buddy, check box and push button below `dialog` that has no mnemonic one of its own: a
/// letter of its text, the start of a word if possible, that nothing on the same page has; "(&X)" behind texts without
/// Latin letters. Mnemonics that are there stay. Called again, it changes only what is new.
void giveMnemonics(QWidget &dialog);

} // namespace suffuse
