#include "model/formats/svg/text/svg_font.h"

#include <QRegularExpression>

#include <map>

namespace suffuse {

namespace {

/// The names of a list such as "Georgia, 'Times New Roman', serif".
QStringList familiesFrom(const QString &text)
{
    QStringList families;
    for (QString name : text.split(u',')) {
        name = name.simplified();
        if (name.size() > 1 && (name.startsWith(u'\'') || name.startsWith(u'"')) && name.endsWith(name.front()))
            name = name.mid(1, name.size() - 2).trimmed();
        if (!name.isEmpty() && name.size() <= Text::mostFamily && families.size() < 50)
            families << name;
    }
    return families;
}

float weightFrom(const QString &text, float parent)
{
    if (text == QLatin1String("normal"))
        return 400;
    if (text == QLatin1String("bold"))
        return 700;
    if (text == QLatin1String("bolder"))
        return parent < 350 ? 400 : parent < 550 ? 700 : 900;
    if (text == QLatin1String("lighter"))
        return parent < 550 ? 100 : parent < 750 ? 400 : 700;
    bool ok = false;
    const float weight = text.toFloat(&ok);
    return ok && weight >= 1 && weight <= 1000 ? weight : parent;
}

std::optional<double> namedSize(const QString &text, double around)
{
    static const std::map<QString, double> sizes{{"xx-small", 9.6}, {"x-small", 12},  {"small", 14.2222},
                                                 {"medium", 16},    {"large", 19.2},  {"x-large", 24},
                                                 {"xx-large", 32},  {"xxx-large", 48}};
    if (text == QLatin1String("larger"))
        return 1.2 * around;
    if (text == QLatin1String("smaller"))
        return around / 1.2;
    const auto at = sizes.find(text);
    return at == sizes.end() ? std::nullopt : std::optional(at->second);
}

double stretchFrom(const QString &text, double parent)
{
    static const std::map<QString, double> stretches{
        {"ultra-condensed", 50},  {"extra-condensed", 62.5}, {"condensed", 75},
        {"semi-condensed", 87.5}, {"normal", 100},           {"semi-expanded", 112.5},
        {"expanded", 125},        {"extra-expanded", 150},   {"ultra-expanded", 200}};
    if (const auto at = stretches.find(text); at != stretches.end())
        return at->second;
    bool ok = false;
    const double stretch = text.endsWith(u'%') ? text.chopped(1).toDouble(&ok) : 0;
    return ok && stretch > 0 ? stretch : parent;
}

double raisedBy(const QString &text, const SvgUnits &units)
{
    // As browsers raise and lower where a font does not say by how much.
    if (text == QLatin1String("super"))
        return units.fontSize / 3;
    if (text == QLatin1String("sub"))
        return -units.fontSize / 5;
    return svgLength(text, {units.fontSize, units.fontSize, units.fontSize}, SvgAxis::Across).value_or(0);
}

} // namespace

SvgFont SvgFont::of(const SvgProperties &all, const SvgFont &parent, const SvgUnits &units)
{
    SvgFont font = parent;
    font.ownBaseline.clear();
    const auto take = [&all](const char *name, auto use) { svgTake(all, name, use); };
    const auto spacing = [&](double &value) {
        return [&](const QString &v) { value = svgLength(v, units, SvgAxis::Across).value_or(0); };
    };
    take("font-family", [&](const QString &v) { font.families = familiesFrom(v); });
    take("font-weight", [&](const QString &v) { font.weight = weightFrom(v, parent.weight); });
    take("font-style", [&](const QString &v) { font.italic = v != QLatin1String("normal"); });
    for (const char *name : {"font-stretch", "font-width"})
        take(name, [&](const QString &v) { font.stretch = stretchFrom(v, parent.stretch); });
    for (const char *name : {"font-variant", "font-variant-caps"})
        take(name, [&](const QString &v) { font.hasSmallCaps = v.split(u' ').contains(QLatin1String("small-caps")); });
    take("letter-spacing", spacing(font.letterSpacing));
    take("word-spacing", spacing(font.wordSpacing));
    take("text-anchor", [&](const QString &v) {
        font.anchor = v == QLatin1String("middle") ? TextAlignment::Centre
                      : v == QLatin1String("end")  ? TextAlignment::End
                                                   : TextAlignment::Start;
    });
    take("direction", [&](const QString &v) { font.isRightToLeft = v == QLatin1String("rtl"); });
    take("writing-mode", [&](const QString &v) {
        font.isVertical = v.startsWith(QLatin1String("tb")) || v.startsWith(QLatin1String("vertical")) ||
                          v.startsWith(QLatin1String("sideways"));
    });
    take("white-space", [&](const QString &v) {
        font.keepsSpace = v.startsWith(QLatin1String("pre")) && v != QLatin1String("pre-line");
    });
    take("baseline-shift", [&](const QString &v) { font.raised = parent.raised + raisedBy(v, units); });
    take("dominant-baseline", [&](const QString &v) { font.baseline = v; });
    take("alignment-baseline", [&](const QString &v) { font.ownBaseline = v; });
    for (const char *name : {"text-decoration", "text-decoration-line"})
        take(name, [&](const QString &v) {
            font.isUnderlined = font.isUnderlined || v.contains(QLatin1String("underline"));
            font.isOverlined = font.isOverlined || v.contains(QLatin1String("overline"));
            font.isStruck = font.isStruck || v.contains(QLatin1String("line-through"));
        });
    return font;
}

double svgFontSize(const QString &text, const SvgUnits &around)
{
    if (const std::optional<double> named = namedSize(text, around.fontSize))
        return *named;
    const SvgUnits units{around.fontSize, around.fontSize, around.fontSize};
    const double size = svgLength(text, units, SvgAxis::Across).value_or(around.fontSize);
    return size > 0 ? size : around.fontSize;
}

SvgProperties svgFontShorthand(const QString &text)
{
    static const QRegularExpression form(
        QStringLiteral("^\\s*((?:[a-z0-9-]+\\s+)*?)"
                       "([0-9.]+(?:px|pt|pc|mm|cm|in|em|ex|%)|(?:x{1,3}-)?(?:small|large)|medium|smaller|larger)"
                       "\\s*(?:/\\s*\\S+)?\\s+(.+)$"));
    const QRegularExpressionMatch match = form.match(text);
    if (!match.hasMatch() || text.size() > 10'000)
        return {};
    SvgProperties out{{"font-style", "normal"},   {"font-weight", "normal"},        {"font-variant", "normal"},
                      {"font-stretch", "normal"}, {"font-size", match.captured(2)}, {"font-family", match.captured(3)}};
    for (const QString &word : match.captured(1).split(u' ', Qt::SkipEmptyParts)) {
        bool isNumber = false;
        word.toInt(&isNumber);
        if (word == QLatin1String("italic") || word == QLatin1String("oblique"))
            out["font-style"] = word;
        else if (word == QLatin1String("small-caps"))
            out["font-variant"] = word;
        else if (word.endsWith(QLatin1String("-condensed")) || word.endsWith(QLatin1String("-expanded")) ||
                 word == QLatin1String("condensed") || word == QLatin1String("expanded"))
            out["font-stretch"] = word;
        else if (isNumber || word.startsWith(QLatin1String("bold")) || word == QLatin1String("lighter"))
            out["font-weight"] = word;
    }
    return out;
}

} // namespace suffuse
