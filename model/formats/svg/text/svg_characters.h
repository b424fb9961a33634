// The characters of an SVG text in their order, each with its style and with what is said of its place.
#pragma once

#include "model/formats/svg/svg_style.h"

#include <deque>

namespace suffuse {

/// What is said of the place of one character, user units.
struct SvgCharacter {
    std::optional<double> x{}, y{}, dx{}, dy{};
    double rotate = 0;     ///< degrees
    std::size_t style = 0; ///< its index among the text's
    int path = -1;         ///< the index of the line along which it stands; −1: none
    bool begins = false;   ///< whether it is the first on that line
};

/// Characters that are to take up a length together.
struct SvgStretch {
    qsizetype from = 0, to = 0;
    double length = 0;
    bool isOfGlyphs = false; ///< whether the letters are stretched, or the room between them
};

/// A line along which letters stand.
struct SvgTextLine {
    std::vector<Cubic> curves;         ///< user units
    double start = 0;                  ///< where on it they start, by length
    const SvgElement *shape = nullptr; ///< what gives the line
    SvgMatrix own;                     ///< from that shape's own units to those of the text
};

struct SvgCharacters {
    QString string;                       ///< spaces are as they are shown
    std::vector<SvgCharacter> characters; ///< one for each UTF-16 unit; of a pair the first one counts
    std::deque<SvgStyle> styles;          ///< without doubles
    std::vector<SvgStretch> stretches;    ///< inner ones first
    std::vector<SvgTextLine> lines;
    bool isCut = false; ///< whether there were more characters than `most`
};

SvgCharacters svgCharacters(const SvgElement &text, const SvgStyle &style, SvgTree &tree, qsizetype most);

} // namespace suffuse
