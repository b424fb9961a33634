// One line of text as the font's tables shape it, on a straight baseline.
#pragma once

#include "model/painting/letters.h"

#include <QHash>
#include <QString>

class QRawFont;

namespace suffuse {

/// Shapes lines, and keeps what it has shaped: a text is set anew at each key, and mostly one line of it is another
/// one.
class LineShaper final : public LetterShaper {
public:
    LineShaper();
    ~LineShaper() override;
    LineShaper(const LineShaper &) = delete;
    LineShaper &operator=(const LineShaper &) = delete;

    std::shared_ptr<const ShapedLine> shape(const QString &line, const Face &face) override;
    bool hasFamily(const QString &family) override;
    QString familyFor(const QString &family) override;

private:
    struct Glyphs;
    std::unique_ptr<Glyphs> m_glyphs;
    QHash<QString, std::shared_ptr<const ShapedLine>> m_lines; ///< of `m_face`
    Face m_face;
};

} // namespace suffuse
