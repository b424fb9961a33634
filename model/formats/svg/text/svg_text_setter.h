// Places the letters of an SVG text whose characters and fonts are known.
#pragma once

#include "model/formats/svg/paths/svg_outlines.h"
#include "model/formats/svg/text/svg_characters.h"
#include "model/painting/letters.h"
#include "model/painting/text.h"

#include <deque>

namespace suffuse {

/// A letter where it stands, or a line under, over or through letters.
struct SvgLetter {
    QString characters;              ///< none for such a line
    std::vector<PenLine> lines;      ///< closed, user units
    const SvgStyle *style = nullptr; ///< one of the text's
};

struct SvgSetText {
    std::vector<SvgLetter> letters; ///< those with ink, in logical order
    Rect box;                       ///< of the letters' cells, user units; gradients count by it
    /// All of it as one that can be typed in again, its place in user units. There is none if its letters differ in
    /// look or stand in a way of their own.
    std::optional<Text> text;
    /// What gives the line along which such a text stands, or null; `text` has the map from its own units to the curve.
    const SvgElement *shape = nullptr;
    QString words; ///< all characters, with single spaces
    std::deque<SvgStyle> styles;
};

/// `families` has the font for each style. No value if the shaper sets no text.
std::optional<SvgSetText> svgSetText(SvgCharacters characters, LetterShaper &shaper, std::vector<QString> families);

} // namespace suffuse
