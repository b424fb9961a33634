// Mnemonics: keys to the fields of a dialog.
#pragma once

class QWidget;

namespace suffuse {

/// Gives a mnemonic to each label with a buddy, check box and push button below `dialog` that has none: a letter of its
/// text, the start of a word if possible, that nothing else on the same page has. Texts without Latin letters get
/// "(&X)" behind them. Mnemonics that are there stay. A second call changes only what is new.
void giveMnemonics(QWidget &dialog);

} // namespace suffuse
