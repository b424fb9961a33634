#pragma once

class QDialog;
class QSize;

namespace suffuse {

/// Lets what a dialog shows scroll if it is higher than the room that there is. The dialog's box of buttons stays below
/// it, in sight. It is for dialogs whose layout is a box or a form, and is called before they are shown.
void scrollIfHigher(QDialog &dialog, QSize room);

} // namespace suffuse
