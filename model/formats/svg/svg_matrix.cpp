#include "model/formats/svg/svg_matrix.h"

#include <QRegularExpression>

#include <algorithm>
#include <numbers>
#include <vector>

namespace suffuse {

namespace {

SvgMatrix oneTransform(const QString &name, const std::vector<double> &v)
{
    const auto at = [&v](std::size_t i, double otherwise) { return i < v.size() ? v[i] : otherwise; };
    constexpr double degree = std::numbers::pi / 180;
    if (name == "matrix" && v.size() == 6)
        return {v[0], v[1], v[2], v[3], v[4], v[5]};
    if (name == "translate")
        return {1, 0, 0, 1, at(0, 0), at(1, 0)};
    if (name == "scale")
        return {at(0, 1), 0, 0, at(1, at(0, 1)), 0, 0};
    if (name == "rotate") {
        const double c = std::cos(at(0, 0) * degree), s = std::sin(at(0, 0) * degree);
        const SvgMatrix there{1, 0, 0, 1, at(1, 0), at(2, 0)}, back{1, 0, 0, 1, -at(1, 0), -at(2, 0)};
        return there * SvgMatrix{c, s, -s, c, 0, 0} * back;
    }
    if (name == "skewX")
        return {1, 0, std::tan(at(0, 0) * degree), 1, 0, 0};
    if (name == "skewY")
        return {1, std::tan(at(0, 0) * degree), 0, 1, 0, 0};
    return {};
}

} // namespace

SvgMatrix svgTransform(const QString &text)
{
    static const QRegularExpression call("([a-zA-Z]+)\\s*\\(([^)]*)\\)"), separator("[\\s,]+"), unit("(px|deg)$");
    SvgMatrix result;
    for (auto it = call.globalMatch(text); it.hasNext();) {
        const QRegularExpressionMatch match = it.next();
        std::vector<double> values;
        for (const QString &number : match.captured(2).split(separator, Qt::SkipEmptyParts))
            values.push_back(QString(number).remove(unit).toDouble());
        result = result * oneTransform(match.captured(1), values);
    }
    return result;
}

Rect svgViewBox(const QXmlStreamAttributes &attributes)
{
    static const QRegularExpression separator("[\\s,]+");
    std::vector<double> v;
    const QString text = attributes.value(QLatin1String("viewBox")).toString();
    for (const QString &number : text.split(separator, Qt::SkipEmptyParts)) {
        bool ok = false;
        v.push_back(number.toDouble(&ok));
        if (!ok || !std::isfinite(v.back()))
            return {};
    }
    return v.size() == 4 && v[2] > 0 && v[3] > 0 ? Rect::of(v[0], v[1], v[2], v[3]) : Rect();
}

SvgMatrix svgViewport(const Rect &viewBox, const Rect &port, const QString &preserveAspectRatio)
{
    double x = port.width() / viewBox.width(), y = port.height() / viewBox.height();
    const auto says = [&](const char *word) { return preserveAspectRatio.contains(QLatin1String(word)); };
    if (!says("none"))
        x = y = says("slice") ? std::max(x, y) : std::min(x, y);
    const double right = port.width() - x * viewBox.width(), down = port.height() - y * viewBox.height();
    const double alongX = says("none") || says("xMin") ? 0 : says("xMax") ? 1 : 0.5;
    const double alongY = says("none") || says("YMin") ? 0 : says("YMax") ? 1 : 0.5;
    return {x, 0, 0, y, port.left + alongX * right - x * viewBox.left, port.top + alongY * down - y * viewBox.top};
}

} // namespace suffuse
