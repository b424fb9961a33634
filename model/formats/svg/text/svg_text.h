// Sets the texts of SVG: which letter stands where, as outlines.
#pragma once

#include "model/formats/svg/text/svg_text_setter.h"

#include <QHash>
#include <QStringList>

namespace suffuse {

/// Sets texts by the fonts that a LetterShaper knows.
class SvgTexts {
public:
    static constexpr qsizetype mostCharacters = Text::mostCharacters; ///< of one text; more are left out

    SvgTexts(SvgTree &tree, LetterShaper *shaper) : m_tree(tree), m_shaper(shaper) {}

    /// A <text> with its style. Positions, shifts and turns of single characters, anchors, baselines, spacing,
    /// textLength and textPath count. No value if it cannot be set: without fonts, or since it is vertical.
    std::optional<SvgSetText> set(const SvgElement &text, const SvgStyle &style);
    /// The families that were asked for and are not installed, each once.
    const QStringList &missing() const { return m_missing; }
    /// Whether a text had more characters than are set.
    bool isCut() const { return m_isCut; }

private:
    QString familyOf(const QStringList &families);
    QString withWidth(const QString &family, double stretch);

    SvgTree &m_tree;
    LetterShaper *const m_shaper; ///< may be null
    QHash<QString, QString> m_families;
    QStringList m_missing;
    bool m_isCut = false;
};

} // namespace suffuse
