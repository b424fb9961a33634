// The look of the program: Fusion with two quiet palettes of our own.
#pragma once

#include <QColor>

class QImage;
class QPalette;

namespace suffuse {

/// Puts style and palette on the application, as the setting says (system, dark or light). Needs a QApplication. May be
/// called again at any time, and all windows follow.
void applyTheme();

/// Whether the palette in use has light text on dark ground.
bool isDarkTheme();

/// The paper on which previews of brushes are drawn: the same white in both themes, a little dimmed in the dark one.
QColor previewPaper();
/// The colour of warnings and refused input, with a contrast of at least 4.5 : 1 against the window.
QColor warningText();
/// The paper, or a grey if the paint of the picture (premultiplied, over nothing) could not be seen on the paper.
QColor paperFor(const QImage &picture);
/// The line around colours that the user chose, which may be those of the window. Its contrast is at least 3 : 1
/// against all grounds.
QColor edgeOfColours();
/// The colour of hairlines between areas.
QColor hairline();
/// The colour of frames around what has the keyboard. Its contrast to windows, buttons and fields is at least 3 : 1.
QColor focusFrame();

/// The two palettes, for tests of contrast.
QPalette lightPalette();
QPalette darkPalette();

} // namespace suffuse
