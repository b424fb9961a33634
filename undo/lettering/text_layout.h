// Sets a text: which letter stands where.
#pragma once

#include "undo/lettering/laid_text.h"
#include "undo/lettering/shaped_line.h"

namespace suffuse {

/// Sets texts by the fonts that are installed: shaped, with kerning and ligatures, in both directions, with other fonts
/// where one lacks a letter. It is a pure function of the text and the fonts, and quick where most lines are those of
/// the text before. It needs a QGuiApplication, and the thread of that.
///
/// Vertical lines have Chinese, Japanese and Korean letters upright, and all others turned by 90°. Brackets, commas and
/// the like take the form that the font has for vertical lines, if it has it as a character. Where it has none,
/// brackets and dashes are turned, too, and commas and full stops are put into the other corner of their square
/// (vertical_forms.h).
///
/// Along a curve, the middle of each letter stands at its length along the curve, turned as the curve is there. What
/// runs past its ends goes straight on. Further lines lie beside it.
class TextLayout {
public:
    LaidText lay(const Text &text);

private:
    LineShaper m_shaper;
    QString m_family; ///< that was asked for last
    bool m_isKnown = false;
    bool m_hasFamily = false;
};

} // namespace suffuse
