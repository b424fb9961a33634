#include "model/formats/svg/paths/svg_shapes.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace suffuse {

namespace {

/// Reads attributes as numbers.
class Numbers {
public:
    Numbers(const QXmlStreamAttributes &attributes, const SvgUnits &units) : m_attributes(attributes), m_units(units) {}

    std::optional<double> find(const char *name) const
    {
        const QLatin1String attribute(name);
        const bool isAcross = attribute.contains(u'x') || attribute == QLatin1String("width");
        const bool isDown = attribute.contains(u'y') || attribute == QLatin1String("height");
        return svgLength(m_attributes.value(attribute).toString(), m_units,
                         isAcross ? SvgAxis::Across
                         : isDown ? SvgAxis::Down
                                  : SvgAxis::Any);
    }
    double operator[](const char *name) const { return find(name).value_or(0); }

private:
    const QXmlStreamAttributes &m_attributes;
    const SvgUnits &m_units;
};

/// A command such as "M" with its numbers.
QString command(const char *letter, std::initializer_list<double> numbers)
{
    QString text = QString::fromLatin1(letter);
    for (const double number : numbers)
        text += ' ' + QString::number(number, 'g', 17);
    return text + ' ';
}

QString rectangle(const Numbers &n)
{
    const double x = n["x"], y = n["y"], width = n["width"], height = n["height"];
    if (!(width > 0 && height > 0))
        return {};
    // One radius alone counts for both.
    const std::optional<double> givenX = n.find("rx"), givenY = n.find("ry");
    const double rx = std::clamp(givenX.value_or(givenY.value_or(0)), 0.0, 0.5 * width);
    const double ry = std::clamp(givenY.value_or(givenX.value_or(0)), 0.0, 0.5 * height);
    if (rx == 0 || ry == 0)
        return command("M", {x, y}) + command("H", {x + width}) + command("V", {y + height}) + command("H", {x}) + 'Z';
    const auto arc = [&](double toX, double toY) { return command("A", {rx, ry, 0, 0, 1, toX, toY}); };
    const double right = x + width, bottom = y + height;
    return command("M", {x + rx, y}) + command("H", {right - rx}) + arc(right, y + ry) + command("V", {bottom - ry}) +
           arc(right - rx, bottom) + command("H", {x + rx}) + arc(x, bottom - ry) + command("V", {y + ry}) +
           arc(x + rx, y) + 'Z';
}

/// The path of an ellipse, from its right end clockwise, as SVG says.
QString ellipse(double x, double y, double rx, double ry)
{
    if (!(rx > 0 && ry > 0))
        return {};
    QString text = command("M", {x + rx, y});
    for (const auto &[toX, toY] : {std::pair{x, y + ry}, {x - rx, y}, {x, y - ry}, {x + rx, y}})
        text += command("A", {rx, ry, 0, 0, 1, toX, toY});
    return text + 'Z';
}

} // namespace

QString svgPathData(QStringView element, const QXmlStreamAttributes &attributes, const SvgUnits &units)
{
    const Numbers n(attributes, units);
    const auto is = [element](const char *name) { return element == QLatin1String(name); };
    if (is("path"))
        return attributes.value(QLatin1String("d")).toString();
    if (is("rect"))
        return rectangle(n);
    if (is("circle"))
        return ellipse(n["cx"], n["cy"], n["r"], n["r"]);
    if (is("ellipse")) { // A radius below 0 is none, and one alone is both.
        const double rx = n["rx"], ry = n["ry"];
        return ellipse(n["cx"], n["cy"], rx < 0 || !n.find("rx") ? ry : rx, ry < 0 || !n.find("ry") ? rx : ry);
    }
    if (is("line"))
        return command("M", {n["x1"], n["y1"]}) + command("L", {n["x2"], n["y2"]});
    if (is("polyline") || is("polygon"))
        return "M " + attributes.value(QLatin1String("points")).toString() + (is("polygon") ? " Z" : "");
    return {};
}

} // namespace suffuse
