// A text as it is set: its letters with their outlines and places, and where a caret can stand between them.
#pragma once

#include "model/geometry/affine.h"
#include "model/painting/letters.h"
#include "model/painting/text.h"

#include <array>
#include <memory>
#include <vector>

namespace suffuse {

/// Where a caret stands: a line between two points. All points of a set text are canvas units before `Text::place`.
using CaretLine = std::array<Point, 2>;

/// One or more characters that are set together: a letter with its marks, or a ligature.
struct LaidCluster {
    qsizetype from = 0; ///< its first character in the text's string, UTF-16
    qsizetype to = 0;   ///< the one behind its last
    int line = 0;
    bool rightToLeft = false;
    std::shared_ptr<const LetterOutline> outline; ///< null where it has no ink, as a space
    Affine place;                                 ///< from ems to where it stands
    Rect box;                                     ///< what belongs to it, ems
    CaretLine before{}, after{};                  ///< of the caret in front of its first character, and behind its last
    double along = 0; ///< of its middle along the baseline, canvas units before `Text::place`

    bool hasInk() const { return outline != nullptr; }
    /// The corners of its box, in order around it.
    std::array<Point, 4> corners() const;
};

/// A line of the text, without the \n that ends it.
struct LaidLine {
    qsizetype from = 0, to = 0;
    std::size_t firstCluster = 0, endCluster = 0;
    bool rightToLeft = false;
    CaretLine start{}, end{}; ///< of the caret in front of its first character, and behind its last
};

struct LaidText {
    std::vector<LaidCluster> clusters; ///< in logical order, those without ink among them
    std::vector<LaidLine> lines;       ///< at least one
    bool hasFamily = true;             ///< whether the font is installed; else another one stands in

    /// Where the caret stands before a character, or at the end for the length of the text.
    CaretLine caretAt(qsizetype position) const;
    /// The place between two characters that is nearest to a point, by the letters themselves: from the middle of a
    /// letter on it is the one behind it, also where the next one stands far apart. `string` must be that of the text.
    qsizetype positionAt(Point point, const QString &string) const;
    /// The line in which a place is.
    int lineOf(qsizetype position) const;
    /// The place of a line that is nearest to a point.
    qsizetype positionInLine(int line, Point point, const QString &string) const;
    /// The corners of what the characters from one place to another take up; a \n takes a little behind its line.
    std::vector<std::array<Point, 4>> areasOf(qsizetype from, qsizetype to) const;
    /// The box of all of it, canvas units before `Text::place`.
    Rect box() const;
};

/// The next place between two characters as people see them; the same at the ends.
qsizetype nextPlace(const QString &string, qsizetype position);
qsizetype placeBefore(const QString &string, qsizetype position);
/// The start of the next word, and that of the word before.
qsizetype nextWord(const QString &string, qsizetype position);
qsizetype wordBefore(const QString &string, qsizetype position);
/// The word around a place, or what lies between two words.
std::pair<qsizetype, qsizetype> wordAt(const QString &string, qsizetype position);

} // namespace suffuse
