#include "model/formats/svg/svg_length.h"

#include <QRegularExpression>
#include <QXmlStreamReader>

#include <cmath>
#include <map>

namespace suffuse {

namespace {

std::optional<double> lengthIn(const QString &text, const std::map<QString, double> &units)
{
    static const QRegularExpression form(QStringLiteral("^\\s*([-+0-9.eE]+?)\\s*(px|pt|pc|mm|cm|in|em|ex|%)?\\s*$"));
    const QRegularExpressionMatch match = form.match(text);
    const auto unit = units.find(match.captured(2));
    bool ok = false;
    const double value = match.captured(1).toDouble(&ok) * (unit == units.end() ? 0 : unit->second);
    return ok && unit != units.end() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

const std::map<QString, double> &absoluteUnits()
{
    constexpr double inch = svgUnitsOfInch;
    static const std::map<QString, double> units{{"", 1},          {"px", 1},           {"pt", inch / 72},
                                                 {"pc", inch / 6}, {"mm", inch / 25.4}, {"cm", inch / 2.54},
                                                 {"in", inch}};
    return units;
}

} // namespace

bool saysSizeOnPaper(const QByteArray &svg)
{
    static const QRegularExpression onPaper(QStringLiteral("(mm|cm|in|pt|pc)\\s*$"));
    QXmlStreamReader xml(svg);
    if (!xml.readNextStartElement())
        return false;
    const auto isOnPaper = [&](const char *name) {
        const QString length = xml.attributes().value(QLatin1String(name)).toString();
        return svgLength(length).value_or(0) > 0 && onPaper.match(length).hasMatch();
    };
    return isOnPaper("width") || isOnPaper("height");
}

std::optional<double> svgLength(const QString &text)
{
    return lengthIn(text, absoluteUnits());
}

std::optional<double> svgLength(const QString &text, const SvgUnits &units, SvgAxis axis)
{
    if (const std::optional<double> absolute = svgLength(text))
        return absolute;
    const double whole = axis == SvgAxis::Across ? units.width
                         : axis == SvgAxis::Down ? units.height
                                                 : std::hypot(units.width, units.height) / std::sqrt(2.0);
    return lengthIn(text, {{"em", units.fontSize}, {"ex", 0.5 * units.fontSize}, {"%", whole / 100}});
}

} // namespace suffuse
