// One line of text as the font's tables shape it, on a straight baseline.
#pragma once

#include "undo/lettering/laid_text.h"

#include <QHash>
#include <QString>

class QRawFont;

namespace suffuse {

/// A cluster of a line, ems; places in the line's string.
struct ShapedCluster {
    qsizetype from = 0, to = 0;
    double left = 0;  ///< where it begins, without what is added between letters
    double width = 0; ///< how far it advances
    int visual = 0;   ///< its number from the left
    bool rightToLeft = false;
    std::shared_ptr<const LetterOutline> outline; ///< from its left on the baseline; null: it has no ink
};

struct ShapedLine {
    std::vector<ShapedCluster> clusters; ///< in logical order
    double width = 0;                    ///< ems, without what is added between letters
    double ascent = 0, descent = 0;      ///< of the font, ems; both positive
    bool rightToLeft = false;            ///< the direction of its paragraph
};

/// What of a font is asked for.
struct Face {
    QString family;
    float weight = 400;
    bool italic = false;
    bool isSpaced = false; ///< whether room is added between letters, so that they make no ligatures
    friend bool operator==(const Face &, const Face &) = default;
};

/// Shapes lines, and keeps what it has shaped: a text is set anew at each key, and mostly one line of it is another
/// one.
class LineShaper {
public:
    LineShaper();
    ~LineShaper();
    LineShaper(const LineShaper &) = delete;
    LineShaper &operator=(const LineShaper &) = delete;

    /// A line without \n. Equal letters of one font share their outline.
    std::shared_ptr<const ShapedLine> shape(const QString &line, const Face &face);
    /// Whether a family of fonts is installed.
    static bool hasFamily(const QString &family);

private:
    struct Glyphs;
    std::unique_ptr<Glyphs> m_glyphs;
    QHash<QString, std::shared_ptr<const ShapedLine>> m_lines; ///< of `m_face`
    Face m_face;
};

} // namespace suffuse
