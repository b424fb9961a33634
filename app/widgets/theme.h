// The look: Fusion with two quiet palettes of our own.
#pragma once

#include <QColor>

class QImage;
class QPalette;

namespace suffuse {

/// Puts style and palette on the application after the setting (system, dark or light). Needs a QApplication; may be
/// called again at any time, all windows follow.
void applyTheme();

/// Whether the palette in use has light text on dark ground.
bool isDarkTheme();

/// Paper that previews of brushes are drawn on; the same white in both themes, a little dimmed in the dark one.
QColor previewPaper();
/// Text of warnings and refused input; at least 4.5 : 1 against the window.
QColor warningText();
/// The paper, or a grey where what is painted (premultiplied, over nothing) would not be seen on the paper.
QColor paperFor(const QImage &picture);
/// Line around colours that the user chose, which may be those of the window: at least 3 : 1 against all grounds.
QColor edgeOfColours();
/// Hairlines between areas.
QColor hairline();

/// The two palettes, for tests of contrast.
QPalette lightPalette();
QPalette darkPalette();

} // namespace suffuse
