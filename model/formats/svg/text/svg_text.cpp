#include "model/formats/svg/text/svg_text.h"

#include <map>

namespace suffuse {

namespace {

/// Fonts that are as wide as well-known ones, which few machines have that run on free software.
const std::map<QString, QStringList> &likeFamilies()
{
    static const QStringList sans{"Liberation Sans", "Arimo", "Nimbus Sans"},
        serif{"Liberation Serif", "Tinos", "Nimbus Roman"}, mono{"Liberation Mono", "Cousine", "Nimbus Mono PS"};
    static const std::map<QString, QStringList> families{
        {"arial", sans},         {"helvetica", sans},        {"helvetica neue", sans},
        {"times", serif},        {"times new roman", serif}, {"courier", mono},
        {"courier new", mono},   {"calibri", {"Carlito"}},   {"cambria", {"Caladea"}},
        {"georgia", {"Gelasio"}}};
    return families;
}

/// The name by which Qt knows a kind of fonts; empty for the name of one.
QString genericFamily(const QString &family)
{
    static const std::map<QString, QString> names{{"serif", "Serif"},          {"sans-serif", "Sans Serif"},
                                                  {"sans", "Sans Serif"},      {"monospace", "Monospace"},
                                                  {"system-ui", "Sans Serif"}, {"ui-sans-serif", "Sans Serif"},
                                                  {"ui-serif", "Serif"},       {"ui-monospace", "Monospace"},
                                                  {"cursive", "cursive"},      {"fantasy", "fantasy"}};
    const auto at = names.find(family.toLower());
    return at == names.end() ? QString() : at->second;
}

} // namespace

/// The first of some families that is installed.
QString SvgTexts::familyOf(const QStringList &given)
{
    static const QStringList usual{"Times New Roman", "serif"};
    const QStringList &families = given.isEmpty() ? usual : given;
    const QString key = families.join(u',');
    const auto known = m_families.constFind(key);
    if (known != m_families.constEnd())
        return *known;
    QString found;
    for (const QString &family : families) {
        if (const QString generic = genericFamily(family); !generic.isEmpty())
            found = generic;
        else if (m_shaper->hasFamily(family))
            found = family;
        else if (const auto like = likeFamilies().find(family.toLower()); like != likeFamilies().end())
            for (const QString &other : like->second)
                if (found.isEmpty() && m_shaper->hasFamily(other))
                    found = other;
        if (!found.isEmpty() || &family == &families.back()) {
            const bool isOther = found.isEmpty() || (found != family && found != genericFamily(family));
            if ((isOther || &family != &families.front()) && !given.isEmpty() && !m_missing.contains(families.front()))
                m_missing << families.front();
            break;
        }
    }
    return m_families[key] = m_shaper->familyFor(found.isEmpty() ? families.front() : found);
}

/// The narrower or wider family that belongs to one, where it is installed: letters are never squeezed.
QString SvgTexts::withWidth(const QString &family, double stretch)
{
    static const QStringList narrow{" Condensed", " Narrow", " SemiCondensed", " ExtraCondensed"},
        wide{" Expanded", " Extended", " Wide", " SemiExpanded"};
    if (stretch >= 90 && stretch <= 110)
        return family;
    for (const QString &suffix : stretch < 100 ? narrow : wide)
        if (m_shaper->hasFamily(family + suffix))
            return family + suffix;
    return family;
}

std::optional<SvgSetText> SvgTexts::set(const SvgElement &text, const SvgStyle &style)
{
    SvgCharacters characters = svgCharacters(text, style, m_tree, mostCharacters);
    if (characters.string.isEmpty())
        return SvgSetText();
    if (!m_shaper || style.font.isVertical)
        return {};
    m_isCut = m_isCut || characters.isCut;
    std::vector<QString> families;
    for (const SvgStyle &one : characters.styles)
        families.push_back(withWidth(familyOf(one.font.families), one.font.stretch));
    return svgSetText(std::move(characters), *m_shaper, std::move(families));
}

} // namespace suffuse
