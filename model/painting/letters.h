// Lines of text as a font shapes them. Fonts themselves are not known in this room: who knows them is a LetterShaper.
#pragma once

#include "model/geometry/geometry.h"

#include <QString>

#include <memory>
#include <vector>

namespace suffuse {

/// The closed contours of a letter in ems: the baseline is the x axis, y points down, and the letter begins at x = 0.
/// Contours of one letter may overlap (the nonzero rule holds).
using LetterOutline = std::vector<std::vector<Cubic>>;

/// A cluster of a line, ems; places in the line's string.
struct ShapedCluster {
    qsizetype from = 0, to = 0;
    double left = 0;  ///< where it begins, without what is added between letters
    double width = 0; ///< how far it advances
    int visual = 0;   ///< its number from the left
    bool rightToLeft = false;
    std::shared_ptr<const LetterOutline> outline; ///< from its left on the baseline; null: it has no ink
    bool hasVerticalForm = false; ///< whether width and outline are those of its form for vertical lines
};

struct ShapedLine {
    std::vector<ShapedCluster> clusters; ///< in logical order
    double width = 0;                    ///< ems, without what is added between letters
    double ascent = 0, descent = 0;      ///< of the font, ems; both positive
    double xHeight = 0;                  ///< of small letters, ems
    double underline = 0;                ///< how far below the baseline the middle of a line under it is, ems
    double lineThickness = 0;            ///< of that line, ems
    bool rightToLeft = false;            ///< the direction of its paragraph
};

/// What of a font is asked for.
struct Face {
    QString family;
    float weight = 400;
    bool italic = false;
    bool isSpaced = false;     ///< whether room is added between letters, so that they make no ligatures
    bool isVertical = false;   ///< whether letters take their forms for vertical lines, where the font has them
    bool hasSmallCaps = false; ///< whether small letters look like capitals that are smaller
    friend bool operator==(const Face &, const Face &) = default;
};

/// Who knows the fonts of a machine.
class LetterShaper {
public:
    virtual ~LetterShaper() = default;
    /// A line without \n; equal letters of one font share their outline. Null where no text can be set.
    virtual std::shared_ptr<const ShapedLine> shape(const QString &line, const Face &face) = 0;
    /// Whether a family of fonts is installed.
    virtual bool hasFamily(const QString &family) = 0;
    /// The installed family that stands for one that is not, or for a kind of fonts such as "Sans Serif".
    virtual QString familyFor(const QString &family) = 0;
};

/// The one that files are read with, or null: then their texts are left out. A program that knows fonts says so once,
/// before it reads files: which fonts there are is a matter of the machine, as its language is.
LetterShaper *letterShaper();
void setLetterShaper(LetterShaper *shaper);

} // namespace suffuse
